// SPDX-License-Identifier: MIT
// From a shape to the class of its type: the one place that casts by it.
#pragma once

#include <Shapes/Arc.h>
#include <Shapes/Circle.h>
#include <Shapes/LineSeg.h>
#include <Shapes/Point.h>

#include <cstdlib>

namespace Shapes {

/// One function per class of shapes: CPerShape{[](const CPoint&) {...}, [](const CLineSeg&) {...}, ...}. A
/// class without a function of its own does not compile, even where one for its base would take it.
template <class... TFunctions>
struct CPerShape : TFunctions... {
  using TFunctions::operator()...;
  template <class TShape>
  void operator()(const TShape&) const = delete;
};
template <class... TFunctions>
CPerShape(TFunctions...) -> CPerShape<TFunctions...>;

/// Calls visit with the shape as its class; a ball is a circle.
template <class F>
decltype(auto) VisitShape(const CShape& shape, const F& visit) {
  switch (shape.GetShapeType()) {
  case eShape::Point: return visit(static_cast<const CPoint&>(shape));
  case eShape::LineSeg: return visit(static_cast<const CLineSeg&>(shape));
  case eShape::Circle: return visit(static_cast<const CCircle&>(shape));
  case eShape::Arc: return visit(static_cast<const CArc&>(shape));
  }
  std::abort(); // no shape that can be made has another type
}

} // namespace Shapes
