// SPDX-License-Identifier: MIT
// Both profiles, and worlds on Box2D, for the tests of this folder.
#pragma once

#include "../Descs.h"
#include "../Messages.h"
#include "../Numbers.h"
#include "../Steps.h"
#include "../geometry/Cases.h"
#include "Tolerances.h"

#include <Shapes/Box2D.h>
#include <Shapes/Shapes.h>

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Shapes::Tests {

inline std::unique_ptr<CWorld> MakeBox2D(eProfile profile, const Vector2& gravity = Vector2::Zero(),
                                         float dt = g_fDt, const CEffectChoice& choice = g_cAutomatic,
                                         float unit = 1.0f) {
  CWorldDesc desc;
  desc.m_cBox2D.m_eProfile = profile;
  desc.m_cBox2D.m_fLengthUnit = unit;
  desc.m_vGravity = gravity;
  desc.m_fTimeStep = dt;
  desc.m_cEffects = choice;
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

} // namespace Shapes::Tests
