// SPDX-License-Identifier: MIT
// Contacts of the reference that last: when they begin, and the hops of those that do not simply rest.
// Included by Reference.cpp, and for 50 digits by the tests.
#pragma once

#include "Reference.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Compare {

template <class T>
bool CReference<T>::Slides(CPair& pair, const T& e, const T& approach, bool pressed) {
  // Each hit takes the time of the last one times e: the series is at its end.
  const bool atOnce = m_fNow - pair.m_fLast <= T(g_fClose) * m_fStep;
  pair.m_nClose = atOnce ? pair.m_nClose + 1 : 0;
  pair.m_fLast = m_fNow;
  // A sliding ball that comes back faster than it left has been thrown: that is a hit.
  if (!pressed && !atOnce && approach > T(2) * pair.m_fOut + Slow(pair)) pair.m_bSlides = false;
  if (pressed || (e < T(1) && pair.m_nClose >= g_nMaxClose)) pair.m_bSlides = true;
  return pair.m_bSlides;
}

template <class T>
void CReference<T>::BeginSlide(CPair& pair) {
  m_stdApproximate[pair.m_nBall] = true;
  if (pair.m_bIsBall) m_stdApproximate[pair.m_nOther] = true;
  if (!pair.m_bCounted) ++m_nSlides;
  pair.m_bCounted = true;
}

// The speed off the surface with which a hop lasts 1 / g_nSlideHops of the step at most and is not higher
// than g_fHop of the size, against the acceleration with which the surface comes after the ball; 0 where it
// does not.
template <class T>
T CReference<T>::HopSpeed(const T& press, const T& size, const T& speeds) const {
  using std::sqrt;
  if (!(press > T(0))) return T(0);
  T time = m_fStep / T(g_nSlideHops);
  if (size > T(0)) time = std::min(time, T(sqrt(T(8.0 * g_fHop) * size / press)));
  return std::min(T(press * time / T(2)), T(speeds + Norm(m_vGravity) * time));
}

// The acceleration with which ball and surface come together, at most.
template <class T>
T CReference<T>::Press(const CPair& pair, const CHit<T>& hit) const {
  using std::abs;
  const CVec<T>& n = hit.m_vNorm;
  if (pair.m_bIsBall) return -(m_stdAcc[pair.m_nBall] - m_stdAcc[pair.m_nOther]).dot(n);
  const CExactBall<T>& ball = m_stdBalls[pair.m_nBall];
  const CSolid& solid = m_stdShapes[pair.m_nOther];
  const T w = solid.GetSpeed(), R = solid.m_cGeometry.m_fRadius;
  const CVec<T> q = hit.m_vCenter - solid.GetTurning(m_fNow).m_vCenter;
  const CVec<T> rel = ball.m_vVel - solid.m_vVel - w * Perp(q);
  T press = -m_stdAcc[pair.m_nBall].dot(n);
  if (w != T(0)) press += T(2) * abs(w) * Norm(CVec<T>(ball.m_vVel - solid.m_vVel)) + w * w * Norm(q);
  const T along = Cross(n, rel);
  if (hit.m_ePart == ePart::Inside)
    press += along * along / (R - ball.m_fRadius);
  else if (w == T(0) && ball.m_fRadius > T(0)) // round it carries the ball off
    press -= along * along / (ball.m_fRadius + (hit.m_ePart == ePart::Outside ? R : T(0)));
  return press;
}

// Contacts that last at this moment act on each other: what one takes from a ball another gives back. All
// are settled at once, one after the other until nothing changes any more (projected Gauss-Seidel, as engines
// do). What contradicts itself, a ball between a blade and a wall, is given up and ends in a jam.
template <class T>
void CReference<T>::Settle() {
  m_stdSettling.clear();
  // Those that hang together with the balls of the hit, which are in m_stdChanged.
  const auto hangsOn = [&](std::size_t i) {
    return std::find(m_stdChanged.begin(), m_stdChanged.end(), i) != m_stdChanged.end();
  };
  for (std::size_t k = 0; k < m_stdPairs.size(); ++k) {
    const CPair& pair = m_stdPairs[k];
    const bool lasts = pair.m_bRests || (pair.m_bSlides && m_fNow - pair.m_fLast <= T(g_fClose) * m_fStep);
    if (!lasts || !(hangsOn(pair.m_nBall) || (pair.m_bIsBall && hangsOn(pair.m_nOther))) ||
        std::find(m_stdSettling.begin(), m_stdSettling.end(), k) != m_stdSettling.end())
      continue;
    m_stdSettling.push_back(k);
    const std::size_t balls = m_stdChanged.size();
    for (const std::size_t i : {pair.m_nBall, pair.m_bIsBall ? pair.m_nOther : pair.m_nBall}) {
      if (hangsOn(i)) continue;
      Advance(i, m_fNow);
      m_stdChanged.push_back(i);
    }
    if (m_stdChanged.size() > balls) k = static_cast<std::size_t>(-1); // look at all again for the new one
  }
  T scale = T(0);
  for (const std::size_t i : m_stdChanged)
    scale = std::max(scale, Norm(m_stdBalls[i].m_vVel));
  for (int round = 0; round < 2000; ++round) {
    T most = T(0);
    for (const std::size_t k : m_stdSettling)
      most = std::max(most, Kick(m_stdPairs[k]));
    if (most <= T(16) * std::numeric_limits<T>::epsilon() * scale) break;
  }
}

} // namespace Shapes::Compare
