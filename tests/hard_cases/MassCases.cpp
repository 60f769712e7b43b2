// SPDX-License-Identifier: MIT
// Velocities after an impact: masses that differ by much, and elasticities.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

// ---- Two balls, head on.

/// Off by how much the velocities are, relative to the largest speed; and the momentum, relative to what the
/// balls carry. On the x axis, ball 0 from the left.
double PairError(eColumn column, float m0, float v0, float m1, float v1) {
  const float r = 0.5f, gap = 0.5f * g_fDt * (v0 - v1);
  CStepped stepped(column, {},
                   {CDynamicCircleDesc({-r, 0.0f}, r, {v0, 0.0f}, m0),
                    CDynamicCircleDesc({r + gap, 0.0f}, r, {v1, 0.0f}, m1)});
  stepped.Step(2); // Box2D may answer a step late
  const Vector2d w0 = stepped.GetVel(0), w1 = stepped.GetVel(1);
  const CFifty a = m0, b = m1, u0 = v0, u1 = v1, x0 = w0.x(), x1 = w1.x();
  const Vector2d right0(static_cast<double>(((a - b) * u0 + 2 * b * u1) / (a + b)), 0.0);
  const Vector2d right1(static_cast<double>(((b - a) * u1 + 2 * a * u0) / (a + b)), 0.0);
  const double speed = std::max({std::abs(static_cast<double>(v0)), right0.norm(), right1.norm()});
  const CFifty gained = a * (x0 - u0) + b * (x1 - u1);
  const CFifty carried = a * (abs(u0) + abs(x0)) + b * (abs(u1) + abs(x1));
  return Worst(Worst(Distance(w0, right0), Distance(w1, right1)) / speed,
               static_cast<double>(abs(gained / carried)));
}

/// In either order of adding.
double WorstPairError(eColumn column, float m0, float v0, float m1, float v1) {
  return Worst(PairError(column, m0, v0, m1, v1), PairError(column, m1, -v1, m0, -v0));
}

// ---- Elasticity at a wall.

CHardCase AtAWall(const std::string& name, const std::string& e, float eWall, float eBall,
                  const Vector2d& right, const std::string& says, const Vector2d& naive,
                  const std::string& naively) {
  return Case(
      name, "v = (3, -4) onto a floor, e = " + e + "; also turned by 45, 90, .. degrees", says,
      Roundings(4, 8), {},
      [=](eColumn column) {
        return WorstOf(8, [=](int i) {
          const double angle = i * std::numbers::pi / 4.0;
          const Vector2 v = Turned(3, -4, angle), p0 = Turned(-3, 0, angle), p1 = Turned(3, 0, angle);
          CStepped stepped(column, {CLineSegDesc(p0, p1, eWall)},
                           {CDynamicCircleDesc(Turned(0, 0.14, angle), 0.1f, v, 1.0f, eBall)});
          stepped.Step(2);
          const Vector2d along = Wide(p1 - p0).normalized(), n(-along.y(), along.x());
          return Distance(stepped.GetVel(), Mirrored(Wide(v), n, Wide(eWall) * Wide(eBall)));
        });
      },
      naively, [=] { return Distance(naive, right); });
}

// ---- A thousandfold at each impact.

constexpr int g_nGains = 20;

/// Each impact in a world of its own, whose step is so short that it has room for just this one.
double Gains(eColumn column) {
  const bool exact = column == Reference,
             isTuned = column == Tuned; // its world is larger inside
  const double most = exact || IsNative(column) ? g_fMaxSpeed : g_fMaxBox2DSpeed / (isTuned ? 4.0 : 1.0);
  double right = 1.0, worst = 0.0;
  Vector2 v(0.0f, -1.0f);
  std::uint64_t capped = 0;
  for (int i = 0; i < g_nGains; ++i) {
    if (exact && right * 1000.0 > most) break; // it has no limit, and would go on
    const float dt = 0.0005f / std::abs(v.y());
    CStepped stepped(column, {CLineSegDesc({-1.0f, 0.0f}, {1.0f, 0.0f}, 1000.0f)},
                     {CDynamicCircleDesc({0.0f, 0.1002f}, 0.1f, v)}, dt);
    stepped.Step();
    right = std::min(-1000.0 * v.y(), most);
    worst = Worst(worst, Distance(stepped.GetVel(), {0.0, right}) / right);
    v = -stepped.GetVel().cast<float>();
    if (!exact) capped += stepped.GetWorld()->GetStats().m_nSpeedsCapped;
  }
  return exact || capped > 0 ? worst : g_fNever;
}

} // namespace

std::vector<CHardCase> MassCases() {
  const CExpect refused = Refused("m_fMass");
  return {
      Case(
          "AMoteIsHitByABall", "m = 1 and v = 1 meets m = 1e-12 at rest: velocities and momentum, relative",
          "1.999999999998 and .999999999998", Roundings(8), {},
          [](eColumn column) { return WorstPairError(column, 1.0f, 1.0f, 1e-12f, 0.0f); },
          "velocity of the light one from the momentum that the heavy one has lost, in float: 0",
          [] {
            const volatile float m = 1e-12f, M = 1.0f, v = 1.0f, after = (M - m) / (M + m) * v;
            return std::abs((M * v - M * after) / m - 2.0) / 2.0;
          }),
      Case(
          "HeavyBallsSwap", "m = 1e30 each, v = 1 meets v = -.5", "they swap velocities", Roundings(8),
          {{Box2D, refused}, {Tuned, refused}},
          [](eColumn column) { return WorstPairError(column, 1e30f, 1.0f, 1e30f, -0.5f); },
          "impulse (1 + e) m M / (m + M) in float: infinite",
          [] {
            const volatile float m = 1e30f, M = 1e30f, v = 1.5f;
            const float impulse = 2.0f * m * M / (m + M) * v;
            return Distance({1.0 - impulse / m, 0.0}, {-0.5, 0.0});
          }),
      AtAWall("NoElasticity", "0", 0.0f, 1.0f, {3, 0}, "(3, 0)", {0, 0}, "v = -e v: (0, 0)"),
      AtAWall("FullElasticity", "1", 1.0f, 1.0f, {3, 4}, "(3, 4)", {-3, 4}, "v = -e v: (-3, 4)"),
      AtAWall("ElasticityAboveOne", "2", 2.0f, 1.0f, {3, 8}, "(3, 8)", {-6, 8}, "v = -e v: (-6, 8)"),
      AtAWall("ElasticitiesMultiply", ".5 and .5", 0.5f, 0.5f, {3, 1}, "(3, 1)", {1.5, 2},
              "half of v is lost: (1.5, 2)"),
      Case("AThousandfoldAtEachImpact",
           "Walls of e = 1000, 1 unit/s at first, " + std::to_string(g_nGains) + " impacts: speed, relative",
           "1000^n up to the limit (1e18; Box2D 1e9, tuned 2.5e8), then cut to that and counted",
           Roundings(8), {}, Gains, "v *= 1000 in float: infinite after 13", [] {
             float v = 1.0f;
             for (int i = 0; i < g_nGains; ++i)
               v *= 1000.0f;
             return std::isinf(v) ? g_fNever : 0.0;
           })};
}

} // namespace Shapes::HardCases
