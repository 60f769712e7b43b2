// SPDX-License-Identifier: MIT
// From impact to impact: the next one of a ball, and what it does.
#include "Continuous.h"

#include "../../shapes/Response.h"
#include "Rounding.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Shapes::Native {

void CContinuous::FindNext(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  ball.m_cNext = CNext();
  FindShapes(i);
  // A halted ball goes along with what comes upon it; what it is carried into it cannot avoid.
  if (!ball.m_bIsHalted)
    FindNextShape(ball);
  else if (ball.m_nLastMoving == g_nNobody)
    FindShapeImpacts(ball);
  FindBallImpacts(i);
  Queue(i);
}

void CContinuous::Queue(std::uint32_t i) {
  const CMoving& ball = m_stdBalls[i];
  if (ball.m_cNext.m_eSweep == eSweep::None) return;
  const double time = std::min(ball.m_fTime + ball.m_cNext.m_cImpact.m_fTime, m_fStep);
  m_stdQueue.push_back({time, ball.m_nBall, i, ball.m_nVersion});
  std::push_heap(m_stdQueue.begin(), m_stdQueue.end());
}

// Of the shapes that were found, or the end of what holds it.
void CContinuous::FindNextShape(CMoving& ball) {
  FindShapeImpacts(ball);
  CNext& next = ball.m_cNext;
  // Along a curve the way is that up to the end of this part: one that an impact ends before is another one.
  const double part = std::min(ball.m_fHoldTime, m_fStep - ball.m_fTime);
  if (next.m_eSweep == eSweep::Impact && next.m_cImpact.m_fTime > part / g_nMaxHolds &&
      !ball.m_vBend.isZero(0.0)) {
    ball.m_fHoldTime = std::min(part, next.m_cImpact.m_fTime);
    ball.m_vBend = GetBend(ball);
    next = CNext();
    FindShapeImpacts(ball);
  }
  const double time = ball.m_fHoldTime;
  if (!(time < m_fStep - ball.m_fTime) || (next.m_eSweep != eSweep::None && !(time < next.m_cImpact.m_fTime)))
    return;
  next = CNext();
  next.m_eSweep = eSweep::Impact;
  next.m_cImpact.m_fTime = time;
}

// Of those that were found.
void CContinuous::FindShapeImpacts(CMoving& ball) {
  const CMotion motion = GetMotion(ball);
  for (const std::uint32_t order : m_stdShapesFound) {
    if (!m_pShapes->Get(order).m_pShape->GetCanCollide() || ball.m_cHolds.HasShape(order)) continue;
    const CShapeGeometry& geometry = m_pShapes->GetGeometry(order);
    if (IsOutOfWay(geometry, motion, ball.m_fTime, 0.0)) continue;
    ++m_pStats->m_nSweeps;
    CNext found;
    found.m_nOther = order;
    found.m_eSweep = SweepShape(order, motion, ball.m_fTime, found.m_cImpact);
    KeepEarliest(found, ball);
  }
}

// Whether two balls rest on each other as they move now.
bool CContinuous::AreAtRest(std::uint32_t i, std::uint32_t j) const {
  const CMoving &ball = m_stdBalls[i], &other = m_stdBalls[j];
  FailIf(!ball.m_bIsInPile || !other.m_bIsInPile);
  return m_cResting.Has(i, j) || ball.m_cHolds.HasBall(j, other.m_nVersion) ||
         other.m_cHolds.HasBall(i, ball.m_nVersion);
}

// Whether the impact of two balls, as they move now, is one of a series in which they come upon each other
// ever more slowly, without end: inelastic balls that are pressed on each other.
bool CContinuous::IsOver(const CMoving& ball, const CMoving& other, const CMotion& motion,
                         const CMotion& otherMotion, const CImpact& impact) const {
  FailIf(std::max(ball.m_nImpacts, other.m_nImpacts) < g_nSqueezed);
  const double t = impact.m_fTime, left = motion.m_fDuration - t;
  const double approach = ApproachSpeed(motion.VelAt(t), otherMotion.VelAt(t), impact.m_vNorm);
  return approach + std::max(0.0, impact.m_fClosing) * left <= g_fLeastApproach * m_fFall;
}

