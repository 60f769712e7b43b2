// SPDX-License-Identifier: MIT
// Scenes that the tests of the metrics make by hand, so that what has to come out is known.
#pragma once

#include "Trial.h"

#include <cstddef>
#include <vector>

namespace Shapes::Compare::Tests {

/// No gravity, no shapes, no balls, 60 steps a second.
inline CScene MakeScene(float halfWidth, float duration) {
  CScene scene;
  scene.m_sName = "made";
  scene.m_cBounds = CAabb2D({-halfWidth, halfWidth}, {halfWidth, -halfWidth});
  scene.m_fDuration = duration;
  return scene;
}

inline void AddShape(CScene& scene, const CAnyShapeDesc& desc) {
  CSceneShape shape;
  shape.m_cDesc = desc;
  scene.m_stdShapes.push_back(shape);
}

inline void AddBall(CScene& scene, const CDynamicCircleDesc& desc) {
  CSceneBall ball;
  ball.m_cDesc = desc;
  scene.m_stdBalls.push_back(ball);
}

inline constexpr std::size_t g_nNative = 0, g_nBox2D = 1; // in the order of GetEngines

} // namespace Shapes::Compare::Tests
