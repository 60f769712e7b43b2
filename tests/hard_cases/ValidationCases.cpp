// SPDX-License-Identifier: MIT
// Inputs that are no numbers, or of no extent.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

using CBall = CDynamicCircleDesc;

// A bounce between a segment and a point, another ball in the way.
std::unique_ptr<CWorld> MakeBusyWorld(eColumn column) {
  auto pWorld = MakeWorld(column, {0.0f, -9.8f});
  pWorld->Add(CLineSegDesc({-2.0f, 0.0f}, {2.0f, 0.0f}));
  pWorld->Add(CPointDesc({0.0f, 0.0f}));
  pWorld->Add(CBall({0.1f, 0.4f}, 0.1f, {0.0f, -1.0f}));
  pWorld->Add(CBall({0.15f, 0.7f}, 0.1f));
  return pWorld;
}

// Lets the refusal of `add` through if nothing else has changed by it, in 60 steps before and after.
double Refusal(eColumn column, const std::function<void(CWorld&)>& add) {
  const auto pWorld = MakeBusyWorld(column), pUntouched = MakeBusyWorld(column);
  const auto run = [&] {
    Steps(*pWorld, 60);
    Steps(*pUntouched, 60);
    return HaveSameBits(*pWorld, *pUntouched);
  };
  if (!run()) return g_fNever;
  try {
    add(*pWorld);
  } catch (const std::invalid_argument&) {
    if (run()) throw;
  }
  return g_fNever;
}

double BallRefusal(eColumn column, const CBall& ball) {
  if (column == Reference) {
    CStepped(column, {CPointDesc({0.0f, 0.0f})}, {ball});
    return g_fNever;
  }
  return Refusal(column, [&](CWorld& world) { world.Add(ball); });
}

/// @param set  puts the same value into a world in another way, which is refused as well
CHardCase RefusedBall(const std::string& name, const std::string& input, const CBall& ball,
                      const std::string& words, const std::string& control,
                      const std::function<double()>& fnControl,
                      const std::function<void(CWorld&)>& set = nullptr) {
  return Case(
      name, input, "refused; of all else no bit changes", g_cBits, RefusedByAll(words),
      [ball, set](eColumn column) {
        try {
          if (set && column != Reference) return Refusal(column, set);
        } catch (const std::invalid_argument&) {
        }
        return BallRefusal(column, ball);
      },
      control, fnControl);
}

// v' of a ball of mass m that runs into one of mass 1 at rest.
double AfterImpulse(double m) { return 1.0 - 2.0 * m / (m + 1.0) / m; }

CHardCase NoRadius() {
  const CBall ball({0.0f, 1.0f}, 0.0f, {0.0f, -1.0f});
  CShot shot{{g_cFloor}, {ball}, 1.25f};
  return Named(ShotCase(shot, MeetFloor(ball)), "BallWithoutRadiusMeetsASegment",
               "ball r = 0 at (0, 1), v = (0, -1); segment (-1, 0)-(1, 0); one step of 1.25",
               "t = 1, v' = (0, 1)",
               {{Approximate, Missed("missed: a radius of 0 overlaps nothing")},
                {Box2D, Off(0.005, "as if t = .995: its skin")}},
               "d < r with r = 0 never holds: missed", [] {
                 for (int i = 0; i <= 1000; ++i) // times up to 2, the right one among them
                   if (std::abs(1.0 - i * 0.002) < 0.0) return 0.0;
                 return g_fNever;
               });
}

// The ball falls straight onto something at height y that acts as a point.
CHardCase PointLike(const CAnyShapeDesc& shape, float x, float y, const std::string& name,
                    const std::string& input, const std::string& control,
                    const std::function<double()>& naive) {
  const CShot shot{{shape}, {CBall({x, y + 2.0f}, 0.5f, {0.0f, -1.0f})}, 1.75f};
  return Named(ShotCase(shot, MeetFloor(CBall({x, 2.0f}, 0.5f, {0.0f, -1.0f}))), name,
               input + ", v = (0, -1); one step of 1.75", "acts as a point: t = 1.5, v' = (0, 1)",
               {{Approximate, Off(0.125, "as if t = 1.625: the way after the impact is lost")},
                {Box2D, Off(0.01, "as if t = 1.510: it stops a ball .015 deep")}},
               control, naive);
}

} // namespace

