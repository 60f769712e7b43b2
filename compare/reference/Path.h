// SPDX-License-Identifier: MIT
// The way of a ball's centre as the shape sees it, and when it crosses a circle or a line. There are three: a
// straight path, a parabola under constant acceleration, and a turning path, seen by a shape that rotates.
// All have the same functions, so each shape is written once (Sweeper.h).
//
// A crossing is made from clear of the circle or line, or by a ball that touches or overlaps without
// approaching, and begins to approach. What approaches already at the start of the path is the business of
// Sweeper.h.
#pragma once

#include "Vec2.h"

#include <limits>

namespace Shapes::Compare {

/// A gap below this many roundings of the coordinates is touching, dimensionless. Larger than what some
/// hundred events add up to; at 1 unit from the origin it is 1.4e-14 units. It is also how many roundings of
/// the speeds and accelerations involved count as none.
inline constexpr int g_nTouchRoundings = 64;

/// A ball whose way passes within this share of the contact distance from a tangent is ambiguous: which way
/// it goes is beyond what the float descriptors say, dimensionless.
inline constexpr double g_fGraze = 1e-9;

template <class T>
struct CPathDesc {
  CVec<T> m_vPos; ///< of the ball's centre at time 0
  CVec<T> m_vVel;
  CVec<T> m_vAcc; ///< constant
  T m_fTimeMax;   ///< The path ends here.
  T m_fTouch;     ///< Gaps up to this are touching.
  T m_fSlow;      ///< A touching ball that approaches no faster than this is not approaching.
  T m_fPush;      ///< Nor is one that is accelerated into the shape by no more than this.
};

/// A crossing of a path with a circle or a line.
template <class T>
struct CCrossing {
  /// When. What is passed in is the time after which to search; negative: from the start, included.
  T m_fTime = T(-1);
  /// The way is tangent within g_fGraze, whether it crosses or not; where it does not, the time is that of
  /// the closest approach (of a step after it, where the shape turns).
  bool m_bGraze = false;
  bool m_bBegins = false; ///< It touched or overlapped already, and begins to approach.
};

} // namespace Shapes::Compare
