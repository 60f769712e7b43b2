// SPDX-License-Identifier: MIT
// Shapes with stops: how fast they are in a part of a substep, and when one comes to its stop.
#pragma once

#include <Shapes/MotionLimits.h>

#include "WorldState.h"

namespace Shapes {

/// @throws std::invalid_argument naming what is not valid, or what a static shape cannot have
void RequireLimits(const CMotionLimits& limits, eMotion motion);

/// Seconds until the shape comes to the next of its stops; infinite where nothing drives it to one.
double GetTimeToStop(const CShapeEntry& entry);

/// With which it moves in the next dt seconds: those that it was given, but for what it rests at, and slower
/// where it would get beyond a stop.
CDrive GetDrive(const CShapeEntry& entry, float dt);

/// Whether a shape that has moved for dt seconds has come to a stop, but for rounding.
bool HasCome(const CShapeEntry& entry, float dt);
/// Puts it exactly there, where it rests.
void SnapToStops(CShapeEntry& entry, float dt);

} // namespace Shapes
