// SPDX-License-Identifier: MIT
#include "Detect.h"

namespace Shapes::Native {

bool Detect(const CShape& shape, const CBall& ball, CHit& hit) {
  switch (shape.GetShapeType()) {
  case eShape::Point: return DetectPointCircle(static_cast<const CPoint&>(shape), ball, hit);
  case eShape::LineSeg: return DetectLineSegCircle(static_cast<const CLineSeg&>(shape), ball, hit);
  case eShape::Circle: return DetectCircleCircle(static_cast<const CCircle&>(shape), ball, hit);
  case eShape::Arc: return DetectCircleArc(static_cast<const CArc&>(shape), ball, hit);
  case eShape::Unknown:
  case eShape::Line: break; // no shape that can be made has these types
  }
  return false;
}

} // namespace Shapes::Native
