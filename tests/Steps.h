// SPDX-License-Identifier: MIT
// Several steps of a world at once, and whether two worlds have come to the same.
#pragma once

#include <Shapes/World.h>

#include <cstring>
#include <span>

namespace Shapes {

inline void Steps(CWorld& world, int n) {
  for (int i = 0; i < n; ++i)
    world.Step();
}

/// Whether the balls of both have the same places and velocities, bit for bit.
inline bool HaveSameBits(const CWorld& a, const CWorld& b) {
  const auto same = [](std::span<const Vector2> u, std::span<const Vector2> v) {
    return u.size() == v.size() && (u.empty() || std::memcmp(u.data(), v.data(), u.size_bytes()) == 0);
  };
  return same(a.GetBallPositions(), b.GetBallPositions()) &&
         same(a.GetBallVelocities(), b.GetBallVelocities());
}

} // namespace Shapes
