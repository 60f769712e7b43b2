// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/World.h>

#include "../geometry/AabbTree.h"
#include "BallPath.h"
#include "WorldState.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace Shapes {

/// Which ball touched which sensor on its path: after each substep, the same for all engines, which only say
/// where the path of a ball bent. Touching is that the centre came closer than the radius at any time of the
/// substep. Which pairs touch is kept in the state of the world.
class CSensors {
public:
  /// A shape or a ball came, went or changed: what is known of the indices of sensors is void.
  void Invalidate() { m_bIsInvalid = true; }
  /// A shape is elsewhere, or is another one: what is known of it is void.
  void InvalidateShape(const CShape& shape) {
    m_bShapesChanged |=
        shape.GetMotionType() == eMotion::Static && (shape.GetSensor() || !m_stdBalls.empty());
  }

  /// Before the substeps of a step: ends the pairs of which one is gone, or is turned off, or of which
  /// neither is a sensor any more.
  /// @return whether there is any sensor; else the others need not be called
  bool Begin(CWorldState& state, std::vector<CSensorEvent>& events);

  void AddPathVertex(std::size_t ball, const Vector2& p, float t) {
    if (m_bAny) m_stdVertices.push_back({ball, {static_cast<double>(t), p.cast<double>()}});
  }

  /// After a substep of dt seconds: appends what began and ended, and counts what was looked at.
  /// @return the contacts, by ball and then by shape; valid until the next call
  std::span<const CContactEvent> Sense(CWorldState& state, float dt, std::vector<CSensorEvent>& events,
                                       CWorldStats& stats);

private:
  struct CBallVertex {
    std::size_t m_nBall;
    CPathVertex m_cPoint;
  };
  /// A shape that is a sensor, or may be met by a ball that is one.
  struct CSensed {
    const CShapeEntry* m_pEntry;
    CZone m_cZone;
    CBox2d m_cBox; // of wherever it was during the substep
    Vector2d m_vRotCenter, m_vMove;
    double m_fTurn;
  };
  struct CSeen {
    CContactEvent m_cEvent;
    bool m_bAtEnd;
  };

  void FindSensors(const CWorldState& state);
  void TakePaths(const CBallArrays& balls);
  void TakeShapes(const CWorldState& state);
  static CSensed Take(const CShapeEntry& entry);
  CBallPath GetPath(std::size_t ball) const;
  void TouchShape(const CBallArrays& balls, std::size_t i, const CSensed& sensed, double dt,
                  CWorldStats& stats);
  void TouchBall(const CBallArrays& balls, std::size_t i, std::size_t j, double dt, CWorldStats& stats);
  void Add(CShapeId ball, CShapeId shape, const CZone::CTouch& touch, const Vector2d& velocity);
  void ReportChanges(std::vector<CTouchingPair>& touching, std::vector<CSensorEvent>& events);

  bool m_bIsInvalid = true;
  bool m_bAny = false;
  std::vector<std::uint32_t> m_stdStaticShapes, m_stdKinematicShapes; // sensors; all, if a ball is a sensor
  std::vector<std::uint32_t> m_stdBalls;                              // sensors
  bool m_bShapesChanged = true;
  std::vector<CSensed> m_stdStatic; // until one of them changes
  Geometry::CAabbTree m_cTree;      // of their boxes

  // Of the substep.
  std::vector<CBallVertex> m_stdVertices;
  std::vector<CPathVertex> m_stdPoints; // the paths of all balls, one after the other
  std::vector<std::size_t> m_stdFirst;  // where in them that of each ball begins, and where the last one ends
  std::vector<CBox2d> m_stdBoxes;       // around all places of each ball
  std::vector<CSensed> m_stdKinematic;
  std::vector<std::uint32_t> m_stdFound;
  std::vector<CPathVertex> m_stdOtherPath; // a path in another frame
  std::vector<CSeen> m_stdSeen;
  std::vector<CContactEvent> m_stdContacts;
  std::vector<CTouchingPair> m_stdTouching;
};

} // namespace Shapes
