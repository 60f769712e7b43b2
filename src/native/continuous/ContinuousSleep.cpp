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

// Whether a ball that is awake may come within reach of a sleeping one.
bool CContinuous::IsOnWay(const CMoving& sleeper, const CMoving& ball) const {
  const CMotion motion = GetMotion(ball);
  const Vector2d d = motion.PosAt(motion.m_fDuration) - motion.m_vPos, q = sleeper.m_vPos - motion.m_vPos;
  const double dd = d.squaredNorm();
  const double share = dd > 0.0 ? std::clamp(d.dot(q) / dd, 0.0, 1.0) : 0.0;
  return Norm(q - share * d) <= sleeper.m_fRadius + ball.m_fRadius + motion.GetSagitta() +
                                    m_cResting.GetSlow() * m_fStep +
                                    Rounding(SizeOf(ball.m_vPos, ball.m_fRadius));
}

void CContinuous::Wake(std::uint32_t i) {
  CMoving& ball = m_stdBalls[i];
  ball.m_bIsAsleep = false;
  ball.m_vAcc = ball.m_vFall;
  Rebox(i);
  m_stdWoken.push_back(i);
}

// Sleeping balls near which something moves wake, and with each all that touch it.
void CContinuous::WakeDisturbed(CBallArrays& balls) {
  m_stdWoken.clear();
  const auto n = static_cast<std::uint32_t>(m_stdBalls.size());
  const auto isAsleep = [](const CMoving& ball) { return ball.m_bIsAsleep; };
  if (std::none_of(m_stdBalls.begin(), m_stdBalls.end(), isAsleep)) return;
  const auto reach = static_cast<float>(m_cResting.GetSlow() * m_fStep);
  const auto wakeAround = [&](std::uint32_t i) {
    m_stdBallsFound.clear();
    m_cBallTree.Query(Padded(m_stdBoxes[i], reach), m_stdBallsFound);
    std::sort(m_stdBallsFound.begin(), m_stdBallsFound.end());
    for (const std::uint32_t j : m_stdBallsFound)
      if (m_stdBalls[j].m_bIsAsleep && IsOnWay(m_stdBalls[j], m_stdBalls[i])) Wake(j);
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!m_stdBalls[i].m_bIsAsleep)
      wakeAround(i);
    else if (m_pShapes->MovesNear(Padded(m_stdBoxes[i], reach)))
      Wake(i);
  }
  for (std::size_t k = 0; k < m_stdWoken.size(); ++k) {
    balls.m_stdCalm[m_stdBalls[m_stdWoken[k]].m_nBall] = 0.0f;
    wakeAround(m_stdWoken[k]);
  }
}

void CContinuous::FallAsleep(CBallArrays& b) {
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
