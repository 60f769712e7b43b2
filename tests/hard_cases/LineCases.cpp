// SPDX-License-Identifier: MIT
// Lines and segments, computed in float.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

// The foot of the perpendicular from q.
CVec<CFifty> FootAt50Digits(const Vector2& p0, const Vector2& p1, const CVec<CFifty>& q) {
  const CVec<CFifty> a = p0.cast<CFifty>(), s = p1.cast<CFifty>() - a;
  return a + (q - a).dot(s) / s.dot(s) * s;
}

// The point of the segment that the ball meets from the side on which it is.
CVec<CFifty> MetAt50Digits(const Vector2& p0, const Vector2& p1, const CDynamicCircleDesc& ball) {
  const CVec<CFifty> q = ball.m_vPos.cast<CFifty>(), v = ball.m_vVel.cast<CFifty>();
  const CVec<CFifty> d = q - FootAt50Digits(p0, p1, q);
  const CFifty gap = sqrt(d.dot(d)), approach = -v.dot(d) / gap, t = (gap - ball.m_fRadius) / approach;
  return FootAt50Digits(p0, p1, q + v * t);
}

// The same as the crossing with the line of gradient -1/m through q.
Vector2d FootByGradients(const Vector2& p0, const Vector2& p1, const Vector2& q) {
  const float m0 = (p1.y() - p0.y()) / (p1.x() - p0.x()), m1 = -1.0f / m0;
  const float b0 = p0.y() - m0 * p0.x(), b1 = q.y() - m1 * q.x();
  const float x = (b1 - b0) / (m0 - m1);
  return Vector2(x, m0 * x + b0).cast<double>();
}

// Where the ball meets the segment is the point closest to its centre. The library is asked for that, too.
CHardCase ClosestPoint(const std::string& name, const std::string& input, const std::string& right,
                       const CBound& bound, const Vector2& p0, const Vector2& p1,
                       const CDynamicCircleDesc& ball, float seconds, const std::string& control) {
  CShot shot{{CLineSegDesc(p0, p1)}, {ball}, seconds};
  const Vector2 q = ball.m_vPos;
  const Vector2d foot = FootAt50Digits(p0, p1, q.cast<CFifty>()).cast<double>();
  const Vector2d met = MetAt50Digits(p0, p1, ball).cast<double>();
  return Case(
      name, input, right, bound, {{Box2D, Off(0.005, "off by .005: its skin")}},
      [=](eColumn column) {
        const double error = Distance(Shoot(column, shot).m_vPOI, met);
        if (column != Approximate) return error;
        const CLineSegDesc desc(p0, p1);
        return std::max({error, Distance(Wide(CLineSeg(desc).ClosestPt(q)), foot),
                         Distance(Wide(CLine(p0, desc.GetGradient()).ClosestPt(q)), foot)});
      },
      control, [=] { return Distance(FootByGradients(p0, p1, q), foot); });
}

// Infinite unless the answer is that there is none.
double ErrorOfNoCrossing(const CLine& a, const CLine& b) {
  return a.Intersect(b) == Vector2(g_fInf, g_fInf) ? 0.0 : g_fNever;
}

CHardCase NoCrossing(const std::string& name, const std::string& input, const std::function<double()>& error,
                     const std::string& control, const std::function<double()>& naive) {
  const CExpect none = NotAsked("no engine crosses lines");
  return Case(
      name, input, "no point: (Inf, Inf), which nothing in the library uses", g_cBits,
      {{Native, none}, {Box2D, none}, {Tuned, none}, {Reference, none}}, [=](eColumn) { return error(); },
      control, naive);
}

CHardCase OfEqualGradient() {
  return NoCrossing(
      "CrossingOfLinesOfEqualGradient",
      "lines of equal gradient (0, 1, -1/3, 1e-20, 1e20) through (0, 0) and (0, 1)",
      [] {
        return WorstOf({0.0f, 1.0f, -1.0f / 3.0f, 1e-20f, 1e20f}, [](float m) {
          return ErrorOfNoCrossing(CLine({0.0f, 0.0f}, m), CLine({0.0f, 1.0f}, m));
        });
      },
      "x = (b1 - b0) / (m0 - m1) = 1 / 0 taken for a point of impact: its normal is NaN",
      [] {
        const double gradients = 0.0, x = 1.0 / gradients;
        return x / std::abs(x);
      });
}

