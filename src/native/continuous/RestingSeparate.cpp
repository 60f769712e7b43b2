// SPDX-License-Identifier: MIT
// Balls of piles that overlap are moved apart.
#include "RestingContacts.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <utility>

namespace Shapes::Native {

// From the bottom up; a shape before balls at the same height. The upper one of two balls comes first.
void CRestingContacts::Order(std::vector<CMoving>& balls) {
  for (CContact& c : m_stdContacts) {
    const CMoving& ball = balls[c.m_nBall];
    c.m_nPair = GetPair(c, balls);
    c.m_fKey = -m_vGravity.dot(ball.m_vPos - ball.m_fRadius * c.m_vNorm);
    if (!c.m_bIsBall || c.m_vNorm.dot(m_vGravity) <= 0.0) continue;
    std::swap(c.m_nBall, c.m_nOther);
    c.m_vNorm = -c.m_vNorm;
  }
  Sort();
}

void CRestingContacts::FindOverlaps(const std::vector<CMoving>& balls) {
  m_stdPlaces.clear();
  for (const CMoving& ball : balls)
    m_stdPlaces.push_back({ball.m_vPos, Vector2d::Zero(), g_fMostSeparation * ball.m_fRadius});
  m_stdOverlaps.clear();
  for (const CContact& c : m_stdContacts) {
    const CMoving& ball = balls[c.m_nBall];
    COverlap o{c.m_nBall, c.m_nOther,  c.m_bIsBall,
               c.m_vNorm, ball.m_vPos, c.m_fGap,
               0.0,       1.0,         g_fSeparateError * ball.m_fRadius,
               0.0};
    if (c.m_bIsBall) {
      const CMoving& other = balls[c.m_nOther];
      const double smaller = std::min(ball.m_fRadius, other.m_fRadius);
      o.m_fTouching = ball.m_fRadius + other.m_fRadius;
      o.m_fShare = other.m_fMass / (ball.m_fMass + other.m_fMass);
      o.m_fLeast = g_fSeparateError * smaller;
      o.m_fSqueezed = g_fSqueezedDepth * smaller;
    }
    m_stdOverlaps.push_back(o);
  }
}

inline void CRestingContacts::Move(std::uint32_t ball, const Vector2d& way) {
  CPlace& place = m_stdPlaces[ball];
  const Vector2d before = place.m_vMoved;
  place.m_vMoved += way;
  if (place.m_vMoved.squaredNorm() > place.m_fMost * place.m_fMost)
    place.m_vMoved *= place.m_fMost / Norm(place.m_vMoved);
  place.m_vPos += place.m_vMoved - before;
}

// Whether they overlapped by more than may stay.
bool CRestingContacts::MoveApart(const COverlap& o, bool isLowerFixed) {
  const Vector2d p = m_stdPlaces[o.m_nBall].m_vPos;
  if (!o.m_bIsBall) {
    const double gap = o.m_fGap + o.m_vNorm.dot(p - o.m_vFrom);
    if (gap < 0.0) Move(o.m_nBall, -gap * o.m_vNorm);
    return gap < -o.m_fLeast;
  }
  const Vector2d d = p - m_stdPlaces[o.m_nOther].m_vPos;
  FailIf(d.squaredNorm() >= o.m_fTouching * o.m_fTouching);
  const double distance = Norm(d), depth = o.m_fTouching - distance;
  FailIf(!(depth > 0.0));
  Vector2d n = distance > 0.0 ? Vector2d(d / distance) : o.m_vNorm;
  // A row that is squeezed has nowhere to go but up, and no contact in it says so.
  if (depth > o.m_fSqueezed) n = Unit(n + g_fLift * m_vUp, n);
  const double share = isLowerFixed ? 1.0 : o.m_fShare;
  Move(o.m_nBall, share * depth * n);
  if (!isLowerFixed) Move(o.m_nOther, (share - 1.0) * depth * n);
  return depth > o.m_fLeast;
}

void CRestingContacts::MoveApart(std::size_t balls, bool flows) {
  // Where many are in one place they need not come apart in one substep.
  const std::size_t goal = flows ? g_nFlowRounds : g_nSeparateRounds;
  const std::size_t most = g_nManyContacts * balls * goal;
  const std::size_t rounds = std::min(goal, 1 + most / (m_stdOverlaps.size() + 1));
  bool any = true;
  for (std::size_t round = 0; any && round < rounds; ++round) {
    any = false;
    for (const COverlap& o : m_stdOverlaps)
      any |= MoveApart(o, false);
    for (auto it = m_stdOverlaps.rbegin(); it != m_stdOverlaps.rend(); ++it)
      any |= MoveApart(*it, false);
  }
  // Each lower one as if it were the ground: else a high pile sinks into itself.
  for (int round = 0; any && rounds > 1 && round < g_nShockRounds; ++round) {
    any = false;
    for (const COverlap& o : m_stdOverlaps)
      any |= MoveApart(o, true);
  }
  for (int round = 0; round < g_nWedgeRounds; ++round)
    for (const COverlap& o : m_stdOverlaps)
      if (!o.m_bIsBall) MoveApart(o, true);
}

void CRestingContacts::Separate(std::vector<CMoving>& balls) {
  Order(balls);
  FindOverlaps(balls);
  double fastest = 0.0; // squared
  for (const CMoving& ball : balls)
    if (ball.m_bIsNearBall) fastest = std::max(fastest, ball.m_vVel.squaredNorm());
  MoveApart(balls.size(), fastest > 0.25 * m_fSlow * m_fSlow);
  for (std::size_t i = 0; i < balls.size(); ++i)
    balls[i].m_vPos = m_stdPlaces[i].m_vPos;
  for (std::size_t k = 0; k < m_stdContacts.size(); ++k) {
    CContact& c = m_stdContacts[k];
    const Vector2d& p = m_stdPlaces[c.m_nBall].m_vPos;
    if (c.m_bIsBall) {
      const Vector2d d = p - m_stdPlaces[c.m_nOther].m_vPos;
      c.m_fGap = Norm(d) - balls[c.m_nBall].m_fRadius - balls[c.m_nOther].m_fRadius;
      c.m_vNorm = Unit(d, c.m_vNorm);
    } else {
      c.m_fGap += c.m_vNorm.dot(p - m_stdOverlaps[k].m_vFrom);
    }
  }
}

} // namespace Shapes::Native
