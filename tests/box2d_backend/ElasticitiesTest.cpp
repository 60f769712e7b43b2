// SPDX-License-Identifier: MIT
// Box2D's larger restitution of two, and the product of two elasticities.
#include "box2d_backend/import/FitElasticities.h"

#include "Box2DTesting.h"
#include "box2d_backend/world/Mixing.h"
#include "box2d_backend/world/Stepper.h"

namespace Shapes::Box2D {
namespace {

using CKinds = std::vector<CBounceKind>;
using CPairs = std::vector<CBouncePair>;

constexpr bool g_bBall = true, g_bShape = false;

std::size_t CountWrong(const CKinds& kinds, const CPairs& pairs, bool withShapes = true,
                       bool ofBalls = true) {
  const std::vector<float> e = FitElasticities(kinds, pairs);
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const CBouncePair& pair) {
    const bool balls = kinds[pair.m_nFirst].m_bIsBall && kinds[pair.m_nSecond].m_bIsBall;
    return (balls ? ofBalls : withShapes) && !Reproduces(kinds, e, pair);
  }));
}

TEST(FitElasticitiesTest, OneBallKeepsOneAndShapesTakeThePair) {
  const CKinds kinds{{g_bBall, 0.5f}, {g_bShape, 0.8f}, {g_bShape, 0.0f}, {g_bShape, 0.3f}};
  EXPECT_EQ(FitElasticities(kinds, CPairs{{0, 1}, {0, 2}, {0, 3}}), (std::vector<float>{1, .8f, .5f, .5f}));
}

TEST(FitElasticitiesTest, ZeroIsTakenByWhatMeetsNothingElse) {
  // A dead ball and a dead floor, a bumper, and a live ball that does not meet the dead one.
  const CKinds kinds{{g_bBall, 0.0f}, {g_bShape, 0.0f}, {g_bShape, 0.9f}};
  const CPairs pairs{{0, 1}, {0, 2}};
  EXPECT_EQ(FitElasticities(kinds, pairs), (std::vector<float>{1.0f, 0.0f, 0.9f}));
  EXPECT_EQ(CountWrong(kinds, pairs), 0u);
  EXPECT_EQ(FitElasticities(CKinds{{g_bBall, 0.0f}}, CPairs{{0, 0}}), std::vector<float>{0.0f});
}

TEST(FitElasticitiesTest, DeadBallsThatBounceElsewhereAreNearlyDeadAmongThemselves) {
  const CKinds kinds{{g_bBall, 0.0f}, {g_bShape, 0.0f}, {g_bShape, 0.75f}};
  const CPairs pairs{{0, 0}, {0, 1}, {0, 2}};
  EXPECT_EQ(FitElasticities(kinds, pairs), (std::vector<float>{0x1p-5f, 0.0f, 24.0f}));
  EXPECT_EQ(CountWrong(kinds, pairs), 1u); // .00098 is not 0
}

TEST(FitElasticitiesTest, WithoutPairsEachKeepsItsOwn) {
  EXPECT_EQ(FitElasticities(CKinds{{g_bBall, 0.25f}, {g_bShape, 0.75f}}, CPairs{}),
            (std::vector<float>{0.25f, 0.75f}));
  EXPECT_TRUE(FitElasticities(CKinds{}, CPairs{}).empty());
}

// A dead ball in a world of live ones: only its pairs with them are lost.
TEST(FitElasticitiesTest, PairsWithShapesComeFirst) {
  const CKinds kinds{{g_bBall, 0.0f}, {g_bBall, 0.8f}, {g_bShape, 0.0f}};
  const CPairs pairs{{0, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}};
  EXPECT_EQ(CountWrong(kinds, pairs, true, false), 0u);
  EXPECT_EQ(CountWrong(kinds, pairs), 1u);
  EXPECT_EQ(FitElasticities(kinds, pairs)[0], 0.0f); // it lies dead on the floor, and on others of its kind
}

TEST(FitElasticitiesTest, WhatCannotBeIsFittedAndFound) {
  // Of the four pairs any three can be reproduced, not all four.
  const CKinds kinds{{g_bBall, 0.25f}, {g_bBall, 1.0f}, {g_bShape, 0.5f}, {g_bShape, 0.75f}};
  const CPairs pairs{{0, 2}, {0, 3}, {1, 2}, {1, 3}};
  EXPECT_GT(CountWrong(kinds, pairs), 0u);
  const std::vector<float> e = FitElasticities(kinds, pairs);
  for (const CBouncePair& pair : pairs) // the ratio of 1.5 is shared by four
    EXPECT_LT(std::abs(std::log(e[pair.m_nFirst] * e[pair.m_nSecond] / GetTarget(kinds, pair))),
              0.25 * std::log(1.5) + 1e-6);
}

TEST(FitElasticitiesTest, NoneIsAboveTheLimit) {
  const CKinds kinds{{g_bBall, 1e-12f}, {g_bShape, 1e3f}};
  for (const float e : FitElasticities(kinds, CPairs{{0, 0}, {0, 1}}))
    EXPECT_LE(e, g_fMaxElasticity);
  EXPECT_EQ(CountWrong(kinds, CPairs{{0, 0}, {0, 1}}), 1u);
}

