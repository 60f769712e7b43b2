// SPDX-License-Identifier: MIT
// Which face of a segment or an arc a ball meets.
#pragma once

#include <Shapes/Shape.h>

namespace Shapes::Native {

/// Chooses the face.
/// @param sides  the solid faces
/// @param s      signed distance of the centre, positive in front
/// @param sPrev  the same at the beginning of the step
/// @param vn     velocity of the ball along the front normal, relative to the surface
/// @param sign   1 for the front, -1 for the back: the normal is sign times the front normal
/// @return false if the ball is on its way through an open face
inline bool ChooseSide(eSides sides, float s, float sPrev, float vn, float& sign) {
  if (sides == eSides::Both) {
    // A centre exactly on the line says nothing; where it came from does, and failing that, where it goes.
    const float side = s != 0.0f ? s : sPrev != 0.0f ? sPrev : -vn;
    sign = side < 0.0f ? -1.0f : 1.0f;
    return true;
  }
  sign = sides == eSides::Front ? 1.0f : -1.0f;
  return sign * sPrev >= 0.0f && sign * vn < 0.0f;
}

} // namespace Shapes::Native
