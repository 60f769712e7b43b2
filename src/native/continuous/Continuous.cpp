// SPDX-License-Identifier: MIT
#include "Continuous.h"

#include "../../shapes/Response.h"
#include "Rounding.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace Shapes::Native {

bool CContinuous::CEvent::operator<(const CEvent& other) const {
  return std::tie(m_fTime, m_nOrder) > std::tie(other.m_fTime, other.m_nOrder);
}

void CContinuous::Begin(CBallArrays& balls, CStaticBroadPhase& shapes, bool pairs, bool filters,
                        const Vector2& gravity, float dt, CWorldStats& stats) {
  m_pBalls = &balls;
  m_pShapes = &shapes;
  m_pStats = &stats;
  m_bPairs = pairs;
  m_bFilters = filters;
  m_fStep = static_cast<double>(dt);
  m_vGravity = gravity.cast<double>();
  m_bIsFalling = !gravity.isZero(0.0f);
  m_bCapsSpeeds = CanExceedMaxSpeed(gravity * dt);
  m_fSagitta = CMotion{Vector2d::Zero(), Vector2d::Zero(), 0.0, m_fStep, m_vGravity}.GetSagitta();
  m_fFall = Norm(m_vGravity) * m_fStep;
  m_cEnergy.Begin();
  m_stdContacts.clear();
  m_stdTimes.clear();
  m_stdPathVertices.clear();
  m_stdHalted.clear();
}

bool CContinuous::Prepare() {
  CBallArrays& balls = *m_pBalls;
  if (IsFalling())
    WakeDisturbed();
  else
    balls.m_cDisturbed.m_bIsEverywhere = true;
  balls.m_stdPrevPos = balls.m_stdPos;
  FailIf(AllSleep() && !m_pShapes->IsAnyMoving());
  const auto dt = static_cast<float>(m_fStep); // as it was given
  m_pShapes->BoxKinematic(dt);
  m_pShapes->MakeGeometries(dt);
  return true;
}

void CContinuous::MoveAlone(std::size_t begin, std::size_t end) {
  m_cResting.Begin(m_vGravity, m_fStep, 1.0);
  for (std::size_t i = begin; i < end; ++i)
    MoveAlone(i);
  // They report theirs one after the other.
  if (!std::is_sorted(m_stdTimes.begin(), m_stdTimes.end())) std::sort(m_stdTimes.begin(), m_stdTimes.end());
}

void CContinuous::Append(const CContinuous& next) {
  const auto first = static_cast<std::uint32_t>(m_stdContacts.size());
  const std::size_t before = m_stdTimes.size();
  for (const auto& [time, k] : next.m_stdTimes)
    m_stdTimes.emplace_back(time, first + k);
  m_stdMerged.resize(m_stdTimes.size());
  const auto middle = m_stdTimes.begin() + static_cast<std::ptrdiff_t>(before);
  std::merge(m_stdTimes.begin(), middle, middle, m_stdTimes.end(), m_stdMerged.begin());
  m_stdTimes.swap(m_stdMerged);
  m_stdContacts.insert(m_stdContacts.end(), next.m_stdContacts.begin(), next.m_stdContacts.end());
  m_stdPathVertices.insert(m_stdPathVertices.end(), next.m_stdPathVertices.begin(),
                           next.m_stdPathVertices.end());
  m_stdHalted.insert(m_stdHalted.end(), next.m_stdHalted.begin(), next.m_stdHalted.end());
}

void CContinuous::MoveTogether() {
  const std::vector<float>& e = m_pBalls->m_stdElasticity;
  m_cResting.Begin(m_vGravity, m_fStep,
                   e.empty() ? 1.0 : static_cast<double>(*std::max_element(e.begin(), e.end())));
  TakeBalls();
  FindCrowds();
  FollowBalls();
  PutBalls();
}

