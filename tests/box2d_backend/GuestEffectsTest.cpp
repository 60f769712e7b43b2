// SPDX-License-Identifier: MIT
// Effects of a world in a game's b2World: some are the game's, and the world says what is true.
#include "GuestTesting.h"

namespace Shapes::Tests {
namespace {

class CGuestEffects : public CGuest {
protected:
  bool Has(eEffect e) { return World().GetEffects().Has(e); }
  std::uint64_t CountSubstepsWith(eEffect e) { return World().GetStats().GetSubstepsWith(e); }
};
SHAPES_ON_EVERY_PROFILE(CGuestEffects);

TEST_P(CGuestEffects, GravityIsThatOfTheGame) {
  CWorld& world = Join();
  const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0}, 0.1f));
  struct CRow {
    b2Vec2 m_cGravity;
    int m_nSteps;
    Vector2 m_vVel; // afterwards
    float m_fTolerance;
  };
  for (const CRow& row : {CRow{{0, 0}, 2, {0, 0}, 0}, CRow{{0, -6}, 3, {0, -0.3f}, 1e-6f},
                          CRow{{0, 0}, 2, {0, -0.3f}, 1e-6f}, CRow{{4, 0}, 30, {2, -0.3f}, 1e-4f}}) {
    m_cGame.SetGravity(row.m_cGravity);
    EXPECT_EQ(Has(eEffect::Gravity), row.m_cGravity != b2Vec2_zero);
    Steps(row.m_nSteps);
    EXPECT_LE((world.GetVel(ball) - row.m_vVel).norm(), row.m_fTolerance);
  }
  EXPECT_EQ(world.GetDesc().m_vGravity, Vector2(0, 0));
  EXPECT_EQ(CountSubstepsWith(eEffect::Gravity), 33u);
  EXPECT_EQ(world.GetStats().m_nBallsAccelerated, 33u);
}

TEST_P(CGuestEffects, ContinuousIsThatOfTheGameHoweverFastBallsAre) {
  CWorld& world = Join();
  world.Add(CLineSegDesc({0, -1}, {0, 1}));
  const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0}, 0.1f));
  for (const float speed : {1.0f, 100.0f})
    for (const bool runs : {true, false}) {
      m_cGame.SetContinuousPhysics(runs);
      EXPECT_EQ(Has(eEffect::Continuous), runs);
      const std::uint64_t ran = CountSubstepsWith(eEffect::Continuous);
      world.SetPos(ball, {-0.8f, 0});
      world.SetVel(ball, {speed, 0});
      Steps(3);
      EXPECT_EQ(CountSubstepsWith(eEffect::Continuous), ran + (runs ? 3 : 0));
      EXPECT_EQ(world.GetPos(ball).x() > 0, speed > 1 && !runs);
      Steps(60); // a slow ball bounces as it should without it, too
      EXPECT_TRUE(speed > 1 || std::abs(world.GetVel(ball).x() + 1) <= 1e-3f) << world.GetVel(ball).x();
    }
  EXPECT_TRUE(Says(world.ExplainEffects(), "Continuous: does not run, decided by the world around; "));
}

TEST_P(CGuestEffects, WhatIsTheGamesCanBeNeitherForcedNorForbidden) {
  for (const eEffect e : {eEffect::Gravity, eEffect::Continuous})
    for (const CEffectChoice& choice : {CEffectChoice{{e}, {}}, CEffectChoice{{}, {e}}}) {
      const std::string refusal = Thrown([&] { Join(choice); });
      for (const std::string_view word : {std::string_view("m_cEffects"), GetName(e), {"b2World"}})
        EXPECT_TRUE(Says(refusal, word));
      EXPECT_EQ(m_cGame.GetBodyCount(), 0); // nothing is half done
    }
  EXPECT_EQ(Thrown([&] { Join({{eEffect::Kinematics}, {eEffect::BallPairs, eEffect::Events}}); }), "");
}

TEST_P(CGuestEffects, EventsAreToldOfTheBodiesOfTheGameAlone) {
  for (const bool forbidden : {false, true}) {
    CWorld& world = Join(forbidden ? CEffectChoice{{}, {eEffect::Events}} : g_cAutomatic);
    b2Body* pGround = AddGround(m_cGame);
    const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0.3f}, 0.1f, {0, -3}));
    const std::size_t told = Told(10, &CWorld::GetContacts).size();
    EXPECT_NEAR(world.GetVel(ball).y(), 3, 1e-4f);
    EXPECT_EQ(told > 0, !forbidden);
    EXPECT_EQ(world.GetStats().m_nContacts, told);
    m_cGame.DestroyBody(pGround);
  }
}

// The bodies of the game are one, and have no id.
TEST_P(CGuestEffects, TouchesOfTheBodiesOfTheGameAreTold) {
  CWorld& world = Join({{eEffect::Touches}, {}});
  m_cGame.SetGravity({0, -10});
  AddGround(m_cGame);
  const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0.15f}, 0.1f, {0, 0}, 1, 0));
  EXPECT_EQ(Told(120, &CWorld::GetTouchEvents), (std::vector<CTouchEvent>{{CShapeId(), ball, true}}));
  world.SetVel(ball, {0, 3});
  EXPECT_EQ(Told(5, &CWorld::GetTouchEvents), (std::vector<CTouchEvent>{{CShapeId(), ball, false}}));
}

