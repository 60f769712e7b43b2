// SPDX-License-Identifier: MIT
// Contacts of the reference that last: their impulses, and the forces that hold the balls. Included by
// Reference.cpp, and for 50 digits by the tests.
#pragma once

#include "Reference.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Shapes::Compare {

// A relative velocity of the pair that is rounding.
template <class T>
T CReference<T>::Slow(const CPair& pair) const {
  T speeds = m_fSpeeds + Norm(m_stdBalls[pair.m_nBall].m_vVel) + Norm(m_vGravity) * m_fStep;
  if (pair.m_bIsBall) speeds += Norm(m_stdBalls[pair.m_nOther].m_vVel);
  return T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon() * speeds;
}

template <class T>
typename CReference<T>::CHeld CReference<T>::MakeHeld(CPair& pair) {
  CHeld held;
  held.m_pPair = &pair;
  const CExactBall<T>& ball = m_stdBalls[pair.m_nBall];
  if (pair.m_bIsBall) {
    held.m_vBase = m_stdBalls[pair.m_nOther].m_vPos;
  } else {
    const CSolid& solid = m_stdShapes[pair.m_nOther];
    const CShapeGeometry<T> f = solid.GetGeometry(m_fNow);
    held.m_cTurning = solid.GetTurning(m_fNow);
    held.m_bLine = pair.m_ePart == ePart::Front || pair.m_ePart == ePart::Back;
    if (held.m_bLine) {
      held.m_vBase = solid.Turns() ? held.m_cTurning.m_vCenter : f.m_vPt0;
      held.m_vNorm = Perp(CVec<T>(f.m_vPt1 - f.m_vPt0)) / Norm(CVec<T>(f.m_vPt1 - f.m_vPt0));
      if (pair.m_ePart == ePart::Back) held.m_vNorm = -held.m_vNorm;
    } else {
      held.m_fSide = pair.m_ePart == ePart::Inside ? T(-1) : T(1);
      held.m_vBase = pair.m_ePart == ePart::End0   ? f.m_vPt0
                     : pair.m_ePart == ePart::End1 ? f.m_vPt1
                                                   : f.m_vCenter;
    }
  }
  if (!held.m_bLine) held.m_vNorm = Unit(CVec<T>(held.m_fSide * (ball.m_vPos - held.m_vBase)), pair.m_vNorm);
  const CTurning<T>& turning = held.m_cTurning;
  held.m_vSurface = turning.m_vVel + turning.m_fSpeed * Perp(CVec<T>(ball.m_vPos - turning.m_vCenter));
  return held;
}

template <class T>
void CReference<T>::SetReach(CPair& pair) {
  const CHeld held = MakeHeld(pair);
  const CVec<T> x = m_stdBalls[pair.m_nBall].m_vPos - held.m_vBase;
  pair.m_fReach = held.m_bLine ? x.dot(held.m_vNorm) : Norm(x);
}

// The lasting contacts of the balls in m_stdChanged, to which all that hang together with them are added, as
// they are now.
template <class T>
void CReference<T>::GatherHeld() {
  const auto changed = [&](std::size_t i) {
    return std::find(m_stdChanged.begin(), m_stdChanged.end(), i) != m_stdChanged.end();
  };
  for (bool grows = true; grows;) {
    grows = false;
    for (const CPair& pair : m_stdPairs) {
      if (!pair.m_bHolds || !pair.m_bIsBall || changed(pair.m_nBall) == changed(pair.m_nOther)) continue;
      m_stdChanged.push_back(changed(pair.m_nBall) ? pair.m_nOther : pair.m_nBall);
      grows = true;
    }
  }
  for (const std::size_t i : m_stdChanged)
    Advance(i, m_fNow);
  m_stdHeld.clear();
  for (CPair& pair : m_stdPairs)
    if (pair.m_bHolds && changed(pair.m_nBall)) m_stdHeld.push_back(MakeHeld(pair));
}

// The velocity off the surface.
template <class T>
T CReference<T>::SpeedOff(const CHeld& held) const {
  const CPair& pair = *held.m_pPair;
  const CVec<T> other = pair.m_bIsBall ? m_stdBalls[pair.m_nOther].m_vVel : held.m_vSurface;
  return (m_stdBalls[pair.m_nBall].m_vVel - other).dot(held.m_vNorm);
}

template <class T>
void CReference<T>::Push(const CHeld& held, const T& impulse) {
  const CPair& pair = *held.m_pPair;
  CExactBall<T>& ball = m_stdBalls[pair.m_nBall];
  ball.m_vVel += (impulse / ball.m_fMass) * held.m_vNorm;
  if (!pair.m_bIsBall) return;
  CExactBall<T>& other = m_stdBalls[pair.m_nOther];
  other.m_vVel -= (impulse / other.m_fMass) * held.m_vNorm;
}

