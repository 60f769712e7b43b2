// SPDX-License-Identifier: MIT
// Several steps of a world at once and what they report, and whether two worlds have come to the same.
#pragma once

#include <Shapes/World.h>

#include <gtest/gtest.h>

#include <cstring>
#include <span>
#include <vector>

namespace Shapes {

inline void Steps(CWorld& world, int n) {
  for (int i = 0; i < n; ++i)
    world.Step();
}

/// Steps, and checks after each step. The first one that fails is named, and the last.
template <class F>
void InEachStep(CWorld& world, int steps, const F& check) {
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
    SCOPED_TRACE(testing::Message() << "after step " << step);
    world.Step();
    check(step);
  }
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

} // namespace Shapes
