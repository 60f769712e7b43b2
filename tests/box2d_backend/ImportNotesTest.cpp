// SPDX-License-Identifier: MIT
// An import names all that a game's b2World has and a scene has not.
#include "ImportTesting.h"

namespace Shapes {
namespace {

using CNotes = std::vector<std::string>;

CNotes NotesOf(const CGame& game) { return ImportScene(game.m_cWorld).m_stdNotes; }

void SetFilter(b2Body* pBody, uint16 category, uint16 mask, int16 group = 0) {
  b2Filter filter;
  filter.categoryBits = category;
  filter.maskBits = mask;
  filter.groupIndex = group;
  pBody->GetFixtureList()->SetFilterData(filter);
}

TEST(ImportNotesTest, AGameOfWhichAllHasACounterpartHasNone) {
  CGame game({0, -10});
  game.AddBall({0, 1})->SetBullet(true);
  game.AddStatic(CGame::Edge({-1, 0}, {1, 0}));
  game.AddBody(b2_staticBody); // a body without fixtures meets nobody
  EXPECT_EQ(NotesOf(game), CNotes());
}

TEST(ImportNotesTest, DynamicBodiesThatAreNoBallsAndDisabledOnesAreLeftOut) {
  CGame game;
  const auto add = [&](auto... shapes) {
    b2Body* pBody = game.AddBody(b2_dynamicBody);
    (CGame::AddFixture(pBody, shapes), ...);
    return pBody;
  };
  add(CGame::Box(1, 1));
  add(CGame::Circle({0, 0}, 1), CGame::Circle({1, 0}, 1));
  b2MassData mass{1.0f, {0.5f, 0.0f}, 1.0f};
  add(CGame::Circle({0, 0}, 1))->SetMassData(&mass);
  add(CGame::Circle({0, 0}, 0));
  add();
  add(CGame::Circle({0, 0}, 1))->SetEnabled(false);
  game.AddStatic(CGame::Edge({-1, 0}, {1, 0}))->SetEnabled(false);
  const CSceneDesc scene = ImportScene(game.m_cWorld);
  EXPECT_EQ(scene.m_stdNotes,
            (CNotes{"Body 0 (dynamic) is left out: its solid fixture is no circle.",
                    "Body 1 (dynamic) is left out: it has 2 solid fixtures, a ball has one.",
                    "Body 2 (dynamic) is left out: its circle is not about its centre of mass.",
                    "Body 3 (dynamic) is left out: it has no mass.",
                    "Body 4 (dynamic) is left out: it has 0 solid fixtures, a ball has one.",
                    "Body 5 is left out: it is disabled.", "Body 6 is left out: it is disabled."}));
  EXPECT_TRUE(scene.m_stdBalls.empty() && scene.m_stdShapes.empty());
}

TEST(ImportNotesTest, WhatPartsLose) {
  CGame game;
  b2Body* pBody = game.AddBody(b2_kinematicBody);
  CGame::AddFixture(pBody, CGame::Circle({0, 0}, 1))->SetSensor(true);
  CGame::AddFixture(pBody, CGame::Box(1, 1))->SetSensor(true);
  b2PolygonShape rounded = CGame::Box(1, 1);
  rounded.m_radius = 0.5f;
  CGame::AddFixture(pBody, rounded);
  pBody->SetLinearVelocity({1, -2});
  b2Body* pBall = game.AddBall({5, 5});
  CGame::AddFixture(pBall, CGame::Circle({0, 0}, 2))->SetSensor(true);
  const CSceneDesc scene = ImportScene(game.m_cWorld);
  EXPECT_EQ(scene.m_stdNotes,
            (CNotes{"Body 1 becomes a ball without its sensors.",
                    "Body 0 fixture 1 is a sensor: balls are felt on its geometry, not inside.",
                    "Body 0 fixture 2 loses its skin of 0.5 m."}));
  EXPECT_EQ(scene.m_stdBalls.size(), 1u);
  for (const CAnyShapeDesc& any : scene.m_stdShapes)
    std::visit([](const auto& desc) { EXPECT_EQ(desc.m_vVel, Vector2(1, -2)); }, any);
}

TEST(ImportNotesTest, SleepAndContinuousPhysics) {
  CGame game({0, -10});
  game.AddBall({0, 0});
  for (const float x : {1.0f, 2.0f})
    game.AddBall({x, 0})->SetAwake(false);
  game.m_cWorld.SetContinuousPhysics(false);
  EXPECT_EQ(
      ImportScene(game.m_cWorld).m_stdNotes,
      (CNotes{"Here nothing sleeps at first: bodies 1, 2 in the b2World, also where nothing holds them.",
              "The b2World has no continuous physics: here balls are swept and pass no wall."}));
}

// Hundreds of restitutions that no elasticities have are one sentence, and take no gigabyte.
TEST(ImportNotesTest, ManyRestitutionsAreSummedUp) {
  CGame game;
  for (int i = 0; i < 300; ++i)
    game.AddBall({static_cast<float>(i), 0}, b2Vec2_zero, 0.3f + 0.002f * static_cast<float>(i));
  const CNotes notes = ImportScene(game.m_cWorld).m_stdNotes;
  EXPECT_LT(notes.size(), 25u);
  EXPECT_NE(notes.back().find(" other pairs, too, which differ by up to "), std::string::npos)
      << notes.back();
}

TEST(ImportNotesTest, DampingAndGravityScale) {
  CGame game({0, -10});
  game.AddBall({0, 0});
  game.AddBall({1, 0})->SetLinearDamping(0.5f);
  game.AddBall({2, 0})->SetLinearDamping(0.5f);
  game.AddBall({3, 0})->SetAngularDamping(0.25f);
  EXPECT_EQ(NotesOf(game),
            (CNotes{"Linear damping has no counterpart: bodies 1, 2 with 0.5.",
                    "Angular damping has no counterpart, balls do not spin: body 3 with 0.25."}));

  CGame scaled({0, -10});
  b2Body* pBall = scaled.AddBall({0, 0});
  pBall->SetGravityScale(2.0f);
  CSceneDesc scene = ImportScene(scaled.m_cWorld);
  EXPECT_EQ(scene.m_stdNotes,
            CNotes{"The gravity is that of the b2World times 2, the gravity scale of every ball."});
  EXPECT_EQ(scene.m_cWorld.m_vGravity, Vector2(0, -20));
  scaled.AddBall({1, 0});
  scene = ImportScene(scaled.m_cWorld);
  EXPECT_EQ(scene.m_stdNotes,
            CNotes{"A gravity scale that balls do not share has no counterpart: body 0 with 2."});
  EXPECT_EQ(scene.m_cWorld.m_vGravity, Vector2(0, -10));
  scaled.m_cWorld.SetGravity(b2Vec2_zero);
  EXPECT_EQ(NotesOf(scaled), CNotes()); // it has no effect
}

TEST(ImportNotesTest, EveryJoint) {
  CGame game;
  b2Body* pGround = game.AddStatic(CGame::Edge({-1, -5}, {1, -5}));
  b2Body* pBall = game.AddBall({0, 0});
  b2Body* pOther = game.AddBall({1, 0});
  b2RevoluteJointDef revolute;
  revolute.Initialize(pOther, pBall, {0, 0});
  game.m_cWorld.CreateJoint(&revolute);
  b2DistanceJointDef distance;
  distance.Initialize(pGround, pBall, {0, -5}, {0, 0});
  distance.collideConnected = true;
  game.m_cWorld.CreateJoint(&distance);
  EXPECT_EQ(NotesOf(game),
            (CNotes{"Joint 0 (revolute, bodies 1, 2) is left out. It keeps its bodies from meeting "
                    "in Box2D; here they meet.",
                    "Joint 1 (distance, bodies 0, 1) is left out."}));
}

TEST(ImportNotesTest, FiltersBetweenBallsAndShapes) {
  CGame game;
  b2Body* pFloor = game.AddStatic(CGame::Edge({-1, 0}, {1, 0}));
  game.AddBall({0, 1});
  b2Body* pGhost = game.AddBall({1, 1});
  EXPECT_EQ(NotesOf(game), CNotes());
  SetFilter(pFloor, 4, 0xFFFF);
  SetFilter(pGhost, 1, 3); // the floor is not in its mask
  const CSceneDesc scene = ImportScene(game.m_cWorld);
  EXPECT_EQ(scene.m_stdNotes, CNotes());
  EXPECT_EQ(std::get<CLineSegDesc>(scene.m_stdShapes.at(0)).m_cFilter, (Shapes::CFilter{4, 0xFFFF}));
  EXPECT_EQ(scene.m_stdBalls.at(0).m_cFilter, Shapes::CFilter());
  EXPECT_EQ(scene.m_stdBalls.at(1).m_cFilter, (Shapes::CFilter{1, 3}));
  SetFilter(pGhost, 1, 3, 7);
  SetFilter(pFloor, 4, 0xFFFF, 7); // a group above 0 wins
  EXPECT_EQ(NotesOf(game), CNotes{"The groups let body 2 meet body 0 in Box2D; here categories and masks "
                                  "keep them apart."});
  SetFilter(pGhost, 1, 0xFFFF, -7);
  SetFilter(pFloor, 4, 0xFFFF, -7);
  EXPECT_EQ(NotesOf(game), CNotes{"The groups keep body 2 from body 0 in Box2D; here they meet."});
}

TEST(ImportNotesTest, FiltersAmongBalls) {
  CGame game;
  for (int i = 0; i < 4; ++i)
    SetFilter(game.AddBall({static_cast<float>(i), 0}), 1, 0xFFFF, -1);
  EXPECT_EQ(NotesOf(game),
            CNotes{"The groups keep bodies 0 to 3 from bodies 0 to 3 in Box2D; here they meet."});
  CGame one;
  SetFilter(one.AddBall({0, 0}), 1, 0xFFFF, -1);
  EXPECT_EQ(NotesOf(one), CNotes()); // it meets nobody anyway
}

TEST(ImportNotesTest, WhatNoBallMeetsIsLeftOut) {
  CGame game;
  b2Body* pBackground = game.AddStatic(CGame::Edge({-1, 0}, {1, 0}));
  SetFilter(pBackground, 2, 2);
  EXPECT_EQ(ImportScene(game.m_cWorld).m_stdShapes.size(), 3u); // without balls nobody can say so
  game.AddBall({0, 1});
  const CSceneDesc scene = ImportScene(game.m_cWorld);
  EXPECT_TRUE(scene.m_stdShapes.empty());
  EXPECT_EQ(scene.m_stdNotes, CNotes{"Left out, because the filters keep every ball from it: body 0."});
}

TEST(ImportNotesTest, FrictionAndThresholdWhereTheyMatter) {
  CGame game;
  b2Body* pFloor = game.AddStatic(CGame::Edge({-1, 0}, {1, 0}), 0.5f);
  b2Body* pBall = game.AddBall({0, 1}, b2Vec2_zero, 0.5f);
  pFloor->GetFixtureList()->SetFriction(0.25f);
  pFloor->GetFixtureList()->SetRestitutionThreshold(1.0f);
  EXPECT_EQ(NotesOf(game), CNotes()); // Box2D takes the mean of a product, and the smaller threshold
  pBall->GetFixtureList()->SetFriction(1.0f);
  EXPECT_EQ(NotesOf(game),
            CNotes{"Friction has no counterpart, balls slide and do not spin: bodies 0, 1 with up to 0.5."});
  pBall->GetFixtureList()->SetFriction(0.0f);
  pBall->GetFixtureList()->SetRestitutionThreshold(2.0f);
  EXPECT_EQ(NotesOf(game),
            CNotes{"Slow balls bounce too, Box2D stops them dead at up to 1 m/s: bodies 0, 1."});
  pBall->GetFixtureList()->SetRestitution(0.0f);
  pFloor->GetFixtureList()->SetRestitution(0.0f);
  EXPECT_EQ(NotesOf(game), CNotes()); // nothing bounces anyway
}

// Every pair of a ball and something else has Box2D's restitution, or is in a note.
TEST(ImportNotesTest, EveryPairBouncesAsInBox2DOrIsTold) {
  int clean = 0, told = 0;
  Tests::ForEachCase(7, 500, [&](Tests::CRandom& random, int) {
    CGame game;
    const auto draw = [&] { return 0.3f * static_cast<float>(random.Below(4)); };
    std::vector<float> r, e;
    const std::uint32_t nBalls = 1 + random.Below(3), nShapes = 1 + random.Below(4);
    for (std::uint32_t i = 0; i < nBalls; ++i)
      game.AddBall({static_cast<float>(i), 5}, b2Vec2_zero, r.emplace_back(draw()));
    for (std::uint32_t i = 0; i < nShapes; ++i)
      game.AddStatic(CGame::Circle({static_cast<float>(i), 0}, 0.1f), r.emplace_back(draw()));
    const CSceneDesc scene = ImportScene(game.m_cWorld);
    for (const CDynamicCircleDesc& ball : scene.m_stdBalls)
      e.push_back(ball.m_fElasticity);
    for (const CCircleDesc& circle : GetAll<CCircleDesc>(scene))
      e.push_back(circle.m_fElasticity);
    ASSERT_EQ(e.size(), r.size());

    // Bodies of one restitution are told together.
    std::set<std::tuple<float, bool, float>> wrong;
    for (std::size_t i = 0; i < nBalls; ++i)
      for (std::size_t j = i + 1; j < e.size(); ++j) {
        const float target = b2MixRestitution(r[i], r[j]);
        const float ulp = std::nextafter(target, 2.0f) - target;
        if (std::abs(e[i] * e[j] - target) <= (target == 0.0f ? 0.0f : 4.0f * ulp)) continue;
        const bool areBalls = j < nBalls, swap = areBalls && r[j] < r[i];
        wrong.emplace(swap ? r[j] : r[i], areBalls, swap ? r[i] : r[j]);
      }
    ASSERT_EQ(scene.m_stdNotes.size(), wrong.size());
    for (const std::string& note : scene.m_stdNotes)
      ASSERT_EQ(note.find("Restitution of "), 0u) << note;
    ++(wrong.empty() ? clean : told);
  });
  EXPECT_GT(clean, 100);
  EXPECT_GT(told, 100);
}

TEST(ImportNotesTest, FixturesOfOneBodyAreTold) {
  CGame game;
  b2Body* pBody = game.AddBody(b2_staticBody);
  for (const float friction : {0.0f, 1.0f, 1.0f, 1.0f, 0.0f, 1.0f})
    CGame::AddFixture(pBody, CGame::Circle({0, 0}, 1))->SetFriction(friction);
  game.AddBall({0, 5})->GetFixtureList()->SetFriction(1.0f);
  EXPECT_EQ(NotesOf(game), CNotes{"Friction has no counterpart, balls slide and do not spin: body 1, body 0 "
                                  "fixtures 1 to 3, 5 with up to 1."});
}

TEST(ImportNotesTest, CodeOfTheGame) {
  struct CFilter : b2ContactFilter {
  } filter;
  struct CListener : b2ContactListener {
  } listener;
  CGame game;
  game.m_cWorld.SetContactFilter(&filter);
  game.m_cWorld.SetContactListener(&listener);
  EXPECT_EQ(NotesOf(game).size(), 2u);
  game.m_cWorld.SetContactFilter(nullptr);
  game.m_cWorld.SetContactListener(nullptr);
  EXPECT_EQ(NotesOf(game), CNotes());
}

} // namespace
} // namespace Shapes
