// SPDX-License-Identifier: MIT
#include "Continuous.h"

#include "../../shapes/Response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace Shapes::Native {
namespace {

double SizeOf(const Vector2d& p, double r) { return p.cwiseAbs().maxCoeff() + r; }

// An overlap that rounding explains, where these are the coordinates.
double Rounding(double size) { return static_cast<double>(g_fTouchRounding) * size; }

// How far a place is moved at most where it is rounded to floats. A ball smaller than that would be found on
// what it has left, or behind it.
double FloatRounding(const Vector2d& p) {
  return 0.5 * static_cast<double>(std::numeric_limits<float>::epsilon()) * p.norm();
}

// How far a centre is kept from where no direction leads away (a shape, or the middle of a disc): there the
// normal is against the velocity, and one that leaves would be taken for one that comes. At the origin,
// where nothing has a size, the way has one.
double Clear(double size, double way) {
  return 4.0 * std::numeric_limits<double>::epsilon() * (size > 0.0 ? size : way);
}

Vector2 ToFloat(const Vector2d& p) {
  // Beyond it boxes are all alike, and nothing is there.
  const double most = 1e37;
  return p.cwiseMax(-most).cwiseMin(most).cast<float>();
}

} // namespace

bool CContinuous::CEvent::operator<(const CEvent& other) const {
  return std::tie(m_fTime, m_nBall) > std::tie(other.m_fTime, other.m_nBall);
}

