// SPDX-License-Identifier: MIT
// Shapes in a game's own b2World: what they do there, and what the game sees of them.
#include "GuestTesting.h"

namespace Shapes::Tests {
namespace {

SHAPES_ON_EVERY_PROFILE(CGuest);

TEST_P(CGuest, ABallPushesABoxAndIsPushed) {
  b2Body* pBox = AddBox(m_cGame, {2, 0});
  const CShapeId ball = Join().Add(CDynamicCircleDesc({0, 0}, 0.1f, {4, 0}));
  Steps(60); // equal masses, and the larger restitution is that of the ball, 1: they exchange velocities
  EXPECT_NEAR(pBox->GetLinearVelocity().x, 4, 1e-4f);
  EXPECT_NEAR(World().GetVel(ball).x(), 0, 1e-4f);
  pBox->SetTransform({-2, 0}, 0);
  Steps(60);
  EXPECT_NEAR(pBox->GetLinearVelocity().x, 0, 1e-4f);
  EXPECT_NEAR(World().GetVel(ball).x(), 4, 1e-4f);
}

TEST_P(CGuest, WhatIsNotOfShapesIsReportedAsNoShape) {
  AddBox(m_cGame, {2, 0}, b2_staticBody);
  const CShapeId ball = Join().Add(CDynamicCircleDesc({0, 0}, 0.1f, {4, 0}));
  World().Add(CLineSegDesc({-2, -1}, {-2, 1}));
  std::vector<CContactEvent> events = Told(140, &CWorld::GetContacts);
  const auto isSame = [](const CContactEvent& a, const CContactEvent& b) { return a.m_cShape == b.m_cShape; };
  events.erase(std::unique(events.begin(), events.end(), isSame), events.end());
  ASSERT_EQ(events.size(), 3u); // the box, the segment, the box
  EXPECT_EQ(events[0].m_cShape, CShapeId());
  EXPECT_EQ(events[0].m_cBall, ball);
  EXPECT_EQ(events[0].m_vNorm, Vector2(-1, 0));
  EXPECT_NEAR(events[0].m_vPOI.x(), 1.5f, 0.03f); // the skins of Box2D and that of a tuned ball
  EXPECT_NEAR(events[0].m_fSpeed, 4, 1e-4f);
  EXPECT_NE(events[1].m_cShape, CShapeId());
  EXPECT_EQ(events[2].m_cShape, CShapeId());
}

TEST_P(CGuest, ABallBouncesOffTheGroundOfTheGameByTheLargerRestitution) {
  b2Body* pGround = AddGround(m_cGame);
  for (const auto& [ofBall, ofGround] : {std::pair(0.75f, 0.25f), std::pair(0.25f, 0.75f)}) {
    pGround->GetFixtureList()->SetRestitution(ofGround);
    Join();
    const Vector2 v = Throw(CDynamicCircleDesc({0, 0.5f}, 0.1f, {1, -2}, 1, ofBall), 30);
    EXPECT_LE((v - Vector2(1, 1.5f)).norm(), 1e-4f) << ofBall; // no friction: x stays
  }
}

TEST_P(CGuest, AFlipperKicksABallAndABox) {
  Join().Add(Turning(CLineSegDesc({0, 0}, {2, 0}), 1));
  b2Body* pBox = AddBox(m_cGame, {-1.5f, 0});
  const Vector2 v = Throw(CDynamicCircleDesc({1, 0.5f}, 0.1f), 15); // a quarter turn
  // Twice the speed of the surface where it meets the ball, sqrt(1.25 - .01) from the centre.
  EXPECT_NEAR(v.norm(), 2 * g_fTwoPi * std::sqrt(1.24f), IsTuned() ? 0.05f : 0.5f);
  EXPECT_EQ(pBox->GetLinearVelocity().Length(), 0);
  Steps(20);
  EXPECT_GT(pBox->GetLinearVelocity().Length(), 1);
}

TEST_P(CGuest, StepsMayDifferInLength) {
  m_cGame.SetGravity({0, -10});
  CWorld& world = Join();
  const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0}, 0.1f, {1, 5}));
  CRandom random(3);
  double t = 0;
  while (t < 1) {
    const float dt = 0.002f + 0.03f * static_cast<float>(random.Unit());
    Steps(1, dt);
    t += Wide(dt);
  }
  EXPECT_NEAR(world.GetPos(ball).x(), t, 1e-5);
  EXPECT_NEAR(world.GetVel(ball).y(), 5 - 10 * t, 1e-4);
  // A tuned ball is on the parabola. The control: Box2D's own way is below it, by g dt / 2 each second.
  const double off = Wide(world.GetPos(ball).y()) - (5 * t - 5 * t * t);
  EXPECT_TRUE(IsTuned() ? std::abs(off) <= 1e-5 : off < -0.05) << off;
}

