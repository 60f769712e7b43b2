// SPDX-License-Identifier: MIT
// Balls of piles that overlap are moved apart.
#include "RestingContacts.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Shapes::Native {

// From the bottom up; a shape before balls at the same height. The upper one of two balls comes first.
void CRestingContacts::Order(std::vector<CMoving>& balls) {
  for (CContact& c : m_stdContacts) {
    const CMoving& ball = balls[c.m_nBall];
    c.m_fKey = -m_vGravity.dot(ball.m_vPos - ball.m_fRadius * c.m_vNorm);
    if (!c.m_bIsBall || c.m_vNorm.dot(m_vGravity) <= 0.0) continue;
    std::swap(c.m_nBall, c.m_nOther);
    c.m_vNorm = -c.m_vNorm;
  }
  Sort();
}

double CRestingContacts::GetSmallerRadius(const CContact& c, const std::vector<CMoving>& balls) {
  const double radius = balls[c.m_nBall].m_fRadius;
  return c.m_bIsBall ? std::min(radius, balls[c.m_nOther].m_fRadius) : radius;
}

// Whether two balls are in a row that is longer than its room: squeezed by a wall, or level and at rest in a
// pile and still in each other. It has nowhere to go but up, and no contact in it says so.
bool CRestingContacts::IsJammed(const CContact& c, const std::vector<CMoving>& balls) const {
  FailIf(!c.m_bIsBall);
  const double overlap = -c.m_fGap, radius = GetSmallerRadius(c, balls); // which may be 0
  FailIf(!(overlap > g_fSleepOverlap * radius));
  const double slow = g_fSleepSpeed * Norm(m_vGravity) * m_fStep;
  const auto isAtRest = [&](std::uint32_t i) {
    return balls[i].m_bHasPressed && Norm(balls[i].m_vVel) <= slow;
  };
  const bool isLevel = std::abs(c.m_vNorm.dot(m_vUp)) < g_fLevel;
  return overlap > g_fSqueezedDepth * radius || (isLevel && isAtRest(c.m_nBall) && isAtRest(c.m_nOther));
}

// The error that a velocity may have where the fastest ball near another one flows.
double CRestingContacts::GetFlowError(const std::vector<CMoving>& balls) const {
  double fastest = 0.0; // squared
  for (const CMoving& ball : balls)
    if (ball.m_bIsNearBall) fastest = std::max(fastest, ball.m_vVel.squaredNorm());
  return CContactSolver::GetFlowError(std::sqrt(fastest), m_fSlow);
}

void CRestingContacts::Separate(std::vector<CMoving>& balls) {
  m_stdLifts.assign(balls.size(), 0.0);
  Order(balls);
  FindKnown();
  double least = std::numeric_limits<double>::infinity(); // overlap that may stay
  bool any = false;
  for (const CContact& c : m_stdContacts) {
    const double stays = g_fSeparateError * GetSmallerRadius(c, balls);
    least = std::min(least, stays);
    any |= c.m_fGap < -stays;
  }
  if (!any) return;
  for (const CContact& c : m_stdContacts)
    if (c.m_fImpulse > 0.0) {
      balls[c.m_nBall].m_bHasPressed = true;
      if (c.m_bIsBall) balls[c.m_nOther].m_bHasPressed = true;
    }

  const double accurate = least / m_fStep, error = GetFlowError(balls);
  // Where balls flow others overlap each time.
  const double known = error > accurate ? 0.0 : g_fKnownApart;
  m_stdSolved.assign(balls.size(), g_nNobody);
  m_cSolver.Begin();
  for (const CContact& c : m_stdContacts) {
    CContactSolver::CRow row = MakeRow(c, balls, [](std::uint32_t) { return Vector2d(Vector2d::Zero()); });
    row.m_fLeast = -c.m_fGap / m_fStep;
    if (IsJammed(c, balls)) row.m_vNorm = Unit(c.m_vNorm + g_fLift * m_vUp, c.m_vNorm);
    m_cSolver.Add(row, known * c.m_fApart);
  }
  // Where a game has put a shape into balls they give way as far as it has come, and more where each has to
  // make room for the one before it.
  double given = 0.0;
  for (const CContact& c : m_stdContacts)
    if (m_cMemory.m_bIsShapePut && !c.m_bIsBall) given = std::max(given, -g_fGivenWay * c.m_fGap);
  double limit = given;
  std::size_t near = 0;
  for (const CMoving& ball : balls) {
    if (!ball.m_bIsNearBall) continue;
    limit = std::max(limit, g_fMostSeparation * ball.m_fNearRadius);
    ++near;
  }
  // Where many are in one place they need not come apart in one substep.
  const std::size_t most = g_nManyContacts * near * g_nSeparateRounds;
  m_cSolver.Separate(std::max(accurate, error), limit / m_fStep,
                     std::min(g_nSeparateRounds, 1 + most / m_stdContacts.size()));

  for (std::size_t k = 0; k < m_stdContacts.size(); ++k)
    m_cMemory.m_stdNear[m_stdContacts[k].m_nNear].m_fApart = m_cSolver.GetImpulse(k);

  const auto getWay = [&](std::uint32_t i) {
    if (m_stdSolved[i] == g_nNobody) return Vector2d(Vector2d::Zero());
    const Vector2d way = m_fStep * m_cSolver.GetVel(m_stdSolved[i]);
    const double length = Norm(way), mostOfIt = std::max(given, g_fMostSeparation * balls[i].m_fNearRadius);
    return length > mostOfIt ? Vector2d(mostOfIt / length * way) : way;
  };
  for (std::uint32_t i = 0; i < balls.size(); ++i)
    if (const Vector2d way = getWay(i); !way.isZero(0.0)) {
      balls[i].m_vPos += way;
      balls[i].m_bIsMoved = true;
      m_stdLifts[i] = -balls[i].m_fMass * m_vGravity.dot(way);
    }
  for (CContact& c : m_stdContacts) {
    if (c.m_bIsBall) {
      const CMoving &ball = balls[c.m_nBall], &other = balls[c.m_nOther];
      const Vector2d d = ball.m_vPos - other.m_vPos;
      c.m_fGap = Norm(d) - ball.m_fRadius - other.m_fRadius;
      c.m_vNorm = Unit(d, c.m_vNorm);
    } else {
      c.m_fGap += c.m_vNorm.dot(getWay(c.m_nBall));
    }
  }
}

void CRestingContacts::NotePressed(std::vector<CMoving>& balls) const {
  for (const CContact& c : m_stdContacts) {
    if (!(GetGap(c, balls) < -g_fSleepOverlap * GetSmallerRadius(c, balls))) continue;
    balls[c.m_nBall].m_bIsPressed = true;
    if (c.m_bIsBall) balls[c.m_nOther].m_bIsPressed = true;
  }
}

} // namespace Shapes::Native
