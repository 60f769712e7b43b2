// SPDX-License-Identifier: MIT
// Vectors, angles and the small formulas that every shape shares. y is up, angles are radians,
// counterclockwise.
#pragma once

#include <Eigen/Core>

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
/// Error at most eps (|a.x b.y| + |a.y b.x|), eps = 2^-23; exactly 0 if a = b.
inline float Cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Length of v without overflow or underflow on the way: right for every finite v. Error at most 2 ulp.
float Length(const Vector2& v);

/// Unit vector along v, within 2 ulp of length 1 for every finite v that is not zero, denormal or huge ones
/// included.
/// @param fallback  what the zero vector gives; a unit vector. Up by default, so that whatever is pushed
/// along
///                  it is not pushed into the floor.
Vector2 Normalize(const Vector2& v, const Vector2& fallback = Vector2(0.0f, 1.0f));

/// Component of v parallel to w, that is (v.w / w.w) w; zero if w is zero.
Vector2 ParallelComponent(const Vector2& v, const Vector2& w);

/// p turned about center by `angle` radians. Error at most 3 ulp of |center| + |p - center|.
Vector2 RotatePt(const Vector2& p, const Vector2& center, float angle);

/// The same angle in [0, 2 pi), in float too: a tiny negative angle gives 0 rather than a float above 2 pi.
/// Reduced in double, so the error is 1 ulp of the result for |angle| up to 1e9. Infinity and NaN come back
/// as they are.
float NormalizeAngle(float angle);

/// Unit vector at `angle` radians from the positive x axis. Each component within 1 ulp.
Vector2 AngleToVector(float angle);

} // namespace Shapes
