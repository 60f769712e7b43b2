// SPDX-License-Identifier: MIT
// Shapes that consist of others: boxes and polylines as segments, with points that guard corners and ends
// where these are open; capsules as segments and circles.
#pragma once

#include <Shapes/WorldDesc.h>

#include <span>
#include <vector>

namespace Shapes {

/// Segments from each vertex to the next one, and a point on each end and on each corner that is no smooth
/// joint: without it balls would fly past the open ends of segments where Continuous does not run. Add them
/// one by one, or as a compound.
/// @param closed  whether the last vertex is joined with the first one
/// @param like    what all have in common: elasticity, motion, filter, ...; its front is to the left of the
///                way. Sensors need no guards, and get none.
/// @throws std::invalid_argument if a vertex is not finite, or if fewer than two differ from the one before
std::vector<CAnyShapeDesc> MakePolyline(std::span<const Vector2> vertices, bool closed = false,
                                        const CLineSegDesc& like = {});

/// The outline of a box, counterclockwise: its front is inside, two-sided unless `like` says otherwise.
/// @param size   width and height, user units, above 0
/// @param angle  radians by which it is turned about its centre
std::vector<CAnyShapeDesc> MakeBox(const Vector2& center, const Vector2& size, float angle = 0.0f,
                                   const CLineSegDesc& like = {});

/// A capsule, or a flipper that tapers: circles about both centres, then the two segments that touch both
/// from outside (CCircle::Tangents, with the same errors). Add them one by one, or as a compound. It is
/// hollow: a ball that starts inside stays there (on Box2D, where the ends are solid, they may push it out),
/// and as a sensor it detects on its parts.
/// @param p0, p1  centres of the round ends, farther apart than their radii differ, user units
/// @param r0, r1  radii of the ends, user units, above 0
/// @param like    what all have in common; its sides do not count, as balls meet both
/// @throws std::invalid_argument if a value is not finite or out of range, or if one end contains the other,
/// as where p0 is p1: that is a circle
std::vector<CAnyShapeDesc> MakeCapsule(const Vector2& p0, float r0, const Vector2& p1, float r1,
                                       const CLineSegDesc& like = {});

} // namespace Shapes
