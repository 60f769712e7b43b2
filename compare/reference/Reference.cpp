// SPDX-License-Identifier: MIT
#include "Reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

constexpr double g_fTau = 2.0 * std::numbers::pi;
constexpr double g_fEps = std::numeric_limits<double>::epsilon();

// How far outside of what it has hit a ball is put, relative to its coordinates: more than the rounding of
// that place, so that it is not inside, and much less than what counts as touching.
constexpr double g_fNudge = 4.0 * g_fEps;

// A velocity that a hit without elasticity has left, relative to the speeds before it: below this it is
// rounding, and the ball rests on what it has hit.
constexpr double g_fResidue = 8.0 * g_fEps;

} // namespace

double CReference::CSolid::GetSpeed() const { return Turns() ? g_fTau * m_fRevs : 0.0; }

CFigure<double> CReference::CSolid::GetFigure(double t) const {
  const double angle = m_fAngle + GetSpeed() * t;
  if (angle == 0.0) return m_cFigure;
  CFigure<double> f = m_cFigure;
  for (CVec2d* p : {&f.m_vCenter, &f.m_vPt0, &f.m_vPt1})
    *p = m_vRotCenter + Turned(CVec2d(*p - m_vRotCenter), angle);
  return f;
}

void CReference::CSolid::SetBox() {
  const CFigure<double> f = GetFigure(0.0);
  const double padded = f.m_fRadius * (1.0 + 4.0 * g_fGraze);
  const CVec2d r(padded, padded);
  if (f.m_eShapeType == eShape::LineSeg) {
    m_vLow = f.m_vPt0.cwiseMin(f.m_vPt1);
    m_vHigh = f.m_vPt0.cwiseMax(f.m_vPt1);
  } else {
    m_vLow = f.m_vCenter - r;
    m_vHigh = f.m_vCenter + r;
  }
  if (!m_bKinematic) return;
  const double reach = std::max({Norm(CVec2d(f.m_vPt0 - m_vRotCenter)), Norm(CVec2d(f.m_vPt1 - m_vRotCenter)),
                                 Norm(CVec2d(f.m_vCenter - m_vRotCenter)) + padded});
  const double all = reach + 16.0 * g_fEps * (reach + m_vRotCenter.cwiseAbs().maxCoeff());
  m_vLow = m_vRotCenter - CVec2d(all, all);
  m_vHigh = m_vRotCenter + CVec2d(all, all);
}

CReference::CReference(std::span<const CAnyShapeDesc> shapes, std::span<const CDynamicCircleDesc> balls,
                       const Vector2& gravity)
    : m_vGravity(ToDouble(gravity)) {
  if (!gravity.allFinite()) throw std::invalid_argument("gravity is not finite");
  for (const CAnyShapeDesc& any : shapes) {
    CSolid solid{};
    solid.m_cFigure = MakeFigure(any);
    std::visit(
        [&](const CShapeDesc& desc) {
          if (desc.m_eMotionType != eMotion::Static && desc.m_eMotionType != eMotion::Kinematic)
            throw std::invalid_argument("m_eMotionType is neither Static nor Kinematic");
          solid.m_vRotCenter = ToDouble(desc.m_vRotCenter);
          solid.m_bKinematic = desc.m_eMotionType == eMotion::Kinematic;
          solid.m_fRevs = static_cast<double>(desc.m_fRotSpeed);
          solid.m_fElasticity = static_cast<double>(desc.m_fElasticity);
          solid.m_bIsSensor = desc.m_bIsSensor;
        },
        any);
    solid.m_fAngle = 0.0;
    solid.m_bCanCollide = true;
    solid.SetBox();
    m_stdShapes.push_back(solid);
  }
  for (const CDynamicCircleDesc& desc : balls) {
    const CDynamicCircle ball(desc);
    m_stdBalls.push_back({ToDouble(ball.GetPos()), ToDouble(ball.GetVel()),
                          static_cast<double>(ball.GetRadius()), static_cast<double>(ball.GetMass()),
                          static_cast<double>(ball.GetElasticity()), ball.GetSensor()});
  }
}

void CReference::SetBall(std::size_t ball, const CVec2d& p, const CVec2d& v) {
  if (!p.allFinite() || !v.allFinite()) throw std::invalid_argument("p or v is not finite");
  m_stdBalls.at(ball).m_vPos = p;
  m_stdBalls.at(ball).m_vVel = v;
}

CFigure<double> CReference::GetFigure(std::size_t shape) const {
  return m_stdShapes.at(shape).GetFigure(0.0);
}

