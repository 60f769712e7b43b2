// SPDX-License-Identifier: MIT
// Balls that are fast for their size, and balls that overlap something already.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

const std::uint64_t g_nFastSeed = 20240611;

// ---- A wall, 1.5 radii a step, any phase.

constexpr int g_nShots = 100000;
constexpr float g_fShotRadius = 0.1f, g_fShotWay = 0.15f;

double ShareThatGetsThrough(eColumn column) {
  Tests::CRandom random(g_nFastSeed);
  const int shots = IsNative(column) || column == Reference ? g_nShots : g_nShots / 10;
  int through = 0;
  for (int i = 0; i < shots; ++i) {
    const double angle = 2.0 * std::numbers::pi * random.Unit(), phase = random.Unit();
    const double height = g_fShotRadius + phase * g_fShotWay;
    CStepped stepped(
        column, {CLineSegDesc(Turned(-2, 0, angle), Turned(2, 0, angle))},
        {CDynamicCircleDesc(Turned(0, height, angle), g_fShotRadius, Turned(0, -g_fShotWay / g_fDt, angle))});
    stepped.Step(3); // Box2D may answer a step late
    if (stepped.GetPos().dot(Turned(0, 1, angle).cast<double>()) < 0.0) ++through;
  }
  return through / static_cast<double>(shots);
}

// A ball that overlaps at the end of the step meets the shape, on the side on which it is then.
double ShareThatAnOverlapTestLoses() {
  Tests::CRandom random(g_nFastSeed);
  int through = 0;
  for (int i = 0; i < g_nShots; ++i)
    if (g_fShotRadius + random.Unit() * g_fShotWay - g_fShotWay < 0.0) ++through;
  return through / static_cast<double>(g_nShots);
}

// ---- A bounce in the middle of a step.

double DeepBounce(eColumn column) {
  const float r = 0.1f, y = 0.13f, v = 6.0f;
  CStepped stepped(column, {g_cFloor}, {CDynamicCircleDesc({0.0f, y}, r, {0.0f, -v})});
  stepped.Step();
  const double t = (Wide(y) - r) / v;
  return OffBy(stepped, {0.0, r + v * (g_fDt - t)}, {0.0, v});
}

// ---- A point, passed at half a radius.

struct COffCentre {
  double m_fMedian = 0.0;  // radians by which the way after the impact is off
  double m_fThrough = 0.0; // share that is not turned at all
};

/// A ball of this radius passes a point at this offset, which it meets with its centre at x = -g_fImpact.
const double g_fPasserRadius = 0.1f, g_fOffset = 0.05f;
const double g_fImpact = std::sqrt((g_fPasserRadius - g_fOffset) * (g_fPasserRadius + g_fOffset));

/// @param velAfter  of a start and a velocity
template <class F>
COffCentre Judge(const F& velAfter) {
  constexpr int phases = 2000;
  const Vector2d n = Vector2d(-g_fImpact, g_fOffset) / g_fPasserRadius, v(6.0, 0.0);
  std::vector<double> errors;
  COffCentre all;
  for (int i = 0; i < phases; ++i) {
    const Vector2d after = velAfter(Vector2d(-g_fImpact - 0.1 * ((i + 0.5) / phases), g_fOffset), v);
    errors.push_back(AngleBetween(after, Mirrored(v, n)));
    if (AngleBetween(after, v) < 1e-6) all.m_fThrough += 1.0 / phases;
  }
  std::sort(errors.begin(), errors.end());
  all.m_fMedian = errors[errors.size() / 2];
  return all;
}

COffCentre PassAPoint(eColumn column) {
  return Judge([&](const Vector2d& p, const Vector2d& v) {
    CStepped stepped(column, {CPointDesc({0.0f, 0.0f})},
                     {CDynamicCircleDesc(p.cast<float>(), 0.1f, v.cast<float>())});
    stepped.Step(3);
    return stepped.GetVel();
  });
}

COffCentre PassAPointNaively() {
  return Judge([&](Vector2d p, Vector2d v) {
    for (int step = 0; step < 3; ++step) {
      p += v / 60.0;
      const Vector2d n = p.normalized();
      if (p.norm() < g_fPasserRadius && v.dot(n) < 0.0) v = Mirrored(v, n);
    }
    return v;
  });
}

// ---- Inside of a ring.

CHardCase RestingInside(const std::string& name, const std::string& input, const std::string& right,
                        const CAnyShapeDesc& ring, const CExpectations& expect, const std::string& control) {
  return Case(
      name, input, right, g_cBits, expect,
      [=](eColumn column) {
        CStepped stepped(column, {ring}, {CDynamicCircleDesc({3.0f, 0.0f}, 0.1f)});
        stepped.Step(60);
        return Distance(stepped.GetPos(), {3.0, 0.0});
      },
      control, [] { return 5.0 + 0.1 - 3.0; });
}

// ---- Overlapping, but on its way out.

const Vector2 g_vLeaving(1.0f, 0.5f);

double LeavesAnOverlap(eColumn column) {
  const float r = 0.1f, y = 0.08f;
  CStepped stepped(column, {g_cFloor}, {CDynamicCircleDesc({0.0f, y}, r, g_vLeaving)});
  stepped.Step();
  // It may be moved along the normal, by no more than the overlap.
  const Vector2d pushed = stepped.GetPos() - Vector2d(0.0, y) - Wide(g_vLeaving) * Wide(g_fDt);
  const double wrong =
      std::max({-pushed.y(), pushed.y() - (Wide(r) - y), std::abs(pushed.x())}) - g_fFloatRounding;
  return Worst(std::max(wrong, 0.0), Distance(stepped.GetVel(), Wide(g_vLeaving)));
}

