// SPDX-License-Identifier: MIT
// Several impacts at once, infinitely many in a finite time, and rest.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

// ---- Corners.

/// Down the bisector of a corner of `opening` radians at the origin, whose first wall points along `angle`.
double Corner(eColumn column, double opening, double angle, bool swapped) {
  const Vector2 p0 = Turned(4, 0, angle), p1 = Turned(4, 0, angle + opening), o(0.0f, 0.0f);
  std::vector<CAnyShapeDesc> walls{CLineSegDesc(o, p0), CLineSegDesc(o, p1)};
  if (swapped) std::swap(walls[0], walls[1]);
  const double r = 0.1f, middle = angle + 0.5 * opening;
  const Vector2 start = Turned(r / std::sin(0.5 * opening) + 0.05, 0, middle), v = Turned(-6, 0, middle);
  CStepped stepped(column, walls, {CDynamicCircleDesc(start, 0.1f, v)});
  stepped.Step(4);
  return Distance(stepped.GetVel(), -v.cast<double>()) / 6.0;
}

double WorstCorner(eColumn column, double opening) {
  return WorstOf(12, [=](int i) {
    const double angle = i * std::numbers::pi / 6.0;
    return Worst(Corner(column, opening, angle, false), Corner(column, opening, angle, true));
  });
}

/// One reflection at each wall, in the order of adding.
double NaiveCorner(double opening) {
  const Vector2d n0(0.0, 1.0), n1(std::sin(opening), -std::cos(opening));
  const Vector2d v(-std::cos(0.5 * opening), -std::sin(0.5 * opening));
  const Vector2d once = Mirrored(Mirrored(v, n0), n1);
  // As one contact: the mean of both normals, not normalized.
  return Distance(opening > 1.5 ? Mirrored(v, 0.5 * (n0 + n1)) : once, -v);
}

/// A corner of pi over the number of reflections.
CHardCase CornerOf(const std::string& name, const std::string& input, int reflections, const CBound& bound,
                   const CExpect& approximate, const CExpect& shipped,
                   const std::string& control = "each wall once, in the order of adding") {
  const double opening = std::numbers::pi / reflections;
  return Case(
      name, input, "v' = -v, after " + std::to_string(reflections) + " reflections", bound,
      {{Approximate, approximate}, {Box2D, shipped}},
      [=](eColumn column) { return WorstCorner(column, opening); }, control,
      [=] { return NaiveCorner(opening); });
}

// ---- Cradles.

/// `count` balls that touch; the first `moving` of them come at speed 1.
double Cradle(eColumn column, int count, int moving, bool reversed) {
  std::vector<CDynamicCircleDesc> balls;
  for (int i = 0; i < count; ++i)
    balls.emplace_back(Vector2(static_cast<float>(i), 0.0f), 0.5f, Vector2(i < moving ? 1.0f : 0.0f, 0.0f));
  if (reversed) std::reverse(balls.begin(), balls.end());
  CStepped stepped(column, {}, balls);
  stepped.Step(60);
  return WorstOf(count, [&](int i) {
    const auto index = static_cast<std::size_t>(reversed ? count - 1 - i : i);
    return Distance(stepped.GetVel(index), {i >= count - moving ? 1.0 : 0.0, 0.0});
  });
}

/// One pass over the pairs, from the far end to the near one.
double NaiveCradle(int count, int moving) {
  std::vector<double> v(static_cast<std::size_t>(count), 0.0);
  std::fill_n(v.begin(), moving, 1.0);
  for (std::size_t i = v.size() - 1; i-- > 0;)
    if (v[i] > v[i + 1]) std::swap(v[i], v[i + 1]);
  return WorstOf(count, [&](int i) {
    return std::abs(v[static_cast<std::size_t>(i)] - (i >= count - moving ? 1.0 : 0.0));
  });
}

CHardCase CradleOf(const std::string& name, const std::string& input, const std::string& right, int count,
                   int moving, double shipped, const std::string& figure) {
  return Case(
      name, input, right, g_cEightRoundings, {{Box2D, Deviates(0.5 * shipped, 1.0, figure)}},
      [=](eColumn column) {
        return Worst(Cradle(column, count, moving, false), Cradle(column, count, moving, true));
      },
      "each pair once, from the far end", [=] { return NaiveCradle(count, moving); });
}

// ---- Five on a line.

constexpr std::size_t g_nOnALine = 5;

