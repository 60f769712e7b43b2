// SPDX-License-Identifier: MIT
// From the arrays of balls to those that move in the continuous mode, and back.
#include "Continuous.h"

#include "../../shapes/Response.h"
#include "Rounding.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Native {

// Those that may meet something.
void CContinuous::TakeBalls() {
  const CBallArrays& b = *m_pBalls;
  m_stdSolid.clear();
  for (std::uint32_t i = 0; i < b.Size(); ++i)
    if (b.IsSolid(i)) m_stdSolid.push_back(i);
  FindDiscs();
  m_cNearDiscs.Build(GetSlack());
  FindInvolved();
  m_stdShapesOf.clear();

  m_stdBalls.clear();
  m_stdIndexOf.assign(m_stdSolid.size(), g_nNobody);
  for (std::uint32_t k = 0; k < m_stdSolid.size(); ++k)
    if (m_stdIsInvolved[k]) TakeSolid(k);
}

CMotion CContinuous::GetFreeMotion(std::size_t i) const {
  const CBallArrays& b = *m_pBalls;
  const Vector2d p = Join(b.m_stdPos[i], b.m_stdPosTail[i]);
  const double least = IsFalling() ? LeastRadius(p) : 0.0;
  return {p, Join(b.m_stdVel[i], b.m_stdVelTail[i]), std::max(static_cast<double>(b.m_stdRadius[i]), least),
          m_fStep, m_vGravity};
}

// Around the whole of a motion of floats, which have no squares that underflow.
CDiscGrid::CDisc CContinuous::GetDisc(const CMotion& motion, double sagitta) {
  const Vector2d chord = motion.PosAt(motion.m_fDuration) - motion.m_vPos;
  const Vector2 center = ToFloat(motion.m_vPos + 0.5 * chord);
  const double radius = 0.5 * chord.norm() + motion.m_fRadius + sagitta;
  const auto size = static_cast<double>(center.cwiseAbs().maxCoeff());
  return {center, static_cast<float>(radius + static_cast<double>(g_fBoxPadding) * (radius + size))};
}

void CContinuous::FindDiscs() {
  std::vector<CDiscGrid::CDisc>& discs = m_cNearDiscs.GetDiscs();
  discs.resize(m_stdSolid.size());
  double fastest = 0.0; // squared
  for (std::uint32_t k = 0; k < m_stdSolid.size(); ++k) {
    const CMotion motion = GetFreeMotion(m_stdSolid[k]);
    fastest = std::max(fastest, motion.m_vVel.squaredNorm());
    discs[k] = GetDisc(motion, m_fSagitta);
  }
  m_fFastest = std::sqrt(fastest);
}

// Balls that are awake and near a shape or another ball, and those that sleep near them; and wakes those near
// which something moves, and with each all that touch it.
void CContinuous::FindInvolved() {
  CBallArrays& b = *m_pBalls;
  m_stdIsInvolved.assign(m_stdSolid.size(), 0);
  m_stdWoken.clear();
  const bool anySleeps = AnySleeps();
  const auto wake = [&](std::uint32_t k) {
    b.m_stdCalm[m_stdSolid[k]] = 0.0f;
    m_stdWoken.push_back(k);
  };
  const auto look = [&](std::uint32_t k) {
    for (const std::uint32_t other : m_cNearDiscs.FindAtBegin(k)) {
      m_stdIsInvolved[k] = m_stdIsInvolved[other] = 1;
      if (anySleeps && IsAsleep(m_stdSolid[other]) && IsOnWay(m_stdSolid[other], m_stdSolid[k])) wake(other);
    }
    const CDiscGrid::CDisc& disc = m_cNearDiscs.Get(k);
    if (!m_stdIsInvolved[k] && !m_pShapes->IsClear(disc.m_vCenter, disc.m_fRadius) &&
        !PassesAll(GetFreeMotion(m_stdSolid[k]), disc))
      m_stdIsInvolved[k] = 1;
  };
  for (std::uint32_t k = 0; k < m_stdSolid.size(); ++k)
    if (!anySleeps || !IsAsleep(m_stdSolid[k]))
      look(k);
    else if (MovesNear(m_cNearDiscs.Get(k)))
      wake(k);
  for (std::size_t w = 0; w < m_stdWoken.size(); ++w)
    look(m_stdWoken[w]);
}

// Whether surely no shape touches the ball or is on its way, where this disc is around that.
bool CContinuous::PassesAll(const CMotion& motion, const CDiscGrid::CDisc& disc) {
  m_pShapes->FindNear(disc.m_vCenter, disc.m_fRadius, m_stdShapesFound);
  return std::all_of(m_stdShapesFound.begin(), m_stdShapesFound.end(), [&](std::uint32_t order) {
    const CShapeGeometry& geometry = m_pShapes->GetGeometry(order);
    const double size = SizeOf(motion.m_vPos, motion.m_fRadius) + geometry.m_fSize;
    return IsOutOfWay(geometry, motion, 0.0, Rounding(size)) ||
           !m_pShapes->Get(order).m_pShape->GetCanCollide();
  });
}

