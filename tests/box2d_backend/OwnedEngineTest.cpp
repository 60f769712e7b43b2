// SPDX-License-Identifier: MIT
// A world on Box2D has particulars: its scale, its limits, what stands for shapes in it, what was
// changed of the way Box2D ships, and what runs of it.
#include "Box2DTesting.h"

namespace Shapes::Tests {
namespace {

std::unique_ptr<CWorld> Make(const Vector2& gravity = Vector2::Zero(), float unit = 1.0f,
                             const CEffectChoice& choice = g_cAutomatic) {
  return MakeBox2D(eProfile::Shipped, gravity, g_fDt, choice, unit);
}

/// Puts the ball at p with velocity v, makes n steps and gives its velocity.
Vector2 Throw(CWorld& world, CShapeId ball, const Vector2& p, const Vector2& v, int n = 20) {
  world.SetPos(ball, p);
  world.SetVel(ball, v);
  Steps(world, n);
  return world.GetVel(ball);
}

CShapeId AddBall(CWorld& world, float r = 0.1f) { return world.Add(CDynamicCircleDesc({50, 50}, r)); }

// Up to 1e8 metres; what is refused has not moved.
TEST(OwnedWorldTest, APoseBeyondTheLimitsIsRefusedByEachSetter) {
  const auto pWorld = Make();
  const CShapeId circle = pWorld->Add(CCircleDesc({0, 0}, 1000)),
                 ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 1000));
  for (const CShapeId id : {circle, ball}) {
    EXPECT_THROW(pWorld->SetPos(id, {1e8f - 500, 0}), std::invalid_argument);
    EXPECT_EQ(pWorld->GetPos(id), Vector2(0, 0));
    pWorld->SetPos(id, {1e8f - 2000, 0}); // the control
    EXPECT_EQ(pWorld->GetPos(id), Vector2(1e8f - 2000, 0));
  }
  const CLineSegDesc bar({0, 0}, {9e7f, 9e7f});
  EXPECT_THROW(pWorld->Add(Turning(bar, 0, {1e10f, 0})), std::invalid_argument);
  const CShapeId lever = pWorld->Add(Turning(bar));
  EXPECT_THROW(pWorld->SetRotCenter(lever, {1e10f, 0}), std::invalid_argument);
  EXPECT_THROW(pWorld->SetOrientation(lever, -g_fPi / 4), std::invalid_argument);
  EXPECT_EQ(pWorld->GetOrientation(lever), 0.0f);
  pWorld->SetOrientation(lever, g_fPi / 2); // the control
}

// In metres: 200 pixels per second at 100 pixels per metre are slow.
TEST(OwnedWorldTest, ClampedMovesAreCounted) {
  for (const float unit : {1.0f, 100.0f}) {
    auto pWorld = Make({0, 0}, unit);
    const CShapeId ball = AddBall(*pWorld);
    const auto throwAt = [&](const Vector2& v, int n) { return Throw(*pWorld, ball, {0, 0}, unit * v, n); };
    // Slow: nothing is counted. 119 m/s is 1.98 metres a step.
    EXPECT_NEAR(throwAt({119, 0}, 10).x(), 119 * unit, 1e-4f * unit);
    EXPECT_EQ(pWorld->GetStats().m_nMovesClamped, 0u);
    // Fast: Box2D parts the velocity itself, to 2 metres a step.
    EXPECT_NEAR(throwAt({200, 0}, 1).x(), b2_maxTranslation / g_fDt * unit, 1e-3f * unit);
    EXPECT_EQ(pWorld->GetStats().m_nMovesClamped, 1u);
    throwAt({0, -200}, 1);
    EXPECT_EQ(pWorld->GetStats().m_nMovesClamped, 2u);
  }
}

TEST(OwnedWorldTest, ArcPiecesAreCountedAsArcsComeAndGo) {
  auto pWorld = Make();
  const auto fixtures = [&] { return pWorld->GetStats().m_nArcPieces; };
  const CShapeId half = pWorld->Add(CArcDesc({0, 0}, 1, 0, g_fPi));
  EXPECT_EQ(fixtures(), 16u);
  const CShapeId bowl = pWorld->Add(CArcDesc({0, 0}, 1, 0, 0));
  EXPECT_EQ(fixtures(), 48u);
  pWorld->Add(CCircleDesc({0, 0}, 1));         // is no arc
  pWorld->Add(CArcDesc({0, 0}, 0.001f, 0, 1)); // becomes a point
  pWorld->SetPos(half, {3, 4});                // is made anew
  pWorld->SetElasticity(bowl, 0.5f);
  EXPECT_EQ(fixtures(), 48u);
  const CSavedState saved = pWorld->SaveState();
  pWorld->Remove(half);
  EXPECT_EQ(fixtures(), 32u);
  pWorld->LoadState(saved);
  EXPECT_EQ(fixtures(), 48u);
  pWorld->Remove(bowl);
  pWorld->Remove(half);
  EXPECT_EQ(fixtures(), 0u);
}

