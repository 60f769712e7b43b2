// SPDX-License-Identifier: MIT
#include "ContactSolver.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Native {

using Geometry::Norm;

void CContactSolver::Begin() {
  m_stdRows.clear();
  m_cImpulses.Clear();
  m_cVels.Clear();
  AddBall(Vector2d::Zero()); // g_nShape
}

std::uint32_t CContactSolver::AddBall(const Vector2d& vel) {
  m_cVels.Add(vel);
  return static_cast<std::uint32_t>(m_cVels.m_stdNow.size() - 1);
}

void CContactSolver::Add(const CRow& row, double impulse) {
  m_stdRows.push_back(row);
  m_cImpulses.Add(impulse);
}

// Of arrays, whose places need not be looked up again after each change.
inline double CContactSolver::GetDifference(const CRow& row, const Vector2d* pVels) {
  return row.m_vNorm.dot(pVels[row.m_nBall] - pVels[row.m_nOther]);
}

inline void CContactSolver::Push(const CRow& row, double impulse, Vector2d* pVels) {
  pVels[row.m_nBall] += (impulse * row.m_fInverse) * row.m_vNorm;
  pVels[row.m_nOther] -= (impulse * row.m_fOtherInverse) * row.m_vNorm;
}

// Returns what it adds to the impulse.
inline double CContactSolver::Relax(const CRow& row, double& impulse, Vector2d* pVels) {
  const double before = impulse;
  impulse = std::max(0.0, before + row.m_fShare * (row.m_fLeast - GetDifference(row, pVels)));
  // Without a branch, as it cannot be foreseen which rows change.
  Push(row, impulse - before, pVels);
  return impulse - before;
}

// Both ways.
CContactSolver::CChange CContactSolver::RelaxAll() {
  const std::span<const CRow> rows = m_stdRows;
  double* const pImpulses = m_cImpulses.m_stdNow.data();
  const double* const pBefore = m_cImpulses.m_stdBefore.data();
  Vector2d* const pVels = m_cVels.m_stdNow.data();
  for (std::size_t k = 0; k < rows.size(); ++k)
    Relax(rows[k], pImpulses[k], pVels);
  CChange change{0.0, 0.0};
  for (std::size_t k = rows.size(); k-- > 0;) {
    const double mass = rows[k].m_fInverse + rows[k].m_fOtherInverse; // inverse
    change.m_fMost = std::max(change.m_fMost, std::abs(Relax(rows[k], pImpulses[k], pVels)) * mass);
    const double round = pImpulses[k] - pBefore[k];
    change.m_fSquare += round * round * mass;
  }
  return change;
}

// The other one does not give way.
void CContactSolver::Stop(const CRow& row) {
  const double now = GetDifference(row, m_cVels.m_stdNow.data());
  if (now < row.m_fLeast) m_cVels.m_stdNow[row.m_nBall] += (row.m_fLeast - now) * row.m_vNorm;
}

void CContactSolver::Solve(double slow, double surface) {
  double fastest = 0.0; // squared
  for (const Vector2d& v : m_cVels.m_stdNow)
    fastest = std::max(fastest, v.squaredNorm());
  const double flow = std::max(0.0, std::sqrt(fastest) - 0.5 * slow);
  const double accurate = std::max(g_fRestingError * slow, g_fFlowError * flow);
  for (std::size_t k = 0; k < m_stdRows.size(); ++k)
    Push(m_stdRows[k], GetImpulse(k), m_cVels.m_stdNow.data());
  m_cImpulses.Begin(0.0);
  m_cVels.Begin(Vector2d::Zero());
  CChange change = RelaxAll();
  double squareBefore = 0.0;
  for (int round = 1; change.m_fMost > accurate && round < g_nRestingRounds; ++round) {
    // As far as what is left has become smaller. The velocities depend on the impulses linearly.
    const double growth = squareBefore > 0.0 ? change.m_fSquare / squareBefore : 0.0;
    const double share = growth > g_fMostGrowth ? 0.0 : std::min(growth, 1.0);
    m_cImpulses.GoOn(share);
    m_cVels.GoOn(share);
    squareBefore = change.m_fSquare;
    change = RelaxAll();
  }
  // Each lower one as if it were the ground, as far as the rounds have not come to an end. Shapes last: no
  // ball is pressed into one by others.
  for (int round = 0; change.m_fMost > g_fShock * accurate && round < g_nShockRounds; ++round)
    for (const CRow& row : m_stdRows)
      Stop(row);
  // Between what comes upon it and what gives no way a ball would leave at the speed of that over the sine of
  // the angle between them, which is small for an instant only.
  const double limit = std::max(std::sqrt(fastest), g_fSqueezed * surface) + slow;
  for (Vector2d& v : m_cVels.m_stdNow)
    if (const double speed = Norm(v); speed > limit) v *= limit / speed;
  for (int round = 0; round < g_nWedgeRounds; ++round)
    for (const CRow& row : m_stdRows)
      if (row.m_nOther == g_nShape) Stop(row);
}

} // namespace Shapes::Native
