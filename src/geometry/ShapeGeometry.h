// SPDX-License-Identifier: MIT
// A shape as the sweeps see it: in double, in its pose at the beginning of a substep, and how it moves and
// turns.
#pragma once

#include <Shapes/Shape.h>

#include "Vector.h"

namespace Shapes::Geometry {

/// Points use m_vCenter, segments the ends, circles centre and radius, arcs all. An arc runs counterclockwise
/// from end 0 to end 1, which are moved onto its circle (by less than their rounding), so that they do not
/// stick out.
struct CShapeGeometry {
  eShape m_eShapeType = eShape::Point;
  eSides m_eSides = eSides::Both;
  bool m_bFull = false;                      ///< The arc is the full circle.
  bool m_bWide = false;                      ///< The arc spans more than half the circle.
  bool m_bHasEnd0 = true, m_bHasEnd1 = true; ///< A segment or an arc without an end is met at the rest only.
  Vector2d m_vCenter = Vector2d::Zero();
  Vector2d m_vPt0 = Vector2d::Zero();
  Vector2d m_vPt1 = Vector2d::Zero();
  Vector2d m_vFront = Vector2d::UnitY(); ///< Unit normal of a segment, to the left from end 0 to 1.
  double m_fRadius = 0.0;
  Vector2d m_vRotCenter = Vector2d::Zero();
  Vector2d m_vVel = Vector2d::Zero(); ///< units per second; the centre of rotation moves along
  /// Radians per second, counterclockwise. 0 where the shape stays in its place, as what is round does when
  /// it turns about its own centre.
  double m_fTurnSpeed = 0.0;
  double m_fSpin = 0.0; ///< The same without this exception: how fast the surface moves.
  /// Largest coordinate, however it turns, plus the radius: what roundings are shares of.
  double m_fSize = 0.0;

  bool IsMoving() const { return m_fTurnSpeed != 0.0 || !m_vVel.isZero(0.0); }
  bool MovesAs(const CShapeGeometry& other) const {
    return m_fTurnSpeed == other.m_fTurnSpeed && m_vRotCenter == other.m_vRotCenter && m_vVel == other.m_vVel;
  }
  /// Of the surface at p, after the centre of rotation has moved for `time` seconds.
  Vector2d GetSurfaceVelocity(const Vector2d& p, double time) const {
    return m_vVel + m_fSpin * Perp(p - m_vRotCenter - time * m_vVel);
  }
};

/// The geometry of a shape in its present pose that is going to turn at this speed, in radians per second,
/// and to move at its velocity.
CShapeGeometry MakeShapeGeometry(const CShape& shape, double turnSpeed);

/// The geometry after its turn for `time` seconds, where it would be had it not moved. Error at most 4 eps
/// (size + angle * distance from the centre of rotation).
CShapeGeometry RotatedFor(const CShapeGeometry& shape, double time);

/// Whether x, measured from the centre, is in the sector of the arc. By cross products with the ends; a
/// direction within `slack` radians of an end ray is inside for slack > 0, outside for slack < 0.
bool InSector(const CShapeGeometry& arc, const Vector2d& x, double slack);

} // namespace Shapes::Geometry
