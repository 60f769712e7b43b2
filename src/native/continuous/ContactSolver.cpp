// SPDX-License-Identifier: MIT
#include "ContactSolver.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Native {

using Geometry::Norm;

double CContactSolver::GetDifference(const CRow& row) const {
  return row.m_vNorm.dot(m_stdVels[row.m_nBall] - m_stdVels[row.m_nOther]);
}

void CContactSolver::Push(const CRow& row, double impulse) {
  m_stdVels[row.m_nBall] += impulse * row.m_fInverse * row.m_vNorm;
  m_stdVels[row.m_nOther] -= impulse * row.m_fOtherInverse * row.m_vNorm;
}

// Returns the velocity by which it was changed.
double CContactSolver::Relax(CRow& row) {
  const double before = row.m_fImpulse;
  row.m_fImpulse = std::max(0.0, before + row.m_fShare * (row.m_fLeast - GetDifference(row)));
  const double change = row.m_fImpulse - before;
  if (change != 0.0) Push(row, change);
  return std::abs(change) * (row.m_fInverse + row.m_fOtherInverse);
}

// Both ways; returns the largest change of a velocity on the way back.
double CContactSolver::RelaxAll(CPile pile) {
  for (CRow& row : pile)
    Relax(row);
  double most = 0.0;
  for (auto it = pile.rbegin(); it != pile.rend(); ++it)
    most = std::max(most, Relax(*it));
  return most;
}

// On in the direction of the round before, as far as what is left has become smaller. Returns the square of
// the change of this round.
double CContactSolver::GoOn(CPile pile, double squareBefore) {
  double square = 0.0;
  for (std::size_t k = 0; k < pile.size(); ++k) {
    const double change = pile[k].m_fImpulse - m_stdWays[k].m_fBefore;
    square += change * change / pile[k].m_fShare;
  }
  const double on = square < squareBefore ? square / squareBefore : 0.0;
  for (std::size_t k = 0; k < pile.size(); ++k) {
    CRow& row = pile[k];
    CWay& way = m_stdWays[k];
    const double more = on * way.m_fOn;
    way.m_fOn = row.m_fImpulse - way.m_fBefore + more;
    row.m_fImpulse += more;
    way.m_fBefore = row.m_fImpulse;
    if (more != 0.0) Push(row, more);
  }
  return square;
}

// The other one does not give way.
void CContactSolver::Stop(const CRow& row) {
  const double now = GetDifference(row);
  if (now < row.m_fLeast) m_stdVels[row.m_nBall] += (row.m_fLeast - now) * row.m_vNorm;
}

void CContactSolver::Solve(CPile pile, double slow, double surface) {
  double fastest = 0.0; // squared
  m_stdWays.clear();
  for (const CRow& row : pile) {
    for (const std::uint32_t i : {row.m_nBall, row.m_nOther})
      fastest = std::max(fastest, m_stdVels[i].squaredNorm());
    m_stdWays.push_back({row.m_fImpulse, 0.0});
  }
  const double flow = std::max(0.0, std::sqrt(fastest) - 0.5 * slow);
  const double accurate = std::max(g_fRestingError * slow, g_fFlowError * flow);
  for (const CRow& row : pile)
    if (row.m_fImpulse > 0.0) Push(row, row.m_fImpulse);
  double most = RelaxAll(pile), square = 0.0;
  for (int round = 1; most > accurate && round < g_nRestingRounds; ++round) {
    square = GoOn(pile, square);
    most = RelaxAll(pile);
  }
  // Each lower one as if it were the ground, as far as the rounds have not come to an end. Shapes last: no
  // ball is pressed into one by others.
  for (int round = 0; most > g_fShock * accurate && round < g_nShockRounds; ++round)
    for (const CRow& row : pile)
      Stop(row);
  // Between what comes upon it and what gives no way a ball would leave at the speed of that over the sine of
  // the angle between them, which is small for an instant only.
  const double limit = std::max(std::sqrt(fastest), g_fSqueezed * surface) + slow;
  for (const CRow& row : pile)
    for (const std::uint32_t i : {row.m_nBall, row.m_nOther})
      if (const double speed = Norm(m_stdVels[i]); speed > limit) m_stdVels[i] *= limit / speed;
  for (int round = 0; round < g_nWedgeRounds; ++round)
    for (const CRow& row : pile)
      if (row.m_fOtherInverse == 0.0) Stop(row);
}

} // namespace Shapes::Native
