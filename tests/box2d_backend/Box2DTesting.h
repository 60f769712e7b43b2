// SPDX-License-Identifier: MIT
// Both profiles, and worlds on Box2D, for the tests of this folder.
#pragma once

#include "Tolerances.h"

#include "../Testing.h"

#include <Shapes/Box2D.h>

#include <box2d/box2d.h>

namespace Shapes::Tests {

inline std::unique_ptr<CWorld> MakeBox2D(eProfile profile, const Vector2& gravity = Vector2::Zero(),
                                         float dt = g_fDt, const CEffectChoice& choice = g_cAutomatic,
                                         float unit = 1.0f) {
  CWorldDesc desc = Described(gravity, dt, 1, choice, profile);
  desc.m_cBox2D.m_fLengthUnit = unit;
  return GetBackend(eBackend::Box2D)->MakeWorld(desc);
}

class CEveryProfile : public testing::TestWithParam<eProfile> {
protected:
  bool IsTuned() const { return GetParam() == eProfile::Tuned; }
};

#define SHAPES_ON_EVERY_PROFILE(suite)                                                                       \
  INSTANTIATE_TEST_SUITE_P(                                                                                  \
      , suite, testing::Values(eProfile::Shipped, eProfile::Tuned),                                          \
      [](const auto& test) { return test.param == eProfile::Tuned ? "tuned" : "shipped"; })

// Vectors of double: directions, angles, and what an exact bounce makes of a velocity.

inline double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
inline Vector2d Perp(const Vector2d& a) { return {-a.y(), a.x()}; }
inline Vector2d UnitVector(double angle) { return {std::cos(angle), std::sin(angle)}; }

} // namespace Shapes::Tests