// Whether a shape moves near a ball that sleeps, with this disc.
bool CContinuous::MovesNear(const CDiscGrid::CDisc& disc) const {
  const auto reach = static_cast<float>(m_cResting.GetSlow() * m_fStep);
  return m_pShapes->MovesNear(Padded(CAabb2D(disc.m_vCenter, disc.m_vCenter), disc.m_fRadius + reach));
}

void CContinuous::TakeSolid(std::uint32_t k) {
  m_stdIndexOf[k] = static_cast<std::uint32_t>(m_stdBalls.size());
  Take(m_stdSolid[k], GetFreeMotion(m_stdSolid[k]), m_cNearDiscs.Get(k));
  m_stdBalls.back().m_nSolid = k;
  if (!m_cEnergy.IsEmpty()) m_cEnergy.Add(m_stdBalls.back());
}

void CContinuous::Take(std::size_t i, const CMotion& motion, const CDiscGrid::CDisc& disc) {
  const CBallArrays& b = *m_pBalls;
  CMoving& ball = m_stdBalls.emplace_back();
  ball.m_nBall = i;
  ball.m_vPos = motion.m_vPos;
  ball.m_vVel = motion.m_vVel;
  ball.m_vFall = m_vGravity;
  ball.m_fRadius = ball.m_fNearRadius = motion.m_fRadius;
  ball.m_fMass = static_cast<double>(b.m_stdMass[i]);
  ball.m_fElasticity = static_cast<double>(b.m_stdElasticity[i]);
  ball.m_bIsAsleep = IsAsleep(i);
  ball.m_vAcc = ball.m_bIsAsleep ? Vector2d(Vector2d::Zero()) : m_vGravity;
  ball.m_cDisc = disc;
  ball.m_bWasSqueezed = m_cResting.WasSqueezed(i);
  ball.m_nSteered = m_cResting.GetSteered(i, ball.m_vVel);
}

// Its motion is another one.
void CContinuous::MoveDisc(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  const CMotion motion = GetMotion(ball);
  ball.m_cDisc = GetDisc(motion, motion.GetSagitta());
  if (m_bPairs) m_cNearDiscs.Move(ball.m_nSolid, ball.m_cDisc);
}

// The balls whose ways come near that of this one and that it meets, each once, in the order in which they
// were taken; in a crowd those that are near enough.
void CContinuous::FindBalls(std::uint32_t i) {
  FindAllBalls(i);
  m_stdBalls[i].m_nBallsSeen += m_stdBallsFound.size();
  if (m_bAnyCrowd) std::erase_if(m_stdBallsFound, [&](std::uint32_t j) { return IsBeyondCrowd(i, j); });
}

void CContinuous::FindAllBalls(std::uint32_t i) {
  m_stdBallsFound.clear();
  if (!m_bPairs) return;
  m_cNearDiscs.Find(m_stdBalls[i].m_nSolid, m_stdBallsFound);
  // Where it was not expected a ball may come upon those in the open.
  bool anyLate = false;
  for (std::uint32_t& found : m_stdBallsFound) {
    if (m_stdIndexOf[found] == g_nNobody) {
      TakeSolid(found);
      anyLate = true;
    }
    found = m_stdIndexOf[found];
  }
  if (anyLate) std::sort(m_stdBallsFound.begin(), m_stdBallsFound.end());
  if (m_bFilters)
    std::erase_if(m_stdBallsFound, [&](std::uint32_t j) {
      const std::vector<CFilter>& filters = m_pBalls->m_stdFilter;
      return !DoMeet(filters[m_stdBalls[i].m_nBall], filters[m_stdBalls[j].m_nBall]);
    });
}

namespace {

bool IsDeep(const CMoving& ball, const CMoving& other) {
  const double reach = ball.m_fRadius + other.m_fRadius - 0.5 * std::min(ball.m_fRadius, other.m_fRadius);
  return (ball.m_vPos - other.m_vPos).squaredNorm() < reach * reach;
}

CFarness GetFarness(const CMoving& ball, const CMoving& other) {
  const auto [first, last] = std::minmax(ball.m_nBall, other.m_nBall);
  return {(ball.m_vPos - other.m_vPos).squaredNorm(), last - first};
}

} // namespace

// Of hundreds of balls in one place each would meet all others, and again after each impact. The nearest are
// enough to part them: when these are apart, others are the nearest.
void CContinuous::FindCrowds() {
  m_bAnyCrowd = false;
  double largest = 0.0; // radius in a crowd
  for (std::uint32_t i = 0; i < m_stdBalls.size(); ++i) {
    CMoving& ball = m_stdBalls[i];
    if (ball.m_bIsAsleep || m_cNearDiscs.FindAtBegin(ball.m_nSolid).size() <= g_nMostDeep) continue;
    FindAllBalls(i);
    m_stdDeep.clear();
    for (const std::uint32_t j : m_stdBallsFound)
      if (IsDeep(ball, m_stdBalls[j])) m_stdDeep.push_back(GetFarness(ball, m_stdBalls[j]));
    if (m_stdDeep.size() <= g_nMostDeep) continue;
    const auto last = m_stdDeep.begin() + (g_nMostDeep - 1);
    std::nth_element(m_stdDeep.begin(), last, m_stdDeep.end());
    ball.m_cFarthestDeep = *last;
    m_bAnyCrowd = true;
    largest = std::max(largest, ball.m_fRadius);
  }
  if (m_bAnyCrowd) m_cNearDiscs.Build(GetSlack() + static_cast<float>(g_fCrowdSlack * largest));
}

