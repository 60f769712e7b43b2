// SPDX-License-Identifier: MIT
#include "Collide.h"

namespace Shapes::Native {

bool CollideBallBall(const CBall& other, const CBall& ball, CHit& hit) {
  const Vector2 p = ball.m_vPos - other.m_vPos;
  const float d = Length(p), r = other.m_fRadius + ball.m_fRadius;
  FailIf(!(d < r));
  const Vector2 phat = d > 0.0f ? Normalize(p) : Normalize(other.m_vVel - ball.m_vVel);
  hit = {other.m_vPos + other.m_fRadius * phat, phat, r - d};
  return true;
}

} // namespace Shapes::Native
