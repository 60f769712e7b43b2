// SPDX-License-Identifier: MIT
// Balls that meet circles, arcs and each other.
#include "Tolerances.h"

#include "ImpactTesting.h"

namespace Shapes::Geometry {
namespace {

CShapeGeometry Ring(float R) { return MakeShapeGeometry(CCircle(CCircleDesc({0, 0}, R)), 0.0); }

TEST(ImpactCircleCircle, AgreesWith50Digits) {
  ExpectAgrees<CFifty>(eShape::Circle, eSides::Both, false, 30, 8000);
}

TEST(ImpactCircleCircle, ARingIsMetFromBothSides) {
  CImpact impact;
  ASSERT_EQ(Sweep(Ring(2), {{5, 0}, {-1, 0}, 0.5, 9.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 2.5);
  EXPECT_EQ(impact.m_vNorm, Vector2d(1, 0));
  EXPECT_EQ(impact.m_fCurve, 0.0);
  ASSERT_EQ(Sweep(Ring(2), {{1, 0}, {-1, 0}, 0.5, 9.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 2.5);
  EXPECT_EQ(impact.m_vNorm, Vector2d(1, 0));
  EXPECT_EQ(impact.m_vPOI, Vector2d(-2, 0));
  // From the very middle.
  ASSERT_EQ(Sweep(Ring(2), {{0, 0}, {0, 3}, 0.5, 9.0}, 0.0, impact), eSweep::Impact);
  EXPECT_NEAR(impact.m_fTime, 0.5, 4 * 0x1p-52);
  EXPECT_EQ(impact.m_vNorm, Vector2d(0, -1));
}

TEST(ImpactCircleCircle, ABallThatDoesNotFitIsOutside) {
  CImpact impact;
  double depth = 0.0;
  EXPECT_EQ(Sweep(Ring(1), {{0.5, 0}, {1, 0}, 1.0, 9.0}, 0.0, impact), eSweep::None);
  ASSERT_EQ(Sweep(Ring(1), {{0.5, 0}, {-1, 0}, 1.0, 9.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_vNorm, Vector2d(1, 0));
  ASSERT_TRUE(Overlap(Ring(1), {{0.5, 0}, {1, 0}, 1.0, 9.0}, 0.0, impact, depth));
  EXPECT_EQ(depth, 1.5);
}

// The gap that opens at rate u closes again after 2 u / m_fCurve, as it does for small u.
TEST(ImpactCircleCircle, TheCurveTellsHowSoonABallComesBack) {
  const double R = 2.0, r = 0.5, speed = 3.0, u = 1e-3;
  CImpact impact, next;
  const CMotion along{{0, R - r}, {speed, -u}, r, 1.0};
  ASSERT_EQ(Sweep(Ring(2), along, 0.0, next), eSweep::Impact);
  ASSERT_EQ(Sweep(Ring(2), {along.m_vPos, {speed, u}, r, 1.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 0.0);
  EXPECT_EQ(impact.m_fCurve, speed * speed / (R - r));
  EXPECT_NEAR(next.m_fTime, 2.0 * u / impact.m_fCurve, 1e-6 * next.m_fTime);
}

// A ball that overlaps the ring from inside, and goes inward by less than it overlaps, is met where it begins
// to approach again.
TEST(ImpactCircleCircle, AnOverlappingBallIsNotLost) {
  ForEachCase(33, 5000, [&](CRandom& random, int) {
    const double r = 0.05 + 0.9 * random.Unit(), depth = r * 0.99 * random.Unit(), far = 1.0 - r + depth;
    const double angle = 6.28 * random.Unit(), inward = 1.57 * random.Unit();
    const Vector2d u(std::cos(angle), std::sin(angle));
    const CMotion motion{far * u, std::cos(inward) * Perp(u) - std::sin(inward) * u, r, 4.0};
    CImpact impact;
    ASSERT_EQ(Sweep(Ring(1), motion, 0.0, impact), eSweep::Impact);
    const Vector2d p = motion.m_vPos + motion.m_vVel * impact.m_fTime;
    const double closest = far * std::cos(inward); // of its way to the centre
    ASSERT_NEAR(p.norm(), std::max(1.0 - r, closest), 1e-7);
    ASSERT_GE(impact.m_vNorm.dot(u), -1.0);
    ASSERT_LE(impact.m_vNorm.dot(motion.m_vVel), 1e-7);
  });
}

// A ball in a ring, for a thousand bounces that keep its speed, never gets out.
TEST(ImpactCircleCircle, ABallInARingStaysThere) {
  const CShapeGeometry ring = Ring(1);
  ForEachCase(34, 50, [&](CRandom& random, int) {
    CMotion motion{random.InSquare(0.4f).cast<double>(), random.Direction().cast<double>(),
                   random.Coin() ? 0.3 : 0.0, 10.0};
    for (int k = 0; k < 1000; ++k) {
      CImpact impact;
      ASSERT_EQ(Sweep(ring, motion, 0.0, impact), eSweep::Impact);
      motion.m_vPos += motion.m_vVel * impact.m_fTime;
      motion.m_vVel -= 2.0 * motion.m_vVel.dot(impact.m_vNorm) * impact.m_vNorm;
      ASSERT_LE(motion.m_vPos.norm() + motion.m_fRadius, 1.0 + 1e-12);
    }
  });
}

TEST(ImpactCircleArc, AgreesWith50Digits) {
  ExpectAgrees<CFifty>(eShape::Arc, eSides::Both, false, 40, 8000);
  ExpectAgrees<CFifty>(eShape::Arc, eSides::Front, false, 41, 4000);
  ExpectAgrees<CFifty>(eShape::Arc, eSides::Back, false, 42, 4000);
}

// In a gap that is narrower than itself a ball touches both ends: each stops it, also where the other is
// nearer.
TEST(ImpactCircleArc, InANarrowGapBothEndsStopTheBall) {
  const CShapeGeometry c = MakeShapeGeometry(CArc(CArcDesc({0, 0}, 1, 0.25f, -0.25f)), 0.0);
  const double r = 0.5, half = std::sin(0.25), x = std::cos(0.25) + std::sqrt(r * r - half * half);
  for (const double y : {1.0, -1.0}) {
    CImpact impact;
    ASSERT_EQ(Sweep(c, {{x, 0}, {0, y}, r, 1.0}, 0.0, impact), eSweep::Impact);
    EXPECT_NEAR(impact.m_fTime, 0.0, 1e-6);
    EXPECT_LT(impact.m_vNorm.y() * y, 0.0);
  }
}

// Quarter turns have the same bits but for signs and places.
TEST(ImpactCircleArc, QuarterTurnsChangeNothing) {
  int hits = 0;
  ForEachCase(43, 5000, [&](CRandom& random, int) {
    const CTrial trial = RandomTrial(random, eShape::Arc, eSides::Both);
    CTrial turned = trial;
    for (Vector2d* v : {&turned.m_cShape.m_vCenter, &turned.m_cShape.m_vPt0, &turned.m_cShape.m_vPt1,
                        &turned.m_cMotion.m_vPos, &turned.m_cMotion.m_vVel})
      *v = Perp(*v);
    CImpact a, b;
    const eSweep found = Sweep(trial.m_cShape, trial.m_cMotion, 0.0, a);
    ASSERT_EQ(found, Sweep(turned.m_cShape, turned.m_cMotion, 0.0, b));
    if (found != eSweep::Impact) return;
    ++hits;
    ASSERT_EQ(a.m_fTime, b.m_fTime);
    ASSERT_EQ(Perp(a.m_vNorm), b.m_vNorm);
    ASSERT_EQ(a.m_fCurve, b.m_fCurve);
  });
  EXPECT_GT(hits, 1000);
}

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
