// SPDX-License-Identifier: MIT
// How far the balls of a world are in each other, and how fast they are.
#pragma once

#include <Shapes/World.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Shapes {

/// The deepest of any two balls, in radii of the smaller one; 0 if none overlap.
inline double GetOverlap(const CWorld& world) {
  const auto places = world.GetBallPositions();
  std::vector<float> radii;
  for (const CShapeId ball : world.GetBallIds())
    radii.push_back(world.GetRadius(ball));
  float deepest = 0.0f;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const float depth = radii[i] + radii[j] - (places[i] - places[j]).norm();
      deepest = std::max(deepest, depth / std::min(radii[i], radii[j]));
    }
  return static_cast<double>(deepest);
}

/// The speed of the fastest ball; 0 if there is none.
inline float GetFastest(const CWorld& world) {
  float most = 0.0f;
  for (const Vector2& v : world.GetBallVelocities())
    most = std::max(most, v.norm());
  return most;
}

} // namespace Shapes
