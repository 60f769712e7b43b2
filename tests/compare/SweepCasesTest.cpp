// SPDX-License-Identifier: MIT
// The sweep on cases with known answers: rings, tangents, what overlaps at the start, and open sides; and
// along parabolas, a ball that is thrown and met by each kind of shape, tangents, and what touches or
// overlaps at the start. Times of impact that are hard are among the hard cases.
#include "ReferenceTesting.h"
#include "reference/Sweep.h"

namespace Shapes::Compare::Tests {
namespace {

using CBalld = CSweptBall<double>;

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

TEST(SweepCases, OneSidedSegmentLetsOutWhatIsHalfWayThrough) {
  const CLineSegDesc both({-1, 0}, {1, 0});
  for (const eSides sides : {eSides::Both, eSides::Front, eSides::Back}) {
    SCOPED_TRACE(static_cast<int>(sides));
    const CLineSegDesc seg = Sided(both, sides);
    // Half way through, in both directions; then still in the end it passes.
    EXPECT_FALSE(Shoot(seg, {{0, .05}, {0, 1}, .1}).m_bMet);
    EXPECT_FALSE(Shoot(seg, {{0, -.05}, {0, -1}, .1}).m_bMet);
    EXPECT_EQ(Shoot(seg, {{1.05, .01}, {-1, .1}, .1}, .5).m_bMet, sides == eSides::Both);
    // Knocked back while its centre is on the solid side.
    EXPECT_EQ(Shoot(seg, {{0, .05}, {0, -1}, .1}).m_bMet, sides != eSides::Back);
  }
}

TEST(SweepCases, FullArcOpenOutsideStopsWhatIsInside) {
  const CResult through = Shoot(Sided(CArcDesc({0, 0}, 1, 0, 0), eSides::Back), {{3, 0}, {-1, 0}, .1});
  ASSERT_TRUE(through.m_bMet);
  EXPECT_NEAR(through.m_cHit.m_fTime, 3.9, 16 * g_fEps * 4.1);
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

const CVec2d g_vDown(0, -8);

CResult Throw(const CAnyShapeDesc& desc, const CVec2d& p, const CVec2d& v, double r, double tMax = 10,
              const CVec2d& g = g_vDown) {
  return Shoot(desc, {p, v, r, g}, tMax);
}

TEST(Parabola, ApexIsFoundInOneLongStep) { // both ends of the way are far below
  EXPECT_TRUE(Throw(CPointDesc({0, 10.1f}), {-2, 0}, {1.265, 12.65}, .25, 20).m_bMet);
  EXPECT_FALSE(Throw(CPointDesc({0, 10.5f}), {-2, 0}, {1.265, 12.65}, .25, 20).m_bMet);
}

// Of a straight way that only touches a point at the time 10, and of a parabola that only touches a ceiling,
// or a point, with its apex at the time .5: within a `close` distance, and no more at a larger one.
TEST(Parabola, TangentsAreFlaggedOnBothSides) {
  const struct {
    CAnyShapeDesc m_cShape;
    CBalld m_cBall;
    double m_fTime, m_fClose;
  } cases[] = {{CPointDesc({0, 1}), {{-10, 0}, {1, 0}, 1}, 10, 1e-12},
               {Wall({-9, 1.5f}, {9, 1.5f}), {{0, 0}, {2, 4}, .5, g_vDown}, .5, 1e-11},
               {CPointDesc({1, 1.5f}), {{0, 0}, {2, 4}, .5, g_vDown}, .5, 1e-11}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.m_cShape.index());
    const auto toss = [&](double over, double tMax) {
      CBalld ball = c.m_cBall;
      ball.m_vPos.y() += over;
      return Shoot(c.m_cShape, ball, tMax);
    };
    const double close = c.m_fClose, far = 1e4 * close, all = 2 * c.m_fTime;
    EXPECT_TRUE(toss(close, all).m_bMet && toss(close, all).m_cHit.m_bGraze);
    EXPECT_TRUE(!toss(-close, all).m_bMet && toss(-close, all).m_cHit.m_bGraze);
    EXPECT_NEAR(toss(-close, all).m_cHit.m_fTime, c.m_fTime, c.m_fTime < 1 ? 1e-6 : 1e-12);
    EXPECT_TRUE(toss(far, all).m_bMet && !toss(far, all).m_cHit.m_bGraze);
    EXPECT_FALSE(toss(-far, all).m_cHit.m_bGraze);
    EXPECT_FALSE(toss(-close, .9 * c.m_fTime).m_cHit.m_bGraze); // it does not get that far
  }
}

// Touching and overlapping balls that do not approach are met when they begin to.
TEST(Parabola, WhatBeginsToApproachIsMet) {
  for (const CAnyShapeDesc& floor :
       {CAnyShapeDesc(Wall({-9, 0}, {9, 0})), CAnyShapeDesc(CCircleDesc({0, -2}, 2)),
        CAnyShapeDesc(CPointDesc({0, 0})), CAnyShapeDesc(CArcDesc({0, 4}, 4, 0, 0)),
        CAnyShapeDesc(Sided(Wall({-9, 0}, {9, 0}), eSides::Front))}) {
    SCOPED_TRACE(floor.index());
    for (const double depth : {0.0, 1e-8, .125}) {
      const CResult rests = Throw(floor, {0, .5 - depth}, {0, 0}, .5);
      ASSERT_TRUE(rests.m_bMet);
      EXPECT_EQ(rests.m_cHit.m_fTime, 0);
      EXPECT_TRUE(rests.m_cHit.m_bBegins);
      EXPECT_NEAR(rests.m_cHit.m_fDepth, depth, 1e-15);
      EXPECT_EQ(rests.m_cHit.m_bOverlapped, depth > 0);
      if (depth < .1) continue;
      const CResult leaves = Throw(floor, {0, .5 - depth}, {0, .8}, .5); // .04 up, in .1
      ASSERT_TRUE(leaves.m_bMet);
      EXPECT_NEAR(leaves.m_cHit.m_fTime, .1, 1e-14);
      EXPECT_NEAR(leaves.m_cHit.m_fDepth, .085, 1e-14);
      // High enough it comes back from clear.
      const CResult clear = Throw(floor, {0, .5 - depth}, {0, 4}, .5);
      ASSERT_TRUE(clear.m_bMet);
      EXPECT_NEAR(clear.m_cHit.m_fTime, (4 + std::sqrt(14.0)) / 8, 1e-14);
      EXPECT_FALSE(clear.m_cHit.m_bOverlapped);
    }
    // Accelerated off, or along a straight one, it is let go.
    EXPECT_FALSE(Throw(floor, {0, .5}, {0, 0}, .5, .1, {0, 8}).m_bMet);
  }
  EXPECT_FALSE(Throw(Wall({-9, 0}, {9, 0}), {0, .5}, {1, 0}, .5, 1, {3, 0}).m_bMet);
  // A centre on the other side is not held back.
  EXPECT_FALSE(Throw(Sided(Wall({-9, 0}, {9, 0}), eSides::Front), {0, -.1}, {0, 0}, .5).m_bMet);
  EXPECT_FALSE(Throw(Wall({-9, 0}, {9, 0}), {0, -.1}, {0, 0}, .5).m_bMet);
}

// Hops of any height last 2 v / g to a few roundings, though their height is below every rounding of place.
TEST(Parabola, TinyHopsKeepTheirRelativePrecision) {
  for (const CAnyShapeDesc& floor :
       {CAnyShapeDesc(Wall({-9, 0}, {9, 0})), CAnyShapeDesc(CCircleDesc({0, -2}, 2))})
    for (const double v : {1e-3, 1e-6, 1e-9, 1e-11}) {
      const CResult hop = Throw(floor, {0, .5 + 4 * g_fEps}, {0, v}, .5);
      ASSERT_TRUE(hop.m_bMet);
      EXPECT_NEAR(hop.m_cHit.m_fTime, 2 * v / 8, 8 * g_fEps * v / 8) << v;
      EXPECT_FALSE(hop.m_cHit.m_bOverlapped);
    }
}

TEST(Parabola, BallsOfWhichOneRests) {
  CHit<double> hit;
  // .5 of free fall onto a ball that is held.
  ASSERT_TRUE(SweepBalls<double>({{0, 0}, {0, 0}, .25}, {{0, 1}, {0, 0}, .25, g_vDown}, 1.0, hit));
  EXPECT_NEAR(hit.m_fTime, std::sqrt(2 * .5 / 8), 1e-15);
  EXPECT_NEAR((hit.m_vPOI - CVec2d(0, .25)).norm(), 0, 1e-15);
  // Both fall: never.
  EXPECT_FALSE(SweepBalls<double>({{0, 0}, {0, 0}, .25, g_vDown}, {{0, 1}, {0, 0}, .25, g_vDown}, 1.0, hit));
  // Thrown after a falling one it is met as if there were no gravity, where both are by then.
  ASSERT_TRUE(SweepBalls<double>({{0, 0}, {0, 0}, .25, g_vDown}, {{0, 1}, {0, -2}, .25, g_vDown}, 1.0, hit));
  EXPECT_NEAR(hit.m_fTime, .25, 1e-15);
  EXPECT_NEAR((hit.m_vPOI - CVec2d(0, .25 - 4 * .0625)).norm(), 0, 1e-15);
  EXPECT_NEAR((hit.m_vSurface - CVec2d(0, -2)).norm(), 0, 1e-15);
}

} // namespace
} // namespace Shapes::Compare::Tests
