// SPDX-License-Identifier: MIT
#include "Flipper.h"

#include <algorithm>

namespace Shapes::Games {
namespace {

constexpr float g_fLength = 1.4f, g_fPivotRadius = 0.24f, g_fTipRadius = 0.13f, g_fElasticity = 0.5f;
constexpr float g_fUpSpeed = 2.0f, g_fDownSpeed = 1.2f; // revolutions per second

} // namespace

CFlipper::CFlipper(CWorld& world, const Vector2& pivot, float angle, float swing)
    : m_fUpwards(swing > 0 ? 1.0f : -1.0f) {
  const CLineSegDesc like({0, 0}, {0, 0}, g_fElasticity);
  const Vector2 tip = pivot + g_fLength * AngleToVector(angle);
  const auto parts = MakeCapsule(pivot, g_fPivotRadius, tip, g_fTipRadius, like);
  const auto stops = CMotionLimits::OfAngle(std::min(0.0f, swing), std::max(0.0f, swing));
  m_stdIds = world.AddCompound(parts, pivot, 0.0f, Vector2::Zero(), stops);
}

void CFlipper::Move(CWorld& world, bool up) {
  world.SetRotSpeed(m_stdIds, m_fUpwards * (up ? g_fUpSpeed : -g_fDownSpeed));
}

} // namespace Shapes::Games
