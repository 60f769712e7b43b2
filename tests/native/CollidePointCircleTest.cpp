// SPDX-License-Identifier: MIT
#include "KernelTesting.h"

namespace Shapes::Native {
namespace {

TEST(CollidePointCircle, GivesPoiNormalAndSetback) {
  CHit hit;
  ASSERT_TRUE(CollidePointCircle(CPoint(CPointDesc({1.0f, 1.0f})), Ball({1.0f, 1.4f}, 0.5f), hit));
  EXPECT_EQ(hit.m_vPOI, Vector2(1.0f, 1.0f));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
  EXPECT_NEAR(hit.m_fSetback, 0.1, 4 * g_fUlp);
}

TEST(CollidePointCircle, TouchingIsNoContact) {
  CHit hit;
  EXPECT_FALSE(CollidePt({0.0f, 0.0f}, Ball({3.0f, 4.0f}, 5.0f), hit));
  EXPECT_TRUE(CollidePt({0.0f, 0.0f}, Ball({3.0f, 4.0f}, std::nextafter(5.0f, 6.0f)), hit));
}

TEST(CollidePointCircle, ABallWithoutExtentMeetsNothing) {
  CHit hit;
  EXPECT_FALSE(CollidePt({0.0f, 0.0f}, Ball({0.0f, 0.0f}, 0.0f), hit));
}

TEST(CollidePointCircle, ACentreOnThePointGoesBackWhereItCameFrom) {
  const Vector2 p(0.0f, 0.0f);
  EXPECT_FALSE((p / p.norm()).allFinite()); // dividing by the distance
  CHit hit;
  ASSERT_TRUE(CollidePt({0.0f, 0.0f}, Ball({0.0f, 0.0f}, 0.5f, {1.0f, 0.0f}), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(-1.0f, 0.0f));
  EXPECT_EQ(hit.m_fSetback, 0.5f);
  ASSERT_TRUE(CollidePt({0.0f, 0.0f}, Ball({0.0f, 0.0f}, 0.5f), hit)); // at rest: up
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
}

TEST(CollidePointCircle, RadiiWhoseSquaresUnderflowAreRight) {
  EXPECT_EQ(1e-23f * 1e-23f, 0.0f);
  CHit hit;
  ASSERT_TRUE(CollidePt({0.0f, 0.0f}, Ball({0.0f, 5e-24f}, 1e-23f), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
  EXPECT_NEAR(hit.m_fSetback / 5e-24f, 1.0, 4 * g_fUlp);
}

TEST(CollidePointCircle, NanInPositionOrRadiusIsNoContact) {
  const CWithoutTraps onPurpose;
  // The condition for a miss, as d >= r, lets NaN through.
  const float d = g_fNan, r = 1.0f;
  EXPECT_FALSE(d >= r);
  CHit hit;
  EXPECT_FALSE(CollidePt({0.0f, 0.0f}, Ball({g_fNan, 0.0f}, 1.0f), hit));
  EXPECT_FALSE(CollidePt({0.0f, 0.0f}, Ball({0.0f, g_fNan}, 1.0f), hit));
  EXPECT_FALSE(CollidePt({0.0f, 0.0f}, Ball({0.0f, 0.5f}, g_fNan), hit));
  EXPECT_FALSE(CollidePt({g_fNan, 0.0f}, Ball({0.0f, 0.5f}, 1.0f), hit));
}

TEST(CollidePointCircle, NanInTheVelocityNeverReachesTheHit) {
  const CWithoutTraps onPurpose;
  CHit hit;
  if (CollidePt({0.0f, 0.0f}, Ball({0.0f, 0.0f}, 1.0f, {g_fNan, 0.0f}), hit)) {
    EXPECT_TRUE(hit.m_vNorm.allFinite());
  }
}

TEST(CollidePointCircle, AgreesWithTheDistanceAndSetsBackToTouching) {
  CRandom random(201);
  int hits = 0;
  for (int i = 0; i < 50000; ++i) {
    const Vector2 p0 = random.Vector(-6, 10);
    const float r = random.Scale(-6, 6);
    const Vector2 p = p0 + r * random.VectorOfLength(0.0f, 1.5f);
    const CBall ball = Ball(p, r, random.Direction());
    const double d = (Wide(ball.m_vPos) - Wide(p0)).norm();
    const double bound = 4 * g_fUlp * (Wide(p0).norm() + static_cast<double>(r));
    CHit hit;
    const bool got = CollidePt(p0, ball, hit);
    if (std::abs(d - static_cast<double>(r)) > bound) {
      ASSERT_EQ(got, d < static_cast<double>(r)) << random.GetSeed();
    }
    if (!got) continue;
    ++hits;
    ASSERT_NEAR(Wide(hit.m_vNorm).norm(), 1.0, 2 * g_fUlp) << "seed " << random.GetSeed();
    ASSERT_GE(hit.m_fSetback, 0.0f);
    ASSERT_NEAR(hit.m_fSetback, static_cast<double>(r) - d, bound);
    CBall back = ball;
    back.m_vPos += hit.m_fSetback * hit.m_vNorm;
    ASSERT_NEAR((Wide(back.m_vPos) - Wide(p0)).norm(), r, bound) << "seed " << random.GetSeed();
    if (CollidePt(p0, back, hit)) {
      ASSERT_LE(hit.m_fSetback, bound) << "seed " << random.GetSeed();
    }
  }
  EXPECT_GT(hits, 10000);
}

TEST(CollidePointCircle, ScalesByPowersOfTwoWithoutAChangedDigit) {
  CHit a, b;
  const float s = 0x1p-30f;
  ASSERT_TRUE(CollidePt({0.3f, 0.7f}, Ball({0.5f, 0.9f}, 0.4f), a));
  ASSERT_TRUE(CollidePt(s * Vector2(0.3f, 0.7f), Ball(s * Vector2(0.5f, 0.9f), s * 0.4f), b));
  EXPECT_EQ(b.m_vNorm, a.m_vNorm);
  EXPECT_EQ(b.m_fSetback, s * a.m_fSetback);
  EXPECT_EQ(b.m_vPOI, s * a.m_vPOI);
}

TEST(Collide, GoesFromTheTypeToTheKernel) {
  const CBall ball = Ball({0.0f, 0.45f}, 0.5f, {0.0f, -1.0f});
  const CPoint point(CPointDesc({0.0f, 0.0f}));
  const CLineSeg seg(CLineSegDesc({-1.0f, 0.0f}, {1.0f, 0.0f}));
  const CCircle circle(CCircleDesc({0.0f, -1.0f}, 1.0f));
  const CArc arc(CArcDesc({0.0f, -1.0f}, 1.0f, 0.0f, g_fPi));
  for (const CShape* pShape : {static_cast<const CShape*>(&point), static_cast<const CShape*>(&seg),
                               static_cast<const CShape*>(&circle), static_cast<const CShape*>(&arc)}) {
    CHit hit;
    ASSERT_TRUE(Collide(*pShape, ball, hit)) << static_cast<int>(pShape->GetShapeType());
    EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
    EXPECT_NEAR(hit.m_fSetback, 0.05, 4 * g_fUlp);
    EXPECT_LE(hit.m_vPOI.norm(), 4 * g_fUlp);
  }
}

} // namespace
} // namespace Shapes::Native
