// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/Contact.h>

namespace Shapes::Box2D {

/// CBackend::CollisionDetected on Box2D, at one metre per user unit. Both shapes are followed
/// from where they were before their last move, by b2TimeOfImpact; the POI and the normal are those at the
/// time of impact, and the setback is how far both have moved into each other since, along the normal. Where
/// there was no impact on the way, an overlap at its end counts, by Box2D's collision functions, its skin
/// included. Where both radii together are below .00625 (1.25 of Box2D's slops), its time of impact stops
/// before they touch, and only that overlap is seen.
bool CollidePair(CContactDesc& c);

} // namespace Shapes::Box2D