// Those that were taken, from impact to impact until the substep ends.
void CContinuous::FollowBalls() {
  m_stdQueue.clear();
  m_cResting.SetSlow(m_stdBalls);
  // Balls upon which others come are taken meanwhile.
  if (m_cResting.IsCalledFor()) {
    FindRestingContacts();
  } else {
    for (std::uint32_t i = 0; i < m_stdBalls.size(); ++i)
      SetBackFromBalls(i);
  }
  for (std::uint32_t i = 0; i < m_stdBalls.size(); ++i) {
    if (m_stdBalls[i].m_bIsAsleep) continue;
    SetBackFromAll(i);
    if (m_stdBalls[i].m_bIsInPile) continue;
    HoldTouching(m_stdBalls[i]);
    if (!m_stdBalls[i].m_cHolds.IsEmpty()) {
      MoveDisc(i);
      FindShapes(i);
    }
    FindFirst(i);
  }
  if (!m_cResting.IsEmpty()) SolveRestingContacts();
  for (std::uint32_t i = 0; i < m_stdBalls.size(); ++i) {
    if (m_stdBalls[i].m_bIsAsleep) continue;
    if (m_bPairs) FindBallImpacts(i, i);
    Queue(i);
  }

  while (!m_stdQueue.empty()) {
    std::pop_heap(m_stdQueue.begin(), m_stdQueue.end());
    const CEvent event = m_stdQueue.back();
    m_stdQueue.pop_back();
    const CMoving& ball = m_stdBalls[event.m_nBall];
    if (event.m_nVersion != ball.m_nVersion) continue;
    if (ball.m_cNext.m_bIsBall &&
        m_stdBalls[ball.m_cNext.m_nOther].m_nVersion != ball.m_cNext.m_nOtherVersion)
      FindNext(event.m_nBall); // the other one has got another way meanwhile
    else
      Resolve(event.m_nBall);
  }
}

const std::vector<CContactEvent>& CContinuous::GetContacts() {
  const auto isInPlace = [](const auto& a, const auto& b) { return a.second < b.second; };
  if (m_bPairs || std::is_sorted(m_stdTimes.begin(), m_stdTimes.end(), isInPlace)) return m_stdContacts;
  m_stdUnsorted.swap(m_stdContacts);
  m_stdContacts.clear();
  for (const auto& [time, k] : m_stdTimes)
    m_stdContacts.push_back(m_stdUnsorted[k]);
  return m_stdContacts;
}

// The first impact of a ball with the shapes that were found.
void CContinuous::FindFirst(std::uint32_t i) {
  m_pStats->m_nBallsSwept += !m_stdShapesFound.empty();
  FindNextShape(m_stdBalls[i]);
}

CMotion CContinuous::GetMotion(const CMoving& ball) const {
  return {ball.m_vPos, ball.m_bIsHalted ? ball.m_vCarried : ball.m_vVel, ball.m_fRadius,
          m_fStep - ball.m_fTime,
          ball.m_bIsHalted ? Vector2d(Vector2d::Zero()) : Vector2d(ball.m_vAcc + ball.m_vBend)};
}

void CContinuous::SetBackFromBalls(std::uint32_t i) {
  FindBalls(i);
  for (const std::uint32_t j : m_stdBallsFound) {
    CImpact impact;
    double depth;
    if (j <= i || !OverlapBallBall(GetMotion(m_stdBalls[j]), GetMotion(m_stdBalls[i]), impact, depth))
      continue;
    const double m0 = m_stdBalls[i].m_fMass, m1 = m_stdBalls[j].m_fMass;
    SetBackFromBall(i, impact.m_vNorm, depth * (m1 / (m0 + m1)));
    SetBackFromBall(j, -impact.m_vNorm, depth * (m0 / (m0 + m1)));
  }
}

// The shapes on the way of the motion, or within reach of it, and some that are near, by order.
void CContinuous::FindShapes(std::uint32_t i, float reach) {
  CMoving& ball = m_stdBalls[i];
  CDiscGrid::CDisc disc = ball.m_cDisc;
  disc.m_fRadius += reach;
  if (!disc.IsWithin(ball.m_cLooked)) {
    disc.m_fRadius *= 1.0f + g_fNearSlack;
    m_pShapes->FindNear(disc.m_vCenter, disc.m_fRadius, m_stdShapesFound);
    if (m_bFilters)
      std::erase_if(m_stdShapesFound, [&](std::uint32_t order) { return !MeetsShape(ball, order); });
    KeepShapesFound(i, disc);
  } else if (m_nFoundOf != i) {
    m_nFoundOf = i;
    m_stdShapesFound.assign(m_stdShapesOf.begin() + ball.m_nShapesBegin,
                            m_stdShapesOf.begin() + ball.m_nShapesEnd);
  }
}

// Those that were found in this disc are those of the ball.
void CContinuous::KeepShapesFound(std::uint32_t i, const CDiscGrid::CDisc& in) {
  CMoving& ball = m_stdBalls[i];
  ball.m_cLooked = in;
  ball.m_nShapesBegin = static_cast<std::uint32_t>(m_stdShapesOf.size());
  m_stdShapesOf.insert(m_stdShapesOf.end(), m_stdShapesFound.begin(), m_stdShapesFound.end());
  ball.m_nShapesEnd = static_cast<std::uint32_t>(m_stdShapesOf.size());
  m_nFoundOf = i;
}

