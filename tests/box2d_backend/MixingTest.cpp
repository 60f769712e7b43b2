// SPDX-License-Identifier: MIT
// Where Box2D's larger restitution of two can be made the product of both elasticities.
#include "box2d_backend/world/Mixing.h"

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include "Random.h"
#include "box2d_backend/world/Stepper.h"

namespace Shapes::Tests {
namespace {

using Box2D::CMixing;
using Box2D::FindMixing;

CWorldState MakeState(const std::vector<float>& balls, const std::vector<float>& shapes) {
  CWorldState state;
  for (const float e : shapes)
    state.m_stdShapes.emplace_back(CShapeId{state.m_nNextId++},
                                   std::make_unique<CPoint>(CPointDesc(Vector2(0, 0), e)));
  for (const float e : balls)
    state.m_cBalls.Add(CShapeId{state.m_nNextId++}, CDynamicCircleDesc({5, 5}, 0.1f, {0, 0}, 1, e));
  return state;
}

// Whether Box2D gives all pairs the product, by these factors.
bool GivesProducts(const CMixing& mixing, const std::vector<float>& balls, const std::vector<float>& shapes,
                   bool pairs) {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const float b = balls[i] * mixing.m_fOfBalls;
    for (const float e : shapes)
      if (b2MixRestitution(b, e * mixing.m_fOfShapes) != balls[i] * e) return false;
    for (std::size_t j = 0; pairs && j < i; ++j)
      if (b2MixRestitution(b, balls[j] * mixing.m_fOfBalls) != balls[i] * balls[j]) return false;
  }
  return true;
}

TEST(MixingTest, WhatIsGivenIsTheProductBitForBit) {
  CRandom random(77);
  int given = 0, wrongWithoutIt = 0;
  for (int k = 0; k < 20000; ++k) {
    // Of a few values each, so that sets of one are frequent.
    const float values[] = {0.0f, 1.0f, random.Uniform(0, 1), random.Uniform(0.5f, 1.2f)};
    std::vector<float> balls(random.Below(4)), shapes(random.Below(4));
    for (auto* pSet : {&balls, &shapes}) {
      const std::uint32_t one = random.Below(4);
      const bool mixed = random.Coin();
      for (float& e : *pSet)
        e = values[mixed ? random.Below(4) : one];
    }
    const bool pairs = random.Coin();
    const auto mixing = FindMixing(MakeState(balls, shapes), pairs);
    if (!mixing) continue;
    ++given;
    ASSERT_TRUE(GivesProducts(*mixing, balls, shapes, pairs));
    wrongWithoutIt += !GivesProducts(CMixing(), balls, shapes, pairs);
  }
  EXPECT_GT(given, 2000);
  EXPECT_GT(wrongWithoutIt, 1000); // the control: Box2D left alone
}

TEST(MixingTest, ItIsGivenWhereOneSideHasOneElasticity) {
  const auto given = [](const std::vector<float>& balls, const std::vector<float>& shapes, bool pairs) {
    return FindMixing(MakeState(balls, shapes), pairs).has_value();
  };
  EXPECT_TRUE(given({0.7f}, {0.5f, 1.0f, 0.0f}, false)); // one ball always
  EXPECT_TRUE(given({0.7f, 0.2f}, {0.9f, 0.9f}, false));
  EXPECT_FALSE(given({0.7f, 0.2f}, {0.9f, 0.8f}, false));
  EXPECT_TRUE(given({0.7f, 0.7f}, {0.9f, 0.8f}, true));
  EXPECT_FALSE(given({0.7f, 0.2f}, {0.9f, 0.9f}, true));
  EXPECT_FALSE(given({0.7f, 0.7f}, {0.9f, 0.6f}, true)); // .42 of the one wall is less than .49 of two balls
  EXPECT_TRUE(given({1.0f, 1.0f}, {1.0f, 1.0f}, true));
  EXPECT_FALSE(given({1.0f}, {1.0f, 1.5f}, false)); // above 1 it may have to be cut
  EXPECT_TRUE(given({0.6f}, {1.0f, 1.5f}, false));
  EXPECT_FALSE(given({1.1f, 1.1f}, {}, true));
  EXPECT_TRUE(given({}, {0.3f, 0.4f}, false));
}

TEST(MixingTest, WhatIsNotSolidDoesNotCount) {
  CWorldState state = MakeState({1.0f, 0.2f}, {1.0f, 0.4f});
  EXPECT_FALSE(FindMixing(state, false));
  state.m_stdShapes[1].m_pShape->SetSensor(true);
  EXPECT_TRUE(FindMixing(state, false));
  EXPECT_FALSE(FindMixing(state, true));
  state.m_cBalls.m_stdCanCollide[1] = false;
  EXPECT_TRUE(FindMixing(state, true));
}

TEST(MixingTest, NobodyListensWhereNobodyNeedsTo) {
  const auto asksForNone = [](const Box2D::CTuning& tuning, CEffects running, float wall) {
    bool needsNone = false;
    const auto ask = [&](CWorldCore& world) -> std::unique_ptr<CEngine> {
      world.GetState() = MakeState({0.7f, 0.2f}, {0.9f, wall});
      b2World b2({0, 0});
      Box2D::CStepper stepper(b2, world, tuning);
      stepper.Plan(running);
      needsNone = stepper.NeedsNoListener();
      return nullptr;
    };
    CWorldCore(CWorldDesc(), CWorldLimits(), CEffects(), ask);
    return needsNone;
  };
  EXPECT_TRUE(asksForNone(Box2D::g_cShipped, {}, 0.9f));
  EXPECT_TRUE(asksForNone(Box2D::g_cShipped, {eEffect::Gravity, eEffect::Continuous}, 0.9f));
  EXPECT_FALSE(asksForNone(Box2D::g_cShipped, {}, 0.8f));
  EXPECT_FALSE(asksForNone(Box2D::g_cShipped, {eEffect::BallPairs}, 0.9f));
  EXPECT_FALSE(asksForNone(Box2D::g_cShipped, {eEffect::Events}, 0.9f));
  EXPECT_FALSE(asksForNone(Box2D::g_cShipped, {eEffect::Sensors}, 0.9f));
  EXPECT_FALSE(asksForNone(Box2D::g_cTuned, {}, 0.9f));
}

} // namespace
} // namespace Shapes::Tests