// ---- A million units a second.

double Million(eColumn column) {
  const float r = 0.1f, v = 1e6f;
  CStepped stepped(column, {g_cFloor}, {CDynamicCircleDesc({0.0f, 1.0f}, r, {0.0f, -v})});
  stepped.Step();
  // Slowed down without a word would be worse than any number.
  const bool isClamped = stepped.GetVel().norm() < 0.5 * v;
  const CWorld* pWorld = stepped.GetWorld();
  if (isClamped && pWorld != nullptr && pWorld->GetStats().m_nMovesClamped == 0) return g_fNever;
  const double t = (1.0 - r) / v, y = r + v * (g_fDt - t);
  return Worst(Distance(stepped.GetPos(), {0.0, y}) / y, Distance(stepped.GetVel(), {0.0, v}) / v);
}

} // namespace

std::vector<CHardCase> FastCases() {
  const CExpect solid = Deviates(2.0, 2.2, "2.1, to the outside: its circles are solid");
  return {
      Case("FastShotsAtAWall",
           "r = .1, head on at a segment at any angle, 1.5 radii a step, any phase: share of 100,000 shots "
           "that get through",
           "0", g_cBits,
           {{Approximate,
             Deviates(1.0 / 3.0 - 0.0045, 1.0 / 3.0 + 0.0045,
                      ".333 get through: it looks at the end of the step only, and loses 1 - r / (v dt)")}},
           ShareThatGetsThrough, "overlap at the end of the step: loses 1 - r / (v dt) = 1/3",
           ShareThatAnOverlapTestLoses),
      Case(
          "BounceInTheMiddleOfAStep", "r = .1 at (0, .13), v = (0, -6), 1/60 s, onto a segment on y = 0",
          "at (0, .17), v = (0, 6)", g_cEightRoundings,
          {{Approximate, Deviates(0.0699, 0.0701,
                                  ".07 short: set back onto the surface, it loses the way after the impact")},
           {Box2D, Deviates(0.00008, 0.0003, ".00016 off: its skin")}},
          DeepBounce, "setback to the surface: at .10 instead of .17",
          [] {
            const double r = 0.1, y = 0.13 - 6.0 / 60.0, setback = r - y;
            return std::abs(0.17 - (y + setback));
          }),
      Case(
          "PointPassedAtHalfARadius",
          "r = .1, passing a point at an offset of .05, a radius a step, 2,000 phases: median error of the "
          "way after it, in radians",
          "the mirror image at the true impact", g_cEightRoundings,
          {{Approximate, Deviates(0.80, 0.86, ".83: the normal is that of the end of the step")},
           {Box2D,
            Deviates(0.105, 0.42, ".21: it stops the ball up to .015 deep, and takes the normal there")}},
          [](eColumn column) { return PassAPoint(column).m_fMedian; },
          "closest point at the end of the step: median .83 rad",
          [] { return PassAPointNaively().m_fMedian; }),
      Case(
          "PointPassedWithoutATurn", "The same: the share that is not turned at all", "0", g_cBits,
          {{Approximate, Deviates(0.12, 0.15, ".134: at the end of the step they are past it, or leaving")}},
          [](eColumn column) { return PassAPoint(column).m_fThrough; },
          "closest point at the end of the step: 13% pass", [] { return PassAPointNaively().m_fThrough; }),
      RestingInside("RestingInsideACircle",
                    "r = .1 at rest, 3 from the centre of a circle of radius 5, for 1 s: how far it moves",
                    "0: the circle is a ring, and is not touched", CCircleDesc({0, 0}, 5.0f),
                    {{Box2D, solid}, {Tuned, solid}}, "a disk, d < R + r: pushed out by 2.1"),
      RestingInside("RestingInsideABowl", "The same inside of a full-circle arc", "0",
                    CArcDesc({0, 0}, 5.0f, 0.0f, 0.0f), {},
                    "the arc as a disk, d < R + r: pushed out by 2.1"),
      Case("LeavingAnOverlap", "r = .1 overlaps a segment by .02, v = (1, .5) off it",
           "v bit for bit; pushed along the normal at most, by .02 at most", g_cBits,
           {{Box2D, Deviates(0.0023, 0.0092, "v kept, but pushed .0046 too far: by its skin")}},
           LeavesAnOverlap, "v - 2 (v.n) n whenever they overlap: sent back in",
           [] { return Distance(Mirrored(Wide(g_vLeaving), Vector2d(0.0, 1.0)), Wide(g_vLeaving)); }),
      Case("AMillionUnitsASecond",
           "r = .1 at (0, 1), v = (0, -1e6), 1/60 s, onto a segment on y = 0: place and velocity, relative",
           "hits after 9e-7 s, and is at y = 16,666 at the end", Roundings(8),
           {{Approximate, Deviates(1.9, 2.1, "goes through: it is at y = -16,666")},
            {Box2D, Deviates(0.9999, 1.0, "slowed down to 120, by at most 2 units a step; counted")},
            {Tuned, Deviates(0.99, 1.0, "slowed down to 7,600, by at most 256 x .5 units a step; counted")}},
           Million, "overlap at the end of the step: goes through",
           [] { return std::abs(1.0 - 1e6 / 60.0) < 0.1 ? 0.0 : g_fNever; })};
}

} // namespace Shapes::HardCases
