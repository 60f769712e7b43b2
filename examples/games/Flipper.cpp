// SPDX-License-Identifier: MIT
#include "Flipper.h"

#include <algorithm>

namespace Shapes::Games {
namespace {

constexpr float g_fLength = 1.4f, g_fPivotRadius = 0.24f, g_fTipRadius = 0.13f, g_fElasticity = 0.5f;
constexpr float g_fUpSpeed = 13.0f, g_fDownSpeed = 7.0f; // radians per second

} // namespace

CFlipper::CFlipper(CWorld& world, const Vector2& pivot, float angle, float swing) : m_fSwing(swing) {
  const CCircleDesc hub(pivot, g_fPivotRadius, g_fElasticity);
  const CCircleDesc tip(pivot + g_fLength * AngleToVector(angle), g_fTipRadius, g_fElasticity);
  CLineSegDesc left({0, 0}, {0, 0}, g_fElasticity), right = left;
  const CCircle tipCircle(tip);
  CCircle(hub).Tangents(&tipCircle, left, right);
  const CAnyShapeDesc parts[] = {hub, tip, left, right};
  m_stdIds = world.AddCompound(parts, pivot);
}

void CFlipper::Move(CWorld& world, bool up) {
  const float dt = world.GetDesc().m_fTimeStep;
  const float target = up ? m_fSwing : 0.0f;
  const float most = (up ? g_fUpSpeed : g_fDownSpeed) * dt;
  const float turn = std::clamp(target - m_fAngle, -most, most);
  m_fAngle = turn == target - m_fAngle ? target : m_fAngle + turn;
  for (const CShapeId id : m_stdIds)
    world.SetRotSpeed(id, turn / (g_fTwoPi * dt));
}

} // namespace Shapes::Games
