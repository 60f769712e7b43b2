// SPDX-License-Identifier: MIT
// The geometry of a shape in the exact reference.
#pragma once

#include "Vec2.h"

#include <Shapes/World.h>

namespace Shapes::Compare {

/// The geometry of a shape. Points use m_vCenter, segments the ends, circles centre and radius, arcs all. An
/// arc runs counterclockwise from end 0 to end 1, both on its circle.
template <class T>
struct CShapeGeometry {
  eShape m_eShapeType = eShape::Point;
  eSides m_eSides = eSides::Both;
  bool m_bFull = false; ///< The arc is the full circle.
  bool m_bWide = false; ///< The arc spans more than half the circle.
  CVec<T> m_vCenter = CVec<T>::Zero();
  CVec<T> m_vPt0 = CVec<T>::Zero();
  CVec<T> m_vPt1 = CVec<T>::Zero();
  T m_fRadius = T(0);

  /// The same for another scalar.
  template <class U>
  CShapeGeometry<U> Cast() const {
    return {m_eShapeType,
            m_eSides,
            m_bFull,
            m_bWide,
            m_vCenter.template cast<U>(),
            m_vPt0.template cast<U>(),
            m_vPt1.template cast<U>(),
            U(m_fRadius)};
  }
};

/// Whether x, measured from the centre, is in the sector of the arc. By cross products with the ends; a
/// direction within `slack` of an end ray is inside for slack > 0, outside for slack < 0.
template <class T>
bool InSector(const CShapeGeometry<T>& arc, const CVec<T>& x, const T& slack) {
  if (arc.m_bFull) return true;
  const CVec<T> e0 = arc.m_vPt0 - arc.m_vCenter, e1 = arc.m_vPt1 - arc.m_vCenter;
  const T least = -slack * Norm(x) * arc.m_fRadius;
  const bool in0 = Cross(e0, x) >= least, in1 = Cross(x, e1) >= least;
  if (arc.m_bWide) return in0 || in1;
  // The ray opposite to a very short arc is on both end lines too.
  return in0 && in1 && (!(e0.dot(e1) > T(0)) || x.dot(e0) > T(0));
}

/// The figure that is solid for a descriptor, from the shape that the library makes of it: its rounded floats
/// as doubles. The ends of an arc are moved onto its circle (by less than their rounding), so that they do
/// not stick out.
/// @throws std::invalid_argument if the library refuses the descriptor, or for a ball
CShapeGeometry<double> MakeShapeGeometry(const CAnyShapeDesc& desc);

} // namespace Shapes::Compare
