// SPDX-License-Identifier: MIT
// Where a ball really meets a shape: Box2D stops it near there, within its skin and at a chord of an arc.
#pragma once

#include "../../geometry/Vector.h"

namespace Shapes::Box2D {

/// The shape itself, in the frame of its body, in Box2D's metres.
struct CContactGeometry {
  enum class eKind { Disk, LineSeg, Arc };
  /// An end of a segment or an arc.
  struct CEnd {
    Vector2d m_vPos = Vector2d::Zero();
    Vector2d m_vOut = Vector2d::Zero(); ///< Unit tangent that leaves the shape there.
    bool m_bIsShared = false;
    Vector2d m_vNext = Vector2d::Zero(); ///< If joined: unit tangent into the neighbour,
    double m_fBend = 0.0;                ///< and its curvature, positive to the left of that.
  };

  eKind m_eKind = eKind::Disk;
  Vector2d m_vCentre = Vector2d::Zero(); ///< Of disks and arcs.
  double m_fRadius = 0.0;                ///< Of disks (0 for a point) and arcs.
  bool m_bFull = false;                  ///< An arc that is a full circle has no ends.
  bool m_bIsOneSided = false;            ///< A ball may be on its way through it.
  bool m_bLong = false;                  ///< An arc of more than half a circle.
  CEnd m_cEnd0{}, m_cEnd1{};             ///< An arc runs counterclockwise from end 0.
};

struct CExactContact {
  Vector2d m_vNorm = Vector2d::Zero(); ///< Unit normal from the shape to the ball where they meet.
  double m_fTime = 0.0;                ///< Seconds until they meet; negative if that is over.
  double m_fGap = 0.0;    ///< Distance now, less the radius of the ball; negative if they overlap.
  bool m_bMisses = false; ///< The way of the ball goes past the shape.
};

/// The contact of a ball that is near a shape, if it goes straight on as it does now, or has come so.
/// Where it does not approach, or its way misses the shape, the time is 0 and the normal is that of now;
/// of a way that misses it the part across the way, so that there is no response. A ball that overlaps a
/// face, but came past an end that it parts from, has the time 0 too, and responds along the normal of now.
///
/// Near is nearer than half of the smallest of these: the radius of the ball, of an arc and of what is left
/// of it for a ball inside, the length of a segment. Farther ahead what is first is not looked for.
///
/// Moved on by m_fTime the ball touches the shape, or what is joined to it, within 2^-50 of the sum of
/// all coordinates and radii; the normal is that of the place, within the same share of that sum over the
/// smallest of those. Traced back out of two parts of a shape at once it touches one of them.
/// @param q  centre of the ball in the frame of the geometry, metres; on the side that it comes from
/// @param w  its velocity relative to the surface, metres per second
/// @param r  its radius, metres
CExactContact FindExactContact(const CContactGeometry& geometry, const Vector2d& q, const Vector2d& w,
                               double r);

} // namespace Shapes::Box2D
