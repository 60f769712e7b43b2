// SPDX-License-Identifier: MIT
#include "WorldState.h"

#include <algorithm>

namespace Shapes {
namespace {

// Applies f to every array of the balls, so that none is forgotten.
template <class F>
void ForEachArray(CBallArrays& b, F f) {
  f(b.m_stdId), f(b.m_stdPos), f(b.m_stdPrevPos), f(b.m_stdVel), f(b.m_stdRadius), f(b.m_stdMass);
  f(b.m_stdPosTail), f(b.m_stdVelTail), f(b.m_stdCalm), f(b.m_stdElasticity), f(b.m_stdFilter),
      f(b.m_stdSensor), f(b.m_stdCanCollide), f(b.m_stdUser);
}

} // namespace

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
  ForEachArray(*this, [i](auto& array) { array.erase(array.begin() + static_cast<std::ptrdiff_t>(i)); });
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

} // namespace Shapes