void CContinuous::Step(CBallArrays& balls, CStaticBroadPhase& shapes, bool pairs, const Vector2& gravityStep,
                       float dt, CWorldStats& stats) {
  m_pBalls = &balls;
  m_pShapes = &shapes;
  m_pStats = &stats;
  m_fStep = static_cast<double>(dt);
  m_vGravityStep = gravityStep.cast<double>();
  m_stdContacts.clear();
  m_stdPathVertices.clear();
  m_stdQueue.clear();
  shapes.BoxKinematic(dt);
  shapes.MakeGeometries(dt);

  TakeBalls(balls);
  SortBalls(pairs);
  const auto n = static_cast<std::uint32_t>(m_stdBalls.size());
  for (std::uint32_t i = 0; i < n; ++i)
    SetBackFromBalls(i);
  for (std::uint32_t i = 0; i < n; ++i) {
    // Out of one shape may be into another: a ball in a wedge is set back in turns.
    FindShapes(i);
    for (int turn = 0; turn < g_nSetBackRounds && SetBackFromShapes(i); ++turn)
      FindShapes(i);
    m_pStats->m_nBallsSwept += !m_stdShapesFound.empty();
    FindShapeImpacts(m_stdBalls[i]);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    FindBallImpacts(i);
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
  PutBalls(balls);
}

void CContinuous::TakeBalls(const CBallArrays& b) {
  m_stdBalls.clear();
  m_stdBoxes.clear();
  for (std::size_t i = 0; i < b.Size(); ++i) {
    if (!b.m_stdCanCollide[i] || b.m_stdSensor[i]) continue;
    CMoving ball;
    ball.m_nBall = i;
    ball.m_vPos = b.m_stdPos[i].cast<double>();
    ball.m_vVel = ball.m_vFirst = b.m_stdVel[i].cast<double>();
    ball.m_fRadius = static_cast<double>(b.m_stdRadius[i]);
    ball.m_fMass = static_cast<double>(b.m_stdMass[i]);
    ball.m_fElasticity = static_cast<double>(b.m_stdElasticity[i]);
    m_stdBoxes.push_back(GetBox(ball));
    m_stdBalls.push_back(ball);
  }
}

// The tree does not matter to what comes out, so it may be an old one whose boxes have moved on.
void CContinuous::SortBalls(bool pairs) {
  const std::size_t n = pairs ? m_stdBoxes.size() : 0;
  if (n == m_cBallTree.Size() && ++m_nRefits < g_nMaxRefits) return m_cBallTree.Refit(m_stdBoxes);
  m_cBallTree.Build(std::span<const CAabb2D>(m_stdBoxes).first(n));
  m_nRefits = 0;
}

void CContinuous::PutBalls(CBallArrays& b) const {
  const auto dt = static_cast<float>(m_fStep);
  b.m_stdPrevPos = b.m_stdPos;
  auto ball = m_stdBalls.begin();
  for (std::size_t i = 0; i < b.Size(); ++i) {
    const bool isSolid = ball != m_stdBalls.end() && ball->m_nBall == i;
    if (isSolid && ball->m_bIsMoved) {
      b.m_stdPos[i] = ToFloat(ball->m_vPos + ball->GetPathVel() * (m_fStep - ball->m_fTime));
      b.m_stdVel[i] = ball->m_vVel.cast<float>();
    } else {
      Move(b.m_stdPos[i], b.m_stdVel[i], dt);
    }
    ball += isSolid;
  }
}

CMotion CContinuous::GetMotion(const CMoving& ball) const {
  return {ball.m_vPos, ball.GetPathVel(), ball.m_fRadius, m_fStep - ball.m_fTime};
}

CAabb2D CContinuous::GetBox(const CMoving& ball) const {
  const CMotion motion = GetMotion(ball);
  CAabb2D box(ToFloat(motion.m_vPos), ToFloat(motion.m_vPos));
  box += ToFloat(motion.m_vPos + motion.m_vVel * motion.m_fDuration);
  return Padded(box, static_cast<float>(motion.m_fRadius) * (1.0f + g_fBoxPadding));
}

void CContinuous::SetBackFromBalls(std::uint32_t i) {
  m_stdBallsFound.clear();
  m_cBallTree.Query(m_stdBoxes[i], m_stdBallsFound);
  std::sort(m_stdBallsFound.begin(), m_stdBallsFound.end());
  for (const std::uint32_t j : m_stdBallsFound) {
    CImpact impact;
    double depth;
    if (j <= i || !OverlapBallBall(GetMotion(m_stdBalls[j]), GetMotion(m_stdBalls[i]), impact, depth))
      continue;
    const double m0 = m_stdBalls[i].m_fMass, m1 = m_stdBalls[j].m_fMass;
    CorrectPosition(i, impact.m_vNorm, depth * (m1 / (m0 + m1)));
    CorrectPosition(j, -impact.m_vNorm, depth * (m0 / (m0 + m1)));
  }
}

// The shapes on the way of the motion, by order.
void CContinuous::FindShapes(std::uint32_t i) {
  m_stdShapesFound.clear();
  m_pShapes->Query(m_stdBoxes[i], m_stdShapesFound);
  std::sort(m_stdShapesFound.begin(), m_stdShapesFound.end());
}

// From those that were found. Whether it had to.
bool CContinuous::SetBackFromShapes(std::uint32_t i) {
  bool had = false;
  for (const std::uint32_t order : m_stdShapesFound) {
    if (!m_pShapes->Get(order).m_pShape->GetCanCollide()) continue;
    const CMoving& ball = m_stdBalls[i];
    const CShapeGeometry& geometry = m_pShapes->GetGeometry(order);
    CImpact impact;
    double depth;
    if (!Overlap(geometry, GetMotion(ball), 0.0, impact, depth)) continue;
    const bool isRounding = depth <= Rounding(SizeOf(ball.m_vPos, ball.m_fRadius) + geometry.m_fSize);
    if (!isRounding && geometry.m_eSides != eSides::Both) continue;
    CorrectPosition(i, impact.m_vNorm, depth);
    had = true;
  }
  return had;
}

// Moves a ball along n; if it could get through something by that, only up to what is in the way.
void CContinuous::CorrectPosition(std::uint32_t i, const Vector2d& n, double depth) {
  CMoving& ball = m_stdBalls[i];
  if (depth > 0.25 * ball.m_fRadius) {
    CMoving corrected = ball;
    corrected.m_vVel = depth / m_fStep * n;
    const CAabb2D box = GetBox(corrected);
    CMotion motion = GetMotion(corrected);
    motion.m_vPos += Clear(SizeOf(motion.m_vPos, motion.m_fRadius), depth) * n;
    motion.m_vVel = depth / g_fInstant * n;
    motion.m_fDuration = g_fInstant;
    std::vector<std::uint32_t> orders;
    m_pShapes->Query(box, orders);
    for (const std::uint32_t order : orders) {
      CImpact impact;
      if (m_pShapes->Get(order).m_pShape->GetCanCollide() &&
          Sweep(m_pShapes->GetGeometry(order), motion, 0.0, impact) != eSweep::None)
        motion.m_fDuration = std::min(motion.m_fDuration, impact.m_fTime);
    }
    depth *= motion.m_fDuration / g_fInstant;
  }
  ball.m_vPos += depth * n;
  ball.m_bIsMoved = true;
  m_stdBoxes[i] = GetBox(ball);
  m_cBallTree.Grow(i, m_stdBoxes[i]);
}

void CContinuous::FindNext(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  ball.m_cNext = CNext();
  if (!ball.m_bIsHalted) {
    FindShapes(i);
    FindShapeImpacts(ball);
  }
  FindBallImpacts(i);
  Queue(i);
}

void CContinuous::Queue(std::uint32_t i) {
  const CMoving& ball = m_stdBalls[i];
  if (ball.m_cNext.m_eSweep == eSweep::None) return;
  const double time = std::min(ball.m_fTime + ball.m_cNext.m_cImpact.m_fTime, m_fStep);
  m_stdQueue.push_back({time, i, ball.m_nVersion});
  std::push_heap(m_stdQueue.begin(), m_stdQueue.end());
}

// Of those that were found.
void CContinuous::FindShapeImpacts(CMoving& ball) {
  for (const std::uint32_t order : m_stdShapesFound) {
    if (!m_pShapes->Get(order).m_pShape->GetCanCollide()) continue;
    ++m_pStats->m_nSweeps;
    const CShapeGeometry& geometry = m_pShapes->GetGeometry(order);
    CNext found;
    found.m_nOther = order;
    found.m_eSweep = Sweep(geometry, GetMotion(ball), ball.m_fTime, found.m_cImpact);
    KeepEarliest(found, geometry.m_fSize, ball);
  }
}

void CContinuous::FindBallImpacts(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  m_stdBallsFound.clear();
  m_cBallTree.Query(m_stdBoxes[i], m_stdBallsFound);
  for (const std::uint32_t j : m_stdBallsFound) {
    if (j == i) continue;
    ++m_pStats->m_nSweeps;
    // Both from the time at which the later motion of the two begins; none beyond what stops it.
    const CMoving& other = m_stdBalls[j];
    const double start = std::max(ball.m_fTime, other.m_fTime), since = start - ball.m_fTime;
    double otherSince = start - other.m_fTime;
    if (other.m_cNext.m_eSweep != eSweep::None)
      otherSince = std::min(otherSince, other.m_cNext.m_cImpact.m_fTime);
    CMotion motion = GetMotion(ball), otherMotion = GetMotion(other);
    motion.m_vPos += motion.m_vVel * since;
    otherMotion.m_vPos += otherMotion.m_vVel * otherSince;
    motion.m_fDuration = otherMotion.m_fDuration = m_fStep - start;

    CNext found;
    found.m_bIsBall = true;
    found.m_nOther = j;
    found.m_nOtherVersion = other.m_nVersion;
    found.m_eSweep = ImpactBallBall(otherMotion, motion, found.m_cImpact);
    if (found.m_eSweep == eSweep::None) continue;
    found.m_fOtherTime = otherSince + found.m_cImpact.m_fTime;
    found.m_cImpact.m_fTime += since;
    KeepEarliest(found, other.m_fRadius, ball);
  }
}

// Takes what was found as the next of the ball if it comes first.
void CContinuous::KeepEarliest(const CNext& found, double size, CMoving& ball) const {
  if (found.m_eSweep == eSweep::None) return;
  const CImpact& impact = found.m_cImpact;
  if (found.m_eSweep == eSweep::Impact && impact.m_fCurve == 0.0) {
    // What would not take the ball into it by more than rounding is none, or a pile that settles would never
    // be done with it. Nor by more than a quarter of its radius: a tiny
    // one would be through by then, or past the middle and set back to the other side.
    const double approach = ApproachSpeed(ball.GetPathVel(), impact.m_vSurface, impact.m_vNorm);
    const double left = m_fStep - ball.m_fTime - impact.m_fTime;
    const double rounding = Rounding(size + SizeOf(impact.m_vPOI, ball.m_fRadius));
    if (approach * left <= std::min(rounding, 0.25 * ball.m_fRadius)) return;
  }
  const auto order = [](const CNext& n) { return std::tuple(n.m_cImpact.m_fTime, n.m_bIsBall, n.m_nOther); };
  if (ball.m_cNext.m_eSweep == eSweep::None || order(found) < order(ball.m_cNext)) ball.m_cNext = found;
}

void CContinuous::Resolve(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  const CNext next = ball.m_cNext;
  if (next.m_eSweep == eSweep::OutOfIterations) {
    Advance(ball, next.m_cImpact.m_fTime);
    Halt(ball);
    return NewMotion(i);
  }
  if (!next.m_bIsBall) {
    ResolveWithShape(ball);
    return NewMotion(i);
  }
  CMoving& other = m_stdBalls[next.m_nOther];
  ResolveWithBall(ball, other);
  // Both boxes have to be there before either looks for the other.
  m_stdBoxes[i] = GetBox(ball);
  m_cBallTree.Grow(i, m_stdBoxes[i]);
  NewMotion(next.m_nOther);
  NewMotion(i);
}

void CContinuous::NewMotion(std::uint32_t i) {
  m_stdBoxes[i] = GetBox(m_stdBalls[i]);
  m_cBallTree.Grow(i, m_stdBoxes[i]);
  FindNext(i);
}

void CContinuous::Advance(CMoving& ball, double motion) {
  ball.m_vPos += ball.GetPathVel() * motion;
  ball.m_fTime = std::min(ball.m_fTime + motion, m_fStep);
  ball.m_bIsMoved = true;
  ++ball.m_nVersion;
}

void CContinuous::ResolveWithShape(CMoving& ball) {
  const CImpact impact = ball.m_cNext.m_cImpact;
  const std::uint32_t order = ball.m_cNext.m_nOther;
  const CShapeEntry& entry = m_pShapes->Get(order);
  const Vector2d &n = impact.m_vNorm, &surface = impact.m_vSurface;
  const bool isResting = IsRestingContact(ball);
  Advance(ball, impact.m_fTime);
  const double depth = ball.m_fRadius - (ball.m_vPos - impact.m_vPOI).dot(n);
  const double size = SizeOf(ball.m_vPos, ball.m_fRadius) + m_pShapes->GetGeometry(order).m_fSize;
  const double clear = Clear(size, ball.m_vVel.norm() * m_fStep);
  // Exactly onto the shape; but one that began deep in something stays there.
  if (depth <= Rounding(size))
    ball.m_vPos = impact.m_vPOI + std::max(ball.m_fRadius, FloatRounding(ball.m_vPos) + clear) * n;
  else
    ball.m_vPos += clear * n;
  const double approach = ApproachSpeed(ball.m_vVel, surface, n);
  const double e =
      isResting ? 0.0 : ball.m_fElasticity * static_cast<double>(entry.m_pShape->GetElasticity());
  RespondKinematic(n, 0.0, e, surface, ball.m_vPos, ball.m_vVel);
  if (ball.m_nLastOrder == order && impact.m_fTime * g_nHops < m_fStep) Slide(ball, impact);
  m_pStats->m_nSpeedsCapped += CapSpeed(ball.m_vVel);
  ball.m_nLastOrder = order;
  Report(entry.m_cId, ball, impact.m_vPOI, n, approach);
  EndMotion(ball);
}

// Whether a ball touches its next shape since the substep began, and would not approach it but for gravity,
// which has pressed it there or into its neighbour in a corner. That is no impact: thrown back, what
// rests would hop, and an elastic ball climb.
bool CContinuous::IsRestingContact(const CMoving& ball) const {
  const CImpact& impact = ball.m_cNext.m_cImpact;
  const Vector2d &n = impact.m_vNorm, &surface = impact.m_vSurface;
  const double size =
      SizeOf(impact.m_vPOI, ball.m_fRadius) + m_pShapes->GetGeometry(ball.m_cNext.m_nOther).m_fSize;
  const double speed = ball.m_vFirst.norm() + surface.norm(), gravityStep = m_vGravityStep.norm();
  return gravityStep > 0.0 && (ball.m_fTime + impact.m_fTime) * speed <= Rounding(size) &&
         ApproachSpeed<Vector2d>(ball.m_vFirst - m_vGravityStep, surface, n) <= Rounding(speed) &&
         ApproachSpeed(ball.m_vVel, surface, n) <= gravityStep + Rounding(speed);
}

// A ball that stays on a surface that curves towards it would meet it again at once, and again.
void CContinuous::Slide(CMoving& ball, const CImpact& impact) const {
  const Vector2d &n = impact.m_vNorm, u = ball.m_vVel - impact.m_vSurface;
  const double most = static_cast<double>(g_fShallow) * (ball.m_vVel.norm() + impact.m_vSurface.norm());
  const double hop = std::min(impact.m_fCurve * m_fStep / (2.0 * g_nHops), most), out = u.dot(n);
  if (!(out < hop)) return;
  const Vector2d along = u - out * n;
  const double speed = along.norm();
  // What it gains across it loses along the surface.
  const double left = std::sqrt(std::max(0.0, u.squaredNorm() - hop * hop));
  ball.m_vVel = impact.m_vSurface + hop * n + (speed > 0.0 ? left / speed : 0.0) * along;
}

void CContinuous::ResolveWithBall(CMoving& ball, CMoving& other) {
  const CNext next = ball.m_cNext;
  const Vector2d n = next.m_cImpact.m_vNorm;
  Advance(ball, next.m_cImpact.m_fTime);
  Advance(other, next.m_fOtherTime);
  other.m_fTime = ball.m_fTime;
  const double e = ball.m_fElasticity * other.m_fElasticity;
  const double approach = ApproachSpeed(ball.GetPathVel(), other.GetPathVel(), n);
  const double size = SizeOf(ball.m_vPos, ball.m_fRadius) + SizeOf(other.m_vPos, other.m_fRadius);
  const double clear = Clear(size, (ball.m_vVel - other.m_vVel).norm() * m_fStep);
  const double rounding = FloatRounding(ball.m_vPos) + FloatRounding(other.m_vPos);
  const double apart = std::max(ball.m_fRadius + other.m_fRadius, rounding + clear);
  double setback = apart - (ball.m_vPos - other.m_vPos).dot(n);
  if (std::abs(setback) > Rounding(size)) setback = clear; // they began deep in each other
  const Vector2d rest = Vector2d::Zero();
  if (other.m_bIsHalted)
    RespondKinematic(n, setback, e, rest, ball.m_vPos, ball.m_vVel);
  else if (ball.m_bIsHalted)
    RespondKinematic(Vector2d(-n), setback, e, rest, other.m_vPos, other.m_vVel);
  else
    RespondDynamic(n, setback, e, other.m_fMass, ball.m_fMass, other.m_vPos, other.m_vVel, ball.m_vPos,
                   ball.m_vVel);
  for (CMoving* pBall : {&ball, &other}) {
    m_pStats->m_nSpeedsCapped += CapSpeed(pBall->m_vVel);
    pBall->m_nLastOrder = g_nNone;
  }
  const bool ballIsFirst = ball.m_nBall < other.m_nBall;
  const CMoving &first = ballIsFirst ? ball : other, &second = ballIsFirst ? other : ball;
  const Vector2d nhat = ballIsFirst ? n : Vector2d(-n);
  Report(m_pBalls->m_stdId[second.m_nBall], first, second.m_vPos + second.m_fRadius * nhat, nhat, approach);
  for (CMoving* pBall : {&ball, &other})
    if (!pBall->m_bIsHalted) EndMotion(*pBall);
}

void CContinuous::Report(CShapeId shape, const CMoving& ball, const Vector2d& poi, const Vector2d& n,
                         double speed) {
  ++m_pStats->m_nContacts;
  CContactEvent event;
  event.m_cShape = shape;
  event.m_cBall = m_pBalls->m_stdId[ball.m_nBall];
  event.m_vPOI = ToFloat(poi);
  event.m_vNorm = n.cast<float>();
  event.m_fSpeed = static_cast<float>(speed);
  m_stdContacts.push_back(event);
}

void CContinuous::EndMotion(CMoving& ball) {
  m_stdPathVertices.push_back(
      {ball.m_nBall, ToFloat(ball.m_vPos), static_cast<float>(ball.m_fTime / m_fStep)});
  if (++ball.m_nImpacts == g_nMaxImpacts) Halt(ball);
}

void CContinuous::Halt(CMoving& ball) {
  ball.m_bIsHalted = true;
  ++m_pStats->m_nBallsHalted;
}

} // namespace Shapes::Native