// A difference would come from Shapes: ties, sentinel, listener, who steps. A tuned world of its own is
// scaled and cuts its steps.
TEST_P(CGuest, PixelsAndMetresGiveTheSameWayAndAsShippedThatOfAWorldOfItsOwn) {
  std::vector<Vector2> ways[2];
  for (const float u : {1.0f, 64.0f}) {
    const auto pOwned = MakeBox2D(GetParam(), {0.5f * u, -9.81f * u}, g_fDt, g_cAutomatic, u);
    b2World game({0.5f, -9.81f});
    const auto pGuest = MakeGuest(game, GetParam(), u);
    CWorld& guest = pGuest->GetWorld();
    CRandom random(5);
    std::vector<CAnyShapeDesc> shapes{CArcDesc({0, 0}, 5 * u, 0, 0, 0.95f),
                                      CLineSegDesc({-3 * u, -2 * u}, {0, -2.5f * u}),
                                      CCircleDesc({2 * u, 0}, 0.5f * u), CPointDesc({-2 * u, 1 * u}),
                                      Turning(CLineSegDesc({-u, u}, {u, u}), 0.7f, {-u, u})};
    for (int i = 0; i < 20; ++i) {
      const float x = -2 + 0.2f * static_cast<float>(i), v = static_cast<float>(4 * random.Unit() - 2);
      shapes.push_back(CDynamicCircleDesc({x * u, 3 * u}, 0.08f * u, {v * u, 0}, 1, 0.9f));
    }
    for (const CAnyShapeDesc& shape : shapes)
      pOwned->Add(shape), guest.Add(shape);
    std::size_t contacts = 0;
    for (int i = 0; i < 600; ++i) {
      pOwned->Step();
      Tests::Steps(game, *pGuest, 1);
      ASSERT_TRUE(IsTuned() || HaveSameBits(*pOwned, guest)) << "step " << i;
      ASSERT_TRUE(IsTuned() || pOwned->GetContacts().size() == guest.GetContacts().size());
      contacts += guest.GetContacts().size();
      for (const Vector2& p : guest.GetBallPositions())
        ways[u > 1].push_back(p / u);
    }
    EXPECT_GT(contacts, 100u);
  }
  EXPECT_EQ(ways[0], ways[1]); // a power of two rounds nothing
}

TEST_P(CGuest, ABallThatLiesOnTheGroundOfTheGameRests) {
  m_cGame.SetGravity({0, -10});
  AddGround(m_cGame);
  CWorld& world = Join();
  const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0.12f}, 0.1f, {0, 0}, 1, 0));
  Steps(60);
  const float y = world.GetPos(ball).y();
  EXPECT_NEAR(y, 0.1f, 0.02f); // the skins
  for (int i = 0; i < 300; ++i) {
    Steps(1);
    ASSERT_NEAR(world.GetPos(ball).y(), y, 1e-3f);
    ASSERT_NEAR(world.GetVel(ball).y(), 0, 1e-4f);
  }
}

TEST(GuestWorldTest, ATunedElasticDropOnTheGroundOfTheGameKeepsItsHeight) {
  const auto highest = [](eProfile e) { // of the last 10 s of 60
    b2World game({0, -9.81f});
    AddGround(game);
    const auto pGuest = MakeGuest(game, e);
    const CShapeId ball = pGuest->GetWorld().Add(CDynamicCircleDesc({0, 2.1f}, 0.1f));
    float top = 0;
    for (int i = 0; i < 7200; ++i) {
      Steps(game, *pGuest, 1, 0.5f * g_fDt);
      if (i >= 6000) top = std::max(top, pGuest->GetWorld().GetPos(ball).y());
    }
    return top - 0.1f;
  };
  EXPECT_NEAR(highest(eProfile::Tuned), 2, 0.04f);
  EXPECT_GT(highest(eProfile::Shipped), 3); // the control: it climbs
}

