// SPDX-License-Identifier: MIT
// Effects: what calls for them, what the description says of them, and what the world does then, the same on
// every engine.
#include "Backends.h"

namespace Shapes {
namespace {

// All but Touches, which no content calls for (TouchContractTest.cpp).
std::vector<eEffect> AllEffects() {
  std::vector<eEffect> all;
  for (int i = 0; i < static_cast<int>(eEffect::Touches); ++i)
    all.push_back(static_cast<eEffect>(i));
  return all;
}

CEffectChoice Forced(eEffect e) { return {{e}, {}}; }
CEffectChoice Forbidden(eEffect e) { return {{}, {e}}; }

CLineSegDesc Flipper(float revsPerSecond) { return Turning(CLineSegDesc({0, 0}, {1, 0}), revsPerSecond); }

class CEffectContract : public CEveryBackend {
protected:
  std::unique_ptr<CWorld> Make(const CEffectChoice& choice = g_cAutomatic,
                               const Vector2& gravity = Vector2::Zero()) const {
    return Backend().MakeWorld(Described(gravity, g_fDt, 2, choice));
  }
  static CShapeId AddBall(CWorld& world, const Vector2& p, const Vector2& v = Vector2::Zero(), float e = 1) {
    return world.Add(CDynamicCircleDesc(p, 0.1f, v, 1, e));
  }
  std::unique_ptr<CWorld> m_pWorld = Make();
};
SHAPES_ON_EVERY_BACKEND(CEffectContract);

// The content of the world says what runs, from the next step on, and the statistics count it.
// @param set  makes the content call for the effect, or not
void ExpectFollows(CWorld& world, eEffect e, const std::function<void(bool)>& set) {
  SCOPED_TRACE(GetName(e));
  for (const bool calls : {true, false, true, false}) {
    set(calls);
    EXPECT_EQ(world.GetEffects().Has(e), calls);
    const std::uint64_t ran = world.GetStats().GetSubstepsWith(e);
    world.Step();
    EXPECT_EQ(world.GetStats().GetSubstepsWith(e), ran + (calls ? 2 : 0));
  }
}

TEST_P(CEffectContract, ContentCallsForEffects) {
  CWorld& world = *m_pWorld;
  AddBall(world, {0, 5});
  const auto expectCalls = [&](std::initializer_list<eEffect> effects, const CAnyShapeDesc& desc) {
    CShapeId id;
    for (const eEffect e : effects)
      ExpectFollows(world, e, [&](bool isThere) {
        if (isThere)
          id = world.Add(desc);
        else
          world.Remove(id);
      });
  };
  expectCalls({eEffect::Events, eEffect::Continuous}, CLineSegDesc({-1, 0}, {1, 0}));
  expectCalls({eEffect::Kinematics}, Flipper(1));
  expectCalls({eEffect::BallPairs, eEffect::Continuous}, CDynamicCircleDesc({3, 3}, 0.1f));
  expectCalls({eEffect::Sensors}, MakeZone({-3, 0}, 1));

  const CShapeId flipper = world.Add(Flipper(0)), other = AddBall(world, {3, 3});
  const auto down = [](bool is) { return Vector2(0, is ? -1.0f : 0.0f); };
  ExpectFollows(world, eEffect::Gravity, [&](bool on) { world.SetGravity(down(on)); });
  ExpectFollows(world, eEffect::Kinematics, [&](bool on) { world.SetRotSpeed(flipper, on ? 0.01f : 0); });
  ExpectFollows(world, eEffect::Kinematics, [&](bool on) { world.SetVel(flipper, down(on)); });
  ExpectFollows(world, eEffect::BallPairs, [&](bool on) { world.SetCanCollide(other, on); });
  ExpectFollows(world, eEffect::Sensors, [&](bool on) { world.SetSensor(flipper, on); });
}

TEST_P(CEffectContract, WhatCallsForAnEffectFeelsItInTheNextStep) {
  const CShapeId ball = AddBall(*m_pWorld, {0, 5});
  Steps(*m_pWorld, 3);
  EXPECT_EQ(m_pWorld->GetVel(ball), Vector2::Zero());
  m_pWorld->SetGravity({0, -6});
  Steps(*m_pWorld, 1);
  EXPECT_NEAR(m_pWorld->GetVel(ball).y(), -0.1f, 1e-6f);
  m_pWorld->SetGravity({0, 0});
  Steps(*m_pWorld, 1);
  EXPECT_NEAR(m_pWorld->GetVel(ball).y(), -0.1f, 1e-6f);

  const CShapeId flipper = m_pWorld->Add(Flipper(0));
  Steps(*m_pWorld, 1);
  EXPECT_EQ(m_pWorld->GetOrientation(flipper), 0);
  m_pWorld->SetRotSpeed(flipper, 0.3f);
  Steps(*m_pWorld, 1);
  EXPECT_NEAR(m_pWorld->GetOrientation(flipper), g_fTwoPi * 0.3f * g_fDt, 1e-6f);
  m_pWorld->SetRotSpeed(flipper, 0);
  Steps(*m_pWorld, 1);
  EXPECT_NEAR(m_pWorld->GetOrientation(flipper), g_fTwoPi * 0.3f * g_fDt, 1e-6f);

  const CShapeId zone = m_pWorld->Add(MakeZone(m_pWorld->GetPos(ball), 1));
  Steps(*m_pWorld, 1);
  ASSERT_EQ(m_pWorld->GetSensorEvents().size(), 1u);
  EXPECT_EQ(m_pWorld->GetSensorEvents()[0], (CSensorEvent{zone, ball, true}));
  m_pWorld->Remove(zone);
  Steps(*m_pWorld, 1); // what is left to tell calls for it, too
  ASSERT_EQ(m_pWorld->GetSensorEvents().size(), 1u);
  EXPECT_EQ(m_pWorld->GetSensorEvents()[0], (CSensorEvent{zone, ball, false}));
  EXPECT_FALSE(m_pWorld->GetEffects().Has(eEffect::Sensors));

  m_pWorld->SetVel(ball, {0, 0});
  const CShapeId other = AddBall(*m_pWorld, m_pWorld->GetPos(ball) + Vector2(0.25f, 0), {-4, 0});
  Steps(*m_pWorld, 2);
  EXPECT_NEAR(m_pWorld->GetVel(ball).x(), -4, 1e-4f); // it has got all of it
  EXPECT_NEAR(m_pWorld->GetVel(other).x(), 0, 1e-4f);

  const Vector2 behind = m_pWorld->GetPos(ball) - Vector2(0.2f, 0);
  m_pWorld->Add(CLineSegDesc(behind - Vector2(0, 1), behind + Vector2(0, 1)));
  Steps(*m_pWorld, 2);
  EXPECT_NEAR(m_pWorld->GetVel(ball).x(), 4, 1e-4f);
}

TEST_P(CEffectContract, WithoutGravityABallFliesStraight) {
  for (const bool forbidden : {true, false}) {
    auto pWorld = Make(forbidden ? Forbidden(eEffect::Gravity) : g_cAutomatic, {0, -10});
    const CShapeId ball = AddBall(*pWorld, {0, 0}, {3, 4});
    Steps(*pWorld, 60);
    EXPECT_EQ(pWorld->GetVel(ball) == Vector2(3, 4), forbidden);
    EXPECT_EQ(pWorld->GetStats().m_nBallsAccelerated, forbidden ? 0u : 120u);
    EXPECT_EQ(pWorld->GetStats().GetSubstepsWith(eEffect::Gravity), forbidden ? 0u : 120u);
    EXPECT_EQ(pWorld->GetDesc().m_vGravity, Vector2(0, -10));
  }
}

TEST_P(CEffectContract, WithoutKinematicsShapesNeitherTurnNorMoveNorKick) {
  for (const bool forbidden : {true, false}) {
    auto pWorld = Make(forbidden ? Forbidden(eEffect::Kinematics) : g_cAutomatic);
    const CShapeId flipper = pWorld->Add(Flipper(0.2f));
    const CShapeId wall = pWorld->Add(Moving(CLineSegDesc({0, -2}, {0, -4}), {2, 0}));
    const CShapeId ball = AddBall(*pWorld, {0.5f, 0.2f}, {0, -2});
    Steps(*pWorld, 10);
    EXPECT_EQ(pWorld->GetRotSpeed(flipper), 0.2f); // what was asked for
    EXPECT_EQ(pWorld->GetVel(wall), Vector2(2, 0));
    EXPECT_EQ(pWorld->GetOrientation(flipper) == 0.0f, forbidden);
    EXPECT_EQ(pWorld->GetPos(wall) == Vector2(0, -3), forbidden);
    EXPECT_EQ(pWorld->GetStats().m_nShapesTurned, forbidden ? 0u : 40u);
    EXPECT_EQ(pWorld->GetEffects().Has(eEffect::Kinematics), !forbidden);
    if (forbidden)
      EXPECT_NEAR(pWorld->GetVel(ball).y(), 2, 1e-5f);
    else
      EXPECT_GT(pWorld->GetVel(ball).y(), 2.8f); // 2 + twice the .63 of the surface, a bit oblique
  }
}

TEST_P(CEffectContract, WithoutBallPairsBallsPassThroughEachOther) {
  for (const bool forbidden : {true, false}) {
    auto pWorld = Make(forbidden ? Forbidden(eEffect::BallPairs) : g_cAutomatic);
    pWorld->Add(CLineSegDesc({1, -1}, {1, 1}));
    const CShapeId left = AddBall(*pWorld, {-0.5f, 0}, {2, 0}), right = AddBall(*pWorld, {0.5f, 0}, {-2, 0});
    pWorld->SetCanCollide(left, false); // turned off and on again it is what it was
    pWorld->SetCanCollide(left, true);
    Steps(*pWorld, 25);
    EXPECT_NEAR(pWorld->GetVel(left).x(), forbidden ? 2 : -2, 1e-4f);
    EXPECT_NEAR(pWorld->GetVel(right).x(), forbidden ? -2 : 2, 1e-4f);
    EXPECT_EQ(pWorld->GetStats().m_nContacts > 0, !forbidden);
    if (forbidden) {
      EXPECT_EQ(pWorld->GetStats().m_nBallTests, 0u);
    }
    // They meet walls all the same.
    Steps(*pWorld, 25);
    EXPECT_GT(pWorld->GetStats().m_nContacts, 0u);
    EXPECT_LT(pWorld->GetVel(left).x(), 0);
  }
}

TEST_P(CEffectContract, WithoutSensorsNothingIsTold) {
  for (const bool forbidden : {true, false}) {
    auto pWorld = Make(forbidden ? Forbidden(eEffect::Sensors) : g_cAutomatic);
    pWorld->Add(MakeZone({0, 0}, 1));
    AddBall(*pWorld, {-2, 0}, {6, 0});
    EXPECT_EQ(Told(*pWorld, 60, &CWorld::GetSensorEvents).empty(), forbidden);
    EXPECT_EQ(pWorld->GetStats().m_nSensorHits > 0, !forbidden); // a contact each
    EXPECT_EQ(pWorld->GetStats().m_nReported, pWorld->GetStats().m_nSensorHits);
    EXPECT_EQ(pWorld->GetStats().m_nSensorTests > 0, !forbidden);
    EXPECT_EQ(pWorld->GetBallVelocities()[0], Vector2(6, 0)); // a sensor is not solid, watched or not
  }
}

TEST_P(CEffectContract, WithoutEventsBallsBounceUntold) {
  // The last two on Box2D by listening to contacts, which would take the larger one and stop at 1.
  for (const auto& [wall, ball, other] :
       {std::array{1.0f, 1.0f, 1.0f}, {0.5f, 0.8f, 0.8f}, {0.5f, 0.8f, 0.9f}, {1.5f, 1.0f, 1.0f}})
    for (const bool forbidden : {true, false}) {
      auto pWorld = Make(forbidden ? Forbidden(eEffect::Events) : g_cAutomatic);
      const CShapeId floor = pWorld->Add(CLineSegDesc({-1, -1}, {1, -1}, wall));
      pWorld->Add(CLineSegDesc({4, 0}, {5, 0}, 0.7f));
      const CShapeId id = AddBall(*pWorld, {0, 0.3f}, {0, -2}, ball);
      AddBall(*pWorld, {4.5f, 3}, {0, 0}, other);
      pWorld->Step();
      pWorld->SetPos(floor, {0, 0}); // in another place it keeps its elasticity
      const std::size_t told = Told(*pWorld, 15, &CWorld::GetContacts).size();
      EXPECT_NEAR(pWorld->GetVel(id).y(), 2 * wall * ball, 1e-4f);
      EXPECT_EQ(told > 0, !forbidden);
      EXPECT_EQ(pWorld->GetStats().m_nReported, told);
    }
}

TEST_P(CEffectContract, WhatIsNotCalledForCountsNothing) {
  m_pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  m_pWorld->Add(Flipper(0)); // kinematic, but it stands still
  const CShapeId ball = AddBall(*m_pWorld, {0, 0.5f}, {0, -1});
  Steps(*m_pWorld, 60);
  const CWorldStats before = m_pWorld->GetStats();
  for (const std::uint64_t n :
       {before.m_nBallsAccelerated, before.m_nShapesTurned, before.m_nBallTests, before.m_nBallsHalted,
        before.m_nSensorTests, before.m_nSensorHits, before.m_nSpeedsCapped, before.m_nMovesClamped,
        before.m_nTurnsClamped, before.m_nArcPieces})
    EXPECT_EQ(n, 0u);
  // The effects of every world in which a ball can meet anything.
  const CEffects meeting{eEffect::Events, eEffect::Continuous};
  for (const eEffect e : AllEffects())
    EXPECT_EQ(before.GetSubstepsWith(e), meeting.Has(e) ? 120u : 0u) << GetName(e);
  EXPECT_GT(before.m_nContacts, 0u);

  m_pWorld->SetGravity({0, -1}); // the control: each is counted where it is called for
  m_pWorld->Add(Flipper(0.1f));
  m_pWorld->Add(MakeZone({0, 0}, 0.5f));
  AddBall(*m_pWorld, {0, 3}, {20, 0});
  m_pWorld->SetPos(ball, {0, 0.5f});
  Steps(*m_pWorld, 60);
  const CWorldStats& after = m_pWorld->GetStats();
  EXPECT_EQ(after.m_nBallsAccelerated, 240u);
  EXPECT_EQ(after.m_nShapesTurned, 120u);
  EXPECT_GT(after.m_nSensorTests, 0u);
  EXPECT_GT(after.m_nSensorHits, 0u);
  for (const eEffect e : AllEffects())
    EXPECT_EQ(after.GetSubstepsWith(e), meeting.Has(e) ? 240u : 120u) << GetName(e);
}

TEST_P(CEffectContract, WhatMeetsNothingIsNotSwept) {
  m_pWorld->Add(MakeZone({0, 0}, 0.5f));
  AddBall(*m_pWorld, {0, 0.5f}, {0, -50});
  Steps(*m_pWorld, 60);
  EXPECT_EQ(m_pWorld->GetStats().GetSubstepsWith(eEffect::Continuous), 0u);
  EXPECT_EQ(m_pWorld->GetStats().m_nSweeps + m_pWorld->GetStats().m_nContacts, 0u);
}

TEST_P(CEffectContract, ForcedRunsForbiddenDoesNotAndBothIsRefusedWhateverIsThere) {
  for (const eEffect e : AllEffects()) {
    SCOPED_TRACE(GetName(e));
    auto pForced = Make(Forced(e));
    EXPECT_EQ(pForced->GetEffects(), CEffects{e}); // nothing is there
    pForced->Step();
    EXPECT_EQ(pForced->GetStats().GetSubstepsWith(e), 2u);

    auto pForbidden = Make(Forbidden(e), {0, -1});
    pForbidden->Add(Flipper(0.1f));
    pForbidden->Add(MakeZone({0, 0}, 0.5f));
    AddBall(*pForbidden, {0, 3}, {20, 0});
    AddBall(*pForbidden, {0, 5});
    EXPECT_EQ(pForbidden->GetEffects(), (CEffects::All() - CEffects{e, eEffect::Touches}));
    pForbidden->Step();
    EXPECT_EQ(pForbidden->GetStats().GetSubstepsWith(e), 0u);

    const std::string refusal = MessageOf<std::invalid_argument>([&] { Make({{e}, {e}}); });
    EXPECT_TRUE(Says(refusal, "m_cEffects"));
    EXPECT_TRUE(Says(refusal, GetName(e)));
  }
}

TEST_P(CEffectContract, TheWorldSaysWhatRunsAndWhy) {
  auto pWorld = Make({{eEffect::Sensors}, {eEffect::BallPairs}}, {0, -10});
  pWorld->Add(Flipper(0.25f));
  AddBall(*pWorld, {0, 3}, {3, 0});
  AddBall(*pWorld, {0, 5}, {0, 12});
  EXPECT_EQ(pWorld->ExplainEffects(), "Gravity: runs; gravity is (0, -10), 2 balls\n"
                                      "Kinematics: runs; 1 shape moves or rotates\n"
                                      "BallPairs: does not run, forbidden by the description; 2 solid balls\n"
                                      "Sensors: runs, forced by the description; 0 sensors\n"
                                      "Events: runs; 2 solid balls, 1 solid shape, 0 sensors\n"
                                      "Continuous: runs; 2 solid balls, 1 solid shape, gravity is (0, -10)\n"
                                      "Touches: does not run; 0 pairs touch\n");
}

} // namespace
} // namespace Shapes
