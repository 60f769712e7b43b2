// SPDX-License-Identifier: MIT
// The contact of a shape and a ball.
#pragma once

#include <Shapes/ShapeMath.h>

namespace Shapes {

class CShape;
class CDynamicCircle;

/// Made with two shapes; CollisionDetected fills in the rest when it returns true.
class CContactDesc {
public:
  CContactDesc(CShape* pShape, CDynamicCircle* pCircle) : m_pShape(pShape), m_pCircle(pCircle) {}

  CShape* m_pShape;          ///< Any shape, another ball included.
  CDynamicCircle* m_pCircle; ///< The ball that responds.
  Vector2 m_vPOI =
      Vector2::Zero(); ///< Point of impact on m_pShape, user units. Native: the point of the shape closest
                       ///< to the ball. Box2D: the point touched at the time of impact.
  Vector2 m_vNorm = Vector2::Zero(); ///< Unit normal, from m_pShape to the ball.
  float m_fSetback = 0.0f; ///< Distance, at least 0, to move the ball along the normal until it only touches.
  /// Approach speed max(0, -(v - V) . n), V the velocity of the surface at the POI, units per second. Error
  /// on native at most 5 ulp of |v| + |V|, plus, where the shape turns, that of the POI times 2 pi times the
  /// rotation speed.
  float m_fSpeed = 0.0f;
};

} // namespace Shapes
