// SPDX-License-Identifier: MIT
// The time step and the gravity that CShape::move uses.
#pragma once

#include <Shapes/Shape.h>

namespace Shapes {

/// Sets them as a game does.
struct CGameClock : CShapeCommon {
  static void Set(float dt, float gravity) {
    m_fTimeStep = dt;
    m_fGravity = gravity;
  }
};

} // namespace Shapes
