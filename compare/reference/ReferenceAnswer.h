// SPDX-License-Identifier: MIT
// The response of the reference's balls to an impact. Included by Reference.cpp, and for 50 digits by the
// tests.
#pragma once

#include "Reference.h"

#include <algorithm>

namespace Shapes::Compare {

// How far outside of what it has hit a ball is put, relative to its coordinates: more than the rounding of
// that place, so that it is not inside, and much less than what counts as touching.
template <class T>
T Nudge() {
  return T(4) * std::numeric_limits<T>::epsilon();
}

// How far a ball that was met where no direction leads away (on a shape, in the middle of a disc) is put
// along the normal, so that it is not taken for one that comes back from the other side: more than the
// rounding of a distance among coordinates of that size, less than what counts as touching. At the origin,
// where nothing has a size, the way has one.
template <class T>
T Clear(const T& size, const T& way) {
  return T(8) * Nudge<T>() * (size > T(0) ? size : way);
}

// A velocity that a hit without elasticity has left, relative to the speeds before it: below this it is
// rounding, and the ball rests on what it has hit.
template <class T>
T Residue() {
  return T(8) * std::numeric_limits<T>::epsilon();
}

template <class T>
bool SharesBall(const CExactEvent<T>& a, const CExactEvent<T>& b) {
  const auto has = [&](std::size_t ball) { return b.m_nBall == ball || (b.m_bIsBall && b.m_nShape == ball); };
  return has(a.m_nBall) || (a.m_bIsBall && has(a.m_nShape));
}

// Between sensors and repeated hits of one pair there is no order to decide.
template <class T>
bool AreInOrder(const CExactEvent<T>& a, const CExactEvent<T>& b) {
  const bool samePair = a.m_nBall == b.m_nBall && a.m_nShape == b.m_nShape && a.m_bIsBall == b.m_bIsBall;
  return samePair || a.m_bIsSensor || b.m_bIsSensor || !SharesBall(a, b);
}

template <class T>
void CReference<T>::Answer(std::size_t i, const CNext& next, std::vector<CExactEvent<T>>& events,
                           std::size_t first) {
  const bool isBall = next.m_bIsBall;
  const std::size_t a = isBall ? std::min(i, next.m_nOther) : i;
  const std::size_t b = isBall ? std::max(i, next.m_nOther) : next.m_nOther;
  CPair& pair = GetPair(a, b, isBall);
  const CHit<T>& hit = next.m_cHit;
  Advance(a, hit.m_fTime);
  if (isBall) Advance(b, hit.m_fTime);
  m_stdChanged = {a};
  if (isBall) m_stdChanged.push_back(b);

  CExactEvent<T> event{};
  event.m_fTime = hit.m_fTime;
  event.m_nBall = a;
  event.m_nShape = b;
  event.m_bIsBall = isBall;
  event.m_bIsSensor =
      m_stdBalls[a].m_bIsSensor || (isBall ? m_stdBalls[b].m_bIsSensor : m_stdShapes[b].m_bIsSensor);
  event.m_bGraze = hit.m_bGraze;
  event.m_bSimultaneous = next.m_bTies;
  event.m_bOverlapped = hit.m_fDepth > T(2 * g_fRest) * m_stdBalls[a].GetExtent();
  event.m_ePart = hit.m_ePart;
  event.m_vCenter = hit.m_vCenter;
  event.m_vPOI = hit.m_vPOI;
  event.m_vNorm = hit.m_vNorm;
  event.m_vVelBefore = event.m_vVelAfter = m_stdBalls[a].m_vVel;
  event.m_vSurface = hit.m_vSurface;
  event.m_fDepth = event.m_bOverlapped ? hit.m_fDepth : T(0);

  ++pair.m_nHits;
  pair.m_vNorm = hit.m_vNorm;
  pair.m_vSurface = hit.m_vSurface;
  m_fSpeeds = Norm(m_stdBalls[a].m_vVel) + Norm(hit.m_vSurface);
  if (event.m_bIsSensor)
    pair.m_bSensed = true;
  else if (isBall)
    AnswerBall(hit, pair, event);
  else
    AnswerShape(hit, pair, event);

  const bool permanent = pair.m_bSlides && !event.m_bIsSensor;
  if (!permanent) {
    for (std::size_t k = events.size(); k > first; --k) {
      CExactEvent<T>& earlier = events[k - 1];
      if (event.m_fTime - earlier.m_fTime > T(g_fSimultaneous) * m_fStep) break;
      if (!AreInOrder(earlier, event)) earlier.m_bSimultaneous = event.m_bSimultaneous = true;
    }
    events.push_back(event);
  }
  if (permanent) Settle();
  CheckHolds();
  Support();
}

// Whether the ball only begins to approach: the contact is permanent. One that is deep in something is not
// passed over in silence, but hit first.
template <class T>
bool CReference<T>::Begins(const CHit<T>& hit, const CPair& pair) const {
  const bool deep = hit.m_fDepth > T(g_fRounded) * m_stdBalls[pair.m_nBall].GetExtent();
  return hit.m_bBegins && !(deep && pair.m_nHits == 1);
}

template <class T>
void CReference<T>::AnswerShape(const CHit<T>& hit, CPair& pair, CExactEvent<T>& event) {
  CExactBall<T>& ball = m_stdBalls[pair.m_nBall];
  const CSolid& solid = m_stdShapes[pair.m_nOther];
  const CVec<T>& n = hit.m_vNorm;
  const T vn = (ball.m_vVel - hit.m_vSurface).dot(n), e = ball.m_fElasticity * solid.m_fElasticity;
  // The way by which a ball is put past the border between two curves turns its normal by this.
  const T reach = ball.m_fRadius + (hit.m_ePart == ePart::Outside ? solid.m_cGeometry.m_fRadius : T(0));
  const T extent =
      GetExtent(solid.m_cGeometry, CSweptBall<T>{ball.m_vPos, ball.m_vVel, ball.m_fRadius}, CTurning<T>());
  const T small = T(4 * g_nTouchRoundings) * std::numeric_limits<T>::epsilon();
  const T turned = reach > T(0) ? T(small * extent / reach) : T(0);
  const bool isFace = hit.m_ePart == ePart::Front || hit.m_ePart == ePart::Back;
  const T gentle = hit.m_ePart == ePart::Inside || solid.Moves() ? T(g_fPressed) : isFace ? T(0) : turned;
  const bool slides = Slides(pair, e, T(-vn), Begins(hit, pair) || -vn < gentle * m_fSpeeds);
  pair.m_fOut = slides ? T(0) : std::max(T(0), T(-e * vn));

  const bool lifts = slides && hit.m_fDepth <= T(g_fRounded) * ball.GetExtent();
  const T clear = Clear(extent, T(Norm(ball.m_vVel) * m_fStep));
  const CVec<T> fromShape = hit.m_vCenter - hit.m_vPOI,
                fromMiddle = hit.m_vCenter - solid.GetGeometry(T(0)).m_vCenter;
  ball.m_vPos = hit.m_vCenter;
  if (std::min(Norm(fromShape), Norm(fromMiddle)) < clear) ball.m_vPos += clear * n;
  if (!event.m_bOverlapped || lifts) {
    const T apart = ball.m_fRadius + Nudge<T>() * ball.GetExtent();
    ball.m_vPos = hit.m_vPOI + std::max(apart, clear) * n;
  }
  if (slides)
    BeginHold(pair, hit.m_ePart);
  else
    Kick(pair);
  if (pair.m_fOut == T(0) && Norm(CVec<T>(ball.m_vVel - hit.m_vSurface)) < Residue<T>() * m_fSpeeds)
    ball.m_vVel = hit.m_vSurface;
  event.m_vVelAfter = ball.m_vVel;
}

template <class T>
void CReference<T>::AnswerBall(const CHit<T>& hit, CPair& pair, CExactEvent<T>& event) {
  CExactBall<T>&a = m_stdBalls[pair.m_nBall], &b = m_stdBalls[pair.m_nOther];
  const CVec<T>& n = hit.m_vNorm;
  const T vn = (a.m_vVel - b.m_vVel).dot(n), e = a.m_fElasticity * b.m_fElasticity;
  const bool slides = Slides(pair, e, T(-vn), Begins(hit, pair));
  pair.m_fOut = slides ? T(0) : std::max(T(0), T(-e * vn));

  const bool lifts = slides && hit.m_fDepth <= T(g_fRounded) * a.GetExtent();
  const T extent = a.GetExtent() + b.GetExtent();
  const T clear = Clear(extent, T(Norm(CVec<T>(a.m_vVel - b.m_vVel)) * m_fStep));
  CVec<T> shift = CVec<T>::Zero();
  if (Norm(CVec<T>(a.m_vPos - b.m_vPos)) < clear) shift = clear * n;
  if (!event.m_bOverlapped || lifts) {
    const T apart = a.m_fRadius + b.m_fRadius + Nudge<T>() * (a.GetExtent() + b.GetExtent());
    shift = (T(0.5) * (std::max(apart, clear) - (a.m_vPos - b.m_vPos).dot(n))) * n;
  }
  a.m_vPos += shift;
  b.m_vPos -= shift;
  if (slides)
    BeginHold(pair, ePart::Ball);
  else
    Kick(pair);
  for (CExactBall<T>* pBall : {&a, &b})
    if (pair.m_fOut == T(0) && Norm(pBall->m_vVel) < Residue<T>() * m_fSpeeds) pBall->m_vVel.setZero();
  event.m_vVelAfter = a.m_vVel;
}

// Gives the pair the normal speed m_fOut, if it has less. Returns what was missing.
template <class T>
T CReference<T>::Kick(CPair& pair) {
  CExactBall<T>& a = m_stdBalls[pair.m_nBall];
  const CVec<T>& n = pair.m_vNorm;
  T first = T(0);
  // Twice: what rounding has left over of a normal velocity would be another approach.
  for (int pass = 0; pass < 2; ++pass) {
    const CVec<T> other = pair.m_bIsBall ? m_stdBalls[pair.m_nOther].m_vVel : pair.m_vSurface;
    const T kick = pair.m_fOut - (a.m_vVel - other).dot(n);
    if (pass == 0) first = kick;
    if (!(first > T(0))) return T(0);
    if (pair.m_bIsBall) {
      CExactBall<T>& b = m_stdBalls[pair.m_nOther];
      const T mass = a.m_fMass + b.m_fMass;
      a.m_vVel += (kick * (b.m_fMass / mass)) * n;
      b.m_vVel -= (kick * (a.m_fMass / mass)) * n;
    } else {
      a.m_vVel += kick * n;
    }
  }
  return first;
}

// Whether the contact becomes permanent with this hit.
template <class T>
bool CReference<T>::Slides(CPair& pair, const T& e, const T& approach, bool pressed) {
  // Each hit takes the time of the last one times e: the series is at its end.
  const bool atOnce = m_fNow - pair.m_fLast <= T(g_fClose) * m_fStep;
  pair.m_nClose = atOnce ? pair.m_nClose + 1 : 0;
  pair.m_fLast = m_fNow;
  // A ball that comes back to what has not held it any more is hit again.
  if (!pressed && !atOnce && approach > Slow(pair)) pair.m_bSlides = false;
  if (pressed || (e < T(1) && pair.m_nClose >= g_nMaxClose)) pair.m_bSlides = true;
  return pair.m_bSlides;
}

template <class T>
void CReference<T>::BeginHold(CPair& pair, ePart part) {
  pair.m_bHolds = true;
  pair.m_ePart = part;
  SetReach(pair);
  const bool isFace = part == ePart::Front || part == ePart::Back;
  ++(part == ePart::Ball || (isFace && !m_stdShapes[pair.m_nOther].Moves()) ? m_nRests : m_nSlides);
}

} // namespace Shapes::Compare
