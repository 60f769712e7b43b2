// SPDX-License-Identifier: MIT
#include "SharedEnds.h"

#include "../../geometry/VisitShape.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace Shapes::Box2D {
namespace {

struct CEnd {
  const CShape* m_pShape;
  CShapeId m_cId;
  std::size_t m_nEnd;
  Vector2 m_vPos;
  Vector2 m_vInto;                  // unit tangent from the end into the shape
  float m_fBend;                    // curvature, positive to the left of the way into the shape
  bool m_bSolidLeft, m_bSolidRight; // of the way into the shape
  std::size_t m_nMatches = 0;
  const CEnd* m_pMatch = nullptr;
};

template <class TShape>
void AddEnds(const TShape& shape, CShapeId id, const Vector2& front, float curvature,
             std::vector<CEnd>& ends) {
  Vector2 p[2], t[2];
  shape.GetEndPts(p[0], p[1]);
  shape.GetTangents(t[0], t[1]);
  const bool isSolid[2] = {shape.GetSides() != eSides::Back, shape.GetSides() != eSides::Front};
  for (std::size_t i = 0; i < 2; ++i) {
    // The front of an arc is known at end 0; seen from end 1 left and right change places, as for a segment.
    const bool frontIsLeft = (perp(t[0]).dot(front) > 0.0f) == (i == 0);
    ends.push_back({&shape, id, i, p[i], t[i], i == 0 ? curvature : -curvature, isSolid[frontIsLeft ? 0 : 1],
                    isSolid[frontIsLeft ? 1 : 0]});
  }
}

void AddEnds(const CShapeEntry& entry, std::vector<CEnd>& ends) {
  const CShape& shape = *entry.m_pShape;
  if (!IsSolid(shape)) return;
  VisitShape(shape,
             CPerShape{[](const CPoint&) {}, [](const CCircle&) {},
                       [&](const CLineSeg& seg) {
                         if (seg.GetEndPt0() != seg.GetEndPt1())
                           AddEnds(seg, entry.m_cId, seg.GetNormal(), 0.0f, ends);
                       },
                       [&](const CArc& arc) {
                         // As a segment that is a point, an arc that is one joins nothing.
                         if (!arc.IsFullCircle() && arc.GetRadius() >= std::numeric_limits<float>::min())
                           AddEnds(arc, entry.m_cId, arc.GetEndPt0() - arc.GetPos(), 1.0f / arc.GetRadius(),
                                   ends);
                       }});
}

// Whether what meets one of them meets the other one in the same place.
bool AreAlike(const CShape& a, const CShape& b) {
  FailIf(a.GetMotionType() != b.GetMotionType() || a.GetFilter() != b.GetFilter());
  return a.GetMotionType() == eMotion::Static ||
         (a.GetVel() == b.GetVel() && a.GetRotCenter() == b.GetRotCenter() &&
          a.GetRotSpeed() == b.GetRotSpeed());
}

} // namespace

std::map<CShapeId, CSharedEnds> FindSharedEnds(const CWorldState& state, float tolerance) {
  std::vector<CEnd> ends;
  for (const CShapeEntry& entry : state.m_stdShapes)
    AddEnds(entry, ends);
  std::stable_sort(ends.begin(), ends.end(),
                   [](const CEnd& a, const CEnd& b) { return a.m_vPos.x() < b.m_vPos.x(); });

  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      CEnd &a = ends[i], &b = ends[j];
      if (b.m_vPos.x() - a.m_vPos.x() > tolerance) break;
      if (Length(b.m_vPos - a.m_vPos) > tolerance || !AreAlike(*a.m_pShape, *b.m_pShape)) continue;
      ++a.m_nMatches, ++b.m_nMatches;
      a.m_pMatch = &b, b.m_pMatch = &a;
    }

  std::map<CShapeId, CSharedEnds> sharedEnds;
  for (const CEnd& a : ends) {
    // Where three meet none of them goes on in another.
    if (a.m_nMatches != 1 || a.m_pMatch->m_nMatches != 1 || a.m_pMatch->m_cId == a.m_cId) continue;
    const CEnd& b = *a.m_pMatch;
    // Left of the way into one is right of the way into the other.
    if (a.m_bSolidLeft != b.m_bSolidRight || a.m_bSolidRight != b.m_bSolidLeft) continue;
    sharedEnds[a.m_cId][a.m_nEnd] = CSharedEnd{b.m_cId, b.m_vInto, b.m_fBend};
  }
  return sharedEnds;
}

} // namespace Shapes::Box2D
