// SPDX-License-Identifier: MIT
#include "Collide.h"

namespace Shapes::Native {

bool CollidePt(const Vector2& p0, const CBall& ball, CHit& hit) {
  const Vector2 p = ball.m_vPos - p0;
  const float d = Length(p);
  FailIf(!(d < ball.m_fRadius));
  // A centre exactly on the point goes back where it came from.
  hit = {p0, d > 0.0f ? Normalize(p) : Normalize(-ball.m_vVel), ball.m_fRadius - d};
  return true;
}

bool CollidePointCircle(const CPoint& point, const CBall& ball, CHit& hit) {
  return CollidePt(point.GetPos(), ball, hit);
}

} // namespace Shapes::Native
