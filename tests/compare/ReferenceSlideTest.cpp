// SPDX-License-Identifier: MIT
// The exact reference where balls slide: along curves, on what turns or moves, and on each other.
#include "ReferenceTesting.h"
#include "reference/Scalar.h"

namespace Shapes::Compare::Tests {
namespace {

// The period of a pendulum of this length and amplitude: 4 sqrt(L / g) K(sin(a / 2)), and K by the mean of
// Gauss.
double Period(double length, double amplitude) {
  double a = 1, b = std::cos(amplitude / 2);
  while (std::abs(a - b) > 1e-15) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return 2 * std::numbers::pi * std::sqrt(length / g_fPull) / a;
}

// After ten periods and a quarter it is at the bottom again: how far off, in periods a period. The ring moves
// with `speed`.
double PeriodError(double amplitude, double told, int steps, float speed) {
  CArcDesc ring({0, 0}, 1, 0, 0, .5f);
  if (speed != 0) ring = Moving(ring, {speed, 0});
  const double r = .25, L = 1 - r, T = Period(L, told), u = static_cast<double>(speed);
  CExact reference =
      MakeOne({ring}, .25f, {L * std::sin(amplitude), -L * std::cos(amplitude)}, {u, 0}, g_vPull);
  EXPECT_TRUE(Carry(reference, 10.25 * T / steps, steps).empty());
  const CVec2d p = reference.GetBall(0).m_vPos - CVec2d(u * 10.25 * T, 0);
  EXPECT_NEAR(p.norm(), L, 1e-12);
  const double v = std::sqrt(2 * g_fPull * L * (1 - std::cos(amplitude)));
  return std::abs(p.x()) / v / (10.25 * T);
}

TEST(ReferenceSlide, BallInARingHasThePeriodOfThePendulum) {
  double worst = 0;
  for (int k = 1; k <= 10; ++k) {
    SCOPED_TRACE(k);
    const double a = k * 8.5 * std::numbers::pi / 180;
    for (const int steps : {1, 500})
      for (const float speed : {0.f, 2.f})
        worst = std::max(worst, PeriodError(a, a, steps, speed));
  }
  EXPECT_LE(worst, 1e-11);
  EXPECT_GT(PeriodError(.5, .5 + 1e-6, 1, 0), 1e-9); // control: another amplitude
}

// It lets go where the reaction is 0: v^2 = g L cos, and v^2 / 2 = g L (cos0 - cos). In flight v_x stays, and
// is sqrt(g L cos) cos there.
TEST(ReferenceSlide, BallLeavesACylinderAtTwoThirds) {
  const double L = 1.25;
  for (const double start : {1e-6, .01, .1, .5}) {
    SCOPED_TRACE(start);
    for (const bool disk : {true, false}) {
      const CAnyShapeDesc shape = disk ? CAnyShapeDesc(CCircleDesc({0, 0}, 1, .5f))
                                       : CAnyShapeDesc(CArcDesc({0, 0}, 1, 0, 3.2f, .5f));
      CExact reference = MakeOne({shape}, .25f, {L * std::sin(start), L * std::cos(start)}, {0, 0}, g_vPull);
      while (reference.GetBall(0).m_vPos.y() > -1)
        ASSERT_TRUE(Carry(reference, 1.0 / 64).empty());
      const double cosine = std::cbrt(std::pow(reference.GetBall(0).m_vVel.x(), 2) / (g_fPull * L));
      EXPECT_NEAR(cosine, 2.0 / 3 * std::cos(start), 1e-12);
      if (start > .001) { // control: as if from the very top
        EXPECT_GT(std::abs(cosine - 2.0 / 3), 1e-5);
      }
    }
  }
}

// Down a line, through an arc and up another line, all tangent to each other: the ends of this arc are places
// of floats.
TEST(ReferenceSlide, ChuteGivesTheSpeedOfItsHeight) {
  const float left = std::atan2(-15.f, -8.f), right = std::atan2(-15.f, 8.f);
  for (const float kink : {0.f, 1.f}) { // control: a joint that is not smooth
    const CShapes chute = {Wall({-38, 1}, {-8, -15}, 0), CArcDesc({0, 0}, 17, left, right, 0),
                           Wall({8, -15}, {38, 1 + kink}, 0)};
    for (const int steps : {1, 240}) {
      const CVec2d from = CVec2d(-23, -7) + .25 / 17 * CVec2d(8, 15);
      CExact reference = MakeOne(chute, .25f, from, {0, 0}, g_vPull);
      std::size_t hits = Carry(reference, 2.0 / steps, steps).size(); // still on the first line
      const CVec2d way = 2 * g_fPull * 8 / 17 * CVec2d(15, -8) / 17;
      EXPECT_NEAR((reference.GetBall(0).m_vPos - from - way).norm(), 0, 1e-12);
      EXPECT_EQ(reference.GetSlideCount(), 0u); // a parabola
      hits += Carry(reference, 3.0 / steps, steps).size();
      const CExactBall<double>& ball = reference.GetBall(0);
      EXPECT_GT(ball.m_vPos.x(), 8);
      EXPECT_LE(hits, 1u);
      const double speed = std::sqrt(2 * g_fPull * (from.y() - ball.m_vPos.y()));
      const CVec2d up = CVec2d(15, 8) / 17;
      EXPECT_EQ(kink == 0, (ball.m_vVel - speed * up).norm() <= 1e-12 * speed)
          << (ball.m_vVel - speed * up).norm() / speed;
    }
  }
}

// On a segment that turns about the origin with w the distance s from there obeys s'' = w^2 s - g sin(w t):
// s = s0 cosh(w t) + g / (2 w^2) (sin(w t) - sinh(w t)) from rest.
TEST(ReferenceSlide, BallOnATurningSegmentFollowsItsClosedForm) {
  const double w = 2 * std::numbers::pi * .25, s0 = 1, h = .25;
  for (const int steps : {1, 40}) {
    CExact reference =
        MakeOne({Turning(Wall({-4, 0}, {4, 0}, .5f), .25f)}, .25f, {s0, h}, {-w * h, w * s0}, g_vPull);
    EXPECT_TRUE(Carry(reference, .5 / steps, steps).empty());
    const double t = .5, a = w * t, k = g_fPull / (2 * w * w);
    const double s = s0 * std::cosh(a) + k * (std::sin(a) - std::sinh(a));
    const CVec2d along(std::cos(a), std::sin(a));
    const auto off = [&](double at) {
      return (reference.GetBall(0).m_vPos - at * along - h * Perp(along)).norm();
    };
    EXPECT_LE(off(s), 1e-13);
    EXPECT_GT(off(s + k * (a - std::sin(a)) * 1e-6), 1e-8); // control: a little more gravity
    EXPECT_EQ(reference.GetRestCount(), 0u);
  }
}

// In a ring that turns about a centre aside, with w, u^2 / 2 - w^2 d^2 / 2 stays: u is the velocity as seen
// from the ring, d the distance from the centre of rotation.
TEST(ReferenceSlide, TurningRingKeepsTheJacobiIntegral) {
  const CShapes shapes = {Turning(CArcDesc({1.5f, 0}, 1, 0, 0, .5f), .5f)};
  const CBalls balls = {CDynamicCircleDesc({9, 0}, .25f)};
  CExact reference = Make(shapes, balls);
  CReference<CFifty> fine(shapes, balls, Vector2::Zero());
  const double w = std::numbers::pi;
  const auto jacobi = [&](double speed) {
    const CExactBall<double>& ball = reference.GetBall(0);
    const CVec2d u = ball.m_vVel - speed * Perp(ball.m_vPos);
    return .5 * u.squaredNorm() - .5 * speed * speed * ball.m_vPos.squaredNorm();
  };
  const CVec2d p(2.25, 0), v(0, w * 2.25 + 3);
  reference.SetBall(0, p, v);
  fine.SetBall(0, p.cast<CFifty>(), v.cast<CFifty>());
  const double before = jacobi(w), other = jacobi(w * 1.001);
  EXPECT_TRUE(Carry(reference, .025, 80).empty());
  EXPECT_NEAR(jacobi(w), before, 1e-12 * std::abs(before) + 1e-12);
  EXPECT_GT(std::abs(jacobi(w * 1.001) - other), 1e-6); // control: another speed of rotation
  Carry(fine, .25, 8);
  const CVec2d center = reference.GetGeometry(0).m_vCenter;
  EXPECT_NEAR((reference.GetBall(0).m_vPos - center).norm(), .75, 1e-13);
  const CVec<CFifty> d = reference.GetBall(0).m_vPos.cast<CFifty>() - fine.GetBall(0).m_vPos;
  EXPECT_LE(static_cast<double>(Norm(d)), 1e-11);
}

// Balls that slide on each other keep their energy, and on a level floor their momentum along it.
TEST(ReferenceSlide, BallSlidesOffABall) {
  for (const float e : {0.f, .5f}) {
    CExact reference =
        Make({Wall({-20, 0}, {20, 0}, e)},
             {CDynamicCircleDesc({0, .25f}, .25f, {0, 0}, 3), CDynamicCircleDesc({1, 1}, .25f)}, g_vPull);
    const CVec2d top = CVec2d(0, .25) + .5 * CVec2d(.28, .96);
    reference.SetBall(1, top, {0, 0});
    const double before = Energy(reference, g_fPull), apart = .5;
    CEvents events;
    double time = 0, left = 0;
    while (events.empty()) {
      reference.Step(1.0 / 64, events);
      time += 1.0 / 64;
      if (!events.empty()) break;
      EXPECT_NEAR(Energy(reference, g_fPull), before, 1e-13 * before);
      EXPECT_NEAR(Momentum(reference).x(), 0, 1e-13);
      const double d = (reference.GetBall(0).m_vPos - reference.GetBall(1).m_vPos).norm();
      EXPECT_GE(d, apart - 1e-14);
      if (d > apart + 1e-9 && left == 0) left = time;
    }
    EXPECT_EQ(events[0].m_nBall, 1u); // on the floor
    EXPECT_FALSE(events[0].m_bIsBall);
    EXPECT_GT(left, .1);
    EXPECT_LT(left, time);
    EXPECT_GT(reference.GetBall(0).m_vVel.x(), -2);
    EXPECT_LT(reference.GetBall(0).m_vVel.x(), -.1);
  }
}

// Four balls in a row down one wall of a right-angled wedge: each presses on that wall with cos of its
// weight, on the next with sin of all above it, and the last on the other wall with sin of all.
TEST(ReferenceSlide, ARowInAWedgeHasTheForcesOfStatics) {
  const CVec2d up(-.8, .6), n(.6, .8);
  const float masses[] = {3, 1, .25f, 5};
  CBalls balls;
  for (const float m : masses)
    balls.emplace_back(CDynamicCircleDesc({9, 9}, .25f, {0, 0}, m, .5f));
  CExact reference = Make({Wall({-8, 6}, {0, 0}, .5f), Wall({0, 0}, {6, 8}, .5f)}, balls, g_vPull);
  for (std::size_t i = 0; i < 4; ++i)
    reference.SetBall(i, .25 * n + (.25 + .5 * static_cast<double>(i)) * up, {0, 0});
  EXPECT_TRUE(Carry(reference, .25, 8).empty());
  double above = 0;
  for (std::size_t i = 4; i-- > 0;) {
    const double weight = g_fPull * static_cast<double>(masses[i]);
    if (i < 3) {
      EXPECT_NEAR(reference.GetForce(i, i + 1, true), .6 * above, 1e-12 * above) << i;
    }
    EXPECT_NEAR(reference.GetForce(i, 0), .8 * weight, 1e-12 * weight) << i;
    above += weight;
    EXPECT_NEAR(reference.GetBall(i).m_vVel.norm(), 0, 1e-12);
  }
  EXPECT_NEAR(reference.GetForce(0, 1), .6 * above, 1e-12 * above);
  EXPECT_GT(std::abs(reference.GetForce(0, 1) - .6 * (above - 9.81 * .25)), .1); // control: one ball less
  EXPECT_EQ(reference.GetForce(1, 1), 0);

  // Two in a symmetric one: weight / cos on the walls, weight tan between them.
  CExact two = Make({Wall({-2, 2}, {0, 0}, .5f), Wall({0, 0}, {2, 2}, .5f)},
                    {CDynamicCircleDesc({9, 9}, .25f), CDynamicCircleDesc({-9, 9}, .25f)}, g_vPull);
  const double y = .25 + .25 * std::sqrt(2.0);
  two.SetBall(0, {-.25, y}, {0, 0});
  two.SetBall(1, {.25, y}, {0, 0});
  EXPECT_TRUE(Carry(two, .25, 8).empty());
  EXPECT_NEAR(two.GetForce(0, 0), g_fPull * std::sqrt(2.0), 1e-12 * g_fPull);
  EXPECT_NEAR(two.GetForce(1, 1), g_fPull * std::sqrt(2.0), 1e-12 * g_fPull);
  EXPECT_NEAR(two.GetForce(0, 1, true), g_fPull, 1e-12 * g_fPull);
}

// A slow ball beside an arc that turns about its own centre stays at the distance of its circle all the time.
TEST(ReferenceSlide, BallBesideATurningArcIsLeftAlone) {
  for (const double gap : {0.0, 1e-14, -.125}) // the last one, control: an end comes round and hits it
    for (const double v : {0.0, 1e-9, 1e-13}) {
      SCOPED_TRACE(testing::Message() << "gap " << gap << ", " << v);
      const CVec2d p = (1.25 + gap) * CVec2d(std::cos(3.0), std::sin(3.0));
      CExact reference = MakeOne({Turning(CArcDesc({0, 0}, 1, 0, 2), 1)}, .25f, p, v * Perp(p));
      const std::size_t hits = Carry(reference, 1).size();
      if (gap < 0) {
        EXPECT_GT(hits, 0u);
        EXPECT_GT((reference.GetBall(0).m_vPos - p).norm(), .1);
      } else {
        EXPECT_LE((reference.GetBall(0).m_vPos - p).norm(), 1e-5);
      }
    }
}

} // namespace
} // namespace Shapes::Compare::Tests
