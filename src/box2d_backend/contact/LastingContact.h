// SPDX-License-Identifier: MIT
// Which balls press on each other, rather than hit each other.
#pragma once

#include "../world/Bodies.h"

namespace Shapes::Box2D {

/// Finds out which balls Box2D's own solver is to move in the next step, all their contacts at once. They are
/// not swept against each other: an overlap is solved in the next step. To be called before each
/// b2World::Step. Balls that touch are lasting if g_nCrowd others are near one of them, or if gravity presses
/// them onto each other: they are not elastic, and their relative speed is one that gravity gives in a step
/// or two. So is every ball that touches a lasting one.
/// @param g  gravity in metres, 0 if balls do not follow parabolas
/// @param h  length of the step, seconds
/// @return the weight of all balls in lasting contact, newtons
float FindLastingContacts(CBodies& bodies, const b2Vec2& g, float h);

/// After each b2World::Step: no ball in lasting contact remains in a shape, even if others push it there.
void PushOutOfShapes(CBodies& bodies);

} // namespace Shapes::Box2D
