// SPDX-License-Identifier: MIT
// Several steps of a world at once and what they report, whether two worlds have come to the same, and how
// deep balls are in each other.
#pragma once

#include <Shapes/World.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

namespace Shapes {

inline void Steps(CWorld& world, int n) {
  for (int i = 0; i < n; ++i)
    world.Step();
}

/// The contacts, sensor events or touches of n steps, each of which `step` makes.
template <class T, class F>
std::vector<T> Told(const CWorld& world, int n, std::span<const T> (CWorld::*pGet)() const, const F& step) {
  std::vector<T> told;
  for (int i = 0; i < n; ++i) {
    step();
    const std::span<const T> events = (world.*pGet)();
    told.insert(told.end(), events.begin(), events.end());
  }
  return told;
}
template <class T>
std::vector<T> Told(CWorld& world, int n, std::span<const T> (CWorld::*pGet)() const) {
  return Told(world, n, pGet, [&] { world.Step(); });
}

/// Whether the balls of both have the same places and velocities, bit for bit.
inline bool HaveSameBits(const CWorld& a, const CWorld& b) {
  const auto same = [](std::span<const Vector2> u, std::span<const Vector2> v) {
    return u.size() == v.size() && (u.empty() || std::memcmp(u.data(), v.data(), u.size_bytes()) == 0);
  };
  return same(a.GetBallPositions(), b.GetBallPositions()) &&
         same(a.GetBallVelocities(), b.GetBallVelocities());
}

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
