// SPDX-License-Identifier: MIT
// Balls whose centre is where no direction leads from.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

// The ball is put exactly onto the shape, and goes on for a quarter of a second. Native looks at the end of a
// step, so there it begins one step back and is on the shape when it is looked at.
struct COnTheSpot {
  CAnyShapeDesc m_cShape;
  Vector2 m_vVel;
  Vector2d m_vNorm, m_vAfter; ///< What is right.
};

constexpr float g_fRadius = 0.5f;
constexpr float g_fStep = 0.25f;

// Largest error of the normal, of the velocity after, and of the setback, which is to be r.
double ErrorOnTheSpot(eColumn column, const COnTheSpot& c) {
  const bool approximate = column == Approximate;
  CShot shot{
      {c.m_cShape},
      {CDynamicCircleDesc(approximate ? Vector2(-g_fStep * c.m_vVel) : Vector2::Zero(), g_fRadius, c.m_vVel)},
      g_fStep};
  const CSeen seen = Shoot(column, shot);
  // The reference leaves what overlaps where it is, and tells how deep it is; worlds put it back.
  const double flown = approximate ? 0.0 : Wide(g_fStep);
  const Vector2d pushed = seen.m_vPos - flown * c.m_vAfter;
  const double setback = column == Reference ? seen.m_fSetback - pushed.norm() : pushed.dot(c.m_vNorm);
  return std::max({Distance(seen.m_vNorm, c.m_vNorm), Distance(seen.m_vVel, c.m_vAfter),
                   std::abs(setback - Wide(g_fRadius))});
}

double NoDirection() {
  const double s = 0.0; // a distance
  return s / std::abs(s);
}

CHardCase OnTheSpot(const std::string& name, const std::string& input, const std::string& right,
                    const COnTheSpot& onTheSpot, const CExpect& shipped, const CExpect& tuned,
                    const std::string& control) {
  return Case(
      name, input, right, g_cTwoUlps, {{Box2D, shipped}, {Tuned, tuned}},
      [=](eColumn column) { return ErrorOnTheSpot(column, onTheSpot); }, control, NoDirection);
}

CShot InFullArc(float R, float r, const Vector2& v, float seconds) {
  return {{CArcDesc({0.0f, 0.0f}, R, 0.0f, 0.0f)}, {CDynamicCircleDesc({0.0f, 0.0f}, r, v)}, seconds};
}

CHardCase InTheMiddle() {
  const CShot flight = InFullArc(2.0f, 0.5f, {1.0f, 0.0f}, 1.75f),
              rest = InFullArc(2.0f, 0.5f, {0.0f, 0.0f}, 1.75f);
  const CAnswer answer = MeetRing(flight.m_stdBalls[0], 2.0f);
  return Case(
      "CentreInTheMiddleOfAFullArc",
      "ball r = .5 in the middle of a full arc R = 2: at rest, and with v = (1, 0); one step of 1.75",
      "at rest no contact; else the gap is 1.5: t = 1.5, n = (-1, 0), v' = (-1, 0)",
      {1e-12, 8.0 * 1.5 * g_fUlp, "1e-12 of t, n and v'; engines 8 roundings"},
      {{Approximate, Off(0.125, "as if t = 1.625: the way after the impact is lost")},
       {Box2D, Off(0.12, "v' off by .12 radians: it bounces off a chord")}},
      [=](eColumn column) {
        return Worst(ErrorOfFlight(Shoot(column, rest), rest), ErrorOf(Shoot(column, flight), answer));
      },
      "closest point: R p over the length of p, 0 / 0", NoDirection);
}

// How far two balls of r = .5 that are on each other at rest are from where they belong after a step.
double ErrorOfParting(eColumn column) {
  const float m0 = 1.0f, m1 = 3.0f;
  CStepped stepped(column, {},
                   {CDynamicCircleDesc({0.0f, 0.0f}, 0.5f, {0.0f, 0.0f}, m0),
                    CDynamicCircleDesc({0.0f, 0.0f}, 0.5f, {0.0f, 0.0f}, m1)});
  stepped.Step();
  const Vector2d p0 = stepped.GetPos(0), p1 = stepped.GetPos(1), none = Vector2d::Zero();
  const double w0 = Wide(m0), w1 = Wide(m1);
  return std::max({std::abs(p0.norm() - w1 / (w0 + w1)), std::abs(p1.norm() - w0 / (w0 + w1)),
                   Distance(w0 * p0 + w1 * p1, none), Distance(stepped.GetVel(0), none),
                   Distance(stepped.GetVel(1), none)});
}

} // namespace

std::vector<CHardCase> CoincidentCases() {
  const CLineSegDesc seg({-1.0f, 0.0f}, {1.0f, 0.0f});
  const CExpect notSetBack = Off(0.5, "n and v' right, set back by 0 instead of .5");
  return {OnTheSpot("CentreExactlyOnAPoint", "ball r = .5, its centre on the point, v = (1, 0)",
                    "against v: n = (-1, 0), setback r, v' = (-1, 0)",
                    {CPointDesc({0.0f, 0.0f}), {1.0f, 0.0f}, {-1.0, 0.0}, {-1.0, 0.0}},
                    Missed("flies on: its normal there is always (1, 0)"), notSetBack,
                    "n = p over its length: 0 / 0"),
          OnTheSpot("CentreExactlyOnASegmentFromAbove",
                    "ball r = .5, its centre on the segment (-1, 0)-(1, 0), v = (1, -1)",
                    "to where it came from: n = (0, 1), setback r, v' = (1, 1)",
                    {seg, {1.0f, -1.0f}, {0.0, 1.0}, {1.0, 1.0}},
                    Missed("flies on: its normal there is always (0, -1)"), notSetBack,
                    "n = q - foot over its length: 0 / 0"),
          OnTheSpot("CentreExactlyOnASegmentFromBelow", "the same from below, v = (1, 1)",
                    "n = (0, -1), setback r, v' = (1, -1)", {seg, {1.0f, 1.0f}, {0.0, -1.0}, {1.0, -1.0}},
                    Off(0.376, "n and v' right by chance: that is its normal there; set back by .12 instead "
                               "of .5"),
                    Missed("flies on: it takes it to be above"), "n = q - foot over its length: 0 / 0"),
          InTheMiddle(),
          Case(
              "BallInTheMiddleOfAFullArcOfItsOwnSize",
              "ball r = 1 in the middle of a full arc R = 1: at rest, and with v = (1, 0); one step of .25",
              "it has no room inside, so it has no inner contact: flies on", g_cTwoUlps,
              {{Box2D, Off(8.6, "thrown out through the arc, with 8.6 times its speed")}},
              [](eColumn column) {
                return WorstOf({0.0f, 1.0f}, [=](float v) {
                  const CShot shot = InFullArc(1.0f, 1.0f, {v, 0.0f}, 0.25f);
                  return ErrorOfFlight(Shoot(column, shot), shot);
                });
              },
              "n = -p over its length: 0 / 0", NoDirection),
          Case("TwoBallsAtOnePlace",
               "two balls r = .5 of m = 1 and 3, both at rest at (0, 0); one step of 1/60",
               "apart by .75 and .25 along one line; the centre of mass stays, v' = 0", g_cTwoUlps,
               {{Box2D, Off(0.75, "they stay on each other for good")},
                {Tuned, Off(0.64, "apart by .11 and .04, right after some steps")},
                {Reference, NotAsked("leaves what overlaps where it is")}},
               ErrorOfParting, "n = p1 - p0 over its length: 0 / 0", NoDirection)};
}

} // namespace Shapes::HardCases