// Worlds that an import can match: one restitution for all balls, whatever the shapes have.
TEST(FitElasticitiesTest, BallsOfOneRestitutionAreAlwaysReproduced) {
  Tests::ForEachCase(1, 2000, [&](Tests::CRandom& random, int) {
    const bool ballsMeet = random.Coin();
    CKinds kinds{{g_bBall, random.Scale(-10, 1)}};
    CPairs pairs;
    if (ballsMeet) pairs.push_back({0, 0});
    for (std::size_t i = 1; i <= 1 + random.Below(8); ++i) {
      kinds.push_back({g_bShape, random.Below(4) == 0 ? 0.0f : random.Scale(-10, 1)});
      pairs.push_back({0, i});
    }
    ASSERT_EQ(CountWrong(kinds, pairs), 0u);
  });
}

// And this too: each ball meets shapes of its own only, or shapes that have more than every ball.
TEST(FitElasticitiesTest, ShapesThatHaveMoreThanEveryBallAreReproduced) {
  Tests::ForEachCase(2, 2000, [&](Tests::CRandom& random, int) {
    CKinds kinds;
    CPairs pairs;
    for (std::size_t i = 0; i < 4; ++i)
      kinds.push_back({g_bBall, random.Uniform(0.0f, 0.5f)});
    for (std::size_t i = 4; i < 8; ++i) {
      kinds.push_back({g_bShape, random.Uniform(0.5f, 1.0f)});
      for (std::size_t j = 0; j < 4; ++j)
        if (random.Coin()) pairs.push_back({j, i});
    }
    ASSERT_EQ(CountWrong(kinds, pairs), 0u);
  });
}

// Three kinds of balls, one of each, that all meet: e0 = e1 = sqrt(r1), e2 = r2 / e1 for r0 <= r1 <= r2. Four
// are possible only if the two in the middle are equal.
TEST(FitElasticitiesTest, AFewBallsOfDifferentRestitution) {
  Tests::ForEachCase(3, 1000, [&](Tests::CRandom& random, int) {
    CKinds kinds;
    CPairs pairs;
    std::vector<float> r;
    for (std::size_t i = 0; i < 4; ++i) {
      r.push_back(random.Uniform(0.125f, 1.0f));
      kinds.push_back({g_bBall, r.back()});
      for (std::size_t j = 0; j < i; ++j)
        pairs.push_back({j, i});
    }
    const CPairs ofThree(pairs.begin(), pairs.begin() + 3);
    ASSERT_EQ(CountWrong(kinds, ofThree), 0u);
    std::sort(r.begin(), r.end());
    ASSERT_EQ(CountWrong(kinds, pairs) > 0, r[2] > r[1] * 1.00001f);
    for (CBounceKind& kind : kinds)
      if (kind.m_fRestitution == r[2]) kind.m_fRestitution = r[1];
    ASSERT_EQ(CountWrong(kinds, pairs), 0u);
  });
}

// Where pairs with shapes alone can all be reproduced, pairs of balls take none of them away.
TEST(FitElasticitiesTest, BallsNeverSpoilShapes) {
  int spoiled = 0, withWrongBalls = 0;
  Tests::ForEachCase(4, 2000, [&](Tests::CRandom& random, int) {
    CKinds kinds;
    CPairs withShapes, all;
    const auto draw = [&] {
      return random.Below(3) == 0 ? 0.0f : 0.25f * static_cast<float>(random.Below(5));
    };
    for (std::size_t i = 0; i < 3; ++i)
      kinds.push_back({g_bBall, draw()});
    for (std::size_t i = 3; i < 6; ++i) {
      kinds.push_back({g_bShape, draw()});
      for (std::size_t j = 0; j < 3; ++j)
        if (random.Coin()) withShapes.push_back({j, i});
    }
    all = withShapes;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        if (random.Coin()) all.push_back({j, i});
    if (CountWrong(kinds, withShapes) > 0) return;
    spoiled += CountWrong(kinds, all, true, false) > 0;
    withWrongBalls += CountWrong(kinds, all) > 0;
  });
  EXPECT_EQ(spoiled, 0);
  EXPECT_GT(withWrongBalls, 100); // there was something to spoil them
}

// Where Box2D's larger restitution of two can be made the product of both elasticities.

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
  int given = 0, wrongWithoutIt = 0;
  Tests::ForEachCase(77, 20000, [&](Tests::CRandom& random, int) {
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
    if (!mixing) return;
    ++given;
    ASSERT_TRUE(GivesProducts(*mixing, balls, shapes, pairs));
    wrongWithoutIt += !GivesProducts(CMixing(), balls, shapes, pairs);
  });
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
  const auto asksForNone = [](const CTuning& tuning, CEffects running, float wall) {
    bool needsNone = false;
    const auto ask = [&](CWorldCore& world) -> std::unique_ptr<CEngine> {
      world.GetState() = MakeState({0.7f, 0.2f}, {0.9f, wall});
      b2World b2({0, 0});
      CStepper stepper(b2, world, tuning);
      stepper.Plan(running);
      needsNone = stepper.NeedsNoListener();
      return nullptr;
    };
    CWorldCore(CWorldDesc(), CWorldLimits(), CEffects(), ask);
    return needsNone;
  };
  EXPECT_TRUE(asksForNone(g_cShipped, {}, 0.9f));
  EXPECT_TRUE(asksForNone(g_cShipped, {eEffect::Gravity, eEffect::Continuous}, 0.9f));
  EXPECT_FALSE(asksForNone(g_cShipped, {}, 0.8f));
  EXPECT_FALSE(asksForNone(g_cTuned, {}, 0.9f));
  for (const eEffect e : {eEffect::BallPairs, eEffect::Events, eEffect::Sensors})
    EXPECT_FALSE(asksForNone(g_cShipped, {e}, 0.9f)) << GetName(e);
}

} // namespace
} // namespace Shapes::Box2D
