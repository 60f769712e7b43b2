// SPDX-License-Identifier: MIT
// Shapes on which a ball lies, or along which it slides: which they are, and until when.
#include "Continuous.h"

#include "../../geometry/Swing.h"
#include "../../shapes/Response.h"
#include "Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Shapes::Native {

// Whether a ball that leaves a surface at the speed `out` is back at once, being accelerated towards it: it
// lies on it, or leaves it all but along the surface.
bool CContinuous::IsHop(double out, double closing, double speed) const {
  const double most = std::max(m_fFall / g_nHops, static_cast<double>(g_fShallow) * speed);
  return closing > 0.0 && out <= most && 2.0 * g_nHops * out < closing * m_fStep;
}

// Whether the way along a surface, of this radius of curvature, can be followed: not where it turns too far
// within a substep.
bool CContinuous::CanFollow(const CMoving& ball, std::uint32_t order, double radius) const {
  const CShapeGeometry& o = m_pShapes->GetGeometry(order);
  const double way = (Norm(ball.m_vVel - o.m_vVel) + m_fFall) * m_fStep, turn = std::abs(o.m_fTurnSpeed);
  const double part = static_cast<double>(turn == 0.0 ? g_fSlideTurn : g_fHoldTurn) * g_nMaxHolds;
  const double left = part - turn * m_fStep;
  return left > 0.0 && (!std::isfinite(radius) || way < left * std::abs(radius));
}

void CContinuous::Free(CMoving& ball) const {
  ball.m_cHolds.Clear();
  ball.m_fHoldTime = std::numeric_limits<double>::infinity();
  ball.m_vAcc = ball.m_vFall;
  ball.m_vBend.setZero();
}

// A new part of the way of a ball along what holds it.
void CContinuous::HoldAnew(CMoving& ball) {
  Advance(ball, ball.m_cNext.m_cImpact.m_fTime);
  const CHolds holds = ball.m_cHolds;
  Free(ball);
  HoldAllTouching(ball, holds);
  EndMotion(ball, Vector2d::Zero());
}

// A ball comes to stay on a shape: alone, so that it may leave what has held it before, or only together with
// that.
void CContinuous::StayOn(CMoving& ball, const CHold& hold, bool alone) {
  if (ball.m_bIsInPile || ball.m_cHolds.IsEmpty()) return Hold(ball, hold);
  const CHolds before = ball.m_cHolds;
  Free(ball);
  if (alone) Hold(ball, hold);
  HoldAllTouching(ball, before);
  if (alone) return;
  if (!ball.m_cHolds.HasShape(hold.m_nOther)) Hold(ball, hold);
  // Once more, with the velocity that it has between them.
  const CHolds all = ball.m_cHolds;
  Free(ball);
  HoldAllTouching(ball, all);
}

// First the shapes that have held it before, as they are now. Then the others that it touches: at a joint
// those that begin there.
void CContinuous::HoldAllTouching(CMoving& ball, const CHolds& before) {
  FindShapes(GetIndex(ball));
  for (const CHold& hold : before.Get())
    if (!hold.m_bIsBall && !ball.m_cHolds.HasShape(hold.m_nOther)) HoldIfTouching(ball, hold.m_nOther, true);
  for (const std::uint32_t order : m_stdShapesFound)
    if (!ball.m_cHolds.HasShape(order) && !before.HasShape(order) && HoldIfTouching(ball, order, false))
      ReportHold(ball);
}

// The impact is of a motion of the ball with this acceleration, which its closing is of.
CHold CContinuous::MakeHold(const CMoving& ball, std::uint32_t order, const CImpact& impact,
                            const Vector2d& acc) const {
  const Vector2d& n = impact.m_vNorm;
  return {order,
          false,
          n,
          n.dot(impact.m_vSurface),
          n.dot(acc) + impact.m_fClosing,
          impact.m_fRadius + ball.m_fRadius};
}

void CContinuous::Hold(CMoving& ball, const CHold& hold) {
  ball.m_cHolds.Add(hold);
  ball.m_bIsDriven |= m_pShapes->GetGeometry(hold.m_nOther).IsMoving();
  ball.m_vVel = ball.m_cHolds.ConstrainVel(ball.m_vVel);
  ball.m_vAcc = ball.m_cHolds.ConstrainAcc(ball.m_vFall);
  const bool isAnyDropped = ball.m_cHolds.DropPulling(ball.m_vAcc, ball.m_vFall);
  if (!isAnyDropped) ball.m_vVel = ball.m_cHolds.KeepVel(ball.m_vVel);
  ball.m_fHoldTime = GetHoldTime(ball);
  ball.m_vBend = GetBend(ball);
  ball.m_bIsMoved = true;
}

// On the shapes that were found to touch it. The first that holds it changes its motion.
void CContinuous::HoldTouching(CMoving& ball) {
  for (const auto& [order, gap, impact] : m_stdTouching) {
    const bool isFirst = ball.m_cHolds.IsEmpty();
    if (isFirst ? HoldIfStaying(ball, order, impact, gap, true) : HoldIfTouching(ball, order, false))
      ReportHold(ball);
  }
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
  return IsNearShape(order, GetMotion(ball), ball.m_fTime, reach, impact, gap);
}

