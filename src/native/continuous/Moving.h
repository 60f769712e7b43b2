// SPDX-License-Identifier: MIT
// A ball in a substep of the continuous mode.
#pragma once

#include "../../geometry/TimeOfImpact.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "../broadphase/DiscGrid.h"
#include "Holds.h"

namespace Shapes::Native {

using namespace Geometry;

inline constexpr std::uint32_t g_nNobody = 0xFFFFFFFFu;

/// Of a ball in which another one is deep: the square of the distance of their centres, then the places
/// between them in the order of the balls.
using CFarness = std::pair<double, std::size_t>;
inline constexpr CFarness g_cFarthest{std::numeric_limits<double>::infinity(), 0};

/// The next event of a ball.
struct CNext {
  eSweep m_eSweep = eSweep::None;
  bool m_bIsBall = false;
  std::uint32_t m_nOther = g_nNobody; // order of the shape, or index of the ball; none where holds end
  std::uint32_t m_nOtherVersion = 0;  // of a ball
  double m_fOtherTime = 0.0;          // of a ball: seconds on its own motion
  CImpact m_cImpact;                  // at the time on the motion of this ball; the normal points to it
};

/// A solid ball, and the part of its path that begins at m_fTime.
struct CMoving {
  std::size_t m_nBall = 0;                            // index in the arrays
  std::uint32_t m_nSolid = 0;                         // and among those that are solid
  CDiscGrid::CDisc m_cDisc{Vector2::Zero(), 0.0f};    // around the motion
  CDiscGrid::CDisc m_cLooked{Vector2::Zero(), -1.0f}; // in which shapes near it are known, none below 0
  std::size_t m_nBallsSeen = 0;                       // near it in this substep, in all searches
  CFarness m_cFarthestDeep = g_cFarthest;             // that it meets, in a crowd
  Vector2d m_vPos = Vector2d::Zero();                 // where the motion begins
  Vector2d m_vVel = Vector2d::Zero();                 // likewise
  Vector2d m_vAcc = Vector2d::Zero();                 // of the motion
  Vector2d m_vBend = Vector2d::Zero();                // more of it, where it follows a curve
  Vector2d m_vCarried = Vector2d::Zero();             // velocity with which it goes along where it is halted
  Vector2d m_vFall = Vector2d::Zero();  // gravity, unless the velocity has what it gives in the substep
  Vector2d m_vGiven = Vector2d::Zero(); // acceleration in the substep, all of which the velocity has
  double m_fRadius = 0.0, m_fMass = 1.0, m_fElasticity = 0.0;
  double m_fNearRadius = 0.0; // of the largest of it and the balls that touch it, or could in this substep
  CHolds m_cHolds;
  double m_fHoldTime = std::numeric_limits<double>::infinity(); // until they end, or its way is computed anew
  CNext m_cNext;
  double m_fTime = 0.0;                               // when the motion begins, seconds in the substep
  std::uint32_t m_nVersion = 0;                       // changes with the motion
  std::uint32_t m_nShapesBegin = 0, m_nShapesEnd = 0; // the shapes that are known, in CContinuous
  unsigned m_nImpacts = 0;                            // in this substep
  unsigned m_nOnLine = 0;                  // of those before the last one how many were along its line
  Vector2d m_vLastNorm = Vector2d::Zero(); // of the last one
  double m_fOnLineSince = 0.0;             // when these were last a multiple of g_nStuckImpacts
  std::uint32_t m_nLastOrder = g_nNobody;  // of the shape that it has just left
  std::uint32_t m_nLastMoving = g_nNobody; // of the shape that it has met last and that pushed it
  unsigned m_nSteered = 0;                 // substeps for which it counts as steered: CRestingContacts
  bool m_bIsAsleep = false;                // at rest, and nothing is near that is not
  bool m_bIsHalted = false;                // goes along with that one for the rest of the substep
  bool m_bIsStuck = false;                 // and has got nowhere in the substep, under gravity
  bool m_bIsTold = false;                  // that it is halted, or that a shape goes over it
  bool m_bIsMoved = false;                 // by anything but its velocity and gravity
  bool m_bIsNearBall = false;              // touches one, or could in this substep
  bool m_bIsInPile = false;                // rests on other balls, or they on it
  bool m_bIsDriven = false;                // gets energy: of what moves, or by an elasticity above 1
  bool m_bWasSqueezed = false;             // in the last substep: CRestingContacts
  bool m_bPresses = false;                 // on others of a pile, without gravity
  bool m_bHasPressed = false;              // in the last substep, on what it still touches, or that on it
  bool m_bIsPressed = false;               // overlaps more than one that falls asleep may

  // Whether it was squeezed, and a game has given it another velocity.
  bool IsSteered() const { return m_bWasSqueezed && m_nSteered > 0; }
  double GetKinetic() const { return 0.5 * m_fMass * m_vVel.squaredNorm(); } // energy
};

} // namespace Shapes::Native
