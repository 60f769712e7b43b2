// SPDX-License-Identifier: MIT
// The results of queries of a world: hits of casts, and closest points.
#pragma once

#include <Shapes/Events.h>
#include <Shapes/ShapeMath.h>

namespace Shapes {

/// Where a point or a circle that moves along a segment first touches.
struct CCastHit {
  CShapeId m_cShape;
  float m_fShare = 0.0f; ///< Fraction of the segment at which it touches, 0 .. 1.
  Vector2 m_vPOI;        ///< On the shape, user units.
  Vector2 m_vNorm;       ///< Unit, from the shape to the point or the circle.
};

/// The point of a shape or a ball that is closest to a place.
struct CClosestHit {
  CShapeId m_cShape;
  float m_fDistance = 0.0f; ///< User units; in a ball as far below 0 as its rim is away.
  Vector2 m_vPOI;           ///< On the shape.
  Vector2 m_vNorm;          ///< Unit, from the shape to the place, in a ball from its centre.
};

} // namespace Shapes
