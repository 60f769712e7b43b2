// SPDX-License-Identifier: MIT
// 500 balls fall into a box in which a bar stirs. A point for each that passes the line.
#include "Pile.h"

#include <vector>

namespace Shapes::Games {
namespace {

constexpr int g_nBalls = 500, g_nColumns = 30;
constexpr float g_fSpacing = 0.65f;

} // namespace

CPile::CPile(const CMode& mode, std::uint32_t seed)
    : CGame(MakeDesc({0, -10}, 1), CAabb2D({-0.5f, 24.5f}, {20.5f, -0.5f}), mode, seed) {
  Add(CLineSegDesc({0, 0}, {20, 0}, 0.5f));
  Add(CLineSegDesc({0, 0}, {0, 24}, 0.5f));
  Add(CLineSegDesc({20, 0}, {20, 24}, 0.5f));
  Add(CLineSegDesc({0, 24}, {20, 24}, 0.5f)); // what is thrown out would count as lost
  CLineSegDesc line({0, 11.5f}, {20, 11.5f});
  line.m_bIsSensor = true;
  m_cLine = Add(line, eRole::Sensor);
  // A bar with round ends.
  const CCircleDesc left({6.5f, 5}, 0.3f, 0.3f), right({13.5f, 5}, 0.3f, 0.3f);
  CLineSegDesc above({0, 0}, {0, 0}, 0.3f), below = above;
  const CCircle other(right);
  CCircle(left).Tangents(&other, above, below);
  const CAnyShapeDesc parts[] = {left, right, above, below};
  m_stdBar = m_pWorld->AddCompound(parts, {10, 5});
  for (const CShapeId id : m_stdBar)
    SetRole(id, eRole::Flipper);
  for (int i = 0; i < g_nBalls; ++i) {
    const float x = 0.6f + g_fSpacing * static_cast<float>(i % g_nColumns);
    const float y = 12.5f + g_fSpacing * static_cast<float>(i / g_nColumns);
    const float r = m_cRandom(0.22f, 0.31f); // one after the other: compilers order arguments as they like
    Add(CDynamicCircleDesc({x, y}, r, {m_cRandom(-1, 1), 0}, 1, 0.5f), eRole::Ball);
  }
}

void CPile::Before(unsigned keys) {
  const float speed = (keys & g_nLeft ? 0.3f : 0.0f) - (keys & g_nRight ? 0.3f : 0.0f);
  for (const CShapeId id : m_stdBar)
    m_pWorld->SetRotSpeed(id, speed);
  if (keys & ~m_nLastKeys & (g_nAction | g_nNudge)) Throw();
  m_nLastKeys = keys;
}

void CPile::Throw() {
  const std::vector<CShapeId> balls(m_pWorld->GetBallIds().begin(), m_pWorld->GetBallIds().end());
  for (const CShapeId id : balls)
    m_pWorld->SetVel(id, {m_cRandom(-3, 3), m_cRandom(6, 14)});
}

void CPile::After() {
  for (const CSensorEvent& event : m_pWorld->GetSensorEvents())
    m_nScore += event.m_bBegin && event.m_cShape == m_cLine;
}

void CPile::PutBack(CShapeId ball) {
  m_pWorld->SetPos(ball, {m_cRandom(1, 19), 23});
  m_pWorld->SetVel(ball, {0, 0});
}

// Stirs one way and the other, and throws everything up every 20 seconds.
unsigned CPile::Play() {
  const unsigned second = GetFrame() / g_nFramesPerSecond;
  if (second % 20 == 15) return g_nAction;
  if (second % 10 < 5) return 0;
  return second % 20 < 10 ? g_nLeft : g_nRight;
}

std::string CPile::GetStatus() const { return std::to_string(m_pWorld->GetBallIds().size()) + " balls"; }

} // namespace Shapes::Games
