// SPDX-License-Identifier: MIT
// The exact reference in billiards, against their mean free paths.
#include "ReferenceTesting.h"
#include "geometry/Cases.h"

#include <functional>
#include <ostream>

namespace Shapes::Compare::Tests {
namespace {

using Shapes::Tests::CRandom, Shapes::Tests::ForEachCase;

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
  float m_fRadius; ///< of the ball
  CVec2d m_vLow;   ///< Box of the table.
  CVec2d m_vHigh;
  double (*m_pRoom)(const CVec2d& p); ///< In the box: how far p is from what else there is; negative outside.
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

CShapes Table(float w, float h, const CShapes& others = {}) {
  CShapes shapes = Box({0, 0}, {w, h});
  shapes.insert(shapes.end(), others.begin(), others.end());
  return shapes;
}

double Between(double lo, double hi, double f) { return lo + (hi - lo) * f; }

// How far p is from the half circle of radius .3 about (.75, .5) that is open to the right.
double ToHook(const CVec2d& p) {
  const CVec2d d = p - CVec2d(.75, .5);
  return d.x() <= 0 ? std::abs(d.norm() - .3) : (CVec2d(d.x(), std::abs(d.y())) - CVec2d(0, .3)).norm();
}
double ToDisc(const CVec2d& p, double x, double y, double r) { return (p - CVec2d(x, y)).norm() - r; }
// From a level line between two places.
double ToLine(const CVec2d& p, double x0, double x1) {
  return (p - CVec2d(std::clamp(p.x(), x0, x1), .5)).norm();
}

const std::vector<CBilliard>& Billiards() {
  static const float pi = static_cast<float>(g_fPi);
  const auto rectangle = Convex(1.5, 5, 4), ring = Convex(g_fPi, 2 * g_fPi, g_fPi);
  const CVec2d zero(0, 0), one(1, 1), wide(1.5, 1);
  static const std::vector<CBilliard> billiards = {
      // Integrable.
      CBilliard{"Rectangle", rectangle, Table(1.5f, 1), .0625f, zero, wide, [](const CVec2d&) { return 1.; }},
      // Integrable.
      CBilliard{"Ring", ring, CShapes({CCircleDesc({0, 0}, 1)}), .25f, -one, one,
                [](const CVec2d& p) { return -ToDisc(p, 0, 0, 1); }},
      // Sinai's; nearly a point.
      CBilliard{"DiscInSquare", Around(.04 * g_fPi, .4 * g_fPi, Convex(1, 4, 4)),
                Table(1, 1, {CCircleDesc({.5f, .5f}, .2f)}), .0078125f, zero, one,
                [](const CVec2d& p) { return ToDisc(p, .5, .5, .2); }},
      // Bunimovich's; segments and the insides of arcs, with tangent joints.
      CBilliard{"Stadium", Convex(1 + g_fPi / 4, 2 + g_fPi, g_fPi),
                CShapes({Wall({.5f, 0}, {1.5f, 0}), Wall({.5f, 1}, {1.5f, 1}),
                         CArcDesc({.5f, .5f}, .5f, pi / 2, 3 * pi / 2),
                         CArcDesc({1.5f, .5f}, .5f, 3 * pi / 2, pi / 2)}),
                .125f, zero, CVec2d(2, 1), [](const CVec2d& p) { return .5 - ToLine(p, .5, 1.5); }},
      // The outside of an arc.
      CBilliard{"BittenSquare", BittenSquare,
                CShapes({Wall({0, 0}, {1, 0}), Wall({0, 0}, {0, 1}), Wall({1, 0}, {1, .5f}),
                         Wall({0, 1}, {.5f, 1}), CArcDesc({1, 1}, .5f, pi, 3 * pi / 2)}),
                .0625f, zero, one, [](const CVec2d& p) { return ToDisc(p, 1, 1, .5); }},
      CBilliard{"PointInRectangle", Around(0, 0, rectangle), Table(1.5f, 1, {CPointDesc({.625f, .5f})}),
                .125f, zero, wide, [](const CVec2d& p) { return ToDisc(p, .625, .5, 0); }},
      // Both faces and both ends of a segment.
      CBilliard{"NeedleInRectangle", Around(0, 2 * .5, rectangle),
                Table(1.5f, 1, {Wall({.5f, .5f}, {1, .5f})}), .09375f, zero, wide,
                [](const CVec2d& p) { return ToLine(p, .5, 1); }},
      // Both faces and both ends of an arc.
      CBilliard{"HookInRectangle", Around(0, 2 * .3 * g_fPi, rectangle),
                Table(1.5f, 1, {CArcDesc({.75f, .5f}, .3f, pi / 2, 3 * pi / 2)}), .0625f, zero, wide, ToHook},
      CBilliard{"DiscInRing", Around(.16 * g_fPi, .8 * g_fPi, ring),
                CShapes({CCircleDesc({0, 0}, 1), CCircleDesc({.3f, 0}, .4f)}), .0625f, -one, one,
                [](const CVec2d& p) { return std::min(-ToDisc(p, 0, 0, 1), ToDisc(p, .3, 0, .4)); }},
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
  const auto path = [&](double radius) {
    return g_fPi * b.m_cSizeOf(radius).m_fArea / b.m_cSizeOf(radius).m_fPerimeter;
  };
  const double truth = path(r), naive = path(0);
  constexpr int nBalls = 5000;
  const double length = 60 * truth;
  CExact reference = Make(b.m_stdShapes, {CDynamicCircleDesc({0, 0}, b.m_fRadius)});
  double sum = 0, squares = 0;
  ForEachCase(1997, nBalls, [&](CRandom& random, int) {
    CVec2d p;
    do {
      p.x() = Between(b.m_vLow.x() + r, b.m_vHigh.x() - r, random.Unit());
      p.y() = Between(b.m_vLow.y() + r, b.m_vHigh.y() - r, random.Unit());
    } while (!(b.m_pRoom(p) > r));
    const CVec2d v = Unit(ToDouble(random.Direction()), CVec2d(1, 0));
    reference.SetBall(0, p, v);
    const CEvents events = Carry(reference, length);
    const double hits = static_cast<double>(events.size()), bound = 8 * g_fEps * hits;
    sum += hits;
    squares += hits * hits;
    const CVec2d end = reference.GetBall(0).m_vPos;
    ASSERT_NEAR(reference.GetBall(0).m_vVel.norm(), 1, bound);
    ASSERT_TRUE(b.m_pRoom(end) > r - 1e-6 &&
                (end - b.m_vLow).minCoeff() > r - 1e-6 && // the shapes are floats
                (b.m_vHigh - end).minCoeff() > r - 1e-6);
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

TEST(MeanFreePath, OfThePublishedExample) {
  const auto it = std::find_if(Billiards().begin(), Billiards().end(),
                               [](const CBilliard& b) { return std::string(b.m_sName) == "DiscInSquare"; });
  EXPECT_NEAR(g_fPi * it->m_cSizeOf(0).m_fArea / it->m_cSizeOf(0).m_fPerimeter, .522541, 5e-7);
}

} // namespace
} // namespace Shapes::Compare::Tests