// A step of the game cannot be cut: the flipper is as slow in it as it has to be.
TEST_P(CGuestEffects, AFlipperComesToItsStopWithTheStep) {
  CWorld& world = Join();
  CLineSegDesc desc = Turning(CLineSegDesc({0, 0}, {1, 0}), 1);
  desc.m_cLimits = CMotionLimits::OfAngle(0, 0.25f);
  const CShapeId flipper = world.Add(desc);
  Steps(2);
  EXPECT_NEAR(world.GetOrientation(flipper), 2 * g_fTwoPi * g_fDt, 1e-6f);
  for (const int n : {1, 10}) {
    Steps(n);
    EXPECT_EQ(world.GetOrientation(flipper), 0.25f);
    EXPECT_NEAR(BodyOf(flipper)->GetAngle(), 0.25f, 1e-6f);
  }
}

TEST_P(CGuestEffects, WithoutEventsTheProductOfElasticitiesStays) {
  m_cGame.SetContactListener(&m_cListener);
  Join({{}, {eEffect::Events}}).Add(CLineSegDesc({-1, 0}, {1, 0}, 0.5f));
  const Vector2 v = Throw(CDynamicCircleDesc({0, 0.3f}, 0.1f, {0, -3}, 1, 0.8f), 12);
  EXPECT_NEAR(v.y(), 1.2f, 1e-4f);  // Box2D's larger one is .8
  EXPECT_GT(m_cListener.m_nPre, 0); // the game listens as before
}

TEST_P(CGuestEffects, WithoutBallPairsBallsPassThroughEachOtherAndMeetTheGame) {
  for (const bool forbidden : {false, true}) {
    CWorld& world = Join(forbidden ? CEffectChoice{{}, {eEffect::BallPairs}} : g_cAutomatic);
    const CShapeId left = world.Add(CDynamicCircleDesc({-0.5f, 3}, 0.1f, {2, 0}));
    world.Add(CDynamicCircleDesc({0.5f, 3}, 0.1f, {-2, 0}));
    b2Body* pBox = AddBox(m_cGame, {2, 3}, b2_staticBody);
    Steps(25);
    EXPECT_NEAR(world.GetVel(left).x(), forbidden ? 2 : -2, 1e-3f);
    // Turned off and on it is in the group still.
    world.SetCanCollide(left, false);
    world.SetCanCollide(left, true);
    world.SetPos(left, {0, 3});
    world.SetVel(left, {2, 0});
    Steps(60);
    EXPECT_LT(world.GetPos(left).x(), 1.45f); // the box
    m_cGame.DestroyBody(pBox);
  }
}

TEST_P(CGuestEffects, WhatIsHeldDoesNotTurnItsBody) {
  for (const bool forbidden : {false, true}) {
    CWorld& world = Join(forbidden ? CEffectChoice{{}, {eEffect::Kinematics}} : g_cAutomatic);
    const CShapeId flipper = world.Add(Turning(CLineSegDesc({0, 0}, {1, 0}), 0.5f));
    const b2Body* pBody = BodyOf(flipper);
    Steps(3);
    EXPECT_NEAR(pBody->GetAngularVelocity(), forbidden ? 0 : g_fPi, 1e-6f);
    EXPECT_NEAR(pBody->GetAngle(), forbidden ? 0 : g_fPi * 3 * g_fDt, 1e-5f);
    EXPECT_EQ(world.GetOrientation(flipper) == 0.0f, forbidden);
    world.SetRotSpeed(flipper, 0);
    const float angle = pBody->GetAngle();
    Steps(3);
    EXPECT_EQ(pBody->GetAngularVelocity(), 0);
    EXPECT_EQ(pBody->GetAngle(), angle);
    EXPECT_EQ(world.GetStats().m_nShapesTurned, forbidden ? 0u : 3u);
  }
}

TEST_P(CGuestEffects, AShapeThatTurnsMayBeLostInTheMiddleOfAStep) {
  CWorld& world = Join();
  const CShapeId lost = world.Add(Turning(CPointDesc(Vector2(1, 0)), 0.5f)),
                 stays = world.Add(Turning(CPointDesc(Vector2(1, 0)), 0.5f));
  Steps(1);
  const float angle = world.GetOrientation(stays);
  StepAndDestroy(lost);
  EXPECT_FALSE(world.Contains(lost));
  EXPECT_NEAR(world.GetOrientation(stays), 2 * angle, 1e-6f);
  EXPECT_EQ(world.GetStats().m_nShapesTurned, 3u);
}

TEST_P(CGuestEffects, BulletsAreThereForPairsOnly) {
  for (const bool forbidden : {false, true}) {
    CWorld& world = Join(forbidden ? CEffectChoice{{}, {eEffect::BallPairs}} : g_cAutomatic);
    const b2Body* pBody = BodyOf(world.Add(CDynamicCircleDesc({0, 0}, 0.1f)));
    const auto isBullet = [&] { return Steps(1), pBody->IsBullet(); };
    EXPECT_FALSE(isBullet());
    const CShapeId other = world.Add(CDynamicCircleDesc({1, 0}, 0.1f));
    EXPECT_EQ(isBullet(), IsTuned() && !forbidden);
    world.Remove(other);
    EXPECT_FALSE(isBullet());
  }
}

} // namespace
} // namespace Shapes::Tests
