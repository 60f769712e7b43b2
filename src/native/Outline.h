// SPDX-License-Identifier: MIT
// A shape as the sweeps see it: in double, in its pose at the beginning of a substep, and how it turns.
#pragma once

#include <Shapes/Shape.h>

#include <cmath>
#include <limits>

namespace Shapes::Native {

using Vector2d = Eigen::Vector2d;

/// z component of a x b.
inline double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
/// Counterclockwise perpendicular.
inline Vector2d Perp(const Vector2d& v) { return {-v.y(), v.x()}; }
// These divide only what can be divided: a compiler may compute what is not needed, and that must not raise
// an exception either.
/// Length, also where the squares underflow. Coordinates up to 1e150.
inline double Norm(const Vector2d& v) {
  const bool tiny = v.squaredNorm() < 0x1p-900;
  const double scale = tiny ? 0x1p500 : 1.0, back = tiny ? 0x1p-500 : 1.0;
  return back * std::sqrt((scale * v).squaredNorm());
}
/// Unit vector along v; `fallback` for the zero vector.
inline Vector2d Unit(const Vector2d& v, const Vector2d& fallback) {
  const double d = Norm(v);
  const Vector2d unit = v / (d > 0.0 ? d : 1.0);
  return d > 0.0 ? unit : fallback;
}
/// above / below, of what is not negative; infinite if that is more than `most`, or if both are 0.
inline double Quotient(double above, double below, double most) {
  const bool fits = below > 0.0 && above <= most * below;
  return (fits ? above : std::numeric_limits<double>::infinity()) / (fits ? below : 1.0);
}
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
  Vector2d m_vPt0 = Vector2d::Zero();
  Vector2d m_vPt1 = Vector2d::Zero();
  Vector2d m_vFront = Vector2d::UnitY(); ///< Unit normal of a segment, to the left from end 0 to 1.
  double m_fRadius = 0.0;
  Vector2d m_vRotCenter = Vector2d::Zero();
  /// Radians per second, counterclockwise. 0 where the shape stays in its place, as what is round does when
  /// it turns about its own centre.
  double m_fTurnSpeed = 0.0;
  double m_fSpin = 0.0; ///< The same without this exception: how fast the surface moves.
  /// Largest coordinate, however it turns, plus the radius: what roundings are shares of.
  double m_fSize = 0.0;
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
