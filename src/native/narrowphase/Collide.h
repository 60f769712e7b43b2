// SPDX-License-Identifier: MIT
// The pair kernels of the native engine: does a ball overlap a shape where both are now, and if so where is
// the point of the shape closest to its centre. In all of them the normal is a unit vector from the shape to
// the ball, moving the ball by setback along it leaves it touching, and a NaN in a position or a radius gives
// false. Each has a file of its own.
//
// Errors at most (ShapeMath.h says how they are counted), with p the centre of the ball, r its radius:
//
//                  answer, as a gap         POI                           setback
//   point          1 ulp r                  exact                         2 ulp r
//   segment        3 ulp |p-e0| + |p-e1|    as CLineSeg::ClosestPt        3 ulp |p-e0|, half an ulp r
//   circle, arc    2 ulp R + r              3 ulp |centre| + R            2 ulp R + r
//   two balls      2 ulp r0 + r             3 ulp |p0| + r0               2 ulp r0 + r
//
// Normals are within 2 ulp of 1 of the exact one, and their lengths within 1 ulp of 1. A centre that is that
// close to a segment (3 ulp |p-e0|), a ring or an arc (1 ulp of its distance from their centre) may count as
// on either side. The sector of an arc is that of CArc::PtInSector. From the point where the setback puts
// it, a ball overlaps by at most the error of the setback, 1 ulp of |p| + r for the rounding of its place,
// and 2 ulp r for the length of the normal.
#pragma once

#include <Shapes/Arc.h>
#include <Shapes/Circle.h>
#include <Shapes/LineSeg.h>
#include <Shapes/Point.h>

namespace Shapes::Native {

/// The input of a kernel: a ball.
struct CBall {
  Vector2 m_vPos;     ///< centre
  Vector2 m_vPrevPos; ///< centre at the beginning of the step
  Vector2 m_vVel;
  float m_fRadius;
};

struct CHit {
  Vector2 m_vPOI;
  Vector2 m_vNorm;
  float m_fSetback; ///< r - distance, at least 0
};

bool CollidePointCircle(const CPoint& point, const CBall& ball, CHit& hit);
bool CollideLineSegCircle(const CLineSeg& seg, const CBall& ball, CHit& hit);
/// A ring: a ball that fits into the circle and is inside meets it from inside.
bool CollideCircleCircle(const CCircle& circle, const CBall& ball, CHit& hit);
bool CollideCircleArc(const CArc& arc, const CBall& ball, CHit& hit);
/// Two solid balls; the normal points to `ball`.
bool CollideBallBall(const CBall& other, const CBall& ball, CHit& hit);

/// A ball against a point at p0: where the other kernels end when their shape has no extent.
bool CollidePt(const Vector2& p0, const CBall& ball, CHit& hit);

/// Any shape that is not a ball: the one place that goes from type to kernel.
bool Collide(const CShape& shape, const CBall& ball, CHit& hit);

} // namespace Shapes::Native
