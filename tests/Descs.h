// SPDX-License-Identifier: MIT
// Descriptions of shapes and worlds in one expression.
#pragma once

#include "Numbers.h"

#include <Shapes/Shapes.h>

#include <array>

namespace Shapes {

/// Kinematic, turning so many times a second about a centre.
template <class TDesc>
TDesc Turning(TDesc desc, float revsPerSecond = 0, const Vector2& center = Vector2::Zero()) {
  desc.m_eMotionType = eMotion::Kinematic;
  desc.m_fRotSpeed = revsPerSecond;
  desc.m_vRotCenter = center;
  return desc;
}

/// Solid on these sides.
template <class TDesc>
TDesc Sided(TDesc desc, eSides sides) {
  desc.m_eSides = sides;
  return desc;
}

/// Kinematic, moving along.
template <class TDesc>
TDesc Moving(TDesc desc, const Vector2& vel) {
  desc.m_vVel = vel;
  return Turning(desc);
}

template <class TDesc>
TDesc Filtered(TDesc desc, const CFilter& filter) {
  desc.m_cFilter = filter;
  return desc;
}

/// Detects only.
template <class TDesc>
TDesc Sensor(TDesc desc) {
  desc.m_bIsSensor = true;
  return desc;
}

/// Four walls of a box: at the bottom, on the right, at the top, on the left.
inline std::array<CLineSegDesc, 4> Walls(const Vector2& low, const Vector2& high, float e = 1) {
  const Vector2 right(high.x(), low.y()), left(low.x(), high.y());
  return {CLineSegDesc(low, right, e), CLineSegDesc(right, high, e), CLineSegDesc(left, high, e),
          CLineSegDesc(low, left, e)};
}

inline CCircleDesc MakeZone(const Vector2& p = Vector2::Zero(), float r = 1) {
  return Sensor(CCircleDesc(p, r));
}

/// The description of a world.
inline CWorldDesc Described(const Vector2& gravity, float dt = g_fDt, unsigned substeps = 1,
                            const CEffectChoice& choice = g_cAutomatic,
                            eProfile profile = eProfile::Shipped) {
  CWorldDesc desc;
  desc.m_vGravity = gravity;
  desc.m_fTimeStep = dt;
  desc.m_nSubsteps = substeps;
  desc.m_cEffects = choice;
  desc.m_cBox2D.m_eProfile = profile;
  return desc;
}

} // namespace Shapes
