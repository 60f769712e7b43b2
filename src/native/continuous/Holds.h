// SPDX-License-Identifier: MIT
// The shapes and balls on which a ball lies or slides.
#pragma once

#include "../../geometry/Vector.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

namespace Shapes::Native {

/// A contact that lasts: the ball touches a shape or another ball, and neither goes into it nor leaves it.
struct CHold {
  std::uint32_t m_nOther; ///< order of the shape, or index of the ball
  bool m_bIsBall;
  Vector2d m_vNorm; ///< unit, from the other one
  double m_fSpeed;  ///< of the surface along the normal
  double m_fAcc;    ///< along the normal, with which the ball follows the surface
  /// Of curvature of the way of the centre along the surface: the middle of the curve is so far away against
  /// the normal. Negative inside an arc; infinite where it is flat, or not looked at.
  double m_fRadius;
  std::uint32_t m_nVersion = 0; ///< of the motion of the other ball
};

/// All lasting contacts of a ball.
class CHolds {
public:
  bool IsEmpty() const { return m_nSize == 0; }
  bool HasShape(std::uint32_t order) const;
  /// Of the other ball, on this version of its motion.
  bool HasBall(std::uint32_t ball, std::uint32_t version) const;
  std::span<const CHold> Get() const { return {m_stdHolds.data(), m_nSize}; }
  void Clear() { m_nSize = 0; }
  /// Of more than there is room for, the oldest goes. (Two are enough to hold a ball in the plane.)
  void Add(const CHold& hold);

  /// The velocity closest to v that goes into none of them, and the acceleration closest to a. By Gauss's
  /// principle of least constraint that is the one of a ball without friction. Where there is none the ball
  /// is squeezed: into balls sooner than into shapes.
  Vector2d ConstrainVel(const Vector2d& v) const;
  Vector2d ConstrainAcc(const Vector2d& a) const;
  /// The velocity of a ball that none of the shapes lets go, of which there is at least one: it neither goes
  /// into the first nor leaves it, nor another one that crosses that. Where that would lead it into another
  /// one it stays as it is.
  Vector2d KeepVel(const Vector2d& v) const;
  /// Takes out those for which isOut(hold) is true.
  /// @returns whether there are any
  template <class F>
  bool DropIf(const F& isOut) {
    const auto end = m_stdHolds.begin() + static_cast<std::ptrdiff_t>(m_nSize);
    const auto left = std::remove_if(m_stdHolds.begin(), end, isOut) - m_stdHolds.begin();
    const auto size = static_cast<std::size_t>(left);
    return std::exchange(m_nSize, size) != size;
  }
  /// Takes out those that would have to pull a ball that is accelerated by `acc` instead of by `free`.
  /// @returns whether there are any
  bool DropPulling(const Vector2d& acc, const Vector2d& free);

private:
  std::array<CHold, 4> m_stdHolds; // of which only the first m_nSize are set
  std::size_t m_nSize = 0;
};

} // namespace Shapes::Native
