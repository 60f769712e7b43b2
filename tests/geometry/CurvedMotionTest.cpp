// SPDX-License-Identifier: MIT
// Sweeps against shapes that turn: where they begin, and how long they take.
#include "ImpactTesting.h"

namespace Shapes::Geometry {
namespace {

// The same shape, turned before.
TEST(SweepTurning, TheLegMayBeginLater) {
  int hits = 0;
  ForEachCase(63, 2000, [&](CRandom& random, int) {
    const CTrial trial = ClearTrial(random, g_eTypes[random.Below(4)], eSides::Both, true);
    const double start = random.Unit();
    CImpact later, turned;
    const eSweep found = Sweep(trial.m_cShape, trial.m_cMotion, start, later);
    ASSERT_EQ(found, Sweep(RotatedFor(trial.m_cShape, start), trial.m_cMotion, 0.0, turned));
    if (found != eSweep::Impact) return;
    ++hits;
    ASSERT_EQ(later.m_fTime, turned.m_fTime);
    ASSERT_EQ(later.m_vPOI, turned.m_vPOI);
    ASSERT_EQ(later.m_vNorm, turned.m_vNorm);
  });
  EXPECT_GT(hits, 400);
}

// A paddle at rest at first, with its end 1 unit from the axis, comes down on a ball that lies there.
TEST(SweepTurning, APaddleComesDownOnABall) {
  const double w = -2.0, r = 0.125;
  const CShapeGeometry paddle = MakeShapeGeometry(CKinematicLineSeg(CLineSegDesc({0, 0}, {1, 0})), w);
  // The line is r from the centre when it is asin(r / distance) short of the direction of the centre.
  const Vector2d p(0.5, -0.5);
  const double distance = p.norm(), angle = -std::numbers::pi / 4 + std::asin(r / distance);
  CImpact impact;
  ASSERT_EQ(Sweep(paddle, {p, Vector2d::Zero(), r, 1.0}, 0.0, impact), eSweep::Impact);
  EXPECT_NEAR(impact.m_fTime, angle / w, 80 * 0x1p-52);
  EXPECT_NEAR(std::atan2(impact.m_vNorm.y(), impact.m_vNorm.x()), angle - std::numbers::pi / 2, 1e-14);
  const double along = std::sqrt(distance * distance - r * r);
  EXPECT_NEAR(impact.m_vSurface.dot(impact.m_vNorm), -w * along, 1e-14);
  // A ball that is slower than the paddle is met again at once, one that is as fast soon, because the paddle
  // turns on. From a faster one the gap opens for long: 2 u / m_fCurve at least, where the curve is that of
  // its own speed.
  const auto whenAgain = [&](double share) {
    CImpact again;
    const CMotion motion{p, share * impact.m_vSurface, r, 1.0};
    return Sweep(paddle, motion, impact.m_fTime, again) == eSweep::Impact ? again.m_fTime : 1.0;
  };
  EXPECT_EQ(whenAgain(0.9), 0.0);
  EXPECT_LT(whenAgain(1.0), 1e-6);
  EXPECT_GE(whenAgain(1.5), 2.0 * 0.5 * -w * along / (1.5 * impact.m_fCurve));
  EXPECT_GT(impact.m_fCurve, 0.0);
}

// A ball that lies on a drum which turns about its own centre, for all gaps down to none, is followed by few
// steps: their number would be Unknown if it grew with the smallness of the gap.
TEST(SweepTurning, ABallBesideATurningDrumIsQuick) {
  const CShapeGeometry drum = MakeShapeGeometry(CKinematicArc(CArcDesc({0, 0}, 0.5f, 0.5f, 6.0f)), 50.0);
  for (double gap = 1e-3; gap > 1e-18; gap /= 8.0)
    for (const double side : {1.0, -1.0})
      for (const double speed : {0.0, 1e-6}) {
        const Vector2d p(0.0, 0.5 + side * (0.1 + gap)), v(speed, 0.0);
        CImpact impact;
        const eSweep found = Sweep(drum, {p, v, 0.1, 0.001}, 0.0, impact);
        EXPECT_NE(found, eSweep::OutOfIterations) << "gap " << gap << " side " << side;
      }
}

// It touches that all the time, and comes no nearer: a look at it in each rounding would take 4,096 steps.
TEST(SweepTurning, ABallAtTheEndAboutWhichAFlipperTurnsIsQuick) {
  const CShapeGeometry flipper = MakeShapeGeometry(CKinematicLineSeg(CLineSegDesc({0, 0}, {2, 0})), 19.0);
  for (double angle = 2.0; angle < 4.3; angle += 0.1) {
    const Vector2d p = 0.15 * Vector2d(std::cos(angle), std::sin(angle));
    CImpact impact;
    EXPECT_EQ(Sweep(flipper, {p, Vector2d::Zero(), 0.15, 0.007}, 0.0, impact), eSweep::None) << angle;
  }
}

// A shape that turns billions of times is not looked at to the end, but nothing is missed before that:
// motions that begin where one was left come to the same impact.
TEST(SweepTurning, WhatIsNotKnownIsSaid) {
  const CKinematicLineSeg spinner(CLineSegDesc({-0.5f, 0}, {0.5f, 0}));
  CImpact impact;
  const double r = 0.1;
  // From 3 units away the ball comes to the circle of the spinner 2.4 seconds later.
  const CShapeGeometry fastest = MakeShapeGeometry(spinner, 6e9);
  ASSERT_EQ(Sweep(fastest, {{3, 0}, {-1, 0}, r, 10.0}, 0.0, impact), eSweep::OutOfIterations);
  EXPECT_GT(impact.m_fTime, 0.0);
  EXPECT_LT(impact.m_fTime, 2.4 + 1e-6);

  const CShapeGeometry fast = MakeShapeGeometry(spinner, 6e4);
  double t = 0.0;
  int motions = 0;
  eSweep found;
  do {
    found = Sweep(fast, {{3.0 - t, 0}, {-1, 0}, r, 10.0 - t}, t, impact);
    ASSERT_GT(impact.m_fTime, 0.0);
    t += impact.m_fTime;
  } while (found == eSweep::OutOfIterations && ++motions < 100000);
  EXPECT_EQ(found, eSweep::Impact);
  EXPECT_GT(motions, 1);
  EXPECT_NEAR(t, 2.4, 1.1e-4); // within the turn in which it comes there
  RecordProperty("motions", motions);
}

} // namespace
} // namespace Shapes::Geometry
