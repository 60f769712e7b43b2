// SPDX-License-Identifier: MIT
#include "Search.h"

namespace Shapes::Native {
namespace {

CRoundings Roundings(const COutline& shape, const CLeg& leg) {
  const double size =
      std::max(shape.m_fSize, leg.m_vPos.cwiseAbs().maxCoeff() + shape.m_fRadius) + leg.m_fRadius;
  return {size, Norm(leg.m_vVel) + std::abs(shape.m_fTurnSpeed) * size};
}

// A ball that is smaller than what is touching would not be seen on the right side of what it has met.
CLeg Seen(CLeg leg, const CRoundings& roundings) {
  leg.m_fRadius = std::max(leg.m_fRadius, 0.5 * roundings.m_fTouch);
  return leg;
}

// The one place that goes from type to kernel.
template <class TLeg>
eSweep Run(const COutline& shape, const TLeg& leg, double end, CImpact& impact) {
  CSearch<TLeg> search(shape, leg, end, impact);
  switch (shape.m_eShapeType) {
  case eShape::Point: SweepPointCircle(search); break;
  case eShape::LineSeg: SweepLineSegCircle(search); break;
  case eShape::Circle: SweepCircleCircle(search); break;
  case eShape::Arc: SweepCircleArc(search); break;
  case eShape::Unknown:
  case eShape::Line: break; // no shape that can be made has these types
  }
  return search.GetFound();
}

} // namespace

eSweep Sweep(const COutline& shape, const CLeg& ball, double start, CImpact& impact) {
  const CRoundings roundings = Roundings(shape, ball);
  const CLeg leg = Seen(ball, roundings);
  eSweep found;
  if (shape.m_fTurnSpeed == 0.0) {
    found = Run(shape, CStraightLeg(leg, roundings), leg.m_fDuration, impact);
  } else {
    const COutline now = TurnedFor(shape, start);
    found = Run(now, CTurningLeg(now, leg, roundings), leg.m_fDuration, impact);
    if (found != eSweep::Impact) return found;
    const double angle = shape.m_fTurnSpeed * impact.m_fTime;
    impact.m_vNorm = Turned(impact.m_vNorm, angle);
    impact.m_vPOI = shape.m_vRotCenter + Turned(impact.m_vPOI - shape.m_vRotCenter, angle);
  }
  if (found == eSweep::Impact) impact.m_vSurface = shape.m_fSpin * Perp(impact.m_vPOI - shape.m_vRotCenter);
  return found;
}

bool Overlap(const COutline& shape, const CLeg& ball, double start, CImpact& impact, double& depth) {
  const CRoundings roundings = Roundings(shape, ball);
  const CLeg leg = Seen(ball, roundings);
  const COutline now = TurnedFor(shape, start);
  const eSweep found = shape.m_fTurnSpeed == 0.0
                           ? Run(now, CStanding(CStraightLeg(leg, roundings)), 0.0, impact)
                           : Run(now, CStanding(CTurningLeg(now, leg, roundings)), 0.0, impact);
  FailIf(found != eSweep::Impact);
  // What it is seen larger by is no overlap.
  depth = -impact.m_fTime - (leg.m_fRadius - ball.m_fRadius);
  FailIf(!(depth > 0.0));
  impact.m_fTime = 0.0;
  impact.m_vSurface = shape.m_fSpin * Perp(impact.m_vPOI - shape.m_vRotCenter);
  return true;
}

} // namespace Shapes::Native
