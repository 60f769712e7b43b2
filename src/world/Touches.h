// SPDX-License-Identifier: MIT
// Solid shapes and balls that begin or cease to touch: found after each substep from its contacts, the same
// for all engines. Which pairs touch is kept in the state of the world.
#pragma once

#include <Shapes/Events.h>

#include "WorldState.h"

#include <span>
#include <vector>

namespace Shapes {

CTouchEvent TouchEvent(const CTouchingPair& pair, bool begin);
/// Before the substeps of a step: ends the pairs of which one is gone or turned off, or that meet otherwise.
void EndLost(const CWorldState& state, eMeeting meeting, std::vector<CTouchingPair>& touching,
             std::vector<CTouchEvent>& events);

/// After a substep: appends what began and ended in it.
/// @param contacts  of the substep
/// @param reach  user units: what is not farther apart may touch on, as within g_fTouchReach radii
void FollowTouches(std::span<const CContactEvent> contacts, float reach, CWorldState& state,
                   std::vector<CTouchEvent>& events);

} // namespace Shapes
