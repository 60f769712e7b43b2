// SPDX-License-Identifier: MIT
// Reports of a step: contacts, and shapes and sensors that balls begin or cease to touch.
#pragma once

#include <Shapes/ShapeMath.h>

#include <compare>
#include <cstdint>

namespace Shapes {

/// Names a shape in its world. Not used again after the shape is removed, unless a state of another world is
/// loaded. The default names none.
struct CShapeId {
  std::uint32_t m_nValue = 0;
  friend auto operator<=>(const CShapeId&, const CShapeId&) = default;
};

/// A contact of a ball during the last Step. A sensor gives one for each ball that touched it at any time of
/// a substep, with POI and normal at the end if they touch then, and else where they were closest.
struct CContactEvent {
  /// The shape; of two balls the one that was added later. Null (the default) if the ball hit a
  /// body that the game created in its b2World.
  CShapeId m_cShape;
  CShapeId m_cBall; ///< The ball; of two balls the one that was added first.
  Vector2 m_vPOI;   ///< Point of impact, user units.
  Vector2 m_vNorm;  ///< Unit normal from the shape to the ball.
  /// Native without Continuous: distance along the normal by which the ball was set back, user units. Else 0.
  float m_fSetback = 0.0f;
  /// Approach speed before the response, units per second, at least 0. Of sensors by the path of the ball,
  /// whose places are rounded.
  float m_fSpeed = 0.0f;
  bool m_bIsSensor = false; ///< Either of them is a sensor: there was no response.
  /// The impulse that the ball got along the normal, mass times velocity, at least 0: how hard it was hit. Of
  /// a ball that lies, the impulse that carried it through the substep. At most the largest float; of sensors
  /// 0.
  float m_fImpulse = 0.0f;
};

/// A ball and a solid shape, or another ball, begin or cease to touch. Touching begins with a contact, and
/// ends after the first substep without one in which they are farther apart than g_fTouchReach radii (on
/// Box2D than its skin and slop, .015 metres, in a tuned world .00375, if that is more): a ball that lies
/// begins once, and one that bounces begins and ends with each bounce. Bounces in consecutive substeps are
/// one. Every begin has its end, as that of a sensor has.
struct CTouchEvent {
  CShapeId m_cShape; ///< As in CContactEvent; null for all bodies of a game together.
  CShapeId m_cBall;
  bool m_bBegin = false;
  friend bool operator==(const CTouchEvent&, const CTouchEvent&) = default;
};

/// A ball and a sensor (a shape, or a ball that is one) begin or cease to touch. Every begin has its end: it
/// comes when they part, and in the next Step where one of the two was removed or turned off, is no sensor
/// any more, or does not meet the other's filter. Only LoadState ends them without telling. In a substep they
/// touch once at most: a ball that passes, bounces off and passes again within it begins once.
using CSensorEvent = CTouchEvent;

} // namespace Shapes
