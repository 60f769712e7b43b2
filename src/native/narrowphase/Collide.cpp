// SPDX-License-Identifier: MIT
#include "Collide.h"

namespace Shapes::Native {

bool Collide(const CShape& shape, const CBall& ball, CHit& hit) {
  switch (shape.GetShapeType()) {
  case eShape::Point: return CollidePointCircle(static_cast<const CPoint&>(shape), ball, hit);
  case eShape::LineSeg: return CollideLineSegCircle(static_cast<const CLineSeg&>(shape), ball, hit);
  case eShape::Circle: return CollideCircleCircle(static_cast<const CCircle&>(shape), ball, hit);
  case eShape::Arc: return CollideCircleArc(static_cast<const CArc&>(shape), ball, hit);
  case eShape::Unknown:
  case eShape::Line: break; // no shape that can be made has these types
  }
  return false;
}

} // namespace Shapes::Native