CHardCase OfVerticalLines() {
  return NoCrossing(
      "CrossingOfVerticalLinesOfEitherSign", "lines of gradient +Inf through (0, 0) and -Inf through (1, 0)",
      [] {
        const CLine up({0.0f, 0.0f}, g_fInf), down({1.0f, 0.0f}, -g_fInf);
        return std::max(ErrorOfNoCrossing(up, down), ErrorOfNoCrossing(down, up));
      },
      "parallel if m0 == m1: +Inf is not -Inf; they cross at NaN",
      [] {
        const double m0 = g_fNever, m1 = -g_fNever, b0 = 0.0, b1 = 0.0 - m1 * 1.0;
        return m0 == m1 ? 0.0 : (b1 - b0) / (m0 - m1);
      });
}

CHardCase BetweenVerticalSegments() {
  CShot shot{{CLineSegDesc({-1.0f, -1.0f}, {-1.0f, 1.0f}), CLineSegDesc({1.0f, 1.0f}, {1.0f, -1.0f})},
             {CDynamicCircleDesc({0.0f, 0.0f}, 0.5f, {1.0f, 0.0f})},
             0.75f};
  const CVec<CFifty> back(CFifty(-1), CFifty(0));
  const CAnswer right{CFifty(0.5), back, back}, left{CFifty(0.5), -back, -back};
  CHardCase c =
      Named(ShotCase(shot, right), "BallBetweenVerticalSegmentsGivenUpAndDown",
            "segments (-1, -1)-(-1, 1) and (1, 1)-(1, -1); ball r = .5 at (0, 0), v = (1, 0) and (-1, 0); "
            "one step of .75",
            "t = .5, back where it came from",
            {{Approximate, Off(0.125, "as if t = .625: the way after the impact is lost")},
             {Box2D, Off(0.00031, "as if t = .5003: its skin")}},
            "side by y - (m x + b): Inf - Inf", [] {
              const double m = g_fNever, x = 1.0, b = 1.0 - m * x;
              return 0.0 - (m * x + b);
            });
  CShot toTheLeft = shot;
  toTheLeft.m_stdBalls[0].m_vVel = {-1.0f, 0.0f};
  c.m_fnError = [=](eColumn column) {
    return std::max(ErrorOf(Shoot(column, shot), right), ErrorOf(Shoot(column, toTheLeft), left));
  };
  return c;
}

} // namespace

std::vector<CHardCase> LineCases() {
  return {ClosestPoint("ClosestPointOfAHorizontalSegment",
                       "segment (0, 0)-(1, 0), q = (.5, .5); met by a ball r = .25 from q", "(.5, 0)",
                       {8.0 * g_fDoubleRounding, 4.0 * g_fUlp, "4 roundings"}, {0.0f, 0.0f}, {1.0f, 0.0f},
                       CDynamicCircleDesc({0.5f, 0.5f}, 0.25f, {0.0f, -1.0f}), 0.375f,
                       "crossing with the line of gradient -1 / 0: NaN"),
          ClosestPoint(
              "ClosestPointOfANearlyVerticalSegment",
              "segment (500, 0)-(500.001, 600), q = (510, 300); met by a ball r = 9.5 from q, v = "
              "(-10, 0)",
              "(500.0005, 300.0000167)",
              {16.0 * 1000.0 * g_fDoubleRounding, 1e-3, "8 roundings of 1000: 1.8e-12; engines 1e-3"},
              {500.0f, 0.0f}, {500.001f, 600.0f}, CDynamicCircleDesc({510.0f, 300.0f}, 9.5f, {-10.0f, 0.0f}),
              0.1f, "crossing with the line of gradient -1/m: (500.0005, 288), off by 12"),
          OfEqualGradient(), OfVerticalLines(), BetweenVerticalSegments()};
}

} // namespace Shapes::HardCases