TEST(OwnedWorldTest, TheSagittaToleranceOfTheWorldIsUsed) {
  CWorldDesc desc;
  desc.m_cBox2D.m_fSagittaTolerance = g_fSagittaTolerance / 4;
  auto pWorld = GetBackend(eBackend::Box2D)->MakeWorld(desc);
  pWorld->Add(CArcDesc({0, 0}, 1, 0, g_fPi));
  EXPECT_EQ(pWorld->GetStats().m_nArcPieces, 32u); // half the chord for a quarter of the sagitta
}

TEST(OwnedWorldTest, ABallOfRadius0HasAMassAndFalls) { // by density it would have none, and would float
  auto pWorld = Make({0, -10});
  pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  const CShapeId ball = AddBall(*pWorld, 0);
  EXPECT_NEAR(Throw(*pWorld, ball, {0, 1}, {0, 0}, 10).y(), -10.0f / 6.0f, 1e-5f);
  Steps(*pWorld, 30);
  EXPECT_GT(pWorld->GetVel(ball).y(), 0);
  // It pushes another ball by its mass: equal masses exchange their velocities.
  auto pLine = Make();
  const CShapeId dot = pLine->Add(CDynamicCircleDesc({0, 0}, 0, {2, 0}));
  const CShapeId other = pLine->Add(CDynamicCircleDesc({0.5f, 0}, 0.2f));
  Steps(*pLine, 20);
  EXPECT_NEAR(pLine->GetVel(dot).x(), 0, 1e-4f);
  EXPECT_NEAR(pLine->GetVel(other).x(), 2, 1e-4f);
}

// Its lowest place is where two of its 16 chords meet, and Box2D solves a contact with each.
TEST(OwnedWorldTest, ABallThatTouchesTwoChordsOfAnArcHasOneContact) {
  const auto pWorld = Make({0, -10});
  pWorld->Add(CArcDesc({0, 1}, 1, g_fPi, 0));
  pWorld->Add(CDynamicCircleDesc({0, 0.5f}, 0.5f, {0, 0}, 1, 0));
  std::size_t reported = 0;
  for (int i = 0; i < 60; ++i) {
    pWorld->Step();
    EXPECT_LE(pWorld->GetContacts().size(), 1u);
    reported += pWorld->GetContacts().size();
  }
  EXPECT_GT(reported, 50u);
  EXPECT_GT(pWorld->GetStats().m_nEngineContacts, reported); // the control
}

TEST(OwnedWorldTest, ABallStaysInABowlOfAnArc) {
  for (const CEffectChoice& choice : {g_cAutomatic, g_cApproximate}) {
    auto pWorld = Make({0, -10}, 1, choice);
    pWorld->Add(CArcDesc({0, 0}, 2, 0, 0));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.7f, 0}, 0.1f, {3, 1}, 1, 0.9f));
    // 3 slops and a bit; where Continuous does not run, the way of a substep at its fastest is added.
    const float fastest = std::sqrt(10.0f + 2.0f * 10.0f * 1.9f);
    const float beyond = 0.016f + (choice == g_cApproximate ? fastest / 60 : 0.0f);
    for (int i = 0; i < 2000; ++i) {
      pWorld->Step();
      ASSERT_LE(pWorld->GetPos(ball).norm(), 1.9f + beyond) << "after step " << i;
    }
  }
}

TEST(OwnedWorldTest, AKinematicShapeIsMetWhereItWasPut) {
  auto pWorld = Make();
  const CShapeId flipper = pWorld->Add(Turning(CLineSegDesc({0, 0}, {1, 0})));
  const CShapeId ball = AddBall(*pWorld);
  const auto isMetAt = [&](float x) { return Throw(*pWorld, ball, {x, 0.5f}, {0, -4}).y() > 3.9f; };
  EXPECT_TRUE(isMetAt(0.5f));
  pWorld->SetPos(flipper, {3, 0}); // its middle
  EXPECT_FALSE(isMetAt(0.5f));
  EXPECT_TRUE(isMetAt(3));
  pWorld->Reset(flipper);
  EXPECT_TRUE(isMetAt(0.5f));
  pWorld->SetOrientation(flipper, 0.5f * g_fPi); // stands up from the origin
  EXPECT_FALSE(isMetAt(0.5f));
  EXPECT_LT(Throw(*pWorld, ball, {-0.5f, 0.5f}, {4, 0}).x(), -3.9f); // from the side
  pWorld->SetOrientation(flipper, 0);
  pWorld->SetRotCenter(flipper, {1, 0});
  pWorld->SetOrientation(flipper, g_fPi); // turned over about its right end
  EXPECT_FALSE(isMetAt(0.5f));
  EXPECT_TRUE(isMetAt(1.5f));
}

