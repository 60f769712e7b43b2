// SPDX-License-Identifier: MIT
#include "Trial.h"

#include "Interrupt.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace Shapes::Compare {
namespace {

constexpr double g_fTurn = 6.283185307179586;

// The engine is the one that the standard defines bit by bit; its distributions are not, so they are not
// used.
class CDice {
public:
  CDice(std::uint64_t seed, std::uint64_t trial) : m_cEngine(seed * 0x9E3779B97F4A7C15u + trial) {}
  /// In [low, high).
  double Between(double low, double high) {
    return low + (high - low) * (static_cast<double>(m_cEngine() >> 11) * 0x1p-53);
  }

private:
  std::mt19937_64 m_cEngine;
};

} // namespace

CStart MakeStart(const CScene& scene, std::uint64_t seed, std::uint64_t trial) {
  CDice dice(seed, trial);
  CStart start;
  const double phase = dice.Between(0, 1) * static_cast<double>(scene.m_cWorld.m_fTimeStep);
  // Whole seconds would leave a shape that turns once a second where it is.
  start.m_fTime = dice.Between(0, 17);
  if (std::any_of(scene.m_stdShapes.begin(), scene.m_stdShapes.end(),
                  [](const CSceneShape& shape) { return !GetBase(shape.m_cDesc).m_vVel.isZero(0.0f); }))
    start.m_fTime = 0.0;
  for (const CSceneBall& ball : scene.m_stdBalls) {
    CDynamicCircleDesc desc = ball.m_cDesc;
    const double dx = dice.Between(-1, 1), dy = dice.Between(-1, 1);
    const double turn = dice.Between(-1, 1), faster = dice.Between(-1, 1);
    desc.m_vVel = RotatePt(desc.m_vVel, Vector2::Zero(), static_cast<float>(turn) * ball.m_fTurn) *
                  (1.0f + static_cast<float>(faster) * ball.m_fSpeedSpread);
    desc.m_vPos +=
        Vector2(static_cast<float>(dx) * ball.m_vSpread.x(), static_cast<float>(dy) * ball.m_vSpread.y());
    desc.m_vPos += desc.m_vVel * static_cast<float>(phase);
    start.m_stdBalls.push_back(desc);
  }
  return start;
}

std::size_t CountSteps(const CScene& scene, float seconds) {
  return static_cast<std::size_t>(
      std::ceil(static_cast<double>(seconds) / static_cast<double>(scene.m_cWorld.m_fTimeStep)));
}

std::size_t GetStepsPerTrial(const CScene& scene) { return CountSteps(scene, scene.m_fDuration); }

float OrientationAt(const CSceneShape& shape, double time) {
  if (shape.m_cFlip) return FlipOrientation(*shape.m_cFlip, time);
  return static_cast<float>(
      std::fmod(g_fTurn * static_cast<double>(GetBase(shape.m_cDesc).m_fRotSpeed) * time, g_fTurn));
}

float RotSpeedAt(const CSceneShape& shape, double time, double dt) {
  if (!shape.m_cFlip) return GetBase(shape.m_cDesc).m_fRotSpeed;
  const double turn = static_cast<double>(FlipOrientation(*shape.m_cFlip, time + dt)) -
                      static_cast<double>(FlipOrientation(*shape.m_cFlip, time));
  return static_cast<float>(turn / (g_fTurn * dt));
}

Eigen::Vector2d OffsetAt(const CSceneShape& shape, double time) {
  if (shape.m_cShuttle) return ShuttleOffset(*shape.m_cShuttle, time);
  return time * GetBase(shape.m_cDesc).m_vVel.cast<double>();
}

Vector2 VelAt(const CSceneShape& shape, double time, double dt) {
  if (!shape.m_cShuttle) return GetBase(shape.m_cDesc).m_vVel;
  return ((OffsetAt(shape, time + dt) - OffsetAt(shape, time)) / dt).cast<float>();
}

