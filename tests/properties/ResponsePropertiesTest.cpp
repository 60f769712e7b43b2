// SPDX-License-Identifier: MIT
// Responses: momentum, energy, and what does not change.
#include "Generators.h"
#include "Properties.h"

#include "shapes/Response.h"

namespace Shapes::Properties {
namespace {

// Against a shape whose surface moves; the naive ones are the controls.
using CRespond = void (*)(const Vector2& n, float setback, float e, const Vector2& surface, Vector2& p,
                          Vector2& v);

void Respond(const Vector2& n, float setback, float e, const Vector2& surface, Vector2& p, Vector2& v) {
  RespondKinematic(n, setback, e, surface, p, v);
}
// Reflected as off a static shape, and a kick of e (V - v) on top of it.
void ReflectAndKick(const Vector2& n, float setback, float e, const Vector2& surface, Vector2& p,
                    Vector2& v) {
  const Vector2 kick = e * (surface.dot(n) - v.dot(n)) * n;
  RespondStatic(n, setback, e, p, v);
  v += kick;
}

Vector2 Normal() { return Normalize(*Way(1.0f)); }
// A velocity, and one that is any other or almost the same.
Vector2 Velocity() {
  return *rc::gen::mapcat(AnySize(), [](float speed) { return Way(speed); });
}
Vector2 Beside(const Vector2& v) {
  return *rc::gen::arbitrary<bool>() ? Velocity() : Vector2(*NearOne() * v);
}

// What the error of v' and that of the length of n add to a speed: n is within 1 ulp of length 1, so v'.n
// within (1 + e) (2 ulp + ulp^2) |w| of what a unit vector gives.
double Slack(const Vector2& v, const Vector2d& w, double e, double ulps) {
  return g_fUlp * (ulps * (Wide(v).norm() + (1 + e) * w.norm()) + 3 * (1 + e) * w.norm());
}

TEST(ResponseProperties, AShapeAddsNoEnergyInItsFrame) {
  const auto holds = [](CRespond respond) {
    return [=] {
      const Vector2 n = Normal(), v = Velocity();
      const Vector2 surface = *rc::gen::arbitrary<bool>() ? Vector2(Vector2::Zero()) : Beside(v);
      const float e = *Between(0.0f, 1.0f);
      Vector2 p = Vector2::Zero(), u = v;
      respond(n, 0.0f, e, surface, p, u);
      const Vector2d w = Wide(v) - Wide(surface), after = Wide(u) - Wide(surface);
      const double slack = Slack(v, w, static_cast<double>(e), 4);
      RC_ASSERT(after.norm() <= w.norm() + slack);
      // Off the shape afterwards, at e times the speed of before; across the normal nothing has changed.
      const double before = w.dot(Wide(n)), then = after.dot(Wide(n));
      RC_ASSERT(std::abs(then - (before < 0.0 ? -static_cast<double>(e) * before : before)) <= slack);
      RC_ASSERT(std::abs((after - w).dot(Wide(perp(n)))) <= slack);
    };
  };
  ExpectHolds(holds(Respond), 10000);
  ExpectBroken(holds(ReflectAndKick));
}

TEST(ResponseProperties, TwoBallsKeepTheirMomentumAndGainNoEnergy) {
  const auto holds = [](bool shared) {
    return [=] {
      const Vector2 n = Normal(), v0 = Velocity(), v1 = Beside(v0);
      const float e = *Between(0.0f, 1.0f);
      const float m0 = *Scale(20), m1 = *rc::gen::arbitrary<bool>() ? *Scale(20) : *NearOne() * m0;
      const float setback = *AnySize();
      Vector2 p0 = Vector2::Zero(), p1 = Vector2::Zero(), u0 = v0, u1 = v1;
      // The control shares as if both weighed the same.
      RespondDynamic(n, setback, e, shared ? m0 : 1.0f, shared ? m1 : 1.0f, p0, u0, p1, u1);
      const double M0 = m0, M1 = m1, s0 = M1 / (M0 + M1), s1 = M0 / (M0 + M1), E = e;
      const Vector2d w = Wide(v1) - Wide(v0);
      const double kick = (1 + E) * w.norm();
      const double b0 = 5 * g_fUlp * (Wide(v0).norm() + s0 * kick),
                   b1 = 5 * g_fUlp * (Wide(v1).norm() + s1 * kick);
      RC_ASSERT((M0 * Wide(u0) + M1 * Wide(u1) - M0 * Wide(v0) - M1 * Wide(v1)).norm() <= M0 * b0 + M1 * b1);
      // By the relative speed: the energy is that of the common motion, and of this with the reduced mass.
      const Vector2d after = Wide(u1) - Wide(u0);
      RC_ASSERT(after.norm() <= w.norm() + b0 + b1 + 3 * g_fUlp * kick);
      // The centre of mass stays where it was: p of both was 0.
      const double q0 = 3 * g_fUlp * s0 * static_cast<double>(setback),
                   q1 = 3 * g_fUlp * s1 * static_cast<double>(setback);
      RC_ASSERT((M0 * Wide(p0) + M1 * Wide(p1)).norm() <= M0 * q0 + M1 * q1);
      RC_ASSERT(std::abs((Wide(p1) - Wide(p0)).norm() - static_cast<double>(setback)) <=
                q0 + q1 + g_fUlp * static_cast<double>(setback));
    };
  };
  ExpectHolds(holds(true), 10000);
  ExpectBroken(holds(false));
}

TEST(ResponseProperties, AQuarterTurnAMirrorAndAPowerOfTwoKeepTheBits) {
  const auto holds = [](bool epsilon) {
    return [=] {
      const Vector2 n = Normal(), v = Velocity(), surface = Beside(v), p = *Place(1.0f);
      const float e = *Between(0.0f, 2.0f), setback = *AnySize();
      const float s = std::ldexp(1.0f, *Whole(20));
      const auto respond = [=](const Vector2& nn, float back, const Vector2& ss, Vector2 pp, Vector2 vv) {
        // The control takes slow ones for resting.
        if (epsilon && (vv - ss).norm() < 1e-3f) return std::pair(pp, ss);
        RespondKinematic(nn, back, e, ss, pp, vv);
        return std::pair(pp, vv);
      };
      const auto [p1, v1] = respond(n, setback, surface, p, v);
      const auto turned = respond(perp(n), setback, perp(surface), perp(p), perp(v));
      RC_ASSERT(turned.first == perp(p1) && turned.second == perp(v1));
      const auto mirror = [](const Vector2& a) { return Vector2(a.x(), -a.y()); };
      const auto mirrored = respond(mirror(n), setback, mirror(surface), mirror(p), mirror(v));
      RC_ASSERT(mirrored.first == mirror(p1) && mirrored.second == mirror(v1));
      const auto scaled = respond(n, s * setback, s * surface, s * p, s * v);
      RC_ASSERT(scaled.first == Vector2(s * p1) && scaled.second == Vector2(s * v1));
    };
  };
  ExpectHolds(holds(false));
  ExpectBroken(holds(true));
}

} // namespace
} // namespace Shapes::Properties
