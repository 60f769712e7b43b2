// SPDX-License-Identifier: MIT
#include "ImpactSearch.h"

namespace Shapes::Geometry {

template <class TMotion>
void ImpactLineSegCircle(CImpactSearch<TMotion>& search) {
  const CShapeGeometry& seg = search.GetShape();
  const Vector2d &p0 = seg.m_vPt0, &p1 = seg.m_vPt1;
  if (p0 == p1) return search.KeepEarliest(CDisk{p0, 0.0});
  const CSegment whole{p0, p1, seg.m_vFront};
  if (seg.m_eSides == eSides::Both) return search.KeepEarliest(whole);

  // Of one solid side: its face where the foot of the perpendicular is between the ends, ...
  const double touch = search.GetMotion().GetTouch();
  const CHalfPlane face{p0, seg.m_eSides == eSides::Front ? seg.m_vFront : Vector2d(-seg.m_vFront)};
  const auto beyond0 = [&, t = whole.Along()](const Vector2d& p) { return t.dot(p0 - p); };
  const auto beyond1 = [&, t = whole.Along()](const Vector2d& p) { return t.dot(p - p1); };
  const auto between = [&](const Vector2d& p) { return beyond0(p) <= touch && beyond1(p) <= touch; };
  search.KeepEarliest(face, search.GetBallRadius(), between);
  // ... and the ends elsewhere. These ignore balls that overlap them; a ball that slides off the face is not
  // beyond them where it would touch them.
  const auto solid = [&](const Vector2d& p) { return face.m_vNorm.dot(p - p0) >= -touch; };
  search.KeepEarliest(CDisk{p0, 0.0}, search.GetEndDepth(),
                      [&](const Vector2d& p) { return beyond0(p) >= -touch && solid(p); });
  search.KeepEarliest(CDisk{p1, 0.0}, search.GetEndDepth(),
                      [&](const Vector2d& p) { return beyond1(p) >= -touch && solid(p); });
}

SHAPES_IMPACTS_FOR_ALL_MOTIONS(ImpactLineSegCircle)

} // namespace Shapes::Geometry
