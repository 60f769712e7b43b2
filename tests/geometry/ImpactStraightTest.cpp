// SPDX-License-Identifier: MIT
// Balls that meet points and segments.
#include "Tolerances.h"

#include "ImpactTesting.h"

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
  double worst = 0.0, worstTextbook = 0.0;
  ForEachCase(31, 3000, [&](CRandom& random, int) {
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
  });
  EXPECT_LE(worst, 1.0);
  EXPECT_GT(worstTextbook, 10.0);
  RecordProperty("worst", std::to_string(worst));
}

TEST(ImpactLineSegCircle, AgreesWith50Digits) {
  ExpectAgrees<CFifty>(eShape::LineSeg, eSides::Both, false, 20, 8000);
  ExpectAgrees<CFifty>(eShape::LineSeg, eSides::Front, false, 21, 4000);
  ExpectAgrees<CFifty>(eShape::LineSeg, eSides::Back, false, 22, 4000);
}

// The centre is behind, it goes back; the centre is in front, it goes on, or it comes.
TEST(ImpactLineSegCircle, AOneSidedSegmentLetsOutABallThatIsHalfWayThrough) {
  const CShapeGeometry floor =
      MakeShapeGeometry(CLineSeg(Sided(CLineSegDesc({-1, 0}, {1, 0}), eSides::Front)), 0.0);
  CImpact impact;
  EXPECT_EQ(Sweep(floor, {{0, -0.1}, {0, -1}, 0.25, 9.0}, 0.0, impact), eSweep::None);
  EXPECT_EQ(Sweep(floor, {{0, 0.1}, {0, 1}, 0.25, 9.0}, 0.0, impact), eSweep::None);
  EXPECT_EQ(Sweep(floor, {{0, 0.1}, {0, -1}, 0.25, 9.0}, 0.0, impact), eSweep::Impact);
}

// A point flies into the face again and again, and stays on its side: whatever the rounding of where it is,
// it is met by the face that it has seen first.
TEST(ImpactLineSegCircle, ABallWithoutRadiusStaysOnItsSide) {
  ForEachCase(23, 5000, [&](CRandom& random, int) {
    const CShapeGeometry seg = RandomOutline(random, eShape::LineSeg, eSides::Both, false);
    const Vector2d foot = seg.m_vPt0 + random.Unit() * (seg.m_vPt1 - seg.m_vPt0);
    const Vector2d p = foot + seg.m_vFront * (0.1 + random.Unit());
    const CMotion motion{p, 2.0 * (foot - p), 0.0, 1.0};
    CImpact impact;
    ASSERT_EQ(Sweep(seg, motion, 0.0, impact), eSweep::Impact);
    ASSERT_GT(impact.m_vNorm.dot(seg.m_vFront), 0.99);
    const CMotion back{motion.m_vPos + motion.m_vVel * impact.m_fTime, -motion.m_vVel, 0.0, 1.0};
    ASSERT_EQ(Sweep(seg, back, 0.0, impact), eSweep::None);
    const CMotion again{back.m_vPos, motion.m_vVel, 0.0, 1.0};
    ASSERT_EQ(Sweep(seg, again, 0.0, impact), eSweep::Impact);
    ASSERT_LE(impact.m_fTime * again.m_vVel.norm(), GapBound({seg, again}));
    ASSERT_GT(impact.m_vNorm.dot(seg.m_vFront), 0.99);
  });
}

// A ball that lies on a face slides off over the end, with no impact there whatever the rounding.
TEST(ImpactLineSegCircle, ABallSlidesOffOverTheEnd) {
  ForEachCase(25, 5000, [&](CRandom& random, int) {
    CShapeGeometry seg = RandomOutline(random, eShape::LineSeg, eSides::Both, false);
    const double r = 0.05 + random.Unit(), share = random.Unit();
    const Vector2d along = seg.m_vPt1 - seg.m_vPt0;
    const CMotion motion{seg.m_vPt0 + share * along + r * seg.m_vFront, 3.0 * along, r, 1.0};
    CImpact impact;
    EXPECT_EQ(Sweep(seg, motion, 0.0, impact), eSweep::None);
    seg.m_eSides = eSides::Front;
    ASSERT_EQ(Sweep(seg, motion, 0.0, impact), eSweep::None);
  });
}

} // namespace
} // namespace Shapes::Geometry
