// SPDX-License-Identifier: MIT
// A game does to the bodies of Shapes in its b2World as it likes: lets balls through, weighs them, holds,
// freezes, destroys them, puts fixtures and joints on them.
#include "GuestTesting.h"

namespace Shapes::Tests {
namespace {

class CGuestBodies : public CGuest {};
SHAPES_ON_EVERY_PROFILE(CGuestBodies);

constexpr float g_fGravity = 10;

// One-way platforms of Box2D: the listener of the game disables the contact.
TEST_P(CGuestBodies, ABallPassesWhatTheListenerDisables) {
  struct CGate : b2ContactListener {
    const b2Body* m_pBall = nullptr;
    void PreSolve(b2Contact* p, const b2Manifold*) override {
      if (p->GetFixtureA()->GetBody() == m_pBall || p->GetFixtureB()->GetBody() == m_pBall)
        p->SetEnabled(false);
    }
  } gate;
  m_cGame.SetContactListener(&gate);
  for (const float gravity : {0.0f, g_fGravity})
    for (const float speed : {0.5f, 6.0f, 60.0f}) {
      SCOPED_TRACE(testing::Message() << "gravity " << gravity << ", speed " << speed);
      m_cGame.SetGravity({0, -gravity});
      Join().Add(CLineSegDesc({-5, 0}, {5, 0}));
      const CShapeId ball = World().Add(CDynamicCircleDesc({0, 0.5f}, 0.1f, {0, -speed}));
      const CShapeId other = World().Add(CDynamicCircleDesc({1, 0.5f}, 0.1f, {0, -speed}));
      gate.m_pBall = BodyOf(ball);
      const float t = 1.1f / speed + 2 * g_fDt;
      Steps(static_cast<int>(t / g_fDt));
      EXPECT_LT(World().GetPos(ball).y(), -0.2f);
      EXPECT_GT(World().GetPos(other).y(), 0.0f); // the control
      m_pGuest.reset();                           // before the listener
    }
}

// On a plate that hangs on a spring of 50 N/m a ball of 1 kg is 10 N.
TEST_P(CGuestBodies, BallsWeighOnBodiesOfTheGame) {
  for (const int balls : {1, 3}) {
    b2World game({0, -g_fGravity});
    b2Body* pGround = CGame::AddBody(game, b2_staticBody);
    b2Body* pPlate = AddBox(game, {0, 0});
    b2PrismaticJointDef rail;
    rail.Initialize(pGround, pPlate, {0, 0}, {0, 1});
    game.CreateJoint(&rail);
    b2DistanceJointDef spring;
    spring.Initialize(pGround, pPlate, {0, 3}, {0, 0});
    spring.stiffness = 50;
    spring.damping = 5;
    spring.minLength = 0;
    spring.maxLength = 100;
    game.CreateJoint(&spring);
    const auto pGuest = MakeGuest(game, GetParam());
    Tests::Steps(game, *pGuest, 600);
    const float y = pPlate->GetPosition().y;
    for (int i = 0; i < balls; ++i)
      pGuest->GetWorld().Add(
          CDynamicCircleDesc({0.3f * static_cast<float>(i - balls / 2), y + 0.62f}, 0.1f, {0, 0}, 1, 0));
    Tests::Steps(game, *pGuest, 1200);
    EXPECT_NEAR(y - pPlate->GetPosition().y, 0.2f * static_cast<float>(balls), 0.004f) << balls;
    ASSERT_FALSE(pGuest->GetWorld().GetContacts().empty());
    for (const CContactEvent& contact : pGuest->GetWorld().GetContacts())
      EXPECT_NEAR(contact.m_fImpulse, g_fGravity * g_fDt, 0.02f * g_fGravity * g_fDt);
  }
}

// Box2D computes masses anew from the densities of fixtures.
TEST_P(CGuestBodies, ABallKeepsItsMass) {
  const std::vector<std::function<void(b2Body&)>> changes = {
      [](b2Body& body) {
        body.SetType(b2_staticBody);
        body.SetType(b2_dynamicBody);
      },
      [](b2Body& body) { body.SetFixedRotation(false); },
      [](b2Body& body) {
        CGame::AddFixture(&body, CGame::Circle({0, 0}, 1));
        body.GetFixtureList()->SetSensor(true);
        body.DestroyFixture(body.GetFixtureList());
      }};
  m_cGame.SetGravity({0, -g_fGravity});
  for (const float r : {0.0f, 0.1f})
    for (const auto& change : changes) {
      Join().Add(CLineSegDesc({-5, 0}, {5, 0}));
      const CShapeId ball = World().Add(CDynamicCircleDesc({0, 2}, r, {0, 0}, 3));
      b2Body* pBody = BodyOf(ball);
      change(*pBody);
      pBody->SetLinearVelocity({0, -3});
      Steps(300);
      EXPECT_EQ(pBody->GetMass(), 3);
      EXPECT_GT(World().GetPos(ball).y(), 0.0f);
    }
}

TEST_P(CGuestBodies, WhatIsNotSolidIsNoneForFiltersAndRaysOfTheGame) {
  struct CAnyFilter : b2ContactFilter {
    bool ShouldCollide(b2Fixture*, b2Fixture*) override { return true; }
  } filter;
  struct CRay : b2RayCastCallback {
    int m_nSolid = 0;
    float ReportFixture(b2Fixture* p, const b2Vec2&, const b2Vec2&, float) override {
      m_nSolid += !p->IsSensor();
      return 1;
    }
  };
  for (b2ContactFilter* pFilter :
       {static_cast<b2ContactFilter*>(&filter), static_cast<b2ContactFilter*>(nullptr)}) {
    m_cGame.SetContactFilter(pFilter);
    CLineSegDesc gate({0, -1}, {0, 1});
    gate.m_bIsSensor = true;
    Join().Add(gate);
    const CShapeId wall = World().Add(CLineSegDesc({0, 2}, {0, 4}));
    World().SetCanCollide(wall, false);
    const CShapeId a = World().Add(CDynamicCircleDesc({-1, 0}, 0.1f, {2, 0}));
    const CShapeId b = World().Add(CDynamicCircleDesc({-1, 3}, 0.1f, {2, 0}));
    Steps(60);
    EXPECT_NEAR(World().GetPos(a).x(), 1, 1e-3f);
    EXPECT_NEAR(World().GetPos(b).x(), 1, 1e-3f);
    CRay ray;
    m_cGame.RayCast(&ray, {-0.5f, 3}, {0.5f, 3});
    EXPECT_EQ(ray.m_nSolid, 0);
    World().SetCanCollide(wall, true);
    m_cGame.RayCast(&ray, {-0.5f, 3}, {0.5f, 3});
    EXPECT_EQ(ray.m_nSolid, 1); // the control
  }
}

// A game that is paused by disabling all bodies.
TEST_P(CGuestBodies, NothingIsWhereNothingWasAdded) {
  b2Body* pBox = AddBox(m_cGame, {0, 3});
  Join();
  for (const bool is : {false, true})
    for (b2Body* p = m_cGame.GetBodyList(); p != nullptr; p = p->GetNext())
      p->SetEnabled(is);
  m_cGame.SetGravity({0, -g_fGravity});
  Steps(90);
  EXPECT_LT(pBox->GetPosition().y, -5);
}

// Turned off, held or asleep, a ball stays where it is.
TEST_P(CGuestBodies, ABallThatTheGameHoldsDoesNotFall) {
  m_cGame.SetGravity({0, -g_fGravity});
  const std::vector<std::function<void(b2Body&)>> holds = {[](b2Body& b) { b.SetEnabled(false); },
                                                           [](b2Body& b) { b.SetType(b2_kinematicBody); },
                                                           [](b2Body& b) { b.SetAwake(false); }};
  for (const auto& hold : holds) {
    Join();
    const CShapeId ball = World().Add(CDynamicCircleDesc({0, 5}, 0.1f));
    hold(*BodyOf(ball));
    Steps(60);
    EXPECT_EQ(World().GetVel(ball), Vector2(0, 0));
    EXPECT_EQ(World().GetPos(ball), Vector2(0, 5));
  }
  b2Body* pBody = BodyOf(World().GetBallIds()[0]);
  pBody->SetEnabled(false);
  World().SetCanCollide(World().GetBallIds()[0], false);
  EXPECT_FALSE(pBody->IsEnabled());
  pBody->SetEnabled(true);
  World().SetPos(World().GetBallIds()[0], {0, 4}); // wakes it
  Steps(60);
  EXPECT_NEAR(World().GetVel(World().GetBallIds()[0]).y(), -g_fGravity, 0.01f);
}

TEST_P(CGuestBodies, AFixtureOfTheGameStaysAsItIs) {
  const CShapeId ball = Join().Add(CDynamicCircleDesc({0, 0}, 0.1f, {2, 0}));
  b2Body* pBody = BodyOf(ball);
  CGame::AddFixture(pBody, CGame::Circle({0, 0}, 1));
  b2Fixture* pRadar = pBody->GetFixtureList();
  pRadar->SetSensor(true);
  pRadar->GetUserData().pointer = 7;
  b2Filter filter;
  filter.categoryBits = 8;
  filter.maskBits = 4;
  filter.groupIndex = -5;
  pRadar->SetFilterData(filter);
  World().SetElasticity(ball, 0.5f);
  World().SetCanCollide(ball, false);
  World().SetCanCollide(ball, true);
  EXPECT_EQ(pRadar->GetUserData().pointer, 7u);
  EXPECT_EQ(pRadar->GetFilterData().categoryBits, 8);
  EXPECT_EQ(pRadar->GetFilterData().maskBits, 4);
  EXPECT_TRUE(pRadar->IsSensor());
  EXPECT_NE(pRadar->GetNext()->GetFilterData().groupIndex, -5);
}

// A lamp that hangs on a wall by a joint of the game.
TEST_P(CGuestBodies, AShapeThatIsMovedKeepsTheJointsOnIt) {
  const std::vector<std::function<void(CWorld&, CShapeId)>> moves = {
      [](CWorld& world, CShapeId id) {
        world.SetPos(id, {0.6f, 0});
      },
      [](CWorld& world, CShapeId id) { world.SetOrientation(id, 0.1f); },
      [](CWorld& world, CShapeId id) { world.SetElasticity(id, 0.1f); },
      [](CWorld& world, CShapeId id) {
        world.SetVel(id, {0.1f, 0});
      }};
  for (const auto& move : moves) {
    b2World game({0, -g_fGravity});
    const auto pGuest = MakeGuest(game, GetParam());
    CWorld& world = pGuest->GetWorld();
    const CShapeId wall = world.Add(Turning(CLineSegDesc({0, 0}, {1, 0})));
    world.SetUserPtr(wall, this);
    b2Body* pLamp = AddBox(game, {0, -2});
    b2DistanceJointDef joint;
    joint.Initialize(FindBody(game, this), pLamp, {0, 0}, {0, -2});
    game.CreateJoint(&joint);
    move(world, wall);
    Tests::Steps(game, *pGuest, 60);
    EXPECT_EQ(game.GetJointCount(), 1);
    EXPECT_GT(pLamp->GetPosition().y, -3);
  }
}

// And balls, its own and those of the game, find it where it is.
TEST_P(CGuestBodies, AShapeThatIsMovedIsMetThere) {
  for (const bool isMoved : {false, true})
    for (const bool isKinematic : {false, true}) {
      CLineSegDesc desc({-1, 0}, {1, 0});
      if (isKinematic) desc.m_eMotionType = eMotion::Kinematic;
      const CShapeId wall = Join().Add(desc);
      b2Body* pBox = AddBox(m_cGame, {0.5f, 6});
      pBox->SetLinearVelocity({0, -3});
      Steps(1);
      if (isMoved) World().SetPos(wall, {0, 2});
      const Vector2 v = Throw(CDynamicCircleDesc({-0.5f, 4}, 0.1f, {0, -3}), 60);
      EXPECT_EQ(v.y() > 0, isMoved);
      Steps(20);
      EXPECT_EQ(pBox->GetPosition().y > 2, isMoved);
      m_cGame.DestroyBody(pBox);
    }
}

TEST_P(CGuestBodies, AShapeThatIsResetIsWhereItWasAdded) {
  const CShapeId wall = Join().Add(Turning(CLineSegDesc({0, 0}, {2, 0})));
  World().SetRotCenter(wall, {2, 0});
  World().SetOrientation(wall, 0.5f * g_fPi);
  Steps(1);
  World().Reset(wall);
  EXPECT_GT(Throw(CDynamicCircleDesc({0.5f, 1}, 0.1f, {0, -3}), 40).y(), 0);
}

TEST_P(CGuestBodies, WhatLiesOnAShapeThatGoesAwayFalls) {
  m_cGame.SetGravity({0, -g_fGravity});
  const CShapeId floor = Join().Add(CLineSegDesc({-1, 0}, {1, 0}));
  b2Body* pBox = AddBox(m_cGame, {0, 0.5f});
  Steps(120);
  EXPECT_FALSE(pBox->IsAwake()); // the control
  World().SetPos(floor, {0, -5});
  Steps(60);
  EXPECT_LT(pBox->GetPosition().y, -3);
}

TEST_P(CGuestBodies, WhatLiesOnAShapeThatIsTurnedOffFalls) {
  m_cGame.SetGravity({0, -g_fGravity});
  const std::vector<std::function<void(CWorld&, CShapeId)>> changes = {
      [](CWorld& world, CShapeId id) { world.SetCanCollide(id, false); },
      [](CWorld& world, CShapeId id) { world.SetSensor(id, true); },
      [](CWorld& world, CShapeId id) {
        world.SetFilter(id, {1, 0});
      },
      [](CWorld& world, CShapeId id) { world.Remove(id); }};
  for (const auto& change : changes) {
    const CShapeId floor = Join().Add(CLineSegDesc({-1, 0}, {1, 0}));
    b2Body* pBox = AddBox(m_cGame, {0, 0.5f});
    Steps(120);
    EXPECT_FALSE(pBox->IsAwake()); // the control
    change(World(), floor);
    Steps(60);
    EXPECT_LT(pBox->GetPosition().y, -3);
    m_cGame.DestroyBody(pBox);
  }
}

// One that stands still sleeps, and so does the box.
TEST_P(CGuestBodies, AShapeThatIsPutOnABodyPushesIt) {
  m_cGame.SetGravity({0, -g_fGravity});
  AddGround(m_cGame);
  b2Body* pBox = AddBox(m_cGame, {0, 0.51f});
  const CShapeId wall = Join().Add(Turning(CLineSegDesc({-5, 5}, {-5, 6})));
  Steps(120);
  EXPECT_FALSE(pBox->IsAwake()); // the control
  World().SetPos(wall, {0.3f, 0.5f});
  Steps(60);
  EXPECT_GT((pBox->GetPosition() - b2Vec2(0, 0.5f)).Length(), 0.1f);
}

// The shape turns about its new centre from where it was made.
TEST_P(CGuestBodies, AShapeIsMetWhereItIsAfterItsCentreHasChanged) {
  for (const bool isDriven : {false, true}) {
    const CShapeId wall = Join().Add(Turning(CLineSegDesc({0, 0}, {1, 0})));
    World().SetOrientation(wall, 0.5f * g_fPi);
    World().SetRotCenter(wall, {5, 5});
    if (isDriven) {
      World().SetRotSpeed(wall, 0.01f);
      Steps(1);
      World().SetRotSpeed(wall, 0);
    } else {
      World().SetOrientation(wall, g_fPi);
    }
    const Vector2 at = World().GetPos(wall);
    const float angle = World().GetOrientation(wall);
    const Vector2 side(-std::sin(angle), std::cos(angle));
    const Vector2 v = Throw(CDynamicCircleDesc(at + side, 0.1f, -3 * side), 30);
    EXPECT_GT(v.dot(side), 0) << isDriven;
  }
}

// Another ball falls on it.
TEST_P(CGuestBodies, ABallThatIsHeldIsNotMovedByAnother) {
  m_cGame.SetGravity({0, -g_fGravity});
  for (const b2BodyType type : {b2_kinematicBody, b2_staticBody})
    for (const bool isFirst : {false, true}) {
      Join();
      const CDynamicCircleDesc falling({0.02f, 6}, 0.1f), resting({0, 5}, 0.1f);
      const CShapeId first = World().Add(isFirst ? resting : falling);
      const CShapeId second = World().Add(isFirst ? falling : resting);
      const CShapeId held = isFirst ? first : second, other = isFirst ? second : first;
      BodyOf(held)->SetType(type);
      Steps(32);
      EXPECT_EQ(World().GetPos(held), Vector2(0, 5));
      EXPECT_EQ(World().GetVel(held), Vector2(0, 0));
      EXPECT_GT(World().GetVel(other).y(), 0);
    }
}

TEST_P(CGuestBodies, BodiesOfTheGameSleepOnAShapeThatDoesNotMove) {
  m_cGame.SetGravity({0, -g_fGravity});
  Join().Add(Turning(CLineSegDesc({-1, 0}, {1, 0})));
  b2Body* pBox = AddBox(m_cGame, {0, 0.5f});
  Steps(120);
  EXPECT_FALSE(pBox->IsAwake());
  World().SetVel(World().GetShapeIds()[0], {0, 0.5f});
  Steps(60);
  EXPECT_GT(pBox->GetPosition().y, 0.9f);
}

TEST_P(CGuestBodies, ElasticityThatIsSetHoldsAtOnceOnTheGroundOfTheGame) {
  m_cGame.SetGravity({0, -g_fGravity});
  AddGround(m_cGame);
  const CShapeId ball = Join().Add(CDynamicCircleDesc({0, 0.25f}, 0.1f, {0, 0}, 1, 0));
  Steps(60);
  World().SetElasticity(ball, 1);
  World().SetPos(ball, {0, 0.15f});
  World().SetVel(ball, {0, -3});
  Steps(3);
  EXPECT_GT(World().GetVel(ball).y(), 2.5f);
}

TEST_P(CGuestBodies, AShiftOfTheOriginIsTold) {
  Join().Add(CLineSegDesc({-1, 0}, {1, 0}));
  m_cGame.ShiftOrigin({10, 0});
  EXPECT_TRUE(Thrown([&] { Steps(1); }).starts_with("b2World::ShiftOrigin was called"));
  World().Remove(World().GetShapeIds()[0]);
  m_cGame.ShiftOrigin({10, 0});
  World().Add(CLineSegDesc({-1, 0}, {1, 0}));
  const Vector2 v = Throw(CDynamicCircleDesc({0, 0.3f}, 0.1f, {0, -3}), 20);
  EXPECT_GT(v.y(), 0);
}

// A bumper that breaks when it is hit: after b2World::Step, as Box2D demands, and before PostStep.
TEST_P(CGuestBodies, AShapeMayBeDestroyedOnceItIsHit) {
  m_cGame.SetGravity({0, -g_fGravity});
  m_cGame.SetContactListener(&m_cListener);
  const CShapeId bumper = Join().Add(CLineSegDesc({-1, 0}, {1, 0}));
  const CShapeId ball = World().Add(CDynamicCircleDesc({0, 0.5f}, 0.1f, {0, -3}));
  b2Body* pBumper = BodyOf(bumper);
  for (int step = 0; step < 60; ++step) {
    m_pGuest->PreStep(g_fDt);
    m_cGame.Step(g_fDt, 8, 3);
    if (m_cListener.m_nPost > 0 && pBumper != nullptr) m_cGame.DestroyBody(std::exchange(pBumper, nullptr));
    m_pGuest->PostStep();
  }
  EXPECT_EQ(World().GetStats().m_nBodiesLost, 1u);
  EXPECT_LT(World().GetPos(ball).y(), 0.5f);
}

// Where the end of one contact makes the game destroy another body, it is told of the end of that one, too.
TEST_P(CGuestBodies, EndsOfContactsWithinEachOtherAreAllTold) {
  m_cGame.SetGravity({0, -g_fGravity});
  AddGround(m_cGame);
  b2Body *pBomb = AddBox(m_cGame, {0, 0.5f}), *pOther = AddBox(m_cGame, {5, 0.5f});
  m_cGame.SetContactListener(&m_cListener);
  Join();
  Steps(10);
  m_cListener.m_nEnd = 0;
  m_cListener.m_stdAtEnd = [&] { m_cGame.DestroyBody(pOther); };
  m_cGame.DestroyBody(pBomb);
  EXPECT_EQ(m_cListener.m_nEnd, 2);
}

// A neighbour is added, so that a body is made anew; the game hears of the end of its contact, and destroys
// the body of a third one.
TEST_P(CGuestBodies, AListenerMayDestroyASegmentWhileEndsAreShared) {
  m_cGame.SetContactListener(&m_cListener);
  m_cGame.SetGravity({0, -g_fGravity});
  Join().Add(CLineSegDesc({-1, 0}, {1, 0}, 0));
  const CShapeId next = World().Add(CLineSegDesc({1, 0}, {2, 0}, 0));
  World().Add(CDynamicCircleDesc({0, 0.11f}, 0.1f, {0, 0}, 1, 0));
  Steps(20);
  b2Body* pNext = BodyOf(next);
  m_cListener.m_stdAtEnd = [&] { m_cGame.DestroyBody(pNext); };
  World().Add(CLineSegDesc({-2, 0}, {-1, 0}, 0));
  Steps(2);
  m_cListener.m_stdAtEnd = nullptr;
  EXPECT_EQ(World().Contains(next), !IsTuned());
}

} // namespace
} // namespace Shapes::Tests