// The impacts of a ball with others, but those before `first` that are awake: these know what they have with
// it.
void CContinuous::FindBallImpacts(std::uint32_t i, std::uint32_t first) {
  FindBalls(i);
  CMoving& ball = m_stdBalls[i];
  for (const std::uint32_t j : m_stdBallsFound) {
    const CMoving& other = m_stdBalls[j];
    if (j < first && !other.m_bIsAsleep) continue;
    if (!ball.m_cDisc.Overlaps(other.m_cDisc) || (ball.m_bIsHalted && other.m_bIsHalted) || AreAtRest(i, j))
      continue;
    ++m_pStats->m_nSweeps;
    // Both from the time at which the later motion of the two begins; none beyond what stops it.
    const double start = std::max(ball.m_fTime, other.m_fTime), since = start - ball.m_fTime;
    double otherSince = start - other.m_fTime;
    if (other.m_cNext.m_eSweep != eSweep::None)
      otherSince = std::min(otherSince, other.m_cNext.m_cImpact.m_fTime);
    CMotion motion = GetMotion(ball), otherMotion = GetMotion(other);
    motion.m_vPos = motion.PosAt(since), motion.m_vVel = motion.VelAt(since);
    otherMotion.m_vPos = otherMotion.PosAt(otherSince), otherMotion.m_vVel = otherMotion.VelAt(otherSince);
    motion.m_fDuration = otherMotion.m_fDuration = m_fStep - start;

    CNext found;
    found.m_bIsBall = true;
    found.m_nOther = j;
    found.m_nOtherVersion = other.m_nVersion;
    found.m_eSweep = ImpactBallBall(otherMotion, motion, found.m_cImpact);
    if (found.m_eSweep == eSweep::None) continue;
    if (found.m_eSweep == eSweep::Impact && IsOver(ball, other, motion, otherMotion, found.m_cImpact))
      continue;
    found.m_fOtherTime = otherSince + found.m_cImpact.m_fTime;
    found.m_cImpact.m_fTime += since;
    KeepEarliest(found, ball);
  }
}

// Takes what was found as the next of the ball if it comes first.
void CContinuous::KeepEarliest(const CNext& found, CMoving& ball) const {
  if (found.m_eSweep == eSweep::None) return;
  const auto order = [this](const CNext& n) {
    const std::size_t other = n.m_bIsBall ? m_stdBalls[n.m_nOther].m_nBall : n.m_nOther;
    return std::tuple(n.m_cImpact.m_fTime, n.m_bIsBall, other);
  };
  if (ball.m_cNext.m_eSweep == eSweep::None || order(found) < order(ball.m_cNext)) ball.m_cNext = found;
}

void CContinuous::Resolve(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  const CNext next = ball.m_cNext;
  m_stdHit.assign(1, i);
  if (next.m_eSweep == eSweep::OutOfIterations) {
    Advance(ball, next.m_cImpact.m_fTime);
    Halt(ball);
  } else if (next.m_nOther == g_nNobody) {
    HoldAnew(ball);
  } else if (next.m_bIsBall) {
    m_stdHit.push_back(next.m_nOther);
    ResolveWithBall(ball, m_stdBalls[next.m_nOther]);
  } else {
    ResolveWithShape(ball);
  }
  if (!m_cResting.IsEmpty()) PassOn();
  // All discs have to be there before any looks for the others.
  for (const std::uint32_t j : m_stdHit)
    MoveDisc(j);
  for (auto it = m_stdHit.rbegin(); it != m_stdHit.rend(); ++it)
    FindNext(*it);
}

