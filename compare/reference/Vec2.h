// SPDX-License-Identifier: MIT
// Vectors of the exact reference: those of Eigen, on any scalar, so that double can be checked by 50 digits.
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace Shapes::Compare {

template <class T>
using CVec = Eigen::Matrix<T, 2, 1>;

/// z component of a x b.
template <class T>
T Cross(const CVec<T>& a, const CVec<T>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Counterclockwise perpendicular.
template <class T>
CVec<T> Perp(const CVec<T>& v) {
  return {-v.y(), v.x()};
}

/// Length. Squares do not over- or underflow: accepted values are floats, and T has at least the
/// exponents of a double.
template <class T>
T Norm(const CVec<T>& v) {
  using std::sqrt;
  return sqrt(v.x() * v.x() + v.y() * v.y());
}

/// Unit vector along v; `fallback` for the zero vector.
template <class T>
CVec<T> Unit(const CVec<T>& v, const CVec<T>& fallback) {
  const T d = Norm(v);
  if (!(d > T(0))) return fallback;
  return {v.x() / d, v.y() / d};
}

/// v turned counterclockwise by `angle` radians.
template <class T>
CVec<T> Turned(const CVec<T>& v, const T& angle) {
  using std::cos;
  using std::sin;
  const T c = cos(angle), s = sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

using CVec2d = CVec<double>;

/// A vector of the library, exactly.
inline CVec2d ToDouble(const Eigen::Vector2f& v) { return v.cast<double>(); }

} // namespace Shapes::Compare
