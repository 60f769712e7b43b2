// SPDX-License-Identifier: MIT
#include "RestingContacts.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace Shapes::Native {

void CRestingContacts::Begin(const Vector2d& gravity, double dt) {
  m_vGravity = gravity;
  m_fStep = dt;
  m_fSlow = g_fRestingSteps * Norm(gravity) * dt;
  m_stdContacts.clear();
  m_stdPairs.clear();
  m_stdRoot.clear();
  m_stdKnown.swap(m_stdNear);
  m_stdNear.clear();
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
  // Of two balls gravity is none.
  c.m_fBend = -impact.m_fClosing - (isBall ? 0.0 : impact.m_vNorm.dot(m_vGravity));
  m_stdContacts.push_back(c);
}

// By their keys; those with the same key stay in their order.
void CRestingContacts::Sort() {
  for (std::uint32_t k = 0; k < m_stdContacts.size(); ++k)
    m_stdContacts[k].m_nPlace = k;
  std::sort(m_stdContacts.begin(), m_stdContacts.end(), [](const CContact& a, const CContact& b) {
    return std::tie(a.m_fKey, a.m_nPlace) < std::tie(b.m_fKey, b.m_nPlace);
  });
}

std::uint64_t CRestingContacts::GetPair(const CContact& c, const std::vector<CMoving>& balls) {
  const std::size_t ball = balls[c.m_nBall].m_nBall;
  const std::size_t other = c.m_bIsBall ? balls[c.m_nOther].m_nBall : c.m_nOther;
  const std::uint64_t first = c.m_bIsBall ? std::min(ball, other) : ball;
  const std::uint64_t second = c.m_bIsBall ? std::max(ball, other) : other;
  return (first << 33) | (second << 1) | std::uint64_t{c.m_bIsBall};
}

