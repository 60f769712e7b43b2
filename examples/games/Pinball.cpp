// SPDX-License-Identifier: MIT
#include "Pinball.h"

#include <algorithm>
#include <vector>

namespace Shapes::Games {
namespace {

constexpr float g_fBallRadius = 0.25f;
constexpr float g_fServeX = 9.55f, g_fServeY = 1.9f;
constexpr float g_fPullSpeed = 1.0f;  // units per second
constexpr float g_fPushSpeed = 30.0f; // units per second, of a plunger that was pulled all the way
constexpr int g_nMostNudges = 3;

} // namespace

CWorldDesc CPinball::MakeDesc() {
  CWorldDesc desc = CGame::MakeDesc({0, -10}, 2);
  desc.m_cEffects.m_cForced.Set(eEffect::Touches); // a bumper gives points when it is touched, once
  return desc;
}

CPinball::CPinball(const CMode& mode, std::uint32_t seed)
    : CGame(MakeDesc(), CAabb2D({-0.5f, 19.5f}, {10.5f, -0.5f}), mode, seed) {
  AddWalls();
  AddKickers();
  AddSensors();
  AddPlunger();
  Serve();
}

// Above the plunger, and above the balls that are in the chute.
Vector2 CPinball::GetFreePlace() const {
  float y = g_fServeY;
  for (const Vector2& p : m_pWorld->GetBallPositions())
    if (p.x() > 9.1f && p.y() < 13) y = std::max(y, p.y() + 3 * g_fBallRadius);
  return {g_fServeX, y};
}

void CPinball::Serve() {
  const Vector2 p = GetFreePlace();
  Add(CDynamicCircleDesc(p, g_fBallRadius, {0, 0}, 1, 0.9f), eRole::Ball);
}

void CPinball::Before(unsigned keys) {
  const unsigned pressed = keys & ~m_nLastKeys;
  m_nLastKeys = keys;
  if (m_nBallsLeft == 0) { // the game is over; the plunger begins the next one
    if (!(pressed & g_nAction)) return;
    m_nBallsLeft = 3;
    m_nScore = 0;
    Serve();
  }
  const bool isTilted = m_nNudges > g_nMostNudges;
  m_cLeft->Move(*m_pWorld, (keys & g_nLeft) != 0 && !isTilted);
  m_cRight->Move(*m_pWorld, (keys & g_nRight) != 0 && !isTilted);
  MovePlunger((keys & g_nAction) != 0);
  if (pressed & g_nNudge) Nudge();
}

// Down while it is pulled, then up at a speed by how far it was pulled; its stops hold it.
void CPinball::MovePlunger(bool pull) {
  const float pulled = -m_pWorld->GetRotCenter(m_stdPlunger[0]).y();
  if (pull) m_fPush = g_fPushSpeed * std::max(pulled / g_fMostPull, 0.2f);
  m_pWorld->SetVel(m_stdPlunger, {0, pull ? -g_fPullSpeed : m_fPush});
}

// A push against the table: every ball gets some speed.
void CPinball::Nudge() {
  ++m_nNudges;
  const std::vector<CShapeId> balls(m_pWorld->GetBallIds().begin(), m_pWorld->GetBallIds().end());
  for (const CShapeId id : balls)
    m_pWorld->SetVel(id, m_pWorld->GetVel(id) + Vector2(m_cRandom(-2, 2), 2));
}

void CPinball::After() {
  for (const CTouchEvent& event : m_pWorld->GetTouchEvents())
    if (event.m_bBegin && GetRole(event.m_cShape) == eRole::Kicker)
      m_nScore += m_pWorld->GetShapeType(event.m_cShape) == eShape::Circle ? 100 : 50;
  std::vector<CShapeId> drained;
  for (const CSensorEvent& event : m_pWorld->GetSensorEvents()) {
    if (!event.m_bBegin) continue;
    if (event.m_cShape == m_cDrain) drained.push_back(event.m_cBall);
    if (event.m_cShape == m_cOrbit) m_nScore += 500;
    if (event.m_cShape == m_cInlane) m_nScore += 50;
    LightSlot(event.m_cShape);
  }
  for (const CShapeId ball : drained)
    Drain(ball);
}

void CPinball::LightSlot(CShapeId slot) {
  if (std::find(m_stdSlots.begin(), m_stdSlots.end(), slot) == m_stdSlots.end()) return;
  m_nScore += 250;
  SetRole(slot, eRole::Lit);
  const auto isLit = [this](CShapeId id) { return GetRole(id) == eRole::Lit; };
  if (!std::all_of(m_stdSlots.begin(), m_stdSlots.end(), isLit)) return;
  m_nScore += 2500;
  for (const CShapeId id : m_stdSlots)
    SetRole(id, eRole::Sensor);
  Serve(); // another ball at once
}

void CPinball::Drain(CShapeId ball) {
  if (!m_pWorld->Contains(ball)) return; // it came to the drain twice in the step
  m_pWorld->Remove(ball);
  if (!m_pWorld->GetBallIds().empty()) return;
  m_nNudges = 0;
  if (--m_nBallsLeft > 0) Serve();
}

void CPinball::PutBack(CShapeId ball) {
  m_pWorld->SetPos(ball, GetFreePlace());
  m_pWorld->SetVel(ball, {0, 0});
}

bool CPinball::IsNear(float side) const {
  for (std::size_t i = 0; i < m_pWorld->GetBallIds().size(); ++i) {
    const Vector2 p = m_pWorld->GetBallPositions()[i], v = m_pWorld->GetBallVelocities()[i];
    const float x = side * (p.x() - 4.55f);
    if (x > 0.2f && x < 1.5f && p.y() > 2.2f && p.y() < 3.3f && v.y() < 1) return true;
  }
  return false;
}

unsigned CPinball::Play() {
  unsigned keys = (IsNear(-1) ? g_nLeft : 0u) | (IsNear(1) ? g_nRight : 0u);
  const auto balls = m_pWorld->GetBallPositions();
  const bool isServed =
      std::any_of(balls.begin(), balls.end(), [](const Vector2& p) { return p.x() > 9.1f && p.y() < 2.2f; });
  // Pulls for some time, lets go, and gives the ball a second to be gone.
  if (m_nWait > 0) {
    --m_nWait;
  } else if (m_nHold > 0) {
    if (--m_nHold > 0)
      keys |= g_nAction;
    else
      m_nWait = g_nFramesPerSecond;
  } else if (isServed || balls.empty()) {
    m_nHold = static_cast<unsigned>(m_cPlayerRandom(40, 60));
  }
  return keys;
}

std::string CPinball::GetStatus() const {
  if (m_nBallsLeft == 0) return "Game over. Pull the plunger for the next one.";
  if (m_nNudges > g_nMostNudges) return "Tilt: nudged too often, the flippers are off.";
  return "Balls: " + std::to_string(m_nBallsLeft);
}

} // namespace Shapes::Games
