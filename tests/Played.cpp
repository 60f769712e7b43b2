// SPDX-License-Identifier: MIT
#include "Played.h"

namespace Shapes::Tests {

using namespace Compare;

CScene MakeBoxOfBalls() {
  constexpr float half = 7.0f;
  CScene scene = Compare::Tests::MakeScene(half, 10.0f);
  for (const float s : {-half, half}) {
    Compare::Tests::AddShape(scene, CLineSegDesc({-half, s}, {half, s}));
    Compare::Tests::AddShape(scene, CLineSegDesc({s, -half}, {s, half}));
  }
  CRandom random(1);
  for (int i = 0; i < 100; ++i) {
    const Vector2 p(1.25f * static_cast<float>(i % 10) - 5.625f, 1.25f * static_cast<float>(i / 10) - 5.625f);
    Compare::Tests::AddBall(scene, {p, 0.25f, 2.5f * random.Direction()});
  }
  return scene;
}

CPlayed::CPlayed(const CScene& scene, const CEffectChoice& effects)
    : m_cScene(scene),
      m_cStart(MakeStart(scene, 1, 0)),
      m_cWorld(scene, CEngine{"native", GetBackend(eBackend::Native), 1, effects}, m_cStart.m_stdBalls,
               m_cStart.m_fTime),
      m_fTime(m_cStart.m_fTime) {}

void CPlayed::StartAgain(std::size_t ball) {
  GetWorld().SetPos(GetBalls()[ball], m_cStart.m_stdBalls[ball].m_vPos);
  GetWorld().SetVel(GetBalls()[ball], m_cStart.m_stdBalls[ball].m_vVel);
}

void CPlayed::Step() {
  CWorld& world = GetWorld();
  m_cWorld.Flip(m_cScene, m_fTime);
  world.Step();
  m_fTime += static_cast<double>(m_cScene.m_cWorld.m_fTimeStep);

  const std::size_t shapes = GetShapes().size();
  m_stdStartAgain.clear();
  for (const CContactEvent& contact : world.GetContacts()) {
    const std::size_t shape = contact.m_cShape.m_nValue - 1;
    if (shape < shapes && m_cScene.m_stdShapes[shape].m_bIsDrain)
      m_stdStartAgain.push_back(contact.m_cBall.m_nValue - 1 - shapes);
  }
  m_nDrained += m_stdStartAgain.size();
  for (std::size_t i = 0; i < GetBalls().size(); ++i)
    if (!(m_cScene.m_cBounds && world.GetBallPositions()[i])) {
      ++m_nEscaped;
      m_stdStartAgain.push_back(i);
    }
  for (const std::size_t ball : m_stdStartAgain)
    StartAgain(ball);
}

CPlayed::CSaved CPlayed::Save() { return {GetWorld().SaveState(), m_fTime}; }

void CPlayed::Load(const CSaved& saved) {
  GetWorld().LoadState(saved.m_cWorld);
  m_fTime = saved.m_fTime;
}

} // namespace Shapes::Tests
