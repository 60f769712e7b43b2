// SPDX-License-Identifier: MIT
// Arcs: where they begin and end, and what is at their angles.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

constexpr double g_fDegree = std::numbers::pi / 180.0;

float Degrees(double degrees) { return static_cast<float>(degrees * g_fDegree); }

// The ball r = .1 that comes from the right to the arc R = 1 about the origin; met at t = .9.
CShot FromTheRight(float a0, float a1, const Vector2& direction = {1.0f, 0.0f}) {
  return {{CArcDesc({0.0f, 0.0f}, 1.0f, a0, a1)},
          {CDynamicCircleDesc(2.0f * direction, 0.1f, -direction)},
          0.925f};
}

CHardCase ArcCase(const CShot& shot, const std::string& name, const std::string& input,
                  const std::string& right, const CExpect& shipped, const std::string& control,
                  const std::function<double()>& naive) {
  const CExpect late = Off(0.0125, "as if t = .9125: the way after the impact is lost");
  return Named(ShotCase(shot, MeetDisc(shot.m_stdBalls[0], 1.0f)), name, input, right,
               {{Approximate, late}, {Box2D, shipped}}, control, naive);
}

// Met if the angle is between the ends, which is no test for a sector that contains 0.
double BetweenAngles(double a0, double a1, double a) { return a0 <= a && a <= a1 ? 0.0 : g_fNever; }

CHardCase EqualAngles() {
  CHardCase c =
      ArcCase(FromTheRight(0.0f, 0.0f), "ArcOfEqualAnglesIsTheFullCircle",
              "arc R = 1 from 0 to 0; ball r = .1 from 17 directions, at a distance of 2; one step of .925",
              "the full circle: t = .9, n is the direction",
              Off(0.17, "v' off by up to .17 radians: it bounces off chords"),
              "in the sector if a0 <= a <= a1: from one direction only",
              [] { return BetweenAngles(0.0, 0.0, std::atan2(1.0, 1.0)); });
  c.m_fnError = [](eColumn column) {
    return WorstOf(17, [=](int i) {
      const CShot shot = FromTheRight(0.0f, 0.0f, AngleToVector(Degrees(360.0 / 17.0 * i)));
      return ErrorOf(Shoot(column, shot), MeetDisc(shot.m_stdBalls[0], 1.0f));
    });
  };
  return c;
}

// Largest distance from 0 of what becomes of a tiny negative angle.
double ErrorOfTinyAngle(eColumn column) {
  const CPointDesc point = Turning(CPointDesc({1.0f, 0.0f}));
  if (column == Reference) {
    Compare::CReference<double> reference(std::vector<CAnyShapeDesc>{point}, {}, Vector2::Zero());
    reference.SetOrientation(0, -1e-17);
    return std::abs(reference.GetOrientation(0));
  }
  const float angle = -1e-9f;
  const auto pWorld = MakeWorld(column);
  const CShapeId turned = pWorld->Add(point), arc = pWorld->Add(CArcDesc({0.0f, 0.0f}, 1.0f, angle, 1.0f));
  pWorld->SetOrientation(turned, angle);
  const auto& shape = static_cast<const CArc&>(pWorld->GetShape(arc));
  return Wide(std::max(
      {std::abs(NormalizeAngle(angle)), std::abs(shape.GetAngle0()), pWorld->GetOrientation(turned)}));
}

CHardCase ShortArc() {
  CHardCase c = ArcCase(FromTheRight(0.0f, 1e-7f), "ArcAlmostWithoutLength",
                        "arc R = 1 from 0 to 1e-7 radians; the same ball", "t = .9, n = (1, 0)",
                        Off(0.01, "as if t = .910: a point to it, which stops a ball .015 deep"),
                        "chords of 1 degree: int(span / step) is none",
                        [] { return static_cast<int>(1e-7 / g_fDegree) > 0 ? 0.0 : g_fNever; });
  c.m_cBound = {1e-7, 8.0 * g_fUlp, "1e-7 of t, n and v'; engines 8 roundings"};
  return c;
}

// The end of the arc R = 1 at this angle, met as a point by a ball from the right.
CAnswer MeetEnd(const CDynamicCircleDesc& ball, float angle) {
  const CVec<CFifty> end(cos(CFifty(angle)), sin(CFifty(angle)));
  const CFifty r(ball.m_fRadius), across = CFifty(ball.m_vPos.y()) - end.y();
  const CFifty along = sqrt(CFifty(r * r - across * across));
  const CVec<CFifty> n(along / r, across / r);
  const CFifty t = CFifty(ball.m_vPos.x()) - end.x() - along;
  return {t, n, {CFifty(2) * n.x() * n.x() - CFifty(1), CFifty(2) * n.x() * n.y()}};
}

CHardCase Slit() {
  const double slit = 1e-6;
  const auto a0 = static_cast<float>(slit), a1 = static_cast<float>(2.0 * std::numbers::pi - slit);
  const CShot shot = FromTheRight(a0, a1);
  // The rounded angles are not alike: end 1 is met first.
  CHardCase c = ShotCase(shot, MeetEnd(shot.m_stdBalls[0], a1));
  c.m_cBound = {1e-6, 1e-6, "1e-6 of t, n and v'"};
  return Named(c, "ArcWithASlitThatIsTooNarrow",
               "arc R = 1 from 1e-6 to 2 pi - 1e-6, a slit of 2e-6; the same ball",
               "meets the ends: t = .9, thrown back",
               {{Approximate, Missed("flies through the slit: ends are open where no point guards them")},
                {Box2D, Off(3.6e-5, "v' off by .00004 radians: its skin")}},
               "the circle's root counts where the centre is in the sector: never",
               [=] { return BetweenAngles(Wide(a0), Wide(a1), std::atan2(0.0, 1.1)); });
}

