// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/World.h>

#include "BallGrid.h"
#include "BoxTree.h"
#include "Detect.h"

#include <cstdint>
#include <vector>

namespace Shapes {
struct CShapeEntry;
}

namespace Shapes::Native {

/// A world on the native engine. Each substep gives the same bits as the plain loop: kinematic shapes advance
/// by id; balls move by id; each ball by id is tested against every point by id, then every other shape by
/// id, at its present position, and answers at once; then every pair of balls i < j answers once. Sensors are
/// left out. Boxes only spare tests that must fail.
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

  /// Shapes of one motion, with the tree over their boxes. Items of the tree index m_stdRank.
  struct CGroup {
    std::vector<std::uint32_t> m_stdRank;
    std::vector<CAabb2D> m_stdBoxes;
    CBoxTree m_cTree;
  };

  void SortShapes();
  void AdvanceKinematics(float dt);
  void MoveBalls(float dt);
  void MeetShapes();
  void MeetShapes(std::size_t ball);
  void MeetShape(std::size_t ball, const CShapeEntry& entry);
  void MeetBalls();
  bool MeetBall(std::size_t i, std::size_t j);

  CBall Ball(std::size_t i) const;
  /// Whether ball i answers what it touches.
  bool Meets(std::size_t i) const;
  void CollectShapes(const CBall& ball, std::uint32_t firstRank);
  void CollectBalls(std::size_t i, std::uint32_t first);
  void Count(bool capped) { Stats().m_nSpeedsCapped += capped; }

  bool m_bShapesChanged = true;
  std::vector<const CShapeEntry*> m_stdByRank; // points by id, then the others by id; without sensors
  std::vector<const CShapeEntry*> m_stdSensors;
  CGroup m_cStatic, m_cKinematic;
  CBallGrid m_cGrid;
  std::vector<std::uint32_t> m_stdFound, m_stdCandidates;
};

} // namespace Shapes::Native