// How much a force of one contact accelerates the balls of another one along its normal.
template <class T>
CMatrix<T> CReference<T>::GetMasses() const {
  const auto side = [&](const CPair& pair, std::size_t ball) {
    return pair.m_nBall == ball ? T(1) : pair.m_bIsBall && pair.m_nOther == ball ? T(-1) : T(0);
  };
  const auto n = static_cast<Eigen::Index>(m_stdHeld.size());
  CMatrix<T> masses = CMatrix<T>::Zero(n, n);
  for (Eigen::Index c = 0; c < n; ++c)
    for (Eigen::Index d = 0; d < n; ++d) {
      const CHeld &h0 = m_stdHeld[static_cast<std::size_t>(c)], &h1 = m_stdHeld[static_cast<std::size_t>(d)];
      const CPair &p0 = *h0.m_pPair, &p1 = *h1.m_pPair;
      T share = side(p1, p0.m_nBall) / m_stdBalls[p0.m_nBall].m_fMass;
      if (p0.m_bIsBall) share -= side(p1, p0.m_nOther) / m_stdBalls[p0.m_nOther].m_fMass;
      masses(c, d) = share * h0.m_vNorm.dot(h1.m_vNorm);
    }
  return masses;
}

// A contact has become permanent: its impulse on a ball may need impulses of others. All lasting
// contacts of these balls get the impulses after which none approaches any more.
template <class T>
void CReference<T>::Settle() {
  GatherHeld();
  const auto n = static_cast<Eigen::Index>(m_stdHeld.size());
  CColumn<T> speeds(n), none(n), impulses;
  for (Eigen::Index k = 0; k < n; ++k) {
    const CHeld& held = m_stdHeld[static_cast<std::size_t>(k)];
    speeds[k] = SpeedOff(held);
    none[k] = Slow(*held.m_pPair) / T(g_nTouchRoundings);
  }
  if (!Complement(GetMasses(), speeds, none, impulses)) Crushed(m_stdHeld[0].m_pPair->m_nBall);
  for (Eigen::Index k = 0; k < n; ++k)
    Push(m_stdHeld[static_cast<std::size_t>(k)], impulses[k]);
}

// Balls have got new velocities: contacts that these end, by leading off or into what carries the ball. One
// that leads into it is a hit, and will be found as one.
template <class T>
void CReference<T>::CheckHolds() {
  using std::abs;
  GatherHeld();
  const T eps = T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon();
  for (const CHeld& held : m_stdHeld)
    if (abs(SpeedOff(held)) > Slow(*held.m_pPair) + eps * Norm(held.m_vSurface))
      held.m_pPair->m_bHolds = held.m_pPair->m_bSlides = false;
}

template <class T>
void CReference<T>::Shift(const CPair& pair, const CVec<T>& way) {
  m_stdBalls[pair.m_nBall].m_vPos += pair.m_bIsBall ? CVec<T>(T(0.5) * way) : way;
  if (pair.m_bIsBall) m_stdBalls[pair.m_nOther].m_vPos -= T(0.5) * way;
}

// Takes away what roundings have left of the distances and velocities that the contacts in m_stdHeld forbid.
template <class T>
void CReference<T>::Straighten() {
  using std::abs;
  const T eps = std::numeric_limits<T>::epsilon();
  bool again = true;
  for (int pass = 0; again && pass < 64; ++pass) {
    again = false;
    for (CHeld& held : m_stdHeld) {
      CPair& pair = *held.m_pPair;
      const CExactBall<T>& ball = m_stdBalls[pair.m_nBall];
      held = MakeHeld(pair);
      const CVec<T> x = ball.m_vPos - held.m_vBase;
      const T reach = held.m_bLine ? x.dot(held.m_vNorm) : Norm(x);
      const T off = held.m_fSide * (pair.m_fReach - reach);
      Shift(pair, CVec<T>(off * held.m_vNorm));
      const T own = T(1) / ball.m_fMass, speed = SpeedOff(held);
      Push(held, T(-speed / (pair.m_bIsBall ? T(own + T(1) / m_stdBalls[pair.m_nOther].m_fMass) : own)));
      again = again || abs(off) > T(16) * eps * ball.GetExtent() ||
              abs(speed) > T(16) * eps * (Norm(ball.m_vVel) + Norm(held.m_vSurface));
    }
  }
}