void CReference::SetOrientation(std::size_t shape, double angle) {
  CSolid& solid = m_stdShapes.at(shape);
  if (!solid.m_bKinematic || !std::isfinite(angle))
    throw std::invalid_argument("SetOrientation: expected a kinematic shape and a finite angle");
  solid.m_fAngle = std::fmod(angle, g_fTau);
  if (solid.m_fAngle < 0.0) solid.m_fAngle += g_fTau;
  if (solid.m_fAngle >= g_fTau) solid.m_fAngle = 0.0;
}

void CReference::SetRotSpeed(std::size_t shape, double revsPerSecond) {
  CSolid& solid = m_stdShapes.at(shape);
  if (!solid.m_bKinematic || !std::isfinite(revsPerSecond))
    throw std::invalid_argument("SetRotSpeed: expected a kinematic shape and a finite speed");
  solid.m_fRevs = revsPerSecond;
}

void CReference::Step(double dt, std::vector<CExactEvent>& events) {
  if (!(std::isfinite(dt) && dt >= 0.0))
    throw std::invalid_argument("dt: expected a finite number of at least 0");
  m_fStep = dt;
  m_fNow = 0.0;
  m_stdTime.assign(m_stdBalls.size(), 0.0);
  m_stdNext.resize(m_stdBalls.size());
  m_stdPairs.clear();
  m_stdNear.clear();
  for (CExactBall& ball : m_stdBalls)
    ball.m_vVel += m_vGravity * dt;
  for (std::size_t i = 0; i < m_stdBalls.size(); ++i)
    FindNext(i);

  const std::size_t events0 = events.size();
  for (int count = 0;; ++count) {
    std::size_t first = m_stdBalls.size();
    for (std::size_t i = 0; i < m_stdBalls.size(); ++i)
      if (m_stdNext[i].m_bFound &&
          (first == m_stdBalls.size() || m_stdNext[i].m_cHit.m_fTime < m_stdNext[first].m_cHit.m_fTime))
        first = i;
    if (first == m_stdBalls.size()) break;
    if (events.size() - events0 >= g_nMaxEvents || count >= g_nMaxSlideHits) Jammed(first);
    const CNext next = m_stdNext[first];
    m_fNow = next.m_cHit.m_fTime;
    CountNearMisses(m_fNow);
    Answer(first, next, events);
    FindAfter();
  }

  CountNearMisses(dt);
  for (std::size_t i = 0; i < m_stdBalls.size(); ++i)
    m_stdBalls[i].m_vPos += m_stdBalls[i].m_vVel * (dt - m_stdTime[i]);
  for (std::size_t i = 0; i < m_stdShapes.size(); ++i)
    if (m_stdShapes[i].Turns()) SetOrientation(i, m_stdShapes[i].m_fAngle + m_stdShapes[i].GetSpeed() * dt);
}

CSweptBall<double> CReference::GetSwept(std::size_t i, double t) const {
  const CExactBall& ball = m_stdBalls[i];
  return {ball.m_vPos + ball.m_vVel * (t - m_stdTime[i]), ball.m_vVel, ball.m_fRadius};
}

void CReference::FindNext(std::size_t i) {
  CNext& next = m_stdNext[i];
  next.m_bFound = false;
  if (!m_stdBalls[i].m_bCanCollide) return;
  MeetShapes(i, next);
  for (std::size_t j = 0; j < m_stdBalls.size(); ++j)
    MeetBall(i, j, next);
}

void CReference::MeetShapes(std::size_t i, CNext& next) {
  const double now = m_stdTime[i], left = m_fStep - now;
  const CSweptBall<double> ball = GetSwept(i, now);
  const CVec2d end = ball.m_vPos + ball.m_vVel * left;
  // Wider than what touches or nearly does, so that the boxes lose no hit and no near miss.
  const double pad =
      ball.m_fRadius * (1.0 + 4.0 * g_fGraze) +
      4.0 * g_nTouchRoundings * g_fEps *
          (ball.m_fRadius + std::max(ball.m_vPos.cwiseAbs().maxCoeff(), end.cwiseAbs().maxCoeff()));
  const CVec2d low = ball.m_vPos.cwiseMin(end) - CVec2d(pad, pad);
  const CVec2d high = ball.m_vPos.cwiseMax(end) + CVec2d(pad, pad);
  for (std::size_t k = 0; k < m_stdShapes.size(); ++k) {
    const CSolid& solid = m_stdShapes[k];
    if (low.x() > solid.m_vHigh.x() || high.x() < solid.m_vLow.x() || low.y() > solid.m_vHigh.y() ||
        high.y() < solid.m_vLow.y() || !solid.m_bCanCollide)
      continue;
    const bool sensor = solid.m_bIsSensor || m_stdBalls[i].m_bIsSensor;
    if (const CPair* pPair = sensor ? FindPair(i, k, false) : nullptr; pPair && pPair->m_bSensed) continue;
    CHit<double> hit;
    const eMeet meet = sensor && now == 0.0 ? eMeet::Touching : eMeet::Approaching;
    const bool found = solid.m_bKinematic ? Sweep(solid.GetFigure(now),
                                                  CTurning<double>{solid.m_vRotCenter, solid.GetSpeed()},
                                                  ball, left, hit, meet)
                                          : Sweep(solid.m_cFigure, ball, left, hit, meet);
    hit.m_fTime += now;
    Offer(next, found && !IsNegligible(i, k, false, hit), false, i, k, hit);
  }
}

