// SPDX-License-Identifier: MIT
#include "RestingContacts.h"

#include "../../Tolerances.h"
#include "Rounding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Shapes::Native {

void CRestingContacts::Begin(const Vector2d& gravity, double dt, double elasticity) {
  m_vGravity = gravity;
  m_vUp = -Unit(gravity, Vector2d::Zero());
  m_bIsFalling = !gravity.isZero(0.0);
  ++m_cMemory.m_nSubstep;
  m_fStep = dt;
  const double bounce = std::clamp(elasticity * elasticity, g_fLeastBounce, 1.0);
  const double speed = g_fRestingSteps * Norm(gravity) * dt;
  m_fSlow = speed / bounce;
  m_fReach = speed * dt;
  m_stdContacts.clear();
  m_stdFirst.clear();
  m_cPiles.Reset(0);
  m_stdEnergies.clear();
  m_stdKnown.swap(m_cMemory.m_stdNear);
  m_cMemory.m_stdNear.clear();
}

void CRestingContacts::Add(std::uint32_t ball, std::uint32_t other, bool isBall, CShapeId id,
                           CShapeId otherId, const CImpact& impact, double gap, bool mayHold) {
  CContact c;
  // Whichever of two balls comes first.
  const auto [first, second] = std::minmax(id.m_nValue, otherId.m_nValue);
  c.m_nPair = (std::uint64_t{first} << 32) | second;
  c.m_nBall = ball;
  c.m_nOther = other;
  c.m_bIsBall = isBall;
  c.m_bMayHold = mayHold;
  c.m_vNorm = impact.m_vNorm;
  c.m_fGap = gap;
  c.m_fSpeed = isBall ? 0.0 : GetPush(impact.m_vNorm, impact.m_vSurface);
  c.m_fRadius = impact.m_fRadius;
  // Of two balls gravity is none.
  c.m_fBend = -impact.m_fClosing - (isBall ? 0.0 : impact.m_vNorm.dot(m_vGravity));
  m_stdContacts.push_back(c);
}

// By their keys; those with the same key stay in their order.
void CRestingContacts::Sort() {
  m_stdOrder.clear();
  for (const CContact& c : m_stdContacts)
    m_stdOrder.emplace_back(c.m_fKey, static_cast<std::uint32_t>(m_stdOrder.size()));
  if (std::is_sorted(m_stdOrder.begin(), m_stdOrder.end())) return; // as of one pile
  std::sort(m_stdOrder.begin(), m_stdOrder.end());
  m_stdUnsorted.swap(m_stdContacts);
  m_stdContacts.clear();
  for (const auto& [key, k] : m_stdOrder)
    m_stdContacts.push_back(m_stdUnsorted[k]);
}

bool CRestingContacts::Has(std::uint32_t ball, std::uint32_t other) const {
  const std::span<const std::uint32_t> neighbours = GetNeighbours(ball);
  return std::find(neighbours.begin(), neighbours.end(), other) != neighbours.end();
}

std::span<const std::uint32_t> CRestingContacts::GetNeighbours(std::uint32_t ball) const {
  // A ball that came later has none.
  if (ball + 1 >= m_stdFirst.size()) return {};
  return std::span(m_stdNeighbours).subspan(m_stdFirst[ball], m_stdFirst[ball + 1] - m_stdFirst[ball]);
}

// Of the contacts that are left.
void CRestingContacts::FindNeighbours(std::size_t balls) {
  m_stdFirst.assign(balls + 2, 0);
  for (const CContact& c : m_stdContacts)
    if (c.m_bIsBall) ++m_stdFirst[c.m_nBall + 2], ++m_stdFirst[c.m_nOther + 2];
  std::partial_sum(m_stdFirst.begin(), m_stdFirst.end(), m_stdFirst.begin());
  m_stdNeighbours.resize(m_stdFirst.back());
  // Each begin moves to where the next one begins.
  for (const CContact& c : m_stdContacts)
    if (c.m_bIsBall) {
      m_stdNeighbours[m_stdFirst[c.m_nBall + 1]++] = c.m_nOther;
      m_stdNeighbours[m_stdFirst[c.m_nOther + 1]++] = c.m_nBall;
    }
  m_stdFirst.pop_back();
  for (std::size_t i = 0; i < balls; ++i)
    std::sort(m_stdNeighbours.begin() + m_stdFirst[i], m_stdNeighbours.begin() + m_stdFirst[i + 1]);
}

