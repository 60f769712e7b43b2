// SPDX-License-Identifier: MIT
// Contact that lasts: balls that lie on shapes or slide along them, and balls that rest on each other.
#include "Continuous.h"

#include "../../shapes/Response.h"
#include "Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Shapes::Native {

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
      CImpact impact;
      double gap;
      const double reach =
          m_cResting.GetReach(Norm(ball.m_vVel - other.m_vVel), CRestingContacts::IsSqueezed(ball, other));
      if (j <= i || other.m_bIsAsleep || !NearBallBall(GetMotion(other), GetMotion(ball), reach, impact, gap))
        continue;
      m_cResting.Add(i, j, true, impact, gap);
      ball.m_bIsNearBall = other.m_bIsNearBall = true;
    }
  }
  if (m_cResting.IsEmpty()) return;
  for (std::uint32_t i = 0; i < n; ++i) {
    const CMoving& ball = m_stdBalls[i];
    if (!ball.m_bIsNearBall) continue;
    // Balls that overlap may be moved towards shapes.
    const auto getReach = [&](double speed) {
      return m_cResting.GetReach(speed, ball.m_bWasSqueezed) + g_fFarCorrection * ball.m_fRadius;
    };
    FindShapes(i, static_cast<float>(getReach(Norm(ball.m_vVel))));
    for (const std::uint32_t order : m_stdShapesFound) {
      CImpact impact;
      double gap;
      const Vector2d surface = m_pShapes->GetGeometry(order).GetSurfaceVelocity(ball.m_vPos, 0.0);
      const double far = getReach(Norm(ball.m_vVel - surface));
      if (m_pShapes->Get(order).m_pShape->GetCanCollide() &&
          Near(m_pShapes->GetGeometry(order), GetMotion(ball), 0.0, far, impact, gap) &&
          CanFollow(ball, order, impact))
        m_cResting.Add(i, order, false, impact, gap);
    }
  }
  m_cResting.Separate(m_stdBalls);
  for (std::uint32_t i = 0; i < n; ++i)
    if (m_stdBalls[i].m_bIsNearBall) MoveDisc(i);
  m_cResting.FindPiles(m_stdBalls);
}

void CContinuous::SolveRestingContacts() {
  const auto n = static_cast<std::uint32_t>(m_stdBalls.size());
  for (const CMoving& ball : m_stdBalls)
    m_cEnergy.Add(ball);
  for (std::uint32_t i = 0; i < n; ++i)
    m_cEnergy.Join(i, m_cResting.GetPile(i));
  m_cResting.Solve(m_stdBalls);
  m_cResting.ForEach(
      [this](std::uint32_t i, std::uint32_t other, bool isBall, const Vector2d& norm, double impulse) {
        const CMoving& ball = m_stdBalls[i];
        Report(isBall ? m_pBalls->m_stdId[m_stdBalls[other].m_nBall] : m_pShapes->Get(other).m_cId, ball,
               ball.m_vPos - ball.m_fRadius * norm, norm, 0.0, ImpulseOf(1.0, 0.0, impulse));
      });
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!m_stdBalls[i].m_bIsInPile) continue;
    m_stdBalls[i].m_fHoldTime = GetHoldTime(m_stdBalls[i]);
    MoveDisc(i);
    FindShapes(i);
    FindFirst(i);
  }
}

// Whether a ball that leaves a surface at the speed `out` is back at once, being accelerated towards it: it
// lies on it, or leaves it all but along the surface.
bool CContinuous::IsHop(double out, double closing, double speed) const {
  const double most = std::max(Norm(m_vGravity) * m_fStep / g_nHops, static_cast<double>(g_fShallow) * speed);
  return closing > 0.0 && out <= most && 2.0 * g_nHops * out < closing * m_fStep;
}

// Whether the way along a surface can be followed: not where it turns too far within a substep.
bool CContinuous::CanFollow(const CMoving& ball, std::uint32_t order, const CImpact& impact) const {
  const double speed = Norm(ball.m_vVel - m_pShapes->GetGeometry(order).m_vVel) + Norm(m_vGravity) * m_fStep;
  const double bend = Geometry::Quotient(speed, std::abs(impact.m_fRadius + ball.m_fRadius),
                                         static_cast<double>(g_fMaxRotSpeed));
  const double turn = std::abs(m_pShapes->GetGeometry(order).m_fTurnSpeed) + bend;
  return turn * m_fStep < static_cast<double>(g_fHoldTurn) * g_nMaxHolds;
}