/// How many impacts are missing or too many, or by how much the speeds are off in the end.
double OnALine(eColumn column, const std::array<float, g_nOnALine>& places) {
  std::vector<CDynamicCircleDesc> balls;
  for (const float x : places)
    balls.emplace_back(Vector2(x, 0.0f), 0.5f, Vector2(static_cast<float>(g_nOnALine - balls.size()), 0.0f));
  CStepped stepped(column, {}, balls);
  std::size_t impacts = 0;
  for (int step = 0; step < 300; ++step) {
    stepped.Step();
    impacts += stepped.GetImpacts().size();
  }
  const double off = WorstOf(static_cast<int>(g_nOnALine), [&](int i) {
    return Distance(stepped.GetVel(static_cast<std::size_t>(i)), {1.0 + i, 0.0});
  });
  return Worst(off, std::abs(static_cast<double>(impacts) - g_nOnALine * (g_nOnALine - 1) / 2.0));
}

/// Balls of diameter 1 swap wherever they overlap at the end of a step, for as long as they do.
double NaiveOnALine(const std::array<float, g_nOnALine>& places) {
  std::array<double, g_nOnALine> x, v;
  double impacts = 0.0;
  for (std::size_t i = 0; i < g_nOnALine; ++i) {
    x[i] = places[i];
    v[i] = static_cast<double>(g_nOnALine - i);
  }
  for (int step = 0; step < 300; ++step)
    for (std::size_t i = 0; i < g_nOnALine; ++i) {
      x[i] += v[i] / 60.0;
      if (i == 0 || x[i] - x[i - 1] >= 1.0) continue;
      std::swap(v[i], v[i - 1]);
      ++impacts;
    }
  return std::abs(impacts - g_nOnALine * (g_nOnALine - 1) / 2.0);
}

CHardCase FiveOnALine(const std::string& name, const std::string& input,
                      const std::array<float, g_nOnALine>& places, const CExpect& shipped,
                      const CExpect& tuned) {
  return Case(
      name, input, "10 impacts, n (n - 1) / 2, and the speeds in the other order",
      {1e-14, 1e-5, "none; speeds 1e-14, engines 1e-5"}, {{Box2D, shipped}, {Tuned, tuned}},
      [=](eColumn column) { return OnALine(column, places); },
      "whoever overlaps at the end of a step swaps, approaching or not",
      [=] { return NaiveOnALine(places); });
}

// ---- A ball that bounces ever lower.

constexpr double g_fDropHeight = 1.0, g_fDropGravity = 9.81f, g_fDropElasticity = 0.5;

/// Height of the exact ball above the floor at time t: hops of a geometric series.
double DropAt(double t) {
  const double g = g_fDropGravity, v0 = std::sqrt(2.0 * g * g_fDropHeight), t0 = v0 / g;
  if (t < t0) return g_fDropHeight - 0.5 * g * t * t;
  double start = t0, v = v0;
  for (int hop = 0; hop < 60; ++hop) {
    v *= g_fDropElasticity;
    if (t < start + 2.0 * v / g) return v * (t - start) - 0.5 * g * (t - start) * (t - start);
    start += 2.0 * v / g;
  }
  return 0.0;
}

constexpr int g_nDropRate = 240;

/// The largest error of the height within 2 s, in steps' worth of the fastest way.
double Drop(eColumn column) {
  const float r = 0.1f, dt = 1.0f / g_nDropRate;
  CStepped stepped(column, {CLineSegDesc({-1, 0}, {1, 0}, 0.5f)}, {CDynamicCircleDesc({0, 1.0f + r}, r)}, dt,
                   {0.0f, -9.81f});
  const double top = Wide(1.0f + r) - g_fDropHeight;
  return WorstOf(2 * g_nDropRate, [&](int i) {
    stepped.Step();
    return std::abs(stepped.GetPos().y() - top - DropAt((i + 1) * Wide(dt)));
  });
}

// ---- At rest.

/// How far it gets at most from where it was put.
double Rest(eColumn column, float e) {
  const float r = 0.1f;
  CStepped stepped(column, {CLineSegDesc({-1, 0}, {1, 0}, e)}, {CDynamicCircleDesc({0, r}, r)}, g_fDt,
                   {0.0f, -9.8f});
  return WorstOf(column == Approximate ? 1000000 : 200000, [&](int) {
    stepped.Step();
    return Distance(stepped.GetPos(), {0.0, r});
  });
}