void CRestingContacts::Separate(std::vector<CMoving>& balls) {
  for (CContact& c : m_stdContacts) {
    CMoving& ball = balls[c.m_nBall];
    c.m_nPair = GetPair(c, balls);
    c.m_vPos = ball.m_vPos;
    c.m_fKey = -m_vGravity.dot(ball.m_vPos - ball.m_fRadius * c.m_vNorm);
    // The upper one of two balls comes first.
    if (!c.m_bIsBall || c.m_vNorm.dot(m_vGravity) <= 0.0) continue;
    std::swap(c.m_nBall, c.m_nOther);
    c.m_vNorm = -c.m_vNorm;
  }
  // From the bottom up; a shape before balls at the same height.
  Sort();
  const Vector2d up = -Unit(m_vGravity, Vector2d::Zero());
  m_stdMoves.assign(balls.size(), Vector2d::Zero());
  const auto move = [&](std::uint32_t i, const Vector2d& way) {
    Vector2d& moved = m_stdMoves[i];
    const Vector2d before = moved;
    moved += way;
    const double most = g_fMostSeparation * balls[i].m_fRadius, length = Norm(moved);
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
    const double touching = ball.m_fRadius + other.m_fRadius;
    if (d.squaredNorm() >= touching * touching) return false;
    const double depth = touching - Norm(d);
    if (!(depth > 0.0)) return false;
    Vector2d n = Unit(d, c.m_vNorm);
    // A row that is squeezed has nowhere to go but up, and no contact in it says so.
    if (depth > g_fSqueezedDepth * std::min(ball.m_fRadius, other.m_fRadius)) n = Unit(n + g_fLift * up, n);
    const double share = isLowerFixed ? 1.0 : other.m_fMass / (ball.m_fMass + other.m_fMass);
    move(c.m_nBall, share * depth * n);
    if (!isLowerFixed) move(c.m_nOther, (share - 1.0) * depth * n);
    return depth > g_fSeparateError * std::min(ball.m_fRadius, other.m_fRadius);
  };
  // Where many are in one place they need not come apart in one substep.
  const std::size_t most = g_nManyContacts * balls.size() * g_nSeparateRounds;
  const std::size_t rounds = std::min(g_nSeparateRounds, 1 + most / (m_stdContacts.size() + 1));
  bool any = true;
  for (std::size_t round = 0; any && round < rounds; ++round) {
    any = false;
    for (auto it = m_stdContacts.begin(); it != m_stdContacts.end(); ++it)
      any |= separate(*it, false);
    for (auto it = m_stdContacts.rbegin(); it != m_stdContacts.rend(); ++it)
      any |= separate(*it, false);
  }
  // Each lower one as if it were the ground: else a high pile sinks into itself.
  for (int round = 0; any && rounds > 1 && round < g_nShockRounds; ++round) {
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
  // Pointers: not every standard library makes a span of iterators of a vector.
  const CPair* const pLast = m_stdPairs.data() + m_stdPairs.size();
  const CPair* const pBegin = std::lower_bound(m_stdPairs.data(), pLast, CPair(ball, 0));
  return {pBegin, std::find_if(pBegin, pLast, [=](const CPair& p) { return p.first != ball; })};
}

// Along the normal, of the velocities at the beginning, the surface's subtracted.
double CRestingContacts::GetSpeed(const CContact& c, const std::vector<CMoving>& balls) const {
  Vector2d v = balls[c.m_nBall].m_vVel;
  if (c.m_bIsBall) v -= balls[c.m_nOther].m_vVel;
  return c.m_vNorm.dot(v) - c.m_fSpeed;
}

// The lowest index of its pile, with the way to it made shorter.
std::uint32_t CRestingContacts::FindRoot(std::uint32_t ball) {
  while (m_stdRoot[ball] != ball)
    ball = m_stdRoot[ball] = m_stdRoot[m_stdRoot[ball]];
  return ball;
}

void CRestingContacts::FindPiles(std::vector<CMoving>& balls) {
  for (const CContact& c : m_stdContacts)
    m_stdNear.push_back({c.m_nPair, 0.0});
  std::sort(m_stdNear.begin(), m_stdNear.end(),
            [](const CKnown& a, const CKnown& b) { return a.m_nPair < b.m_nPair; });
  std::erase_if(m_stdContacts, [&](const CContact& c) {
    const double speed = GetSpeed(c, balls);
    // Where an approach is still there after a substep it is that of balls that cannot give way.
    const bool isSlow = speed <= m_fSlow && (speed >= -m_fSlow || Find(m_stdKnown, c) != nullptr);
    return !(isSlow && c.m_fGap <= m_fSlow * m_fStep);
  });
  m_stdRoot.resize(balls.size());
  std::iota(m_stdRoot.begin(), m_stdRoot.end(), 0u);
  for (const CContact& c : m_stdContacts) {
    if (!c.m_bIsBall) continue;
    const std::uint32_t a = FindRoot(c.m_nBall), b = FindRoot(c.m_nOther);
    m_stdRoot[std::max(a, b)] = std::min(a, b);
  }
  m_stdIsHeld.assign(balls.size(), false);
  for (const CContact& c : m_stdContacts)
    if (!c.m_bIsBall) m_stdIsHeld[FindRoot(c.m_nBall)] = true;
  std::erase_if(m_stdContacts, [&](const CContact& c) { return !m_stdIsHeld[FindRoot(c.m_nBall)]; });
  for (CContact& c : m_stdContacts)
    c.m_fKey = static_cast<double>(FindRoot(c.m_nBall));
  Sort();
  for (const CContact& c : m_stdContacts) {
    balls[c.m_nBall].m_bIsInPile = true;
    if (!c.m_bIsBall) continue;
    balls[c.m_nOther].m_bIsInPile = true;
    m_stdPairs.emplace_back(c.m_nBall, c.m_nOther);
    m_stdPairs.emplace_back(c.m_nOther, c.m_nBall);
  }
  std::sort(m_stdPairs.begin(), m_stdPairs.end());
}

double CRestingContacts::GetDifference(const CRow& row) const {
  return row.m_vNorm.dot(m_stdVels[row.m_nBall] - m_stdVels[row.m_nOther]);
}

void CRestingContacts::Push(const CRow& row, double impulse) {
  m_stdVels[row.m_nBall] += impulse * row.m_fInverse * row.m_vNorm;
  m_stdVels[row.m_nOther] -= impulse * row.m_fOtherInverse * row.m_vNorm;
}

// Returns the velocity by which it was changed.
double CRestingContacts::Relax(CRow& row) {
  const double before = row.m_fImpulse;
  row.m_fImpulse = std::max(0.0, before + row.m_fShare * (row.m_fLeast - GetDifference(row)));
  const double change = row.m_fImpulse - before;
  if (change != 0.0) Push(row, change);
  return std::abs(change) * (row.m_fInverse + row.m_fOtherInverse);
}

CRestingContacts::CKnown* CRestingContacts::Find(std::vector<CKnown>& known, const CContact& c) {
  const auto it = std::lower_bound(known.begin(), known.end(), c.m_nPair,
                                   [](const CKnown& k, std::uint64_t pair) { return k.m_nPair < pair; });
  return it != known.end() && it->m_nPair == c.m_nPair ? &*it : nullptr;
}

// Both ways; returns the largest change of a velocity on the way back.
double CRestingContacts::RelaxAll(CPile pile) {
  for (CRow& row : pile)
    row.m_fBefore = row.m_fImpulse;
  for (CRow& row : pile)
    Relax(row);
  double most = 0.0;
  for (auto it = pile.rbegin(); it != pile.rend(); ++it)
    most = std::max(most, Relax(*it));
  return most;
}

// On in the direction of the round before, as far as what is left has become smaller. Returns the square of
// the change of this round.
double CRestingContacts::GoOn(CPile pile, double squareBefore) {
  double square = 0.0;
  for (const CRow& row : pile)
    square += (row.m_fImpulse - row.m_fBefore) * (row.m_fImpulse - row.m_fBefore) / row.m_fShare;
  const double on = square < squareBefore ? square / squareBefore : 0.0;
  for (CRow& row : pile) {
    const double more = on * row.m_fWay;
    row.m_fWay = row.m_fImpulse - row.m_fBefore + more;
    row.m_fImpulse += more;
    if (more != 0.0) Push(row, more);
  }
  return square;
}

void CRestingContacts::Iterate(CPile pile) {
  double fastest = 0.0; // squared
  for (const CRow& row : pile)
    for (const std::uint32_t i : {row.m_nBall, row.m_nOther})
      fastest = std::max(fastest, m_stdVels[i].squaredNorm());
  const double flow = std::max(0.0, std::sqrt(fastest) - 0.5 * m_fSlow);
  const double accurate = std::max(g_fRestingError * m_fSlow, g_fFlowError * flow);
  for (const CRow& row : pile)
    if (row.m_fImpulse > 0.0) Push(row, row.m_fImpulse);
  double most = RelaxAll(pile), square = 0.0;
  for (int round = 1; most > accurate && round < g_nRestingRounds; ++round) {
    square = GoOn(pile, square);
    most = RelaxAll(pile);
  }
  // Each lower one as if it were the ground, as far as the rounds have not come to an end. Shapes last: no
  // ball is pressed into one by others.
  const auto stop = [&](const CRow& row) {
    const double now = GetDifference(row);
    if (now < row.m_fLeast) m_stdVels[row.m_nBall] += (row.m_fLeast - now) * row.m_vNorm;
  };
  for (int round = 0; most > g_fShock * accurate && round < g_nShockRounds; ++round)
    for (const CRow& row : pile)
      stop(row);
  // Between what comes upon it and what gives no way a ball would leave at the speed of that over the sine of
  // the angle between them, which is small for an instant only.
  double limit = std::sqrt(fastest);
  for (const CRow& row : pile)
    limit = std::max(limit, g_fSqueezed * std::abs(row.m_fSurface));
  limit += m_fSlow;
  for (const CRow& row : pile)
    for (const std::uint32_t i : {row.m_nBall, row.m_nOther})
      if (const double speed = Norm(m_stdVels[i]); speed > limit) m_stdVels[i] *= limit / speed;
  for (int round = 0; round < g_nWedgeRounds; ++round)
    for (const CRow& row : pile)
      if (row.m_fOtherInverse == 0.0) stop(row);
}

void CRestingContacts::Solve(std::vector<CMoving>& balls) {
  const double dt = m_fStep;
  const auto nobody = static_cast<std::uint32_t>(balls.size()); // a shape: with a velocity that stays zero
  m_stdVels.resize(balls.size() + 1);
  m_stdVels[nobody] = Vector2d::Zero();
  m_stdRows.clear();
  const auto accelerate = [&](std::uint32_t i) { m_stdVels[i] = balls[i].m_vVel + m_vGravity * dt; };
  for (const CContact& c : m_stdContacts) {
    CRow row;
    row.m_nBall = c.m_nBall;
    row.m_nOther = c.m_bIsBall ? c.m_nOther : nobody;
    row.m_vNorm = c.m_vNorm;
    row.m_fInverse = 1.0 / balls[c.m_nBall].m_fMass;
    row.m_fOtherInverse = c.m_bIsBall ? 1.0 / balls[c.m_nOther].m_fMass : 0.0;
    row.m_fShare = 1.0 / (row.m_fInverse + row.m_fOtherInverse);
    row.m_fSurface = c.m_fSpeed;
    row.m_fLeast = c.m_fSpeed - 0.5 * c.m_fBend * dt - std::max(0.0, c.m_fGap) / dt;
    const CKnown* const pKnown = Find(m_stdKnown, c);
    row.m_fImpulse = pKnown != nullptr ? pKnown->m_fImpulse : 0.0;
    m_stdRows.push_back(row);
    accelerate(c.m_nBall);
    if (c.m_bIsBall) accelerate(c.m_nOther);
  }
  for (std::size_t begin = 0; begin < m_stdRows.size();) {
    std::size_t end = begin + 1;
    while (end < m_stdRows.size() && FindRoot(m_stdRows[end].m_nBall) == FindRoot(m_stdRows[begin].m_nBall))
      ++end;
    Iterate(CPile(m_stdRows).subspan(begin, end - begin));
    begin = end;
  }
  const auto take = [&](std::uint32_t i) {
    balls[i].m_vVel = m_stdVels[i];
    balls[i].m_vFall = balls[i].m_vAcc = Vector2d::Zero(); // gravity has been there
    balls[i].m_bIsMoved = true;
  };
  for (std::size_t k = 0; k < m_stdContacts.size(); ++k) {
    CContact& c = m_stdContacts[k];
    c.m_fImpulse = m_stdRows[k].m_fImpulse;
    take(c.m_nBall);
    if (c.m_bIsBall) take(c.m_nOther);
    if (!(c.m_fImpulse > 0.0)) continue;
    Find(m_stdNear, c)->m_fImpulse = c.m_fImpulse;
    CMoving& ball = balls[c.m_nBall];
    if (!c.m_bIsBall)
      ball.m_cHolds.Add(
          {c.m_nOther, false, c.m_vNorm, c.m_fSpeed, 0.0, std::abs(c.m_fRadius + ball.m_fRadius)});
  }
}

} // namespace Shapes::Native
