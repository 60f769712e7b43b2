// SPDX-License-Identifier: MIT
// Balls that touch a little, not quite, or all the time; and curved ways.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

// A ball r = 1 that flies past the point (0, 0), from 10 units away; in the reference at a height that no
// float has.
CShot Past(eColumn column, float y, double exactly) {
  CShot shot{{CPointDesc({0.0f, 0.0f})}, {CDynamicCircleDesc({-10.0f, y}, 1.0f, {1.0f, 0.0f})}, 10.5f};
  shot.m_nBox2DSteps = 7;
  if (column == Reference) shot.m_vExactPos = Vector2d(-10.0, exactly);
  return shot;
}

CAnswer PastAt50Digits(double y) {
  const CFifty h(y), x = -sqrt(CFifty(CFifty(1) - h * h));
  return {CFifty(10) + x, {x, h}, {CFifty(1) - CFifty(2) * x * x, -CFifty(2) * x * h}};
}

// The radicand of the quadratic equation, in float: all digits of c = d.d - r r cancel.
float UnderTheRoot(float y) {
  const volatile float dd = 100.0f + y * y; // as a processor without wider registers has it
  const float c = dd - 1.0f;
  return 100.0f - c;
}

CHardCase JustTouching() {
  const double y = 1.0 - 1e-12;
  const float yFloat = 1.0f - 0x1p-24f;
  return Case(
      "BallThatJustTouchesAPoint",
      "point (0, 0); ball r = 1 at (-10, 1 - 1e-12), in float (-10, 1 - 6e-8), v = (1, 0)",
      "t = 9.99999858578644 (float: 9.99965473), turned by 2.8e-6 (6.9e-4) radians",
      {2e-9, 8.0 * 10.0 * g_fUlp,
       "t, n and v' within 2e-9, a rounding of 10 over the slope sqrt(2e-12); engines 8 roundings of 10"},
      {{Approximate, Missed("flies past: at the end of the step it is beyond")},
       {Box2D, Missed("flies past: it stops a ball only where it is .015 deep")},
       {Tuned, Missed("flies past: so slight an overlap does not stop Box2D")}},
      [=](eColumn column) {
        CSeen seen = Shoot(column, Past(column, yFloat, y));
        if (column == Reference) return ErrorOf(seen, PastAt50Digits(y));
        // Where it was met tells the time better than so small a change of velocity.
        if (std::isfinite(seen.m_fTime)) seen.m_fTime = seen.m_fContactTime;
        return ErrorOf(seen, PastAt50Digits(Wide(yFloat)));
      },
      "quadratic in float, -b - sqrt(b b - (d.d - r r)): all digits cancel",
      [=] {
        const float root = std::sqrt(std::max(0.0f, UnderTheRoot(yFloat)));
        return std::abs(Wide(10.0f - root - static_cast<float>(PastAt50Digits(Wide(yFloat)).m_fTime)));
      });
}

CHardCase JustMissing() {
  const float yFloat = 1.0f + 0x1p-23f;
  return Case(
      "BallThatJustMissesAPoint", "the same at (-10, 1 + 1e-12), in float (-10, 1 + 1.2e-7)", "flies past",
      {1e-12, 8.0 * g_fUlp, "1e-12 of p and v; engines 8 roundings"}, {},
      [=](eColumn column) {
        const CShot shot = Past(column, yFloat, 1.0 + 1e-12);
        return ErrorOfFlight(Shoot(column, shot), shot);
      },
      "the same quadratic: a root of 0 is taken for a touch",
      [=] { return UnderTheRoot(yFloat) >= 0.0f ? g_fNever : 0.0; });
}

constexpr int g_nSlideSteps = 10000;
constexpr float g_fSlider = 0.1f;

// Largest change of height or velocity of a ball that slides along a segment without pressing on it.
double ErrorOfSliding(eColumn column) {
  CStepped stepped(column, {CLineSegDesc({-1.0f, 0.0f}, {200.0f, 0.0f})},
                   {CDynamicCircleDesc({0.0f, g_fSlider}, g_fSlider, {1.0f, 0.0f})});
  return WorstOf(g_nSlideSteps, [&](int) {
    stepped.Step();
    return Worst(std::abs(stepped.GetPos().y() - Wide(g_fSlider)), Distance(stepped.GetVel(), {1.0, 0.0}));
  });
}

