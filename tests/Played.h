// SPDX-License-Identifier: MIT
// Scenes that are played on the native engine step by step, and what came out of them in one number.
#pragma once

#include "Hash.h"
#include "compare/MadeScenes.h"

#include <string>
#include <vector>

namespace Shapes::Tests {

using Compare::Tests::LoadBundled;

/// A square box, no gravity, with 100 elastic balls that have a tenth of its area. A step is a sixth of the
/// radius at the mean speed.
Compare::CScene MakeBoxOfBalls();

/// A scene that is played: flippers flip, and balls that drain, or leave the bounds, start again.
class CPlayed {
public:
  CPlayed(const Compare::CScene& scene, const CEffectChoice& effects);

  void Step();

  CWorld& GetWorld() { return *m_cWorld.m_pWorld; }
  const CWorld& GetWorld() const { return *m_cWorld.m_pWorld; }
  const Compare::CScene& GetScene() const { return m_cScene; }
  /// The shapes in the order of the scene, then the balls.
  const std::vector<CShapeId>& GetShapes() const { return m_cWorld.m_stdShapes; }
  const std::vector<CShapeId>& GetBalls() const { return m_cWorld.m_stdBalls; }
  std::size_t GetEscaped() const { return m_nEscaped; }
  std::size_t GetDrained() const { return m_nDrained; }

  /// All that a game has to keep in order to go on later.
  struct CSaved {
    CSavedState m_cWorld;
    double m_fTime;
  };
  CSaved Save();
  void Load(const CSaved& saved);

private:
  void StartAgain(std::size_t ball);

  const Compare::CScene& m_cScene;
  Compare::CStart m_cStart;
  Compare::CTrialWorld m_cWorld;
  double m_fTime;
  std::size_t m_nEscaped = 0, m_nDrained = 0;
  std::vector<std::size_t> m_stdStartAgain;
};

} // namespace Shapes::Tests
