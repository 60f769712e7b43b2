// SPDX-License-Identifier: MIT
// The way of a ball along what holds it.
#include "Continuous.h"

#include "../../geometry/Swing.h"
#include "Rounding.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Native {

// The curve along which a ball slides, if there is one: of more than one shape where they share an end.
const CHold* CContinuous::GetCurve(const CMoving& ball) const {
  const auto holds = ball.m_cHolds.Get();
  if (holds.empty() || ball.m_bIsInPile || !std::isfinite(holds[0].m_fRadius)) return nullptr;
  for (const CHold& hold : holds)
    if (hold.m_bIsBall || hold.m_fRadius != holds[0].m_fRadius || hold.m_vNorm != holds[0].m_vNorm)
      return nullptr;
  return &holds[0];
}

// Of its acceleration on a curve the ball has that at the beginning. The derivative of it, times a third of
// the time until the next part of its way, takes it to the place where it is then, up to the fourth power of
// that time. With m the unit vector from the middle of the curve, u the velocity along it, g gravity as the
// middle feels it, and R its radius that derivative is -(g m + u^2/R) u/R - 3 (g u) m/R, and what the
// acceleration of the middle changes by.
Vector2d CContinuous::GetBend(const CMoving& ball) const {
  // Its way is looked at only where it may meet something.
  const bool isAlone = !m_bPairs && m_stdShapesFound.size() == ball.m_cHolds.Get().size();
  const CHold* pCurve = isAlone ? nullptr : GetCurve(ball);
  if (pCurve == nullptr) return Vector2d::Zero();
  const CSlide slide = GetSlide(ball, *pCurve, ball.m_vPos, ball.m_vVel, ball.m_fTime);
  const Vector2d& n = pCurve->m_vNorm;
  const double time = std::min(ball.m_fHoldTime, m_fStep - ball.m_fTime), rate = slide.m_fRate;
  const double along = -(slide.m_fOut + rate * rate) * rate * pCurve->m_fRadius,
               out = -3.0 * slide.m_fAlong * rate * pCurve->m_fRadius;
  const CMiddle& middle = slide.m_cMiddle;
  return time / 3.0 * (along * Perp(n) + out * n + middle.m_fTurnSpeed * Perp(middle.GetAcc()));
}

// To where its centre has got on its circle, from which the parabola is off by the fourth power of the time.
// The hold is of where this part of the way began.
void CContinuous::SettleOnCurve(CMoving& ball, const CHold& curve, const CMotion& before, double time) const {
  const CSlide slide = GetSlide(ball, curve, before.m_vPos, before.m_vVel, ball.m_fTime - time);
  const CSwing swing = GetSwing(slide.m_fAlong, slide.m_fOut, slide.m_fRate, time);
  const CTurn turn = GetTurn(swing.m_fAngle);
  const CMiddle& middle = slide.m_cMiddle;
  const double R = curve.m_fRadius;
  ball.m_vPos = middle.PosAt(time) + R * Turned(curve.m_vNorm, turn);
  ball.m_vVel = middle.VelAt(time) + R * swing.m_fRate * Turned(Perp(curve.m_vNorm), turn);
}

