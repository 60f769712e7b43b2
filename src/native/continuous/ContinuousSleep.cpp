// SPDX-License-Identifier: MIT
// Balls at rest: they are passed over until something comes near.
#include "Continuous.h"

#include "Rounding.h"

#include <algorithm>
#include <limits>

namespace Shapes::Native {

bool CContinuous::AllSleep(const CBallArrays& b) const {
  return std::all_of(b.m_stdCalm.begin(), b.m_stdCalm.end(), [](float calm) { return calm >= g_fCalmTime; });
}

bool CContinuous::IsAsleep(std::size_t i) const {
  return IsFalling() && m_pBalls->m_stdCalm[i] >= g_fCalmTime;
}

bool CContinuous::AnySleeps() const {
  return IsFalling() && std::any_of(m_stdSolid.begin(), m_stdSolid.end(), [this](std::uint32_t i) {
           return m_pBalls->m_stdCalm[i] >= g_fCalmTime;
         });
}

// Whether a ball that is awake may come within reach of a sleeping one.
bool CContinuous::IsOnWay(std::size_t sleeper, std::size_t ball) const {
  const CMotion motion = GetFreeMotion(ball), sleeping = GetFreeMotion(sleeper);
  const Vector2d d = motion.PosAt(motion.m_fDuration) - motion.m_vPos, q = sleeping.m_vPos - motion.m_vPos;
  const double dd = d.squaredNorm();
  const double share = dd > 0.0 ? std::clamp(d.dot(q) / dd, 0.0, 1.0) : 0.0;
  return Norm(q - share * d) <= sleeping.m_fRadius + motion.m_fRadius + motion.GetSagitta() +
                                    m_cResting.GetSlow() * m_fStep +
                                    Rounding(SizeOf(motion.m_vPos, motion.m_fRadius));
}

// Of those that were taken.
void CContinuous::FallAsleep() {
  CBallArrays& b = *m_pBalls;
  const auto slow = static_cast<float>(g_fCalmSpeed * Norm(m_vGravity) * m_fStep);
  const auto dt = static_cast<float>(m_fStep);
  const auto n = static_cast<std::uint32_t>(m_stdBalls.size());
  m_stdLeastCalm.assign(n, std::numeric_limits<float>::infinity());
  const auto isCarried = [this](const CHold& hold) {
    return !hold.m_bIsBall && m_pShapes->GetGeometry(hold.m_nOther).IsMoving();
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const CMoving& ball = m_stdBalls[i];
    const auto holds = ball.m_cHolds.Get();
    const bool lies = ball.m_bIsAsleep || ball.m_bIsInPile || !holds.empty();
    const bool isCalm = lies && !ball.m_bIsHalted && std::none_of(holds.begin(), holds.end(), isCarried) &&
                        b.m_stdVel[ball.m_nBall].norm() <= slow;
    float& calm = b.m_stdCalm[ball.m_nBall];
    calm = isCalm ? calm + dt : 0.0f;
    float& least = m_stdLeastCalm[m_cResting.GetPile(i)];
    least = std::min(least, calm);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    // Where one of a pile moves the others may have lost what they lean on: all begin anew.
    const std::size_t k = m_stdBalls[i].m_nBall;
    b.m_stdCalm[k] = std::min(m_stdLeastCalm[m_cResting.GetPile(i)], g_fCalmTime);
    if (b.m_stdCalm[k] >= g_fCalmTime) b.SetVel(k, Vector2::Zero());
  }
}

} // namespace Shapes::Native
