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
  for (std::uint32_t shape = g_nShape; shape <= g_nPushingShape; ++shape)
    AddBall(Vector2d::Zero());
}

std::uint32_t CContactSolver::AddBall(const Vector2d& vel) {
  m_cVels.Add(vel);
  return static_cast<std::uint32_t>(m_cVels.m_stdNow.size() - 1);
}

void CContactSolver::Add(const CRow& row, double impulse) {
  m_stdRows.push_back(row);
  m_stdRows.back().m_fShare = 1.0 / (row.m_fInverse + row.m_fOtherInverse);
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

// A round that gives each contact this part of what it lacks.
CContactSolver::CChange CContactSolver::Relax(double part) {
  double* const pImpulses = m_cImpulses.m_stdNow.data();
  const double* const pBefore = m_cImpulses.m_stdBefore.data();
  Vector2d* const pVels = m_cVels.m_stdNow.data();
  CChange change{0.0, 0.0};
  for (std::size_t k = 0; k < m_stdRows.size(); ++k) {
    const CRow& row = m_stdRows[k];
    const double now = pImpulses[k];
    // No impulse pulls. Without a branch, as it cannot be foreseen which rows change.
    const double wanted = now + part * row.m_fShare * (row.m_fLeast - GetDifference(row, pVels));
    const double next = 0.5 * (wanted + std::abs(wanted));
    const double more = next - now, mass = row.m_fInverse + row.m_fOtherInverse; // inverse
    pImpulses[k] = next;
    Push(row, more, pVels);
    change.m_fMost = std::max(change.m_fMost, std::abs(more) * mass);
    change.m_fBack -= more * (next - pBefore[k]) * mass;
  }
  return change;
}

// Returns how much the last round has changed a velocity.
double CContactSolver::Search(double accurate, std::size_t rounds) {
  for (std::size_t k = 0; k < m_stdRows.size(); ++k)
    Push(m_stdRows[k], GetImpulse(k), m_cVels.m_stdNow.data());
  m_cImpulses.Begin();
  m_cVels.Begin();
  CChange change = Relax(1.0);
  const double most = g_fMostGrowth * change.m_fMost;
  bool isGrowing = false;
  double momentum = 1.0;
  for (std::size_t round = 1; change.m_fMost > accurate && round < rounds; ++round) {
    isGrowing |= change.m_fMost > most;
    if (change.m_fBack > 0.0 || isGrowing) momentum = 1.0;
    const double next = 0.5 + std::sqrt(0.25 + momentum * momentum);
    // The velocities depend on the impulses linearly.
    m_cImpulses.GoOn((momentum - 1.0) / next);
    m_cVels.GoOn((momentum - 1.0) / next);
    change = Relax(momentum > 1.0 ? g_fRelaxation : 1.0);
    momentum = next;
  }
  return change.m_fMost;
}

// The other one does not give way.
void CContactSolver::Stop(const CRow& row) {
  const double now = GetDifference(row, m_cVels.m_stdNow.data());
  if (now < row.m_fLeast) m_cVels.m_stdNow[row.m_nBall] += (row.m_fLeast - now) * row.m_vNorm;
}

void CContactSolver::StopAt(std::uint32_t shape) {
  for (const CRow& row : m_stdRows)
    if (row.m_nOther == shape) Stop(row);
}

// Shapes last: no ball is pressed into one by others, nor into one that stays by one that comes upon it.
void CContactSolver::StopAtShapes() {
  const bool anyPushes = std::any_of(m_stdRows.begin(), m_stdRows.end(),
                                     [](const CRow& row) { return row.m_nOther == g_nPushingShape; });
  for (int round = 0; anyPushes && round < g_nWedgeRounds; ++round) {
    StopAt(g_nPushingShape);
    StopAt(g_nShape);
  }
  for (int round = 0; round < g_nWedgeRounds; ++round)
    StopAt(g_nShape);
}

double CContactSolver::GetFlowError(double fastest, double slow) {
  return g_fFlowError * std::max(0.0, fastest - 0.5 * slow);
}

void CContactSolver::Solve(double slow, double surface) {
  double fastest = 0.0; // squared
  for (const Vector2d& v : m_cVels.m_stdNow)
    fastest = std::max(fastest, v.squaredNorm());
  const double accurate = std::max(g_fRestingError * slow, GetFlowError(std::sqrt(fastest), slow));
  // Each lower one as if it were the ground, as far as the rounds have not come to an end.
  if (Search(accurate, g_nRestingRounds) > g_fShock * accurate)
    for (int round = 0; round < g_nShockRounds; ++round)
      for (const CRow& row : m_stdRows)
        Stop(row);
  // Between what comes upon it and what gives no way a ball would leave at the speed of that over the sine of
  // the angle between them, which is small for an instant only.
  const double limit = std::max(std::sqrt(fastest), g_fSqueezed * surface + slow);
  for (Vector2d& v : m_cVels.m_stdNow)
    if (const double speed = Norm(v); speed > limit) v *= limit / speed;
  StopAtShapes();
}

void CContactSolver::Separate(double accurate, std::size_t rounds) {
  Search(accurate, rounds);
  StopAtShapes();
}

} // namespace Shapes::Native
