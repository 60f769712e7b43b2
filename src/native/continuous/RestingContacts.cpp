// SPDX-License-Identifier: MIT
#include "RestingContacts.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace Shapes::Native {

void CRestingContacts::Clear() {
  m_stdContacts.clear();
  m_stdPairs.clear();
}

void CRestingContacts::Add(std::uint32_t ball, std::uint32_t other, bool isBall, const CImpact& impact,
                           double gap) {
  CContact c;
  c.m_nBall = ball;
  c.m_nOther = other;
  c.m_bIsBall = isBall;
  c.m_vNorm = impact.m_vNorm;
  c.m_fGap = gap;
  c.m_fSpeed = isBall ? 0.0 : impact.m_vNorm.dot(impact.m_vSurface);
  c.m_fRadius = impact.m_fRadius;
  c.m_fBend = impact.m_fClosing; // until Solve
  m_stdContacts.push_back(c);
}

void CRestingContacts::Separate(std::vector<CMoving>& balls, const Vector2d& gravity) {
  for (CContact& c : m_stdContacts) {
    CMoving& ball = balls[c.m_nBall];
    c.m_vPos = ball.m_vPos;
    c.m_fHeight = -gravity.dot(ball.m_vPos - ball.m_fRadius * c.m_vNorm);
    // The upper one of two balls comes first.
    if (!c.m_bIsBall || c.m_vNorm.dot(gravity) <= 0.0) continue;
    std::swap(c.m_nBall, c.m_nOther);
    c.m_vNorm = -c.m_vNorm;
  }
  // From the bottom up; a shape before balls at the same height.
  std::stable_sort(m_stdContacts.begin(), m_stdContacts.end(),
                   [](const CContact& a, const CContact& b) { return a.m_fHeight < b.m_fHeight; });
  m_stdMoves.assign(balls.size(), Vector2d::Zero());
  const auto move = [&](std::uint32_t i, const Vector2d& way) {
    Vector2d& moved = m_stdMoves[i];
    const Vector2d before = moved;
    moved += way;
    const double most = 0.2 * balls[i].m_fRadius, length = Norm(moved);
    if (length > most) moved *= most / length;
    balls[i].m_vPos += moved - before;
  };
  const auto separate = [&](CContact& c, bool isLowerFixed) {
    CMoving& ball = balls[c.m_nBall];
    if (!c.m_bIsBall) {
      const double gap = c.m_fGap + c.m_vNorm.dot(ball.m_vPos - c.m_vPos);
      if (gap < 0.0) move(c.m_nBall, -gap * c.m_vNorm);
      return gap < -g_fSeparateError * ball.m_fRadius;
    }
    CMoving& other = balls[c.m_nOther];
    const Vector2d d = ball.m_vPos - other.m_vPos;
    const double depth = ball.m_fRadius + other.m_fRadius - Norm(d);
    if (!(depth > 0.0)) return false;
    const Vector2d n = Unit(d, c.m_vNorm);
    const double share = isLowerFixed ? 1.0 : other.m_fMass / (ball.m_fMass + other.m_fMass);
    move(c.m_nBall, share * depth * n);
    if (!isLowerFixed) move(c.m_nOther, (share - 1.0) * depth * n);
    return depth > g_fSeparateError * std::min(ball.m_fRadius, other.m_fRadius);
  };
  bool any = true;
  for (int round = 0; any && round < g_nSeparateRounds; ++round) {
    any = false;
    for (auto it = m_stdContacts.begin(); it != m_stdContacts.end(); ++it)
      any |= separate(*it, false);
    for (auto it = m_stdContacts.rbegin(); it != m_stdContacts.rend(); ++it)
      any |= separate(*it, false);
  }
  // Each lower one as if it were the ground: else a high pile sinks into itself.
  for (int round = 0; any && round < g_nShockRounds; ++round) {
    any = false;
    for (CContact& c : m_stdContacts)
      any |= separate(c, true);
  }
  for (int round = 0; round < g_nWedgeRounds; ++round)
    for (CContact& c : m_stdContacts)
      if (!c.m_bIsBall) separate(c, true);
  for (CContact& c : m_stdContacts) {
    const CMoving& ball = balls[c.m_nBall];
    if (c.m_bIsBall) {
      const Vector2d d = ball.m_vPos - balls[c.m_nOther].m_vPos;
      c.m_fGap = Norm(d) - ball.m_fRadius - balls[c.m_nOther].m_fRadius;
      c.m_vNorm = Unit(d, c.m_vNorm);
    } else {
      c.m_fGap += c.m_vNorm.dot(ball.m_vPos - c.m_vPos);
    }
  }
}

bool CRestingContacts::Has(std::uint32_t ball, std::uint32_t other) const {
  return std::binary_search(m_stdPairs.begin(), m_stdPairs.end(), CPair(ball, other));
}

std::span<const CRestingContacts::CPair> CRestingContacts::GetNeighbours(std::uint32_t ball) const {
  const auto begin = std::lower_bound(m_stdPairs.begin(), m_stdPairs.end(), CPair(ball, 0));
  const auto end = std::find_if(begin, m_stdPairs.end(), [=](const CPair& p) { return p.first != ball; });
  return {begin, end};
}

