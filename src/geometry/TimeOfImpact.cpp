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
  case eShape::Unknown:
  case eShape::Line: break; // no shape that can be made has these types
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