bool CContinuous::HoldIfTouching(CMoving& ball, std::uint32_t order, bool mayMeet) {
  CImpact impact;
  double gap;
  return Touches(ball, order, impact, gap) && gap >= -GetRounding(ball, order) &&
         HoldIfStaying(ball, order, impact, gap, mayMeet);
}

// A ball that lies on a shape where its motion begins, or slides along it. Unless it `mayMeet` that, to come
// upon it faster than it would at the end of a hop is an impact, which is to come.
bool CContinuous::HoldIfStaying(CMoving& ball, std::uint32_t order, const CImpact& impact, double gap,
                                bool mayMeet) {
  const Vector2d& n = impact.m_vNorm;
  const bool isHeld = !ball.m_cHolds.IsEmpty();
  if (isHeld && HoldAsOne(ball, order, impact)) return true;
  // Out of it; but not onto it, which may be into the one that holds it.
  if (isHeld && gap < 0.0) ball.m_vPos -= gap * n;
  const double apart = n.dot(ball.m_vVel - impact.m_vSurface);
  const double speed = Norm(ball.m_vVel) + Norm(impact.m_vSurface);
  const double e = ball.m_fElasticity * static_cast<double>(m_pShapes->Get(order).m_pShape->GetElasticity());
  const double out = std::max(apart, -apart * (mayMeet ? e : 1.0));
  FailIf(!IsHop(out, impact.m_fClosing, speed) || !CanFollow(ball, order, impact.m_fRadius + ball.m_fRadius));
  const CHold hold = MakeHold(ball, order, impact, GetMotion(ball).m_vAcc);
  if (!isHeld) ball.m_vPos -= gap * n;
  Hold(ball, hold);
  return true;
}