// A ball that has slid along a curve up to an impact: along that on to exactly where it touches the shape, as
// its parabola has been off the curve. Where it meets the shape all but along the curve, or is deep in it, it
// stays where it is. Whether the impact is that of its place now.
bool CContinuous::SlideOnto(CMoving& ball, std::uint32_t order, const CMotion& before,
                            CImpact& impact) const {
  const CHold* pCurve = GetCurve(ball);
  FailIf(pCurve == nullptr);
  const double time = impact.m_fTime;
  const CMiddle moving = GetMiddle(ball, *pCurve, before.m_vPos, ball.m_fTime - time);
  const Vector2d middle = moving.PosAt(time), vel = moving.VelAt(time);
  const Vector2d fromMiddle = ball.m_vPos - middle, u = ball.m_vVel - vel;
  CMoving at = ball;
  double angle = 0.0;
  for (int round = 0; round < g_nSlideRounds; ++round) {
    CImpact met;
    double gap;
    if (!Near(m_pShapes->GetGeometry(order), GetMotion(at), ball.m_fTime, g_fSettleReach * ball.m_fRadius,
              met, gap) ||
        (round == 0 && gap < -g_fSettleReach * ball.m_fRadius))
      break;
    FailIf(!(met.m_vNorm.dot(at.m_vVel - met.m_vSurface) < 0.0)); // of another part of the shape
    const bool isThere = std::abs(gap) <= g_fSlideGap * GetRounding(ball, order);
    if (round == 0 || isThere) impact = met, impact.m_fTime = time;
    if (isThere) {
      KeepEnergy(at, before, time);
      ball.m_vPos = at.m_vPos, ball.m_vVel = at.m_vVel;
      break;
    }
    const Vector2d way = Perp(Vector2d(at.m_vPos - middle)); // for a radian
    const double slope = met.m_vNorm.dot(way);
    if (std::abs(slope) < g_fSlideSlope * Norm(way)) break;
    angle -= gap / slope;
    if (!(std::abs(angle) < static_cast<double>(g_fSlideTurn))) break;
    const CTurn turn = GetTurn(angle);
    at.m_vPos = middle + Turned(fromMiddle, turn);
    at.m_vVel = vel + Turned(u, turn);
  }
  return true;
}

// Onto the surfaces that hold it. Whether it needed that.
bool CContinuous::SettleOnAll(CMoving& ball) const {
  bool isMoved = false;
  // Between two of them in turns.
  const int rounds = ball.m_cHolds.Get().size() > 1 ? g_nWedgeRounds : 1;
  for (int round = 0; round < rounds; ++round)
    for (const CHold& hold : ball.m_cHolds.Get()) {
      if (hold.m_bIsBall) continue;
      const CShapeGeometry& geometry = m_pShapes->GetGeometry(hold.m_nOther);
      const bool isFlat = geometry.m_fTurnSpeed == 0.0 && !std::isfinite(hold.m_fRadius);
      if (isFlat && rounds == 1) continue;
      CImpact impact;
      double gap;
      if (!Near(geometry, GetMotion(ball), ball.m_fTime, isFlat ? 0.0 : g_fSettleReach * ball.m_fRadius,
                impact, gap))
        continue;
      // One that is deep in what leaves it no room stays there.
      if (gap < -g_fSettleReach * ball.m_fRadius) continue;
      const Vector2d& n = impact.m_vNorm;
      ball.m_vPos -= gap * n;
      if (isFlat) continue;
      ball.m_vVel -= n.dot(ball.m_vVel - impact.m_vSurface) * n;
      isMoved = true;
    }
  return isMoved;
}

// After a part of its way of `time` seconds.
void CContinuous::Settle(CMoving& ball, const CMotion& before, double time) {
  const CHold* pCurve = GetCurve(ball);
  if (pCurve != nullptr)
    SettleOnCurve(ball, *pCurve, before, time);
  else if (!SettleOnAll(ball))
    return;
  KeepEnergy(ball, before, time);
}

// Where what holds a ball is at rest, or moves evenly, nothing but gravity has done work in the frame of
// that. Where it turns round, its speed is not known better by that than it was.
void CContinuous::KeepEnergy(CMoving& ball, const CMotion& before, double time) const {
  if (ball.m_bIsInPile) return; // balls hold it, too
  const Vector2d vel = m_pShapes->GetGeometry(ball.m_cHolds.Get()[0].m_nOther).m_vVel;
  for (const CHold& hold : ball.m_cHolds.Get()) {
    const CShapeGeometry& o = m_pShapes->GetGeometry(hold.m_nOther);
    if (GetTurnSpeed(ball, hold, o) != 0.0 || o.m_vVel != vel) return;
  }
  const Vector2d u = ball.m_vVel - vel, way = ball.m_vPos - before.m_vPos - time * vel;
  const double square = (before.m_vVel - vel).squaredNorm() + 2.0 * m_vGravity.dot(way);
  const double now = u.squaredNorm();
  if (16.0 * std::abs(square - now) < now) ball.m_vVel = vel + std::sqrt(square / now) * u;
}

} // namespace Shapes::Native