void CContinuous::Free(CMoving& ball) const {
  ball.m_cHolds.Clear();
  ball.m_fHoldTime = std::numeric_limits<double>::infinity();
  ball.m_vAcc = ball.m_vFall;
  ball.m_vBend.setZero();
}

// The shapes that hold a ball, as they are now.
void CContinuous::HoldAnew(CMoving& ball) {
  Advance(ball, ball.m_cNext.m_cImpact.m_fTime);
  const CHolds holds = ball.m_cHolds;
  Free(ball);
  for (const CHold& hold : holds.Get())
    if (!hold.m_bIsBall) HoldIfTouching(ball, hold.m_nOther);
  EndMotion(ball);
}

// The impact is that of the motion of the ball, whose acceleration its closing is of.
CHold CContinuous::MakeHold(const CMoving& ball, std::uint32_t order, const CImpact& impact) const {
  const Vector2d& n = impact.m_vNorm;
  return {order,
          false,
          n,
          n.dot(impact.m_vSurface),
          n.dot(ball.m_vAcc) + impact.m_fClosing,
          impact.m_fRadius + ball.m_fRadius};
}

void CContinuous::Hold(CMoving& ball, const CHold& hold) {
  ball.m_cHolds.Add(hold);
  ball.m_bIsDriven |= m_pShapes->GetGeometry(hold.m_nOther).IsMoving();
  ball.m_vVel += (hold.m_fSpeed - hold.m_vNorm.dot(ball.m_vVel)) * hold.m_vNorm;
  ball.m_vVel = ball.m_cHolds.ConstrainVel(ball.m_vVel);
  ball.m_vAcc = ball.m_cHolds.ConstrainAcc(ball.m_vFall);
  ball.m_cHolds.DropPulling(ball.m_vAcc, ball.m_vFall);
  ball.m_fHoldTime = GetHoldTime(ball);
  ball.m_vBend = GetBend(ball);
  ball.m_bIsMoved = true;
}

// The one shape that a ball slides along, if that curves and does not turn.
const CHold* CContinuous::GetCurve(const CMoving& ball) const {
  const auto holds = ball.m_cHolds.Get();
  const bool isCurve = holds.size() == 1 && !ball.m_bIsInPile && !holds[0].m_bIsBall &&
                       std::isfinite(holds[0].m_fRadius) &&
                       m_pShapes->GetGeometry(holds[0].m_nOther).m_fTurnSpeed == 0.0;
  return isCurve ? &holds[0] : nullptr;
}

// Of its acceleration on a curve the ball has that at the beginning. The derivative of it, times a third of
// the time until the next part of its way, takes it to the place where it is then, up to the fourth power of
// that time. With m the unit vector from the middle of the curve, u the velocity along it and R its radius
// that derivative is -(g m + u^2/R) u/R - 3 (g u) m/R.
Vector2d CContinuous::GetBend(const CMoving& ball) const {
  const CHold* pCurve = GetCurve(ball);
  if (pCurve == nullptr) return Vector2d::Zero();
  const Vector2d &n = pCurve->m_vNorm, &g = ball.m_vFall;
  const Vector2d u = ball.m_vVel - m_pShapes->GetGeometry(pCurve->m_nOther).m_vVel;
  const double R = pCurve->m_fRadius; // with its sign, so that m / |R| = n / R
  const double time = std::min(ball.m_fHoldTime, m_fStep - ball.m_fTime);
  return -time / 3.0 * ((g.dot(n) / R + u.squaredNorm() / (R * R)) * u + 3.0 * g.dot(u) / R * n);
}

// On the shapes that were found to touch it. The first that holds it changes its motion.
void CContinuous::HoldTouching(CMoving& ball) {
  for (const auto& [order, gap, impact] : m_stdTouching)
    if (ball.m_cHolds.IsEmpty() ? HoldIfStaying(ball, order, impact, gap) : HoldIfTouching(ball, order))
      ReportHold(ball);
}

double CContinuous::GetRounding(const CMoving& ball, std::uint32_t order) const {
  return Rounding(SizeOf(ball.m_vPos, ball.m_fRadius) + m_pShapes->GetGeometry(order).m_fSize);
}

// Whether the ball touches the shape now, or is in it.
bool CContinuous::Touches(const CMoving& ball, std::uint32_t order, CImpact& impact, double& gap) const {
  const CShapeGeometry& geometry = m_pShapes->GetGeometry(order);
  FailIf(!m_pShapes->Get(order).m_pShape->GetCanCollide());
  const double reach = GetRounding(ball, order);
  FailIf(IsOutOfWay(geometry, GetPlace(ball), ball.m_fTime, reach));
  return Near(geometry, GetMotion(ball), ball.m_fTime, reach, impact, gap);
}

