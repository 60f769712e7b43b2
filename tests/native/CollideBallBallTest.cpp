// SPDX-License-Identifier: MIT
#include "KernelTesting.h"

namespace Shapes::Native {
namespace {

CBall RandomBall(CRandom& random) {
  const Vector2 p = random.InSquare(2.0f);
  const float r = random.Uniform(0.1f, 1.0f);
  return Ball(p, r, random.Direction());
}

TEST(CollideBallBall, NormalPointsToTheSecond) {
  CHit hit;
  ASSERT_TRUE(CollideBallBall(Ball({0.0f, 0.0f}, 1.0f), Ball({0.0f, 1.75f}, 1.0f), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
  EXPECT_EQ(hit.m_vPOI, Vector2(0.0f, 1.0f));
  EXPECT_EQ(hit.m_fSetback, 0.25f);
  EXPECT_FALSE(CollideBallBall(Ball({0.0f, 0.0f}, 1.0f), Ball({0.0f, 2.0f}, 1.0f), hit));
}

TEST(CollideBallBall, BallsAreSolid) {
  CHit hit; // a small one deep in a large one goes out, not in
  ASSERT_TRUE(CollideBallBall(Ball({0.0f, 0.0f}, 5.0f), Ball({3.0f, 0.0f}, 0.1f), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(1.0f, 0.0f));
  EXPECT_NEAR(hit.m_fSetback, 2.1, 8 * g_fUlp);
}

TEST(CollideBallBall, CoincidentCentresSeparateAgainstTheirRelativeVelocity) {
  CHit hit;
  ASSERT_TRUE(
      CollideBallBall(Ball({1.0f, 1.0f}, 0.5f, {3.0f, 0.0f}), Ball({1.0f, 1.0f}, 0.5f, {1.0f, 0.0f}), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(1.0f, 0.0f));
  EXPECT_EQ(hit.m_fSetback, 1.0f);
  ASSERT_TRUE(CollideBallBall(Ball({1.0f, 1.0f}, 0.5f), Ball({1.0f, 1.0f}, 0.5f), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f)); // at rest: a fixed axis
}

TEST(CollideBallBall, NanInPositionOrRadiusIsNoContact) {
  const CWithoutTraps onPurpose;
  CHit hit;
  const CBall good = Ball({0.0f, 0.0f}, 1.0f);
  for (const CBall& bad :
       {Ball({g_fNan, 0.0f}, 1.0f), Ball({0.0f, g_fNan}, 1.0f), Ball({0.0f, 0.5f}, g_fNan)}) {
    EXPECT_FALSE(CollideBallBall(good, bad, hit));
    EXPECT_FALSE(CollideBallBall(bad, good, hit));
  }
}

TEST(CollideBallBall, SwappingTheBallsTurnsTheNormalRound) {
  CRandom random(231);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const CBall a = RandomBall(random), b = RandomBall(random);

    CHit ab, ba;
    const bool got = CollideBallBall(a, b, ab);
    ASSERT_EQ(CollideBallBall(b, a, ba), got) << "seed " << random.GetSeed();
    if (!got) continue;
    ++hits;
    ASSERT_EQ(ab.m_vNorm, -ba.m_vNorm);
    ASSERT_EQ(ab.m_fSetback, ba.m_fSetback);
  }
  EXPECT_GT(hits, 2000);
}

TEST(CollideBallBall, AgreesWithTheDistanceAndSetsBackToTouching) {
  CRandom random(232);
  int hits = 0;
  for (int i = 0; i < 50000; ++i) {
    const Vector2 pa = random.Vector(-6, 8);
    const CBall a = Ball(pa, random.Scale(-8, 6));
    const float rb = random.Scale(-8, 6);
    CBall b = Ball(a.m_vPos, rb, random.Direction());
    const float reach = a.m_fRadius + b.m_fRadius;
    b.m_vPos += reach * random.VectorOfLength(0.0f, 1.5f);
    const double d = (Wide(b.m_vPos) - Wide(a.m_vPos)).norm(), R = reach;
    const double bound = 4 * g_fUlp * (Wide(a.m_vPos).norm() + Wide(b.m_vPos).norm() + R);
    CHit hit;
    const bool got = CollideBallBall(a, b, hit);
    if (std::abs(d - R) > bound) {
      ASSERT_EQ(got, d < R) << "seed " << random.GetSeed();
    }
    if (!got) continue;
    ++hits;
    ASSERT_NEAR(Wide(hit.m_vNorm).norm(), 1.0, 2 * g_fUlp) << "seed " << random.GetSeed();
    ASSERT_GE(hit.m_fSetback, 0.0f);
    ASSERT_NEAR(hit.m_fSetback, R - d, bound) << "seed " << random.GetSeed();
    CBall back = b;
    back.m_vPos += hit.m_fSetback * hit.m_vNorm;
    if (CollideBallBall(a, back, hit)) {
      ASSERT_LE(hit.m_fSetback, bound) << "seed " << random.GetSeed();
    }
  }
  EXPECT_GT(hits, 20000);
}

} // namespace
} // namespace Shapes::Native
