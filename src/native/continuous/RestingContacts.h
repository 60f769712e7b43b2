// SPDX-License-Identifier: MIT
// Balls that rest on each other: which accelerations they have.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "Moving.h"

namespace Shapes::Native {

/// The slow contacts of balls with each other and with shapes at the beginning of a substep: pairs that touch
/// or would touch within it, and approach no faster than gravity makes them. They are inelastic. The
/// velocities at the end of the substep are those that gravity gives, changed by impulses along the normals
/// that push and never pull, so that no pair ends in an overlap (projected Gauss-Seidel from the bottom up
/// and back, begun with the impulses of the substep before). In between all accelerations are constant.
///
/// An impulse J at a pair that approaches at u0 before and u1 after does the work -J (u0 + u1) / 2, which is
/// not above zero for what is asked of u1: contacts give no energy.
class CRestingContacts {
public:
  void Clear();
  /// Takes up a pair of balls, or a ball and the shape of this order (`isBall` false).
  /// @param impact  as of Near, for the present accelerations of the balls
  void Add(std::uint32_t ball, std::uint32_t other, bool isBall, const CImpact& impact, double gap);
  bool IsEmpty() const { return m_stdContacts.empty(); }
  /// Forgets the impulses of the last substep, so that the next one does not depend on what was before.
  void Forget() { m_stdKnown.clear(); }
  using CPair = std::pair<std::uint32_t, std::uint32_t>;
  /// Whether two balls are a pair here.
  bool Has(std::uint32_t ball, std::uint32_t other) const;
  /// The pairs of a ball, which is the first in all of them.
  std::span<const CPair> GetNeighbours(std::uint32_t ball) const;

  /// Moves balls that overlap apart, and out of shapes: by less than a quarter of their radius.
  void Separate(std::vector<CMoving>& balls, const Vector2d& gravity);
  /// Sets the accelerations of all balls that are in a contact; the shapes that push become holds.
  void Solve(std::vector<CMoving>& balls, const Vector2d& gravity, double dt);
  /// Calls f(ball, other, isBall, normal) for each contact that pushes, from the bottom up.
  template <class F>
  void ForEach(const F& f) const {
    for (const CContact& c : m_stdContacts)
      if (c.m_fImpulse > 0.0) f(c.m_nBall, c.m_nOther, c.m_bIsBall, c.m_vNorm);
  }

private:
  struct CContact {
    std::uint32_t m_nBall, m_nOther;
    bool m_bIsBall;
    Vector2d m_vNorm;
    Vector2d m_vPos = Vector2d::Zero(); // of the ball where the gap is that of a shape
    double m_fGap, m_fSpeed, m_fRadius;
    double m_fBend;         // second derivative of the gap, without the accelerations of the balls
    double m_fHeight = 0.0; // against gravity
    double m_fShare = 0.0;  // 1 / (inverse masses)
    double m_fLeast = 0.0;  // that the difference of velocities along the normal may have at the end
    bool m_bIsSlow = false; // and so solved
    double m_fImpulse = 0.0;
  };
  struct CKnown {
    std::uint64_t m_nPair;
    double m_fImpulse;
  };
  static std::uint64_t Pair(const CContact& c) {
    return (std::uint64_t{c.m_nBall} << 33) | (std::uint64_t{c.m_nOther} << 1) | std::uint64_t{c.m_bIsBall};
  }
  void Iterate(const std::vector<CMoving>& balls, double accurate);

  std::vector<CContact> m_stdContacts; // from the bottom up after Separate
  std::vector<Vector2d> m_stdMoves;    // of each ball
  std::vector<Vector2d> m_stdVels;     // of each ball at the end of the substep
  std::vector<CPair> m_stdPairs;       // each both ways
  std::vector<CKnown> m_stdKnown;      // impulses of the last substep, by pair
};

} // namespace Shapes::Native
