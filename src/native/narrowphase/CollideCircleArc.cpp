// SPDX-License-Identifier: MIT
#include "Collide.h"
#include "OneSided.h"

#include <cmath>

namespace Shapes::Native {
namespace {

// Whether a ball inside the circle of the arc leaves past an end: it overlaps the nearer end and moves
// against the tangent there, that is off the arc, and more so than it moves into the arc. Bouncing it there
// would make it skip around the end. (Without the last condition a ball that comes straight at the arc near
// its end flies through it.)
bool LeavesPastEnd(const CArc& arc, const CBall& ball) {
  FailIf(arc.IsFullCircle());
  const float d0 = Length(ball.m_vPos - arc.GetEndPt0()), d1 = Length(ball.m_vPos - arc.GetEndPt1());
  FailIf(!(d0 < ball.m_fRadius || d1 < ball.m_fRadius));
  Vector2 t0, t1;
  arc.GetTangents(t0, t1);
  const bool nearEnd0 = d0 <= d1;
  const Vector2 out = nearEnd0 ? Vector2(-perp(t0)) : perp(t1); // from the centre to that end
  const Vector2 v = ball.m_vVel - arc.GetSurfaceVelocity(nearEnd0 ? arc.GetEndPt0() : arc.GetEndPt1());
  const float off = -v.dot(nearEnd0 ? t0 : t1);
  return off > 0.0f && off > v.dot(out);
}

} // namespace

bool CollideCircleArc(const CArc& arc, const CBall& ball, CHit& hit) {
  const Vector2 p = ball.m_vPos - arc.GetPos();
  const float d = Length(p), R = arc.GetRadius(), r = ball.m_fRadius;
  const float s = d - R;
  FailIf(!(std::abs(s) < r));
  FailIf(!arc.PtInSector(ball.m_vPos));

  // A ball that does not fit inside cannot touch the inside of the arc, only its ends.
  const bool inside = s < 0.0f;
  FailIf(inside && (r >= R || LeavesPastEnd(arc, ball)));

  const Vector2 phat = d > 0.0f ? Normalize(p) : Normalize(-ball.m_vVel);
  const Vector2 poi = arc.GetPos() + R * phat;
  const float vn = (ball.m_vVel - arc.GetSurfaceVelocity(poi)).dot(phat);
  float sign;
  FailIf(!ChooseSide(arc.GetSides(), s, Length(ball.m_vPrevPos - arc.GetPos()) - R, vn, sign));
  hit = {poi, sign * phat, r - sign * s};
  return true;
}

} // namespace Shapes::Native
