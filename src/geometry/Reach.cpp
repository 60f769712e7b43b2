// SPDX-License-Identifier: MIT
#include "Reach.h"

#include "VisitShape.h"

#include <algorithm>

namespace Shapes {

double GetReach(const CShape& shape) {
  const auto from = [&](const Vector2& p) {
    return (p.cast<double>() - shape.GetRotCenter().cast<double>()).norm();
  };
  const auto ofDisk = [&](const CCircle& circle) { return from(circle.GetPos()) + circle.GetRadius(); };
  return VisitShape(shape, CPerShape{[&](const CPoint& point) { return from(point.GetPos()); },
                                     [&](const CLineSeg& seg) {
                                       return std::max(from(seg.GetEndPt0()), from(seg.GetEndPt1()));
                                     },
                                     [&](const CCircle& circle) { return ofDisk(circle); },
                                     [&](const CArc& arc) { return ofDisk(arc); }});
}

} // namespace Shapes
