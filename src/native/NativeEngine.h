// SPDX-License-Identifier: MIT
#pragma once

#include "../world/WorldCore.h"

#include "broadphase/DiscGrid.h"
#include "broadphase/StaticBroadPhase.h"
#include "continuous/Continuous.h"
#include "narrowphase/Collide.h"

#include <cstdint>
#include <vector>

namespace Shapes::Native {

/// The native engine. A substep is a list of stages, those that are called for. Without Continuous it
/// gives the same bits as the plain loop: kinematic shapes advance by id; balls move by id; each ball by id
/// is tested against every point by id, then every other shape by id, at its present position, and responds
/// at once; then every pair of balls i < j responds once. Sensors are left out. Boxes only spare tests that
/// must fail.
class CNativeEngine final : public CEngine {
public:
  explicit CNativeEngine(CWorldCore& world) : m_cWorld(world), m_cState(world.GetState()) {}

  void Added(CShapeId id) override;
  void Removed(CShapeId id) override;
  void Changed(CShapeId id, eChange change) override;
  void Plan(CEffects running) override;
  void Substep(float dt) override;
  /// A world that goes on and one that is loaded take the same steps.
  void Saved() override { m_cContinuous.Forget(); }
  void Loaded() override {
    m_bShapesChanged = m_bBallsChanged = true;
    m_cContinuous.Forget();
  }

private:
  using CStage = void (CNativeEngine::*)(float);

  bool Runs(eEffect e) const { return m_cRunning.Has(e); }
  void UpdateBroadPhase();
  CWorldStats& Stats() { return m_cWorld.Stats(); }

  // Stages.
  void Accelerate(float dt);
  void MoveShapes(float dt);
  void BoxShapes(float dt);
  void MoveBalls(float dt);
  template <bool TReports>
  void CollideWithShapes(float dt);
  template <bool TReports>
  void CollideBalls(float dt);
  void Sweep(float dt);

  template <bool TReports>
  void CollideWithShapesOf(std::size_t ball);
  template <bool TReports>
  void CollideWithShape(std::size_t ball, const CShapeEntry& entry);
  template <bool TReports>
  bool CollideWithBall(std::size_t i, std::size_t j);

  CBall Ball(std::size_t i) const;
  void BuildDiscGrid();
  void MoveInDiscGrid(std::uint32_t i);
  bool HasFilters() const;
  void CollectShapes(std::size_t ball, float reach);
  void LeaveOutShapes(std::size_t ball);
  void CollectBalls(std::uint32_t i, std::uint32_t first);
  void Count(bool capped) { Stats().m_nSpeedsCapped += capped; }

  CWorldCore& m_cWorld;
  CWorldState& m_cState;
  CEffects m_cRunning;
  std::vector<CStage> m_stdStages;

  bool m_bShapesChanged = true; // the broad phase is made anew
  std::size_t m_nShapes = 0;    // when it was made
  bool m_bBallsChanged = true;  // added or removed
  float m_fLargestRadius = 0.0f;
  bool m_bFilters = false; // some meet not all
  CStaticBroadPhase m_cBroadPhase;
  std::vector<CShape*> m_stdKinematic; // sensors too
  CContinuous m_cContinuous;
  CDiscGrid m_cDiscGrid;
  std::vector<CDiscGrid::CDisc> m_stdDiscs; // the last one of each ball in it
  std::vector<std::uint32_t> m_stdCandidates;
};

} // namespace Shapes::Native