// Along the normal, of the velocities at the beginning, the surface's subtracted.
double CRestingContacts::GetSpeed(const CContact& c, const std::vector<CMoving>& balls) const {
  Vector2d v = balls[c.m_nBall].m_vVel;
  if (c.m_bIsBall) v -= balls[c.m_nOther].m_vVel;
  return c.m_vNorm.dot(v) - c.m_fSpeed;
}

// Those that were within reach in the last substep, too, with their impulses.
void CRestingContacts::FindKnown() {
  std::vector<CKnown>& pairs = m_cMemory.m_stdNear;
  for (std::uint32_t k = 0; k < m_stdContacts.size(); ++k)
    pairs.push_back({m_stdContacts[k].m_nPair, 0.0, k});
  std::sort(pairs.begin(), pairs.end(),
            [](const CKnown& a, const CKnown& b) { return a.m_nPair < b.m_nPair; });
  auto known = m_stdKnown.cbegin();
  for (std::uint32_t k = 0; k < pairs.size(); ++k) {
    const CKnown& near = pairs[k];
    while (known != m_stdKnown.cend() && known->m_nPair < near.m_nPair)
      ++known;
    CContact& c = m_stdContacts[near.m_nContact];
    c.m_nNear = k;
    if (known == m_stdKnown.cend() || known->m_nPair != near.m_nPair) continue;
    c.m_fImpulse = known->m_fImpulse;
    c.m_fApart = known->m_fApart;
  }
}

// Whether what is near each other rests on each other.
bool CRestingContacts::IsPair(const CContact& c, const std::vector<CMoving>& balls) const {
  const CMoving &ball = balls[c.m_nBall], &other = c.m_bIsBall ? balls[c.m_nOther] : ball;
  const bool isSqueezed = IsSqueezed(ball, other);
  const double speed = std::abs(GetSpeed(c, balls));
  FailIf(!c.m_bMayHold || (!isSqueezed && speed > m_fSlow));
  // A ball of a pile moves straight: a surface that curves towards it turns its velocity.
  const double inward = -0.5 * c.m_fBend * m_fStep * m_fStep, R = std::abs(c.m_fRadius + ball.m_fRadius);
  FailIf(!c.m_bIsBall && inward > g_fMostInward * R);
  return c.m_fGap <= GetReach(isSqueezed, speed, GetSmallerRadius(c, balls));
}

void CRestingContacts::NotePlaces(const std::vector<CMoving>& balls) {
  m_stdPlaces.clear();
  for (const CMoving& ball : balls)
    m_stdPlaces.push_back(ball.m_vPos);
}

// Now, along the normal.
double CRestingContacts::GetGap(const CContact& c, const std::vector<CMoving>& balls) const {
  Vector2d way = balls[c.m_nBall].m_vPos - m_stdPlaces[c.m_nBall];
  if (c.m_bIsBall) way -= balls[c.m_nOther].m_vPos - m_stdPlaces[c.m_nOther];
  return c.m_fGap + c.m_vNorm.dot(way);
}

void CRestingContacts::FindPiles(std::vector<CMoving>& balls) {
  std::erase_if(m_stdContacts, [&](const CContact& c) { return !IsPair(c, balls); });
  m_cPiles.Reset(balls.size());
  for (const CContact& c : m_stdContacts)
    if (c.m_bIsBall) m_cPiles.Join(c.m_nBall, c.m_nOther);
  m_stdIsHeld.assign(balls.size(), false);
  const auto holds = [this](const CMoving& b) { return m_bIsFalling ? b.IsSteered() : b.m_bWasSqueezed; };
  for (const CContact& c : m_stdContacts) {
    const CMoving &ball = balls[c.m_nBall], &other = c.m_bIsBall ? balls[c.m_nOther] : ball;
    if ((m_bIsFalling && !c.m_bIsBall) || holds(ball) || holds(other))
      m_stdIsHeld[m_cPiles.Find(c.m_nBall)] = true;
  }
  std::erase_if(m_stdContacts, [&](const CContact& c) { return !m_stdIsHeld[m_cPiles.Find(c.m_nBall)]; });
  for (CContact& c : m_stdContacts)
    c.m_fKey = static_cast<double>(m_cPiles.Find(c.m_nBall));
  Sort();
  for (const CContact& c : m_stdContacts) {
    balls[c.m_nBall].m_bIsInPile = true;
    if (c.m_bIsBall) balls[c.m_nOther].m_bIsInPile = true;
  }
  FindNeighbours(balls.size());
}

