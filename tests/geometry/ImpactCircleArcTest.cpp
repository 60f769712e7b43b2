// SPDX-License-Identifier: MIT
#include "ImpactTesting.h"

#include <cmath>

namespace Shapes::Geometry {
namespace {

// The right half of a circle.
CShapeGeometry HalfCircle(eSides sides = eSides::Both) {
  CArcDesc desc({0, 0}, 2, -0.5f * g_fPi, 0.5f * g_fPi);
  desc.m_eSides = sides;
  return MakeShapeGeometry(CArc(desc), 0.0);
}

TEST(ImpactCircleArc, AgreesWith50Digits) {
  ExpectAgrees<CFifty>(eShape::Arc, eSides::Both, false, 40, 8000);
  ExpectAgrees<CFifty>(eShape::Arc, eSides::Front, false, 41, 4000);
  ExpectAgrees<CFifty>(eShape::Arc, eSides::Back, false, 42, 4000);
}

TEST(ImpactCircleArc, AnArcIsMetInItsSector) {
  CImpact impact;
  ASSERT_EQ(Sweep(HalfCircle(), {{5, 0}, {-1, 0}, 0.5, 20.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 2.5);
  EXPECT_EQ(impact.m_vNorm, Vector2d(1, 0));
  // Through the opening, and from inside.
  ASSERT_EQ(Sweep(HalfCircle(), {{-5, 0}, {1, 0}, 0.5, 20.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 6.5);
  EXPECT_EQ(impact.m_vNorm, Vector2d(-1, 0));
  EXPECT_EQ(Sweep(HalfCircle(), {{-5, -1}, {0, 1}, 0.5, 20.0}, 0.0, impact), eSweep::None);
  // At an end.
  ASSERT_EQ(Sweep(HalfCircle(), {{-5, 2}, {1, 0}, 0.5, 20.0}, 0.0, impact), eSweep::Impact);
  EXPECT_NEAR(impact.m_fTime, 4.5, 1e-6); // the angles are floats
  EXPECT_NEAR(impact.m_vNorm.x(), -1.0, 1e-6);
}

TEST(ImpactCircleArc, AOneSidedArcIsOpenFromTheOtherSide) {
  CImpact impact;
  const CMotion in{{5, 0}, {-1, 0}, 0.5, 4.0}, out{{0, 0}, {1, 0}, 0.5, 9.0};
  EXPECT_EQ(Sweep(HalfCircle(eSides::Front), in, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(Sweep(HalfCircle(eSides::Front), out, 0.0, impact), eSweep::None);
  EXPECT_EQ(Sweep(HalfCircle(eSides::Back), in, 0.0, impact), eSweep::None);
  EXPECT_EQ(Sweep(HalfCircle(eSides::Back), out, 0.0, impact), eSweep::Impact);
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

} // namespace
} // namespace Shapes::Geometry
