// SPDX-License-Identifier: MIT
// Balls of the reference that rest: what carries them, and what is left of gravity. Included by
// Reference.cpp, and for 50 digits by the tests.
#pragma once

#include "Reference.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Compare {

// Accelerations below this many roundings of gravity are none.
inline constexpr int g_nStill = 4096;
// Rounds of the search for the forces; a wedge needs about 37 / log10(1 / cos^2) for its angle.
inline constexpr int g_nMaxRounds = 20000;

// A relative velocity of the pair that is rounding.
template <class T>
T CReference<T>::Slow(const CPair& pair) const {
  T speeds = m_fSpeeds + Norm(m_stdBalls[pair.m_nBall].m_vVel) + Norm(m_vGravity) * m_fStep;
  if (pair.m_bIsBall) speeds += Norm(m_stdBalls[pair.m_nOther].m_vVel);
  return T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon() * speeds;
}

// The ball is put past the end by more than what counts as touching the side.
template <class T>
void CReference<T>::PassEnd(std::size_t i, const CNext& next) {
  Advance(i, m_fNow);
  CPair& pair = GetPair(i, next.m_nOther, false);
  const CShapeGeometry<T> f = m_stdShapes[next.m_nOther].GetGeometry(m_fNow);
  const T touch = T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon() *
                  GetExtent(f, GetSwept(i, m_fNow), m_stdShapes[next.m_nOther].GetTurning(m_fNow));
  const CVec<T> past = m_stdBalls[i].m_vPos - next.m_cHit.m_vPOI;
  m_stdBalls[i].m_vPos += (T(2) * touch - past.dot(next.m_cHit.m_vNorm)) * next.m_cHit.m_vNorm;
  pair.m_bRests = pair.m_bSlides = false;
  m_stdChanged = {i};
  Support();
}

// Balls have got new velocities: contacts that these end, by leading off or into what carries the ball. One
// that leads into it is a hit, and will be found as one.
template <class T>
void CReference<T>::CheckRests() {
  for (CPair& pair : m_stdPairs) {
    const auto changed = [&](std::size_t i) {
      return std::find(m_stdChanged.begin(), m_stdChanged.end(), i) != m_stdChanged.end();
    };
    if (!pair.m_bRests || !(changed(pair.m_nBall) || (pair.m_bIsBall && changed(pair.m_nOther)))) continue;
    if (pair.m_bIsBall) {
      Advance(pair.m_nBall, m_fNow);
      Advance(pair.m_nOther, m_fNow);
    }
    CVec<T>& v = m_stdBalls[pair.m_nBall].m_vVel;
    const CVec<T> other = pair.m_bIsBall ? m_stdBalls[pair.m_nOther].m_vVel : pair.m_vSurface;
    const T vn = (v - other).dot(pair.m_vNorm);
    using std::abs;
    if (abs(vn) > Slow(pair))
      pair.m_bRests = pair.m_bSlides = false;
    else if (!pair.m_bIsBall)
      v -= vn * pair.m_vNorm;
  }
}

// Gives every ball the acceleration that its supports leave it.
template <class T>
void CReference<T>::Support() {
  while (!Balance() || LeaveUnsteady())
    ;
  for (std::size_t i = 0; i < m_stdBalls.size(); ++i) {
    if (m_stdSolved[i] == m_stdAcc[i]) continue;
    Advance(i, m_fNow);
    m_stdAcc[i] = m_stdSolved[i];
    m_stdChanged.push_back(i);
  }
}

// The forces of all contacts that rest, by projected Gauss-Seidel: each takes away what is left of the
// acceleration into it, and none pulls. Contacts without force end; returns false if there are any.
template <class T>
bool CReference<T>::Balance() {
  using std::abs;
  m_stdSolved.assign(m_stdBalls.size(), m_vGravity);
  m_stdSettling.clear();
  for (std::size_t k = 0; k < m_stdPairs.size(); ++k)
    if (m_stdPairs[k].m_bRests) m_stdSettling.push_back(k);
  if (m_stdSettling.empty()) return true;

  const T none = std::numeric_limits<T>::epsilon() * Norm(m_vGravity);
  for (const std::size_t k : m_stdSettling)
    m_stdPairs[k].m_fForce = T(0);
  const auto massOf = [&](const CPair& pair) { // how much a force changes the acceleration of the pair
    const T own = T(1) / m_stdBalls[pair.m_nBall].m_fMass;
    return pair.m_bIsBall ? T(own + T(1) / m_stdBalls[pair.m_nOther].m_fMass) : own;
  };
  T most = T(0);
  for (int round = 0; round < g_nMaxRounds; ++round) {
    most = T(0);
    for (const std::size_t k : m_stdSettling) {
      CPair& pair = m_stdPairs[k];
      CVec<T>& a = m_stdSolved[pair.m_nBall];
      T an = a.dot(pair.m_vNorm);
      if (pair.m_bIsBall) an -= m_stdSolved[pair.m_nOther].dot(pair.m_vNorm);
      const T mass = massOf(pair), force = std::max(T(0), T(pair.m_fForce - an / mass));
      const T more = force - pair.m_fForce;
      pair.m_fForce = force;
      a += (more / m_stdBalls[pair.m_nBall].m_fMass) * pair.m_vNorm;
      if (pair.m_bIsBall)
        m_stdSolved[pair.m_nOther] -= (more / m_stdBalls[pair.m_nOther].m_fMass) * pair.m_vNorm;
      most = std::max(most, T(abs(more) * mass));
    }
    if (most <= T(16) * none) break;
  }

  bool all = true;
  for (const std::size_t k : m_stdSettling) {
    CPair& pair = m_stdPairs[k];
    if (most > T(16) * none) { // it may still be moving where it should not
      m_stdApproximate[pair.m_nBall] = true;
      if (pair.m_bIsBall) m_stdApproximate[pair.m_nOther] = true;
    }
    if (pair.m_fForce * massOf(pair) > T(g_nTouchRoundings) * none) continue;
    pair.m_bRests = false;
    all = false;
  }
  for (CVec<T>& a : m_stdSolved)
    if (Norm(a) <= T(g_nStill) * none) a.setZero();
  return all;
}

// A ball on a ball rests only while neither moves along the other; else it begins to slide. Returns whether
// one does.
template <class T>
bool CReference<T>::LeaveUnsteady() {
  for (CPair& pair : m_stdPairs) {
    if (!pair.m_bRests || !pair.m_bIsBall) continue;
    const std::size_t i = pair.m_nBall, j = pair.m_nOther;
    Advance(i, m_fNow);
    Advance(j, m_fNow);
    const CVec<T> v = m_stdBalls[i].m_vVel - m_stdBalls[j].m_vVel;
    const CVec<T> a = m_stdSolved[i] - m_stdSolved[j];
    const T still = T(g_nStill) * std::numeric_limits<T>::epsilon() * Norm(m_vGravity);
    if (Norm(v) <= Slow(pair) && Norm(a) <= still) continue;
    pair.m_bRests = false;
    // The pressing acceleration is that without this contact; gravity is of its order.
    pair.m_fOut = HopSpeed(Norm(m_vGravity), T(m_stdBalls[i].m_fRadius + m_stdBalls[j].m_fRadius), m_fSpeeds);
    BeginSlide(pair);
    Kick(pair);
    m_stdChanged.push_back(i);
    m_stdChanged.push_back(j);
    CheckRests();
    return true;
  }
  return false;
}

} // namespace Shapes::Compare
