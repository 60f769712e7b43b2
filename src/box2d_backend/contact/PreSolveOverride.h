// SPDX-License-Identifier: MIT
// Overrides contacts before Box2D solves them, so that it responds to the exact contact of a ball and a
// shape.
#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <vector>

#include "../world/Bodies.h"

namespace Shapes::Box2D {

/// Box2D makes two passes over a step. In its first look it updates all contacts where everything is at the
/// beginning, solves them, and moves everything. Then it goes from impact to impact: it moves two bodies to
/// where they touch, updates the contact and then all others that touch them, solves this island, and moves
/// on. It asks about each contact before it is solved (PreSolve) and reports it afterwards (PostSolve). What
/// it is answered here:
/// - an impact waits for the second pass, and gets the normal and the time that it really has;
/// - what only touches the shape that is hit waits for its own impact;
/// - what comes into the skins only, or goes past, is left alone;
/// - what is pressed rather than hit is left to Box2D, without the skins;
/// - so is all that a ball in lasting contact touches, in both passes.
class CPreSolveOverride {
public:
  /// @param g  gravity, 0 if balls do not follow parabolas
  /// @param h  length of the step, seconds
  /// @param weight  of all balls in lasting contact, newtons
  void BeginStep(const b2Vec2& g, float h, float weight);
  /// After PostSolve of any contact.
  void AfterSolve();

  /// A response to be reported, in Box2D's metres.
  struct CResolution {
    b2Vec2 m_vPOI, m_vNorm; ///< normal to the ball
    float m_fSpeed;         ///< of approach
  };
  /// Prepares the contact for Box2D.
  /// @param contact  its restitution is that of the pair already
  /// @param canWait  false if Box2D may throw the ball another way in its first look, as what is there of
  /// somebody else is answered then: what waits the wrong way round would hold it
  std::optional<CResolution> Override(b2Contact& contact, CBody& shape, CBody& ball, bool canWait = true);

  /// After the step: puts a ball on its parabola, but not through a shape that it has bounced off.
  static void Land(CBody& ball);

  /// A ball meets what is not ours, and Box2D answers that; its parabola bounces there, or ends.
  void FollowOther(b2Contact& contact, CBody& other, CBody& ball);

  /// The part of the step that is over when Box2D is where these two are, by that one which goes farther.
  double PartAt(const CBody& shape, const CBody& ball) const;

private:
  struct CInspected;
  CInspected Inspect(b2Contact& contact, const CBody& shape, const CBody& ball) const;
  std::optional<CResolution> LeaveToSolver(b2Contact& contact, const CBody& shape, const CBody& ball);
  bool ResolvePress(const CInspected& inspected, CBody& shape, CBody& ball);
  bool IsSupport(const CInspected& inspected, CBody& shape, CBody& ball) const;
  void SeparateShapes(const CInspected& inspected, CBody& shape, CBody& ball);
  void OpenIsland(const b2Vec2& n);

  b2Vec2 m_vGravity{0.0f, 0.0f};
  float m_fStep = 0.0f;
  float m_fLastingWeight = 0.0f;
  bool m_bIsContinuous = false; // in the second pass
  bool m_bIsIslandOpen = false; // the contact that was hit has been answered, what else touches comes now
  b2Vec2 m_vIslandNormal{0.0f, 0.0f};
  /// Answered in the first look: impacts for which the second pass is of no use.
  struct CEarly {
    const CBody *m_pShape, *m_pBall;
    b2Vec2 m_vNorm;
  };
  std::vector<CEarly> m_stdEarly;
};

} // namespace Shapes::Box2D
