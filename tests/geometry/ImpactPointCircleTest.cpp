// SPDX-License-Identifier: MIT
#include "Tolerances.h"

#include "ImpactTesting.h"

#include <cmath>

namespace Shapes::Geometry {
namespace {

CShapeGeometry PointAt(const Vector2& p) { return MakeShapeGeometry(CPoint(CPointDesc(p)), 0.0); }

TEST(ImpactPointCircle, AgreesWith50Digits) {
  ExpectAgrees<CFifty>(eShape::Point, eSides::Both, false, 10, 8000);
}

TEST(ImpactPointCircle, ABallThatLeavesIsNotMet) {
  CImpact impact;
  const CShapeGeometry point = PointAt({1, 2});
  // Touching and overlapping, away and along.
  for (const double y : {2.5, 2.25}) {
    EXPECT_EQ(Sweep(point, {{1, y}, {0, 1}, 0.5, 10.0}, 0.0, impact), eSweep::None);
    EXPECT_EQ(Sweep(point, {{1, y}, {1, 0}, 0.5, 10.0}, 0.0, impact), eSweep::None);
    EXPECT_EQ(Sweep(point, {{1, y}, {0, 0}, 0.5, 10.0}, 0.0, impact), eSweep::None);
    ASSERT_EQ(Sweep(point, {{1, y}, {0, -1}, 0.5, 10.0}, 0.0, impact), eSweep::Impact);
    EXPECT_EQ(impact.m_fTime, 0.0);
    EXPECT_EQ(impact.m_vNorm, Vector2d(0, 1));
  }
}

TEST(ImpactPointCircle, FromExactlyOnThePointItGoesBackWhereItCameFrom) {
  CImpact impact;
  double depth = 0.0;
  const CShapeGeometry point = PointAt({1, 2});
  ASSERT_EQ(Sweep(point, {{1, 2}, {3, 0}, 0.5, 1.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_vNorm, Vector2d(-1, 0));
  ASSERT_TRUE(Overlap(point, {{1, 2}, {0, 0}, 0.5, 1.0}, 0.0, impact, depth));
  EXPECT_EQ(impact.m_vNorm, Vector2d(0, 1));
  EXPECT_EQ(depth, 0.5);
}

TEST(ImpactPointCircle, ABallWithoutRadiusMeetsWhatItFliesInto) {
  CImpact impact;
  const CShapeGeometry point = PointAt({1, 2});
  ASSERT_EQ(Sweep(point, {{-1, 2}, {4, 0}, 0.0, 1.0}, 0.0, impact), eSweep::Impact);
  EXPECT_NEAR(impact.m_fTime, 0.5, g_nSweepRoundings * 0x1p-52);
  EXPECT_EQ(impact.m_vNorm, Vector2d(-1, 0));
  EXPECT_EQ(Sweep(point, {{-1, 2.0 + 1e-12}, {4, 0}, 0.0, 1.0}, 0.0, impact), eSweep::None);
}

TEST(ImpactPointCircle, TheEndOfTheLegBelongsToIt) {
  CImpact impact;
  const CShapeGeometry point = PointAt({0, 0});
  ASSERT_EQ(Sweep(point, {{2, 0}, {-1, 0}, 0.5, 1.5}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 1.5);
  EXPECT_EQ(Sweep(point, {{2, 0}, {-1, 0}, 0.5, std::nextafter(1.5, 0.0)}, 0.0, impact), eSweep::None);
}

// The bound of the straight way, and the control: the textbook's formula of the quadratic does not keep it.
TEST(ImpactPointCircle, NearGrazesKeepTheBoundThatTheTextbookBreaks) {
  CRandom random(31);
  double worst = 0.0, worstTextbook = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double r = 0.1, far = 1.0 + 99.0 * random.Unit(),
                 gap = r * std::pow(10.0, -1.0 - 5.0 * random.Unit());
    const double angle = 6.28 * random.Unit();
    const Vector2d v(std::cos(angle), std::sin(angle)), d = -far * v + (r - gap) * Perp(v);
    const CTrial trial{PointAt({0, 0}), {d, v, r, 2.0 * far}};
    CImpact impact;
    Compare::CHit<CFifty> exact;
    ASSERT_EQ(Sweep(trial.m_cShape, trial.m_cMotion, 0.0, impact), eSweep::Impact);
    ASSERT_TRUE(SweepExactly(trial, exact));
    const double truth = static_cast<double>(exact.m_fTime), approach = -impact.m_vNorm.dot(v);
    const double bound = 16.0 * 0x1p-52 * (d.norm() + r) / approach + 4.0 * 0x1p-52 * truth;
    const double a = v.squaredNorm(), b = d.dot(v), disc = b * b - a * (d.squaredNorm() - r * r);
    const double textbook = disc < 0.0 ? 0.0 : (-b - std::sqrt(disc)) / a;
    worst = std::max(worst, std::abs(impact.m_fTime - truth) / bound);
    worstTextbook = std::max(worstTextbook, std::abs(textbook - truth) / bound);
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_GT(worstTextbook, 10.0);
  RecordProperty("worst", std::to_string(worst));
}

} // namespace
} // namespace Shapes::Geometry
