// SPDX-License-Identifier: MIT
// Lengths that are very small, very large, or far from the origin.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

// ---- A scene of 1e-23 units.

constexpr float g_fTiny = 1e-23f;

double Tiny(eColumn column) {
  const float y = 2.5f * g_fTiny, v = 120.0f * g_fTiny;
  CStepped stepped(column, {CPointDesc({0.0f, 0.0f})}, {CDynamicCircleDesc({0.0f, y}, g_fTiny, {0.0f, -v})});
  stepped.Step(2);
  const double r = g_fTiny, t = (Wide(y) - r) / v, end = r + v * (2.0 * g_fDt - t);
  return Worst(Distance(stepped.GetPos(), {0.0, end}) / r, Distance(stepped.GetVel(), {0.0, v}) / v);
}

// ---- A radius whose square is no float.

double Huge(eColumn column) {
  CStepped stepped(column, {CPointDesc({0, 0})}, {CDynamicCircleDesc({1e18f, 0}, 2e19f, {1, 0})});
  stepped.Step();
  return Distance(stepped.GetVel(), {1.0, 0.0});
}

// ---- Far from the origin.

double Far(eColumn column, float x, float r) {
  const float edge = std::numbers::pi_v<float> / 18.0f;
  CStepped stepped(column, {CArcDesc({x, 0.0f}, 1.0f, -edge, edge)},
                   {CDynamicCircleDesc({x + 2.0f, 0.0f}, r, {-1.0f, 0.0f})}, 1.0f);
  stepped.Step(2);
  const double t = 2.0 - 1.0 - r;
  return OffBy(stepped, {x + 1.0 + r + (2.0 - t), 0.0}, {1.0, 0.0});
}

double NaiveFar(float x) {
  // The textbook quadratic in absolute float coordinates: |p + v t|^2 with the centre's square taken off.
  const float r = 0.1f, R = 1.0f, p = x + 2.0f, v = -1.0f;
  const float b = v * p - v * x, c = p * p - 2.0f * p * x + x * x - (R + r) * (R + r);
  return std::abs(-b - std::sqrt(b * b - c) - 0.9);
}

CHardCase FarArc(const std::string& name, const std::string& input, const std::string& right,
                 const CBound& bound, float x, float r, const CExpect& approximate, const CExpect& shipped,
                 const CExpect& tuned) {
  return Case(
      name, input, right, bound, {{Approximate, approximate}, {Box2D, shipped}, {Tuned, tuned}},
      [=](eColumn column) { return Far(column, x, r); },
      "quadratic equation in float, in absolute coordinates", [=] { return NaiveFar(x); });
}

} // namespace

std::vector<CHardCase> ScaleCases() {
  const CBound at2To20{1e-9, 1048576 * g_fFloatRounding, "1e-9; engines: 1 rounding of 2^20, .0625"};
  return {
      Case("ABallOf1eMinus23",
           "r = 1e-23 at (0, 2.5 r), v = (0, -120 r), 2 steps of 1/60 s, onto a point at the origin: place "
           "in r, velocity relative",
           "bounces: at (0, 3.5 r)", Roundings(8, 4),
           {{Approximate, Deviates(0.45, 0.55, ".5 r short: set back")},
            {Box2D, Deviates(4.9, 5.1, "goes through: r is far below its slop of .005")},
            {Tuned, Deviates(5.4, 5.6, "goes through a step later: r is far below its slop of .005")}},
           Tiny, "d^2 < r^2 in float, at d = r / 2: r^2 is 0, a miss",
           [] {
             const volatile float d = g_fTiny / 2.0f;
             return d * d < g_fTiny * g_fTiny ? 0.0 : g_fNever;
           }),
      Case("ABallOf2e19", "r = 2e19", "refused: its square is no float", g_cBits, RefusedByAll("m_fRadius"),
           Huge, "a miss if d^2 > r^2 in float: both are infinite at d = 2 r, a hit",
           [] {
             const volatile float r = 2e19f, d = 4e19f;
             return d * d > r * r ? 0.0 : g_fNever;
           }),
      FarArc(
          "AnArcAt2To13",
          "Arc from 350 to 10 degrees, R = 1, about (2^13, 0); r = .1 at (2, 0) from there, v = (-1, 0), two "
          "steps of 1 s",
          "hits at .9 s, and is at (2.2, 0) from there, v = (1, 0)",
          {8 * 8192 * 2 * g_fDoubleRounding, 8192 * g_fFloatRounding,
           "8 roundings of 2^14; engines: 1 rounding of 2^13, .0005"},
          8192.0f, 0.1f, Deviates(0.099, 0.101, ".1 short: set back"),
          Deviates(0.0005, 0.0016, ".0008: its skin"),
          Deviates(0.0009, 0.0035,
                   ".0018, a step late: its world is 4 times as large, and floats .004 apart there")),
      FarArc("AnArcAt2To20", "The same about (2^20, 0), where floats are .125 apart: more than r", "the same",
             at2To20, 1048576.0f, 0.1f, Deviates(0.0725, 0.0775, ".075: set back, to the nearest float"),
             Deviates(0.13, 0.53, ".26, a step late: floats are .125 apart, its skin is .01"),
             Deviates(0.8, 1.35,
                      "1.1, put back without a bounce: floats are .5 apart in its world, 4 times as large")),
      FarArc("ALargerBallAt2To20", "The same with r = .5, four times as much as floats are apart",
             "hits at .5 s, and is at (3, 0) from there", at2To20, 1048576.0f, 0.5f,
             Deviates(0.49, 0.51, ".5 short: set back"),
             Deviates(0.5, 2.0, "1, a step late: floats are .125 apart, its skin is .01"),
             Deviates(0.9, 3.5, "1.75 off: its world is 4 times as large, and floats are .5 apart there"))};
}

} // namespace Shapes::HardCases