CTrialWorld::CTrialWorld(const CScene& scene, const CEngine& engine,
                         std::span<const CDynamicCircleDesc> balls, double time)
    : m_pWorld(engine.m_pBackend->MakeWorld(engine.MakeWorldDesc(scene))) {
  const double dt = scene.m_cWorld.m_fTimeStep;
  for (const CSceneShape& shape : scene.m_stdShapes) {
    const CShapeId id = m_pWorld->Add(shape.m_cDesc);
    m_stdShapes.push_back(id);
    if (m_pWorld->GetMotionType(id) != eMotion::Kinematic) continue;
    if (const Eigen::Vector2d way = OffsetAt(shape, time); !way.isZero(0.0))
      m_pWorld->SetPos(id, (m_pWorld->GetPos(id).cast<double>() + way).cast<float>());
    if (const float angle = OrientationAt(shape, time); angle != 0.0f) m_pWorld->SetOrientation(id, angle);
    m_pWorld->SetRotSpeed(id, RotSpeedAt(shape, time, dt));
    m_pWorld->SetVel(id, VelAt(shape, time, dt));
  }
  for (const CDynamicCircleDesc& ball : balls)
    m_stdBalls.push_back(m_pWorld->Add(ball));
}

void CTrialWorld::Flip(const CScene& scene, double time) {
  const double dt = scene.m_cWorld.m_fTimeStep;
  for (std::size_t i = 0; i < scene.m_stdShapes.size(); ++i) {
    const CSceneShape& shape = scene.m_stdShapes[i];
    if (shape.m_cFlip) m_pWorld->SetRotSpeed(m_stdShapes[i], RotSpeedAt(shape, time, dt));
    if (shape.m_cShuttle) m_pWorld->SetVel(m_stdShapes[i], VelAt(shape, time, dt));
  }
}

CGame::CGame(const CScene& scene, const CEngine& engine, const CStart& start)
    : CGame(scene, engine, start, start.m_stdBalls, start.m_fTime) {}

CGame::CGame(const CScene& scene, const CEngine& engine, const CStart& start,
             std::span<const CDynamicCircleDesc> balls, double time)
    : m_cScene(scene), m_cStart(start), m_cWorld(scene, engine, balls, time), m_fTime(time) {
  for (const CSceneShape& shape : scene.m_stdShapes)
    m_bHasDrain |= shape.m_bIsDrain;
}

void CGame::StartAgain(std::size_t ball) {
  m_cWorld.m_pWorld->SetPos(m_cWorld.m_stdBalls[ball], m_cStart.m_stdBalls[ball].m_vPos);
  m_cWorld.m_pWorld->SetVel(m_cWorld.m_stdBalls[ball], m_cStart.m_stdBalls[ball].m_vVel);
}

void CGame::Step() {
  CheckInterrupt();
  CWorld& world = *m_cWorld.m_pWorld;
  const double dt = m_cScene.m_cWorld.m_fTimeStep;
  m_cWorld.Flip(m_cScene, m_fTime);
  world.Step();
  m_fTime += dt;

  const std::size_t firstBall = m_cWorld.m_stdShapes.size();
  if (m_bHasDrain) {
    std::vector<std::size_t> drained;
    for (const CContactEvent& event : world.GetContacts()) {
      const std::size_t shape = event.m_cShape.m_nValue - 1;
      if (shape < firstBall && m_cScene.m_stdShapes[shape].m_bIsDrain)
        drained.push_back(event.m_cBall.m_nValue - 1 - firstBall);
    }
    m_nDrained += drained.size();
    for (const std::size_t ball : drained)
      StartAgain(ball);
  }

  if (!m_bPutBack) return;
  for (std::size_t i = 0; i < world.GetBallPositions().size(); ++i) {
    const Vector2& p = world.GetBallPositions()[i];
    if (m_cScene.m_cBounds && p) continue;
    ++(p.allFinite() ? m_nEscaped : m_nNotFinite);
    StartAgain(i);
  }
}

} // namespace Shapes::Compare
