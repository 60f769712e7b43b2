// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/World.h>

#include "BallGrid.h"
#include "Continuous.h"
#include "Detect.h"
#include "Solids.h"

#include <cstdint>
#include <vector>

namespace Shapes {
struct CShapeEntry;
}

namespace Shapes::Native {

/// A world on the native engine. A substep is a list of stages, those that are called for. Without Continuous
/// it gives the same bits as the plain loop: kinematic shapes advance by id; balls move by id; each ball by
/// id is tested against every point by id, then every other shape by id, at its present position, and answers
/// at once; then every pair of balls i < j answers once. Sensors are left out. Boxes only spare tests that
/// must fail.
class CNativeWorld final : public CWorld {
public:
  explicit CNativeWorld(const CWorldDesc& desc);

private:
  void Substep(float dt) override;
  void OnAdded(CShapeId id) override;
  void OnRemoved(CShapeId id) override;
  void OnChanged(CShapeId id, eChange what) override;
  void OnSaved() override {}
  void OnLoaded() override { m_bShapesChanged = true; }

  using CStage = void (CNativeWorld::*)(float dt);

  void PlanStages();

  // Stages.
  void Accelerate(float dt);
  void TurnShapes(float dt);
  void MoveBalls(float dt);
  template <bool TReports>
  void MeetShapes(float dt);
  template <bool TReports>
  void MeetBalls(float dt);
  void Sweep(float dt);

  template <bool TReports>
  void MeetShapesOf(std::size_t ball);
  template <bool TReports>
  void MeetShape(std::size_t ball, const CShapeEntry& entry);
  template <bool TReports>
  bool MeetBall(std::size_t i, std::size_t j);

  CBall Ball(std::size_t i) const;
  /// Whether ball i answers what it touches.
  bool Meets(std::size_t i) const;
  void CollectShapes(const CBall& ball, std::uint32_t firstRank);
  void CollectBalls(std::size_t i, std::uint32_t first);
  void Count(bool capped) { Stats().m_nSpeedsCapped += capped; }

  std::uint64_t m_nPlanned = 0;         // version of the content
  std::vector<CStage> m_stdFirst;       // before it is known whether anything is fast
  std::vector<CStage> m_stdApproximate; // then these,
  std::vector<CStage> m_stdContinuous;  // or these

  bool m_bShapesChanged = true;
  CSolids m_cSolids;
  std::vector<const CShapeEntry*> m_stdTurning; // sensors too
  CContinuous m_cContinuous;
  CBallGrid m_cGrid;
  std::vector<std::uint32_t> m_stdFound, m_stdCandidates;
};

} // namespace Shapes::Native