void CRestingContacts::SetSlow(const std::vector<CMoving>& balls) {
  if (m_bIsFalling) return;
  double fastest = 0.0; // squared
  for (const CMoving& ball : balls)
    if (ball.m_bWasSqueezed) fastest = std::max(fastest, ball.m_vVel.squaredNorm());
  m_fSlow = g_fFlowError * std::sqrt(fastest);
  m_fReach = m_fSlow * m_fStep;
}

void CRestingContacts::ForgetBall(std::size_t ball) {
  std::vector<CLast>& last = m_cMemory.m_stdLast;
  if (ball < last.size()) last.erase(last.begin() + static_cast<std::ptrdiff_t>(ball));
}

void CRestingContacts::Remember(const std::vector<CMoving>& balls, std::size_t size) {
  m_cMemory.m_stdLast.resize(size);
  m_cMemory.m_bIsAnySqueezed = m_cMemory.m_bIsShapePut = false;
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const CMoving& ball = balls[i];
    // One that was taken late has no pile.
    const CEnergy pile = i < m_stdEnergies.size() ? m_stdEnergies[m_cPiles.Find(i)] : CEnergy();
    const bool isJammed = m_bIsFalling ? ball.m_bIsNearBall : ball.m_bIsHalted || pile.m_bIsSteered;
    // An elastic ball goes on bouncing, unless a shape or a game presses it.
    const bool isElastic = ball.m_fElasticity >= 1.0 && ball.m_nLastMoving == g_nNobody && !pile.m_bIsMoved &&
                           ball.m_nSteered == 0 && !pile.m_bIsSteered;
    const bool isHit = ball.m_nImpacts >= g_nSqueezed && isJammed;
    // One that flies far may be hit as often.
    const bool isFast = m_bIsFalling && Norm(ball.m_vVel) * m_fStep > ball.m_fRadius;
    const bool stays = ball.m_bWasSqueezed && (pile.m_bIsMoved || pile.m_bIsSteered || ball.m_bPresses);
    const bool isSqueezed = !isFast && !isElastic && (isHit || stays);
    const unsigned steered = ball.m_nSteered > 0 ? ball.m_nSteered - 1 : 0;
    m_cMemory.m_stdLast[ball.m_nBall] = {ToFloat(ball.m_vVel), m_cMemory.m_nSubstep,
                                         static_cast<std::uint16_t>(steered), isSqueezed};
    m_cMemory.m_bIsAnySqueezed |= isSqueezed;
  }
}

unsigned CRestingContacts::GetSteered(std::size_t ball, const Vector2d& vel) const {
  FailIf(!WasThere(ball));
  const CLast& known = m_cMemory.m_stdLast[ball];
  const Vector2d last = known.m_vVel.cast<double>();
  const double least = std::max(Norm(m_vGravity) * m_fStep, g_fSteered * Norm(last));
  return Norm(vel - last) > least ? m_nSubsteps : known.m_nSteered;
}

// With the share s of the velocities the pile has gained nothing where kinetic s^2 - fall s = before.
double CRestingContacts::CEnergy::GetShare() const {
  if (m_bIsMoved || m_fKinetic - m_fFall <= m_fBefore || !(m_fKinetic > 0.0)) return 1.0;
  const double root = std::sqrt(std::max(0.0, m_fFall * m_fFall + 4.0 * m_fKinetic * m_fBefore));
  return std::clamp((m_fFall + root) / (2.0 * m_fKinetic), 0.0, 1.0);
}

