// SPDX-License-Identifier: MIT
// Worlds of the native engine, and what many of its tests put into them.
#pragma once

#include "../Testing.h"

namespace Shapes {

/// @param gravity  downward
inline std::unique_ptr<CWorld> MakeNative(const CEffectChoice& effects, float gravity = 0, float dt = g_fDt,
                                          unsigned substeps = 1) {
  CWorldDesc desc;
  desc.m_vGravity = {0, -gravity};
  desc.m_fTimeStep = dt;
  desc.m_nSubsteps = substeps;
  desc.m_cEffects = effects;
  return GetBackend(eBackend::Native)->MakeWorld(desc);
}

/// Kinematic, moving along.
template <class TDesc>
TDesc Moving(TDesc desc, const Vector2& vel) {
  desc.m_vVel = vel;
  return Turning(desc);
}

/// The walls of a closed polygon.
inline void AddRoom(CWorld& world, std::span<const Vector2> corners, float e = 1) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    world.Add(CLineSegDesc(corners[i], corners[(i + 1) % corners.size()], e));
}

/// Those of a square about the origin.
inline void AddBox(CWorld& world, float half, float e = 1) {
  const Vector2 corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  AddRoom(world, corners, e);
}

/// Per mass, above the floor on which a ball of radius r lies.
inline double EnergyOf(const CWorld& world, CShapeId ball, double g, double r) {
  return 0.5 * world.GetVel(ball).cast<double>().squaredNorm() +
         g * (static_cast<double>(world.GetPos(ball).y()) - r);
}

} // namespace Shapes
