// SPDX-License-Identifier: MIT
#include "Response.h"

namespace Shapes {
namespace {

// What a response adds along n. Finite: the surface of a shape far from its centre may be faster than any
// ball, and infinity times a component of n that is 0 is not a number. CapSpeed does the rest.
float Kick(float e, float vn) { return std::max((1.0f + e) * vn, -g_fMaxKick); }

} // namespace

bool CapSpeed(Vector2& v, float most) {
  FailIf(Length(v) <= most);
  v = most * Normalize(v);
  return true;
}

void RespondStatic(const Vector2& n, float setback, float e, Vector2& p, Vector2& v) {
  RespondKinematic(n, setback, e, Vector2::Zero(), p, v);
}

void RespondKinematic(const Vector2& n, float setback, float e, const Vector2& surface, Vector2& p,
                      Vector2& v) {
  const float vn = (v - surface).dot(n);
  if (vn < 0.0f) v -= Kick(e, vn) * n;
  p += setback * n;
}

void RespondDynamic(const Vector2& n, float setback, float e, float m0, float m1, Vector2& p0, Vector2& v0,
                    Vector2& p1, Vector2& v1) {
  // As shares of the total mass: the product of two masses may overflow, the shares cannot.
  const float share0 = m1 / (m0 + m1), share1 = m0 / (m0 + m1);
  const float vn = (v1 - v0).dot(n);
  if (vn < 0.0f) {
    v0 += (Kick(e, vn) * share0) * n;
    v1 -= (Kick(e, vn) * share1) * n;
  }
  p0 -= (setback * share0) * n;
  p1 += (setback * share1) * n;
}

} // namespace Shapes
