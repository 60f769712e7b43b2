// SPDX-License-Identifier: MIT
// The pinball table, 10 units wide: x to the right, y up, the chute of the plunger on the right.
#include "Pinball.h"

namespace Shapes::Games {
namespace {

constexpr float g_fWall = 0.8f, g_fGuide = 0.5f, g_fRubber = 0.7f;

CLineSegDesc Gate(const Vector2& p0, const Vector2& p1, eSides solid) {
  CLineSegDesc gate(p0, p1, g_fGuide);
  gate.m_eSides = solid;
  return gate;
}

template <class CDesc>
CDesc Sensor(CDesc desc) {
  desc.m_bIsSensor = true;
  return desc;
}

} // namespace

void CPinball::AddWalls() {
  // The walls go on past the ends of the arc, so that a ball meets one or the other.
  Add(CLineSegDesc({0, -0.5f}, {0, 14.5f}, g_fWall));
  Add(CLineSegDesc({10, -0.5f}, {10, 14.5f}, g_fWall));
  Add(CArcDesc({5, 14}, 5, 0, g_fPi, g_fWall));
  AddGuarded(CLineSegDesc({9.1f, -0.5f}, {9.1f, 13}, g_fWall));
  // Balls leave the chute and do not come back.
  Add(Gate({9.1f, 13}, {10, 13.9f}, eSides::Front), eRole::Gate);
  // The orbit along the left wall, downward only.
  AddGuarded(CLineSegDesc({1, 10.2f}, {1, 13.2f}, g_fWall));
  Add(Gate({0, 12.4f}, {1, 12.4f}, eSides::Back), eRole::Gate);
  // To the flippers.
  AddGuarded(CLineSegDesc({0, 4.85f}, {2.56f, 3.24f}, g_fGuide));
  AddGuarded(CLineSegDesc({9.1f, 4.85f}, {6.54f, 3.24f}, g_fGuide));
  // Four bollards, and a post in the middle that gives luck a chance.
  for (const float x : {2.9f, 4.1f, 5.3f, 6.5f})
    Add(CCircleDesc({x, 15.4f}, 0.16f, g_fRubber));
  Add(CCircleDesc({1, 8.9f}, 0.16f, g_fRubber));
  Add(CCircleDesc({8.1f, 9.3f}, 0.16f, g_fRubber));
  m_cLeft.emplace(*m_pWorld, Vector2(2.55f, 2.95f), -g_fPi / 6, g_fPi / 3);
  m_cRight.emplace(*m_pWorld, Vector2(6.55f, 2.95f), g_fPi * 7 / 6, -g_fPi / 3);
  for (const CFlipper* pFlipper : {&*m_cLeft, &*m_cRight})
    for (const CShapeId id : pFlipper->GetIds())
      SetRole(id, eRole::Flipper);
}

void CPinball::AddKickers() {
  for (const Vector2& p : {Vector2(2.9f, 12.4f), Vector2(6.5f, 12.4f), Vector2(4.7f, 10)})
    Add(CCircleDesc(p, 0.62f, 1.4f), eRole::Kicker);
  // A slingshot: the long side kicks, the others are walls. The second one mirrors the first.
  for (const float side : {1.0f, -1.0f}) {
    const auto place = [side](float x, float y) { return Vector2(4.55f + side * x, y); };
    const Vector2 top = place(-3.4f, 7.6f), bottom = place(-2.15f, 5.05f), outer = place(-3.4f, 5.8f);
    AddGuarded(CLineSegDesc(top, outer, g_fWall));
    AddGuarded(CLineSegDesc(outer, bottom, g_fWall));
    Add(CLineSegDesc(top, bottom, 1.5f), eRole::Kicker);
  }
}

void CPinball::AddSensors() {
  for (std::size_t i = 0; i < m_stdSlots.size(); ++i) {
    const float x = 2.9f + 1.2f * static_cast<float>(i);
    m_stdSlots[i] = Add(Sensor(CLineSegDesc({x + 0.16f, 15.4f}, {x + 1.04f, 15.4f})), eRole::Sensor);
  }
  m_cOrbit = Add(Sensor(CLineSegDesc({0, 11.2f}, {1, 11.2f})), eRole::Sensor);
  m_cInlane = Add(Sensor(CLineSegDesc({0, 6.6f}, {1.15f, 6.6f})), eRole::Sensor);
  m_cDrain = Add(Sensor(CLineSegDesc({0, 0.4f}, {9.1f, 0.4f})), eRole::Sensor);
}

void CPinball::AddPlunger() {
  // A bar that fills the chute but for a gap on each side. It is pulled down as far as its stop.
  const Vector2 corners[] = {{9.15f, 1.6f}, {9.95f, 1.6f}, {9.95f, 1.3f}, {9.15f, 1.3f}};
  std::vector<CAnyShapeDesc> sides;
  for (std::size_t i = 0; i < 4; ++i)
    sides.emplace_back(CLineSegDesc(corners[i], corners[(i + 1) % 4], 0.0f));
  const auto stops = CMotionLimits::OfCenter({0, 0}, {0, -g_fMostPull});
  m_stdPlunger = m_pWorld->AddCompound(sides, {0, 0}, 0.0f, Vector2::Zero(), stops);
  for (const CShapeId id : m_stdPlunger)
    SetRole(id, eRole::Flipper);
}

} // namespace Shapes::Games
