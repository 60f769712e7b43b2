// SPDX-License-Identifier: MIT
#include "Search.h"

namespace Shapes::Native {

template <class TLeg>
void SweepCircleCircle(CSearch<TLeg>& search) {
  const Vector2d& c = search.GetShape().m_vCenter;
  const double R = search.GetShape().m_fRadius;
  const CSeenBall ball = search.GetLeg().At(0.0);
  const Vector2d d = ball.m_vPos - c;
  const double dist = Norm(d);
  // Exactly on the ring, the side from which it came.
  const bool within = dist < R || (dist == R && d.dot(ball.m_vVel) > 0.0);
  if (within && search.GetBallRadius() < R)
    search.Meet(CInsidePart{c, R});
  else
    search.Meet(CRoundPart{c, R});
}

SHAPES_SWEEP_FOR_ALL_LEGS(SweepCircleCircle)

} // namespace Shapes::Native
