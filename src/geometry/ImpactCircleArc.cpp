// SPDX-License-Identifier: MIT
#include "ImpactSearch.h"

namespace Shapes::Geometry {

template <class TMotion>
void ImpactCircleArc(CImpactSearch<TMotion>& search) {
  const CShapeGeometry& arc = search.GetShape();
  const Vector2d& c = arc.m_vCenter;
  const double R = arc.m_fRadius, r = search.GetBallRadius(), touch = search.GetMotion().GetTouch();
  const double slack = std::min(touch / (R > 0.0 ? R : 1.0), 1.0);
  const auto inSector = [&](const Vector2d& p) { return InSector(arc, p - c, slack); };
  // Overlapping by r the centre is on the circle: on the other side it is not on the solid one. Exactly on
  // it, it is on the side from which it came.
  const CBallAt ball = search.GetMotion().At(0.0);
  const Vector2d d = ball.m_vPos - c;
  const double out = Norm(d) == R ? d.dot(ball.m_vVel) : 0.0;
  if (arc.m_eSides != eSides::Back && !(out > 0.0)) search.KeepEarliest(CDisk{c, R}, r, inSector);
  if (arc.m_eSides != eSides::Front && r < R && !(out < 0.0)) search.KeepEarliest(CRing{c, R}, r, inSector);
  if (arc.m_bFull || search.HasFace()) return;

  const bool oneSided = arc.m_eSides != eSides::Both;
  const double side = arc.m_eSides == eSides::Back ? -1.0 : 1.0;
  for (const bool first : {true, false}) {
    if (!(first ? arc.m_bHasEnd0 : arc.m_bHasEnd1)) continue;
    const Vector2d &end = first ? arc.m_vPt0 : arc.m_vPt1, &other = first ? arc.m_vPt1 : arc.m_vPt0;
    search.KeepEarliest(
        CDisk{end, 0.0}, oneSided ? search.GetEndDepth() : std::numeric_limits<double>::infinity(),
        [&](const Vector2d& p) {
          if (InSector(arc, p - c, -slack)) return false;
          // On its way through it may reach the second end while it still overlaps the first.
          return !oneSided || (side * (Norm(p - c) - R) >= -touch && Norm(p - other) >= r - touch);
        });
  }
}

SHAPES_IMPACTS_FOR_ALL_MOTIONS(ImpactCircleArc)

} // namespace Shapes::Geometry
