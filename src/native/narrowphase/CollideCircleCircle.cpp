// SPDX-License-Identifier: MIT
#include "Collide.h"

namespace Shapes::Native {

bool CollideCircleCircle(const CCircle& circle, const CBall& ball, CHit& hit) {
  const Vector2 p = ball.m_vPos - circle.GetPos();
  const float d = Length(p), R = circle.GetRadius(), r = ball.m_fRadius;

  // Exactly on the ring, the side where it was; failing that, the one from which it comes.
  const float dPrev = d == R ? Length(ball.m_vPrevPos - circle.GetPos()) : d;
  const bool within = dPrev < R || (dPrev == R && p.dot(ball.m_vVel) > 0.0f);
  // A ball too large to fit into the ring is always outside, however deep.
  const bool inside = within && r < R;
  const float gap = inside ? R - d : d - R;
  FailIf(!(gap < r));

  const Vector2 phat = d > 0.0f ? Normalize(p) : Normalize(-ball.m_vVel);
  hit = {circle.GetPos() + R * phat, inside ? Vector2(-phat) : phat, r - gap};
  return true;
}

} // namespace Shapes::Native
