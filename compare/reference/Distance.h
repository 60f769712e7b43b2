// SPDX-License-Identifier: MIT
// How far a point is from what a ball may hit.
#pragma once

#include "ShapeGeometry.h"

#include <algorithm>

namespace Shapes::Compare {

/// Distance of p to the nearest point of the figure as it is: point, segment with its ends, ring of a circle,
/// arc with its ends. Which sides are solid does not matter. Error of a few roundings of the coordinates.
template <class T>
T Distance(const CShapeGeometry<T>& f, const CVec<T>& p) {
  using std::abs;
  const CVec<T> x = p - f.m_vCenter;
  const auto ends = [&] { return std::min(Norm(CVec<T>(p - f.m_vPt0)), Norm(CVec<T>(p - f.m_vPt1))); };
  switch (f.m_eShapeType) {
  case eShape::LineSeg: {
    const CVec<T> along = f.m_vPt1 - f.m_vPt0;
    const T d0 = (p - f.m_vPt0).dot(along), d1 = (p - f.m_vPt1).dot(along), length = Norm(along);
    if (!(d0 > T(0)) || !(d1 < T(0)) || !(length > T(0))) return ends();
    return abs(Cross(along, CVec<T>(p - f.m_vPt0))) / length;
  }
  case eShape::Circle: return abs(Norm(x) - f.m_fRadius);
  case eShape::Arc: return InSector(f, x, T(0)) ? T(abs(Norm(x) - f.m_fRadius)) : ends();
  case eShape::Point: break;
  }
  return Norm(x);
}

} // namespace Shapes::Compare
