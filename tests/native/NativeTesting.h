// SPDX-License-Identifier: MIT
// Worlds of the native engine, and what many of its tests put into them.
#pragma once

#include "../Testing.h"

namespace Shapes {

/// @param gravity  downward
inline std::unique_ptr<CWorld> MakeNative(const CEffectChoice& effects, float gravity = 0, float dt = g_fDt,
                                          unsigned substeps = 1, unsigned threads = 1) {
  CWorldDesc desc = Described({0, -gravity}, dt, substeps, effects);
  desc.m_nThreads = threads;
  return GetBackend(eBackend::Native)->MakeWorld(desc);
}

/// Segments from each place to the next one.
inline void AddPath(CWorld& world, std::initializer_list<Vector2> path) {
  for (auto p = path.begin(); p + 1 != path.end(); ++p)
    world.Add(CLineSegDesc(p[0], p[1]));
}

inline void AddBox(CWorld& world, const Vector2& low, const Vector2& high, float e = 1) {
  for (const CLineSegDesc& wall : Walls(low, high, e))
    world.Add(wall);
}
/// About the origin.
inline void AddBox(CWorld& world, float half, float e = 1) { AddBox(world, {-half, -half}, {half, half}, e); }

/// Steps, and checks after each step. The first one that fails is named, and the last.
template <class F>
void InEachStep(CWorld& world, int steps, const F& check) {
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
    SCOPED_TRACE(testing::Message() << "after step " << step);
    world.Step();
    check(step);
  }
}

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

/// In the last step.
inline std::vector<CShapeId> Halted(const CWorld& world) {
  const auto halted = world.GetHaltedBalls();
  return {halted.begin(), halted.end()};
}

/// Per mass, above the floor on which a ball of radius r lies.
inline double EnergyOf(const CWorld& world, CShapeId ball, double g, double r) {
  return 0.5 * Wide(world.GetVel(ball)).squaredNorm() + g * (Wide(world.GetPos(ball).y()) - r);
}

/// Of all balls together, above this height.
inline double GetEnergy(const CWorld& world, double g, double height = 0.0) {
  double sum = 0.0;
  for (const CShapeId ball : world.GetBallIds())
    sum += Wide(world.GetMass(ball)) * EnergyOf(world, ball, g, height);
  return sum;
}

} // namespace Shapes
