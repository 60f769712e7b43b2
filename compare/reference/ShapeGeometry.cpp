// SPDX-License-Identifier: MIT
#include "ShapeGeometry.h"

#include <numbers>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

CShapeGeometry<double> ToGeometry(const CPoint& point) {
  CShapeGeometry<double> f;
  f.m_eShapeType = eShape::Point;
  f.m_vCenter = ToDouble(point.GetPos());
  return f;
}

CShapeGeometry<double> ToGeometry(const CLineSeg& seg) {
  CShapeGeometry<double> f;
  f.m_eShapeType = eShape::LineSeg;
  f.m_eSides = seg.GetSides();
  f.m_vPt0 = ToDouble(seg.GetEndPt0());
  f.m_vPt1 = ToDouble(seg.GetEndPt1());
  f.m_vCenter = f.m_vPt0;
  return f;
}

CShapeGeometry<double> ToGeometry(const CCircle& circle) {
  CShapeGeometry<double> f;
  f.m_eShapeType = eShape::Circle;
  f.m_vCenter = f.m_vPt0 = f.m_vPt1 = ToDouble(circle.GetPos());
  f.m_fRadius = static_cast<double>(circle.GetRadius());
  return f;
}

CShapeGeometry<double> ToGeometry(const CArc& arc) {
  CShapeGeometry<double> f = ToGeometry(static_cast<const CCircle&>(arc));
  f.m_eShapeType = eShape::Arc;
  f.m_eSides = arc.GetSides();
  f.m_bFull = arc.IsFullCircle();
  const CVec2d right(1.0, 0.0);
  const CVec2d e0 = Unit(CVec2d(ToDouble(arc.GetEndPt0()) - f.m_vCenter), right);
  const CVec2d e1 = Unit(CVec2d(ToDouble(arc.GetEndPt1()) - f.m_vCenter), right);
  // By the ends as they are rounded; where they fall together, the angles know.
  const double turn = Cross(e0, e1);
  const bool together = turn == 0.0 && e0.dot(e1) > 0.0;
  f.m_bWide = turn < 0.0 || (together && static_cast<double>(arc.GetSpan()) > std::numbers::pi);
  f.m_vPt0 += f.m_fRadius * e0;
  f.m_vPt1 += f.m_fRadius * e1;
  return f;
}

} // namespace

CShapeGeometry<double> MakeShapeGeometry(const CAnyShapeDesc& desc) {
  const auto pShape = MakeShape(desc);
  if (pShape->GetMotionType() == eMotion::Dynamic)
    throw std::invalid_argument("shapes has a ball: expected static and kinematic shapes");
  switch (pShape->GetShapeType()) {
  case eShape::Point: return ToGeometry(static_cast<const CPoint&>(*pShape));
  case eShape::LineSeg: return ToGeometry(static_cast<const CLineSeg&>(*pShape));
  case eShape::Circle: return ToGeometry(static_cast<const CCircle&>(*pShape));
  case eShape::Arc: return ToGeometry(static_cast<const CArc&>(*pShape));
  }
  throw std::invalid_argument("shapes has a shape that the reference does not know");
}

} // namespace Shapes::Compare
