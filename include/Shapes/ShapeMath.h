// SPDX-License-Identifier: MIT
// Vectors, angles and the small formulas that every shape shares. y is up, angles are radians,
// counterclockwise.
//
// Error bounds, here and beside every geometric function: n ulp of a length are n 2^-23 of that length, and
// of a sum of lengths likewise. The error of a vector is the length of the difference. Arguments count as
// exact; "|p|" is the distance of p from the origin. The bounds are for lengths from 1e-18 to g_fMaxLength,
// where no product underflows, unless it says more. Where the answer is yes or no, it is right for all
// arguments that are farther than the bound from where it changes.
#pragma once

#include <Eigen/Core>

#include <cmath>

/// Leaves the calling function with `false` if `x` holds. Write the condition so that NaN fails: FailIf(!(d <
/// r)).
#define FailIf(x)                                                                                            \
  do {                                                                                                       \
    if (x) return false;                                                                                     \
  } while (0)

namespace Shapes {

using Vector2 = Eigen::Vector2f;

inline constexpr float g_fPi = 3.14159265358979323846f;
/// The float nearest to 2 pi. It is larger than 2 pi by 1.7e-7, so no angle below 2 pi rounds past it.
inline constexpr float g_fTwoPi = 6.28318530717958647692f;

/// Counterclockwise perpendicular of v. Exact, same length as v.
inline Vector2 perp(const Vector2& v) { return {-v.y(), v.x()}; }

/// z component of the cross product a x b: positive if b lies counterclockwise of a.
/// Error at most 1 ulp of |a.x b.y| + |a.y b.x|, plus 2^-149 where these underflow; exactly 0 if a = b.
inline float Cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Length of v without overflow or underflow on the way: right for every finite v whose length is finite in
/// float. Error at most 1 ulp, plus 2^-149 where it is denormal.
inline float Length(const Vector2& v) {
  // Float squares span twice the exponents of a float; in double none of them over- or underflows.
  const double x = v.x(), y = v.y();
  return static_cast<float>(std::sqrt(x * x + y * y));
}

/// Unit vector along v: each component within 1 ulp of itself (2^-149 where it is denormal) and the length
/// within 1 ulp of 1, for every finite v that is not zero, denormal or huge ones included.
/// @param fallback  the result for the zero vector, a unit vector. Up by default, so that nothing is pushed
///                  along it into the floor.
inline Vector2 Normalize(const Vector2& v, const Vector2& fallback = Vector2(0.0f, 1.0f)) {
  const double x = v.x(), y = v.y();
  const double d = std::sqrt(x * x + y * y);
  if (!(d > 0.0)) return fallback;
  return {static_cast<float>(x / d), static_cast<float>(y / d)};
}

/// Component of v parallel to w, that is (v.w / w.w) w; zero if w is zero. Error at most 3 ulp of
/// |v|, for w of any length.
Vector2 ParallelComponent(const Vector2& v, const Vector2& w);

/// p turned about center by `angle` radians. Error at most 1 ulp of |center| + |p - center|, for every
/// finite angle.
Vector2 RotatePt(const Vector2& p, const Vector2& center, float angle);

/// The same angle in [0, 2 pi), in float too: a tiny negative angle gives 0 rather than a float above 2 pi.
/// Reduced in double, so the error is 1 ulp of the result for |angle| up to 1e9; what is less than 2^-23
/// below 2 pi may give 0. Infinity and NaN come back as they are.
float NormalizeAngle(float angle);

/// Unit vector at `angle` radians from the positive x axis. Each component within 1 ulp of itself, below 2^20
/// radians with the same bits on every machine.
Vector2 AngleToVector(float angle);

} // namespace Shapes
