// SPDX-License-Identifier: MIT
// A number after a million impacts, and whether it is the same number each time.
#include "StepTesting.h"

#include <cstring>
#include <numeric>

namespace Shapes::HardCases {
namespace {

constexpr std::uint64_t g_nLongRunSeed = 20240613;

/// Impacts of a run: a million in the approximate mode, a tenth of that elsewhere.
int GetCount(eColumn column) { return column == Approximate ? 1000000 : 100000; }

// ---- Speed.

/// A ball of r = .5 in a box of 1.2 that is turned, and that it crosses in about a step.
double SpeedDriftInABox(eColumn column, double turn) {
  std::vector<CAnyShapeDesc> walls;
  for (int i = 0; i < 4; ++i) {
    const double angle = turn + i * std::numbers::pi / 2.0;
    walls.emplace_back(CLineSegDesc(Turned(0.6, -0.6, angle), Turned(0.6, 0.6, angle)));
  }
  CStepped stepped(column, walls, {CDynamicCircleDesc({0, 0}, 0.5f, {3, 4})}, 0.04f);
  double worst = 0.0;
  const std::size_t count = static_cast<std::size_t>(GetCount(column)) / 4;
  for (std::size_t impacts = 0; impacts < count; impacts += stepped.GetImpacts().size()) {
    stepped.Step();
    if (!(stepped.GetPos().norm() < 0.6)) return g_fNever; // it is out
    worst = Worst(worst, std::abs(stepped.GetVel().norm() / 5.0 - 1.0));
  }
  return worst;
}

double SpeedDrift(eColumn column) {
  return WorstOf({0.1, 0.3, 0.7, 1.1}, [=](double turn) { return SpeedDriftInABox(column, turn); });
}

// ---- Momentum.

/// Two balls that are put together again after each impact, at another angle: what their momentum changes by,
/// relative to what they carry.
double MomentumDrift(eColumn column) {
  const float r = 0.5f, dt = g_fDt, m0 = 1.0f, m1 = 3.0f;
  CStepped stepped(
      column, {},
      {CDynamicCircleDesc({-1, 0}, r, {1, 0.3f}, m0), CDynamicCircleDesc({1, 0}, r, {-0.5f, -0.7f}, m1)}, dt);
  const auto momentum = [&] { return Vector2d(m0 * stepped.GetVel(0) + m1 * stepped.GetVel(1)); };
  const Vector2d before = momentum();
  const double carried = m0 * stepped.GetVel(0).norm() + m1 * stepped.GetVel(1).norm();
  Tests::CRandom random(g_nLongRunSeed);
  const int count = GetCount(column);
  int impacts = 0;
  const double worst = WorstOf(count, [&](int) {
    const Vector2d w0 = stepped.GetVel(0), w1 = stepped.GetVel(1);
    Vector2d u = Wide(random.Direction());
    if ((w1 - w0).dot(u) > 0.0) u = -u;
    const double gap = 0.5 * dt * -(w1 - w0).dot(u);
    // In the reference, too, where floats are.
    stepped.SetPos(0, Wide((-r * u).cast<float>()));
    stepped.SetPos(1, Wide(((r + gap) * u).cast<float>()));
    stepped.Step(column == Box2D ? 2 : 1); // it answers two balls a step late
    impacts += stepped.GetVel(0) != w0;
    return (momentum() - before).norm();
  });
  return impacts < count * 9 / 10 ? g_fNever : worst / carried * std::sqrt(1e6 / count);
}

// ---- Determinism.

/// The way of each of 16 balls in a box of its own with a turning hand, added in that order.
std::vector<float> RunBoxes(eColumn column, const std::vector<int>& order) {
  std::vector<CAnyShapeDesc> shapes;
  std::vector<CDynamicCircleDesc> balls;
  for (const int cell : order) {
    const Vector2 c(3.0f * static_cast<float>(cell % 4), 3.0f * static_cast<float>(cell / 4));
    for (const CLineSegDesc& wall : Walls(c - Vector2(1, 1), c + Vector2(1, 1), 0.9f))
      shapes.emplace_back(wall);
    shapes.emplace_back(Turning(CLineSegDesc(c, c + Vector2(0.4f, 0.0f)), 0.5f, c));
    Tests::CRandom random(g_nLongRunSeed + static_cast<std::uint64_t>(cell));
    balls.emplace_back(c + Vector2(0.6f, 0.5f), 0.1f, 4.0f * random.Direction());
    balls.emplace_back(c + Vector2(-0.6f, 0.5f), 0.15f, 4.0f * random.Direction(), 2.0f);
  }
  CStepped stepped(column, shapes, balls, g_fDt, {0.0f, -9.8f});
  stepped.Step(240);
  std::vector<float> way(order.size() * 8);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vector2d p = stepped.GetPos(i), v = stepped.GetVel(i);
    float* pOut = &way[8 * static_cast<std::size_t>(order[i / 2]) + 4 * (i % 2)];
    for (const double x : {p.x(), p.y(), v.x(), v.y()})
      *pOut++ = static_cast<float>(x);
  }
  return way;
}

double CountDifferent(const std::vector<float>& a, const std::vector<float>& b) {
  double different = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    different += std::memcmp(&a[i], &b[i], sizeof(float)) != 0;
  return different;
}

std::vector<int> InOrder() {
  std::vector<int> order(16);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::vector<int> Shuffled() {
  std::vector<int> order = InOrder();
  Tests::CRandom random(g_nLongRunSeed);
  for (std::size_t i = order.size(); i-- > 1;)
    std::swap(order[i], order[random.Below(static_cast<std::uint32_t>(i) + 1)]);
  return order;
}

} // namespace

std::vector<CHardCase> LongRunCases() {
  return {
      Case("MillionReflections",
           "r = .5 in boxes of 1.2 that are turned by .1, .3, .7 and 1.1 rad, v = (3, 4), a million "
           "reflections in the approximate mode, 100,000 elsewhere: largest change of the speed, relative",
           "0",
           {1e-11, 64 * g_fFloatRounding,
            "1e-11; engines 64 roundings, 3.8e-6: of the million some 1,000, their root, could add up"},
           {}, SpeedDrift, "a normal whose length is wrong by a rounding: it counts at each reflection",
           [] {
             float x = 3.0f, y = 4.0f;
             const float nx = 0.6f, ny = 0.8f * (1.0f + 0x1p-23f);
             for (int i = 0; i < 1000000; ++i) {
               const float d = 2.0f * (x * nx + y * ny);
               x -= d * nx;
               y -= d * ny;
             }
             return std::abs(std::hypot(Wide(x), Wide(y)) / 5.0 - 1.0);
           }),
      Case("MillionPairImpacts",
           "Masses 1 and 3, e = 1, put together again after each impact, at a random angle, a million times "
           "in the approximate mode, 100,000 (times the root of 10) elsewhere: change of the momentum, "
           "relative",
           "0",
           {1e-12, 4 * 1000 * g_fFloatRounding,
            "1e-12; engines 4 x 1,000 roundings: they add up as the root of their number"},
           {}, MomentumDrift, "each ball is answered with the velocity that the other one has by then",
           [] {
             double v0 = 1.0, v1 = -0.5;
             const double before = v0 + 3.0 * v1;
             v0 -= 2.0 * 3.0 / 4.0 * (v0 - v1);
             v1 += 2.0 * 1.0 / 4.0 * (v0 - v1);
             return std::abs(v0 + 3.0 * v1 - before) / 2.5;
           }),
      Case(
          "TheSameTwice",
          "16 boxes with a turning hand and two balls each, gravity, 240 steps, made and run twice: numbers "
          "of 128 that differ",
          "none", g_cBits, {},
          [](eColumn column) {
            return CountDifferent(RunBoxes(column, InOrder()), RunBoxes(column, InOrder()));
          },
          "random numbers that go on where the last run stopped",
          [] {
            Tests::CRandom random(g_nLongRunSeed);
            const Vector2 a = random.Direction(), b = random.Direction();
            return CountDifferent({a.x(), a.y()}, {b.x(), b.y()});
          }),
      Case(
          "AddedInAnotherOrder", "The same boxes, added in a random order",
          "none: what does not meet does not matter", g_cBits, {},
          [](eColumn column) {
            return CountDifferent(RunBoxes(column, InOrder()), RunBoxes(column, Shuffled()));
          },
          "the mean velocity of all, summed up in float in the order of adding, taken off each",
          [] {
            const auto mean = [](const std::vector<int>& order) {
              float sum = 0.0f;
              for (const int cell : order)
                sum += 0.1f + 0.37f * static_cast<float>(cell * cell);
              return sum / 16.0f;
            };
            return CountDifferent({mean(InOrder())}, {mean(Shuffled())});
          })};
}

} // namespace Shapes::HardCases
