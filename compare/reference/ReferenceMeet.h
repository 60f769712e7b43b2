// SPDX-License-Identifier: MIT
// Finds the next impact of each ball of the reference. Included by Reference.cpp, and for 50 digits by the
// tests.
#pragma once

#include "Reference.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Compare {

template <class T>
void CReference<T>::FindNext(std::size_t i) {
  CNext& next = m_stdNext[i];
  next.m_bFound = false;
  if (!m_stdBalls[i].m_bCanCollide) return;
  MeetLimits(i, next);
  MeetShapes(i, next);
  for (std::size_t j = 0; j < m_stdBalls.size(); ++j)
    MeetBall(i, j, next);
}

template <class T>
void CReference<T>::MeetShapes(std::size_t i, CNext& next) {
  const T now = m_stdTime[i], left = m_stdUntil[i] - now;
  const CSweptBall<T> ball = GetSwept(i, now);
  const CVec<T> end = ball.GetPos(left);
  CVec<T> low = ball.m_vPos.cwiseMin(end), high = ball.m_vPos.cwiseMax(end);
  for (int k = 0; k < 2; ++k) { // where the parabola turns back
    const T v = ball.m_vVel[k], a = ball.m_vAcc[k];
    if (!ball.m_stdMore.empty() || (v < T(0)) == (a < T(0)) || a == T(0) || !(-v / a < left)) continue;
    const T apex = ball.m_vPos[k] - v * v / (T(2) * a);
    low[k] = std::min(low[k], apex);
    high[k] = std::max(high[k], apex);
  }
  if (!ball.m_stdMore.empty()) { // no farther than this from its chord
    const T sag = (Norm(ball.m_vAcc) + BeyondBound(ball.m_stdMore, left)) * left * left / T(8);
    low -= CVec<T>(sag, sag);
    high += CVec<T>(sag, sag);
  }
  // Wider than what touches or nearly does, so that the boxes lose no hit and no near miss.
  const T size = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) + ball.m_fRadius;
  const T pad = ball.m_fRadius * T(1.0 + 4.0 * g_fGraze) +
                T(4 * g_nTouchRoundings) * std::numeric_limits<T>::epsilon() * size;
  low -= CVec<T>(pad, pad);
  high += CVec<T>(pad, pad);
  for (std::size_t k = 0; k < m_stdShapes.size(); ++k) {
    const CSolid& solid = m_stdShapes[k];
    // As seen from the shape, which may have moved.
    const CVec<T> from = solid.m_vMoved + now * solid.m_vVel,
                  to = solid.m_vMoved + m_stdUntil[i] * solid.m_vVel;
    const CVec<T> lower = low - from.cwiseMax(to), upper = high - from.cwiseMin(to);
    if (lower.x() > solid.m_vHigh.x() || upper.x() < solid.m_vLow.x() || lower.y() > solid.m_vHigh.y() ||
        upper.y() < solid.m_vLow.y() || !solid.m_bCanCollide ||
        !DoMeet(solid.m_cFilter, m_stdBalls[i].m_cFilter))
      continue;
    const bool sensor = solid.m_bIsSensor || m_stdBalls[i].m_bIsSensor;
    if (const CPair* pPair = FindPair(i, k, false);
        pPair && (pPair->m_bHolds || (sensor && pPair->m_bSensed)))
      continue;
    CHit<T> hit;
    const eMeet meet = sensor && now == T(0) ? eMeet::Touching : eMeet::Approaching;
    const bool found = solid.m_bKinematic
                           ? Sweep(solid.GetGeometry(now), solid.GetTurning(now), ball, left, hit, meet)
                           : Sweep(solid.m_cGeometry, ball, left, hit, meet);
    hit.m_fTime += now;
    Offer(next, found && !IsNegligible(i, k, false, hit), false, i, k, hit);
  }
}

template <class T>
void CReference<T>::MeetBall(std::size_t i, std::size_t j, CNext& next) {
  if (i == j || !m_stdBalls[j].m_bCanCollide || !DoMeet(m_stdBalls[i].m_cFilter, m_stdBalls[j].m_cFilter))
    return;
  const std::size_t a = std::min(i, j), b = std::max(i, j);
  const CSweptBall<T> lower = GetSwept(a, m_fNow), upper = GetSwept(b, m_fNow);
  // Too far to come near each other in the time that is left.
  const T left = std::min(m_stdUntil[a], m_stdUntil[b]) - m_fNow;
  if (left < T(0)) return;
  const T bend = Norm(CVec<T>(upper.m_vAcc - lower.m_vAcc)) + BeyondBound(lower.m_stdMore, left) +
                 BeyondBound(upper.m_stdMore, left);
  const T way = (Norm(CVec<T>(upper.m_vVel - lower.m_vVel)) + bend * (left / T(2))) * left;
  const CVec<T> d = upper.m_vPos - lower.m_vPos;
  const T near = way + (lower.m_fRadius + upper.m_fRadius) * T(1.0 + 4.0 * g_fGraze) +
                 T(4 * g_nTouchRoundings) * std::numeric_limits<T>::epsilon() *
                     (m_stdBalls[a].GetExtent() + m_stdBalls[b].GetExtent() + way);
  if (d.dot(d) > near * near) return;
  const bool sensor = m_stdBalls[i].m_bIsSensor || m_stdBalls[j].m_bIsSensor;
  if (const CPair* pPair = FindPair(a, b, true); pPair && (pPair->m_bHolds || (sensor && pPair->m_bSensed)))
    return;
  CHit<T> hit;
  const eMeet meet = sensor && m_fNow == T(0) ? eMeet::Touching : eMeet::Approaching;
  const bool found = SweepBalls(upper, lower, left, hit, meet);
  hit.m_fTime += m_fNow;
  // The hit is that of the lower ball, whichever of the two it is kept for.
  Offer(next, found && !IsNegligible(a, b, true, hit), true, i, j, hit);
}