void CRestingContacts::Iterate(const std::vector<CMoving>& balls, double accurate) {
  const auto push = [&](const CContact& c, double impulse) {
    m_stdVels[c.m_nBall] += impulse / balls[c.m_nBall].m_fMass * c.m_vNorm;
    if (c.m_bIsBall) m_stdVels[c.m_nOther] -= impulse / balls[c.m_nOther].m_fMass * c.m_vNorm;
  };
  for (const CContact& c : m_stdContacts)
    if (c.m_fImpulse > 0.0) push(c, c.m_fImpulse);
  const auto relax = [&](CContact& c) {
    const double of = c.m_vNorm.dot(m_stdVels[c.m_nBall]);
    const double now = c.m_bIsBall ? of - c.m_vNorm.dot(m_stdVels[c.m_nOther]) : of;
    const double before = c.m_fImpulse;
    c.m_fImpulse = std::max(0.0, before + c.m_fShare * (c.m_fLeast - now));
    if (c.m_fImpulse == before) return 0.0;
    push(c, c.m_fImpulse - before);
    return std::abs(c.m_fImpulse - before) / c.m_fShare;
  };
  double most = std::numeric_limits<double>::infinity();
  for (int round = 0; most > accurate && round < g_nRestingRounds; ++round) {
    most = 0.0;
    for (auto it = m_stdContacts.begin(); it != m_stdContacts.end(); ++it)
      relax(*it);
    for (auto it = m_stdContacts.rbegin(); it != m_stdContacts.rend(); ++it)
      most = std::max(most, relax(*it));
  }
  // Each lower one as if it were the ground, as far as the rounds have not come to an end. Shapes last: no
  // ball is pressed into one by others.
  const auto stop = [&](const CContact& c) {
    Vector2d& v = m_stdVels[c.m_nBall];
    const double of = c.m_vNorm.dot(v), now = c.m_bIsBall ? of - c.m_vNorm.dot(m_stdVels[c.m_nOther]) : of;
    if (now < c.m_fLeast) v += (c.m_fLeast - now) * c.m_vNorm;
  };
  for (int round = 0; most > g_fShock * accurate && round < g_nShockRounds; ++round)
    for (const CContact& c : m_stdContacts)
      stop(c);
  for (int round = 0; round < g_nWedgeRounds; ++round)
    for (const CContact& c : m_stdContacts)
      if (!c.m_bIsBall) stop(c);
}

void CRestingContacts::Solve(std::vector<CMoving>& balls, const Vector2d& gravity, double dt) {
  const double slow = g_fRestingSteps * Norm(gravity) * dt;
  for (CContact& c : m_stdContacts) {
    const CMoving& ball = balls[c.m_nBall];
    Vector2d acc = ball.m_vAcc, v = ball.m_vVel;
    double inverse = 1.0 / ball.m_fMass;
    if (c.m_bIsBall) {
      const CMoving& other = balls[c.m_nOther];
      acc -= other.m_vAcc, v -= other.m_vVel, inverse += 1.0 / other.m_fMass;
    }
    const double speed = c.m_vNorm.dot(v) - c.m_fSpeed;
    c.m_bIsSlow = std::abs(speed) <= slow && c.m_fGap <= slow * dt;
    c.m_fBend = -c.m_fBend - c.m_vNorm.dot(acc);
    c.m_fShare = 1.0 / inverse;
    c.m_fLeast = c.m_fSpeed - c.m_fBend * dt - std::max(0.0, 2.0 * std::max(0.0, c.m_fGap) / dt + speed);
  }
  std::erase_if(m_stdContacts, [](const CContact& c) { return !c.m_bIsSlow; });
  m_stdVels.resize(balls.size());
  for (CContact& c : m_stdContacts) {
    const auto known = std::lower_bound(m_stdKnown.begin(), m_stdKnown.end(), Pair(c),
                                        [](const CKnown& k, std::uint64_t pair) { return k.m_nPair < pair; });
    if (known != m_stdKnown.end() && known->m_nPair == Pair(c)) c.m_fImpulse = known->m_fImpulse;
  }
  // Pairs of balls may overlap for a substep; into a shape none goes.
  for (int round = 0; round < g_nWedgeRounds; ++round)
    for (const CContact& c : m_stdContacts) {
      if (c.m_bIsBall) continue;
      Vector2d& v = balls[c.m_nBall].m_vVel;
      v += std::max(0.0, c.m_fSpeed - std::max(0.0, c.m_fGap) / dt - c.m_vNorm.dot(v)) * c.m_vNorm;
    }
  for (const CContact& c : m_stdContacts) {
    m_stdVels[c.m_nBall] = balls[c.m_nBall].m_vVel + gravity * dt;
    if (!c.m_bIsBall) continue;
    m_stdVels[c.m_nOther] = balls[c.m_nOther].m_vVel + gravity * dt;
    m_stdPairs.emplace_back(c.m_nBall, c.m_nOther);
    m_stdPairs.emplace_back(c.m_nOther, c.m_nBall);
  }
  std::sort(m_stdPairs.begin(), m_stdPairs.end());

  Iterate(balls, g_fRestingError * slow);
  m_stdKnown.clear();
  const auto take = [&](std::uint32_t i) {
    balls[i].m_vAcc = (m_stdVels[i] - balls[i].m_vVel) / dt;
    balls[i].m_bIsMoved = true;
  };
  for (const CContact& c : m_stdContacts) {
    take(c.m_nBall);
    if (c.m_bIsBall) take(c.m_nOther);
    if (!(c.m_fImpulse > 0.0)) continue;
    m_stdKnown.push_back({Pair(c), c.m_fImpulse});
    CMoving& ball = balls[c.m_nBall];
    if (!c.m_bIsBall)
      ball.m_cHolds.Add(
          {c.m_nOther, false, c.m_vNorm, c.m_fSpeed, -c.m_fBend, std::abs(c.m_fRadius + ball.m_fRadius)});
  }
  std::sort(m_stdKnown.begin(), m_stdKnown.end(),
            [](const CKnown& a, const CKnown& b) { return a.m_nPair < b.m_nPair; });
}

} // namespace Shapes::Native
