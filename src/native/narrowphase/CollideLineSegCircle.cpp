// SPDX-License-Identifier: MIT
#include "Collide.h"
#include "OneSided.h"

#include <cmath>

namespace Shapes::Native {

bool CollideLineSegCircle(const CLineSeg& seg, const CBall& ball, CHit& hit) {
  const Vector2 &p0 = seg.GetEndPt0(), &p1 = seg.GetEndPt1(), &p2 = ball.m_vPos;
  if (p0 == p1) return CollidePt(p0, ball, hit);

  // The ends are open: only a centre between them is met.
  Vector2 t0, t1;
  seg.GetTangents(t0, t1);
  FailIf(!((p2 - p0).dot(t0) >= 0.0f && (p2 - p1).dot(t1) >= 0.0f));

  const Vector2& nhat = seg.GetNormal();
  const float s = (p2 - p0).dot(nhat);
  FailIf(!(std::abs(s) < ball.m_fRadius));

  const Vector2 poi = seg.ClosestPt(p2);
  const float vn = (ball.m_vVel - seg.GetSurfaceVelocity(poi)).dot(nhat);
  float sign;
  FailIf(!ChooseSide(seg.GetSides(), s, (ball.m_vPrevPos - p0).dot(nhat), vn, sign));
  hit = {poi, sign * nhat, ball.m_fRadius - sign * s};
  return true;
}

} // namespace Shapes::Native
