// SPDX-License-Identifier: MIT
#include "PileEnergy.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Native {

void CPileEnergy::Add(const CMoving& ball) {
  m_stdBegin.push_back({ball.m_vPos, ball.GetKinetic()});
  m_cGroups.Add();
}

void CPileEnergy::Keep(std::vector<CMoving>& balls, const Vector2d& gravity) {
  if (IsEmpty()) return;
  m_stdGroups.assign(balls.size(), {});
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const CMoving& ball = balls[i];
    CGroup& group = m_stdGroups[m_cGroups.Find(i)];
    group.m_bHasPile |= ball.m_bIsInPile;
    group.m_bIsDriven |= ball.m_bIsDriven || ball.m_nLastMoving != g_nNobody;
    group.m_fKinetic += ball.GetKinetic();
    const double fall = ball.m_fMass * gravity.dot(ball.m_vPos - m_stdBegin[i].m_vPos);
    group.m_fMost += m_stdBegin[i].m_fKinetic + fall;
  }
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const CGroup& group = m_stdGroups[m_cGroups.Find(i)];
    const double most = std::max(0.0, group.m_fMost);
    if (group.m_bHasPile && !group.m_bIsDriven && group.m_fKinetic > most)
      balls[i].m_vVel *= std::sqrt(most / group.m_fKinetic);
  }
}

} // namespace Shapes::Native
