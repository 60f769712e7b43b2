// SPDX-License-Identifier: MIT
// The bounds of src/shapes/Response.h, in float and in double, and its largest numbers.
#include "Inputs.h"
#include "Worst.h"

#include "shapes/Response.h"

namespace Shapes::Bounds {
namespace {

constexpr int g_nResponseBoundsTrials = 5000;

template <class T>
CFifty Ulp() {
  return CFifty(std::numeric_limits<T>::epsilon());
}
template <class T>
using TVec = Eigen::Matrix<T, 2, 1>;

template <class T>
class ResponseBounds : public testing::Test {};
using CScalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ResponseBounds, CScalars, );

// Two velocities: any, or almost the same, so that their difference has few digits.
template <class T>
TVec<T> AnyVel(CRandom& random) {
  const TVec<T> v = AnyWay(random, AnySize(random)).cast<T>();
  return v * (T(1) + T(random.Unit()) * T(0x1p-20));
}
template <class T>
TVec<T> Beside(CRandom& random, const TVec<T>& v) {
  if (random.Coin()) return AnyVel<T>(random);
  const T away = T(random.Scale(-24, -1)) * v.norm();
  return v + away * random.Direction().cast<T>();
}
template <class T>
TVec<T> AnyNormal(CRandom& random) {
  return Normalize(AnyWay(random, 1.0f)).cast<T>();
}
float AnyElasticity(CRandom& random) {
  return random.Below(4) ? random.Uniform(0.0f, 1.0f) : random.Scale(-4, 4);
}

TYPED_TEST(ResponseBounds, AgainstAStaticOrTurningShape) {
  using T = TypeParam;
  CKept vel("RespondKinematic, velocity", g_nResponseBoundsTrials),
      pos("RespondKinematic, place", g_nResponseBoundsTrials),
      speed("ApproachSpeed", g_nResponseBoundsTrials);
  CBroken naive("Response by parallel and perpendicular component");
  const CFifty ulp = Ulp<T>();
  ForEachCase(1601, g_nResponseBoundsTrials, [&](CRandom& random, int i) {
    const float size = AnySize(random);
    const TVec<T> n = AnyNormal<T>(random), p = AnyPlace(random, size).cast<T>(), v = AnyVel<T>(random);
    const TVec<T> surface = i % 2 ? TVec<T>(TVec<T>::Zero()) : Beside<T>(random, v);
    const T setback = T(random.Unit()) * T(size), e = AnyElasticity(random);
    const CVec en = Exact(n), ev = Exact(v), w = ev - Exact(surface);
    const CFifty vn = Dot(w, en), along = vn < 0 ? CFifty((1 + CFifty(e)) * vn) : CFifty(0);
    TVec<T> gotP = p, gotV = v;
    RespondKinematic<TVec<T>>(n, setback, e, surface, gotP, gotV);
    const CFifty bound = 4 * ulp * (Norm(ev) + (1 + CFifty(e)) * Norm(w));
    vel.See(Exact(gotV), ev - along * en, bound);
    pos.See(Exact(gotP), Exact(p) + CFifty(setback) * en, ulp * (Norm(Exact(p)) + setback));
    speed.See(abs(ApproachSpeed(v, surface, n) - std::max(CFifty(0), CFifty(-vn))), 2 * ulp * Norm(w));
    if (vn >= 0) return;
    // Across by Pythagoras.
    const T rel = (v - surface).dot(n),
            across = std::sqrt(std::max(T(0), (v - surface).squaredNorm() - rel * rel));
    const TVec<T> t(-n.y(), n.x());
    naive.See(Exact(TVec<T>(surface - e * rel * n + std::copysign(across, (v - surface).dot(t)) * t)),
              ev - along * en, bound);
  });
}

// With the largest elasticities. Infinity times the component of n that is 0 would not be a number.
TEST(KinematicResponse, OfASurfaceFasterThanAnyBallStaysFinite) {
  const float e = g_fMaxElasticity * g_fMaxElasticity;
  for (const float V : {1e18f, 1e25f, 1e30f, 1e38f}) {
    Vector2 p = Vector2::Zero(), v(3, -4);
    RespondKinematic<Vector2>(Vector2(0, 1), 0.0f, e, Vector2(0, V), p, v);
    EXPECT_EQ(v.x(), 3.0f) << V;
    EXPECT_GT(v.y(), g_fMaxSpeed) << V;
    EXPECT_TRUE(std::isfinite(v.y())) << V;
  }
}

TYPED_TEST(ResponseBounds, OfTwoBalls) {
  using T = TypeParam;
  CKept vel("RespondDynamic, velocity", g_nResponseBoundsTrials),
      pos("RespondDynamic, place", g_nResponseBoundsTrials),
      momentum("RespondDynamic, momentum", g_nResponseBoundsTrials);
  CBroken naive("Response of two balls by mass differences");
  const CFifty ulp = Ulp<T>();
  ForEachCase(1602, g_nResponseBoundsTrials, [&](CRandom& random, int i) {
    const float size = AnySize(random);
    const TVec<T> n = AnyNormal<T>(random), v0 = AnyVel<T>(random), v1 = Beside<T>(random, v0);
    const TVec<T> p0 = AnyPlace(random, size).cast<T>(), p1 = p0 + T(size) * n;
    const T setback = T(random.Unit()) * T(size), e = AnyElasticity(random);
    // From the lightest to the heaviest: the product of both masses may be no float.
    const int most = i % 3 ? 79 : 119;
    const T m0 = random.Scale(-most, most), m1 = m0 * (i % 3 ? random.Scale(-40, 40) : NearOne(random));
    const CVec en = Exact(n), e0 = Exact(v0), e1 = Exact(v1), w = e1 - e0;
    const CFifty mass = CFifty(m0) + CFifty(m1), share0 = m1 / mass, share1 = m0 / mass, vn = Dot(w, en);
    const CFifty along = vn < 0 ? CFifty((1 + CFifty(e)) * vn) : CFifty(0);
    TVec<T> q0 = p0, q1 = p1, u0 = v0, u1 = v1;
    RespondDynamic<TVec<T>>(n, setback, e, m0, m1, q0, u0, q1, u1);
    const CFifty kick = (1 + CFifty(e)) * Norm(w);
    const CFifty bound0 = 5 * ulp * (Norm(e0) + share0 * kick), bound1 = 5 * ulp * (Norm(e1) + share1 * kick);
    vel.See(Exact(u0), e0 + (along * share0) * en, bound0);
    vel.See(Exact(u1), e1 - (along * share1) * en, bound1);
    pos.See(Exact(q0), Exact(p0) - (setback * share0) * en, 3 * ulp * (Norm(Exact(p0)) + setback * share0));
    pos.See(Exact(q1), Exact(p1) + (setback * share1) * en, 3 * ulp * (Norm(Exact(p1)) + setback * share1));
    momentum.See(CFifty(m0) * Exact(u0) + CFifty(m1) * Exact(u1), CFifty(m0) * e0 + CFifty(m1) * e1,
                 m0 * bound0 + m1 * bound1);
    if (vn >= 0) return;
    // Each from the textbook's ((m1 - e m0) v1 + (1 + e) m0 v0) / (m0 + m1) along n.
    const int scale = -std::ilogb(m0); // so that it loses digits, not the range
    const T w0 = std::ldexp(m0, scale), w1 = std::ldexp(m1, scale);
    const T a0 = v0.dot(n), a1 = v1.dot(n);
    const T b1 = ((w1 - e * w0) * a1 + (T(1) + e) * w0 * a0) / (w0 + w1);
    naive.See(Exact(TVec<T>(v1 + (b1 - a1) * n)), e1 - (along * share1) * en, bound1);
  });
}

TYPED_TEST(ResponseBounds, CapSpeed) {
  using T = TypeParam;
  CKept worst("CapSpeed", 1000);
  ForEachCase(1603, g_nResponseBoundsTrials, [&](CRandom& random, int i) {
    const float most = AnySize(random), nearly = most * NearOne(random);
    const TVec<T> v = i % 2 ? AnyVel<T>(random) : TVec<T>(AnyWay(random, nearly).cast<T>());
    TVec<T> got = v;
    const bool cut = CapSpeed(got, most);
    const CVec e = Exact(v);
    const CFifty speed = Norm(e);
    if (abs(speed - most) > 2 * Ulp<T>() * speed) {
      EXPECT_EQ(cut, speed > most);
    }
    if (!cut) {
      EXPECT_EQ(got, v);
      return;
    }
    worst.See(Exact(got), (CFifty(most) / speed) * e, 4 * Ulp<T>() * most);
  });
}

TEST(FreeFlightBounds, AccelerateAndMove) {
  CKept vel("Accelerate", g_nResponseBoundsTrials), pos("Move", g_nResponseBoundsTrials);
  CBroken naive("Move by the mean of both velocities");
  ForEachCase(1604, g_nResponseBoundsTrials, [&](CRandom& random, int) {
    const Vector2 g = AnyWay(random, AnySize(random)), v = AnyWay(random, AnySize(random)),
                  p = AnyPlace(random, AnySize(random));
    const float dt = random.Scale(-20, 0);
    const CVec gdt = CFifty(dt) * Exact(g);
    Vector2 gotV = v, gotP = p;
    Accelerate(gotV, g, dt);
    vel.See(Exact(gotV), Exact(v) + gdt, g_fUlp * (Norm(Exact(v)) + Norm(gdt)));
    Move(gotP, gotV, dt);
    const CVec vdt = CFifty(dt) * Exact(gotV);
    const CFifty bound = g_fUlp * (Norm(Exact(p)) + Norm(vdt));
    pos.See(Exact(gotP), Exact(p) + vdt, bound);
    naive.See(Exact(Vector2(p + 0.5f * dt * (v + gotV))), Exact(p) + vdt, bound);
  });
}

} // namespace
} // namespace Shapes::Bounds