// Out of one shape may be into another: a ball in a wedge is set back in turns. Whether it is out of all.
bool CContinuous::SetBackInTurns(std::uint32_t i, eShapes from, eThrough through) {
  for (int turn = 0; turn < g_nSetBackRounds; ++turn) {
    if (!SetBackFromShapes(i, from, through)) return true;
    FindShapes(i);
  }
  return false;
}

void CContinuous::SetBackFromAll(std::uint32_t i) {
  FindShapes(i);
  if (SetBackInTurns(i, eShapes::All, eThrough::None)) return;
  // There is no room: what moves goes over the ball, or what a game has put or stopped there. One that was
  // put deep into several shapes gets out of each only deeper into others; among others it gives way to them
  // bit by bit.
  const CMoving& ball = m_stdBalls[i];
  const bool isAlone = !ball.m_bIsNearBall;
  const eThrough through = isAlone ? eThrough::Surfaces : eThrough::None;
  if (!SetBackInTurns(i, eShapes::Resting, through) &&
      !(isAlone && GetDepthIn(eShapes::Static, ball, ball.m_vPos) > 0.0 &&
        SetBackInTurns(i, eShapes::Static, through)))
    StayInPlace(i);
  TellIfGoneOver(i);
}

// The overlap of a ball where its motion begins.
double CContinuous::GetDepth(std::uint32_t order, const CMotion& motion) const {
  CImpact impact;
  double gap;
  const bool isIn =
      m_pShapes->Get(order).m_pShape->GetCanCollide() && IsNearShape(order, motion, 0.0, 0.0, impact, gap);
  return isIn ? -gap : 0.0;
}

bool CContinuous::IsAmong(eShapes shapes, std::uint32_t order) const {
  if (shapes == eShapes::Resting) return !m_pShapes->GetGeometry(order).IsMoving();
  return shapes == eShapes::All || m_pShapes->Get(order).m_pShape->GetMotionType() == eMotion::Static;
}

// The deepest overlap of a ball at p with such shapes, of those that were found.
double CContinuous::GetDepthIn(eShapes shapes, const CMoving& ball, const Vector2d& p) const {
  CMotion motion = GetMotion(ball);
  motion.m_vPos = p;
  double depth = 0.0;
  for (const std::uint32_t order : m_stdShapesFound)
    if (IsAmong(shapes, order)) depth = std::max(depth, GetDepth(order, motion));
  return depth;
}

// Nor is there room between shapes that rest: it goes back to where it was, unless it is less deep in them
// than there.
void CContinuous::StayInPlace(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  const Vector2d begin = GetFreeMotion(ball.m_nBall).m_vPos;
  if (GetDepthIn(eShapes::Resting, ball, ball.m_vPos) < GetDepthIn(eShapes::Resting, ball, begin)) return;
  ball.m_vPos = begin;
  m_stdTouching.clear(); // of where it was in between
  MoveDisc(i);
  FindShapes(i);
}

void CContinuous::TellIfGoneOver(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  const auto goesOver = [&](std::uint32_t order) {
    const CShapeGeometry& o = m_pShapes->GetGeometry(order);
    return !IsAmong(eShapes::Static, order) && o.m_eSides == eSides::Both &&
           GetDepth(order, GetMotion(ball)) > g_fSettleReach * ball.m_fRadius;
  };
  if (std::any_of(m_stdShapesFound.begin(), m_stdShapesFound.end(), goesOver)) TellHalted(ball);
}

void CContinuous::TellHalted(CMoving& ball) {
  if (!std::exchange(ball.m_bIsTold, true)) m_stdHalted.push_back(GetId(ball));
}

// Whether a ball that is deep in a one-sided shape comes through it from behind: it moves out of it, and
// neither others nor what it is set back from have pressed it deeper into it in this substep.
bool CContinuous::ComesThrough(const CMoving& ball, std::uint32_t order, const CImpact& impact,
                               double gap) const {
  FailIf(!(impact.m_vNorm.dot(ball.m_vVel - impact.m_vSurface) > 0.0));
  CImpact before;
  double gapBefore;
  return IsNearShape(order, GetFreeMotion(ball.m_nBall), 0.0, 0.0, before, gapBefore) &&
         gap >= gapBefore - GetRounding(ball, order);
}

