// SPDX-License-Identifier: MIT
// Balls at rest: they are passed over until something comes near.
#include "Continuous.h"

#include "Rounding.h"

#include <algorithm>
#include <limits>

namespace Shapes::Native {

bool CContinuous::AllSleep() const {
  const std::vector<float>& calm = m_pBalls->m_stdCalm;
  return IsFalling() && std::all_of(calm.begin(), calm.end(), [](float c) { return c >= g_fSleepTime; });
}

bool CContinuous::AnySleeps() const {
  const std::vector<float>& calm = m_pBalls->m_stdCalm;
  return IsFalling() && std::any_of(calm.begin(), calm.end(), [](float c) { return c >= g_fSleepTime; });
}

// Those near which something was changed since the last substep: they may lie on nothing, or in something.
void CContinuous::WakeDisturbed() {
  CBallArrays& b = *m_pBalls;
  CDisturbed& disturbed = b.m_cDisturbed;
  if (disturbed.m_bIsEverywhere)
    std::fill(b.m_stdCalm.begin(), b.m_stdCalm.end(), 0.0f);
  else if (!disturbed.m_stdBoxes.empty() && AnySleeps()) {
    m_cDisturbed.Build(disturbed.m_stdBoxes);
    for (std::size_t i = 0; i < b.Size(); ++i) {
      // As far as what it touches may be from it.
      const CAabb2D near = Geometry::Padded(b.GetAABB(i), g_fTouchReach * b.m_stdRadius[i]);
      m_cDisturbed.Visit([&](const CAabb2D& box) { return box && near; },
                         [&](std::uint32_t) { b.m_stdCalm[i] = 0.0f; });
    }
  }
  disturbed.Clear();
}

// Whether a ball that is awake may come within reach of a sleeping one.
bool CContinuous::IsOnWay(std::size_t sleeper, std::size_t ball) const {
  const CMotion motion = GetFreeMotion(ball), sleeping = GetFreeMotion(sleeper);
  const Vector2d d = motion.PosAt(motion.m_fDuration) - motion.m_vPos, q = sleeping.m_vPos - motion.m_vPos;
  return Norm(q - ClosestShare(Vector2d::Zero(), d, q) * d) <=
         sleeping.m_fRadius + motion.m_fRadius + motion.GetSagitta() + m_cResting.GetSlow() * m_fStep +
             Rounding(SizeOf(motion.m_vPos, motion.m_fRadius));
}

// Seconds for which a ball that was taken has been at rest, those in which it is pressed as less.
float CContinuous::GetCalm(const CMoving& ball) const {
  const CBallArrays& b = *m_pBalls;
  const auto isCarried = [this](const CHold& hold) {
    return !hold.m_bIsBall && m_pShapes->GetGeometry(hold.m_nOther).IsMoving();
  };
  const auto holds = ball.m_cHolds.Get();
  const bool lies = ball.m_bIsAsleep || ball.m_bIsInPile || ball.m_bIsStuck || !holds.empty();
  const bool isInCrowd = ball.m_cFarthestDeep != g_cFarthest; // which comes apart little by little
  const bool isCalm = lies && !isInCrowd && ball.m_bIsHalted == ball.m_bIsStuck &&
                      b.m_stdVel[ball.m_nBall].norm() <= static_cast<float>(g_fSleepSpeed * m_fFall) &&
                      std::none_of(holds.begin(), holds.end(), isCarried);
  const double share = ball.m_bIsPressed ? g_fSleepTime / g_fPressedSleepTime : 1.0;
  return isCalm ? b.m_stdCalm[ball.m_nBall] + static_cast<float>(m_fStep * share) : 0.0f;
}

void CContinuous::SetCalm(std::size_t k, float calm) {
  CBallArrays& b = *m_pBalls;
  b.m_stdCalm[k] = std::min(calm, g_fSleepTime);
  if (calm >= g_fSleepTime) b.SetVel(k, Vector2::Zero());
}

// Of those that were taken.
void CContinuous::FallAsleep() {
  if (!m_bPairs) {
    for (const CMoving& ball : m_stdBalls)
      SetCalm(ball.m_nBall, GetCalm(ball));
    return;
  }
  m_cResting.NotePressed(m_stdBalls);
  const auto n = static_cast<std::uint32_t>(m_stdBalls.size());
  m_stdLeastCalm.assign(n, std::numeric_limits<float>::infinity());
  for (std::uint32_t i = 0; i < n; ++i) {
    float& least = m_stdLeastCalm[m_cResting.GetPile(i)];
    const float calm = m_pBalls->m_stdCalm[m_stdBalls[i].m_nBall] = GetCalm(m_stdBalls[i]);
    least = std::min(least, calm);
  }
  // Where one of a pile moves the others may have lost what they lean on: all begin anew.
  for (std::uint32_t i = 0; i < n; ++i)
    SetCalm(m_stdBalls[i].m_nBall, m_stdLeastCalm[m_cResting.GetPile(i)]);
}

} // namespace Shapes::Native