void CRestingContacts::Solve(std::vector<CMoving>& balls) {
  m_stdSolved.assign(balls.size(), g_nNobody);
  m_stdEnergies.assign(balls.size(), {});
  ForEachInPile(balls, [&](CMoving& ball, CEnergy& pile, double lift) {
    pile.m_fBefore += ball.GetKinetic() - lift;
    ball.m_vGiven = -ball.m_vVel / m_fStep;
  });
  for (std::size_t begin = 0, end = 0; begin < m_stdContacts.size(); begin = end) {
    const std::uint32_t root = m_cPiles.Find(m_stdContacts[begin].m_nBall);
    while (end < m_stdContacts.size() && m_cPiles.Find(m_stdContacts[end].m_nBall) == root)
      ++end;
    SolvePile(std::span(m_stdContacts).subspan(begin, end - begin), balls);
  }
  ForEachInPile(balls, [&](CMoving& ball, CEnergy& pile, double) {
    pile.m_fKinetic += ball.GetKinetic();
    pile.m_fFall += ball.m_fMass * m_fStep * m_vGravity.dot(ball.m_vVel);
  });
  ForEachInPile(balls, [&](CMoving& ball, CEnergy& pile, double) {
    ball.m_vVel *= pile.GetShare();
    ball.m_vGiven += ball.m_vVel / m_fStep;
    // Without gravity a ball has the velocity that a game gives it at once.
    if (!m_bIsFalling) ball.m_vGiven.setZero();
  });
}

void CRestingContacts::SolvePile(std::span<CContact> pile, std::vector<CMoving>& balls) {
  const double dt = m_fStep;
  double surface = 0.0; // the fastest
  m_cSolver.Begin();
  for (const CContact& c : pile) {
    CContactSolver::CRow row =
        MakeRow(c, balls, [&](std::uint32_t i) { return Vector2d(balls[i].m_vVel + m_vGravity * dt); });
    double bend = 0.5 * c.m_fBend * dt;
    // Of two balls that slide along each other it is less at the end than at these velocities.
    if (c.m_bIsBall) bend = std::min(bend, g_fPassedOverlap * GetSmallerRadius(c, balls) / dt);
    row.m_fLeast = c.m_fSpeed - bend - std::max(0.0, GetGap(c, balls)) / dt;
    m_cSolver.Add(row, c.m_fImpulse);
    surface = std::max(surface, std::abs(c.m_fSpeed));
  }
  m_cSolver.Solve(m_fSlow, surface);
  CEnergy& energy = m_stdEnergies[m_cPiles.Find(pile[0].m_nBall)];
  energy.m_bIsMoved = surface > 0.0;

  const auto put = [&](std::uint32_t i) {
    balls[i].m_vVel = m_cSolver.GetVel(m_stdSolved[i]);
    balls[i].m_vFall = balls[i].m_vAcc = Vector2d::Zero(); // gravity has been there
    balls[i].m_bIsMoved = true;
    balls[i].m_bIsDriven |= surface > 0.0;
    energy.m_bIsSteered |= balls[i].IsSteered();
  };
  for (std::size_t k = 0; k < pile.size(); ++k) {
    CContact& c = pile[k];
    c.m_fImpulse = m_cSolver.GetImpulse(k);
    put(c.m_nBall);
    if (c.m_bIsBall) put(c.m_nOther);
    if (!(c.m_fImpulse > 0.0)) continue;
    m_cMemory.m_stdNear[c.m_nNear].m_fImpulse = c.m_fImpulse;
    balls[c.m_nBall].m_bPresses = !m_bIsFalling;
    if (c.m_bIsBall) balls[c.m_nOther].m_bPresses = !m_bIsFalling;
    CMoving& ball = balls[c.m_nBall];
    if (c.m_bIsBall) continue;
    ball.m_cHolds.Add({c.m_nOther, false, c.m_vNorm, c.m_fSpeed, 0.0, c.m_fRadius + ball.m_fRadius});
  }
}

} // namespace Shapes::Native
