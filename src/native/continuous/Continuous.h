// SPDX-License-Identifier: MIT
#pragma once

#include "../../geometry/TimeOfImpact.h"
#include "../../world/WorldState.h"

#include <cstdint>
#include <vector>

#include "../broadphase/AabbTree.h"
#include "../broadphase/StaticBroadPhase.h"

namespace Shapes::Native {

/// The continuous mode of a substep: every solid ball moves straight on at the velocity that it has, from
/// impact to impact, and responds to each, in the order of time, at the place and in the direction of the
/// impact; the rest of the substep it moves on. Shapes turn meanwhile. Computed in double.
///
/// - An unobstructed ball moves bit-identically to the approximate mode.
/// - Initial overlaps are pushed out along the normal, of two balls by their shares of the mass, but never
///   through another shape. An overlap of a one-sided shape by more than rounding stays.
/// - Impacts at the same time are answered one after the other: shapes before balls, by order and by id.
/// - A ball that comes back to the same turning shape or inside of an arc within 1/g_nHops of the substep,
///   and leaves it all but along the surface, slides: it keeps its speed, but leaves so steeply that it stays
///   away for that long, or at g_fShallow radians if that is less.
/// - A ball that touches a shape at the beginning, and would not approach it but for what gravity has just
///   added, rests on it: it does not bounce, whatever the elasticities are.
/// - A ball that has had g_nMaxImpacts impacts is halted: it stays where it is, which is a place that it can
///   be at, for the rest of the substep, and keeps its velocity; others bounce off it as off a wall.
class CContinuous {
public:
  /// Moves the balls by dt seconds, and counts what was done.
  /// @param shapes  as they are at the beginning of the substep
  /// @param pairs   whether balls meet each other
  /// @param gravityStep  what gravity has added to their velocities in this substep
  void Step(CBallArrays& balls, CStaticBroadPhase& shapes, bool pairs, const Vector2& gravityStep, float dt,
            CWorldStats& stats);

  /// The impacts of the last call in the order of time.
  const std::vector<CContactEvent>& GetContacts() const { return m_stdContacts; }
  /// Where balls were at the share m_fPart of the substep when they were answered.
  struct CPathVertex {
    std::size_t m_nBall;
    Vector2 m_vPos;
    float m_fPart;
  };
  const std::vector<CPathVertex>& GetPathVertices() const { return m_stdPathVertices; }

private:
  static constexpr std::uint32_t g_nNone = 0xFFFFFFFFu;

  /// What a ball meets next.
  struct CNext {
    eSweep m_eSweep = eSweep::None;
    bool m_bIsBall = false;
    std::uint32_t m_nOther = g_nNone;  // order of the shape, or index in m_stdBalls
    std::uint32_t m_nOtherVersion = 0; // of a ball
    double m_fOtherTime = 0.0;         // of a ball: seconds on its own motion
    CImpact m_cImpact;                 // at the time on the motion of this ball; the normal points to it
  };
  struct CMoving {
    std::size_t m_nBall; // index in the arrays
    Vector2d m_vPos;     // where the motion begins
    Vector2d m_vVel;
    Vector2d m_vFirst; // velocity at the beginning, gravity included
    double m_fRadius, m_fMass, m_fElasticity;
    double m_fTime = 0.0; // when the motion begins, seconds in the substep
    CNext m_cNext;
    std::uint32_t m_nVersion = 0; // changes with the motion
    unsigned m_nImpacts = 0;
    std::uint32_t m_nLastOrder = g_nNone; // of the shape that it has just left
    bool m_bIsHalted = false;
    bool m_bIsMoved = false; // by anything but its velocity

    Vector2d GetPathVel() const { return m_bIsHalted ? Vector2d(Vector2d::Zero()) : m_vVel; }
  };
  struct CEvent {
    double m_fTime;
    std::uint32_t m_nBall;
    std::uint32_t m_nVersion;
    bool operator<(const CEvent& other) const; // comes later: for a heap whose top is the first
  };

  void TakeBalls(const CBallArrays& balls);
  void SortBalls(bool pairs);
  void PutBalls(CBallArrays& balls) const;
  CMotion GetMotion(const CMoving& ball) const;
  CAabb2D GetBox(const CMoving& ball) const;
  void FindShapes(std::uint32_t i);
  bool SetBackFromShapes(std::uint32_t i);
  void SetBackFromBalls(std::uint32_t i);
  void CorrectPosition(std::uint32_t i, const Vector2d& n, double depth);
  void FindNext(std::uint32_t i);
  void FindShapeImpacts(CMoving& ball);
  void FindBallImpacts(std::uint32_t i);
  void KeepEarliest(const CNext& found, double size, CMoving& ball) const;
  void Queue(std::uint32_t i);
  void Advance(CMoving& ball, double motion);
  void Resolve(std::uint32_t i);
  void ResolveWithShape(CMoving& ball);
  void ResolveWithBall(CMoving& ball, CMoving& other);
  bool IsRestingContact(const CMoving& ball) const;
  void Slide(CMoving& ball, const CImpact& impact) const;
  void Report(CShapeId shape, const CMoving& ball, const Vector2d& poi, const Vector2d& n, double speed);
  void EndMotion(CMoving& ball);
  void Halt(CMoving& ball);
  void NewMotion(std::uint32_t i);

  std::vector<CContactEvent> m_stdContacts;
  std::vector<CPathVertex> m_stdPathVertices;

  // Of the substep.
  CBallArrays* m_pBalls = nullptr;
  CStaticBroadPhase* m_pShapes = nullptr;
  CWorldStats* m_pStats = nullptr;
  double m_fStep = 0.0;
  Vector2d m_vGravityStep = Vector2d::Zero();
  std::vector<CMoving> m_stdBalls; // that are solid
  std::vector<CAabb2D> m_stdBoxes; // of their motions
  CAabbTree m_cBallTree;
  int m_nRefits = 0;              // since it was built
  std::vector<CEvent> m_stdQueue; // a heap
  std::vector<std::uint32_t> m_stdShapesFound, m_stdBallsFound;
};

} // namespace Shapes::Native
