// SPDX-License-Identifier: MIT
// Numbers that many tests use.
#pragma once

#include <Shapes/ShapeMath.h>

#include <cmath>
#include <limits>

namespace Shapes {

/// The distance of 1 from the next float.
inline constexpr double g_fUlp = 0x1p-23;
inline constexpr float g_fNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float g_fInf = std::numeric_limits<float>::infinity();
/// 2 pi in double.
inline constexpr double g_fPi2 = 6.28318530717958647692;
/// The time step of most worlds, in seconds.
inline constexpr float g_fDt = 1.0f / 60.0f;

using Vector2d = Eigen::Vector2d;

/// Without rounding.
inline Vector2d Wide(const Vector2& v) { return v.cast<double>(); }
inline double Wide(float f) { return static_cast<double>(f); }

/// Radians between two directions, 0 .. pi.
inline double AngleBetween(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}
/// v mirrored at a surface of normal n, with elasticity e.
inline Vector2d Mirrored(const Vector2d& v, const Vector2d& n, double e = 1) {
  return v - (1 + e) * v.dot(n) * n;
}

} // namespace Shapes
