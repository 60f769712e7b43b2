// SPDX-License-Identifier: MIT
#include "BoxOverlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Shapes::Geometry {
namespace {

// Whether a circle crosses the outline of a box in the sector of its arc.
bool CrossesOutline(const CShapeGeometry& arc, const CBox2d& box) {
  for (const int axis : {0, 1})
    for (const double edge : {box.min()[axis], box.max()[axis]}) {
      const double off = edge - arc.m_vCenter[axis];
      if (std::abs(off) > arc.m_fRadius) continue;
      const double along = std::sqrt((arc.m_fRadius - off) * (arc.m_fRadius + off));
      for (const double side : {along, -along}) {
        Vector2d x;
        x[axis] = off;
        x[1 - axis] = side;
        const double place = arc.m_vCenter[1 - axis] + side;
        if (box.min()[1 - axis] <= place && place <= box.max()[1 - axis] && InSector(arc, x, 0.0))
          return true;
      }
    }
  return false;
}

bool HasPointOfCircle(const CShapeGeometry& circle, const CBox2d& box) {
  const Vector2d farthest =
      (box.min() - circle.m_vCenter).cwiseAbs().cwiseMax((box.max() - circle.m_vCenter).cwiseAbs());
  return box.squaredExteriorDistance(circle.m_vCenter) <= circle.m_fRadius * circle.m_fRadius &&
         circle.m_fRadius <= Norm(farthest);
}

} // namespace

double FindEntry(const CBox2d& box, const Vector2d& p, const Vector2d& d, double most) {
  double first = 0.0, last = most;
  for (const int axis : {0, 1}) {
    const double low = box.min()[axis] - p[axis], high = box.max()[axis] - p[axis], way = d[axis];
    if (way == 0.0) {
      if (low > 0.0 || high < 0.0) return std::numeric_limits<double>::infinity();
      continue;
    }
    first = std::max(first, (way > 0.0 ? low : high) / way);
    last = std::min(last, (way > 0.0 ? high : low) / way);
  }
  return first <= last ? first : std::numeric_limits<double>::infinity();
}

bool HasPointIn(const CShapeGeometry& shape, const CBox2d& box) {
  switch (shape.m_eShapeType) {
  case eShape::Point: return box.contains(shape.m_vCenter);
  case eShape::LineSeg: return std::isfinite(FindEntry(box, shape.m_vPt0, shape.m_vPt1 - shape.m_vPt0, 1.0));
  case eShape::Circle: return HasPointOfCircle(shape, box);
  case eShape::Arc:
    if (shape.m_bFull) return HasPointOfCircle(shape, box);
    return box.contains(shape.m_vPt0) || box.contains(shape.m_vPt1) || CrossesOutline(shape, box);
  }
  return false;
}

} // namespace Shapes::Geometry