// Whether both are in crowds, and neither is among the nearest of the other.
bool CContinuous::IsBeyondCrowd(std::uint32_t i, std::uint32_t j) const {
  const CMoving &ball = m_stdBalls[i], &other = m_stdBalls[j];
  return GetFarness(ball, other) > std::max(ball.m_cFarthestDeep, other.m_cFarthestDeep);
}

// The floats of a place and a velocity, and under gravity what they lack.
void CContinuous::Put(const Vector2d& p, Vector2d v, std::size_t i) {
  CBallArrays& b = *m_pBalls;
  if (m_bCapsSpeeds) m_pStats->m_nSpeedsCapped += CapSpeed(v);
  const Vector2 pos = ToFloat(p), vel = ToFloat(v);
  b.m_stdPos[i] = pos;
  b.m_stdVel[i] = vel;
  if (!IsFalling()) return;
  b.m_stdPosTail[i] = ToFloat(p - pos.cast<double>());
  b.m_stdVelTail[i] = ToFloat(v - vel.cast<double>());
}

// A ball that nothing comes near.
void CContinuous::MoveFreely(std::size_t i) { MoveFreely(i, GetFreeMotion(i)); }

void CContinuous::MoveFreely(std::size_t i, const CMotion& motion) {
  if (!IsFalling()) return Move(m_pBalls->m_stdPos[i], m_pBalls->m_stdVel[i], static_cast<float>(m_fStep));
  Put(motion.PosAt(m_fStep), motion.VelAt(m_fStep), i);
}

// Whether surely nothing is near a ball that is awake and its way, by a larger disc than GetDisc has: without
// a root, as most balls are far from everything.
bool CContinuous::IsFar(std::size_t i) const {
  if (IsAsleep(i)) return false;
  const CBallArrays& b = *m_pBalls;
  const Vector2 half = static_cast<float>(0.5 * m_fStep) * b.m_stdVel[i], center = b.m_stdPos[i] + half;
  // It leaves the chord of its velocity by g dt^2/2, which is four sagittas.
  const float radius = half.cwiseAbs().sum() + b.m_stdRadius[i] + static_cast<float>(4.0 * m_fSagitta);
  const float size = center.cwiseAbs().maxCoeff() + radius;
  return m_pShapes->IsClear(center, radius + 2.0f * g_fBoxPadding * size);
}

// A ball that does not meet others: they need not move at the same time.
void CContinuous::MoveAlone(std::size_t i) {
  if (IsFar(i)) {
    m_pBalls->m_stdCalm[i] = 0.0f;
    return MoveFreely(i);
  }
  const CMotion motion = GetFreeMotion(i);
  if (!m_pBalls->IsSolid(i)) return MoveFreely(i, motion);
  const CDiscGrid::CDisc disc = GetDisc(motion, m_fSagitta);
  float& calm = m_pBalls->m_stdCalm[i];
  if (IsAsleep(i) && !MovesNear(disc)) return;
  if (IsAsleep(i)) calm = 0.0f;
  // So wide that mostly what a shape that holds it makes of its way is in it, too.
  const CDiscGrid::CDisc wide{disc.m_vCenter, disc.m_fRadius + static_cast<float>(8.0 * m_fSagitta)};
  if (PassesAll(motion, wide)) {
    calm = 0.0f;
    return MoveFreely(i, motion);
  }
  m_stdBalls.clear();
  Take(i, motion, disc);
  m_stdShapesOf.clear();
  if (!m_bFilters) KeepShapesFound(0, wide);
  FollowBalls();
  PutTaken();
}

void CContinuous::PutBalls() {
  std::uint32_t k = 0;
  for (std::uint32_t i = 0; i < m_pBalls->Size(); ++i) {
    if (k == m_stdSolid.size() || m_stdSolid[k] != i) {
      MoveFreely(i);
    } else if (m_stdIndexOf[k++] == g_nNobody && !IsAsleep(i)) {
      m_pBalls->m_stdCalm[i] = 0.0f;
      MoveFreely(i);
    }
  }
  PutTaken();
  m_cResting.Remember(m_stdBalls, m_pBalls->Size());
}

void CContinuous::PutTaken() {
  for (CMoving& ball : m_stdBalls)
    if (ball.m_bIsMoved) Advance(ball, m_fStep - ball.m_fTime);
  m_cEnergy.Keep(m_stdBalls, m_vGravity);
  for (const CMoving& ball : m_stdBalls)
    if (ball.m_bIsMoved)
      Put(ball.m_vPos, ball.m_vVel, ball.m_nBall);
    else if (!ball.m_bIsAsleep)
      MoveFreely(ball.m_nBall);
  if (IsFalling()) FallAsleep();
}

} // namespace Shapes::Native
