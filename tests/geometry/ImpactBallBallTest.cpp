// SPDX-License-Identifier: MIT
#include "Tolerances.h"

#include "ImpactTesting.h"

#include <cmath>

namespace Shapes::Geometry {
namespace {

Compare::CSweptBall<CFifty> Exact(const CMotion& motion, double more = 0.0) {
  return {To<CFifty>(motion.m_vPos), To<CFifty>(motion.m_vVel), CFifty(motion.m_fRadius) + CFifty(more)};
}

// Two balls whose ways graze, meet, or begin touching.
void RandomBalls(CRandom& random, CMotion& other, CMotion& ball) {
  const CTrial trial = RandomTrial(random, eShape::Circle, eSides::Both);
  const Vector2d drift = random.InSquare(3.0f).cast<double>();
  other = {trial.m_cShape.m_vCenter, drift, trial.m_cShape.m_fRadius, 1.0};
  ball = trial.m_cMotion;
  ball.m_vVel += drift;
}

TEST(ImpactBallBall, AgreesWith50Digits) {
  int hits = 0, misses = 0, ambiguous = 0;
  ForEachCase(50, 20000, [&](CRandom& random, int) {
    CMotion other, ball;
    RandomBalls(random, other, ball);
    CImpact impact;
    const bool met = ImpactBallBall(other, ball, impact) == eSweep::Impact;
    Compare::CHit<CFifty> exact;
    const bool metExactly = Compare::SweepBalls<CFifty>(Exact(other), Exact(ball), CFifty(1), exact);
    const Vector2d v = ball.m_vVel - other.m_vVel;
    const double size = std::max(other.m_vPos.cwiseAbs().maxCoeff(), ball.m_vPos.cwiseAbs().maxCoeff()) +
                        other.m_fRadius + ball.m_fRadius;
    const double bound = 16.0 * 0x1p-52 * (size + other.m_vVel.norm() + ball.m_vVel.norm());
    const double approach = met ? -v.dot(impact.m_vNorm) : 0.0;
    const double error = std::abs(static_cast<double>(exact.m_fTime - CFifty(impact.m_fTime)));
    if (met != metExactly || (met && !(error * approach <= bound + 4.0 * 0x1p-52 * approach))) {
      // Larger by the bound it is met before, smaller after this, or not at all.
      Compare::CHit<CFifty> larger, smaller;
      const double more = 4.0 * std::max(bound, g_nSweepRoundings * 0x1p-52 * size);
      const bool metLarger = Compare::SweepBalls<CFifty>(Exact(other), Exact(ball, more), CFifty(1), larger);
      const bool metSmaller =
          Compare::SweepBalls<CFifty>(Exact(other), Exact(ball, -more), CFifty(1), smaller);
      ++ambiguous;
      ASSERT_TRUE(metLarger && (!met || static_cast<double>(larger.m_fTime) <= impact.m_fTime + 1e-15));
      ASSERT_TRUE(!metSmaller || (met && static_cast<double>(smaller.m_fTime) >= impact.m_fTime - 1e-15));
      return;
    }
    ++(met ? hits : misses);
    if (!met) return;
    ASSERT_GT(approach, 0.0);
    const Vector2d n(static_cast<double>(exact.m_vNorm.x()), static_cast<double>(exact.m_vNorm.y()));
    ASSERT_LE((impact.m_vNorm - n).norm() * (other.m_fRadius + ball.m_fRadius),
              2.0 * (error * v.norm() + bound));
    ASSERT_EQ(impact.m_vSurface, other.m_vVel);
    const Vector2d p = other.m_vPos + other.m_vVel * impact.m_fTime;
    ASSERT_NEAR((impact.m_vPOI - p).norm(), other.m_fRadius, 2.0 * bound);
  });
  EXPECT_GT(hits, 4000);
  EXPECT_GT(misses, 4000);
  EXPECT_LT(ambiguous, 200);
}

TEST(ImpactBallBall, SwappingTheBallsChangesSignsOnly) {
  int hits = 0;
  ForEachCase(51, 5000, [&](CRandom& random, int) {
    CMotion other, ball;
    RandomBalls(random, other, ball);
    CImpact a, b;
    const eSweep found = ImpactBallBall(other, ball, a);
    ASSERT_EQ(found, ImpactBallBall(ball, other, b));
    double depthA = 0.0, depthB = 0.0;
    CImpact c, d;
    ASSERT_EQ(OverlapBallBall(other, ball, c, depthA), OverlapBallBall(ball, other, d, depthB));
    ASSERT_EQ(depthA, depthB);
    if (found != eSweep::Impact) return;
    ++hits;
    ASSERT_EQ(a.m_fTime, b.m_fTime);
    ASSERT_EQ(a.m_vNorm, -b.m_vNorm);
  });
  EXPECT_GT(hits, 1000);
}

TEST(ImpactBallBall, TheShorterLegEndsTheSearch) {
  CImpact impact;
  const CMotion other{{0, 0}, {0, 0}, 0.5, 1.0}, ball{{3, 0}, {-1, 0}, 0.5, 4.0};
  EXPECT_EQ(ImpactBallBall(other, ball, impact), eSweep::None);
  EXPECT_EQ(ImpactBallBall(ball, other, impact), eSweep::None);
  CMotion longer = other;
  longer.m_fDuration = 4.0;
  ASSERT_EQ(ImpactBallBall(longer, ball, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 2.0);
  EXPECT_EQ(impact.m_vNorm, Vector2d(1, 0));
}

TEST(ImpactBallBall, BallsAtOnePlaceGoBackWhereTheyCameFrom) {
  CImpact impact;
  double depth = 0.0;
  const CMotion other{{1, 1}, {0, 2}, 0.5, 1.0}, ball{{1, 1}, {0, -2}, 0.25, 1.0};
  ASSERT_EQ(ImpactBallBall(other, ball, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 0.0);
  EXPECT_EQ(impact.m_vNorm, Vector2d(0, 1));
  ASSERT_TRUE(OverlapBallBall(other, ball, impact, depth));
  EXPECT_EQ(depth, 0.75);
  EXPECT_EQ(impact.m_vNorm, Vector2d(0, 1));
  EXPECT_EQ(impact.m_vPOI, Vector2d(1, 1.5));
}

} // namespace
} // namespace Shapes::Geometry