// By order, each from where those before it have put it. Whether any had to. Under gravity those that it
// touches are kept: it is held on them, or put onto them where it meets them.
bool CContinuous::SetBackFromShapes(std::uint32_t i, eShapes from, eThrough through) {
  bool had = false;
  m_stdTouching.clear();
  for (std::size_t k = 0; k < m_stdShapesFound.size(); ++k) {
    const std::uint32_t order = m_stdShapesFound[k];
    const CShapeGeometry& geometry = m_pShapes->GetGeometry(order);
    if (!m_pShapes->Get(order).m_pShape->GetCanCollide()) continue;
    if (!IsAmong(from, order)) continue;
    const CMoving& ball = m_stdBalls[i];
    const double rounding = GetRounding(ball, order);
    const double reach = IsFalling() ? rounding : 0.0;
    CImpact impact;
    double gap;
    if (IsOutOfWay(geometry, GetPlace(ball), 0.0, reach) ||
        !IsNearShape(order, GetMotion(ball), 0.0, reach, impact, gap))
      continue;
    const bool isRounding = gap >= -rounding;
    if (isRounding && IsFalling()) {
      m_stdTouching.push_back({order, gap, impact});
      continue;
    }
    if (!isRounding && geometry.m_eSides != eSides::Both && ComesThrough(ball, order, impact, gap)) continue;
    if (isRounding)
      CorrectPosition(i, -gap * impact.m_vNorm);
    else
      SetBackFromShape(i, order, impact.m_vNorm, -gap, through);
    had = true;
    m_stdTouching.clear();
    FindShapes(i);
    const auto next = std::upper_bound(m_stdShapesFound.begin(), m_stdShapesFound.end(), order);
    k = static_cast<std::size_t>(next - m_stdShapesFound.begin()) - 1;
  }
  return had;
}

// The share of a push of a ball from p by `way`, all at once, that no shape is in the way of, as they are at
// `time`, but for these.
double CContinuous::GetFreeShare(const CMoving& ball, const Vector2d& p, const Vector2d& way, double time,
                                 const CNotInTheWay& except) {
  const double radius = ball.m_fRadius;
  CAabb2D box(ToFloat(p), ToFloat(p));
  box += ToFloat(p + way);
  std::vector<std::uint32_t>& orders = m_stdInTheWay;
  orders.clear();
  m_pShapes->Query(Padded(box, static_cast<float>(radius) * (1.0f + g_fBoxPadding)), orders);
  // Each is looked for in the time that those before have left.
  std::sort(orders.begin(), orders.end());
  CMotion motion{p, way / g_fInstant, radius, g_fInstant};
  for (const std::uint32_t order : orders) {
    const CShapeGeometry& o = m_pShapes->GetGeometry(order);
    if (order == except.m_nShape || (except.m_pAlong != nullptr && o.MovesAs(*except.m_pAlong))) continue;
    CImpact impact;
    if (!MeetsShape(ball, order) || !m_pShapes->Get(order).m_pShape->GetCanCollide()) continue;
    if (Sweep(o, motion, time, impact) != eSweep::None)
      motion.m_fDuration = std::min(motion.m_fDuration, impact.m_fTime);
  }
  return motion.m_fDuration / g_fInstant;
}

// The share of a push of a ball along n that leads it through nothing, nor into what it is clear of.
double CContinuous::GetClearShare(const CMoving& ball, const Vector2d& n, double depth) {
  const Vector2d clear = ball.m_vPos + Clear(SizeOf(ball.m_vPos, ball.m_fRadius), depth) * n;
  return GetFreeShare(ball, clear, depth * n, 0.0, {});
}

// Along n, out of another ball, up to what shape is in the way.
void CContinuous::SetBackFromBall(std::uint32_t i, const Vector2d& n, double depth) {
  const CMoving& ball = m_stdBalls[i];
  if (depth > Rounding(SizeOf(ball.m_vPos, ball.m_fRadius))) depth *= GetClearShare(ball, n, depth);
  CorrectPosition(i, depth * n);
}

// Along n, out of a shape, by much only up to what else is in the way. A game may have put it so deep into
// several that its centre is closer to others than it is set back: it goes half of the way to the first.
void CContinuous::SetBackFromShape(std::uint32_t i, std::uint32_t order, const Vector2d& n, double depth,
                                   eThrough through) {
  CMoving ball = m_stdBalls[i];
  if (through == eThrough::None && depth > g_fFarCorrection * ball.m_fRadius)
    depth *= GetClearShare(ball, n, depth);
  ball.m_fRadius = 0.0;
  const double share = GetFreeShare(ball, ball.m_vPos, depth * n, 0.0, {.m_nShape = order});
  CorrectPosition(i, (share < 1.0 ? 0.5 * share : 1.0) * depth * n);
}

void CContinuous::CorrectPosition(std::uint32_t i, const Vector2d& way) {
  CMoving& ball = m_stdBalls[i];
  ball.m_vPos += way;
  ball.m_bIsMoved = true;
  MoveDisc(i);
}

} // namespace Shapes::Native
