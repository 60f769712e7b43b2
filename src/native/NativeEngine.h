// SPDX-License-Identifier: MIT
#pragma once

#include "../world/WorldCore.h"

#include "Lanes.h"
#include "broadphase/DiscGrid.h"
#include "broadphase/StaticBroadPhase.h"
#include "continuous/Continuous.h"
#include "narrowphase/Collide.h"

#include <cstdint>
#include <vector>

namespace Shapes::Native {

/// The native engine. Of the stages of a substep those run that are called for. Without Continuous it
/// gives the same bits as the plain loop: kinematic shapes advance by id; balls move by id; each ball by id
/// is tested against every point by id, then every other shape by id, at its present position, and responds
/// at once; then every pair of balls i < j responds once. Sensors are left out. Boxes only spare tests that
/// must fail.
class CNativeEngine final : public CEngine {
public:
  explicit CNativeEngine(CWorldCore& world);

  void Added(CShapeId id) override;
  void Removed(CShapeId id, std::unique_ptr<CShape> pShape) override;
  void Changed(CShapeId id, eChange change) override;
  void Plan(CEffects running) override { m_cRunning = running; }
  void Substep(float dt) override;
  std::shared_ptr<const CEngineMemory> Save() override;
  void Loaded(const CEngineMemory* pMemory) override;

private:
  // Where a thread works, and what came of it.
  struct CLane {
    CContinuous m_cContinuous;
    std::vector<std::uint32_t> m_stdNear; // balls near a shape
    std::vector<std::uint32_t> m_stdCandidates;
    std::vector<CContactEvent> m_stdContacts;
    CWorldStats m_cStats;            // of the stage
    CWorldStats* m_pStats = nullptr; // these, but of the first lane those of the world
  };

  bool Runs(eEffect e) const { return m_cRunning.Has(e); }
  CLane& First() { return m_stdLanes.front(); }
  void UpdateBroadPhase();
  CWorldStats& Stats() { return m_cWorld.Stats(); }

  // Stages.
  void MoveShapes(float dt);
  void MoveBalls(float dt);
  void CollideBalls();
  void Sweep(float dt);

  std::size_t CountLanes();
  template <class F>
  void ForEachLane(const F& f);
  void AddCounts(CLane& lane);
  void Report(CLane& lane);
  void CollideWithShapesOf(std::size_t ball, CLane& lane);
  void CollideWithShape(std::size_t ball, const CSolidShape& solid, CLane& lane);
  bool CollideWithBall(std::size_t i, std::size_t j);

  CBall Ball(std::size_t i) const;
  void BuildDiscGrid();
  void MoveInDiscGrid(std::uint32_t i);
  bool HasFilters() const;
  void CollectBalls(std::uint32_t i, std::uint32_t first);
  void Count(bool capped) { Stats().m_nSpeedsCapped += capped; }

  CWorldCore& m_cWorld;
  CWorldState& m_cState;
  CEffects m_cRunning;

  bool m_bShapesChanged = true; // the broad phase is made anew
  bool m_bBallsChanged = true;  // added or removed
  float m_fLargestRadius = 0.0f;
  bool m_bFilters = false; // some meet not all
  CStaticBroadPhase m_cBroadPhase;
  std::vector<CShape*> m_stdKinematic; // sensors too
  CLanes m_cLanes;
  std::vector<CLane> m_stdLanes; // the first does what is not shared
  CDiscGrid m_cDiscGrid;
  std::vector<CDiscGrid::CDisc> m_stdDiscs; // the last one of each ball in it
};

} // namespace Shapes::Native
