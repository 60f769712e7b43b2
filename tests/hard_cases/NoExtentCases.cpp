// SPDX-License-Identifier: MIT
// Balls and shapes of no extent.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

using CBall = CDynamicCircleDesc;

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

std::vector<CHardCase> NoExtentCases() {
  return {NoRadius(),
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
