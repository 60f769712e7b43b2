// SPDX-License-Identifier: MIT
#include "ShapeGeometry.h"

#include "VisitShape.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace Shapes::Geometry {
namespace {

Vector2d Wide(const Vector2& v) { return v.cast<double>(); }

void SetLineSeg(CShapeGeometry& o, const CLineSeg& seg) {
  o.m_eSides = seg.GetSides();
  o.m_vPt0 = Wide(seg.GetEndPt0());
  o.m_vPt1 = Wide(seg.GetEndPt1());
  const Vector2d left = Perp(Unit(o.m_vPt1 - o.m_vPt0, Vector2d::UnitX()));
  // The ends of a segment that turns change places, its normal does not.
  const bool turnedOver = left.dot(Wide(seg.GetNormal())) < 0.0;
  if (turnedOver) std::swap(o.m_vPt0, o.m_vPt1);
  o.m_vFront = turnedOver ? Vector2d(-left) : left;
  o.m_vCenter = o.m_vPt0;
}

void SetArc(CShapeGeometry& o, const CArc& arc) {
  o.m_eSides = arc.GetSides();
  o.m_bFull = arc.IsFullCircle();
  const Vector2d e0 = Unit(Wide(arc.GetEndPt0()) - o.m_vCenter, Vector2d::UnitX());
  const Vector2d e1 = Unit(Wide(arc.GetEndPt1()) - o.m_vCenter, Vector2d::UnitX());
  // By the ends as they are rounded; where they fall together, the angles know.
  const double turn = Cross(e0, e1);
  const bool together = turn == 0.0 && e0.dot(e1) > 0.0;
  o.m_bWide = turn < 0.0 || (together && static_cast<double>(arc.GetSpan()) > std::numbers::pi);
  o.m_vPt0 += o.m_fRadius * e0;
  o.m_vPt1 += o.m_fRadius * e1;
}

} // namespace

CShapeGeometry MakeShapeGeometry(const CShape& shape, double turnSpeed) {
  CShapeGeometry o;
  o.m_eShapeType = shape.GetShapeType();
  o.m_vCenter = o.m_vPt0 = o.m_vPt1 = Wide(shape.GetPos());
  VisitShape(shape,
             CPerShape{[](const CPoint&) {}, [&](const CLineSeg& seg) { SetLineSeg(o, seg); },
                       [&](const CCircle& circle) { o.m_fRadius = static_cast<double>(circle.GetRadius()); },
                       [&](const CArc& arc) {
                         o.m_fRadius = static_cast<double>(arc.GetRadius());
                         SetArc(o, arc);
                       }});

  o.m_vVel = Wide(shape.GetVel());
  const Vector2d& c = o.m_vRotCenter = Wide(shape.GetRotCenter());
  const bool isRound = o.m_eShapeType == eShape::Point || o.m_eShapeType == eShape::Circle || o.m_bFull;
  o.m_fSpin = turnSpeed;
  o.m_fTurnSpeed = isRound && o.m_vCenter == c ? 0.0 : turnSpeed;
  const double turning = o.m_fTurnSpeed == 0.0 ? 0.0 : 1.0;
  for (const Vector2d& p : {o.m_vCenter, o.m_vPt0, o.m_vPt1})
    o.m_fSize = std::max({o.m_fSize, Largest(p), turning * (Largest(c) + Norm(p - c))});
  o.m_fSize += o.m_fRadius;
  return o;
}

CShapeGeometry RotatedFor(const CShapeGeometry& shape, double time) {
  CShapeGeometry o = shape;
  if (shape.m_fTurnSpeed == 0.0) return o;
  const double angle = shape.m_fTurnSpeed * time;
  for (Vector2d* p : {&o.m_vCenter, &o.m_vPt0, &o.m_vPt1})
    *p = o.m_vRotCenter + Turned(*p - o.m_vRotCenter, angle);
  o.m_vFront = Turned(o.m_vFront, angle);
  return o;
}

bool InSector(const CShapeGeometry& arc, const Vector2d& x, double slack) {
  if (arc.m_bFull) return true;
  const Vector2d e0 = arc.m_vPt0 - arc.m_vCenter, e1 = arc.m_vPt1 - arc.m_vCenter;
  const double least = -slack * Norm(x) * arc.m_fRadius;
  const bool in0 = Cross(e0, x) >= least, in1 = Cross(x, e1) >= least;
  if (arc.m_bWide) return in0 || in1;
  // The ray opposite to a very short arc is on both end lines too.
  return in0 && in1 && (!(e0.dot(e1) > 0.0) || x.dot(e0) > 0.0);
}

} // namespace Shapes::Geometry
