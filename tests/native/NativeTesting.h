// SPDX-License-Identifier: MIT
// Worlds of the native engine, and what many of its tests put into them.
#pragma once

#include "../Testing.h"

namespace Shapes {

/// @param gravity  downward
inline std::unique_ptr<CWorld> MakeNative(const CEffectChoice& effects, float gravity = 0, float dt = g_fDt,
                                          unsigned substeps = 1, unsigned threads = 1) {
  CWorldDesc desc = Described({0, -gravity}, dt, substeps, effects);
  desc.m_nThreads = threads;
  return GetBackend(eBackend::Native)->MakeWorld(desc);
}

inline void AddBox(CWorld& world, const Vector2& low, const Vector2& high, float e = 1) {
  for (const CLineSegDesc& wall : Walls(low, high, e))
    world.Add(wall);
}
/// About the origin.
inline void AddBox(CWorld& world, float half, float e = 1) { AddBox(world, {-half, -half}, {half, half}, e); }

/// In the last step.
inline std::vector<CShapeId> Halted(const CWorld& world) {
  const auto halted = world.GetHaltedBalls();
  return {halted.begin(), halted.end()};
}

} // namespace Shapes
