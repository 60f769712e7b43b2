// SPDX-License-Identifier: MIT
// Contact that lasts: balls that lie on shapes or slide along them, and balls that rest on each other.
#include "Continuous.h"

#include "../../shapes/Response.h"
#include "Rounding.h"

#include <algorithm>
#include <limits>

namespace Shapes::Native {

// Whether the ball is deep in a one-sided shape through which it has come from behind.
bool CContinuous::IsPassing(const CMoving& ball, std::uint32_t order, const CImpact& impact,
                            double gap) const {
  FailIf(m_pShapes->GetGeometry(order).m_eSides == eSides::Both || gap >= -GetRounding(ball, order));
  return impact.m_vNorm.dot(ball.m_vVel - impact.m_vSurface) > m_cResting.GetSlow();
}

// Pairs of balls that touch or could by the end of the substep, and the shapes around these balls. They are
// separated where they overlap.
void CContinuous::FindRestingContacts() {
  if (!m_bPairs) return;
  const auto n = static_cast<std::uint32_t>(m_stdBalls.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    if (m_stdBalls[i].m_bIsAsleep) continue;
    FindBalls(i);
    for (const std::uint32_t j : m_stdBallsFound) {
      CMoving &ball = m_stdBalls[i], &other = m_stdBalls[j];
      if (j <= i || other.m_bIsAsleep) continue;
      CImpact impact;
      double gap;
      const double reach =
          m_cResting.GetReach(CRestingContacts::IsSqueezed(ball, other), Norm(ball.m_vVel - other.m_vVel),
                              std::min(ball.m_fRadius, other.m_fRadius));
      if (!NearBallBall(GetMotion(other), GetMotion(ball), reach, impact, gap)) continue;
      m_cResting.Add(i, j, true, GetId(ball), GetId(other), impact, gap, true);
      ball.m_bIsNearBall = other.m_bIsNearBall = true;
      ball.m_fNearRadius = std::max(ball.m_fNearRadius, other.m_fRadius);
      other.m_fNearRadius = std::max(other.m_fNearRadius, ball.m_fRadius);
    }
  }
  if (m_cResting.IsEmpty()) return;
  for (std::uint32_t i = 0; i < n; ++i) {
    const CMoving& ball = m_stdBalls[i];
    if (!ball.m_bIsNearBall) continue;
    // Balls that overlap may be moved towards shapes.
    const auto getReach = [&](double speed) {
      return m_cResting.GetReach(ball.m_bWasSqueezed, speed, ball.m_fRadius) +
             g_fFarCorrection * ball.m_fNearRadius;
    };
    FindShapes(i, static_cast<float>(getReach(Norm(ball.m_vVel))));
    for (const std::uint32_t order : m_stdShapesFound) {
      CImpact impact;
      double gap;
      const Vector2d surface = m_pShapes->GetGeometry(order).GetSurfaceVelocity(ball.m_vPos, 0.0);
      const double far = getReach(Norm(ball.m_vVel - surface));
      if (m_pShapes->Get(order).m_pShape->GetCanCollide() &&
          IsNearShape(order, GetMotion(ball), 0.0, far, impact, gap) && !IsPassing(ball, order, impact, gap))
        m_cResting.Add(i, order, false, GetId(ball), m_pShapes->Get(order).m_cId, impact, gap,
                       CanFollow(ball, order, impact.m_fRadius + ball.m_fRadius));
    }
  }
  m_cResting.Separate(m_stdBalls);
  m_cResting.NotePlaces(m_stdBalls);
  for (std::uint32_t i = 0; i < m_stdBalls.size(); ++i) {
    if (!m_stdBalls[i].m_bIsNearBall) continue;
    StayInside(i);
    MoveDisc(i);
  }
  m_cResting.FindPiles(m_stdBalls);
}

// A ball that was moved apart from others farther than shapes were looked for goes through none.
void CContinuous::StayInside(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  const Vector2d from = GetFreeMotion(ball.m_nBall).m_vPos, way = ball.m_vPos - from;
  if (Norm(way) <= g_fFarCorrection * ball.m_fNearRadius) return;
  const double share = GetFreeShare(ball, from, way, 0.0, {});
  ball.m_vPos = from + share * way;
  m_cResting.ShortenLift(i, share);
}

void CContinuous::SolveRestingContacts() {
  const auto n = static_cast<std::uint32_t>(m_stdBalls.size());
  for (const CMoving& ball : m_stdBalls)
    m_cEnergy.Add(ball);
  for (std::uint32_t i = 0; i < n; ++i)
    m_cEnergy.Join(i, m_cResting.GetPile(i));
  m_cResting.Solve(m_stdBalls);
  for (const auto& c : m_cResting.GetContacts()) {
    if (!(c.m_fImpulse > 0.0)) continue;
    const CMoving& ball = m_stdBalls[c.m_nBall];
    Report(c.m_bIsBall ? GetId(m_stdBalls[c.m_nOther]) : m_pShapes->Get(c.m_nOther).m_cId, ball,
           ball.m_vPos - ball.m_fRadius * c.m_vNorm, c.m_vNorm, 0.0, ImpulseOf(1.0, 0.0, c.m_fImpulse));
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    CMoving& ball = m_stdBalls[i];
    if (!ball.m_bIsInPile) continue;
    // The pile may have made it too fast to follow what holds it, or take it through that.
    ball.m_cHolds.DropIf([&](const CHold& hold) {
      const Vector2d surface = m_pShapes->GetGeometry(hold.m_nOther).GetSurfaceVelocity(ball.m_vPos, 0.0);
      const double into = ApproachSpeed(ball.m_vVel, surface, hold.m_vNorm) * m_fStep;
      return into > ball.m_fRadius || !CanFollow(ball, hold.m_nOther, hold.m_fRadius);
    });
    ball.m_fHoldTime = GetHoldTime(ball);
    MoveDisc(i);
    FindShapes(i);
    FindFirst(i);
  }
}

// Whether two balls meet no faster than what gravity gives in a substep, or a pile may still move by, presses
// them together.
bool CContinuous::IsSlow(const CMoving& ball, const CMoving& other, double approach) const {
  if (ball.m_bIsHalted || other.m_bIsHalted || approach > m_cResting.GetSlow()) return false;
  if (ball.m_bIsInPile || other.m_bIsInPile) return true;
  const double out = ball.m_fElasticity * other.m_fElasticity * approach;
  return IsFalling() && IsHop(out, ball.m_cNext.m_cImpact.m_fClosing, 0.0);
}

// An impact without elasticity of two balls that move as what holds them lets them. Without it the upper one
// goes along with the lower one, however light that is.
void CContinuous::StopTogether(CMoving& upper, CMoving& lower, const Vector2d& up) const {
  const double approach = up.dot(lower.m_vVel - upper.m_vVel);
  if (!(approach > 0.0)) return;
  const auto answer = [](const CMoving& ball, const Vector2d& change) {
    return Vector2d((ball.m_cHolds.ConstrainVel(ball.m_vVel + change) - ball.m_vVel) / ball.m_fMass);
  };
  const Vector2d u = answer(upper, approach * up), l = answer(lower, -approach * up);
  const double free = approach * (1.0 / upper.m_fMass + 1.0 / lower.m_fMass), held = up.dot(u - l);
  if (held < g_fLeastGiven * free) return;
  upper.m_vVel = upper.m_cHolds.ConstrainVel(upper.m_vVel + approach / held * u);
  lower.m_vVel = lower.m_cHolds.ConstrainVel(lower.m_vVel + approach / held * l);
}

// The upper one of two balls comes to rest on the lower one, until the substep ends.
void CContinuous::Rest(CMoving& ball, CMoving& other, const Vector2d& n) {
  for (CMoving* pBall : {&ball, &other}) {
    pBall->m_bIsInPile = true;
    pBall->m_vVel = pBall->m_cHolds.ConstrainVel(pBall->m_vVel);
    pBall->m_vAcc = pBall->m_cHolds.ConstrainAcc(pBall->m_vFall);
    pBall->m_vBend.setZero();
  }
  const bool isAbove = !(n.dot(m_vGravity) > 0.0);
  CMoving &upper = isAbove ? ball : other, &lower = isAbove ? other : ball;
  const Vector2d up = isAbove ? n : Vector2d(-n);
  StopTogether(upper, lower, up);
  const double along = Cross(up, upper.m_vVel - lower.m_vVel), R = upper.m_fRadius + lower.m_fRadius;
  const double bend = R > 0.0 ? along * along / R : 0.0;
  upper.m_cHolds.Add({GetIndex(lower), true, up, up.dot(lower.m_vVel), up.dot(lower.m_vAcc) - bend,
                      std::numeric_limits<double>::infinity(), lower.m_nVersion});
  upper.m_vVel = upper.m_cHolds.ConstrainVel(upper.m_vVel);
  upper.m_vAcc = upper.m_cHolds.ConstrainAcc(upper.m_vFall);
  for (CMoving* pBall : {&ball, &other})
    pBall->m_fHoldTime = GetHoldTime(*pBall);
}

} // namespace Shapes::Native
