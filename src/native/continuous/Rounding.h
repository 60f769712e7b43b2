// SPDX-License-Identifier: MIT
// Roundings of places in the continuous mode, and places as floats.
#pragma once

#include "../../Tolerances.h"
#include "../../geometry/Vector.h"

#include <Shapes/ShapeMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Shapes::Native {

inline double SizeOf(const Vector2d& p, double r) { return p.cwiseAbs().maxCoeff() + r; }

/// An overlap that rounding explains, where these are the coordinates.
inline double Rounding(double size) { return static_cast<double>(g_fTouchRounding) * size; }

/// How far a place is moved at most where it is rounded to floats. A ball smaller than that would be found on
/// what it has left, or behind it.
inline double FloatRounding(const Vector2d& p) {
  return 0.5 * static_cast<double>(std::numeric_limits<float>::epsilon()) * p.norm();
}

/// The radius that a ball under gravity has at least. A smaller one that lies on a shape would be found on
/// the other side of it sooner or later.
inline double LeastRadius(const Vector2d& p) {
  return 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon()) * p.cwiseAbs().sum();
}

/// How fast a surface moves along the normal, towards the ball; 0 where it moves along itself, but for
/// rounding, as that of what turns about its own middle.
inline double GetPush(const Vector2d& n, const Vector2d& surface) {
  const double push = n.dot(surface);
  return std::abs(push) > static_cast<double>(g_fTouchRounding) * Norm(surface) ? push : 0.0;
}

/// How far a centre is kept from where no direction leads away (a shape, or the middle of a disc): there the
/// normal is against the velocity, and one that leaves would be taken for one that comes. At the origin,
/// where nothing has a size, the way has one.
inline double Clear(double size, double way) {
  return 4.0 * std::numeric_limits<double>::epsilon() * (size > 0.0 ? size : way);
}

inline Vector2 ToFloat(const Vector2d& p) {
  // Beyond it boxes are all alike, and nothing is there.
  const double most = 1e37;
  if (std::max(std::abs(p.x()), std::abs(p.y())) < most) [[likely]]
    return {static_cast<float>(p.x()), static_cast<float>(p.y())};
  return p.cwiseMax(-most).cwiseMin(most).cast<float>();
}

/// A double of a float and what that lacks.
inline Vector2d Join(const Vector2& high, const Vector2& tail) {
  return high.cast<double>() + tail.cast<double>();
}

} // namespace Shapes::Native