// Time at which |p + v t + g t^2 / 2| falls to R, by halving, between 0 and where it is closest or later.
CFifty MeetOnParabola(const CDynamicCircleDesc& ball, const Vector2& g, double after) {
  const CVec<CFifty> p = ball.m_vPos.cast<CFifty>(), v = ball.m_vVel.cast<CFifty>(), a = g.cast<CFifty>();
  CFifty low(0), high(after);
  for (int i = 0; i < 170; ++i) {
    const CFifty t = (low + high) / 2;
    const CVec<CFifty> x = p + v * t + a * (t * t / 2);
    const bool isApart = x.dot(x) > CFifty(ball.m_fRadius) * CFifty(ball.m_fRadius);
    (isApart ? low : high) = t;
  }
  return low;
}

CHardCase OnAParabola() {
  CShot shot{{CPointDesc({0.0f, 0.0f})}, {CDynamicCircleDesc({-1.0f, 0.5f}, 0.3f, {3.0f, 0.0f})}, 0.3f};
  shot.m_vGravity = {0.0f, -9.8f};
  shot.m_nSteps = 18;
  const CFifty right = MeetOnParabola(shot.m_stdBalls[0], shot.m_vGravity, 0.3);
  return Case(
      "BallOnAParabolaMeetsAPoint",
      "point (0, 0); ball r = .3 at (-1, .5), v = (3, 0), gravity (0, -9.8); 60 steps a second",
      "t = .254193423748269", {1e-12, 8.0 * g_fUlp, "1e-12 of t; engines 8 roundings"},
      {{Approximate, Off(0.0047, ".0047 early: met at the end of the step, and v changes once in a step")},
       {Box2D, Off(0.00066, ".0007 late: v changes once in a step, and it stops a ball .015 deep")}},
      [=](eColumn column) {
        return Worst(0.0, std::abs(Shoot(column, shot).m_fContactTime - static_cast<double>(right)));
      },
      "straight on with its first velocity: .2 above the point, missed",
      [] { return 0.5 < 0.3 ? 0.0 : g_fNever; });
}

CHardCase TwoThatFall() {
  CShot shot;
  shot.m_stdBalls = {CDynamicCircleDesc({-2.0f, 0.3f}, 0.25f, {4.0f, 0.0f}),
                     CDynamicCircleDesc({0.0f, 0.0f}, 0.25f)};
  shot.m_vGravity = {0.0f, -9.8f};
  shot.m_fSeconds = 0.45f;
  shot.m_nSteps = 27;
  const CAnswer answer = MeetDisc(shot.m_stdBalls[0], 0.25f);
  return Named(
      ShotCase(shot, answer), "TwoBallsThatFallTogether",
      "balls r = .25 at (-2, .3), v = (4, 0), and at (0, 0) at rest, gravity (0, -9.8); 27 steps of 1/60",
      "gravity cancels: t = .4, n = (-.8, .6), relative v' = (-1.12, 3.84)",
      {{Approximate, Off(0.70, "v' off by .18 radians: n is that at the end of the step")},
       {Box2D,
        Off(0.70, "v' off by .18 radians: it does not sweep balls, n is that at the end of the step")}},
      "only the first one falls in the equation: t = .55", [=] {
        const CDynamicCircleDesc first({-2.0f, 0.3f}, 0.5f, {4.0f, 0.0f});
        return static_cast<double>(MeetOnParabola(first, {0.0f, -9.8f}, 0.45) - answer.m_fTime);
      });
}

} // namespace

std::vector<CHardCase> GrazingCases() {
  return {
      JustTouching(), JustMissing(),
      Case("BallThatSlidesAlongASegment",
           "segment (-1, 0)-(200, 0); ball r = .1 at (0, .1), v = (1, 0), no gravity; 10,000 steps of 1/60",
           "y and v keep their bits", {1e-12, 1e-12, "1e-12 of y and v, less than a rounding of float"},
           {{Box2D, Off(0.005, "lifted by .005: its skin")}}, ErrorOfSliding,
           "normal by its angle, cos(pi / 2) = -4.4e-8 in float: v is off by 8.7e-8",
           [] {
             const Vector2 n(std::cos(g_fPi / 2.0f), std::sin(g_fPi / 2.0f));
             Vector2 v(1.0f, 0.0f);
             for (int i = 0; i < g_nSlideSteps; ++i)
               if (v.dot(n) < 0.0f) v -= 2.0f * v.dot(n) * n;
             return Wide(v.y());
           }),
      OnAParabola(), TwoThatFall()};
}

} // namespace Shapes::HardCases
