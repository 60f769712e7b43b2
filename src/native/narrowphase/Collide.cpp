// SPDX-License-Identifier: MIT
#include "Collide.h"

#include "../../geometry/VisitShape.h"

namespace Shapes::Native {

bool Collide(const CShape& shape, const CBall& ball, CHit& hit) {
  return VisitShape(shape,
                    CPerShape{[&](const CPoint& point) { return CollidePointCircle(point, ball, hit); },
                              [&](const CLineSeg& seg) { return CollideLineSegCircle(seg, ball, hit); },
                              [&](const CCircle& circle) { return CollideCircleCircle(circle, ball, hit); },
                              [&](const CArc& arc) { return CollideCircleArc(arc, ball, hit); }});
}

} // namespace Shapes::Native
