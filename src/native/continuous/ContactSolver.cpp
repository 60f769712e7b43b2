// SPDX-License-Identifier: MIT
#include "ContactSolver.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace Shapes::Native {

using Geometry::Norm;

// With zeros. An assignment would allocate anew for each larger pile.
template <class T>
static void Fill(std::vector<T>& list, std::size_t n) {
  list.clear();
  list.resize(n);
}

void CContactSolver::Begin() {
  m_stdRows.clear();
  m_stdImpulses.clear();
  m_stdVels.clear();
  m_bIsPushed = false;
  for (std::uint32_t shape = g_nShape; shape <= g_nPushingShape; ++shape)
    AddBall(Vector2d::Zero());
}

std::uint32_t CContactSolver::AddBall(const Vector2d& vel) {
  m_stdVels.push_back(vel);
  return static_cast<std::uint32_t>(m_stdVels.size() - 1);
}

void CContactSolver::Add(const CRow& row, double impulse) {
  m_stdRows.push_back(row);
  m_stdImpulses.push_back(impulse);
  m_bIsPushed |= row.m_nOther == g_nPushingShape;
}

// By level: a row comes after those before it that share a ball with it, so that a round has the same bits as
// one in the order of the rows (level scheduling, as triangular systems are solved).
void CContactSolver::MakePairs() {
  const std::size_t n = m_stdRows.size();
  Fill(m_stdLevels, m_stdVels.size()); // of the next row of a ball; nothing changes a shape, which stays at 0
  Fill(m_stdEnds, n);                  // of a level: how many rows it has, then the place of its next one
  m_stdPlaces.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    std::uint32_t& ball = m_stdLevels[m_stdRows[k].m_nBall];
    std::uint32_t& other = m_stdLevels[m_stdRows[k].m_nOther];
    const std::uint32_t level = std::max(ball, other);
    ++m_stdEnds[level];
    m_stdPlaces[k] = level;
    ball = level + 1;
    if (m_stdRows[k].m_nOther > g_nPushingShape) other = level + 1;
  }
  std::uint32_t places = 0;
  for (std::size_t level = 0; level < n && m_stdEnds[level] > 0; ++level) {
    const std::uint32_t count = std::exchange(m_stdEnds[level], places);
    places += count + count % 2;
  }
  Fill(m_stdPairs, places / 2);
  for (std::size_t k = 0; k < n; ++k) {
    m_stdPlaces[k] = m_stdEnds[m_stdPlaces[k]]++;
    const std::uint32_t which = m_stdPlaces[k] % 2;
    const CRow& row = m_stdRows[k];
    CRowPair& pair = m_stdPairs[m_stdPlaces[k] / 2];
    const double inverse = row.m_fInverse + row.m_fOtherInverse;
    const Vector2d lack = row.m_vNorm / inverse;
    const Vector2d ball = row.m_fInverse * row.m_vNorm, other = row.m_fOtherInverse * row.m_vNorm;
    pair.m_vLackX[which] = lack.x(), pair.m_vLackY[which] = lack.y();
    pair.m_vLeast[which] = row.m_fLeast / inverse;
    pair.m_vBallX[which] = ball.x(), pair.m_vBallY[which] = ball.y();
    pair.m_vOtherX[which] = other.x(), pair.m_vOtherY[which] = other.y();
    pair.m_vInverse[which] = inverse;
    pair.m_vImpulse[which] = m_stdImpulses[k];
    pair.m_nBall[which] = row.m_nBall;
    pair.m_nOther[which] = row.m_nOther;
  }
}

// On by this share of what the last round has changed: the velocities depend on the impulses linearly. Then a
// round that gives each contact this part of what it lacks.
CContactSolver::CChange CContactSolver::Relax(double share, double part) {
  CTwo *const pVels = GetTwos(m_stdVels), *const pBefore = GetTwos(m_stdVelsBefore);
  for (std::size_t k = 0, n = m_stdVels.size(); k < n; ++k) {
    const CTwo more = share * (pVels[k] - pBefore[k]);
    pBefore[k] = pVels[k];
    pVels[k] += more;
  }
  CTwo most{}, least{}, back{};
  for (CRowPair& pair : m_stdPairs) {
    const CTwo last = pair.m_vImpulse, now = last + share * (last - pair.m_vBefore);
    const CTwo more = pair.Relax(part, now, pVels);
    const CTwo next = now + more, change = more * pair.m_vInverse;
    pair.m_vBefore = last;
    pair.m_vImpulse = next;
    most = Max(most, change);
    least = Min(least, change);
    back -= change * (next - last);
  }
  most = Max(most, -least);
  return {std::max(most[0], most[1]), back[0] + back[1]};
}

// Whether no velocities up to this speed fulfil all contacts. For those that do, and any impulses that push,
// the sum of impulse * least over the contacts is at most that of |momentum| * speed over the balls (the
// lemma of Farkas 1902). Where there are none impulses grow for ever, and what the last round has changed
// tells it.
bool CContactSolver::IsImpossible(double speed) {
  m_stdMomenta.clear();
  m_stdMomenta.resize(m_stdVels.size(), Vector2d::Zero());
  double least = 0.0, most = 0.0;
  for (std::size_t k = 0; k < m_stdRows.size(); ++k) {
    const CRow& row = m_stdRows[k];
    const CRowPair& pair = m_stdPairs[m_stdPlaces[k] / 2];
    const std::size_t which = m_stdPlaces[k] % 2;
    const double impulse = std::max(0.0, pair.m_vImpulse[which] - pair.m_vBefore[which]);
    least += impulse * row.m_fLeast;
    m_stdMomenta[row.m_nBall] += impulse * row.m_vNorm;
    m_stdMomenta[row.m_nOther] -= impulse * row.m_vNorm;
  }
  for (std::size_t ball = g_nPushingShape + 1; ball < m_stdMomenta.size(); ++ball)
    most += speed * Norm(m_stdMomenta[ball]);
  return least > most;
}