// From balls that were hit to those that rest on them, at the same time: two that rest on each other and
// approach faster than that, or would get deep into each other, are an impact.
void CContinuous::PassOn() {
  const double now = m_stdBalls[m_stdHit.front()].m_fTime;
  std::vector<std::uint32_t>& queue = m_stdPassing;
  queue = m_stdHit;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const std::uint32_t i = queue[k];
    for (const std::uint32_t j : m_cResting.GetNeighbours(i)) {
      CMoving &ball = m_stdBalls[i], &other = m_stdBalls[j];
      if (ball.m_bIsHalted && other.m_bIsHalted) continue;
      const CMotion motion = GetMotion(other);
      const double since = now - other.m_fTime;
      const Vector2d d = ball.m_vPos - motion.PosAt(since), n = Unit(d, Vector2d::UnitY());
      // A ball that rests on a squeezed one need not touch it yet.
      if (Norm(d) > ball.m_fRadius + other.m_fRadius + m_cResting.GetReach()) continue;
      const double approach = ApproachSpeed(GetMotion(ball).m_vVel, motion.VelAt(since), n);
      const double deep = g_fPassedOverlap * std::min(ball.m_fRadius, other.m_fRadius);
      if (approach <= m_cResting.GetSlow() && approach * (m_fStep - now) <= deep) continue;
      if (since > 0.0) Advance(other, since);
      ++other.m_nVersion;
      Collide(ball, other, n, 0.0, false);
      for (const std::uint32_t hit : {j, i})
        if (std::find(queue.begin() + static_cast<std::ptrdiff_t>(k) + 1, queue.end(), hit) == queue.end())
          queue.push_back(hit);
      if (std::find(m_stdHit.begin(), m_stdHit.end(), j) == m_stdHit.end()) m_stdHit.push_back(j);
    }
  }
}

void CContinuous::Advance(CMoving& ball, double motion) {
  const CMotion before = GetMotion(ball);
  if (!ball.m_bIsHalted) {
    ball.m_vPos = before.PosAt(motion);
    ball.m_vVel = before.VelAt(motion);
    ball.m_vBend.setZero();
  } else if (ball.m_nLastMoving != g_nNobody) {
    GoAlong(ball, motion);
  }
  ball.m_fTime = std::min(ball.m_fTime + motion, m_fStep);
  ball.m_bIsMoved = true;
  ball.m_bIsAsleep = false;
  ++ball.m_nVersion;
  if (!ball.m_cHolds.IsEmpty() && !ball.m_bIsHalted) Settle(ball, before, motion);
}

// A halted ball with the shape that has pushed it last, until something else is in the way of that.
void CContinuous::GoAlong(CMoving& ball, double time) {
  const CShapeGeometry& o = m_pShapes->GetGeometry(ball.m_nLastMoving);
  const Vector2d fromCenter = ball.m_vPos - o.m_vRotCenter - ball.m_fTime * o.m_vVel;
  const Vector2d way = time * o.m_vVel + Turned(fromCenter, o.m_fTurnSpeed * time) - fromCenter;
  ball.m_vPos += GetFreeShare(ball, ball.m_vPos, way, ball.m_fTime, {.m_pAlong = &o}) * way;
}

// Whether a wall that pushes a ball along n leaves it on all that holds it: it neither lifts it from that nor
// presses it into it.
bool CContinuous::IsAlong(const CHolds& held, std::uint32_t wall, const Vector2d& n) const {
  const auto isAlong = [&](const CHold& hold) {
    return n.dot(hold.m_vNorm) >= -static_cast<double>(g_fTouchRounding) &&
           !m_pShapes->GetGeometry(hold.m_nOther).MovesAs(m_pShapes->GetGeometry(wall));
  };
  return !held.IsEmpty() && std::all_of(held.Get().begin(), held.Get().end(), isAlong);
}

