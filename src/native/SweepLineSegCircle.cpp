// SPDX-License-Identifier: MIT
#include "Search.h"

namespace Shapes::Native {

template <class TLeg>
void SweepLineSegCircle(CSearch<TLeg>& search) {
  const COutline& seg = search.GetShape();
  const Vector2d &p0 = seg.m_vPt0, &p1 = seg.m_vPt1;
  if (p0 == p1) return search.Meet(CRoundPart{p0, 0.0});
  const CLineSegPart whole{p0, p1, seg.m_vFront};
  if (seg.m_eSides == eSides::Both) return search.Meet(whole);

  // Of one solid side: its face where the foot of the perpendicular is between the ends, ...
  const double touch = search.GetLeg().GetTouch();
  const CFacePart face{p0, seg.m_eSides == eSides::Front ? seg.m_vFront : Vector2d(-seg.m_vFront)};
  const auto beyond0 = [&, t = whole.Along()](const Vector2d& p) { return t.dot(p0 - p); };
  const auto beyond1 = [&, t = whole.Along()](const Vector2d& p) { return t.dot(p - p1); };
  const auto between = [&](const Vector2d& p) { return beyond0(p) <= touch && beyond1(p) <= touch; };
  search.Meet(face, search.GetBallRadius(), between);
  // ... and the ends elsewhere. These let go whatever overlaps them; what slides off the face is not beyond
  // them where it would touch them.
  const auto solid = [&](const Vector2d& p) { return face.m_vNorm.dot(p - p0) >= -touch; };
  search.Meet(CRoundPart{p0, 0.0}, touch,
              [&](const Vector2d& p) { return beyond0(p) >= -touch && solid(p); });
  search.Meet(CRoundPart{p1, 0.0}, touch,
              [&](const Vector2d& p) { return beyond1(p) >= -touch && solid(p); });
}

SHAPES_SWEEP_FOR_ALL_LEGS(SweepLineSegCircle)

} // namespace Shapes::Native
