// SPDX-License-Identifier: MIT
// Balls of the reference that are pressed against something: they slide.
#include "Reference.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Compare {

// Whether the hit is what is left over of a sliding contact. Contacts that act on each other settle as a
// geometric series of ever smaller hits; this is its end.
bool CReference::IsNegligible(std::size_t i, std::size_t other, bool isBall, const CHit<double>& hit) {
  const CPair* pPair = FindPair(i, other, isBall);
  if (pPair == nullptr || !pPair->m_bSlides) return false;
  if (!isBall && (hit.m_ePart == ePart::Inside || m_stdShapes[other].Turns())) return false;
  const double approach = (hit.m_vSurface - m_stdBalls[i].m_vVel).dot(hit.m_vNorm);
  return approach * (m_fStep - hit.m_fTime) < g_fRest * m_stdBalls[i].GetExtent();
}

// Gives the pair the normal speed m_fOut, if it has less. Returns what was missing.
double CReference::Kick(CPair& pair) {
  CExactBall& a = m_stdBalls[pair.m_nBall];
  const CVec2d& n = pair.m_vNorm;
  double first = 0.0;
  // Twice: what rounding has left over of a normal velocity would be another approach.
  for (int pass = 0; pass < 2; ++pass) {
    const CVec2d other = pair.m_bIsBall ? m_stdBalls[pair.m_nOther].m_vVel : pair.m_vSurface;
    const double kick = pair.m_fOut - (a.m_vVel - other).dot(n);
    if (pass == 0) first = kick;
    if (!(first > 0.0)) return 0.0;
    if (pair.m_bIsBall) {
      CExactBall& b = m_stdBalls[pair.m_nOther];
      const double mass = a.m_fMass + b.m_fMass;
      a.m_vVel += (kick * (b.m_fMass / mass)) * n;
      b.m_vVel -= (kick * (a.m_fMass / mass)) * n;
    } else {
      a.m_vVel += kick * n;
    }
  }
  return first;
}

// Contacts that slide at this moment act on each other: what one takes from a ball another gives back. All
// are settled at once, one after the other until nothing changes any more (projected Gauss-Seidel, as engines
// do). What contradicts itself, a ball between a blade and a wall, is given up and ends in a jam.
void CReference::Settle() {
  m_stdSettling.clear();
  for (std::size_t k = 0; k < m_stdPairs.size(); ++k)
    if (m_stdPairs[k].m_bSlides && m_fNow - m_stdPairs[k].m_fLast <= g_fClose * m_fStep)
      m_stdSettling.push_back(k);
  double scale = 0.0;
  for (const std::size_t k : m_stdSettling) {
    CPair& pair = m_stdPairs[k];
    for (const std::size_t i : {pair.m_nBall, pair.m_bIsBall ? pair.m_nOther : pair.m_nBall}) {
      m_stdBalls[i].m_vPos = GetSwept(i, m_fNow).m_vPos;
      m_stdTime[i] = m_fNow;
      m_stdChanged.push_back(i);
      scale = std::max(scale, Norm(m_stdBalls[i].m_vVel));
    }
  }
  for (int round = 0; round < 2000; ++round) {
    double most = 0.0;
    for (const std::size_t k : m_stdSettling)
      most = std::max(most, Kick(m_stdPairs[k]));
    if (most <= 16.0 * std::numeric_limits<double>::epsilon() * scale) break;
  }
}

bool CReference::Slides(CPair& pair, double e, bool pressed) {
  // Each hit takes the time of the last one times e: the series is at its end.
  pair.m_nClose = m_fNow - pair.m_fLast <= g_fClose * m_fStep ? pair.m_nClose + 1 : 0;
  pair.m_fLast = m_fNow;
  if (!pair.m_bSlides &&
      (pressed || (e < 1.0 && (pair.m_nHits > g_nMaxHits || pair.m_nClose >= g_nMaxClose)))) {
    pair.m_bSlides = true;
    ++m_nSlides;
  }
  return pair.m_bSlides;
}

// The speed off the surface with which a hop lasts 1 / g_nSlideHops of the step, against the acceleration
// with which the surface comes after the ball; 0 where it does not.
double CReference::HopSpeed(const CExactBall& ball, const CSolid& solid, const CHit<double>& hit) const {
  const double w = solid.GetSpeed();
  const CVec2d q = hit.m_vCenter - solid.m_vRotCenter, rel = ball.m_vVel - w * Perp(q);
  double accel = 2.0 * std::abs(w) * Norm(ball.m_vVel) + w * w * Norm(q);
  if (hit.m_ePart == ePart::Inside) {
    const double along = Cross(hit.m_vNorm, rel);
    accel += along * along / (solid.m_cFigure.m_fRadius - ball.m_fRadius);
  }
  return std::min(0.5 * accel * m_fStep / g_nSlideHops, Norm(ball.m_vVel) + Norm(hit.m_vSurface));
}

} // namespace Shapes::Compare
