// SPDX-License-Identifier: MIT
// A shape as the sweeps see it: in double, in its pose at the beginning of a substep, and how it turns.
#pragma once

#include <Shapes/Shape.h>

#include <cmath>

namespace Shapes::Native {

using Vector2d = Eigen::Vector2d;

/// z component of a x b.
inline double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
/// Counterclockwise perpendicular.
inline Vector2d Perp(const Vector2d& v) { return {-v.y(), v.x()}; }
/// Length, also where the squares underflow. Coordinates up to 1e150.
double Norm(const Vector2d& v);
/// Unit vector along v; `fallback` for the zero vector.
Vector2d Unit(const Vector2d& v, const Vector2d& fallback);
/// v turned counterclockwise by `angle` radians.
Vector2d Turned(const Vector2d& v, double angle);

/// Points use m_vCenter, segments the ends, circles centre and radius, arcs all. An arc runs counterclockwise
/// from end 0 to end 1, which are moved onto its circle (by less than their rounding), so that they do not
/// stick out.
struct COutline {
  eShape m_eShapeType = eShape::Unknown;
  eSides m_eSides = eSides::Both;
  bool m_bFull = false; ///< The arc is the full circle.
  bool m_bWide = false; ///< The arc spans more than half the circle.
  Vector2d m_vCenter = Vector2d::Zero();
  Vector2d m_vPt0 = Vector2d::Zero(); ///< End 1 of a segment is to the right of its front, seen along it.
  Vector2d m_vPt1 = Vector2d::Zero();
  Vector2d m_vFront = Vector2d::UnitY(); ///< Unit normal of a segment.
  double m_fRadius = 0.0;
  Vector2d m_vRotCenter = Vector2d::Zero();
  /// Radians per second, counterclockwise. 0 where the shape stays in its place, as what is round does when
  /// it turns about its own centre.
  double m_fTurnSpeed = 0.0;
  double m_fSpin = 0.0; ///< The same without this exception: how fast the surface moves.
  double m_fSize =
      0.0; ///< Largest coordinate, however it turns, plus the radius: what roundings are shares of.
};

/// The outline of a shape in its present pose that is going to turn at this speed, in radians per second.
COutline MakeOutline(const CShape& shape, double turnSpeed);

/// The outline after its turn for `time` seconds. Error at most 4 eps (size + angle * distance from the
/// centre of rotation).
COutline TurnedFor(const COutline& shape, double time);

/// Whether x, measured from the centre, is in the sector of the arc. By cross products with the ends; a
/// direction within `slack` radians of an end ray is inside for slack > 0, outside for slack < 0.
bool InSector(const COutline& arc, const Vector2d& x, double slack);

} // namespace Shapes::Native