CHardCase ThroughTheOpening() {
  CShot shot = FromTheRight(Degrees(45.0), Degrees(315.0));
  shot.m_stdBalls[0].m_vPos = {3.0f, 0.0f};
  shot.m_fSeconds = 3.925f;
  shot.m_nBox2DSteps = 2;
  return Named(
      ShotCase(shot, MeetRing(shot.m_stdBalls[0], 1.0f)), "BallThroughTheOpeningOfAnArc",
      "arc R = 1 from 45 to 315 degrees; ball r = .1 at (3, 0), v = (-1, 0); one step of 3.925, on Box2D two",
      "enters and meets the far side from inside: t = 3.9, n = (1, 0)",
      {{Approximate, Off(0.0125, "as if t = 3.9125: the way after the impact is lost")},
       {Box2D, Off(0.146, "v' off by .15 radians: it bounces off a chord")}},
      "the first root of the full circle: t = 1.9", [] { return 3.9 - 1.9; });
}

CHardCase AtTheTopOfAShortArc() {
  CShot shot{{CArcDesc({0.0f, 0.0f}, 1.0f, Degrees(80.0), Degrees(100.0))},
             {CDynamicCircleDesc({0.0f, 1.5f}, 0.1f, {0.0f, -1.0f})},
             0.41f};
  return Named(
      ShotCase(shot, MeetDisc(shot.m_stdBalls[0], 1.0f)), "BallAtTheTopOfAShortArc",
      "the same arc; ball r = .1 at (0, 1.5), v = (0, -1); one step of .41, so it is .01 too deep at most",
      "t = .4, n = (0, 1)",
      {{Approximate, Off(0.005, "as if t = .405: the way after the impact is lost")},
       {Box2D, Off(2e-5, "as if t = .40002: it meets a corner of its chords")}},
      "box of the ends: the ball is .005 above it at the end", [] {
        const double low = 1.5 - 0.41 - 0.1, top = std::sin(80.0 * g_fDegree);
        return low <= top ? 0.0 : g_fNever;
      });
}

} // namespace

std::vector<CHardCase> ArcCases() {
  return {ArcCase(FromTheRight(Degrees(350.0), Degrees(10.0)), "ArcAcrossAngleZero",
                  "arc R = 1 from 350 to 10 degrees; ball r = .1 at (2, 0), v = (-1, 0); one step of .925",
                  "t = .9, n = (1, 0)", Off(2e-5, "as if t = .90002: it meets a corner of its chords"),
                  "in the sector if a0 <= a <= a1: never",
                  [] { return BetweenAngles(350.0 * g_fDegree, 10.0 * g_fDegree, std::atan2(0.0, 1.0)); }),
          EqualAngles(),
          Case("TinyNegativeAngleStaysBelowAFullTurn",
               "angle -1e-9 in float (reference: -1e-17), of an arc and of an orientation", "in [0, 2 pi): 0",
               g_cBits, {}, ErrorOfTinyAngle, "a + 2 pi in float: 6.2831855, above 2 pi",
               [] {
                 const volatile float a = -1e-9f;
                 return Wide(a + g_fTwoPi);
               }),
          ShortArc(),
          Slit(),
          ThroughTheOpening(),
          Case(
              "BallTooLargeInsideAFullArc",
              "full arc R = 1, ball r = 1.5 inside at (.25, 0), v = (.5, 0), (-.5, 0) and 0; one step of .25",
              "it cannot touch the inside: ignored, it flies on", g_cTwoUlps,
              {{Box2D, Off(2.6, "thrown out through the arc, by 2.6 units in the step")}},
              [](eColumn column) {
                return WorstOf({0.5f, -0.5f, 0.0f}, [=](float v) {
                  const CShot shot{{CArcDesc({0.0f, 0.0f}, 1.0f, 0.0f, 0.0f)},
                                   {CDynamicCircleDesc({0.25f, 0.0f}, 1.5f, {v, 0.0f})},
                                   0.25f};
                  return ErrorOfFlight(Shoot(column, shot), shot);
                });
              },
              "overlaps if R - d < r, put to d = R - r = -.5: to the other side and back in every step",
              [] {
                const double d = 0.25, R = 1.0, r = 1.5;
                return R - d < r ? std::abs((R - r) - d) : 0.0;
              }),
          Case(
              "BoxOfAnArcAcrossItsTop", "arc R = 1 from 80 to 100 degrees: its box", "up to y = 1",
              {g_fUlp, g_fUlp, "1 rounding of float"}, {{Reference, NotAsked("keeps its boxes to itself")}},
              [](eColumn column) {
                const auto pWorld = MakeWorld(column);
                const CShapeId arc = pWorld->Add(CArcDesc({0.0f, 0.0f}, 1.0f, Degrees(80.0), Degrees(100.0)));
                return std::abs(Wide(pWorld->GetShape(arc).GetAABB().GetTopLeft().y()) - 1.0);
              },
              "box of the ends: y = .98481",
              [] { return 1.0 - std::max(std::sin(80.0 * g_fDegree), std::sin(100.0 * g_fDegree)); }),
          AtTheTopOfAShortArc()};
}

} // namespace Shapes::HardCases
