// SPDX-License-Identifier: MIT
// Vectors of double: directions, angles, and what an exact bounce makes of a velocity.
#pragma once

#include "Box2DTesting.h"

namespace Shapes::Tests {

inline double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
inline Vector2d Perp(const Vector2d& a) { return {-a.y(), a.x()}; }
inline Vector2d UnitVector(double angle) { return {std::cos(angle), std::sin(angle)}; }
/// Radians between two directions, 0 .. pi.
inline double AngleBetween(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(Cross(a, b), a.dot(b)));
}
inline Vector2d Mirror(const Vector2d& v, const Vector2d& n, double e = 1) {
  return v - (1 + e) * v.dot(n) * n;
}

} // namespace Shapes::Tests
