// SPDX-License-Identifier: MIT
// Where shapes join, and where they end.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

constexpr std::uint64_t g_nJointSeed = 20240612;

// ---- Two segments that go on straight.

double CollinearJoint(eColumn column) {
  Tests::CRandom random(g_nJointSeed);
  return WorstOf(2000, [&](int) {
    const double angle = 2.0 * std::numbers::pi * random.Unit();
    const Vector2 p0 = Turned(-3, 0, angle), joint(0, 0), p1 = Turned(3, 0, angle);
    const double slope = 0.05 + 0.3 * random.Unit(), where = 0.3 * (random.Unit() - 0.5);
    const double vx = 6.0 * std::cos(slope), vy = -6.0 * std::sin(slope), t = random.Unit() / 60.0;
    const Vector2 v = Turned(vx, vy, angle), p = Turned(where - vx * t, 0.1 - vy * t, angle);
    CStepped stepped(column, {CLineSegDesc(p0, joint), CLineSegDesc(joint, p1)},
                     {CDynamicCircleDesc(p, 0.1f, v)});
    stepped.Step(4);
    const Vector2d along = Wide(p1 - p0).normalized(), n(-along.y(), along.x());
    return AngleBetween(stepped.GetVel(), Mirrored(Wide(v), n));
  });
}

// ---- A naked end.

double NakedEnd(eColumn column, bool guarded) {
  const double r = 0.5, x = -0.3f, y = 2.0;
  std::vector<CAnyShapeDesc> shapes{CLineSegDesc({0, 0}, {1, 0})};
  if (guarded) shapes.emplace_back(CPointDesc({0, 0}));
  CStepped stepped(column, shapes, {CDynamicCircleDesc({-0.3f, 2}, 0.5f, {0, -1})});
  const int steps = 120;
  stepped.Step(steps);
  const double top = std::sqrt((r - x) * (r + x)), t = y - top;
  const Vector2d n(x / r, top / r), after = Mirrored({0.0, -1.0}, n);
  const double left = steps * static_cast<double>(1.0f / 60.0f) - t;
  return OffBy(stepped, Vector2d(x, top) + left * after, after);
}

CHardCase End(bool guarded) {
  const CExpect approximate = guarded ? Deviates(0.02, 0.08, ".041: it meets the point where the step ends")
                                      : Deviates(1.5, 1.7, "passes: its ends are open");
  return Case(
      guarded ? "GuardedEnd" : "NakedEnd",
      guarded ? "The same with a guard point on the end"
              : "Segment (0, 0)-(1, 0), r = .5 at (-.3, 2), v = (0, -1), 2 s",
      guarded ? "the same" : "hits the end at 1.6 s, n = (-.6, .8), v' = (-.96, .28)",
      {1e-12, 120 * 2 * g_fFloatRounding, "1e-12; engines a rounding of 2 for each of 120 steps"},
      {{Approximate, approximate}}, [=](eColumn column) { return NakedEnd(column, guarded); },
      guarded ? "segments before points, each on its own: the same miss, without the point"
              : "the foot of the perpendicular is not on the segment: no hit",
      [] { return Distance(Vector2d(0.0, -1.0), Vector2d(-0.96, 0.28)); });
}

// ---- A vertex that is there more than once.

/// How many contacts more or less than one there are, for each of many ways to come; infinite if the velocity
/// is not that of one reflection.
double Vertex(eColumn column) {
  return WorstOf(33, [=](int i) {
    // From all sides from which the end itself is met: the half circle away from the segment.
    const double angle = 0.5 * std::numbers::pi + i * std::numbers::pi / 32.0;
    const Vector2 v = Turned(-6, 0, angle);
    CStepped stepped(column, {CLineSegDesc({0, 0}, {1, 0}), CPointDesc({0, 0})},
                     {CDynamicCircleDesc(Turned(0.15, 0, angle), 0.1f, v)});
    double contacts = 0.0;
    for (int step = 0; step < 4; ++step) {
      stepped.Step();
      contacts += static_cast<double>(stepped.GetImpacts().size());
    }
    const double error = Distance(stepped.GetVel(), Wide(-v)) / 6.0;
    return error > 1e-5 ? g_fNever : std::abs(contacts - 1.0);
  });
}

// ---- Into the sector of an arc.

/// A ball whose centre comes close to the arc, crosses the end ray into its sector: by how much it is moved
/// farther than it can fly.
double IntoTheSector(eColumn column, bool guarded) {
  std::vector<CAnyShapeDesc> shapes{CArcDesc({0, 0}, 1.0f, 0.0f, std::numbers::pi_v<float> / 2.0f)};
  if (guarded) shapes.emplace_back(CPointDesc({1, 0}));
  return WorstOf({0.85f, 0.95f, 1.05f, 1.15f}, [&](float distance) {
    CStepped stepped(column, shapes, {CDynamicCircleDesc({distance, -0.5f}, 0.2f, {0.0f, 1.0f})});
    return WorstOf(60, [&](int) {
      const Vector2d before = stepped.GetPos();
      stepped.Step();
      return (stepped.GetPos() - before).norm() - Wide(g_fDt);
    });
  });
}

CHardCase IntoTheSectorOfAnArc(bool guarded) {
  return Case(
      guarded ? "PastAGuardIntoTheSectorOfAnArc" : "IntoTheSectorOfAnArc",
      guarded ? "The same with a guard point on the end"
              : "Quarter of a circle, R = 1; r = .2 comes from below its end at (1, 0), .05 and .15 off the "
                "arc to either side, v = (0, 1), 1/60 s: how much farther it gets in a step than it flies",
      guarded ? "0" : "0: it bounces off the end", g_cEightRoundings,
      {{Approximate, guarded ? Right() : Deviates(0.067, 0.15, ".134 at once: its ends are open")}},
      [=](eColumn column) { return IntoTheSector(column, guarded); },
      "set back from the arc as soon as the centre is in its sector: .15 at once", [] { return 0.2 - 0.05; });
}

} // namespace

std::vector<CHardCase> JointCases() {
  return {
      Case(
          "CollinearJoint",
          "Two collinear segments that join, at any angle; r = .1 at 6 units/s comes down near the joint at "
          "3 to 20 degrees, 2,000 times: worst way after it, in radians",
          "the mirror image", {1e-12, 16 * g_fFloatRounding, "1e-12; engines 16 roundings of 1"},
          {{Box2D, Deviates(0.5, 1.6, "1.0: it bounces off the joint itself, which is inside of the floor")}},
          CollinearJoint, "a guard point on the joint: kicks",
          [] {
            // The point is met first by whoever overlaps it at the end of the step.
            const Vector2d v(std::cos(0.1), -std::sin(0.1)), p(-0.04, 0.09);
            return AngleBetween(Mirrored(v, p.normalized()), Mirrored(v, {0.0, 1.0}));
          }),
      End(false),
      End(true),
      Case("VertexAndGuard",
           "A guard point on the end of a segment; r = .1 straight onto it, from 33 directions of the half "
           "circle away from the segment: contacts more than one",
           "one contact, v' = -v", g_cBits,
           {{Box2D, Deviates(0.5, 1.5, "1 more: both are told; v' is right")}}, Vertex,
           "each shape reflects what overlaps it, approaching or not: twice, v' = v",
           [] {
             const Vector2d v(0.0, -6.0), up(0.0, 1.0);
             return Distance(Mirrored(Mirrored(v, up), up), -v);
           }),
      IntoTheSectorOfAnArc(false),
      IntoTheSectorOfAnArc(true)};
}

} // namespace Shapes::HardCases
