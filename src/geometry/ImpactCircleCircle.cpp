// SPDX-License-Identifier: MIT
#include "ImpactSearch.h"

namespace Shapes::Geometry {

template <class TMotion>
void ImpactCircleCircle(CImpactSearch<TMotion>& search) {
  const Vector2d& c = search.GetShape().m_vCenter;
  const double R = search.GetShape().m_fRadius;
  const CBallAt ball = search.GetMotion().At(0.0);
  const Vector2d d = ball.m_vPos - c;
  const double dist = Norm(d);
  // Exactly on the ring, the side from which it came.
  const bool within = dist < R || (dist == R && d.dot(ball.m_vVel) > 0.0);
  if (within && search.GetBallRadius() < R)
    search.KeepEarliest(CRing{c, R});
  else
    search.KeepEarliest(CDisk{c, R});
}

SHAPES_IMPACTS_FOR_ALL_MOTIONS(ImpactCircleCircle)

} // namespace Shapes::Geometry
