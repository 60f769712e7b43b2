// SPDX-License-Identifier: MIT
#include "ShotTesting.h"

#include <algorithm>
#include <cmath>

namespace Shapes::HardCases {

namespace {

CVec<CFifty> Fifty(const Vector2& v) { return {CFifty(v.x()), CFifty(v.y())}; }

void SetTimes(CSeen& seen, const CShot& shot) {
  const CDynamicCircleDesc& ball = shot.m_stdBalls[0];
  CVec2d p = ball.m_vPos.cast<double>(), v = ball.m_vVel.cast<double>();
  if (shot.m_stdBalls.size() > 1) {
    p -= shot.m_stdBalls[1].m_vPos.cast<double>();
    v -= shot.m_stdBalls[1].m_vVel.cast<double>();
  }
  // p_end = p + v t + v' (T - t)
  const CVec2d change = v - seen.m_vVel;
  const CVec2d way = seen.m_vPos - p - seen.m_vVel * static_cast<double>(shot.m_fSeconds);
  if (!change.isZero(0.0)) seen.m_fTime = way.dot(change) / change.squaredNorm();
  const CVec2d centre = seen.m_vPOI + static_cast<double>(ball.m_fRadius) * seen.m_vNorm;
  seen.m_fContactTime = (centre - p).dot(v) / v.squaredNorm();
}

CAnswer Bounce(const CVec<CFifty>& v, const CFifty& t, const CVec<CFifty>& n) {
  return {t, n, v - CFifty(2) * v.dot(n) * n};
}

} // namespace

CSeen Shoot(eColumn column, const CShot& shot) {
  const bool exact = column == eColumn::Reference,
             native = column == eColumn::Native || column == eColumn::Continuous;
  const unsigned steps = exact ? 1 : native || shot.m_nBox2DSteps == 0 ? shot.m_nSteps : shot.m_nBox2DSteps;
  CStepped stepped(column, shot.m_stdShapes, shot.m_stdBalls, shot.m_fSeconds / static_cast<float>(steps),
                   shot.m_vGravity);
  if (exact && shot.m_vExactPos) stepped.SetPos(0, *shot.m_vExactPos);
  CSeen seen;
  std::optional<CImpact> first;
  for (unsigned i = 0; i < steps; ++i) {
    stepped.Step();
    for (const CImpact& impact : stepped.GetImpacts()) {
      ++seen.m_nContacts;
      if (!first && impact.m_bApproaches) first = impact;
    }
  }
  seen.m_vPos = stepped.GetPos();
  seen.m_vVel = stepped.GetVel();
  if (shot.m_stdBalls.size() > 1) {
    seen.m_vPos -= stepped.GetPos(1);
    seen.m_vVel -= stepped.GetVel(1);
  }
  if (first) {
    seen.m_vPOI = first->m_vPOI;
    seen.m_vNorm = first->m_vNorm;
    seen.m_fSetback = first->m_fSetback;
  }
  if (!exact)
    SetTimes(seen, shot);
  else if (first)
    seen.m_fTime = seen.m_fContactTime = first->m_fTime;
  return seen;
}

CAnswer MeetDisc(const CDynamicCircleDesc& ball, float R) {
  const CVec<CFifty> d = Fifty(ball.m_vPos), v = Fifty(ball.m_vVel);
  const CFifty reach = CFifty(R) + CFifty(ball.m_fRadius), a = v.dot(v), b = d.dot(v);
  const CFifty t = (-b - sqrt(CFifty(b * b - a * (d.dot(d) - reach * reach)))) / a;
  return Bounce(v, t, CVec<CFifty>((d + v * t) / reach));
}

CAnswer MeetRing(const CDynamicCircleDesc& ball, float R) {
  const CVec<CFifty> d = Fifty(ball.m_vPos), v = Fifty(ball.m_vVel);
  const CFifty reach = CFifty(R) - CFifty(ball.m_fRadius), a = v.dot(v), b = d.dot(v);
  const CFifty t = (-b + sqrt(CFifty(b * b - a * (d.dot(d) - reach * reach)))) / a;
  return Bounce(v, t, CVec<CFifty>(-(d + v * t) / reach));
}

CAnswer MeetFloor(const CDynamicCircleDesc& ball) {
  const CVec<CFifty> p = Fifty(ball.m_vPos), v = Fifty(ball.m_vVel);
  return Bounce(v, (p.y() - CFifty(ball.m_fRadius)) / -v.y(), CVec<CFifty>(CFifty(0), CFifty(1)));
}

double ErrorOf(const CSeen& seen, const CAnswer& answer) {
  const double time = std::abs(seen.m_fTime - static_cast<double>(answer.m_fTime));
  if (!std::isfinite(time)) return g_fNever;
  return std::max({time, Distance(seen.m_vNorm, answer.m_vNorm.cast<double>()),
                   Distance(seen.m_vVel, answer.m_vVel.cast<double>())});
}

double ErrorOfFlight(const CSeen& seen, const CShot& shot) {
  const CDynamicCircleDesc& ball = shot.m_stdBalls[0];
  const CVec2d p = shot.m_vExactPos.value_or(ball.m_vPos.cast<double>()), v = ball.m_vVel.cast<double>();
  return std::max({Distance(seen.m_vVel, v),
                   Distance(seen.m_vPos, p + v * static_cast<double>(shot.m_fSeconds)),
                   static_cast<double>(seen.m_nContacts)});
}

CExpect Off(double figure, const std::string& figureAndReason) {
  return Deviates(0.5 * figure, 2.0 * figure, figureAndReason);
}

CExpect Missed(const std::string& reason) { return Deviates(g_fNever, g_fNever, reason); }

CExpect& Of(CHardCase& c, eColumn column) { return c.m_stdExpect[static_cast<std::size_t>(column)]; }

CHardCase Named(CHardCase c, const std::string& name, const std::string& input, const std::string& right,
                const std::vector<std::pair<eColumn, CExpect>>& deviations, const std::string& control,
                const std::function<double()>& fnControl) {
  c.m_sName = name;
  c.m_sInput = input;
  if (!right.empty()) c.m_sRight = right;
  for (const auto& [column, expect] : deviations)
    Of(c, column) = expect;
  c.m_sControl = control;
  c.m_fnControl = fnControl;
  return c;
}

CHardCase ShotCase(const CShot& shot, const CAnswer& answer) {
  CHardCase c;
  const double size = std::max(
      {1.0, static_cast<double>(answer.m_fTime), static_cast<double>(answer.m_vVel.cwiseAbs().maxCoeff())});
  c.m_cBound = {8.0 * g_fEps * size, 8.0 * g_fFloatEps * size, "t, n and v' within 8 roundings"};
  c.m_fnError = [shot, answer](eColumn column) { return ErrorOf(Shoot(column, shot), answer); };
  return c;
}

} // namespace Shapes::HardCases
