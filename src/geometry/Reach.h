// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/Shape.h>

namespace Shapes {

/// Distance of the farthest point of a shape from the centre about which it turns, user units. Error a few
/// roundings in double.
double GetReach(const CShape& shape);

} // namespace Shapes