TEST_P(CGuest, TheListenerOfTheGameHearsEverythingAfterShapes) {
  CCounting& listener = m_cListener;
  m_cGame.SetContactListener(&listener);
  CWorld& world = Join();
  world.Add(CLineSegDesc({-1, 0}, {1, 0}, 0.5f));
  EXPECT_NEAR(Throw(CDynamicCircleDesc({0, 0.5f}, 0.1f, {0, -4}, 1, 0.5f), 30).y(), 1, 1e-4f);
  EXPECT_EQ(listener.m_nBegin, 1);
  EXPECT_EQ(listener.m_nEnd, 1);
  EXPECT_GE(listener.m_nPre, 1);
  EXPECT_GE(listener.m_nPost, 1);
  EXPECT_EQ(listener.m_fRestitution, 0.25f); // the product of both: Shapes has been there before
  world.Remove(world.GetBallIds()[0]);
  listener = CCounting();
  AddBox(m_cGame, {5, 0});
  AddBox(m_cGame, {5, 0.9f}); // what has nothing to do with Shapes, too
  Steps(2);
  EXPECT_GE(listener.m_nBegin, 1);
  EXPECT_GE(listener.m_nPost, 1);
}

TEST_P(CGuest, WhatTheGameDisablesIsNotReported) {
  struct COneWay : b2ContactListener {
    bool m_bIsOn = false;
    void PreSolve(b2Contact* pContact, const b2Manifold*) override { pContact->SetEnabled(m_bIsOn); }
  } listener;
  m_cGame.SetContactListener(&listener);
  AddGround(m_cGame);
  CWorld& world = Join();
  const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0.5f}, 0.1f, {0, -4}));
  Steps(30);
  EXPECT_EQ(world.GetVel(ball).y(), -4);
  EXPECT_EQ(world.GetStats().m_nContacts, 0u);
  listener.m_bIsOn = true; // the control
  world.SetVel(ball, {0, 4});
  Steps(30);
  EXPECT_NEAR(world.GetVel(ball).y(), -4, 1e-4f);
  EXPECT_GE(world.GetStats().m_nContacts, 1u);
  m_pGuest.reset(); // before the listener
}

TEST_P(CGuest, UserDataAreTheUserPointersOfShapes) {
  CWorld& world = Join();
  int mine = 0, other = 0;
  const CShapeId arc = world.Add(CArcDesc({0, 0}, 1, 0, 2)); // two chains
  const CShapeId ball = world.Add(CDynamicCircleDesc({3, 0}, 0.1f));
  for (b2Body* p = m_cGame.GetBodyList(); p != nullptr; p = p->GetNext()) {
    EXPECT_EQ(p->GetUserData().pointer, 0u);
    for (b2Fixture* q = p->GetFixtureList(); q != nullptr; q = q->GetNext())
      EXPECT_EQ(q->GetUserData().pointer, 0u);
  }
  world.SetUserPtr(arc, &mine);
  world.SetUserPtr(ball, &other);
  for (int* pUser : {&mine, &other})
    ASSERT_EQ(FindBodies(m_cGame, pUser).size(), 1u);
  for (b2Fixture* p = FindBody(m_cGame, &mine)->GetFixtureList(); p != nullptr; p = p->GetNext())
    EXPECT_EQ(p->GetUserData().pointer, reinterpret_cast<uintptr_t>(&mine));
  world.SetPos(arc, {1, 1}); // made anew
  EXPECT_EQ(FindBodies(m_cGame, &mine).size(), 1u);
}

TEST_P(CGuest, TheFilterOfTheGameIsAsked) {
  struct CNothingMeets : b2ContactFilter {
    bool ShouldCollide(b2Fixture*, b2Fixture*) override { return false; }
  } filter;
  AddGround(m_cGame);
  const auto fall = [&] {
    Join();
    return Throw(CDynamicCircleDesc({0, 0.5f}, 0.1f, {0, -4}), 30).y();
  };
  EXPECT_NEAR(fall(), 4, 1e-4f);
  m_cGame.SetContactFilter(&filter);
  EXPECT_EQ(fall(), -4);
  m_pGuest.reset(); // before the filter
}

TEST_P(CGuest, QueriesFindTheShapesAndNothingElse) {
  struct CCount : b2QueryCallback {
    int m_n = 0;
    bool ReportFixture(b2Fixture*) override { return ++m_n > 0; }
  };
  const auto count = [&] {
    CCount found;
    m_cGame.QueryAABB(&found, {{-1e6f, -1e6f}, {1e6f, 1e6f}});
    return found.m_n;
  };
  CWorld& world = Join();
  EXPECT_EQ(count(), 0);
  world.Add(CLineSegDesc({-1, 0}, {1, 0}));
  EXPECT_EQ(count(), 1);
}

TEST_P(CGuest, WhatTheGameDoesToTheBodyOfABallCounts) {
  CWorld& world = Join();
  const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0}, 0.1f));
  b2Body* pBody = BodyOf(ball);
  pBody->ApplyLinearImpulseToCenter({3, 0}, true);
  Steps(60);
  EXPECT_NEAR(world.GetPos(ball).x(), 3, 1e-4f);
  pBody->SetTransform({0, 7}, 0);
  Steps(60);
  EXPECT_LE((world.GetPos(ball) - Vector2(3, 7)).norm(), 1e-4f);
}

