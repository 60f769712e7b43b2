// SPDX-License-Identifier: MIT
#include "WorldState.h"

#include <algorithm>

namespace Shapes {

void CBallArrays::Add(CShapeId id, const CDynamicCircleDesc& desc) {
  m_stdId.push_back(id);
  m_stdPos.push_back(desc.m_vPos);
  m_stdPrevPos.push_back(desc.m_vPos);
  m_stdVel.push_back(desc.m_vVel);
  m_stdPosTail.push_back(Vector2::Zero());
  m_stdVelTail.push_back(Vector2::Zero());
  m_stdCalm.push_back(0.0f);
  m_stdRadius.push_back(desc.m_fRadius);
  m_stdMass.push_back(desc.m_fMass);
  m_stdElasticity.push_back(desc.m_fElasticity);
  m_stdFilter.push_back(desc.m_cFilter);
  m_stdSensor.push_back(desc.m_bIsSensor);
  m_stdCanCollide.push_back(true);
  m_stdUser.push_back(nullptr);
}

void CBallArrays::Remove(std::size_t i) {
  const auto removeFrom = [i](auto&... arrays) {
    (arrays.erase(arrays.begin() + static_cast<std::ptrdiff_t>(i)), ...);
  };
  removeFrom(m_stdId, m_stdPos, m_stdPrevPos, m_stdVel, m_stdPosTail, m_stdVelTail, m_stdCalm, m_stdRadius,
             m_stdMass, m_stdElasticity, m_stdFilter, m_stdSensor, m_stdCanCollide, m_stdUser);
}

void CBallArrays::ForgetTails() {
  m_stdPosTail.assign(m_stdId.size(), Vector2::Zero());
  m_stdVelTail.assign(m_stdId.size(), Vector2::Zero());
}

std::size_t CWorldState::FindShape(CShapeId id) const {
  const auto it = std::lower_bound(m_stdShapes.begin(), m_stdShapes.end(), id,
                                   [](const CShapeEntry& entry, CShapeId i) { return entry.m_cId < i; });
  return it != m_stdShapes.end() && it->m_cId == id ? static_cast<std::size_t>(it - m_stdShapes.begin())
                                                    : npos;
}

std::size_t CWorldState::FindBall(CShapeId id) const {
  const auto it = std::lower_bound(m_cBalls.m_stdId.begin(), m_cBalls.m_stdId.end(), id);
  return it != m_cBalls.m_stdId.end() && *it == id ? static_cast<std::size_t>(it - m_cBalls.m_stdId.begin())
                                                   : npos;
}

eMeeting CWorldState::GetMeeting(const CTouchingPair& pair) const {
  const CBallArrays& b = m_cBalls;
  const std::size_t i = FindBall(pair.m_cBall);
  if (i == npos || !b.m_stdCanCollide[i]) return eMeeting::None;
  if (pair.m_cShape == CShapeId()) return b.m_stdSensor[i] ? eMeeting::None : eMeeting::Solid;
  const auto meet = [&](bool canCollide, bool isSensor, const CFilter& filter) {
    if (!canCollide || !DoMeet(b.m_stdFilter[i], filter)) return eMeeting::None;
    return b.m_stdSensor[i] || isSensor ? eMeeting::Sensor : eMeeting::Solid;
  };
  if (const std::size_t j = FindBall(pair.m_cShape); j != npos)
    return meet(b.m_stdCanCollide[j], b.m_stdSensor[j], b.m_stdFilter[j]);
  const std::size_t k = FindShape(pair.m_cShape);
  if (k == npos) return eMeeting::None;
  const CShape& shape = *m_stdShapes[k].m_pShape;
  return meet(shape.GetCanCollide(), shape.GetSensor(), shape.GetFilter());
}

} // namespace Shapes