void CContinuous::ResolveWithShape(CMoving& ball) {
  CImpact impact = ball.m_cNext.m_cImpact;
  const std::uint32_t order = ball.m_cNext.m_nOther;
  if (ball.m_bIsHalted) {
    Advance(ball, impact.m_fTime);
    ball.m_nLastMoving = order;
    return Halt(ball);
  }
  const CSolidShape& solid = m_pShapes->Get(order);
  const Vector2d &n = impact.m_vNorm, &surface = impact.m_vSurface;
  const CMotion before = GetMotion(ball);
  Advance(ball, impact.m_fTime);
  const bool onCurve = SlideOnto(ball, order, before, impact);
  const Vector2d acc = onCurve ? ball.m_vAcc : before.m_vAcc;
  const double depth = ball.m_fRadius - (ball.m_vPos - impact.m_vPOI).dot(n);
  const double size = SizeOf(ball.m_vPos, ball.m_fRadius) + m_pShapes->GetGeometry(order).m_fSize;
  const double clear = Clear(size, ball.m_vVel.norm() * m_fStep);
  // Exactly onto the shape; but one that began deep in something stays there.
  if (depth <= Rounding(size) && !onCurve)
    ball.m_vPos = impact.m_vPOI + std::max(ball.m_fRadius, FloatRounding(ball.m_vPos) + clear) * n;
  else
    ball.m_vPos += clear * n;
  m_fFastest = std::max(m_fFastest, g_fSqueezed * Norm(surface));
  const bool isPush = GetPush(n, surface) != 0.0;
  // As fast as it is with what its pile gives it.
  const bool canFollow = IsFalling() && CanFollow(ball, order, impact.m_fRadius + ball.m_fRadius);
  TakeBack(ball);
  const double approach = ApproachSpeed(ball.m_vVel, surface, n);
  const double e = ball.m_fElasticity * static_cast<double>(solid.m_pShape->GetElasticity());
  const double speed = Norm(ball.m_vVel) + Norm(surface);
  const CHold hold = MakeHold(ball, order, impact, acc);
  // Where it leaves what has held it nothing but gravity accelerates it.
  const bool staysAlone = IsHop(e * approach, hold.m_fAcc - n.dot(ball.m_vFall), speed);
  const bool stays = canFollow && (staysAlone || IsHop(e * approach, impact.m_fClosing, speed));
  if (stays) {
    GiveAgain(ball);
    StayOn(ball, hold, staysAlone);
  } else {
    RespondKinematic(n, 0.0, e, surface, ball.m_vPos, ball.m_vVel);
    TakeSupport(ball, n, surface);
    GiveAgain(ball);
    // With that it comes into the shape no more than without.
    if (IsPushed(ball)) RespondKinematic(n, 0.0, 0.0, surface, ball.m_vPos, ball.m_vVel);
    const CHolds held = ball.m_cHolds;
    Free(ball);
    if (isPush && !ball.m_bIsInPile && IsAlong(held, order, n)) HoldAllTouching(ball, held);
    if (ball.m_nLastOrder == order && impact.m_fTime * g_nHops < m_fStep) Slide(ball, impact);
  }
  m_pStats->m_nSpeedsCapped += CapSpeed(ball.m_vVel);
  ball.m_nLastOrder = order;
  if (isPush) ball.m_nLastMoving = order;
  ball.m_bIsDriven |= e > 1.0;
  Report(solid.m_cId, ball, impact.m_vPOI, n, approach, ImpulseOf(ball.m_fMass, stays ? 0.0 : e, approach));
  EndMotion(ball, n);
}

// A ball that stays on a surface that curves towards it would meet it again at once, and again.
void CContinuous::Slide(CMoving& ball, const CImpact& impact) const {
  const Vector2d &n = impact.m_vNorm, u = ball.m_vVel - impact.m_vSurface;
  const double most = static_cast<double>(g_fShallow) * (ball.m_vVel.norm() + impact.m_vSurface.norm());
  const double hop = std::min(impact.m_fCurve * m_fStep / (2.0 * g_nHops), most), out = u.dot(n);
  if (!(out < hop)) return;
  const Vector2d along = u - out * n;
  const double speed = along.norm();
  // The speed stays: the part along the surface shrinks.
  const double left = std::sqrt(std::max(0.0, u.squaredNorm() - hop * hop));
  ball.m_vVel = impact.m_vSurface + hop * n + (speed > 0.0 ? left / speed : 0.0) * along;
}

void CContinuous::ResolveWithBall(CMoving& ball, CMoving& other) {
  const CNext next = ball.m_cNext;
  const Vector2d n = next.m_cImpact.m_vNorm;
  Advance(ball, next.m_cImpact.m_fTime);
  Advance(other, next.m_fOtherTime);
  other.m_fTime = ball.m_fTime;
  const double approach = ApproachSpeed(GetMotion(ball).m_vVel, GetMotion(other).m_vVel, n);
  const double size = SizeOf(ball.m_vPos, ball.m_fRadius) + SizeOf(other.m_vPos, other.m_fRadius);
  const double clear = Clear(size, (ball.m_vVel - other.m_vVel).norm() * m_fStep);
  const double rounding = FloatRounding(ball.m_vPos) + FloatRounding(other.m_vPos);
  const double apart = std::max(ball.m_fRadius + other.m_fRadius, rounding + clear);
  double setback = apart - (ball.m_vPos - other.m_vPos).dot(n);
  // They began deep in each other; or they are so small that a rounding would take one through a shape.
  const double most = g_fFarCorrection * std::min(ball.m_fRadius, other.m_fRadius);
  if (std::abs(setback) > std::min(Rounding(size), most)) setback = clear;
  Collide(ball, other, n, setback, IsSlow(ball, other, approach));
}

