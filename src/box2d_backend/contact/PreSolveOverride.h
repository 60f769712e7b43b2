// SPDX-License-Identifier: MIT
// Overrides contacts before Box2D solves them, so that it responds to the exact contact of a ball and a
// shape.
#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <vector>

#include "../world/Bodies.h"

namespace Shapes::Box2D {

/// Box2D makes two passes over a step. In the first it updates all contacts in the poses at the
/// beginning, solves them, and moves everything. Then it goes from impact to impact: it moves two bodies to
/// where they touch, updates the contact and then all others that touch them, solves this island, and moves
/// on. It asks about each contact before it is solved (PreSolve) and reports it afterwards (PostSolve). The
/// rules here:
/// - an impact waits for the second pass, and gets its true normal and time;
/// - a body that only touches the shape that is hit waits for its own impact;
/// - a ball that comes into the skins only, or goes past, is ignored;
/// - presses rather than hits are left to Box2D, without the skins;
/// - so are all contacts of a ball in lasting contact, in both passes.
class CPreSolveOverride {
public:
  /// @param g  gravity, 0 if balls do not follow parabolas
  /// @param h  length of the step, seconds
  /// @param weight  of all balls in lasting contact, newtons
  void BeginStep(const b2Vec2& g, float h, float weight);
  const b2Vec2& GetGravity() const { return m_vGravity; }
  float GetStep() const { return m_fStep; }
  /// After PostSolve of any contact.
  void AfterSolve();

  /// A response to be reported, in Box2D's metres.
  struct CResolution {
    b2Vec2 m_vPOI, m_vNorm; ///< normal to the ball
    float m_fSpeed;         ///< of approach
    float m_fUnsolved;      ///< part of the impulse that Box2D's solver has no part in, newton seconds
  };
  /// Prepares the contact for Box2D.
  /// @param contact  its restitution is that of the pair already
  /// @param canWait  false if Box2D may throw the ball another way in its first pass, which resolves contacts
  /// with the game's bodies: a contact that waits with the wrong normal would hold it
  std::optional<CResolution> Override(b2Contact& contact, CBody& shape, CBody& ball, bool canWait);

  /// The state before a call of Override, which is taken back if the game's listener disables the contact.
  struct CMark {
    bool m_bIsIslandOpen = false;
    b2Vec2 m_vIslandNormal;
    std::size_t m_nEarly = 0;
  };
  CMark GetMark() const { return {m_bIsIslandOpen, m_vIslandNormal, m_stdEarly.size()}; }
  void GoBack(const CMark& mark) {
    m_bIsIslandOpen = mark.m_bIsIslandOpen;
    m_vIslandNormal = mark.m_vIslandNormal;
    m_stdEarly.erase(m_stdEarly.begin() + static_cast<std::ptrdiff_t>(mark.m_nEarly), m_stdEarly.end());
  }

  /// After the step: puts a ball on its parabola, but not through a shape that it has bounced off.
  static void Land(CBody& ball);

  /// A ball hits a body of the game, and Box2D resolves that; its parabola bounces there, or ends.
  void FollowOther(b2Contact& contact, CBody& other, CBody& ball);

  /// The part of the step that is over when Box2D is where these two are, by that one which goes farther.
  double PartAt(const CBody& shape, const CBody& ball) const;

private:
  struct CInspected;
  CInspected Inspect(b2Contact& contact, const CBody& shape, const CBody& ball) const;
  std::optional<CResolution> LeaveToSolver(b2Contact& contact, const CBody& shape, const CBody& ball);
  bool ResolvePress(const CInspected& inspected, CBody& shape, CBody& ball, CResolution& resolution);
  bool IsSupport(const CInspected& inspected, CBody& shape, CBody& ball) const;
  void SeparateShapes(const CInspected& inspected, CBody& shape, CBody& ball);
  void OpenIsland(const b2Vec2& n);

  b2Vec2 m_vGravity{0.0f, 0.0f};
  float m_fStep = 0.0f;
  float m_fLastingWeight = 0.0f;
  bool m_bIsContinuous = false; // in the second pass
  bool m_bIsIslandOpen = false; // the contact that was hit is resolved, others that touch come now
  b2Vec2 m_vIslandNormal{0.0f, 0.0f};
  /// Resolved in the first pass: impacts for which the second one is of no use.
  struct CEarly {
    const CBody *m_pShape, *m_pBall;
    b2Vec2 m_vNorm;
  };
  std::vector<CEarly> m_stdEarly;
};

} // namespace Shapes::Box2D
