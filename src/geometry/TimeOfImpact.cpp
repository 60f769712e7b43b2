// SPDX-License-Identifier: MIT
#include "ImpactSearch.h"

namespace Shapes::Geometry {
namespace {

CRoundings Roundings(const CShapeGeometry& shape, const CMotion& motion) {
  const double size =
      std::max(shape.m_fSize, motion.m_vPos.cwiseAbs().maxCoeff() + shape.m_fRadius) + motion.m_fRadius;
  return {size, Norm(motion.m_vVel) + std::abs(shape.m_fTurnSpeed) * size};
}

// A ball that is smaller than what is touching would not be seen on the right side of what it has met.
CMotion Seen(CMotion motion, const CRoundings& roundings) {
  motion.m_fRadius = std::max(motion.m_fRadius, 0.5 * roundings.m_fTouch);
  return motion;
}

// The one place that goes from type to kernel.
template <class TMotion>
eSweep Run(const CShapeGeometry& shape, const TMotion& motion, double end, CImpact& impact) {
  CImpactSearch<TMotion> search(shape, motion, end, impact);
  switch (shape.m_eShapeType) {
  case eShape::Point: ImpactPointCircle(search); break;
  case eShape::LineSeg: ImpactLineSegCircle(search); break;
  case eShape::Circle: ImpactCircleCircle(search); break;
  case eShape::Arc: ImpactCircleArc(search); break;
  }
  return search.GetFound();
}

// In the frame that moves with the shape.
CMotion Relative(CMotion motion, const CShapeGeometry& shape, double start) {
  motion.m_vPos -= start * shape.m_vVel;
  motion.m_vVel -= shape.m_vVel;
  return motion;
}

// The impact on a shape that has moved for `time` seconds, in the frame at rest.
void Complete(const CShapeGeometry& shape, double time, CImpact& impact) {
  impact.m_vPOI += time * shape.m_vVel;
  impact.m_vSurface = shape.GetSurfaceVelocity(impact.m_vPOI, time);
}

} // namespace

eSweep Sweep(const CShapeGeometry& shape, const CMotion& moving, double start, CImpact& impact) {
  const CMotion ball = Relative(moving, shape, start);
  const CRoundings roundings = Roundings(shape, ball);
  const CMotion motion = Seen(ball, roundings);
  eSweep found;
  if (shape.m_fTurnSpeed == 0.0 && motion.m_vAcc.isZero(0.0)) {
    found = Run(shape, CLinearMotion(motion, roundings), motion.m_fDuration, impact);
  } else if (shape.m_fTurnSpeed == 0.0) {
    found = Run(shape, CParabolicMotion(shape, motion, roundings), motion.m_fDuration, impact);
  } else {
    const CShapeGeometry now = RotatedFor(shape, start);
    found = Run(now, CCurvedMotion(now, motion, roundings), motion.m_fDuration, impact);
    if (found != eSweep::Impact) return found;
    const double angle = shape.m_fTurnSpeed * impact.m_fTime;
    impact.m_vNorm = Turned(impact.m_vNorm, angle);
    impact.m_vPOI = shape.m_vRotCenter + Turned(impact.m_vPOI - shape.m_vRotCenter, angle);
  }
  if (found == eSweep::Impact) Complete(shape, start + impact.m_fTime, impact);
  return found;
}

bool IsOutOfWay(const CShapeGeometry& shape, const CMotion& moving, double start, double reach) {
  FailIf(shape.m_fTurnSpeed != 0.0);
  const CMotion motion = Relative(moving, shape, start);
  const Vector2d p = motion.m_vPos, way = motion.m_vVel * motion.m_fDuration,
                 fall = motion.m_vAcc * (0.5 * motion.m_fDuration * motion.m_fDuration);
  const double size = Largest(p) + Largest(way) + Largest(fall) + shape.m_fSize;
  const double far = motion.m_fRadius + reach + g_fFarRounding * size;
  // Along w, from a point of the shape beyond which nothing of it comes, |w| is the distance at first.
  const auto isPassed = [&](const Vector2d& w, double distance) {
    const double square = w.squaredNorm();
    const double least = square + std::min(0.0, w.dot(way)) + std::min(0.0, w.dot(fall));
    return least > 0.0 && least * least > distance * distance * square;
  };
  switch (shape.m_eShapeType) {
  case eShape::LineSeg: {
    const Vector2d along = shape.m_vPt1 - shape.m_vPt0, from0 = p - shape.m_vPt0;
    const double length = along.squaredNorm(), share = along.dot(from0);
    if (!(share > 0.0)) return isPassed(from0, far);
    if (!(share < length)) return isPassed(p - shape.m_vPt1, far);
    return isPassed(shape.m_vFront.dot(from0) * shape.m_vFront, far);
  }
  case eShape::Point: // a circle without radius
  case eShape::Circle:
  case eShape::Arc: break;
  }
  const Vector2d w = p - shape.m_vCenter;
  if (isPassed(w, shape.m_fRadius + far)) return true;
  // A falling ball is no farther from the centre than an end of its chord and the sagitta.
  const double inner = shape.m_fRadius - far - 0.25 * (std::abs(fall.x()) + std::abs(fall.y()));
  return inner > 0.0 && std::max(w.squaredNorm(), (w + way + fall).squaredNorm()) < inner * inner;
}

bool Near(const CShapeGeometry& shape, const CMotion& moving, double start, double reach, CImpact& impact,
          double& gap) {
  const CMotion ball = Relative(moving, shape, start);
  const CRoundings roundings = Roundings(shape, ball);
  const CMotion motion = Seen(ball, roundings);
  eSweep found;
  if (shape.m_fTurnSpeed == 0.0) {
    found = Run(shape, CStandingMotion(CLinearMotion(motion, roundings)), reach, impact);
  } else {
    const CShapeGeometry now = RotatedFor(shape, start);
    found = Run(now, CStandingMotion(CCurvedMotion(now, motion, roundings)), reach, impact);
  }
  FailIf(found != eSweep::Impact);
  // Subtract the radius inflation.
  gap = impact.m_fTime + (motion.m_fRadius - ball.m_fRadius);
  FailIf(!(gap < reach));
  impact.m_fTime = 0.0;
  Complete(shape, start, impact);
  return true;
}

bool Overlap(const CShapeGeometry& shape, const CMotion& ball, double start, CImpact& impact, double& depth) {
  FailIf(!Near(shape, ball, start, 0.0, impact, depth));
  depth = -depth;
  return true;
}

} // namespace Shapes::Geometry
