// SPDX-License-Identifier: MIT
// Exact time of impact of a ball that moves on a straight line, on a parabola or along a curve, against every
// kind of shape (Sweeper.h says which parts are solid). All results are in the world. Templates on the
// scalar, so that double is checked by 50 digits.
#pragma once

#include "Sweeper.h"

#include <algorithm>
#include <type_traits>

namespace Shapes::Compare {

/// The size of the coordinates among which a ball meets a figure; g_nTouchRoundings of it are touching.
template <class T>
T GetExtent(const CShapeGeometry<T>& f, const CSweptBall<T>& ball, const CTurning<T>& turning) {
  T size = ball.m_vPos.cwiseAbs().maxCoeff();
  for (const CVec<T>* p : {&f.m_vCenter, &f.m_vPt0, &f.m_vPt1, &turning.m_vCenter})
    size = std::max(size, p->cwiseAbs().maxCoeff());
  return size + f.m_fRadius + ball.m_fRadius;
}

/// The path of a ball against something of this size.
template <class T>
CPathDesc<T> MakePathDesc(const CSweptBall<T>& ball, const T& tMax, const T& size, const T& speed) {
  const T eps = T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon();
  const T acc = Norm(ball.m_vAcc) + BeyondBound(ball.m_stdMore, tMax);
  return {ball.m_vPos,  ball.m_vVel,   ball.m_vAcc, tMax, T(eps * size), T(eps * (speed + acc * tMax)),
          T(eps * acc), ball.m_stdMore};
}

/// The first hit of the ball on the figure in [0, tMax], while the figure moves and turns from the pose that
/// is given. Error of the time at most (g_nTouchRoundings + 16) eps (size of the coordinates and of the way)
/// / approach speed + 4 eps t; without rotation 16 instead of the first factor, unless the ball touches at
/// time 0.
/// @return whether there is one; hit.m_bGraze is set in any case
template <class T>
bool Sweep(const CShapeGeometry<T>& f, const CTurning<T>& turning, const CSweptBall<T>& mover, const T& tMax,
           CHit<T>& hit, eMeet meet = eMeet::Approaching) {
  using std::abs;
  // In the frame that moves with the figure.
  const CSweptBall<T> ball{mover.m_vPos, mover.m_vVel - turning.m_vVel, mover.m_fRadius, mover.m_vAcc,
                           mover.m_stdMore};
  const T size = GetExtent(f, ball, turning), w = turning.m_fSpeed;
  const CPathDesc<T> desc = MakePathDesc(ball, tMax, size, T(Norm(ball.m_vVel) + abs(w) * size));
  const auto run = [&](const auto& path) {
    return CSweeper<std::decay_t<decltype(path)>>(path, ball.m_fRadius, meet, hit).Run(f);
  };
  // A shape without ends that turns about its own centre stays where it is.
  const bool isRound = f.m_eShapeType == eShape::Point || f.m_eShapeType == eShape::Circle || f.m_bFull;
  const bool turns = w != T(0) && !(isRound && f.m_vCenter == turning.m_vCenter);
  if (turns || !ball.m_stdMore.empty()) {
    const T seen = turns ? w : T(0);
    if (!run(CTurningPath<T>(desc, turning.m_vCenter, seen))) return false;
    const T angle = seen * hit.m_fTime;
    hit.m_vNorm = Turned(hit.m_vNorm, angle);
    hit.m_vPOI = turning.m_vCenter + Turned(CVec<T>(hit.m_vPOI - turning.m_vCenter), angle);
  } else if (!(ball.m_vAcc.x() == T(0) && ball.m_vAcc.y() == T(0))) {
    if (!run(CParabolicPath<T>(desc))) return false;
  } else if (!run(CStraightPath<T>(desc))) {
    return false;
  }
  hit.m_vSurface = turning.m_vVel + w * Perp(CVec<T>(hit.m_vPOI - turning.m_vCenter));
  hit.m_vPOI += hit.m_fTime * turning.m_vVel;
  hit.m_vCenter = mover.GetPos(hit.m_fTime);
  return true;
}

/// The same for a figure at rest.
template <class T>
bool Sweep(const CShapeGeometry<T>& f, const CSweptBall<T>& ball, const T& tMax, CHit<T>& hit,
           eMeet meet = eMeet::Approaching) {
  return Sweep(f, CTurning<T>(), ball, tMax, hit, meet);
}

template <class T>
CMore<T> Minus(CMore<T> a, const CMore<T>& b) {
  if (a.size() < b.size()) a.resize(b.size(), CVec<T>::Zero());
  for (std::size_t k = 0; k < b.size(); ++k)
    a[k] -= b[k];
  return a;
}

/// Ball against `other`, both moving; balls are solid. hit.m_vSurface is the velocity of the other at the
/// impact.
template <class T>
bool SweepBalls(const CSweptBall<T>& other, const CSweptBall<T>& ball, const T& tMax, CHit<T>& hit,
                eMeet meet = eMeet::Approaching) {
  const T size = std::max(other.m_vPos.cwiseAbs().maxCoeff(), ball.m_vPos.cwiseAbs().maxCoeff()) +
                 other.m_fRadius + ball.m_fRadius;
  const CSweptBall<T> relative{ball.m_vPos - other.m_vPos, ball.m_vVel - other.m_vVel, ball.m_fRadius,
                               ball.m_vAcc - other.m_vAcc, Minus(ball.m_stdMore, other.m_stdMore)};
  const CPathDesc<T> desc = MakePathDesc(relative, tMax, size, T(Norm(ball.m_vVel) + Norm(other.m_vVel)));
  const auto run = [&](const auto& path) {
    return CSweeper<std::decay_t<decltype(path)>>(path, ball.m_fRadius, meet, hit).RunDisc(other.m_fRadius);
  };
  // Under common gravity the relative way is straight.
  const bool straight = relative.m_vAcc.x() == T(0) && relative.m_vAcc.y() == T(0);
  if (!relative.m_stdMore.empty()) {
    if (!run(CTurningPath<T>(desc, CVec<T>(CVec<T>::Zero()), T(0)))) return false;
  } else if (!(straight ? run(CStraightPath<T>(desc)) : run(CParabolicPath<T>(desc)))) {
    return false;
  }
  hit.m_vPOI += other.GetPos(hit.m_fTime);
  hit.m_vSurface = other.GetVel(hit.m_fTime);
  hit.m_vCenter = ball.GetPos(hit.m_fTime);
  return true;
}

} // namespace Shapes::Compare
