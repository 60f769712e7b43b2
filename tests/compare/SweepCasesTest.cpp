// SPDX-License-Identifier: MIT
// The sweep on cases with known answers: the hard ones that concern the time of impact on a straight way,
// what overlaps at the start, open sides, and turning shapes.
#include "../Numbers.h"
#include "ReferenceTesting.h"
#include "reference/Sweep.h"

#include <Shapes/World.h>

namespace Shapes::Compare::Tests {
namespace {

using CBalld = CSweptBall<double>;

constexpr float g_fDegree = g_fPi / 180.0f;

struct CResult {
  bool m_bMet;
  CHit<double> m_cHit;
};

CResult Shoot(const CAnyShapeDesc& desc, const CBalld& ball, double tMax = 10.0,
              eMeet meet = eMeet::Approaching) {
  CResult result;
  result.m_bMet = Sweep(MakeShapeGeometry(desc), ball, tMax, result.m_cHit, meet);
  return result;
}

TEST(SweepCases, HardTimesOfImpactAreTheKnownOnes) {
  const struct {
    const char* m_sName;
    CAnyShapeDesc m_cShape;
    CBalld m_cBall;
    double m_fTime;
    double m_fTolerance = 0; // 8 ulp of the time if it is 0
  } cases[] = {
      {"ball of radius 0", CLineSegDesc({-1, 0}, {1, 0}), {{0, 1}, {0, -1}, 0}, 1},
      {"segment without length", CLineSegDesc({1, 1}, {1, 1}), {{1, 3}, {0, -1}, .5}, 1.5},
      {"the square of its length underflows", CLineSegDesc({0, 0}, {1e-30f, 0}), {{0, 2}, {0, -1}, .5}, 1.5},
      {"circle of radius 0", CCircleDesc({0, 0}, 0), {{0, 2}, {0, -1}, .5}, 1.5},
      {"arc across 0", CArcDesc({0, 0}, 1, 350 * g_fDegree, 10 * g_fDegree), {{2, 0}, {-1, 0}, .1}, .9},
      {"full circle", CArcDesc({0, 0}, 1, 0, 0), {{2, 0}, {-1, 0}, .1}, .9},
      {"arc from a tiny negative angle", CArcDesc({0, 0}, 1, -1e-9f, 1), {{2, 0}, {-1, 0}, .1}, .9},
      {"arc of 1e-7 radian", CArcDesc({0, 0}, 1, 0, 1e-7f), {{2, 0}, {-1, 0}, .1}, .9, 1e-7},
      {"slit narrower than the ball",
       CArcDesc({0, 0}, 1, 1e-6f, float(g_fPi2 - 1e-6)),
       {{2, 0}, {-1, 0}, .1},
       .9,
       1e-6},
      {"wider opening", CArcDesc({0, 0}, 1, 45 * g_fDegree, 315 * g_fDegree), {{3, 0}, {-1, 0}, .1}, 3.9},
      {"near graze",
       CPointDesc({0, 0}),
       {{-10, 1 - 1e-12}, {1, 0}, 1},
       9.99999858578644,
       10 * g_fEps / std::sqrt(2e-12)},
      {"very fast ball", CLineSegDesc({0, -1}, {0, 1}), {{-1, 0}, {1e6, 0}, .1}, 9e-7},
      {"far from the origin",
       CArcDesc({1048576, 1048576}, 1, 350 * g_fDegree, 10 * g_fDegree),
       {{1048578, 1048576}, {-1, 0}, .1},
       .9,
       4 * 0x1p-32},
      {"naked end", CLineSegDesc({0, 0}, {1, 0}), {{-.3, 2}, {0, -1}, .5}, 1.6}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.m_sName);
    const CResult result = Shoot(c.m_cShape, c.m_cBall);
    ASSERT_TRUE(result.m_bMet);
    EXPECT_NEAR(result.m_cHit.m_fTime, c.m_fTime,
                c.m_fTolerance > 0 ? c.m_fTolerance : 8 * g_fEps * c.m_fTime);
    EXPECT_NEAR(result.m_cHit.m_vNorm.norm(), 1.0, 8.0 * g_fEps);
  }
}

TEST(SweepCases, CentreOnTheShapeGoesBackWhereItCameFrom) { // a point, or a segment
  const CResult point = Shoot(CPointDesc({0, 0}), {{0, 0}, {1, 0}, .5});
  ASSERT_TRUE(point.m_bMet);
  EXPECT_EQ(point.m_cHit.m_vNorm, CVec2d(-1, 0));
  EXPECT_EQ(point.m_cHit.m_fTime, 0.0);
  EXPECT_TRUE(point.m_cHit.m_bOverlapped);
  EXPECT_EQ(point.m_cHit.m_fDepth, .5);
  const CResult seg = Shoot(CLineSegDesc({-1, 0}, {1, 0}), {{0, 0}, {1, -1}, .5});
  ASSERT_TRUE(seg.m_bMet);
  EXPECT_EQ(seg.m_cHit.m_vNorm, CVec2d(0, 1));
  EXPECT_EQ(seg.m_cHit.m_fDepth, .5);
  // From below it is the other face, also for a ball without extent.
  EXPECT_EQ(Shoot(CLineSegDesc({-1, 0}, {1, 0}), {{0, 0}, {1, 1}, 0}).m_cHit.m_vNorm, CVec2d(0, -1));
}

TEST(SweepCases, InsideAnArcThatItDoesNotFit) { // is met by nothing; in a wide one the gap is R - r
  const CArcDesc bowl({0, 0}, 1, 0, 0), wide({0, 0}, 2, 0, 0);
  for (const CVec2d& v : {CVec2d(0, 0), CVec2d(1, 0), CVec2d(-.3, .4)}) {
    EXPECT_FALSE(Shoot(bowl, {{0, 0}, v, 1}).m_bMet);
    EXPECT_FALSE(Shoot(bowl, {{.1, 0}, v, 1.5}).m_bMet);
  }
  EXPECT_FALSE(Shoot(wide, {{0, 0}, {0, 0}, .5}).m_bMet);
  EXPECT_FALSE(Shoot(wide, {{0, 0}, {1, 0}, .5}, 1.5 - 1e-9).m_bMet); // the gap is 1.5
  EXPECT_TRUE(Shoot(wide, {{0, 0}, {1, 0}, .5}, 1.5 + 1e-9).m_bMet);
}

TEST(SweepCases, RingThatTheBallDoesNotFitIsMetFromOutside) {
  const CCircleDesc ring({0, 0}, 1);
  EXPECT_FALSE(Shoot(ring, {{2, 0}, {0, 0}, .1}).m_bMet); // inside a ring there is nothing
  const CResult fits = Shoot(ring, {{.5, 0}, {1, 0}, .25});
  ASSERT_TRUE(fits.m_bMet);
  EXPECT_EQ(fits.m_cHit.m_ePart, ePart::Inside);
  EXPECT_NEAR(fits.m_cHit.m_fTime, .25, 16 * g_fEps);
  EXPECT_FALSE(Shoot(ring, {{.5, 0}, {1, 0}, 1}).m_bMet); // outside, however deep, and leaving
  const CResult deep = Shoot(ring, {{.5, 0}, {-1, 0}, 1});
  ASSERT_TRUE(deep.m_bMet);
  EXPECT_EQ(deep.m_cHit.m_ePart, ePart::Outside);
  EXPECT_NEAR(deep.m_cHit.m_fDepth, 1.5, 8 * g_fEps);
}

TEST(SweepCases, GrazesAreFlaggedOnBothSides) { // of the way that only touches
  const auto graze = [](double offset) {
    return Shoot(CPointDesc({0, 0}), {{-10, offset}, {1, 0}, 1}, 20.0);
  };
  EXPECT_TRUE(graze(1 - 1e-12).m_bMet);
  EXPECT_TRUE(graze(1 - 1e-12).m_cHit.m_bGraze);
  EXPECT_FALSE(graze(1 + 1e-12).m_bMet);
  EXPECT_TRUE(graze(1 + 1e-12).m_cHit.m_bGraze);
  EXPECT_NEAR(graze(1 + 1e-12).m_cHit.m_fTime, 10.0, 1e-12);
  // Not ambiguous any more a little farther off.
  EXPECT_TRUE(graze(1 - 1e-8).m_bMet);
  EXPECT_FALSE(graze(1 - 1e-8).m_cHit.m_bGraze);
  EXPECT_FALSE(graze(1 + 1e-8).m_cHit.m_bGraze);
  // Nor if it does not get that far.
  EXPECT_FALSE(Shoot(CPointDesc({0, 0}), {{-10, 1 + 1e-12}, {1, 0}, 1}, 9.0).m_cHit.m_bGraze);
}

TEST(SweepCases, OverlapIsHitOnlyIfItApproaches) {
  struct {
    CAnyShapeDesc m_cShape;
    CVec2d m_vPos;
    CVec2d m_vOut;
    double m_fDepth;
  } cases[] = {{CPointDesc({0, 0}), {.3, 0}, {1, 0}, .2},
               {CLineSegDesc({-1, 0}, {1, 0}), {0, -.3}, {0, -1}, .2},
               {CLineSegDesc({-1, 0}, {1, 0}), {1.3, 0}, {1, 0}, .2},
               {CCircleDesc({0, 0}, 1), {1.3, 0}, {1, 0}, .2},
               {CCircleDesc({0, 0}, 1), {.7, 0}, {-1, 0}, .2},
               {CArcDesc({0, 0}, 1, -1, 1), {.7, 0}, {-1, 0}, .2},
               {CArcDesc({0, 0}, 1, -1, 1), {1.3, 0}, {1, 0}, .2}};
  for (const auto& c : cases) {
    SCOPED_TRACE(testing::Message() << "shape " << c.m_cShape.index() << " at " << c.m_vPos.x());
    const CVec2d in = -c.m_vOut;
    const CResult approaching = Shoot(c.m_cShape, {c.m_vPos, in, .5}, .1);
    ASSERT_TRUE(approaching.m_bMet);
    EXPECT_EQ(approaching.m_cHit.m_fTime, 0.0);
    EXPECT_TRUE(approaching.m_cHit.m_bOverlapped);
    EXPECT_NEAR(approaching.m_cHit.m_fDepth, c.m_fDepth, 16 * g_fEps);
    EXPECT_NEAR((approaching.m_cHit.m_vNorm - c.m_vOut).norm(), 0.0, 1e-15);
    EXPECT_FALSE(Shoot(c.m_cShape, {c.m_vPos, c.m_vOut, .5}, .1).m_bMet);
    EXPECT_FALSE(Shoot(c.m_cShape, {c.m_vPos, {0, 0}, .5}, .1).m_bMet);
    // A sensor is touched whichever way the ball goes.
    EXPECT_TRUE(Shoot(c.m_cShape, {c.m_vPos, c.m_vOut, .5}, .1, eMeet::Touching).m_bMet);
  }
}

TEST(SweepCases, OneSidedSegmentStopsOneWay) {
  const CLineSegDesc both({-1, 0}, {1, 0});
  for (const eSides sides : {eSides::Both, eSides::Front, eSides::Back}) {
    SCOPED_TRACE(static_cast<int>(sides));
    const CLineSegDesc seg = Sided(both, sides);
    const bool front = sides != eSides::Back, back = sides != eSides::Front;
    EXPECT_EQ(Shoot(seg, {{0, 2}, {0, -1}, .1}).m_bMet, front);
    EXPECT_EQ(Shoot(seg, {{0, -2}, {0, 1}, .1}).m_bMet, back);
    EXPECT_EQ(Shoot(seg, {{1.05, 2}, {0, -1}, .1}).m_bMet, front); // the ends too
    EXPECT_EQ(Shoot(seg, {{1.05, -2}, {0, 1}, .1}).m_bMet, back);
    // Half way through, in both directions; then still in the end it passes.
    EXPECT_FALSE(Shoot(seg, {{0, .05}, {0, 1}, .1}).m_bMet);
    EXPECT_FALSE(Shoot(seg, {{0, -.05}, {0, -1}, .1}).m_bMet);
    EXPECT_EQ(Shoot(seg, {{1.05, .01}, {-1, .1}, .1}, .5).m_bMet, sides == eSides::Both);
    // Knocked back while its centre is on the solid side.
    EXPECT_EQ(Shoot(seg, {{0, .05}, {0, -1}, .1}).m_bMet, front);
  }
}

TEST(SweepCases, OneSidedArcStopsOneWay) {
  const CArcDesc both({0, 0}, 1, -1, 1);
  for (const eSides sides : {eSides::Both, eSides::Front, eSides::Back}) {
    SCOPED_TRACE(static_cast<int>(sides));
    const CArcDesc arc = Sided(both, sides);
    EXPECT_EQ(Shoot(arc, {{2, 0}, {-1, 0}, .1}).m_bMet, sides != eSides::Back);
    EXPECT_EQ(Shoot(arc, {{0, 0}, {1, 0}, .1}).m_bMet, sides != eSides::Front);
    const CVec2d end(std::cos(1.0), std::sin(1.0)), beside(-.05 * end.y(), .05 * end.x());
    EXPECT_EQ(Shoot(arc, {2.0 * end + beside, -end, .1}).m_bMet, sides != eSides::Back);
    EXPECT_EQ(Shoot(arc, {0.5 * end + beside, end, .1}).m_bMet, sides != eSides::Front);
  }
  // Through the open outside, against the solid inside beyond.
  const CResult through = Shoot(Sided(CArcDesc({0, 0}, 1, 0, 0), eSides::Back), {{3, 0}, {-1, 0}, .1});
  ASSERT_TRUE(through.m_bMet);
  EXPECT_NEAR(through.m_cHit.m_fTime, 3.9, 16 * g_fEps * 4.1);
}

// A blade of length 1 that turns at w meets a resting ball when its angle is that of the tangent.
TEST(SweepCases, TurningBladeMeetsARestingBall) {
  const CShapeGeometry<double> blade = MakeShapeGeometry(CLineSegDesc({0, 0}, {1, 0}));
  for (const double w : {0.1, 6.0, 60.0, 60.0 * g_fPi2}) {
    const double r = .1, d = .7, turn = std::numbers::pi / 2 - std::asin(r / d), t = turn / w;
    CHit<double> hit;
    ASSERT_TRUE(Sweep<double>(blade, {{0, 0}, w}, {{0, d}, {0, 0}, r}, 100.0 / w, hit));
    EXPECT_NEAR(hit.m_fTime, t, 100 * g_fEps * 2 / (w * d) + 4 * g_fEps * t);
    const double foot = std::sqrt(d * d - r * r);
    EXPECT_NEAR((hit.m_vPOI - foot * CVec2d(std::cos(turn), std::sin(turn))).norm(), 0.0, 1e-13);
    EXPECT_NEAR(hit.m_vSurface.norm(), w * foot, 1e-12 * w);
    EXPECT_GT(hit.m_vSurface.dot(hit.m_vNorm), 0.0);
    // The other way round it is met by the other face, later.
    CHit<double> back;
    ASSERT_TRUE(Sweep<double>(blade, {{0, 0}, -w}, {{0, d}, {0, 0}, r}, 100.0 / w, back));
    EXPECT_NEAR(back.m_fTime, (g_fPi2 - std::numbers::pi / 2 - std::asin(r / d)) / w,
                100 * g_fEps * 2 / (w * d) + 4 * g_fEps * back.m_fTime);
    EXPECT_NE(hit.m_ePart, back.m_ePart);
  }
}

// A whole turn in one step. At its end nothing seems to have moved; the sweep sees the blade pass.
TEST(SweepCases, WholeTurnIsNotNoTurn) {
  const CShapeGeometry<double> blade = MakeShapeGeometry(CLineSegDesc({0, 0}, {1, 0}));
  CHit<double> hit;
  EXPECT_TRUE(Sweep<double>(blade, {{0, 0}, 60 * g_fPi2}, {{0, .5}, {0, 0}, .1}, 1.0 / 60, hit));
  EXPECT_LT(hit.m_fTime, 1.0 / 60 / 4);
  EXPECT_FALSE(Sweep<double>(blade, {{0, .5}, {0, 0}, .1}, 1.0 / 60, hit)); // control: at rest
}

// A ball that a turning blade carries along, in touch and not approaching, is met as soon as the blade
// presses.
TEST(SweepCases, PressedByATurningBlade) {
  const CShapeGeometry<double> blade = MakeShapeGeometry(CLineSegDesc({0, 0}, {1, 0}));
  CHit<double> hit;
  ASSERT_TRUE(Sweep<double>(blade, {{0, 0}, 10}, {{.5, .1}, {1, 5}, .1}, 1.0 / 60, hit));
  EXPECT_LT(hit.m_fTime, 1e-9);
  // One that is faster than the blade leaves.
  EXPECT_FALSE(Sweep<double>(blade, {{0, 0}, 10}, {{.5, .1}, {0, 8}, .1}, 1.0 / 60, hit));
}

} // namespace
} // namespace Shapes::Compare::Tests