// The velocity of a ball in a pile at the moment: it bounces at that, without what gravity and the pile give
// in the rest of the substep. With that it would bounce higher than it has come from.
void CContinuous::TakeBack(CMoving& ball) const { ball.m_vVel -= (m_fStep - ball.m_fTime) * ball.m_vGiven; }

// A ball of a pile that leaves a shape: what has held it out of that does so no more, and gravity slows it,
// but does not turn it back.
void CContinuous::TakeSupport(CMoving& ball, const Vector2d& n, const Vector2d& surface) const {
  const double given = n.dot(ball.m_vGiven), falling = std::min(0.0, n.dot(m_vGravity));
  const double left = m_fStep - ball.m_fTime, out = std::max(0.0, n.dot(ball.m_vVel - surface));
  if (!IsPushed(ball) || given <= falling || !(left > 0.0)) return;
  ball.m_vGiven += ((out + falling * left > 0.0 ? falling : -out / left) - given) * n;
}

// After the response. What that gives of energy CPileEnergy takes away.
void CContinuous::GiveAgain(CMoving& ball) const {
  if (IsPushed(ball)) ball.m_vVel += (m_fStep - ball.m_fTime) * ball.m_vGiven;
}

// Two balls that touch at the present place of both.
void CContinuous::Collide(CMoving& ball, CMoving& other, const Vector2d& n, double setback, bool isSlow) {
  const auto isAnswered = [isSlow](const CMoving& b) { return !isSlow && !b.m_bIsHalted; };
  for (CMoving* pBall : {&ball, &other})
    if (isAnswered(*pBall)) TakeBack(*pBall);
  const double approach = ApproachSpeed(GetMotion(ball).m_vVel, GetMotion(other).m_vVel, n);
  const double e = isSlow ? 0.0 : ball.m_fElasticity * other.m_fElasticity;
  m_cEnergy.Join(GetIndex(ball), GetIndex(other));
  ball.m_bIsDriven |= e > 1.0;
  double mass = ReducedMass(ball.m_fMass, other.m_fMass);
  if (ball.m_bIsHalted || other.m_bIsHalted) mass = ball.m_bIsHalted ? other.m_fMass : ball.m_fMass;
  if (other.m_bIsHalted)
    RespondKinematic(n, setback, e, other.m_vCarried, ball.m_vPos, ball.m_vVel);
  else if (ball.m_bIsHalted)
    RespondKinematic(Vector2d(-n), setback, e, ball.m_vCarried, other.m_vPos, other.m_vVel);
  else
    RespondDynamic(n, setback, e, other.m_fMass, ball.m_fMass, other.m_vPos, other.m_vVel, ball.m_vPos,
                   ball.m_vVel);
  for (CMoving* pBall : {&ball, &other})
    if (isAnswered(*pBall)) GiveAgain(*pBall);
  // With that they come into each other no more than without.
  if (isAnswered(ball) && isAnswered(other) && (IsPushed(ball) || IsPushed(other)))
    RespondDynamic(n, 0.0, 0.0, other.m_fMass, ball.m_fMass, other.m_vPos, other.m_vVel, ball.m_vPos,
                   ball.m_vVel);
  for (CMoving* pBall : {&ball, &other}) {
    m_pStats->m_nSpeedsCapped += CapSpeed(pBall->m_vVel);
    pBall->m_nLastOrder = g_nNobody;
  }
  // A moving shape, or what goes along with one, presses them on each other.
  const auto isPushed = [](const CMoving& b) { return b.m_bIsHalted || b.m_nLastMoving != g_nNobody; };
  if (isPushed(ball) || isPushed(other)) ball.m_bIsNearBall = other.m_bIsNearBall = true;
  if (isSlow) {
    Rest(ball, other, n);
  } else {
    Free(ball);
    Free(other);
  }
  const bool ballIsFirst = ball.m_nBall < other.m_nBall;
  const CMoving &first = ballIsFirst ? ball : other, &second = ballIsFirst ? other : ball;
  const Vector2d nhat = ballIsFirst ? n : Vector2d(-n);
  Report(GetId(second), first, second.m_vPos + second.m_fRadius * nhat, nhat, approach,
         ImpulseOf(mass, e, approach));
  for (CMoving* pBall : {&ball, &other})
    if (!pBall->m_bIsHalted) EndMotion(*pBall, n);
}