// Whether the hit is what is left over of a sliding contact that nothing presses. Contacts that act on each
// other settle as a geometric series of ever smaller hits; this is its end.
template <class T>
bool CReference<T>::IsNegligible(std::size_t i, std::size_t other, bool isBall, const CHit<T>& hit) {
  const CPair* pPair = FindPair(i, other, isBall);
  if (pPair == nullptr || !pPair->m_bSlides || hit.m_bBegins) return false;
  if (!isBall && (hit.m_ePart == ePart::Inside || m_stdShapes[other].Moves())) return false;
  const CVec<T> acc = isBall ? CVec<T>(m_stdAcc[i] - m_stdAcc[other]) : m_stdAcc[i];
  const T eps = T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon();
  if (acc.dot(hit.m_vNorm) < -eps * Norm(m_vGravity)) return false;
  const T approach = (hit.m_vSurface - GetSwept(i, hit.m_fTime).m_vVel).dot(hit.m_vNorm);
  return approach * (m_fStep - hit.m_fTime) < T(g_fRest) * m_stdBalls[i].GetExtent();
}

// Whether two hits of ball i at the same time would send it to different sides, so that their order decides.
template <class T>
bool CReference<T>::AreApart(std::size_t i, bool isBall0, std::size_t other0, const CHit<T>& hit0,
                             bool isBall1, std::size_t other1, const CHit<T>& hit1) const {
  const auto isSensor = [&](bool isBall, std::size_t k) {
    return m_stdBalls[i].m_bIsSensor || (isBall ? m_stdBalls[k].m_bIsSensor : m_stdShapes[k].m_bIsSensor);
  };
  if (isSensor(isBall0, other0) || isSensor(isBall1, other1)) return false;
  // Of two balls the normal is that of the lower one.
  const T side0 = isBall0 && i > other0 ? T(-1) : T(1), side1 = isBall1 && i > other1 ? T(-1) : T(1);
  return Norm(CVec<T>(side0 * hit0.m_vNorm - side1 * hit1.m_vNorm)) > T(g_fGraze);
}

template <class T>
void CReference<T>::Offer(CNext& next, bool found, bool isBall, std::size_t i, std::size_t other,
                          const CHit<T>& hit) {
  if (found) {
    const CHit<T>& old = next.m_cHit;
    const auto isFace = [](const CHit<T>& h) {
      return h.m_ePart == ePart::Front || h.m_ePart == ePart::Back;
    };
    using std::abs;
    bool earlier = hit.m_fTime < old.m_fTime;
    const bool together = next.m_bFound && next.m_eNext == eNext::Impact &&
                          abs(hit.m_fTime - old.m_fTime) <= T(g_fSimultaneous) * m_fStep;
    // Where a ball comes to lie on a joint it lies on the side, not on an end.
    if (together && hit.m_bBegins && old.m_bBegins && isFace(hit) != isFace(old)) earlier = isFace(hit);
    // Two hits with the same response, as at the sides of a shared end, are one.
    const bool ties =
        together && (next.m_bTies || AreApart(i, next.m_bIsBall, next.m_nOther, old, isBall, other, hit));
    if (!next.m_bFound || earlier) next = {true, isBall, other, hit};
    next.m_bTies = earlier || together ? ties : next.m_bTies;
  }
  if (found || !hit.m_bGraze) return;
  const std::size_t a = isBall ? std::min(i, other) : i, b = isBall ? std::max(i, other) : other;
  const bool known = std::any_of(m_stdNear.begin(), m_stdNear.end(), [&](const CNear& n) {
    return n.m_nBall == a && n.m_nOther == b && n.m_bIsBall == isBall;
  });
  if (!known) m_stdNear.push_back({a, b, isBall, hit.m_fTime});
}

template <class T>
void CReference<T>::CountNearMisses(const T& now) {
  m_nNearMisses += std::erase_if(m_stdNear, [&](const CNear& n) { return n.m_fTime <= now; });
}

// Some balls have got new velocities: what was found with their old ones is void.
template <class T>
void CReference<T>::FindAfter() {
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

} // namespace Shapes::Compare