bool CContinuous::HoldIfTouching(CMoving& ball, std::uint32_t order) {
  CImpact impact;
  double gap;
  return Touches(ball, order, impact, gap) && gap >= -GetRounding(ball, order) &&
         HoldIfStaying(ball, order, impact, gap);
}

// A ball that lies on a shape where its motion begins, or slides along it.
bool CContinuous::HoldIfStaying(CMoving& ball, std::uint32_t order, const CImpact& impact, double gap) {
  const Vector2d& n = impact.m_vNorm;
  const double apart = n.dot(ball.m_vVel - impact.m_vSurface);
  const double speed = Norm(ball.m_vVel) + Norm(impact.m_vSurface);
  const double e = ball.m_fElasticity * static_cast<double>(m_pShapes->Get(order).m_pShape->GetElasticity());
  FailIf(!IsHop(std::max(apart, -e * apart), impact.m_fClosing, speed) || !CanFollow(ball, order, impact));
  ball.m_vPos -= gap * n;
  Hold(ball, MakeHold(ball, order, impact));
  return true;
}

// The last one that has come.
void CContinuous::ReportHold(const CMoving& ball) {
  if (ball.m_cHolds.IsEmpty()) return;
  const CHold& hold = ball.m_cHolds.Get().back();
  const double push = std::max(0.0, hold.m_vNorm.dot(ball.m_vAcc - ball.m_vFall)) * m_fStep;
  Report(m_pShapes->Get(hold.m_nOther).m_cId, ball, ball.m_vPos - ball.m_fRadius * hold.m_vNorm, hold.m_vNorm,
         0.0, ImpulseOf(ball.m_fMass, 0.0, push));
}

// Onto the circle on which its centre moves: the parabola leaves that with the fourth power of the time. The
// hold is of where this part of the way began.
void CContinuous::SettleOnCurve(CMoving& ball, const CHold& curve, const CMotion& before, double time) const {
  const Vector2d& vel = m_pShapes->GetGeometry(curve.m_nOther).m_vVel;
  const Vector2d middle = before.m_vPos - curve.m_fRadius * curve.m_vNorm + time * vel;
  const Vector2d n = Unit((ball.m_vPos - middle) / curve.m_fRadius, curve.m_vNorm);
  ball.m_vPos = middle + curve.m_fRadius * n;
  ball.m_vVel -= n.dot(ball.m_vVel - vel) * n;
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
      // Past the end of an arc it flies on, and does not turn round the end.
      if (impact.m_fRadius + ball.m_fRadius != hold.m_fRadius) continue;
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
  if (ball.m_bIsInPile) return; // balls hold it, too
  // Where what holds it is at rest, or moves evenly, nothing but gravity has done work in the frame of that.
  const Vector2d vel = m_pShapes->GetGeometry(ball.m_cHolds.Get()[0].m_nOther).m_vVel;
  for (const CHold& hold : ball.m_cHolds.Get()) {
    const CShapeGeometry& geometry = m_pShapes->GetGeometry(hold.m_nOther);
    if (geometry.m_fTurnSpeed != 0.0 || geometry.m_vVel != vel) return;
  }
  const Vector2d u = ball.m_vVel - vel, way = ball.m_vPos - before.m_vPos - time * vel;
  const double square = (before.m_vVel - vel).squaredNorm() + 2.0 * m_vGravity.dot(way);
  const double now = u.squaredNorm();
  if (now > 0.0) ball.m_vVel = vel + std::sqrt(std::max(0.0, square) / now) * u;
  // A ball that turns round is put back to where its speed is zero. Not farther than it has come: where
  // hardly anything pulls it the quotient is of roundings.
  const double pull = Norm(ball.m_vAcc), length = Norm(way);
  if (square < 0.0 && pull > 0.0)
    ball.m_vPos += std::min(Geometry::Quotient(-0.5 * square, pull, length), length) / pull * ball.m_vAcc;
}

namespace {

// When a way that begins at the speed v, with the acceleration a, has got as far as `gap`, which is 0 at
// least: the first root of v t + a t^2/2 = gap. Infinite where that is after `most`.
double GetTimeTo(double gap, double v, double a, double most) {
  const double discriminant = v * v + 2.0 * a * gap;
  if (!(discriminant >= 0.0)) return std::numeric_limits<double>::infinity();
  const double s = std::sqrt(discriminant);
  return v > 0.0 ? Geometry::Quotient(2.0 * gap, v + s, most) : Geometry::Quotient(s - v, a, most);
}

} // namespace

