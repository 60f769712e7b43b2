// SPDX-License-Identifier: MIT
#include "ExactGame.h"

#include "Interrupt.h"

namespace Shapes::Compare {

CExactGame::CExactGame(const CScene& scene, const CStart& start)
    : m_cScene(scene),
      m_cStart(start),
      m_cReference(GetShapes(scene), start.m_stdBalls, scene.m_cWorld.m_vGravity),
      m_stdBalls(start.m_stdBalls),
      m_fTime(start.m_fTime),
      m_fNextTime(start.m_fTime) {}

void CExactGame::Step() {
  CheckInterrupt();
  const double dt = static_cast<double>(m_cScene.m_cWorld.m_fTimeStep);
  m_fTime = m_fNextTime;
  // Balls that drained in the last step start again only now, so that callers see where it ended.
  for (const CExactEvent<double>& event : m_stdEvents)
    if (!event.m_bIsBall && m_cScene.m_stdShapes[event.m_nShape].m_bIsDrain)
      m_cReference.SetBall(event.m_nBall, ToDouble(m_cStart.m_stdBalls[event.m_nBall].m_vPos),
                           ToDouble(m_cStart.m_stdBalls[event.m_nBall].m_vVel));
  for (std::size_t i = 0; i < m_stdBalls.size(); ++i) {
    CDynamicCircleDesc& ball = m_stdBalls[i];
    ball.m_vPos = m_cReference.GetBall(i).m_vPos.cast<float>();
    ball.m_vVel = m_cReference.GetBall(i).m_vVel.cast<float>();
    m_cReference.SetBall(i, ToDouble(ball.m_vPos), ToDouble(ball.m_vVel));
  }
  for (std::size_t i = 0; i < m_cScene.m_stdShapes.size(); ++i) {
    const CSceneShape& shape = m_cScene.m_stdShapes[i];
    m_cReference.SetOffset(i, OffsetAt(shape, m_fTime));
    m_cReference.SetVel(i, ToDouble(VelAt(shape, m_fTime, dt)));
    const float speed = RotSpeedAt(shape, m_fTime, dt);
    if (speed == 0.0f && m_cReference.GetRotSpeed(i) == 0.0) continue;
    m_cReference.SetOrientation(i, static_cast<double>(OrientationAt(shape, m_fTime)));
    m_cReference.SetRotSpeed(i, static_cast<double>(speed));
  }
  m_stdEvents.clear();
  m_cReference.Step(dt, m_stdEvents);
  m_fNextTime = m_fTime + dt;
  ++m_nSteps;
}

bool CExactGame::TryStep() {
  try {
    Step();
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

bool CExactGame::IsInBounds() const {
  for (std::size_t i = 0; i < m_stdBalls.size(); ++i)
    if (!(m_cScene.m_cBounds && Vector2(m_cReference.GetBall(i).m_vPos.cast<float>()))) return false;
  return true;
}

} // namespace Shapes::Compare
