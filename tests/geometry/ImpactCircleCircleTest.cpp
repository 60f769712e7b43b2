// SPDX-License-Identifier: MIT
#include "ImpactTesting.h"

#include <cmath>

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

} // namespace
} // namespace Shapes::Geometry
