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

/// Parts into which dt seconds have to be cut so that the balls that were in lasting contact in the last
/// step, which are not swept, get little deeper into each other in each: 1 .. g_fMostLastingSubsteps.
float CountLastingSubsteps(CBodies& bodies, float dt);

/// After each b2World::Step: no ball in lasting contact remains in a shape, even if others push it there.
/// @param g  gravity in metres, 0 if balls do not follow parabolas: no ball gains energy by being lifted
void PushOutOfShapes(CBodies& bodies, const b2Vec2& g);

} // namespace Shapes::Box2D