// Returns how much the last round has changed a velocity.
double CContactSolver::Search(double accurate, double limit, std::size_t rounds) {
  MakePairs();
  for (std::size_t k = 0; k < m_stdRows.size(); ++k) {
    const CRow& row = m_stdRows[k];
    m_stdVels[row.m_nBall] += m_stdImpulses[k] * row.m_fInverse * row.m_vNorm;
    m_stdVels[row.m_nOther] -= m_stdImpulses[k] * row.m_fOtherInverse * row.m_vNorm;
  }
  m_stdVelsBefore.resize(m_stdVels.size());
  std::copy(m_stdVels.begin(), m_stdVels.end(), m_stdVelsBefore.begin());
  CChange change = Relax(0.0, 1.0);
  const double most = g_fMostGrowth * change.m_fMost;
  bool isGrowing = false;
  double momentum = 1.0;
  for (std::size_t round = 1; change.m_fMost > accurate && round < rounds; ++round) {
    isGrowing |= change.m_fMost > most;
    if (change.m_fBack > 0.0 || isGrowing) momentum = 1.0;
    const double next = 0.5 + std::sqrt(0.25 + momentum * momentum);
    change = Relax((momentum - 1.0) / next, momentum > 1.0 ? g_fRelaxation : 1.0);
    momentum = next;
    if (m_bIsPushed && round >= g_nPossibleRounds && std::has_single_bit(round) && IsImpossible(limit)) break;
  }
  return change.m_fMost;
}

// The other one does not give way. Returns whether it changes anything.
bool CContactSolver::Stop(const CRow& row) {
  const double now = row.m_vNorm.dot(m_stdVels[row.m_nBall] - m_stdVels[row.m_nOther]);
  if (!(now < row.m_fLeast)) return false;
  m_stdVels[row.m_nBall] += (row.m_fLeast - now) * row.m_vNorm;
  return true;
}

bool CContactSolver::StopAt(std::uint32_t shape) {
  bool isAny = false;
  for (const CRow& row : m_stdRows)
    if (row.m_nOther == shape && Stop(row)) isAny = true;
  return isAny;
}

// Shapes last: no ball is pressed into one by others, nor into one that stays by one that comes upon it.
void CContactSolver::StopAtShapes() {
  bool isChanging = m_bIsPushed;
  for (int round = 0; isChanging && round < g_nWedgeRounds; ++round) {
    isChanging = StopAt(g_nPushingShape);
    isChanging |= StopAt(g_nShape);
  }
  isChanging = true;
  for (int round = 0; isChanging && round < g_nWedgeRounds; ++round)
    isChanging = StopAt(g_nShape);
  if (isChanging && m_bIsPushed) StopInWedges();
}

// Where a shape pushes a ball between others that do not, to whose crossing those rounds come slowly where it
// is narrow: a ball that may stay in its place goes no farther than each of them lets it.
void CContactSolver::StopInWedges() {
  const auto mayStay = [this](std::uint32_t ball) {
    return std::none_of(m_stdRows.begin(), m_stdRows.end(), [=](const CRow& row) {
      return row.m_nBall == ball && row.m_nOther == g_nShape && row.m_fLeast > 0.0;
    });
  };
  for (const CRow& row : m_stdRows) {
    if (row.m_nOther != g_nShape) continue;
    Vector2d& v = m_stdVels[row.m_nBall];
    const double now = row.m_vNorm.dot(v), rounding = static_cast<double>(g_fTouchRounding) * Norm(v);
    if (row.m_fLeast - now > rounding && mayStay(row.m_nBall)) v *= row.m_fLeast / now;
  }
}

double CContactSolver::GetFlowError(double fastest, double slow) {
  return g_fFlowError * std::max(0.0, fastest - 0.5 * slow);
}

void CContactSolver::Solve(double slow, double surface) {
  double fastest = 0.0; // squared
  for (const Vector2d& v : m_stdVels)
    fastest = std::max(fastest, v.squaredNorm());
  const double resting = g_fRestingError * slow, error = GetFlowError(std::sqrt(fastest), slow);
  const double accurate = std::max(resting, error);
  const std::size_t rounds = error > resting ? g_nFlowRounds : g_nRestingRounds;
  // Between what comes upon it and what gives no way a ball would leave at the speed of that over the sine of
  // the angle between them, which is small for an instant only.
  const double limit = std::max(std::sqrt(fastest), g_fSqueezed * surface + slow);
  // Each lower one as if it were the ground, as far as the rounds have not come to an end.
  if (Search(accurate, limit, rounds) > g_fShock * accurate)
    for (int round = 0; round < g_nShockRounds; ++round)
      for (const CRow& row : m_stdRows)
        Stop(row);
  for (Vector2d& v : m_stdVels)
    if (const double speed = Norm(v); speed > limit) v *= limit / speed;
  StopAtShapes();
}

void CContactSolver::Separate(double accurate, double limit, std::size_t rounds) {
  Search(accurate, limit, rounds);
  StopAtShapes();
}

} // namespace Shapes::Native
