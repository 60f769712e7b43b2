// SPDX-License-Identifier: MIT
// Which segments and arcs go on in one another, so that a ball does not bump into the end that they share.
#pragma once

#include "../../world/WorldState.h"

#include <array>
#include <map>
#include <optional>

namespace Shapes::Box2D {

/// The neighbour beyond an end of a segment or an arc.
struct CSharedEnd {
  CShapeId m_cNeighbour;
  Vector2 m_vTangent = Vector2::Zero(); ///< Unit vector from the end into the neighbour, as both are now.
  float m_fBend = 0.0f; ///< Curvature of the neighbour, per user unit; positive to the left of that.
};

/// Of end 0 and end 1, in the order in which they are now.
using CSharedEnds = std::array<std::optional<CSharedEnd>, 2>;

/// All shapes of a world that share an end with exactly one other: both static, or turning together; solid on
/// the same sides; neither a sensor or switched off.
/// @param tolerance  how far apart ends may be that count as one, user units
std::map<CShapeId, CSharedEnds> FindSharedEnds(const CWorldState& state, float tolerance);

} // namespace Shapes::Box2D
