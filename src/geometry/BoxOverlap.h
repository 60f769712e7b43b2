// SPDX-License-Identifier: MIT
#pragma once

#include "ShapeGeometry.h"

#include <Eigen/Geometry>

namespace Shapes::Geometry {

/// The part of the way from p by d, in [0, most], at which it comes into the box; infinite if it does not.
double FindEntry(const CBox2d& box, const Vector2d& p, const Vector2d& d, double most);

/// Whether a point of the shape is in the box, whose edges belong to it. Of circles and arcs the curve
/// counts. Right unless the shape comes within a few roundings of its size to the edge of the box.
bool HasPointIn(const CShapeGeometry& shape, const CBox2d& box);

} // namespace Shapes::Geometry
