// SPDX-License-Identifier: MIT
#include "KernelTesting.h"

namespace Shapes::Native {
namespace {

float Degrees(float a) { return a * g_fPi / 180.0f; }
CArc Arc(float r, float a0, float a1, eSides sides = eSides::Both, const Vector2& p = Vector2::Zero()) {
  CArcDesc desc(p, r, a0, a1);
  desc.m_eSides = sides;
  return CArc(desc);
}

TEST(CollideCircleArc, MeetsBothSidesInItsSector) {
  const CArc arc = Arc(1.0f, Degrees(350), Degrees(10));
  CHit hit;
  ASSERT_TRUE(CollideCircleArc(arc, Ball({1.05f, 0.0f}, 0.1f, {-1.0f, 0.0f}), hit));
  EXPECT_EQ(hit.m_vPOI, Vector2(1.0f, 0.0f));
  EXPECT_EQ(hit.m_vNorm, Vector2(1.0f, 0.0f));
  EXPECT_NEAR(hit.m_fSetback, 0.05, 4 * g_fUlp);
  ASSERT_TRUE(CollideCircleArc(arc, Ball({0.95f, 0.0f}, 0.1f, {1.0f, 0.0f}), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(-1.0f, 0.0f));
  EXPECT_NEAR(hit.m_fSetback, 0.05, 4 * g_fUlp);
  EXPECT_FALSE(CollideCircleArc(arc, Ball({1.1f, 0.0f}, 0.1f), hit));
  EXPECT_FALSE(CollideCircleArc(arc, Ball({-1.05f, 0.0f}, 0.1f), hit)); // out of the sector
}

TEST(CollideCircleArc, EqualAnglesAreAFullCircleFromEveryDirection) {
  const CArc arc = Arc(1.0f, 0.0f, 0.0f);
  for (int k = 0; k < 360; ++k) {
    const Vector2 u = AngleToVector(Degrees(static_cast<float>(k)));
    CHit hit;
    ASSERT_TRUE(CollideCircleArc(arc, Ball(1.09f * u, 0.1f, -u), hit)) << k;
    EXPECT_LE((hit.m_vNorm - u).norm(), 4 * g_fUlp);
    EXPECT_FALSE(CollideCircleArc(arc, Ball(1.11f * u, 0.1f, -u), hit)) << k;
    ASSERT_TRUE(CollideCircleArc(arc, Ball(0.91f * u, 0.1f, u), hit)) << k;
    EXPECT_LE((hit.m_vNorm + u).norm(), 4 * g_fUlp);
  }
}

TEST(CollideCircleArc, ShortArcsAreMet) {
  CHit hit;
  EXPECT_TRUE(CollideCircleArc(Arc(1.0f, 0.0f, 1e-7f), Ball({1.09f, 0.0f}, 0.1f, {-1.0f, 0.0f}), hit));
}

TEST(CollideCircleArc, AShortArcIsNotMetOppositeToIt) {
  CHit hit;
  EXPECT_FALSE(CollideCircleArc(Arc(1.0f, 0.0f, 1e-5f, eSides::Both, {1000.0f, 1000.0f}),
                                Ball({998.95f, 1000.0f}, 0.1f, {1.0f, 0.0f}), hit));
}

TEST(CollideCircleArc, ABallFarInsideIsFree) {
  CHit hit;
  EXPECT_FALSE(CollideCircleArc(Arc(2.0f, 0.0f, 0.0f), Ball({0.0f, 0.0f}, 0.5f), hit));
}

TEST(CollideCircleArc, ABallThatDoesNotFitInsideDoesNotTouchTheInside) {
  CHit hit;
  EXPECT_FALSE(CollideCircleArc(Arc(1.0f, 0.0f, 0.0f), Ball({0.0f, 0.0f}, 1.0f, {1.0f, 0.0f}), hit));
  EXPECT_FALSE(CollideCircleArc(Arc(1.0f, 0.0f, 0.0f), Ball({0.3f, 0.2f}, 1.5f, {1.0f, 0.0f}), hit));
}

TEST(CollideCircleArc, LetsGoOfABallInsideThatLeavesPastAnEnd) {
  // Quarter from 0 to 90 degrees; the tangent at the right end points up, at the top end to the right.
  const CArc arc = Arc(1.0f, 0.0f, Degrees(90));
  CHit hit;
  const Vector2 nearRight(0.9f, 0.05f), nearTop(0.05f, 0.9f), middle(0.65f, 0.65f);
  EXPECT_FALSE(CollideCircleArc(arc, Ball(nearRight, 0.2f, {1.0f, -2.0f}), hit)); // down, off the arc
  EXPECT_TRUE(CollideCircleArc(arc, Ball(nearRight, 0.2f, {1.0f, 2.0f}), hit));   // up, along it
  EXPECT_FALSE(CollideCircleArc(arc, Ball(nearTop, 0.2f, {-2.0f, 1.0f}), hit));
  EXPECT_TRUE(CollideCircleArc(arc, Ball(nearTop, 0.2f, {2.0f, 1.0f}), hit));
  // Up to 45 degrees from straight out it comes at the arc; beyond that it leaves.
  EXPECT_TRUE(CollideCircleArc(arc, Ball(nearRight, 0.2f, {1.0f, 0.0f}), hit));
  EXPECT_TRUE(CollideCircleArc(arc, Ball(nearRight, 0.2f, {2.0f, -1.0f}), hit));
  EXPECT_TRUE(CollideCircleArc(arc, Ball(nearTop, 0.2f, {-1.0f, 2.0f}), hit));
  EXPECT_FALSE(CollideCircleArc(arc, Ball(nearRight, 0.2f, {1.0f, -1.01f}), hit));
  EXPECT_FALSE(CollideCircleArc(arc, Ball(nearTop, 0.2f, {-1.01f, 1.0f}), hit));
  EXPECT_FALSE(CollideCircleArc(arc, Ball(nearRight, 0.2f, {-1.0f, -0.1f}), hit)); // inward and off it
  // Away from the ends the direction does not matter, and outside it never does.
  EXPECT_TRUE(CollideCircleArc(arc, Ball(middle, 0.2f, {1.0f, -2.0f}), hit));
  EXPECT_TRUE(CollideCircleArc(arc, Ball({1.1f, 0.05f}, 0.2f, {-1.0f, -2.0f}), hit));
  // A full circle has no ends.
  EXPECT_TRUE(CollideCircleArc(Arc(1.0f, 0.0f, 0.0f), Ball(nearRight, 0.2f, {1.0f, -2.0f}), hit));
}

TEST(CollideCircleArc, LetsGoByTheVelocityRelativeToTheSurface) {
  CArcDesc desc({0.0f, 0.0f}, 1.0f, 0.0f, Degrees(90));
  desc.m_fRotSpeed = 1.0f; // its end 0 moves up at 2 pi
  const CKinematicArc arc(desc);
  CHit hit;
  EXPECT_FALSE(CollideCircleArc(arc, Ball({0.9f, 0.05f}, 0.2f, {1.0f, 2.0f}), hit));
  EXPECT_TRUE(CollideCircleArc(arc, Ball({0.9f, 0.05f}, 0.2f, {1.0f, 7.0f}), hit));
}

TEST(CollideCircleArc, OneSidedArcsLetTheOtherSideThrough) {
  const CBall in{{1.05f, 0.0f}, {1.3f, 0.0f}, {-5.0f, 0.0f}, 0.1f};
  const CBall out{{0.95f, 0.0f}, {0.7f, 0.0f}, {5.0f, 0.0f}, 0.1f};
  const float a0 = Degrees(300), a1 = Degrees(60);
  CHit hit;
  ASSERT_TRUE(CollideCircleArc(Arc(1.0f, a0, a1, eSides::Front), in, hit)); // the front is the outside
  EXPECT_EQ(hit.m_vNorm, Vector2(1.0f, 0.0f));
  EXPECT_FALSE(CollideCircleArc(Arc(1.0f, a0, a1, eSides::Front), out, hit));
  ASSERT_TRUE(CollideCircleArc(Arc(1.0f, a0, a1, eSides::Back), out, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(-1.0f, 0.0f));
  EXPECT_FALSE(CollideCircleArc(Arc(1.0f, a0, a1, eSides::Back), in, hit));
}

TEST(CollideCircleArc, ACentreOnTheArcGoesBackToTheSideItCameFrom) {
  CHit hit;
  const CArc arc = Arc(1.0f, Degrees(300), Degrees(60));
  ASSERT_TRUE(CollideCircleArc(arc, {{1.0f, 0.0f}, {1.2f, 0.0f}, {-3.0f, 0.0f}, 0.1f}, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(1.0f, 0.0f));
  ASSERT_TRUE(CollideCircleArc(arc, {{1.0f, 0.0f}, {0.8f, 0.0f}, {3.0f, 0.0f}, 0.1f}, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(-1.0f, 0.0f));
}

TEST(CollideCircleArc, NanInPositionOrRadiusIsNoContact) {
  const CWithoutTraps onPurpose;
  CHit hit;
  for (const float a1 : {0.0f, 1.0f}) {
    EXPECT_FALSE(CollideCircleArc(Arc(1.0f, 0.0f, a1), Ball({g_fNan, 0.1f}, 0.5f), hit));
    EXPECT_FALSE(CollideCircleArc(Arc(1.0f, 0.0f, a1), Ball({0.9f, g_fNan}, 0.5f), hit));
    EXPECT_FALSE(CollideCircleArc(Arc(1.0f, 0.0f, a1), Ball({0.9f, 0.1f}, g_fNan), hit));
  }
}

TEST(CollideCircleArc, SetsBackToTouchingWithAUnitNormal) {
  CRandom random(221);
  int outside = 0, inside = 0;
  for (int i = 0; i < 50000; ++i) {
    const Vector2 c = random.Vector(-4, 8);
    const float a0 = random.Uniform(0.0f, 6.28f), a1 = random.Uniform(0.0f, 6.28f);
    const CArc arc = Arc(random.Scale(-4, 6), a0, a1, eSides::Both, c);
    const double R = arc.GetRadius();
    const float r = arc.GetRadius() * random.Scale(-8, -2);
    const float d0 = arc.GetRadius() + r * random.Uniform(-1.2f, 1.2f);
    const Vector2 p =
        arc.GetPos() + d0 * AngleToVector(arc.GetAngle0() + arc.GetSpan() * random.Uniform(0.0f, 1.0f));
    const CBall ball = Ball(p, r, random.Direction());
    const double d = (Wide(p) - Wide(arc.GetPos())).norm();
    const double bound = 8 * g_fUlp * (Wide(arc.GetPos()).norm() + 2 * R);
    CHit hit;
    if (!CollideCircleArc(arc, ball, hit)) continue;
    ++(d < R ? inside : outside);
    ASSERT_NEAR(Wide(hit.m_vNorm).norm(), 1.0, 2 * g_fUlp) << "seed " << random.GetSeed();
    ASSERT_GE(hit.m_fSetback, 0.0f);
    ASSERT_NEAR(hit.m_fSetback, static_cast<double>(r) - std::abs(d - R), bound)
        << "seed " << random.GetSeed();
    ASSERT_NEAR((Wide(hit.m_vPOI) - Wide(arc.GetPos())).norm(), R, bound);
    CBall back = ball;
    back.m_vPos += hit.m_fSetback * hit.m_vNorm;
    if (CollideCircleArc(arc, back, hit)) {
      ASSERT_LE(hit.m_fSetback, bound) << "seed " << random.GetSeed();
    }
  }
  EXPECT_GT(outside, 5000);
  EXPECT_GT(inside, 5000);
}

} // namespace
} // namespace Shapes::Native