void CReference::MeetBall(std::size_t i, std::size_t j, CNext& next) {
  if (i == j || !m_stdBalls[j].m_bCanCollide) return;
  const std::size_t a = std::min(i, j), b = std::max(i, j);
  const bool sensor = m_stdBalls[i].m_bIsSensor || m_stdBalls[j].m_bIsSensor;
  if (const CPair* pPair = sensor ? FindPair(a, b, true) : nullptr; pPair && pPair->m_bSensed) return;
  CHit<double> hit;
  const eMeet meet = sensor && m_fNow == 0.0 ? eMeet::Touching : eMeet::Approaching;
  const bool found = SweepBalls(GetSwept(b, m_fNow), GetSwept(a, m_fNow), m_fStep - m_fNow, hit, meet);
  hit.m_fTime += m_fNow;
  // The hit is that of the lower ball, whichever of the two it is kept for.
  Offer(next, found && !IsNegligible(a, b, true, hit), true, i, j, hit);
}

void CReference::Offer(CNext& next, bool found, bool isBall, std::size_t i, std::size_t other,
                       const CHit<double>& hit) {
  if (found && (!next.m_bFound || hit.m_fTime < next.m_cHit.m_fTime)) next = {true, isBall, other, hit};
  if (found || !hit.m_bGraze) return;
  const std::size_t a = isBall ? std::min(i, other) : i, b = isBall ? std::max(i, other) : other;
  const bool known = std::any_of(m_stdNear.begin(), m_stdNear.end(), [&](const CNear& n) {
    return n.m_nBall == a && n.m_nOther == b && n.m_bIsBall == isBall;
  });
  if (!known) m_stdNear.push_back({a, b, isBall, hit.m_fTime});
}

void CReference::CountNearMisses(double now) {
  m_nNearMisses += std::erase_if(m_stdNear, [&](const CNear& n) { return n.m_fTime <= now; });
}

// Some balls have got new velocities: what was found with their old ones is void.
void CReference::FindAfter() {
  const auto changed = [&](std::size_t i) {
    return std::find(m_stdChanged.begin(), m_stdChanged.end(), i) != m_stdChanged.end();
  };
  std::sort(m_stdChanged.begin(), m_stdChanged.end());
  m_stdChanged.erase(std::unique(m_stdChanged.begin(), m_stdChanged.end()), m_stdChanged.end());
  std::erase_if(m_stdNear,
                [&](const CNear& n) { return changed(n.m_nBall) || (n.m_bIsBall && changed(n.m_nOther)); });
  for (std::size_t i = 0; i < m_stdBalls.size(); ++i) {
    CNext& next = m_stdNext[i];
    if (changed(i) || (next.m_bFound && next.m_bIsBall && changed(next.m_nOther)))
      FindNext(i);
    else if (m_stdBalls[i].m_bCanCollide)
      for (const std::size_t j : m_stdChanged)
        MeetBall(i, j, next);
  }
}

void CReference::Answer(std::size_t i, const CNext& next, std::vector<CExactEvent>& events) {
  const bool isBall = next.m_bIsBall;
  const std::size_t a = isBall ? std::min(i, next.m_nOther) : i;
  const std::size_t b = isBall ? std::max(i, next.m_nOther) : next.m_nOther;
  CPair& pair = GetPair(a, b, isBall);
  const CHit<double>& hit = next.m_cHit;
  CExactEvent event{};
  event.m_fTime = hit.m_fTime;
  event.m_nBall = a;
  event.m_nShape = b;
  event.m_bIsBall = isBall;
  event.m_bIsSensor =
      m_stdBalls[a].m_bIsSensor || (isBall ? m_stdBalls[b].m_bIsSensor : m_stdShapes[b].m_bIsSensor);
  event.m_bGraze = hit.m_bGraze;
  event.m_bOverlapped = hit.m_fDepth > 2.0 * g_fRest * m_stdBalls[a].GetExtent();
  event.m_ePart = hit.m_ePart;
  event.m_vCenter = hit.m_vCenter;
  event.m_vPOI = hit.m_vPOI;
  event.m_vNorm = hit.m_vNorm;
  event.m_vVelBefore = event.m_vVelAfter = m_stdBalls[a].m_vVel;
  event.m_vSurface = hit.m_vSurface;
  event.m_fDepth = event.m_bOverlapped ? hit.m_fDepth : 0.0;

  ++pair.m_nHits;
  pair.m_vNorm = hit.m_vNorm;
  if (event.m_bIsSensor)
    pair.m_bSensed = true;
  else if (isBall)
    AnswerBall(hit, pair, event);
  else
    AnswerShape(hit, pair, event);
  m_stdChanged = {a};
  if (isBall) m_stdChanged.push_back(b);
  if (pair.m_bSlides && !event.m_bIsSensor) {
    ++m_nSlideHits;
    Settle();
  } else {
    events.push_back(event);
  }
}

