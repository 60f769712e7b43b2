// SPDX-License-Identifier: MIT
// Balls that Box2D lets through a shape: small ones in what may overlap, others where they are squeezed.
#pragma once

#include "../world/Bodies.h"

namespace Shapes::Box2D {

/// After each b2World::Step: the centre of no ball has got through a segment or an arc that is solid on both
/// sides. One that has is put back to where it went through, on the side from which it came, and moves into
/// the surface no more. Between two shapes it is kept on its side of the one that does not move. A ball
/// within a radius of an end that is not shared may have gone round it and stays. Only where continuous
/// physics is on.
void KeepBallsOnTheirSide(CBodies& bodies);

} // namespace Shapes::Box2D
