// SPDX-License-Identifier: MIT
// Balls that are so small that Box2D may lose them in what it lets overlap.
#pragma once

#include "../world/Bodies.h"

namespace Shapes::Box2D {

/// After each b2World::Step: no ball of less than g_fSmallBall slops has got through a segment or an arc that
/// is solid on both sides. One that has is put back to where it went through, on the side from which it came,
/// and moves into the surface no more.
void KeepSmallBallsOnTheirSide(CBodies& bodies);

} // namespace Shapes::Box2D
