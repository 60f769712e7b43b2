// SPDX-License-Identifier: MIT
// For games that have a b2World of Box2D 2.4 of their own. Not part of Shapes.h: what is declared here is
// there only where the library was built with Box2D (Shapes_WITH_BOX2D, component box2d).
#pragma once

#include <Shapes/SceneDesc.h>

class b2World;

namespace Shapes {

/// How a b2World becomes a scene.
struct CImportOptions {
  float m_fLengthUnit = 1.0f;       ///< User units per metre of the b2World, above 0.
  float m_fTimeStep = 1.0f / 60.0f; ///< Seconds that the game gives to b2World::Step, above 0.
};

/// The scene that a game's world is in: shapes and balls where they are now, with the speeds that they have
/// now. Lengths and speeds are multiplied by the length unit. Bodies are taken in the order in which the game
/// made them, the fixtures of each likewise, and counted from 0 in this order.
///
/// - Fixtures of static and kinematic bodies become circles and segments. Chains and one-sided edges are
///   solid on the side on which they are in Box2D, polygons on the outside, two-sided edges on both. Where a
///   ball can meet a corner or an end, a point guards it (native ends are open); the points come after all
///   other shapes. Fixtures share end points with the same bits where they do in Box2D.
/// - Kinematic bodies turn about their positions.
/// - Dynamic bodies become balls if they have exactly one solid fixture, a circle about the centre of mass.
/// - Elasticities: Box2D takes the larger restitution of two, Shapes the product of both elasticities. Every
///   shape and ball gets an elasticity with which each pair that can meet has the restitution that it has in
///   Box2D, within 4 ulp, where there are such elasticities. Else those of balls and shapes come first, and
///   what remains is fitted (least squares of logarithms).
///
/// Whatever has no counterpart, or another effect, is in the notes, one sentence each that names the bodies:
/// other dynamic bodies, joints, friction, damping, filters, thresholds, pairs of another restitution, and
/// code of the game that takes part in collisions.
/// docs/box2d_import.md has an example and the list of them.
///
/// @throws std::invalid_argument naming the option, or the body, the field and the value, that no shape can
/// have
CSceneDesc ImportScene(const b2World& world, const CImportOptions& options = {});

} // namespace Shapes
