// SPDX-License-Identifier: MIT
#include "ImpactSearch.h"

namespace Shapes::Geometry {

template <class TMotion>
void ImpactLineSegCircle(CImpactSearch<TMotion>& search) {
  const CShapeGeometry& seg = search.GetShape();
  const Vector2d &p0 = seg.m_vPt0, &p1 = seg.m_vPt1;
  if (p0 == p1) return search.KeepEarliest(CDisk{p0, 0.0});
  const CSegment whole{p0, p1, seg.m_vFront};
  const bool hasBothEnds = seg.m_bHasEnd0 && seg.m_bHasEnd1, isSolid = seg.m_eSides == eSides::Both;
  if (isSolid && hasBothEnds) return search.KeepEarliest(whole);

  // Of each solid side: its face where the foot of the perpendicular is between the ends, ...
  const double touch = search.GetMotion().GetTouch();
  const CHalfPlane front{p0, seg.m_vFront}, back{p0, Vector2d(-seg.m_vFront)};
  const CHalfPlane& face = seg.m_eSides == eSides::Back ? back : front;
  const auto beyond0 = [&, t = whole.Along()](const Vector2d& p) { return t.dot(p0 - p); };
  const auto beyond1 = [&, t = whole.Along()](const Vector2d& p) { return t.dot(p - p1); };
  const auto between = [&](const Vector2d& p) { return beyond0(p) <= touch && beyond1(p) <= touch; };
  search.KeepEarliest(face, search.GetBallRadius(), between);
  if (isSolid) search.KeepEarliest(back, search.GetBallRadius(), between);
  // ... and the ends elsewhere. Those of one solid side ignore balls that overlap them; a ball that slides
  // off the face is not beyond them where it would touch them.
  const double deepest = isSolid ? std::numeric_limits<double>::infinity() : search.GetEndDepth();
  const auto solid = [&](const Vector2d& p) { return isSolid || face.m_vNorm.dot(p - p0) >= -touch; };
  if (seg.m_bHasEnd0)
    search.KeepEarliest(CDisk{p0, 0.0}, deepest,
                        [&](const Vector2d& p) { return beyond0(p) >= -touch && solid(p); });
  if (seg.m_bHasEnd1)
    search.KeepEarliest(CDisk{p1, 0.0}, deepest,
                        [&](const Vector2d& p) { return beyond1(p) >= -touch && solid(p); });
}

SHAPES_IMPACTS_FOR_ALL_MOTIONS(ImpactLineSegCircle)

} // namespace Shapes::Geometry