TEST_P(CGuest, ABallDoesNotSleepAndWakesWhatDoes) {
  m_cGame.SetGravity({0, -10});
  AddGround(m_cGame);
  b2Body* pBox = AddBox(m_cGame, {3, 0.51f});
  CWorld& world = Join();
  world.Add(CLineSegDesc({-5, 0.4f}, {0, 0.4f}, 0));
  const CShapeId ball = world.Add(CDynamicCircleDesc({-1, 0.51f}, 0.1f));
  Steps(120);
  ASSERT_FALSE(pBox->IsAwake()); // the game's bodies sleep as before
  m_cGame.SetGravity({0, 0});
  world.SetVel(ball, {5, 0});
  Steps(60);
  EXPECT_GT(pBox->GetLinearVelocity().x, 1);
}

TEST_P(CGuest, SensorsSeeBallsThatFlyThrough) {
  CWorld& world = Join();
  const CShapeId gate = world.Add(Sensor(CLineSegDesc({0, -1}, {0, 1})));
  world.Add(CLineSegDesc({1, -1}, {1, 1}));
  const CShapeId ball = world.Add(CDynamicCircleDesc({-1, 0}, 0.1f, {30, 0})); // 2.5 diameters a step
  const std::vector<CSensorEvent> toAndFro{
      {gate, ball, true}, {gate, ball, false}, {gate, ball, true}, {gate, ball, false}};
  EXPECT_EQ(Told(10, &CWorld::GetSensorEvents), toAndFro);
  EXPECT_GE(world.GetStats().m_nSensorHits, 2u);
  EXPECT_LT(world.GetPos(ball).x(), -1);
}

TEST_P(CGuest, ASensorLosesABallThatTheGameDestroys) {
  CWorld& world = Join();
  world.Add(CDynamicCircleDesc({5, 5}, 0.1f)); // its place is taken by the next
  const CShapeId lost = world.Add(CDynamicCircleDesc({0, 0}, 0.1f));
  const CShapeId stays = world.Add(CDynamicCircleDesc({0.5f, 0}, 0.1f));
  const CShapeId zone = world.Add(MakeZone());
  Steps(1);
  EXPECT_EQ(world.GetSensorEvents().size(), 2u);
  StepAndDestroy(lost);
  const auto events = world.GetSensorEvents();
  EXPECT_EQ(std::vector(events.begin(), events.end()), (std::vector<CSensorEvent>{{zone, lost, false}}));
  ASSERT_EQ(world.GetContacts().size(), 1u);
  EXPECT_EQ(world.GetContacts()[0].m_cBall, stays);
}

TEST_P(CGuest, WhatBox2DSlowsDownIsCountedByTheLengthOfTheStep) {
  CWorld& world = Join();
  const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0}, 0.1f, {100, 0}));
  const CShapeId flipper = world.Add(Turning(CLineSegDesc({0, 50}, {1, 50}), 12, {0, 50}));
  Steps(10);
  EXPECT_EQ(world.GetStats().m_nMovesClamped, 0u);
  EXPECT_EQ(world.GetStats().m_nTurnsClamped, 0u);
  Steps(1, 1.0f / 40); // 2.5 metres, .6 pi radians
  EXPECT_EQ(world.GetStats().m_nMovesClamped, 1u);
  EXPECT_EQ(world.GetStats().m_nTurnsClamped, 1u);
  EXPECT_NEAR(world.GetVel(ball).x(), 80, 1e-3f);
  for (const std::uint64_t n :
       {world.GetStats().m_nEngineSteps, world.GetStats().m_nSteps, world.GetStats().m_nSubsteps})
    EXPECT_EQ(n, 11u);
  EXPECT_GT(world.GetOrientation(flipper), 0);
}

// It meets both in one step. What waits for its impact with the arc must not hold it when the ground answers.
TEST_P(CGuest, ABallKeepsItsWayFromAnArcOntoTheGroundOfTheGame) {
  m_cGame.SetGravity({0, -10});
  AddGround(m_cGame);
  Join().Add(CArcDesc({2, 2}, 2, g_fPi, 1.5f * g_fPi));
  const float speed = Throw(CDynamicCircleDesc({0.2f, 2.5f}, 0.15f, {0, -4}, 1, 0.3f), 45).x();
  // Energy makes it 7.9 at the ground; each bounce along the arc takes a little.
  EXPECT_GT(speed, IsTuned() ? 7.0f : 6.0f);
  EXPECT_LT(speed, 7.9f);
}

} // namespace
} // namespace Shapes::Tests
