// SPDX-License-Identifier: MIT
// Restitutions with which Box2D's own mixing gives the product of elasticities, so that no listener is
// needed.
#pragma once

#include "../../world/WorldState.h"

#include <optional>

namespace Shapes::Box2D {

/// A fixture's restitution is the elasticity of its ball or shape times one of these.
struct CMixing {
  float m_fOfBalls = 1.0f;
  float m_fOfShapes = 1.0f;
};

/// Box2D takes the larger of two restitutions; with these it is the product of both elasticities, bit for
/// bit, for all that can meet. There are such where either all solid balls or all solid shapes have one
/// elasticity, and, if balls meet balls, all balls have one that is no larger than that of any shape. None
/// are given where a product is above 1, which is cut at times.
/// @param pairs  whether balls meet balls
std::optional<CMixing> FindMixing(const CWorldState& state, bool pairs);

} // namespace Shapes::Box2D