TEST(OwnedWorldTest, ATurningShapeIsMetWhereTheLibrarySaysItIs) {
  // A little more than 3 turns and a quarter: the angle that Box2D adds up has to stay with the library's,
  // which is reduced to one turn.
  auto pWorld = Make();
  const CShapeId bar = pWorld->Add(Turning(CLineSegDesc({-1, 0}, {1, 0}), 3.25f * 60 / 500));
  Steps(*pWorld, 500);
  EXPECT_NEAR(pWorld->GetOrientation(bar), 0.5f * g_fPi, 1e-3f);
  pWorld->SetRotSpeed(bar, 0);
  const CShapeId ball = AddBall(*pWorld);
  EXPECT_NEAR(Throw(*pWorld, ball, {-0.5f, 0.9f}, {4, 0}).x(), -4, 0.01f);
  EXPECT_EQ(Throw(*pWorld, ball, {0.5f, 0.5f}, {0, -4}).y(), -4); // where it lay at first nothing is
}

// Effects: what runs of Box2D.

/// Whether a ball that is thrown at a wall gets through it, and the steps in which Continuous ran.
std::pair<bool, unsigned> Throw(eProfile profile, const CEffectChoice& choice, float speed) {
  auto pWorld = MakeBox2D(profile, {0, 0}, g_fDt, choice);
  pWorld->Add(CLineSegDesc({0, -1}, {0, 1}));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-1, 0}, 0.1f, {speed, 0}));
  Steps(*pWorld, speed > 50 ? 2 : 30); // without a wall it would be well behind it then
  return {pWorld->GetPos(ball).x() > 0,
          static_cast<unsigned>(pWorld->GetStats().GetSubstepsWith(eEffect::Continuous))};
}

TEST(OwnedEffectsTest, AFastBallGetsThroughNoWallUnlessContinuousIsForbidden) {
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned}) {
    SCOPED_TRACE(profile == eProfile::Tuned ? "tuned" : "shipped");
    EXPECT_EQ(Throw(profile, g_cAutomatic, 70), std::pair(false, 2u));
    EXPECT_EQ(Throw(profile, g_cApproximate, 70), std::pair(true, 0u));
    EXPECT_FALSE(Throw(profile, g_cContinuous, 70).first);
    EXPECT_EQ(Throw(profile, g_cAutomatic, 2.999f), std::pair(false, 30u)); // slow ones are swept, too
    EXPECT_EQ(Throw(profile, g_cApproximate, 2.999f).second, 0u);
  }
}

TEST(OwnedEffectsTest, WhatStandsStillIsMetLikeAStaticShape) {
  // Also where it did not always do so.
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned}) {
    std::vector<Vector2> paths[3];
    for (const int k : {0, 1, 2}) {
      auto pWorld = MakeBox2D(profile, {0, -10});
      const CArcDesc desc({0, -1}, 1, 0, g_fPi);
      const CShapeId arc = pWorld->Add(k == 0 ? desc : Turning(desc, 0, {0, -1}));
      if (k == 2) {
        pWorld->SetRotSpeed(arc, 1);
        pWorld->Step();
        pWorld->SetRotSpeed(arc, 0);
        pWorld->Step();
        pWorld->Reset(arc);
      }
      const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.2f, 0.4f}, 0.1f, {0, 0}, 1, 0.9f));
      for (int i = 0; i < 100; ++i) {
        pWorld->Step();
        paths[k].push_back(pWorld->GetPos(ball));
      }
    }
    EXPECT_EQ(paths[0], paths[1]);
    EXPECT_EQ(paths[0], paths[2]);
    EXPECT_GT(paths[0].back().x(), 0.5f); // it has been met
  }
}

TEST(OwnedEffectsTest, ContactsCountWhereSomebodyHearsOfThem) {
  for (const bool sensor : {true, false}) {
    auto pWorld = Make({0, 0}, 1, {{}, {eEffect::Events}});
    pWorld->Add(CLineSegDesc({0, -1}, {0, 1}));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-0.5f, 0}, 0.1f, {2, 0}));
    pWorld->Add(sensor ? MakeZone({5, 5}) : CCircleDesc({5, 5}, 1));
    Steps(*pWorld, 20);
    EXPECT_LT(pWorld->GetVel(ball).x(), 0);
    EXPECT_EQ(pWorld->GetStats().m_nContacts > 0, sensor);
  }
}

} // namespace
} // namespace Shapes::Tests
