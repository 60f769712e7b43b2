// SPDX-License-Identifier: MIT
// A whole scene as descriptors: for a world on either engine, or as a file for shapes-compare.
#pragma once

#include <Shapes/World.h>

#include <string>
#include <vector>

namespace Shapes {

/// A world, its shapes and its balls, with notes on their origin.
class CSceneDesc {
public:
  CWorldDesc m_cWorld;
  std::vector<CAnyShapeDesc> m_stdShapes; ///< Static and kinematic shapes.
  std::vector<CDynamicCircleDesc> m_stdBalls;
  std::vector<std::string> m_stdNotes; ///< Whole sentences, such as differences from an imported world.

  /// Adds everything, the shapes first, and gives the ids in this order. Gravity and time step stay those of
  /// the world: make it from m_cWorld.
  /// @throws std::invalid_argument naming the shape or the ball (by its index), the field and the value that
  /// is not valid; nothing is added then
  std::vector<CShapeId> AddTo(CWorld& world) const;

  /// The text of a scene file (docs/scenes.md). Every float reads back with the same bits. The bounds are the
  /// box of all shapes and balls, the circles in which kinematic shapes turn included, made wider on each
  /// side by half of its larger extent. The notes become the description. Of m_cWorld it has gravity, time
  /// step and the length unit of Box2D: substeps, threads, effects and the profile are left out.
  /// @param name     UTF-8, at least one letter
  /// @param seconds  how long one run takes, at least the time step
  /// @throws std::invalid_argument naming what is not valid or cannot be written: no ball, a ball that is a
  /// sensor, a shape with stops, a ball among the shapes, an empty name
  std::string ToJson(const std::string& name, float seconds) const;
};

} // namespace Shapes