// Until the ball is past the end of a segment or an arc that holds it and does not turn; round an end, until
// it is in front of the face.
double CContinuous::GetTimeToEnd(const CMoving& ball, const CHold& hold) const {
  double time = std::numeric_limits<double>::infinity();
  const CShapeGeometry& o = m_pShapes->GetGeometry(hold.m_nOther);
  const Vector2d u = ball.m_vVel - o.m_vVel, moved = ball.m_fTime * o.m_vVel;
  const double left = m_fStep - ball.m_fTime;
  const bool isRoundEnd = hold.m_fRadius == ball.m_fRadius;
  // So far that rounding leaves nothing of the shape below the ball.
  const double past = GetRounding(ball, hold.m_nOther);
  if (o.m_eShapeType == eShape::LineSeg) {
    for (const double sign : {1.0, -1.0}) {
      const Vector2d way = (isRoundEnd ? sign : -sign) * Perp(o.m_vFront);
      const Vector2d end = (sign > 0.0 ? o.m_vPt1 : o.m_vPt0) + moved;
      const double gap = way.dot(end - ball.m_vPos);
      if (isRoundEnd && gap < 0.0) continue; // the other one
      time = std::min(time, GetTimeTo(std::max(gap, 0.0) + past, way.dot(u), way.dot(ball.m_vAcc), left));
    }
  } else if (o.m_eShapeType == eShape::Arc && !o.m_bFull) {
    const Vector2d d = ball.m_vPos - o.m_vCenter - moved;
    const double sign = Cross(d, u) > 0.0 ? 1.0 : -1.0;
    const Vector2d end = ((sign > 0.0) != isRoundEnd ? o.m_vPt1 : o.m_vPt0) - o.m_vCenter;
    if (!(d.dot(end) > 0.0)) return time;
    const double sine = sign * Cross(d, end) / (Norm(d) * o.m_fRadius), R = Norm(d);
    // Not farther off than the ball gets.
    if (!(sine > 0.0) || sine * R > (Norm(u) + Norm(ball.m_vAcc) * left) * left) return time;
    const double gap = std::asin(std::min(sine, 1.0)) * R + past;
    const Vector2d along = Unit(u, Vector2d::UnitX());
    time = GetTimeTo(gap, u.dot(along), ball.m_vAcc.dot(along), left);
  }
  return time;
}

// Until the ball is past the end of a shape, a shape would have to pull it, or it has turned so far on what
// curves that its way is no parabola.
double CContinuous::GetHoldTime(const CMoving& ball) const {
  double time = std::numeric_limits<double>::infinity();
  const double left = m_fStep - ball.m_fTime;
  const bool isCurve = GetCurve(ball) != nullptr;
  for (const CHold& hold : ball.m_cHolds.Get()) {
    if (hold.m_bIsBall) continue;
    const CShapeGeometry& o = m_pShapes->GetGeometry(hold.m_nOther);
    const bool isFlat = o.m_fTurnSpeed == 0.0 && !std::isfinite(hold.m_fRadius);
    if (isFlat || isCurve) time = std::min(time, GetTimeToEnd(ball, hold));
    if (isFlat) continue;
    const Vector2d u = ball.m_vVel - o.m_vVel;
    const double speed = Norm(u) + Norm(ball.m_vAcc) * left;
    double part = Geometry::Quotient(static_cast<double>(isCurve ? g_fSlideTurn : g_fHoldTurn),
                                     std::abs(o.m_fTurnSpeed) + speed / std::abs(hold.m_fRadius), left);
    // The push of a curve changes by -3 g u / R.
    const double push = hold.m_vNorm.dot(ball.m_vAcc - ball.m_vFall);
    const double less = 3.0 * ball.m_vFall.dot(u) / hold.m_fRadius;
    if (isCurve && less > 0.0) part = std::min(part, Geometry::Quotient(std::max(push, 0.0), less, left));
    time = std::min(time, std::max(part, m_fStep / g_nMaxHolds));
  }
  return time;
}

// Whether two balls meet no faster than what gravity gives in a substep presses them together.
bool CContinuous::IsSlow(const CMoving& ball, const CMoving& other, double approach) const {
  if (!IsFalling() || ball.m_bIsHalted || other.m_bIsHalted || approach > m_cResting.GetSlow()) return false;
  const double out = ball.m_fElasticity * other.m_fElasticity * approach;
  return ball.m_bIsInPile || other.m_bIsInPile || IsHop(out, ball.m_cNext.m_cImpact.m_fClosing, 0.0);
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