// Contacts that held at the end of the last step go on if since then the ball has been rounded to floats, but
// not moved or thrown; the ball is put back onto the surface.
template <class T>
void CReference<T>::Continue() {
  using std::abs;
  m_stdChanged.clear();
  std::erase_if(m_stdPairs, [&](CPair& pair) {
    const CExactBall<T>& ball = m_stdBalls[pair.m_nBall];
    const bool isSolid = ball.m_bCanCollide && (pair.m_bIsBall ? m_stdBalls[pair.m_nOther].m_bCanCollide
                                                               : m_stdShapes[pair.m_nOther].m_bCanCollide);
    if (!pair.m_bHolds || !isSolid) return true;
    const CHeld held = MakeHeld(pair);
    T touch = pair.m_bIsBall ? m_stdBalls[pair.m_nOther].m_fRadius : T(0);
    CVec<T> from = held.m_vBase;
    if (!pair.m_bIsBall) {
      const CShapeGeometry<T> f = m_stdShapes[pair.m_nOther].GetGeometry(m_fNow);
      if (held.m_bLine) from = f.m_vPt0;
      if (pair.m_ePart == ePart::Outside || pair.m_ePart == ePart::Inside) touch = f.m_fRadius;
      for (const CBorder& border : GetBorders(pair, f)) {
        const CVec<T> x = ball.m_vPos - border.m_vAt;
        if (border.m_vToward.dot(x) >= T(0) && border.m_vOut.dot(x) > T(0)) return true;
      }
    }
    const CVec<T> x = ball.m_vPos - from;
    const T gap = (held.m_bLine ? x.dot(held.m_vNorm) : T(held.m_fSide * (Norm(x) - touch))) - ball.m_fRadius;
    const CVec<T> other = pair.m_bIsBall ? m_stdBalls[pair.m_nOther].m_vVel : held.m_vSurface;
    if (abs(gap) > T(g_fRounded) * (ball.GetExtent() + touch) ||
        abs(SpeedOff(held)) > Slow(pair) + T(g_fRounded) * (Norm(ball.m_vVel) + Norm(other)))
      return true;
    const ePart part = pair.m_ePart;
    pair = CPair(pair.m_nBall, pair.m_nOther, pair.m_bIsBall);
    pair.m_vNorm = held.m_vNorm;
    pair.m_bSlides = true;
    BeginHold(pair, part);
    pair.m_fReach -= held.m_fSide * (gap - Nudge<T>() * ball.GetExtent());
    m_stdChanged.push_back(pair.m_nBall);
    return false;
  });
  Support();
}

// Gives the balls in m_stdChanged the ways that what holds them leaves them. Contacts without force end.
template <class T>
void CReference<T>::Support() {
  GatherHeld();
  for (const std::size_t i : m_stdChanged) {
    m_stdAcc[i] = m_vGravity;
    m_stdMore[i].clear();
    m_stdUntil[i] = m_fStep;
  }
  if (m_stdHeld.empty()) return;

  Straighten();
  const auto n = static_cast<Eigen::Index>(m_stdHeld.size());
  CColumn<T> free(n), none(n), forces; // the accelerations off the surfaces that gravity alone would give
  for (Eigen::Index k = 0; k < n; ++k) {
    const CHeld& held = m_stdHeld[static_cast<std::size_t>(k)];
    const CPair& pair = *held.m_pPair;
    const CExactBall<T>& ball = m_stdBalls[pair.m_nBall];
    const CVec<T> x = ball.m_vPos - held.m_vBase;
    const T w = held.m_cTurning.m_fSpeed;
    T bend, turn;
    if (held.m_bLine) {
      bend = T(2) * w * Perp(held.m_vNorm).dot(CVec<T>(ball.m_vVel - held.m_cTurning.m_vVel));
      turn = -w * w * held.m_vNorm.dot(x);
    } else {
      const CVec<T> arm = held.m_vBase - held.m_cTurning.m_vCenter;
      const CVec<T> base =
          pair.m_bIsBall ? m_stdBalls[pair.m_nOther].m_vVel : CVec<T>(held.m_cTurning.m_vVel + w * Perp(arm));
      const T along = Cross(held.m_vNorm, CVec<T>(ball.m_vVel - base));
      bend = held.m_fSide * along * along / pair.m_fReach;
      turn = w * w * held.m_vNorm.dot(arm);
    }
    const T fall = pair.m_bIsBall ? T(0) : m_vGravity.dot(held.m_vNorm);
    using std::abs;
    free[k] = fall + bend + turn;
    none[k] = T(g_nTouchRoundings / 2) * std::numeric_limits<T>::epsilon() *
              (Norm(m_vGravity) + abs(bend) + abs(turn));
  }
  const CMatrix<T> masses = GetMasses();
  if (!Complement(masses, free, none, forces)) Crushed(m_stdHeld[0].m_pPair->m_nBall);
  for (Eigen::Index k = n; k-- > 0;) {
    if (forces[k] * masses(k, k) > none[k]) continue;
    m_stdHeld[static_cast<std::size_t>(k)].m_pPair->m_bHolds = false;
    m_stdHeld.erase(m_stdHeld.begin() + k);
  }
  if (!m_stdHeld.empty()) Slide();
}

template <class T>
void CReference<T>::Crushed(std::size_t i) const {
  const CVec<T>& p = m_stdBalls[i].m_vPos;
  std::ostringstream out;
  out << "ball " << i << " at (" << p.x() << ", " << p.y() << ") is crushed between what it touches, "
      << m_fNow << " s into a step of " << m_fStep << " s";
  throw std::runtime_error(out.str());
}

} // namespace Shapes::Compare
