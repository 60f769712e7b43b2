// SPDX-License-Identifier: MIT
#include "KernelTesting.h"

namespace Shapes::Native {
namespace {

CCircle Circle(const Vector2& p, float r) { return CCircle(CCircleDesc(p, r)); }

TEST(CollideCircleCircle, MeetsABallOutside) {
  CHit hit;
  ASSERT_TRUE(CollideCircleCircle(Circle({0.0f, 0.0f}, 1.0f), Ball({1.4f, 0.0f}, 0.5f), hit));
  EXPECT_EQ(hit.m_vPOI, Vector2(1.0f, 0.0f));
  EXPECT_EQ(hit.m_vNorm, Vector2(1.0f, 0.0f));
  EXPECT_NEAR(hit.m_fSetback, 0.1, 4 * g_fUlp);
  EXPECT_FALSE(CollideCircleCircle(Circle({0.0f, 0.0f}, 1.0f), Ball({1.5f, 0.0f}, 0.5f), hit));
}

TEST(CollideCircleCircle, ABallInsideBouncesOffTheInside) {
  CHit hit;
  ASSERT_TRUE(CollideCircleCircle(Circle({0.0f, 0.0f}, 2.0f), Ball({1.6f, 0.0f}, 0.5f), hit));
  EXPECT_EQ(hit.m_vPOI, Vector2(2.0f, 0.0f));
  EXPECT_EQ(hit.m_vNorm, Vector2(-1.0f, 0.0f));
  EXPECT_NEAR(hit.m_fSetback, 0.1, 4 * g_fUlp);
  EXPECT_FALSE(CollideCircleCircle(Circle({0.0f, 0.0f}, 5.0f), Ball({3.0f, 0.0f}, 0.1f), hit)); // free inside
  EXPECT_FALSE(
      CollideCircleCircle(Circle({0.0f, 0.0f}, 2.0f), Ball({0.0f, 0.0f}, 0.5f), hit)); // at its centre
}

TEST(CollideCircleCircle, ACentreExactlyOnTheRingIsOnTheSideFromWhichItCame) {
  const CCircle ring = Circle({0.0f, 0.0f}, 1.0f);
  CHit hit;
  const CBall outward{{1.0f, 0.0f}, {0.75f, 0.0f}, {1.0f, 0.0f}, 0.5f};
  ASSERT_TRUE(CollideCircleCircle(ring, outward, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(-1.0f, 0.0f));
  EXPECT_EQ(hit.m_fSetback, 0.5f);
  const CBall inward{{1.0f, 0.0f}, {1.25f, 0.0f}, {-1.0f, 0.0f}, 0.5f};
  ASSERT_TRUE(CollideCircleCircle(ring, inward, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(1.0f, 0.0f));
  // Placed there: by its velocity.
  ASSERT_TRUE(CollideCircleCircle(ring, Ball({1.0f, 0.0f}, 0.5f, {1.0f, 0.0f}), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(-1.0f, 0.0f));
  ASSERT_TRUE(CollideCircleCircle(ring, Ball({1.0f, 0.0f}, 0.5f, {-1.0f, 0.0f}), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(1.0f, 0.0f));
}

TEST(CollideCircleCircle, PoiIsOnTheCircleThatIsMet) {
  // The closest point of the ball to the centre of the circle is r from the ball's own centre: as a point
  // that a ball of radius r has to overlap, it is never met.
  CRandom random(211);
  int hits = 0, naiveHits = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vector2 c = random.InSquare(2.0f), p = random.InSquare(2.0f);
    const CCircle circle = Circle(c, random.Uniform(0.5f, 2.0f));
    const CBall ball = Ball(p, random.Uniform(0.1f, 1.0f));
    CHit hit, naive;
    const CCircle ballShape = Circle(ball.m_vPos, ball.m_fRadius);
    const bool got = CollideCircleCircle(circle, ball, hit);
    if (!got) continue;
    ++hits;
    naiveHits += CollidePt(ballShape.ClosestPt(circle.GetPos()), ball, naive) &&
                 naive.m_fSetback > 8 * g_fUlp * static_cast<double>(ball.m_vPos.norm() + ball.m_fRadius);
    ASSERT_NEAR((Wide(hit.m_vPOI) - Wide(circle.GetPos())).norm(), circle.GetRadius(), 8 * g_fUlp * 4)
        << "seed " << random.GetSeed();
  }
  EXPECT_GT(hits, 1000);
  EXPECT_EQ(naiveHits, 0);
}

TEST(CollideCircleCircle, ABallThatDoesNotFitInsideIsOutside) {
  CHit hit;
  ASSERT_TRUE(CollideCircleCircle(Circle({0.0f, 0.0f}, 1.0f), Ball({0.5f, 0.0f}, 1.5f), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(1.0f, 0.0f));
  EXPECT_EQ(hit.m_fSetback, 2.0f);
  ASSERT_TRUE(CollideCircleCircle(Circle({0.0f, 0.0f}, 1.0f), Ball({0.0f, 0.0f}, 1.0f, {0.0f, 3.0f}), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, -1.0f)); // against its velocity
}

TEST(CollideCircleCircle, OneWithoutExtentIsAPoint) {
  CHit hit;
  ASSERT_TRUE(CollideCircleCircle(Circle({0.0f, 0.0f}, 0.0f), Ball({0.0f, 0.4f}, 0.5f), hit));
  EXPECT_EQ(hit.m_vPOI, Vector2(0.0f, 0.0f));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
  EXPECT_NEAR(hit.m_fSetback, 0.1, 4 * g_fUlp);
  ASSERT_TRUE(CollideCircleCircle(Circle({0.0f, 0.0f}, 0.0f), Ball({0.0f, 0.0f}, 0.5f), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
}

TEST(CollideCircleCircle, NanInPositionOrRadiusIsNoContact) {
  const CWithoutTraps onPurpose;
  CHit hit;
  EXPECT_FALSE(CollideCircleCircle(Circle({0.0f, 0.0f}, 1.0f), Ball({g_fNan, 0.0f}, 0.5f), hit));
  EXPECT_FALSE(CollideCircleCircle(Circle({0.0f, 0.0f}, 1.0f), Ball({1.0f, 0.0f}, g_fNan), hit));
}

TEST(CollideCircleCircle, AgreesWithTheGapAndSetsBackToTouching) {
  CRandom random(212);
  int outside = 0, inside = 0;
  for (int i = 0; i < 50000; ++i) {
    const Vector2 c = random.Vector(-4, 8);
    const CCircle circle = Circle(c, random.Scale(-6, 6));
    const double R = circle.GetRadius();
    const float r = random.Scale(-6, 6);
    const float d0 = std::max(0.0f, circle.GetRadius() + r * random.Uniform(-1.5f, 1.5f));
    const Vector2 p = c + d0 * random.Direction();
    const CBall ball = Ball(p, r, random.Direction());
    const double d = (Wide(ball.m_vPos) - Wide(circle.GetPos())).norm();
    const double bound = 8 * g_fUlp * (Wide(circle.GetPos()).norm() + R + static_cast<double>(r) + d);
    const double gap = (r < circle.GetRadius() ? std::abs(d - R) : d - R) - static_cast<double>(r);
    CHit hit;
    const bool got = CollideCircleCircle(circle, ball, hit);
    if (std::abs(gap) > bound) {
      ASSERT_EQ(got, gap < 0.0) << "seed " << random.GetSeed();
    }
    if (!got) continue;
    ++(d < R ? inside : outside);
    ASSERT_NEAR(Wide(hit.m_vNorm).norm(), 1.0, 2 * g_fUlp) << "seed " << random.GetSeed();
    ASSERT_GE(hit.m_fSetback, 0.0f);
    ASSERT_NEAR(hit.m_fSetback, -gap, bound) << "seed " << random.GetSeed();
    CBall back = ball;
    back.m_vPos += hit.m_fSetback * hit.m_vNorm;
    if (CollideCircleCircle(circle, back, hit)) {
      ASSERT_LE(hit.m_fSetback, bound)
          << "seed " << random.GetSeed() << " R " << R << " r " << r << " d " << d;
    }
  }
  EXPECT_GT(outside, 5000);
  EXPECT_GT(inside, 2000);
}

} // namespace
} // namespace Shapes::Native
