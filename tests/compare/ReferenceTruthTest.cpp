// SPDX-License-Identifier: MIT
// The exact reference against what is known in closed form: collision counts, cradles, and the time at
// which a bouncing ball comes to rest. Each has a control that breaks what it rests on.
#include "Random.h"
#include "ReferenceTesting.h"

#include <utility>

namespace Shapes::Compare::Tests {
namespace {

using Shapes::Tests::CRandom;

// A wall at x = 0, a ball of mass 1 at rest, and one of mass `ratio` that comes with speed 1 from the right.
CExact WallAndTwoBalls(double ratio, float e = 1) {
  return Make({Wall({0, -1}, {0, 1})},
              {CDynamicCircleDesc({1, 0}, .125f, {0, 0}, 1, e),
               CDynamicCircleDesc({2, 0}, .125f, {-1, 0}, static_cast<float>(ratio))});
}

// G. Galperin, Playing pool with pi, Regular and Chaotic Dynamics 8 (2003): the number of hits is the number
// of multiples of theta = arctan(1 / sqrt(ratio)) below pi. In the plane of (v1, sqrt(ratio) v2) each hit of
// the balls is a reflection, and with the next hit of the wall a turn by 2 theta; so after the j-th hit of
// the balls the heavy one has the velocity -cos(2 j theta).
//
// The order of the hits is fixed, so only the directions err: by some roundings a hit, pi sqrt(ratio) hits.
// The count is safe as long as that is less than what pi lacks to the next multiple, a share of theta. For
// ratios of 100^n this is 10^2n pi eps < .07 (the share is .14, .41, .59, .93, .93 for n = 0 .. 4), n <= 6.
// The float mass is exact up to n = 5.
class CPoolWithPi : public testing::TestWithParam<int> {};

TEST_P(CPoolWithPi, CountsTheDigits) {
  const int n = GetParam();
  const std::size_t expected[] = {3, 31, 314, 3141, 31415};
  const double ratio = std::pow(100, n), theta = std::atan(1 / std::sqrt(ratio));
  CExact reference = WallAndTwoBalls(ratio);
  const CEvents events = Carry(reference, 20);
  ASSERT_EQ(events.size(), expected[n]);
  EXPECT_EQ(reference.GetSlideCount(), 0u);
  const double bound = 8 * g_fEps * static_cast<double>(events.size()); // of the direction
  EXPECT_NEAR(Energy(reference) / (.5 * ratio), 1, 2 * bound);
  int pairs = 0;
  double before = -1, worst = 0; // of the heavy ball
  for (std::size_t k = 0; k < events.size(); ++k) {
    ASSERT_EQ(events[k].m_bIsBall, k % 2 == 0) << "hit " << k; // they take turns
    if (!events[k].m_bIsBall) continue;
    worst = std::max(worst, std::abs(events[k].m_vSurface.x() - before));
    before = -std::cos(2 * ++pairs * theta);
  }
  worst = std::max(worst, std::abs(reference.GetBall(1).m_vVel.x() - before));
  EXPECT_LE(worst, bound);
}

// The same by velocities alone: who approaches whom. Hits of the balls and of the wall take turns.
std::size_t CountHits(double ratio, double e) {
  double light = 0, heavy = -1;
  for (std::size_t hits = 0;;) {
    if (heavy < light) {
      const double kick = (1 + e) * (light - heavy) / (ratio + 1);
      light -= kick * ratio;
      heavy += kick;
      ++hits;
    }
    if (light < 0) {
      light *= -e;
      ++hits;
    }
    if (heavy >= light) return hits;
  }
}

TEST_P(CPoolWithPi, OtherMassesAndLossesCountOtherwise) { // control
  const int n = GetParam();
  const double right = std::pow(100, n), wrong = .7 * right;
  // Much more loss than this, and the heavy ball presses the light one onto the wall.
  const float loss = 2 / static_cast<float>(std::numbers::pi * std::pow(10, n));
  // Hits with a loss must not come within g_fClose of a step.
  const auto count = [](CExact reference) { return Carry(reference, .5, 40).size(); };
  const std::size_t hits = CountHits(right, 1), others = CountHits(wrong, 1);
  const std::size_t lossy = CountHits(right, static_cast<double>(1 - loss));
  EXPECT_EQ(count(WallAndTwoBalls(right)), hits);
  EXPECT_EQ(count(WallAndTwoBalls(wrong)), others);
  EXPECT_EQ(count(WallAndTwoBalls(right, 1 - loss)), lossy);
  EXPECT_NE(lossy, hits);
  if (n > 0) { // .7 has 3 hits too
    EXPECT_NE(others, hits);
  }
}

INSTANTIATE_TEST_SUITE_P(Reference, CPoolWithPi, testing::Range(0, 5));

// Balls on a line, of diameter 1/4 and equal masses, exchange their velocities: what moves on is the
// velocity. Seen so, velocity i starts at x_i - i / 4 and goes straight, and each crossing of two is a hit.
struct CLineOfBalls {
  CBalls m_stdBalls;
  std::vector<double> m_stdTimes; // of the crossings, ascending
};

CLineOfBalls RandomLine(CRandom& random, int n) {
  std::vector<int> order;
  for (int i = 0; i < n; ++i)
    order.push_back(i);
  for (std::uint32_t i = static_cast<std::uint32_t>(n); i > 1; --i)
    std::swap(order[i - 1], order[random.Below(i)]);
  CLineOfBalls line;
  std::vector<double> start, speed;
  float x = 0;
  for (const int rank : order) {
    x += random.Uniform(.3f, 2);
    const float v = static_cast<float>(rank) + random.Uniform(-.4f, .4f); // .2 apart at least
    line.m_stdBalls.emplace_back(Vector2(x, 0), .125f, Vector2(v, 0));
    start.push_back(static_cast<double>(x) - .25 * static_cast<double>(start.size()));
    speed.push_back(static_cast<double>(v));
  }
  for (std::size_t j = 0; j < start.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (speed[i] > speed[j]) line.m_stdTimes.push_back((start[j] - start[i]) / (speed[i] - speed[j]));
  std::sort(line.m_stdTimes.begin(), line.m_stdTimes.end());
  return line;
}

TEST(ReferenceTruth, HitsOnALineAreInversions) {
  CRandom random(1203);
  double worst = 0;
  int unlike = 0;
  for (int n = 2; n <= 12; ++n)
    for (int trial = 0; trial < 40; ++trial) {
      SCOPED_TRACE("seed 1203, " + std::to_string(n) + " balls, trial " + std::to_string(trial));
      CLineOfBalls line = RandomLine(random, n);
      if (trial == 0) { // the most: all against each other
        std::vector<float> speeds;
        for (const CDynamicCircleDesc& ball : line.m_stdBalls)
          speeds.push_back(ball.m_vVel.x());
        std::sort(speeds.rbegin(), speeds.rend());
        for (std::size_t i = 0; i < speeds.size(); ++i)
          line.m_stdBalls[i].m_vVel.x() = speeds[i];
        CExact reference = Make({}, line.m_stdBalls);
        EXPECT_EQ(Carry(reference, 200).size(), static_cast<std::size_t>(n * (n - 1) / 2));
        continue;
      }
      CExact reference = Make({}, line.m_stdBalls);
      const double energy = Energy(reference), momentum = Momentum(reference).x();
      const CEvents events = Carry(reference, 200); // the last crossing comes before 24 / .2 seconds
      ASSERT_EQ(events.size(), line.m_stdTimes.size());
      // A velocity errs by a few eps of the largest, 12, and that over 120 s, at a least approach of .2.
      for (std::size_t k = 0; k < events.size(); ++k)
        worst = std::max(worst, std::abs(events[k].m_fTime - line.m_stdTimes[k]));
      const double bound = 8 * g_fEps * static_cast<double>(events.size() + 1);
      EXPECT_NEAR(Energy(reference), energy, bound * energy);
      EXPECT_NEAR(Momentum(reference).x(), momentum, bound * 12 * n);
      // Control: one ball of another mass, or a loss, and the crossings are others.
      line.m_stdBalls[1].m_fMass = 3;
      CExact heavy = Make({}, line.m_stdBalls);
      unlike += Carry(heavy, 200).size() != events.size();
    }
  EXPECT_LE(worst, 1e-10);
  EXPECT_GT(unlike, 100);
}

// As many as come in go out, with the whole speed: k (5 - k) hits. Every velocity goes from ball to ball
// unchanged but for two roundings a hit.
TEST(ReferenceTruth, CradlePassesOnWhatComesIn) {
  for (const double gap : {1e-2, 1e-5, 1e-8, 0.0})
    for (std::size_t k = 1; k <= 4; ++k)
      for (const float middle : {1.0f, 2.0f}) { // a heavier ball in the middle is the control
        SCOPED_TRACE(testing::Message() << "gap " << gap << ", " << k);
        CBalls balls(5, CDynamicCircleDesc({0, 0}, .5f));
        balls[2].m_fMass = middle;
        CExact reference = Make({}, balls);
        for (std::size_t i = 0; i < 5; ++i)
          reference.SetBall(i, {static_cast<double>(i) * (1 + gap) - (i < k ? 1.0 : 0.0), 0},
                            {i < k ? 1.0 : 0.0, 0});
        const double energy = Energy(reference), momentum = Momentum(reference).x();
        const std::size_t hits = Carry(reference, 4).size();
        const double bound = 4 * g_fEps * static_cast<double>(hits);
        EXPECT_NEAR(Energy(reference), energy, bound * energy);
        EXPECT_NEAR(Momentum(reference).x(), momentum, bound * momentum);
        double worst = 0;
        for (std::size_t i = 0; i < 5; ++i)
          worst = std::max(worst, (reference.GetBall(i).m_vVel - CVec2d(i >= 5 - k ? 1 : 0, 0)).norm());
        if (middle == 1) {
          EXPECT_EQ(hits, k * (5 - k));
          EXPECT_LE(worst, bound);
        } else {
          EXPECT_GT(worst, .1);
        }
      }
}

// A ball that falls from the height h falls for t0 = sqrt(2 h / g), and hop k after that lasts 2 t0 e^k: the
// bounces are at t0 (1 + 2 e + ... + 2 e^k), and it lies still at t0 (1 + e) / (1 - e). For h = 1, g = 9.81
// and e = .5 that is 3 sqrt(2 / 9.81) = 1.354570923 seconds. Gravity is a float, so the height takes up its
// rounding: only the ratio counts.
TEST(ReferenceTruth, BouncingBallComesToRestHoweverTimeIsCutIntoSteps) {
  const double t0 = std::sqrt(2 / 9.81), seconds = 2;
  for (const float e : {.5f, .25f, .625f})
    for (const int steps : {1, 120}) {
      SCOPED_TRACE(testing::Message() << e << ", " << steps << " steps");
      const double loss = static_cast<double>(e), rest = t0 * (1 + loss) / (1 - loss), dt = seconds / steps;
      CExact reference =
          MakeOne({Wall({-1, 0}, {1, 0}, e)}, .125f, {0, .125 + g_fPull / 9.81}, {0, 0}, g_vPull);
      double t = t0, hop = 2 * t0, last = 0;
      std::size_t bounces = 0;
      for (int k = 0; k < steps; ++k)
        for (const CExactEvent<double>& event : Carry(reference, dt)) {
          last = k * dt + event.m_fTime;
          // The sweep errs by 16 roundings of the size, 1, over the approach speed, g hop / 2.
          EXPECT_NEAR(last, t, 1e-15 / hop + 1e-15);
          hop *= loss;
          t += hop;
          ++bounces;
        }
      EXPECT_GT(bounces, 10u);
      // It is put to rest when hops last less than g_fClose of the step.
      EXPECT_NEAR(last, rest, seconds * g_fClose / (1 - loss));
      EXPECT_EQ(reference.GetRestCount() == 1u, steps == 1); // once a step
      EXPECT_EQ(reference.GetSlideCount(), 0u);
      EXPECT_EQ(reference.GetBall(0).m_vVel, CVec2d(0, 0));
      EXPECT_NEAR(reference.GetBall(0).m_vPos.y(), .125, 1e-14);
      EXPECT_EQ(e == .5f, std::abs(last - 1.354570923) < 1e-9); // control: the others
    }
}

} // namespace
} // namespace Shapes::Compare::Tests