void CReference::AnswerShape(const CHit<double>& hit, CPair& pair, CExactEvent& event) {
  CExactBall& ball = m_stdBalls[pair.m_nBall];
  const CSolid& solid = m_stdShapes[pair.m_nOther];
  const CVec2d& n = hit.m_vNorm;
  ball.m_vPos = hit.m_vCenter;
  if (!event.m_bOverlapped) ball.m_vPos = hit.m_vPOI + (ball.m_fRadius + g_fNudge * ball.GetExtent()) * n;
  m_stdTime[pair.m_nBall] = hit.m_fTime;

  const double vn = (ball.m_vVel - hit.m_vSurface).dot(n), e = ball.m_fElasticity * solid.m_fElasticity;
  const double speeds = Norm(ball.m_vVel) + Norm(hit.m_vSurface);
  const bool pressed = (hit.m_ePart == ePart::Inside || solid.Turns()) && -vn < g_fPressed * speeds;
  pair.m_fOut = Slides(pair, e, pressed) ? HopSpeed(ball, solid, hit) : std::max(0.0, -e * vn);
  pair.m_vSurface = hit.m_vSurface;
  Kick(pair);
  if (pair.m_fOut == 0.0 && Norm(CVec2d(ball.m_vVel - hit.m_vSurface)) < g_fResidue * speeds)
    ball.m_vVel = hit.m_vSurface;
  event.m_vVelAfter = ball.m_vVel;
}

void CReference::AnswerBall(const CHit<double>& hit, CPair& pair, CExactEvent& event) {
  CExactBall &a = m_stdBalls[pair.m_nBall], &b = m_stdBalls[pair.m_nOther];
  const CVec2d& n = hit.m_vNorm;
  a.m_vPos = GetSwept(pair.m_nBall, hit.m_fTime).m_vPos;
  b.m_vPos = GetSwept(pair.m_nOther, hit.m_fTime).m_vPos;
  m_stdTime[pair.m_nBall] = m_stdTime[pair.m_nOther] = hit.m_fTime;
  if (!event.m_bOverlapped) {
    const double apart = a.m_fRadius + b.m_fRadius + g_fNudge * (a.GetExtent() + b.GetExtent());
    const CVec2d shift = 0.5 * (apart - (a.m_vPos - b.m_vPos).dot(n)) * n;
    a.m_vPos += shift;
    b.m_vPos -= shift;
  }

  const double speeds = Norm(a.m_vVel) + Norm(b.m_vVel), vn = (a.m_vVel - b.m_vVel).dot(n);
  pair.m_fOut = Slides(pair, a.m_fElasticity * b.m_fElasticity, false)
                    ? 0.0
                    : std::max(0.0, -a.m_fElasticity * b.m_fElasticity * vn);
  Kick(pair);
  for (CExactBall* pBall : {&a, &b})
    if (pair.m_fOut == 0.0 && Norm(pBall->m_vVel) < g_fResidue * speeds) pBall->m_vVel.setZero();
  event.m_vVelAfter = a.m_vVel;
}

CReference::CPair* CReference::FindPair(std::size_t ball, std::size_t other, bool isBall) {
  const auto it = std::find_if(m_stdPairs.begin(), m_stdPairs.end(), [&](const CPair& p) {
    return p.m_nBall == ball && p.m_nOther == other && p.m_bIsBall == isBall;
  });
  return it == m_stdPairs.end() ? nullptr : &*it;
}

CReference::CPair& CReference::GetPair(std::size_t ball, std::size_t other, bool isBall) {
  if (CPair* pPair = FindPair(ball, other, isBall)) return *pPair;
  return m_stdPairs.emplace_back(ball, other, isBall);
}

void CReference::Jammed(std::size_t i) const {
  const CNext& next = m_stdNext[i];
  std::ostringstream out;
  out << "too many events in a step of " << m_fStep << " s: ball " << i << " at ("
      << next.m_cHit.m_vCenter.x() << ", " << next.m_cHit.m_vCenter.y() << ") is jammed against "
      << (next.m_bIsBall ? "ball " : "shape ") << next.m_nOther << ", " << m_fNow << " s into the step";
  throw std::runtime_error(out.str());
}

} // namespace Shapes::Compare
