// SPDX-License-Identifier: MIT
// The way of a ball's centre as the shape sees it, and when it crosses a circle or a line. There are three: a
// straight path, a parabola under constant acceleration, and a turning path: of a ball that slides on a
// curve, or seen by a shape that rotates. All have the same functions, so each shape is written once
// (Sweeper.h).
//
// A crossing is made from clear of the circle or line, or by a ball that touches or overlaps without
// approaching, and begins to approach. Sweeper.h handles balls that approach already at the start of the
// path.
#pragma once

#include "Vec2.h"

#include <cstddef>
#include <vector>

namespace Shapes::Compare {

/// A gap below this many roundings of the coordinates is touching, dimensionless. Larger than what some
/// hundred events add up to; at 1 unit from the origin it is 1.4e-14 units. It is also how many roundings of
/// the speeds and accelerations involved count as none.
inline constexpr int g_nTouchRoundings = 64;

/// A ball whose way passes within this share of the contact distance from a tangent is ambiguous: which way
/// it goes is beyond what the float descriptors say, dimensionless.
inline constexpr double g_fGraze = 1e-9;

/// Coefficients of t^3, t^4, ...: by which the way of a ball that slides differs from its parabola.
template <class T>
using CMore = std::vector<CVec<T>>;

/// The sum of more[k] t^(k + 3), or its first or second derivative.
template <class T>
CVec<T> Beyond(const CMore<T>& more, const T& t, int derivative) {
  CVec<T> sum = CVec<T>::Zero();
  for (std::size_t k = more.size(); k-- > 0;) {
    const T n = T(k + 3), factor = derivative == 0 ? T(1) : derivative == 1 ? n : T(n * (n - T(1)));
    sum = sum * t + more[k] * factor;
  }
  return sum * (derivative == 0 ? T(t * t * t) : derivative == 1 ? T(t * t) : t);
}

/// Bound of the second derivative in [0, t].
template <class T>
T BeyondBound(const CMore<T>& more, const T& t) {
  T sum = T(0);
  for (std::size_t k = more.size(); k-- > 0;)
    sum = sum * t + Norm(more[k]) * T(k + 3) * T(k + 2);
  return sum * t;
}

template <class T>
struct CPathDesc {
  CVec<T> m_vPos; ///< of the ball's centre at time 0
  CVec<T> m_vVel;
  CVec<T> m_vAcc; ///< at time 0; constant unless there is more
  T m_fTimeMax;   ///< The path ends here.
  T m_fTouch;     ///< Gaps up to this are touching.
  T m_fSlow;      ///< A touching ball that approaches no faster than this is not approaching.
  T m_fPush;      ///< Nor is one that is accelerated into the shape by no more than this.
  CMore<T> m_stdMore;
};

/// A crossing of a path with a circle or a line.
template <class T>
struct CCrossing {
  /// Time of the crossing. Input: the time after which to search; negative: from the start, included.
  T m_fTime = T(-1);
  /// The way is tangent within g_fGraze, whether it crosses or not; where it does not, the time is that of
  /// the closest approach (of a step after it, where the shape turns).
  bool m_bGraze = false;
  bool m_bBegins = false; ///< It touched or overlapped already, and begins to approach.
};

} // namespace Shapes::Compare
