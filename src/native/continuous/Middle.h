// SPDX-License-Identifier: MIT
#pragma once

#include "../../geometry/Vector.h"

namespace Shapes::Native {

/// The middle of a curve along which a ball slides, since the beginning of a part of its way: it moves along,
/// and turns about a point that moves along.
struct CMiddle {
  Vector2d m_vPos, m_vVel;
  Vector2d m_vFromRot; ///< from that point
  double m_fTurnSpeed; ///< radians per second

  Vector2d PosAt(double t) const {
    if (m_fTurnSpeed == 0.0) return m_vPos + t * m_vVel;
    return m_vPos + t * m_vVel + (Geometry::Turned(m_vFromRot, m_fTurnSpeed * t) - m_vFromRot);
  }
  Vector2d VelAt(double t) const {
    if (m_fTurnSpeed == 0.0) return m_vVel;
    return m_vVel + m_fTurnSpeed * Geometry::Perp(Geometry::Turned(m_vFromRot, m_fTurnSpeed * t));
  }
  /// At the beginning.
  Vector2d GetAcc() const { return -m_fTurnSpeed * m_fTurnSpeed * m_vFromRot; }
};

} // namespace Shapes::Native