std::vector<CHardCase> ValidationCases() {
  const Vector2 above(0.0f, 3.0f), rest(0.0f, 0.0f);
  return {RefusedBall(
              "BallAtAPlaceThatIsNoNumber", "ball r = 1 at (NaN, 0), point (0, 0); added, or put there",
              CBall({g_fNan, 0.0f}, 1.0f), "m_vPos is (nan, 0)",
              "\"no contact if d >= r\": NaN is a contact, its normal is NaN",
              [] {
                const double x = g_fNan, d = std::hypot(x, 0.0);
                return d >= 1.0 ? 0.0 : x / d;
              },
              [](CWorld& world) { world.SetPos(world.GetBallIds()[0], Vector2(g_fNan, 0.0f)); }),
          RefusedBall(
              "BallOfInfiniteVelocity", "v = (Inf, 0); added, or set",
              CBall({-3.0f, 0.0f}, 1.0f, {g_fInf, 0.0f}), "m_vVel is (inf, 0)", "v - 2 (v.n) n: Inf - Inf",
              [] {
                const double v = g_fNever, n = -1.0;
                return v - 2.0 * (v * n) * n;
              },
              [](CWorld& world) { world.SetVel(world.GetBallIds()[0], Vector2(g_fInf, 0.0f)); }),
          RefusedBall("BallOfNegativeRadius", "ball of r = -1", CBall(above, -1.0f),
                      "m_fRadius is -1: expected a number from 0",
                      "d < r never holds: the ball is met by nothing",
                      [] {
                        const double r = -1.0, d = 0.0; // right on a point
                        return d < r ? 0.0 : g_fNever;
                      }),
          RefusedBall("BallWithoutMass", "ball of m = 0", CBall(above, 0.1f, rest, 0.0f),
                      "m_fMass is 0: expected a number from 1e-36",
                      "impulse 2 m v / (m + 1), then divided by m: 0 / 0", [] { return AfterImpulse(0.0); }),
          RefusedBall("BallOfAMassThatIsNoNumber", "ball of m = NaN", CBall(above, 0.1f, rest, g_fNan),
                      "m_fMass is nan", "the impulse is NaN, for whatever it meets too",
                      [] { return AfterImpulse(g_fNan); }),
          RefusedBall("BallOfNegativeElasticity", "ball of e = -1", CBall(above, 0.1f, rest, 1.0f, -1.0f),
                      "m_fElasticity is -1: expected a number from 0",
                      "v - (1 + e) (v.n) n is v: it flies through the wall",
                      [] {
                        const double e = -1.0, vn = -1.0, after = vn - (1.0 + e) * vn;
                        return std::abs(after - 1.0);
                      }),
          NoRadius(),
          PointLike(CLineSegDesc({1.0f, 1.0f}, {1.0f, 1.0f}), 1.0f, 1.0f, "SegmentWithoutLengthIsAPoint",
                    "segment (1, 1)-(1, 1); ball r = .5 at (1, 3)",
                    "share of the length (q - p0).s / s.s: 0 / 0",
                    [] {
                      const Vector2d q(0.0, 2.0), s(0.0, 0.0);
                      return q.dot(s) / s.dot(s);
                    }),
          PointLike(CLineSegDesc({0.0f, 0.0f}, {1e-30f, 0.0f}), 0.0f, 0.0f,
                    "SegmentWhoseLengthSquaredIsNothing", "segment (0, 0)-(1e-30, 0); ball r = .5 at (0, 2)",
                    "normal s / sqrt(s.s) in float: 1e-60 is 0, NaN",
                    [] {
                      const volatile float s = 1e-30f,
                                           none = 0.0f; // as a processor without wider registers has it
                      const float square = s * s;
                      return Wide(none / std::sqrt(square));
                    }),
          PointLike(CCircleDesc({0.0f, 0.0f}, 0.0f), 0.0f, 0.0f, "CircleWithoutRadiusIsAPoint",
                    "circle R = 0 at (0, 0); ball r = .5 at (0, 2)", "normal (POI - centre) / R: 0 / 0", [] {
                      const double R = 0.0, poi = R * 1.0;
                      return poi / R;
                    })};
}

} // namespace Shapes::HardCases