void CContinuous::Report(CShapeId shape, const CMoving& ball, const Vector2d& poi, const Vector2d& n,
                         double speed, float impulse) {
  ++m_pStats->m_nContacts;
  m_stdTimes.emplace_back(ball.m_fTime, static_cast<std::uint32_t>(m_stdContacts.size()));
  m_stdContacts.push_back(
      {shape, GetId(ball), ToFloat(poi), n.cast<float>(), 0.0f, static_cast<float>(speed), false, impulse});
}

// Whether a ball that a moving shape pushes has got nowhere with the last of its impacts: all along one line,
// so that it gets out at no side either.
bool CContinuous::GetsNowhere(CMoving& ball, const Vector2d& n) const {
  const bool isOnLine = std::abs(n.dot(std::exchange(ball.m_vLastNorm, n))) >= 1.0 - g_fOnLine;
  // One along another line begins anew.
  ball.m_nOnLine = isOnLine ? ball.m_nOnLine + 1 : 0;
  FailIf(ball.m_nOnLine % g_nStuckImpacts != 0);
  const double since = std::exchange(ball.m_fOnLineSince, ball.m_fTime);
  return isOnLine && ball.m_nLastMoving != g_nNobody && ball.m_fTime - since <= g_fStuckPart * m_fStep;
}

// After an impact with this normal; none where only what holds the ball is another one.
void CContinuous::EndMotion(CMoving& ball, const Vector2d& n) {
  m_stdPathVertices.push_back(
      {ball.m_nBall, ToFloat(ball.m_vPos), static_cast<float>(ball.m_fTime / m_fStep)});
  ++ball.m_nImpacts;
  // Elastic balls pass on what they have, and keep it where nothing gives more.
  const auto mayKeep = [&] {
    return ball.m_fElasticity == 1.0 && !ball.m_bIsDriven && !m_pShapes->IsAnyMoving();
  };
  if (ball.m_bIsNearBall && ball.m_nImpacts >= g_nSqueezed && !mayKeep()) {
    const double most = m_fFastest + m_fFall, speed = Norm(ball.m_vVel);
    if (speed > most) ball.m_vVel *= most / speed;
  }
  const bool isCrowded =
      ball.m_nImpacts == g_nCrowded && (ball.m_bIsInPile || (ball.m_bIsNearBall && !mayKeep()));
  const bool isStopped = GetsNowhere(ball, n) || isCrowded;
  if (isStopped || ball.m_nImpacts == g_nMaxImpacts || ball.m_nBallsSeen > g_nMostBallsSeen) Halt(ball);
}

// It keeps no velocity into the shapes that it touches, and none at all if it has got nowhere.
void CContinuous::StopAtTouching(CMoving& ball) {
  FindShapes(GetIndex(ball));
  CHolds touching;
  for (const std::uint32_t order : m_stdShapesFound) {
    CImpact impact;
    double gap;
    if (Touches(ball, order, impact, gap))
      touching.Add(MakeHold(ball, order, impact, GetMotion(ball).m_vAcc));
  }
  ball.m_bIsStuck = ball.m_fTime <= g_fStuckPart * m_fStep;
  ball.m_vVel = touching.ConstrainVel(ball.m_bIsStuck ? Vector2d(Vector2d::Zero()) : ball.m_vVel);
}

void CContinuous::Halt(CMoving& ball) {
  TellHalted(ball);
  // Gravity would give it more velocity in every substep, and so it would be halted in each.
  if (IsFalling() && !ball.m_bIsHalted) StopAtTouching(ball);
  ball.m_bIsHalted = true;
  const auto getSurface = [&](std::uint32_t order) {
    return m_pShapes->GetGeometry(order).GetSurfaceVelocity(ball.m_vPos, ball.m_fTime);
  };
  for (const CHold& hold : ball.m_cHolds.Get()) // what it lies on comes upon it as well
    if (ball.m_nLastMoving == g_nNobody && !hold.m_bIsBall &&
        GetPush(hold.m_vNorm, getSurface(hold.m_nOther)) != 0.0)
      ball.m_nLastMoving = hold.m_nOther;
  if (ball.m_nLastMoving != g_nNobody) ball.m_vCarried = getSurface(ball.m_nLastMoving);
}

} // namespace Shapes::Native
