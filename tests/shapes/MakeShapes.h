// SPDX-License-Identifier: MIT
// Static shapes in few words.
#pragma once

#include <Shapes/Shapes.h>

namespace Shapes {

inline CCircle Circle(const Vector2& p, float r) { return CCircle(CCircleDesc(p, r)); }
inline CArc Arc(const Vector2& p, float r, float a0, float a1) { return CArc(CArcDesc(p, r, a0, a1)); }

} // namespace Shapes
