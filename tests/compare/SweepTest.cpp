// SPDX-License-Identifier: MIT
// The sweep against known answers, and distances; tests/geometry/FirstImpactTest.cpp holds it against a
// search and against 50 digits.
#include "reference/Sweep.h"
#include "ReferenceTesting.h"
#include "SweepOracle.h"
#include "reference/Distance.h"
#include "reference/Scalar.h"

namespace Shapes::Compare::Tests {
namespace {

TEST(DistanceTest, IsThatOfTheOracle) {
  ForEachCase(17, 1600, [&](CRandom& random, int i) {
    const Vector2 center = random.InSquare(1);
    const CShapeGeometry<double> f = WithAnyShape(random, static_cast<std::uint32_t>(i), center, 1,
                                                  [](const auto& desc) { return MakeShapeGeometry(desc); });
    const CVec2d p = Wide(random.InSquare(2));
    const real distance = CSweepOracle(f, {}, {p, {0, 0}, 0}, 0).Gap(0);
    EXPECT_NEAR(Distance(f, p), static_cast<double>(distance), 32.0 * g_fEps);
  });
}

TEST(DistanceTest, OfSpecialPlaces) {
  const CShapeGeometry<double> seg = MakeShapeGeometry(CLineSegDesc({0, 0}, {4, 0})),
                               spot = MakeShapeGeometry(CLineSegDesc({1, 1}, {1, 1}));
  EXPECT_EQ(Distance(seg, CVec2d(2, 0)), 0.0);
  EXPECT_EQ(Distance(spot, CVec2d(4, 5)), 5.0);
  EXPECT_EQ(Distance(MakeShapeGeometry(CCircleDesc({1, 0}, 2)), CVec2d(1, 0)), 2.0); // the centre
}

// ---- Known answers: what overlaps at the start, what a turning blade presses; and along parabolas tangents,
// and what touches at the start. Times of impact that are hard are among the hard cases.

using CBalld = CSweptBall<double>;

struct CFound {
  bool m_bMet;
  CHit<double> m_cHit;
};

CFound Shoot(const CAnyShapeDesc& desc, const CBalld& ball, double tMax) {
  CFound result;
  result.m_bMet = Sweep(MakeShapeGeometry(desc), ball, tMax, result.m_cHit);
  return result;
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

CFound Throw(const CAnyShapeDesc& desc, const CVec2d& p, const CVec2d& v, double r, double tMax = 10,
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
      const CFound rests = Throw(floor, {0, .5 - depth}, {0, 0}, .5);
      ASSERT_TRUE(rests.m_bMet);
      EXPECT_EQ(rests.m_cHit.m_fTime, 0);
      EXPECT_TRUE(rests.m_cHit.m_bBegins);
      EXPECT_NEAR(rests.m_cHit.m_fDepth, depth, 1e-15);
      EXPECT_EQ(rests.m_cHit.m_bOverlapped, depth > 0);
      if (depth < .1) continue;
      const CFound leaves = Throw(floor, {0, .5 - depth}, {0, .8}, .5); // .04 up, in .1
      ASSERT_TRUE(leaves.m_bMet);
      EXPECT_NEAR(leaves.m_cHit.m_fTime, .1, 1e-14);
      EXPECT_NEAR(leaves.m_cHit.m_fDepth, .085, 1e-14);
      // High enough it comes back from clear.
      const CFound clear = Throw(floor, {0, .5 - depth}, {0, 4}, .5);
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
      const CFound hop = Throw(floor, {0, .5 + 4 * g_fEps}, {0, v}, .5);
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
