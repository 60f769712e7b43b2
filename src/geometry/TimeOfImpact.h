// SPDX-License-Identifier: MIT
// The time of impact of a ball and a shape on a straight path or a parabola, in double. The normal is a unit
// vector from the shape to the ball.
//
// An impact is the first time at which the ball touches the shape AND approaches it. Solid are: points; both
// faces and the round ends of segments; the ring of a circle, met from outside, and from inside by a ball
// that fits in (r < R; one that does not is always outside); arcs like rings in their sector (one that does
// not fit meets only the ends from inside), and their round ends. A one-sided segment or arc is met only by a
// centre on its solid side; one that comes from the open side passes, ends included.
//
// A ball that touches or overlaps at the beginning is met at once if it approaches. Otherwise it is ignored,
// and met when it begins to approach: never on a straight way from a convex feature; at a turning shape
// before it is deeper by a ten-thousandth of the overlap. The ends of one-sided shapes ignore balls
// that overlap them. Gaps up to g_nSweepRoundings roundings of the coordinates are touching, and approach
// speeds up to as many roundings of the speeds are none.
//
// Coordinates and speeds may be as large as accepted values make them (up to 1e28, durations up to 1e6
// seconds): nothing overflows or is NaN.
#pragma once

#include "ShapeGeometry.h"

namespace Shapes::Geometry {

/// A part of the path of a ball: a parabola, or straight.
struct CMotion {
  Vector2d m_vPos; ///< of the centre at the beginning
  Vector2d m_vVel; ///< likewise
  double m_fRadius;
  double m_fDuration;                 ///< seconds, at least 0
  Vector2d m_vAcc = Vector2d::Zero(); ///< units per second squared

  Vector2d PosAt(double t) const { return m_vPos + (m_vVel + 0.5 * t * m_vAcc) * t; }
  Vector2d VelAt(double t) const { return m_vVel + t * m_vAcc; }
  /// How far the path is from its chord at most.
  double GetSagitta() const { return 0.125 * Norm(m_vAcc) * m_fDuration * m_fDuration; }
};

struct CImpact {
  double m_fTime = 0.0;                   ///< seconds from the beginning of the motion
  Vector2d m_vPOI = Vector2d::Zero();     ///< of the shape, in the world at that time
  Vector2d m_vNorm = Vector2d::Zero();    ///< likewise
  Vector2d m_vSurface = Vector2d::Zero(); ///< velocity of the shape at the POI
  /// How fast the gap closes again after touching, units per second squared: one that opens at rate u is
  /// u t - m_fCurve t^2/2 at least, for short t and with the velocity across n that it has. 0 for what is
  /// convex and rests, (speed across n)^2 / (R - r) inside a ring or an arc.
  double m_fCurve = 0.0;
  /// Minus the second derivative of the gap: what closes it again if it stays as it is, units per second
  /// squared. Where a shape turns, only of a ball that falls.
  double m_fClosing = 0.0;
  double m_fRadius = 0.0; ///< Of curvature of the shape at the POI: CSpot::m_fRadius.
};

enum class eSweep {
  None,
  Impact,
  /// No impact before m_fTime, of the impact only this is set. The time after it is not searched: the shape
  /// turns so often that g_nMaxAdvancementSteps were not enough. A motion that begins there can go on.
  OutOfIterations
};

/// The first impact in [0, duration] on a shape that has moved and turned for `start` seconds when the motion
/// begins.
/// Error of the time at most (g_nSweepRoundings + 16) eps (size of the coordinates and of the way) / approach
/// speed + 4 eps t; where the shape rests 16 instead of the first factor, unless the ball touches at time 0.
/// Where it turns, the size is to be multiplied by 1 + the angle by which it has turned. The POI and the way
/// of the centre along the normal err by as much as the time times the approach speed. The ball overlaps by
/// no more than that.
eSweep Sweep(const CShapeGeometry& shape, const CMotion& motion, double start, CImpact& impact);

/// Whether surely the ball stays farther than `reach` from the shape, told without a root: Sweep finds no
/// impact then. By the component of the motion away from the shape's closest point, or from the centre of
/// what is round; inside a circle by how far from the centre the ends of the motion are. False for turning
/// shapes. Roundings of the kernels are allowed for.
bool IsOutOfWay(const CShapeGeometry& shape, const CMotion& motion, double start, double reach);

/// Two balls on motions that begin at the same time, until the shorter one ends. The normal points to `ball`,
/// the surface is that of `other`. Swapping the balls changes signs only.
eSweep ImpactBallBall(const CMotion& other, const CMotion& ball, CImpact& impact);

/// Whether the ball overlaps the shape at the beginning of the motion, and if so how deep: moving it by
/// `depth` along the normal leaves it touching. The time is 0. A one-sided shape is overlapped only by a
/// centre on its solid side, and not at its ends.
bool Overlap(const CShapeGeometry& shape, const CMotion& motion, double start, CImpact& impact,
             double& depth);
bool OverlapBallBall(const CMotion& other, const CMotion& ball, CImpact& impact, double& depth);

/// Whether the gap at the beginning of the motion is less than `reach`, and where: the smallest of several in
/// `gap`, negative where they overlap. The time is 0; one-sided shapes as in Overlap.
bool Near(const CShapeGeometry& shape, const CMotion& motion, double start, double reach, CImpact& impact,
          double& gap);
bool NearBallBall(const CMotion& other, const CMotion& ball, double reach, CImpact& impact, double& gap);

} // namespace Shapes::Geometry