double NaiveRest(double e) {
  // The kick of gravity is mirrored with the velocity, and nobody looks whether it approaches.
  double y = 0.0, v = 0.0, worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    v -= 9.8 / 60.0;
    y += v / 60.0;
    if (y < 0.0) {
      v *= -e;
      worst = std::max(worst, -y); // no setback: it sinks
    }
  }
  return worst;
}

CHardCase RestOf(const std::string& name, const std::string& e, float elasticity, const CExpect& shipped) {
  return Case(
      name,
      "r = .1 at rest on a segment, g = 9.8, e = " + e +
          ", a million steps in the approximate mode, 200,000 elsewhere: largest way from its place",
      "0", {1e-6, 1e-6, "1e-6"}, {{Box2D, shipped}}, [=](eColumn column) { return Rest(column, elasticity); },
      "mirrored where it is below the floor, not set back: sinks in", [=] { return NaiveRest(elasticity); });
}

} // namespace

std::vector<CHardCase> SimultaneousCases() {
  const double rounding = 32 * g_fFloatRounding;
  const CBound rounded{rounding, rounding, "32 roundings of a float, to which the opening is rounded"};
  const double step = std::sqrt(2.0 * g_fDropGravity * g_fDropHeight) / g_nDropRate;
  return {
      CornerOf(
          "SquareCorner",
          "r = .1 down the bisector of a corner of 90 degrees, both orders of adding, turned by 0, 30, .. "
          "degrees: velocity, relative",
          2, Roundings(32), Right(), Right(), "both as one contact, with the mean of the normals"),
      CornerOf("SharpCorner", "The same with 60 degrees", 3, rounded, Right(),
               Off(0.00005, ".00005: it stops after 8 iterations")),
      CornerOf(
          "NarrowCorner", "The same with 45 degrees", 4, rounded,
          Deviates(1.3, 1.5, "1.4: it answers each wall once, and has set the ball back from both by then"),
          Off(0.01, ".01: it stops after 8 iterations")),
      CradleOf("CradleOfFive", "Five balls that touch, the first one comes at speed 1; both orders of adding",
               "(0, 0, 0, 0, 1)", 5, 1, 0.60, ".60: it answers all of them at once"),
      CradleOf("CradleOfFiveTwoComing", "The same, two come", "(0, 0, 0, 1, 1)", 5, 2, 0.77,
               ".77: it answers all of them at once"),
      FiveOnALine("FiveOnALine",
                  "Five equal balls on a line, gaps .4, .7, .2 and .9, speeds 5, 4, 3, 2, 1: impacts too "
                  "many or missing",
                  {0.0f, 1.4f, 3.1f, 4.3f, 6.2f},
                  Deviates(0.5, 1.5, "1 missing: two pairs in one step are answered at once"),
                  Deviates(0.5, 1.5, "1 missing: it tells of each pair once a step; the speeds are right")),
      FiveOnALine("FiveOnALineAtOnce", "The same with gaps of .5: all meet at the same time",
                  {0.0f, 1.5f, 3.0f, 4.5f, 6.0f}, Right(),
                  Deviates(5.5, 6.5, "6 missing: it tells of each pair once a step; the speeds are right")),
      Case("DropThatComesToRest",
           "Drop from 1, g = 9.81, e = .5, 240 steps a second, for 2 s: largest error of the height",
           "at rest after 1.3545709 s and a way of 5/3",
           {1e-7, step, "1e-7, where r + 1 and e round to; engines: an impact late by one step, .018"}, {},
           Drop, "from impact to impact, without a rule for rest: never gets beyond 1.3546 s",
           [] {
             double v = std::sqrt(2.0 * g_fDropGravity * g_fDropHeight), t = v / g_fDropGravity;
             for (int impact = 0; impact < 100000; ++impact) {
               v *= g_fDropElasticity;
               t += 2.0 * v / g_fDropGravity;
             }
             return t < 2.0 ? g_fNever : 0.0;
           }),
      RestOf("RestWithoutElasticity", "0", 0.0f,
             Deviates(0.0025, 0.01, ".005: lies that much above, in its skin")),
      RestOf("RestOfHalfElasticity", ".5", 0.5f,
             Deviates(0.0055, 0.022, ".011, never still: its skin, and the kick of gravity bounces")),
      RestOf("RestOfFullElasticity", "1", 1.0f,
             Deviates(135.0, 540.0, "271, climbs: the kick of gravity bounces"))};
}

} // namespace Shapes::HardCases