// With the curve that holds it, if that and what the shape is there differ by rounding only: two shapes that
// share an end. Else the ball, whose way is not exactly on the curve, would have an impact with the other one
// again and again.
bool CContinuous::HoldAsOne(CMoving& ball, std::uint32_t order, const CImpact& impact) {
  const CHold* pCurve = GetCurve(ball);
  FailIf(pCurve == nullptr || impact.m_fRadius + ball.m_fRadius != pCurve->m_fRadius);
  const CShapeGeometry &o = m_pShapes->GetGeometry(order), &curve = m_pShapes->GetGeometry(pCurve->m_nOther);
  const double apart = std::abs(pCurve->m_fRadius) * Norm(impact.m_vNorm - pCurve->m_vNorm); // their middles
  FailIf(o.m_fTurnSpeed != 0.0 || o.m_vVel != curve.m_vVel || apart > GetRounding(ball, order));
  CHold hold = *pCurve;
  hold.m_nOther = order;
  ball.m_cHolds.Add(hold);
  ball.m_fHoldTime = GetHoldTime(ball);
  ball.m_vBend = GetBend(ball);
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

// Until a ball that slides along the face of a segment is past its end: so far that rounding leaves nothing
// of it below the ball.
double CContinuous::GetTimeToEnd(const CMoving& ball, const CHold& hold) const {
  double time = std::numeric_limits<double>::infinity();
  const CShapeGeometry& o = m_pShapes->GetGeometry(hold.m_nOther);
  const Vector2d u = ball.m_vVel - o.m_vVel, place = ball.m_vPos - ball.m_fTime * o.m_vVel;
  const double past = GetRounding(ball, hold.m_nOther), left = m_fStep - ball.m_fTime;
  for (const double sign : {1.0, -1.0}) {
    const Vector2d way = -sign * Perp(o.m_vFront);
    const double gap = way.dot((sign > 0.0 ? o.m_vPt1 : o.m_vPt0) - place);
    time = std::min(time, GetTimeTo(std::max(gap, 0.0) + past, way.dot(u), way.dot(ball.m_vAcc), left));
  }
  return time;
}

// The directions from the middle of the curve in which the shape holds the ball, counterclockwise from
// `first` to `last`, and their length. 0 where it does all around.
double CContinuous::GetSector(const CMoving& ball, const CHold& hold, Vector2d& first, Vector2d& last) const {
  const CShapeGeometry& o = m_pShapes->GetGeometry(hold.m_nOther);
  const bool isSeg = o.m_eShapeType == eShape::LineSeg;
  if (!isSeg && (o.m_eShapeType != eShape::Arc || o.m_bFull)) return 0.0;
  const double angle = o.m_fTurnSpeed * ball.m_fTime;
  const auto turned = [angle](const Vector2d& v) { return angle == 0.0 ? v : Turned(v, angle); };
  const Vector2d from0 = turned(o.m_vPt0 - o.m_vCenter), from1 = turned(o.m_vPt1 - o.m_vCenter);
  if (hold.m_fRadius != ball.m_fRadius) {
    first = from0, last = from1;
    return o.m_fRadius;
  }
  // Round an end: until the ball is in front of a face.
  const Vector2d fromRot =
      ball.m_vPos - hold.m_fRadius * hold.m_vNorm - o.m_vRotCenter - ball.m_fTime * o.m_vVel;
  const auto getOff = [&](const Vector2d& end) {
    return (fromRot - turned(end - o.m_vRotCenter)).squaredNorm();
  };
  const bool isSecond = getOff(o.m_vPt1) < getOff(o.m_vPt0);
  last = isSeg ? turned(o.m_vFront) : Vector2d(isSecond ? -from1 : -from0);
  if (!isSecond) last = -last;
  first = -last;
  return isSeg ? 1.0 : o.m_fRadius;
}

// Until a ball that slides along a curve is past an end of the shape.
double CContinuous::GetTimeToTurn(const CMoving& ball, const CHold& hold, const CSlide& slide) const {
  double time = std::numeric_limits<double>::infinity();
  Vector2d first, last;
  const double length = GetSector(ball, hold, first, last);
  if (length == 0.0) return time;
  const double left = m_fStep - ball.m_fTime, turn = m_pShapes->GetGeometry(hold.m_nOther).m_fTurnSpeed;
  const double most = (std::abs(slide.m_fRate) + std::abs(turn) + slide.GetPull() * left) * left;
  const Vector2d from = (hold.m_fRadius > 0.0 ? length : -length) * hold.m_vNorm;
  for (const double sign : {1.0, -1.0}) {
    const Vector2d& end = sign > 0.0 ? last : first;
    const double far = most * length;
    if ((end - from).squaredNorm() > far * far) continue; // farther off than the ball gets
    const double past = GetRounding(ball, hold.m_nOther) / std::abs(hold.m_fRadius);
    const double angle = std::max(std::atan2(sign * Cross(from, end), from.dot(end)), 0.0) + past;
    double t = GetTimeTo(angle, sign * (slide.m_fRate - turn), sign * slide.m_fAlong, left);
    // That is of an even acceleration; from there by Newton's method.
    for (int round = 0; round < 2 && t < left; ++round) {
      const CSwing swing = GetSwing(slide.m_fAlong, slide.m_fOut, slide.m_fRate, t);
      const double speed = sign * (swing.m_fRate - turn), gone = sign * (swing.m_fAngle - turn * t);
      if (!(speed > 0.0)) break;
      t = std::max(t - (gone - angle) / speed, 0.0);
    }
    time = std::min(time, t);
  }
  return time;
}

// Until the ball is past an end of a curve, that would have to pull it, or it has turned so far that its way
// is no parabola.
double CContinuous::GetSlideTime(const CMoving& ball, const CHold& curve) const {
  const CSlide slide = GetSlide(ball, curve, ball.m_vPos, ball.m_vVel, ball.m_fTime);
  const double left = m_fStep - ball.m_fTime, turn = std::abs(slide.m_cMiddle.m_fTurnSpeed);
  const double speed = std::abs(slide.m_fRate) + slide.GetPull() * left;
  double part = Geometry::Quotient(static_cast<double>(g_fSlideTurn), speed, left);
  if (turn > 0.0) part = std::min(part, Geometry::Quotient(static_cast<double>(g_fHoldTurn), turn, left));
  // The push changes by -3 g u / R.
  const double less = 3.0 * slide.m_fAlong * slide.m_fRate * curve.m_fRadius;
  if (less > 0.0) {
    const double push = curve.m_vNorm.dot(ball.m_vAcc - ball.m_vFall);
    part = std::min(part, Geometry::Quotient(std::max(push, 0.0), less, left));
  }
  double time = std::max(part, m_fStep / g_nMaxHolds);
  for (const CHold& hold : ball.m_cHolds.Get())
    time = std::min(time, GetTimeToTurn(ball, hold, slide));
  return time;
}

// The time until the ball is past the end of what holds it, or what turns has turned so far that its way is
// no parabola.
double CContinuous::GetHoldTime(const CMoving& ball) const {
  if (const CHold* pCurve = GetCurve(ball)) return GetSlideTime(ball, *pCurve);
  double time = std::numeric_limits<double>::infinity();
  const double left = m_fStep - ball.m_fTime;
  for (const CHold& hold : ball.m_cHolds.Get()) {
    if (hold.m_bIsBall) continue;
    const CShapeGeometry& o = m_pShapes->GetGeometry(hold.m_nOther);
    if (o.m_fTurnSpeed == 0.0 && !std::isfinite(hold.m_fRadius)) {
      time = std::min(time, GetTimeToEnd(ball, hold));
      continue;
    }
    const double speed = Norm(ball.m_vVel - o.m_vVel) + Norm(ball.m_vAcc) * left;
    const double part = Geometry::Quotient(static_cast<double>(g_fHoldTurn),
                                           std::abs(o.m_fTurnSpeed) + speed / std::abs(hold.m_fRadius), left);
    time = std::min(time, std::max(part, m_fStep / g_nMaxHolds));
  }
  return time;
}

} // namespace Shapes::Native
