// SPDX-License-Identifier: MIT
#include "Game.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace Shapes::Games {

float GetSine(float angle) { return AngleToVector(angle).y(); }
float GetCosine(float angle) { return AngleToVector(angle).x(); }

CWorldDesc CGame::MakeDesc(const Vector2& gravity, unsigned stepsPerFrame) {
  CWorldDesc desc;
  desc.m_vGravity = gravity;
  desc.m_fTimeStep = 1.0f / static_cast<float>(g_nFramesPerSecond * stepsPerFrame);
  return desc;
}

CGame::CGame(const CWorldDesc& desc, const CAabb2D& bounds, const CMode& mode, std::uint32_t seed)
    : m_cRandom(seed),
      m_cPlayerRandom(seed),
      m_cDesc(desc),
      m_nStepsPerFrame(static_cast<unsigned>(std::lround(1.0f / (g_nFramesPerSecond * desc.m_fTimeStep)))),
      m_cBounds(bounds),
      m_pMode(&mode) {
  m_pWorld = MakeWorld(m_cDesc, mode);
  if (!m_pWorld) throw std::invalid_argument(std::string(mode.m_pName) + ": this engine was not built");
}

void CGame::Frame(unsigned keys) {
  for (unsigned i = 0; i < m_nStepsPerFrame; ++i) {
    Before(keys);
    m_pWorld->Step();
    After();
    FindLost();
  }
  ++m_nFrame;
}

void CGame::SetMode(const CMode& mode) {
  auto pWorld = MakeWorld(m_cDesc, mode);
  if (!pWorld) throw std::invalid_argument(std::string(mode.m_pName) + ": this engine was not built");
  pWorld->LoadState(m_pWorld->SaveState());
  m_pWorld = std::move(pWorld);
  m_pMode = &mode;
}

eRole CGame::GetRole(CShapeId id) const {
  const auto found = m_stdRoles.find(id);
  return found == m_stdRoles.end() ? eRole::Wall : found->second;
}

CShapeId CGame::Add(const CAnyShapeDesc& desc, eRole role) {
  const CShapeId id = m_pWorld->Add(desc);
  SetRole(id, role);
  return id;
}

void CGame::AddGuarded(const CLineSegDesc& desc, eRole role) {
  Add(desc, role);
  for (const Vector2& p : {desc.GetEndPt0(), desc.GetEndPt1()})
    Add(CPointDesc(p, desc.m_fElasticity), role);
}

void CGame::FindLost() {
  std::vector<CShapeId> lost;
  for (std::size_t i = 0; i < m_pWorld->GetBallIds().size(); ++i)
    if (!(m_cBounds && m_pWorld->GetBallPositions()[i])) lost.push_back(m_pWorld->GetBallIds()[i]);
  m_nLost += static_cast<int>(lost.size());
  for (const CShapeId id : lost)
    PutBack(id);
}

std::string CGame::GetTrace() const {
  std::string text = std::to_string(m_nFrame) + " " + std::to_string(m_nScore);
  const auto add = [&text](float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits); // std::bit_cast is too new for some libraries
    char digits[16];
    std::snprintf(digits, sizeof digits, " %08x", static_cast<unsigned>(bits));
    text += digits;
  };
  for (const auto& values : {m_pWorld->GetBallPositions(), m_pWorld->GetBallVelocities()})
    for (const Vector2& v : values) {
      add(v.x());
      add(v.y());
    }
  return text;
}

} // namespace Shapes::Games
