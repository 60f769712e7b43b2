// SPDX-License-Identifier: MIT
// The exact reference against what is known in closed form: collision counts, cradles, the time at which a
// bouncing ball comes to rest, and mean free paths. Each has a control that breaks what it rests on.
#include "ReferenceTesting.h"

namespace Shapes::Compare::Tests {
namespace {

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
      for (const CExactEvent<double>& event : Carry(reference, dt, steps)) {
        last = event.m_fTime;
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

// ---- Billiards, against their mean free paths.

// The mean free path of a billiard is pi A / P (N. Chernov, Entropy, Lyapunov exponents, and mean free path
// for billiards, Journal of Statistical Physics 88 (1997)), where A and P are area and perimeter of what the
// centre of the ball can reach: a ball of radius r is a point between walls that have come closer by r.
struct CSize {
  double m_fArea, m_fPerimeter;
};
using CSizeOf = std::function<CSize(double r)>;

struct CBilliard {
  const char* m_sName;
  CSizeOf m_cSizeOf;
  CShapes m_stdShapes;
  float m_fRadius;                  ///< of the ball
  bool (*m_pIsIn)(const CVec2d& p); ///< Whether p is on the table, and in no circle that stands on it.
};

void PrintTo(const CBilliard& billiard, std::ostream* pOut) { *pOut << billiard.m_sName; }

constexpr double g_fPi = std::numbers::pi;

// A convex table of this size whose walls have come closer by r: `corners` is 4 of a rectangle, and pi where
// the wall is smooth (Steiner's formula, with -r).
CSizeOf Convex(double area, double perimeter, double corners) {
  return [=](double r) { return CSize{area - perimeter * r + corners * r * r, perimeter - 2 * corners * r}; };
}
// Without what stands in it and has grown by r.
CSizeOf Around(double area, double perimeter, const CSizeOf& table) {
  return [=](double r) {
    const CSize all = table(r);
    return CSize{all.m_fArea - area - perimeter * r - g_fPi * r * r,
                 all.m_fPerimeter + perimeter + 2 * g_fPi * r};
  };
}
// A square of which two walls meet a quarter of a circle of radius 1/2 about (1, 1). The ball in such a
// corner leaves the angle a of the circle that its centre follows.
CSize BittenSquare(double r) {
  const double R = .5 + r, a = std::asin(r / R);
  return {(1 - 2 * r) * (1 - 2 * r) - R * R * (g_fPi / 4 - a) + r * (R * std::cos(a) - r),
          2 * (1 - 2 * r) + 2 * (1 - r - R * std::cos(a)) + R * (g_fPi / 2 - 2 * a)};
}

// A box of this width and a height of 1.
CShapes Table(float width, const CShapes& others = {}) {
  CShapes shapes = Box({0, 0}, {width, 1});
  shapes.insert(shapes.end(), others.begin(), others.end());
  return shapes;
}

bool IsOnTable(const CVec2d& p, double width) { return p.minCoeff() > 0 && p.x() < width && p.y() < 1; }
double ToDisc(const CVec2d& p, double x, double y, double r) { return (p - CVec2d(x, y)).norm() - r; }

const std::vector<CBilliard>& Billiards() {
  static const float pi = static_cast<float>(g_fPi);
  const auto rectangle = Convex(1.5, 5, 4), ring = Convex(g_fPi, 2 * g_fPi, g_fPi);
  const auto isIn = [](const CVec2d& p) { return IsOnTable(p, 1.5); };
  static const std::vector<CBilliard> billiards = {
      // Integrable.
      CBilliard{"Rectangle", rectangle, Table(1.5f), .0625f, isIn},
      // Integrable.
      CBilliard{"Ring", ring, CShapes({CCircleDesc({0, 0}, 1)}), .25f,
                [](const CVec2d& p) { return p.norm() < 1; }},
      // Sinai's; nearly a point.
      CBilliard{"DiscInSquare", Around(.04 * g_fPi, .4 * g_fPi, Convex(1, 4, 4)),
                Table(1, {CCircleDesc({.5f, .5f}, .2f)}), .0078125f,
                [](const CVec2d& p) { return IsOnTable(p, 1) && ToDisc(p, .5, .5, .2) > 0; }},
      // Bunimovich's; segments and the insides of arcs, with tangent joints.
      CBilliard{"Stadium", Convex(1 + g_fPi / 4, 2 + g_fPi, g_fPi),
                CShapes({Wall({.5f, 0}, {1.5f, 0}), Wall({.5f, 1}, {1.5f, 1}),
                         CArcDesc({.5f, .5f}, .5f, pi / 2, 3 * pi / 2),
                         CArcDesc({1.5f, .5f}, .5f, 3 * pi / 2, pi / 2)}),
                .125f, [](const CVec2d& p) { return ToDisc(p, std::clamp(p.x(), .5, 1.5), .5, .5) < 0; }},
      // The outside of an arc.
      CBilliard{"BittenSquare", BittenSquare,
                CShapes({Wall({0, 0}, {1, 0}), Wall({0, 0}, {0, 1}), Wall({1, 0}, {1, .5f}),
                         Wall({0, 1}, {.5f, 1}), CArcDesc({1, 1}, .5f, pi, 3 * pi / 2)}),
                .0625f, [](const CVec2d& p) { return IsOnTable(p, 1) && ToDisc(p, 1, 1, .5) > 0; }},
      CBilliard{"PointInRectangle", Around(0, 0, rectangle), Table(1.5f, {CPointDesc({.625f, .5f})}), .125f,
                isIn},
      // Both faces and both ends of a segment.
      CBilliard{"NeedleInRectangle", Around(0, 2 * .5, rectangle), Table(1.5f, {Wall({.5f, .5f}, {1, .5f})}),
                .09375f, isIn},
      // Both faces and both ends of an arc.
      CBilliard{"HookInRectangle", Around(0, 2 * .3 * g_fPi, rectangle),
                Table(1.5f, {CArcDesc({.75f, .5f}, .3f, pi / 2, 3 * pi / 2)}), .0625f, isIn},
      CBilliard{"DiscInRing", Around(.16 * g_fPi, .8 * g_fPi, ring),
                CShapes({CCircleDesc({0, 0}, 1), CCircleDesc({.3f, 0}, .4f)}), .0625f,
                [](const CVec2d& p) { return p.norm() < 1 && ToDisc(p, .3, 0, .4) > 0; }},
  };
  return billiards;
}

// Successive flights correlate, over long times where a ball runs to and fro between two walls, so their
// spread says little about the error of their mean. Here many balls fly for the same time each, from places
// and directions of equal share (the measure that the flow keeps). Then the number of bounces of each is a
// draw of its own, of the exact mean (speed x time) P / (pi A), whether the billiard is chaotic or not; the
// standard error is that of the mean of these draws.
class CMeanFreePath : public testing::TestWithParam<CBilliard> {};

TEST_P(CMeanFreePath, IsPiAreaOverPerimeter) {
  const CBilliard& b = GetParam();
  const auto path = [&](double radius) {
    return g_fPi * b.m_cSizeOf(radius).m_fArea / b.m_cSizeOf(radius).m_fPerimeter;
  };
  const double truth = path(static_cast<double>(b.m_fRadius)), naive = path(0);
  if (std::string_view(b.m_sName) == "DiscInSquare") { // as published
    EXPECT_NEAR(naive, .522541, 5e-7);
  }
  constexpr int nBalls = 5000;
  const double length = 60 * truth;
  CExact reference = Make(b.m_stdShapes, {CDynamicCircleDesc({0, 0}, b.m_fRadius)});
  double sum = 0, squares = 0;
  ForEachCase(1997, nBalls, [&](CRandom& random, int) {
    const CVec2d v = Unit(ToDouble(random.Direction()), CVec2d(1, 0));
    do
      reference.SetBall(0, ToDouble(random.InSquare(2)), v);
    while (!b.m_pIsIn(reference.GetBall(0).m_vPos) || GetGap(reference, 0) < 0);
    const CEvents events = Carry(reference, length);
    const double hits = static_cast<double>(events.size()), bound = 8 * g_fEps * hits;
    sum += hits;
    squares += hits * hits;
    ASSERT_NEAR(reference.GetBall(0).m_vVel.norm(), 1, bound);
    ASSERT_TRUE(b.m_pIsIn(reference.GetBall(0).m_vPos));
    ASSERT_GT(GetGap(reference, 0), -1e-6);
    ASSERT_FALSE(std::any_of(events.begin(), events.end(), [](const auto& e) { return e.m_bOverlapped; }));
  });
  const double mean = sum / nBalls, variance = (squares / nBalls - mean * mean) * nBalls / (nBalls - 1);
  const double measured = length / mean, error = measured * std::sqrt(variance / nBalls) / mean;
  EXPECT_GE(sum, 1e5);
  EXPECT_NEAR(measured, truth, 3 * error);
  EXPECT_GT(std::abs(measured - naive), 6 * error); // control: the table of a point
  EXPECT_EQ(reference.GetSlideCount(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Reference, CMeanFreePath, testing::ValuesIn(Billiards()),
                         [](const auto& billiard) { return std::string(billiard.param.m_sName); });

} // namespace
} // namespace Shapes::Compare::Tests
