// SPDX-License-Identifier: MIT
// All balls of a world together: where they are, how far in each other, how fast, and their energy.
#pragma once

#include "Numbers.h"

#include <Shapes/World.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Shapes {

/// Whether it holds for the place of each ball.
template <class F>
testing::AssertionResult AllBalls(const CWorld& world, const F& isRight) {
  for (const CShapeId ball : world.GetBallIds())
    if (const Vector2 p = world.GetPos(ball); !isRight(p))
      return testing::AssertionFailure() << "ball " << ball.m_nValue << " is at " << p.transpose();
  return testing::AssertionSuccess();
}

template <class F>
std::ptrdiff_t CountBalls(const CWorld& world, const F& isCounted) {
  const auto places = world.GetBallPositions();
  return std::count_if(places.begin(), places.end(), isCounted);
}

/// Whether all centres are in a square about the origin.
inline testing::AssertionResult AreWithin(const CWorld& world, double half) {
  return AllBalls(world, [=](const Vector2& p) { return Wide(p.cwiseAbs().maxCoeff()) < half; });
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

/// Per mass, above a height.
inline double EnergyOf(const CWorld& world, CShapeId ball, double g, double height) {
  return 0.5 * Wide(world.GetVel(ball)).squaredNorm() + g * (Wide(world.GetPos(ball).y()) - height);
}

/// Of all balls together, above this height.
inline double GetEnergy(const CWorld& world, double g, double height = 0.0) {
  double sum = 0.0;
  for (const CShapeId ball : world.GetBallIds())
    sum += Wide(world.GetMass(ball)) * EnergyOf(world, ball, g, height);
  return sum;
}

} // namespace Shapes
