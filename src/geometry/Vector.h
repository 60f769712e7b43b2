// SPDX-License-Identifier: MIT
// Vectors of doubles, where the library needs more than float.
#pragma once

#include <Eigen/Core>

#include "Turn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Shapes {

using Vector2d = Eigen::Vector2d;
/// <Eigen/Geometry> has it.
using CBox2d = Eigen::AlignedBox<double, 2>;

namespace Geometry {

/// z component of a x b.
inline double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
/// Counterclockwise perpendicular.
inline Vector2d Perp(const Vector2d& v) { return {-v.y(), v.x()}; }
/// Magnitude of the larger coordinate.
inline double Largest(const Vector2d& v) { return v.cwiseAbs().maxCoeff(); }

// These divide only what can be divided: a compiler may compute what is not needed, and that must not raise
// an exception either.

/// Length, also where the squares underflow. Coordinates up to 1e150.
inline double Norm(const Vector2d& v) {
  const double square = v.squaredNorm();
  if (square < 0x1p-900) [[unlikely]]
    return 0x1p-500 * std::sqrt((0x1p500 * v).squaredNorm());
  return std::sqrt(square);
}
/// Unit vector along v; `fallback` for the zero vector.
inline Vector2d Unit(const Vector2d& v, const Vector2d& fallback) {
  const double d = Norm(v);
  const Vector2d unit = v / (d > 0.0 ? d : 1.0);
  return d > 0.0 ? unit : fallback;
}
/// above / below, of what is not negative; infinite if that is more than `most`, or if both are 0.
inline double Quotient(double above, double below, double most) {
  const bool fits = below > 0.0 && above <= most * below;
  return (fits ? above : std::numeric_limits<double>::infinity()) / (fits ? below : 1.0);
}
/// Share of the way from p by d at which it is closest to q; 0 if there is no way.
inline double ClosestShare(const Vector2d& p, const Vector2d& d, const Vector2d& q) {
  const double dd = d.squaredNorm();
  return dd > 0.0 ? std::clamp(d.dot(q - p) / dd, 0.0, 1.0) : 0.0;
}
/// v turned counterclockwise.
inline Vector2d Turned(const Vector2d& v, const CTurn& turn) {
  const auto [c, s] = turn;
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}
/// The same, by `angle` radians.
inline Vector2d Turned(const Vector2d& v, double angle) { return Turned(v, GetTurn(angle)); }
/// p turned about center, as by Shapes::RotatePt: for several points that turn by the same angle.
inline Eigen::Vector2f RotatePt(const Eigen::Vector2f& p, const Eigen::Vector2f& center, const CTurn& turn) {
  if (turn.m_fSin == 0.0 && turn.m_fCos == 1.0) return p; // as the sum may be rounded
  const Vector2d c = center.cast<double>();
  return (c + Turned(p.cast<double>() - c, turn)).cast<float>();
}

} // namespace Geometry
} // namespace Shapes
