// SPDX-License-Identifier: MIT
#include <Shapes/ShapeMath.h>

#include "../geometry/Vector.h"

#include <cmath>

namespace Shapes {

Vector2 ParallelComponent(const Vector2& v, const Vector2& w) {
  const Vector2 what = Normalize(w, Vector2::Zero());
  return v.dot(what) * what;
}

Vector2 RotatePt(const Vector2& p, const Vector2& center, float angle) {
  return Geometry::RotatePt(p, center, Geometry::GetTurn(static_cast<double>(angle)));
}

float NormalizeAngle(float angle) {
  if (!std::isfinite(angle)) return angle;
  constexpr double twoPi = 6.28318530717958647692;
  constexpr double rest = 2.44929359829470641e-16; // 2 pi - twoPi
  double a = angle;
  if (std::abs(a) >= twoPi) {
    a = std::fmod(a, twoPi);
    a -= std::round((static_cast<double>(angle) - a) / twoPi) * rest;
    a = std::fmod(a, twoPi); // of huge angles the rests alone are many turns
  }
  if (a < 0.0) a += twoPi;
  const float f = static_cast<float>(a);
  return f >= g_fTwoPi ? 0.0f : f + 0.0f; // + 0 turns -0 into 0
}

Vector2 AngleToVector(float angle) {
  const auto [c, s] = Geometry::GetTurn(static_cast<double>(angle));
  return {static_cast<float>(c), static_cast<float>(s)};
}

} // namespace Shapes
