// SPDX-License-Identifier: MIT
// The exact reference in billiards, against their mean free paths.
#include "Random.h"
#include "ReferenceTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

namespace Shapes::Compare::Tests {
namespace {

using Shapes::Tests::CRandom;

// The mean free path of a billiard is pi A / P (N. Chernov, Entropy, Lyapunov exponents, and mean free path
// for billiards, Journal of Statistical Physics 88 (1997)), where A and P are area and perimeter of what the
// centre of the ball can reach: a ball of radius r is a point between walls that have come closer by r.
struct CBilliard {
  const char* m_sName;
  double (*m_pArea)(double r);
  double (*m_pPerimeter)(double r);
  CShapes m_stdShapes;
  float m_fRadius; ///< of the ball
  CVec2d m_vLow;   ///< Box of the table.
  CVec2d m_vHigh;
  bool (*m_pIsFree)(const CVec2d& p, double r); ///< In the box: whether the centre can be there.
};

void PrintTo(const CBilliard& billiard, std::ostream* pOut) { *pOut << billiard.m_sName; }

constexpr double g_fPi = std::numbers::pi;

CShapes Table(float w, float h, const CShapes& others = {}) {
  CShapes shapes = Box({0, 0}, {w, h});
  shapes.insert(shapes.end(), others.begin(), others.end());
  return shapes;
}

double Between(double lo, double hi, double f) { return lo + (hi - lo) * f; }

// The ball in the corner of a square where two walls meet a quarter of a circle of radius 1/2 about (1, 1):
// the angle at which a wall is met by the circle that the centre follows.
double BiteAngle(double r) { return std::asin(r / (.5 + r)); }

// How far p is from the half circle of radius .3 about (.75, .5) that is open to the right.
double ToHook(const CVec2d& p) {
  const CVec2d d = p - CVec2d(.75, .5);
  return d.x() <= 0 ? std::abs(d.norm() - .3) : (CVec2d(d.x(), std::abs(d.y())) - CVec2d(0, .3)).norm();
}

const std::vector<CBilliard>& Billiards() {
  static const float pi = static_cast<float>(g_fPi);
  static const std::vector<CBilliard> billiards = {
      {"Rectangle", // integrable
       [](double r) { return (1.5 - 2 * r) * (1 - 2 * r); },
       [](double r) { return 5 - 8 * r; },
       Table(1.5f, 1),
       .0625f,
       {0, 0},
       {1.5, 1},
       [](const CVec2d&, double) { return true; }},
      {"Ring", // integrable
       [](double r) { return g_fPi * (1 - r) * (1 - r); },
       [](double r) { return 2 * g_fPi * (1 - r); },
       {CCircleDesc({0, 0}, 1)},
       .25f,
       {-1, -1},
       {1, 1},
       [](const CVec2d& p, double r) { return p.norm() < 1 - r; }},
      {"DiscInSquare", // Sinai's; nearly a point
       [](double r) { return (1 - 2 * r) * (1 - 2 * r) - g_fPi * (.2 + r) * (.2 + r); },
       [](double r) { return 4 - 8 * r + 2 * g_fPi * (.2 + r); },
       Table(1, 1, {CCircleDesc({.5f, .5f}, .2f)}),
       .0078125f,
       {0, 0},
       {1, 1},
       [](const CVec2d& p, double r) { return (p - CVec2d(.5, .5)).norm() > .2 + r; }},
      {"Stadium", // Bunimovich's; segments and the insides of arcs, with tangent joints
       [](double r) { return 1 - 2 * r + g_fPi * (.5 - r) * (.5 - r); },
       [](double r) { return 2 + 2 * g_fPi * (.5 - r); },
       {Wall({.5f, 0}, {1.5f, 0}), Wall({.5f, 1}, {1.5f, 1}), CArcDesc({.5f, .5f}, .5f, pi / 2, 3 * pi / 2),
        CArcDesc({1.5f, .5f}, .5f, 3 * pi / 2, pi / 2)},
       .125f,
       {0, 0},
       {2, 1},
       [](const CVec2d& p, double r) {
         return (p - CVec2d(std::clamp(p.x(), .5, 1.5), .5)).norm() < .5 - r;
       }},
      {"BittenSquare", // the outside of an arc
       [](double r) {
         const double R = .5 + r, a = BiteAngle(r);
         return (1 - 2 * r) * (1 - 2 * r) - R * R * (g_fPi / 4 - a) + r * (R * std::cos(a) - r);
       },
       [](double r) {
         const double R = .5 + r, a = BiteAngle(r);
         return 2 * (1 - 2 * r) + 2 * (1 - r - R * std::cos(a)) + R * (g_fPi / 2 - 2 * a);
       },
       {Wall({0, 0}, {1, 0}), Wall({0, 0}, {0, 1}), Wall({1, 0}, {1, .5f}), Wall({0, 1}, {.5f, 1}),
        CArcDesc({1, 1}, .5f, pi, 3 * pi / 2)},
       .0625f,
       {0, 0},
       {1, 1},
       [](const CVec2d& p, double r) { return (p - CVec2d(1, 1)).norm() > .5 + r; }},
      {"PointInRectangle",
       [](double r) { return (1.5 - 2 * r) * (1 - 2 * r) - g_fPi * r * r; },
       [](double r) { return 5 - 8 * r + 2 * g_fPi * r; },
       Table(1.5f, 1, {CPointDesc({.625f, .5f})}),
       .125f,
       {0, 0},
       {1.5, 1},
       [](const CVec2d& p, double r) { return (p - CVec2d(.625, .5)).norm() > r; }},
      {"NeedleInRectangle", // both faces and both ends of a segment
       [](double r) { return (1.5 - 2 * r) * (1 - 2 * r) - g_fPi * r * r - 2 * r * .5; },
       [](double r) { return 5 - 8 * r + 2 * g_fPi * r + 2 * .5; },
       Table(1.5f, 1, {Wall({.5f, .5f}, {1, .5f})}),
       .09375f,
       {0, 0},
       {1.5, 1},
       [](const CVec2d& p, double r) { return (p - CVec2d(std::clamp(p.x(), .5, 1.), .5)).norm() > r; }},
      {"HookInRectangle", // both faces and both ends of an arc
       [](double r) { return (1.5 - 2 * r) * (1 - 2 * r) - g_fPi * r * r - 2 * r * .3 * g_fPi; },
       [](double r) { return 5 - 8 * r + 2 * g_fPi * r + 2 * .3 * g_fPi; },
       Table(1.5f, 1, {CArcDesc({.75f, .5f}, .3f, pi / 2, 3 * pi / 2)}),
       .0625f,
       {0, 0},
       {1.5, 1},
       [](const CVec2d& p, double r) { return ToHook(p) > r; }},
      {"DiscInRing",
       [](double r) { return g_fPi * ((1 - r) * (1 - r) - (.4 + r) * (.4 + r)); },
       [](double) { return 2 * g_fPi * 1.4; },
       {CCircleDesc({0, 0}, 1), CCircleDesc({.3f, 0}, .4f)},
       .0625f,
       {-1, -1},
       {1, 1},
       [](const CVec2d& p, double r) { return p.norm() < 1 - r && (p - CVec2d(.3, 0)).norm() > .4 + r; }},
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
  const double r = static_cast<double>(b.m_fRadius);
  const auto path = [&](double radius) { return g_fPi * b.m_pArea(radius) / b.m_pPerimeter(radius); };
  const double truth = path(r), naive = path(0);
  constexpr int nBalls = 5000;
  const double length = 60 * truth;
  CRandom random(1997);
  CExact reference = Make(b.m_stdShapes, {CDynamicCircleDesc({0, 0}, b.m_fRadius)});
  double sum = 0, squares = 0;
  for (int k = 0; k < nBalls; ++k) {
    SCOPED_TRACE("seed 1997 ball " + std::to_string(k));
    CVec2d p;
    do {
      p.x() = Between(b.m_vLow.x() + r, b.m_vHigh.x() - r, random.Unit());
      p.y() = Between(b.m_vLow.y() + r, b.m_vHigh.y() - r, random.Unit());
    } while (!b.m_pIsFree(p, r));
    const CVec2d v = Unit(ToDouble(random.Direction()), CVec2d(1, 0));
    reference.SetBall(0, p, v);
    const CEvents events = Carry(reference, length);
    const double hits = static_cast<double>(events.size()), bound = 8 * g_fEps * hits;
    sum += hits;
    squares += hits * hits;
    const CVec2d end = reference.GetBall(0).m_vPos;
    ASSERT_NEAR(reference.GetBall(0).m_vVel.norm(), 1, bound);
    ASSERT_TRUE(b.m_pIsFree(end, r - 1e-6) &&
                (end - b.m_vLow).minCoeff() > r - 1e-6 && // the shapes are floats
                (b.m_vHigh - end).minCoeff() > r - 1e-6);
    ASSERT_FALSE(std::any_of(events.begin(), events.end(), [](const auto& e) { return e.m_bOverlapped; }));
  }
  const double mean = sum / nBalls, variance = (squares / nBalls - mean * mean) * nBalls / (nBalls - 1);
  const double measured = length / mean, error = measured * std::sqrt(variance / nBalls) / mean;
  RecordProperty("result", Text(measured) + " +- " + Text(error) + ", pi A / P " + Text(truth) +
                               ", without the radius " + Text(naive) + ", bounces " + Text(sum));
  EXPECT_GE(sum, 1e5);
  EXPECT_NEAR(measured, truth, 3 * error) << "seed 1997";
  EXPECT_GT(std::abs(measured - naive), 6 * error); // control: the table of a point
  EXPECT_EQ(reference.GetSlideCount(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Reference, CMeanFreePath, testing::ValuesIn(Billiards()),
                         [](const auto& billiard) { return std::string(billiard.param.m_sName); });

TEST(MeanFreePath, OfThePublishedExample) {
  const auto it = std::find_if(Billiards().begin(), Billiards().end(),
                               [](const CBilliard& b) { return std::string(b.m_sName) == "DiscInSquare"; });
  EXPECT_NEAR(g_fPi * it->m_pArea(0) / it->m_pPerimeter(0), .522541, 5e-7);
}

} // namespace
} // namespace Shapes::Compare::Tests
