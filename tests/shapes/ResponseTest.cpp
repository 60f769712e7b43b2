// SPDX-License-Identifier: MIT
#include "shapes/Response.h"

#include "Tolerances.h"

#include "../Numbers.h"
#include "../Random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Shapes {
namespace {

using Tests::CRandom;

const Vector2 g_vUp(0.0f, 1.0f);

Vector2 AfterStatic(float e, const Vector2& v0, const Vector2& n = g_vUp) {
  Vector2 p = Vector2::Zero(), v = v0;
  RespondStatic(n, 0.0f, e, p, v);
  return v;
}

TEST(StaticResponse, MirrorsTheNormalPartTimesTheElasticity) {
  const auto naive = [](float e, const Vector2& v) { return Vector2(-e * v); }; // the whole velocity flipped
  EXPECT_EQ(naive(1.0f, {3.0f, -4.0f}), Vector2(-3.0f, 4.0f));
  EXPECT_EQ(AfterStatic(1.0f, {3.0f, -4.0f}), Vector2(3.0f, 4.0f));
  EXPECT_EQ(AfterStatic(0.0f, {3.0f, -4.0f}), Vector2(3.0f, 0.0f));
  EXPECT_EQ(AfterStatic(2.0f, {3.0f, -4.0f}), Vector2(3.0f, 8.0f));
  EXPECT_EQ(AfterStatic(0.5f * 0.5f, {3.0f, -4.0f}), Vector2(3.0f, 1.0f));
}

TEST(StaticResponse, LeavesASeparatingBallItsVelocity) {
  Vector2 p(0.0f, 0.48f), v(1.0f, 2.0f);
  RespondStatic(g_vUp, 0.02f, 1.0f, p, v);
  EXPECT_EQ(v, Vector2(1.0f, 2.0f));
  EXPECT_EQ(p, Vector2(0.0f, 0.48f + 0.02f));
}

TEST(StaticResponse, NeverAddsEnergyUpToElasticityOne) {
  CRandom random(101);
  for (int i = 0; i < 100000; ++i) {
    const Vector2 v0 = random.Vector(-20, 20);
    const Vector2 n = Normalize(random.Direction());
    const float e = i % 3 == 0 ? 1.0f : random.Uniform(0.0f, 1.0f);
    const Vector2 v = AfterStatic(e, v0, n);
    // n is a unit vector within 2 ulp, the dot product and the sum round once or twice each.
    ASSERT_LE(Wide(v).squaredNorm(), Wide(v0).squaredNorm() * (1 + 16 * g_fUlp))
        << "seed " << random.GetSeed();
    const double vn = Wide(v0).dot(Wide(n));
    const Vector2d exact = Wide(v0) - (vn < 0.0 ? (1.0 + e) * vn : 0.0) * Wide(n);
    ASSERT_LE((Wide(v) - exact).norm(), 8 * g_fUlp * Wide(v0).norm()) << "seed " << random.GetSeed();
    // The tangential part is kept.
    const Vector2d t(-static_cast<double>(n.y()), static_cast<double>(n.x()));
    ASSERT_NEAR(Wide(v).dot(t), Wide(v0).dot(t), 8 * g_fUlp * Wide(v0).norm());
  }
  EXPECT_GT(AfterStatic(1.1f, {3.0f, -4.0f}).norm(), 5.0f); // above 1 it does
}

float AfterKinematic(float e, float V, float vn) {
  Vector2 p = Vector2::Zero(), v(0.0f, vn);
  RespondKinematic(g_vUp, 0.0f, e, {0.0f, V}, p, v);
  return v.y();
}

TEST(KinematicResponse, IsTheStaticOneInTheFrameOfTheSurface) {
  // First as if at rest, then e times the surface's velocity relative to the ball: before the bounce, or
  // after.
  const auto naiveBefore = [](float e, float V, float vn) { return -e * vn + e * (V - vn); };
  const auto naiveAfter = [](float e, float V, float vn) { return -e * vn + e * (V + e * vn); };
  EXPECT_EQ(naiveBefore(1.0f, 0.0f, -1.0f), 2.0f);
  EXPECT_EQ(naiveAfter(1.0f, 0.0f, -1.0f), 0.0f);
  EXPECT_EQ(AfterKinematic(1.0f, 0.0f, -1.0f), 1.0f); // a surface at rest: as static

  EXPECT_EQ(AfterKinematic(1.0f, 2.0f, -1.0f), 5.0f);
  EXPECT_EQ(AfterKinematic(1.0f, 2.0f, 1.0f), 3.0f);    // caught up with
  EXPECT_EQ(AfterKinematic(1.0f, -2.0f, -1.0f), -1.0f); // it runs away faster than the ball comes
  EXPECT_NEAR(AfterKinematic(0.5f, g_fPi, 0.0f), 4.71238898, 4 * g_fUlp * 4);
}

TEST(KinematicResponse, RelativeSpeedIsMirroredTimesTheElasticity) {
  CRandom random(102);
  for (int i = 0; i < 20000; ++i) {
    const Vector2 v0 = random.Vector(-4, 4), V = random.Vector(-4, 4);
    const Vector2 n = random.Direction();
    const float e = random.Uniform(0.0f, 2.0f);
    Vector2 p = Vector2::Zero(), v = v0;
    RespondKinematic(n, 0.0f, e, V, p, v);
    const double before = (Wide(v0) - Wide(V)).dot(Wide(n)), after = (Wide(v) - Wide(V)).dot(Wide(n));
    ASSERT_NEAR(after, before < 0.0 ? -e * before : before, 24 * g_fUlp * (Wide(v0).norm() + Wide(V).norm()))
        << "seed " << random.GetSeed();
  }
}

TEST(KinematicResponse, OfASurfaceFasterThanAnyBallStaysFinite) {
  // With the largest elasticities. Infinity times the component of n that is 0 would not be a number.
  const float e = g_fMaxElasticity * g_fMaxElasticity;
  for (const float V : {1e18f, 1e25f, 1e30f, 1e38f}) {
    Vector2 p = Vector2::Zero(), v(3, -4);
    RespondKinematic<Vector2>(Vector2(0, 1), 0.0f, e, Vector2(0, V), p, v);
    EXPECT_EQ(v.x(), 3.0f) << V;
    EXPECT_GT(v.y(), g_fMaxSpeed) << V;
    EXPECT_TRUE(std::isfinite(v.y())) << V;
  }
}

TEST(DynamicResponse, KeepsMomentumAndAddsNoEnergy) {
  CRandom random(103);
  for (int i = 0; i < 100000; ++i) {
    const float m0 = random.Scale(-20, 20), m1 = i % 4 ? random.Scale(-20, 20) : m0;
    const Vector2 w0 = random.Vector(-6, 6), w1 = random.Vector(-6, 6);
    const Vector2 n = random.Direction();
    const float e = i % 3 ? random.Uniform(0.0f, 1.0f) : 1.0f;
    Vector2 p0 = Vector2::Zero(), p1 = Vector2::Zero(), v0 = w0, v1 = w1;
    RespondDynamic(n, 0.0f, e, m0, m1, p0, v0, p1, v1);
    const double M0 = m0, M1 = m1;
    const Vector2d before = M0 * Wide(w0) + M1 * Wide(w1), after = M0 * Wide(v0) + M1 * Wide(v1);
    // Each share and each product is rounded; each ball's velocity once more.
    const double size =
        M0 * Wide(v0).norm() + M1 * Wide(v1).norm() + M0 * Wide(w0).norm() + M1 * Wide(w1).norm();
    ASSERT_LE((after - before).norm(), 4 * g_fUlp * size) << "seed " << random.GetSeed();
    const auto energy = [&](const Vector2& a, const Vector2& b) {
      return M0 * Wide(a).squaredNorm() + M1 * Wide(b).squaredNorm();
    };
    ASSERT_LE(energy(v0, v1), energy(w0, w1) * (1 + 16 * g_fUlp)) << "seed " << random.GetSeed();
    const double wn = (Wide(w1) - Wide(w0)).dot(Wide(n)), vn = (Wide(v1) - Wide(v0)).dot(Wide(n));
    const double speeds = Wide(w0).norm() + Wide(w1).norm();
    ASSERT_NEAR(vn, wn < 0.0 ? -e * wn : wn, 16 * g_fUlp * speeds) << "seed " << random.GetSeed();
  }
}

TEST(DynamicResponse, OfExtremeMassesIsRight) {
  Vector2 p0 = Vector2::Zero(), p1 = Vector2::Zero();
  // A heavy ball of speed 1 meets a light one at rest.
  Vector2 v0(0.0f, 0.0f), v1(0.0f, -1.0f);
  RespondDynamic(g_vUp, 0.0f, 1.0f, 1e-12f, 1.0f, p0, v0, p1, v1);
  EXPECT_NEAR(v0.y(), -1.999999999998, 4 * g_fUlp);
  EXPECT_NEAR(v1.y(), -1.0, 4 * g_fUlp);

  // Their product is not a float.
  EXPECT_TRUE(std::isinf(1e30f * 1e30f));
  v0 = {0.0f, 0.0f};
  v1 = {0.0f, -1.0f};
  RespondDynamic(g_vUp, 0.0f, 1.0f, 1e30f, 1e30f, p0, v0, p1, v1);
  EXPECT_NEAR(v0.y(), -1.0, 4 * g_fUlp);
  EXPECT_NEAR(v1.y(), 0.0, 4 * g_fUlp);

  v0 = {0.0f, 0.0f};
  v1 = {0.0f, -1.0f};
  RespondDynamic(g_vUp, 0.0f, 1.0f, g_fMaxMass, g_fMaxMass, p0, v0, p1, v1);
  EXPECT_EQ(v0.y(), -1.0f);
}

TEST(DynamicResponse, SharesTheSetbackByTheOtherMass) {
  Vector2 p0 = Vector2::Zero(), p1 = Vector2::Zero(), v0 = Vector2::Zero(), v1 = Vector2::Zero();
  RespondDynamic(g_vUp, 1.0f, 1.0f, 1.0f, 3.0f, p0, v0, p1, v1);
  EXPECT_EQ(p0, Vector2(0.0f, -0.75f));
  EXPECT_EQ(p1, Vector2(0.0f, 0.25f));
  EXPECT_EQ(1.0f * p0.y() + 3.0f * p1.y(), 0.0f); // the centre of mass stays
  EXPECT_EQ(v0, Vector2::Zero());
  EXPECT_EQ(v1, Vector2::Zero());
}

TEST(Accelerate, AndThenMoveIsSemiImplicit) {
  Vector2 p(1.0f, 2.0f), v(4.0f, 0.0f);
  Accelerate(v, {0.0f, -8.0f}, 0.5f);
  Move(p, v, 0.5f);
  EXPECT_EQ(v, Vector2(4.0f, -4.0f));
  EXPECT_EQ(p, Vector2(3.0f, 0.0f));
}

TEST(ApproachSpeed, IsRelativeToTheSurfaceAndNeverNegative) {
  EXPECT_EQ(ApproachSpeed({3.0f, -4.0f}, {0.0f, 0.0f}, g_vUp), 4.0f);
  EXPECT_EQ(ApproachSpeed({3.0f, -4.0f}, {7.0f, 2.0f}, g_vUp), 6.0f);
  EXPECT_EQ(ApproachSpeed({3.0f, 4.0f}, {0.0f, 0.0f}, g_vUp), 0.0f);
}

TEST(CapSpeed, CutsToTheLimitAndKeepsTheDirection) {
  Vector2 v(3.0f, 4.0f);
  EXPECT_FALSE(CapSpeed(v));
  EXPECT_EQ(v, Vector2(3.0f, 4.0f));
  v = {3e30f, -4e30f};
  EXPECT_TRUE(CapSpeed(v));
  EXPECT_LE((v / g_fMaxSpeed - Vector2(0.6f, -0.8f)).norm(), 2 * g_fUlp);
}

} // namespace
} // namespace Shapes
