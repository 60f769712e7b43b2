// SPDX-License-Identifier: MIT
// A game's b2World as a scene: the same shapes in the same places, and the same bounces.
#include "ImportTesting.h"

namespace Shapes {
namespace {

constexpr float g_fSpeed = 5.0f;
constexpr float g_fRadius = 0.1f;
// Time to come to the shape and be off again, but not to the far side of a hollow one.
constexpr int g_nSteps = 45;

b2ChainShape Chain(const std::vector<b2Vec2>& vertices, const b2Vec2& prev, const b2Vec2& next) {
  b2ChainShape chain;
  chain.CreateChain(vertices.data(), static_cast<int32>(vertices.size()), prev, next);
  return chain;
}

b2ChainShape Loop(const std::vector<b2Vec2>& vertices) {
  b2ChainShape chain;
  chain.CreateLoop(vertices.data(), static_cast<int32>(vertices.size()));
  return chain;
}

b2EdgeShape OneSided(const b2Vec2& p, const b2Vec2& q) {
  b2EdgeShape edge;
  edge.SetOneSided(q, p, q, p); // neighbours that fold back
  return edge;
}

const std::vector<b2Vec2> g_stdSquare{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}; // counterclockwise
const std::vector<b2Vec2> g_stdSquareInside{{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};

// A ball that is thrown at a body: at a face straight, or at a corner along its bisector, so that the engines
// may differ by rounding only.
struct CImportThrow {
  const char* m_sName;
  std::function<void(b2Body*)> m_fnMake; // the fixtures of a body at (3, 2), turned by 0.7
  Vector2 m_vFrom, m_vTo;                // in the frame of the body
  bool m_bBounces = true;
};

void PrintTo(const CImportThrow& t, std::ostream* pOut) { *pOut << t.m_sName; }

const std::vector<CImportThrow>& Throws() {
  const auto make = [](const auto& shape) {
    return [shape](b2Body* p) { CGame::AddFixture(p, shape, 0.8f); };
  };
  const auto chain = [](const std::vector<b2Vec2>& vertices) {
    return [vertices](b2Body* p) {
      CGame::AddFixture(p, Chain(vertices, vertices[1], vertices[vertices.size() - 2]), 0.8f);
    };
  };
  const auto loop = [](const std::vector<b2Vec2>& vertices) {
    return [vertices](b2Body* p) { CGame::AddFixture(p, Loop(vertices), 0.8f); };
  };
  static const std::vector<CImportThrow> throws{
      {"circle", make(CGame::Circle({0.5f, 0.25f}, 0.75f)), {-2, 0.25f}, {0.5f, 0.25f}},
      {"edge_from_above", make(CGame::Edge({-1, 0}, {1, 0})), {0.3f, 2}, {0.3f, 0}},
      {"edge_from_below", make(CGame::Edge({-1, 0}, {1, 0})), {0.3f, -2}, {0.3f, 0}},
      {"edge_at_its_end", make(CGame::Edge({-1, 0}, {1, 0})), {-3, 0}, {-1, 0}},
      {"one_sided_edge_from_its_right", make(OneSided({-1, 0}, {1, 0})), {0.3f, -2}, {0.3f, 0}},
      {"one_sided_edge_from_its_left", make(OneSided({-1, 0}, {1, 0})), {0.3f, 2}, {0.3f, 0}, false},
      {"one_sided_edge_back_from_its_right", make(OneSided({1, 0}, {-1, 0})), {0.3f, 2}, {0.3f, 0}},
      {"one_sided_edge_back_from_its_left", make(OneSided({1, 0}, {-1, 0})), {0.3f, -2}, {0.3f, 0}, false},
      {"upright_one_sided_edge_from_its_right", make(OneSided({0, -1}, {0, 1})), {2, 0.3f}, {0, 0.3f}},
      {"one_sided_edge_at_its_end", make(OneSided({-1, 0}, {1, 0})), {-2, -1}, {-1, 0}},
      {"chain_from_its_right", chain({{-1, 0}, {0, 0}, {1, 0.5f}}), {-0.5f, -2}, {-0.5f, 0}},
      {"chain_from_its_left", chain({{-1, 0}, {0, 0}, {1, 0.5f}}), {-0.5f, 2}, {-0.5f, 0}, false},
      {"chain_at_a_corner", chain({{-1, 0}, {0, 0}, {0, 1}}), {2, -2}, {0, 0}},
      {"chain_at_its_end", chain({{-1, 0}, {0, 0}, {0, 1}}), {-2, -1}, {-1, 0}},
      {"loop_from_outside", loop(g_stdSquare), {0.3f, 3}, {0.3f, 1}},
      {"loop_at_a_corner", loop(g_stdSquare), {3, 3}, {1, 1}},
      {"loop_at_its_first_corner", loop(g_stdSquare), {-3, -3}, {-1, -1}},
      {"loop_from_inside", loop(g_stdSquareInside), {0.3f, -0.8f}, {0.3f, 1}},
      {"box_from_above", make(CGame::Box(1, 1)), {0.3f, 3}, {0.3f, 1}},
      {"box_from_the_left", make(CGame::Box(1, 1)), {-3, 0.3f}, {-1, 0.3f}},
      {"box_at_a_corner", make(CGame::Box(1, 1)), {3, -3}, {1, -1}}};
  return throws;
}

class ThrowTest : public testing::TestWithParam<CImportThrow> {
protected:
  ThrowTest() {
    b2Body* pBody = m_cGame.AddBody(b2_staticBody, {3, 2}, 0.7f);
    GetParam().m_fnMake(pBody);
    const auto place = [&](const Vector2& p) { return pBody->GetWorldPoint({p.x(), p.y()}); };
    const b2Vec2 from = place(GetParam().m_vFrom);
    b2Vec2 v = place(GetParam().m_vTo) - from;
    v.Normalize();
    m_pBall = m_cGame.AddBall(from, g_fSpeed * v, 0.5f, g_fRadius);
    m_cScene = ImportScene(m_cGame.m_cWorld);
  }

  // The velocity afterwards.
  Vector2 PlayGame() {
    for (int i = 0; i < g_nSteps; ++i)
      m_cGame.m_cWorld.Step(g_fDt, 8, 3);
    return {m_pBall->GetLinearVelocity().x, m_pBall->GetLinearVelocity().y};
  }
  static Vector2 Play(const CSceneDesc& scene, eBackend backend) {
    const auto pWorld = GetBackend(backend)->MakeWorld(scene.m_cWorld);
    const CShapeId ball = scene.AddTo(*pWorld).back();
    Steps(*pWorld, g_nSteps);
    return pWorld->GetVel(ball);
  }

  CGame m_cGame;
  b2Body* m_pBall;
  CSceneDesc m_cScene;
};

// A straight bounce has no error but rounding. Each step rounds a position of less than 8 by at most half an
// ulp of it; at a corner the normal turns by the sum over the radius, and twice that turns the velocity.
constexpr float g_fTolerance = g_nSteps * 2.4e-7f / g_fRadius * 2.0f * g_fSpeed;

TEST_P(ThrowTest, BouncesAsInTheGame) {
  const Vector2 start = m_cScene.m_stdBalls.at(0).m_vVel, after = PlayGame();
  // That the game itself does what the case says.
  EXPECT_LT((after - (GetParam().m_bBounces ? Vector2(-0.8f * start) : start)).norm(), g_fTolerance);
  for (const eBackend backend : {eBackend::Native, eBackend::Box2D})
    EXPECT_LT((Play(m_cScene, backend) - after).norm(), g_fTolerance) << GetBackend(backend)->GetName();
  EXPECT_TRUE(m_cScene.m_stdNotes.empty()) << m_cScene.m_stdNotes[0];
}

// The control: with the other side solid, or without guards, the native ball goes another way.
TEST_P(ThrowTest, SidesAndGuardsAreWhatMakesIt) {
  const std::string_view name = GetParam().m_sName;
  const bool isCorner = name.find("_at_") != name.npos;
  std::size_t sides = 0;
  for (CAnyShapeDesc& any : m_cScene.m_stdShapes)
    if (auto* p = std::get_if<CLineSegDesc>(&any); p != nullptr && p->m_eSides != eSides::Both)
      ++sides, p->m_eSides = p->m_eSides == eSides::Front ? eSides::Back : eSides::Front;
  const auto removed = std::erase_if(m_cScene.m_stdShapes, [&](const CAnyShapeDesc& any) {
    return isCorner && std::holds_alternative<CPointDesc>(any);
  });
  if (sides + removed == 0) {
    EXPECT_TRUE(name.starts_with("circle") || name.starts_with("edge_from")); // no sides, nothing to guard
    return;
  }
  m_cScene.m_cWorld.m_cEffects = g_cApproximate; // Continuous has round ends without any guard
  EXPECT_GT((Play(m_cScene, eBackend::Native) - PlayGame()).norm(), 0.1f * g_fSpeed);
}

INSTANTIATE_TEST_SUITE_P(, ThrowTest, testing::ValuesIn(Throws()),
                         [](const auto& sample) { return std::string(sample.param.m_sName); });

TEST(ImportSceneTest, WorldIsThatOfTheGameInUserUnits) {
  CGame game({1, -10});
  game.AddBall({2, 3}, {4, -5}, 0.25f, 0.5f);
  game.AddStatic(CGame::Edge({-1, 0}, {1, 0}));
  const CSceneDesc scene = ImportScene(game.m_cWorld, {.m_fLengthUnit = 100.0f, .m_fTimeStep = 0.01f});
  EXPECT_EQ(scene.m_cWorld.m_vGravity, Vector2(100, -1000));
  EXPECT_EQ(scene.m_cWorld.m_fTimeStep, 0.01f);
  EXPECT_EQ(scene.m_cWorld.m_cBox2D.m_fLengthUnit, 100.0f);
  ASSERT_EQ(scene.m_stdBalls.size(), 1u);
  const CDynamicCircleDesc& ball = scene.m_stdBalls[0];
  EXPECT_EQ(ball.m_vPos, Vector2(200, 300));
  EXPECT_EQ(ball.m_vVel, Vector2(400, -500));
  EXPECT_EQ(ball.m_fRadius, 50.0f);
  EXPECT_FLOAT_EQ(ball.m_fMass, 0.25f * g_fPi);
  EXPECT_EQ(GetAll<CLineSegDesc>(scene).at(0).GetEndPt1(), Vector2(100, 0));
}

TEST(ImportSceneTest, OrderIsThatInWhichTheGameMadeThem) {
  CGame game;
  for (int i = 0; i < 5; ++i) {
    game.AddBall({static_cast<float>(i), 0});
    b2Body* pBody = game.AddBody(b2_staticBody);
    for (int j = 0; j < 3; ++j)
      CGame::AddFixture(pBody, CGame::Circle({static_cast<float>(i), static_cast<float>(j + 1)}, 0.1f));
  }
  const CSceneDesc scene = ImportScene(game.m_cWorld);
  const auto circles = GetAll<CCircleDesc>(scene);
  ASSERT_EQ(scene.m_stdBalls.size(), 5u);
  ASSERT_EQ(circles.size(), 15u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(scene.m_stdBalls[i].m_vPos.x(), static_cast<float>(i));
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_EQ(circles[3 * i + j].m_vPos, Vector2(static_cast<float>(i), static_cast<float>(j + 1)));
  }
}

TEST(ImportSceneTest, JoinedSegmentsShareTheirEndsBitForBit) {
  CGame game;
  b2Body* pBody = game.AddBody(b2_staticBody, {1.7f, -0.3f}, 0.77f);
  CGame::AddFixture(pBody, Loop({{0, 0}, {1.1f, 0.1f}, {0.9f, 1.3f}, {-0.2f, 0.8f}}));
  CGame::AddFixture(pBody, CGame::Edge({3, 0}, {4.1f, 0.3f}));
  CGame::AddFixture(pBody, CGame::Edge({5.3f, 0.1f}, {4.1f, 0.3f}));
  const auto segs = GetAll<CLineSegDesc>(ImportScene(game.m_cWorld, {.m_fLengthUnit = 37.0f}));
  ASSERT_EQ(segs.size(), 6u);
  const auto share = [](const CLineSegDesc& a, const CLineSegDesc& b) {
    const auto isOfB = [&](const Vector2& p) { return p == b.GetEndPt0() || p == b.GetEndPt1(); };
    return isOfB(a.GetEndPt0()) || isOfB(a.GetEndPt1());
  };
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_TRUE(share(segs[i], segs[(i + 1) % 4])) << i;
  EXPECT_TRUE(share(segs[4], segs[5]));
  EXPECT_FALSE(share(segs[0], segs[2]));
}

std::vector<Vector2> GuardsOf(const CGame& game) {
  std::vector<Vector2> points;
  for (const CPointDesc& point : GetAll<CPointDesc>(ImportScene(game.m_cWorld)))
    points.push_back(point.m_vPos);
  return points;
}

TEST(ImportSceneTest, GuardsStandAtCornersAndEndsThatABallCanMeet) {
  CGame game;
  game.AddBall({10, 10});
  const auto guards = [&](const b2Shape& shape) {
    b2Body* pBody = game.AddStatic(shape);
    const std::vector<Vector2> points = GuardsOf(game);
    game.m_cWorld.DestroyBody(pBody);
    return points;
  };
  using CPoints = std::vector<Vector2>;
  EXPECT_EQ(guards(CGame::Circle({0, 0}, 1)), CPoints());
  EXPECT_EQ(guards(CGame::Edge({-1, 0}, {1, 0})), (CPoints{{-1, 0}, {1, 0}}));
  EXPECT_EQ(guards(CGame::Box(1, 2)).size(), 4u);
  EXPECT_EQ(guards(Loop(g_stdSquare)).size(), 4u);
  EXPECT_EQ(guards(Loop(g_stdSquareInside)), CPoints()); // corners that nothing reaches
  // The ends go on to neighbours that the game has told Box2D of; the corner in the middle sticks out.
  EXPECT_EQ(guards(Chain({{-1, 0}, {0, 0}, {0, 1}}, {-2, 0}, {0, 2})), (CPoints{{0, 0}}));
  EXPECT_EQ(guards(Chain({{-1, 0}, {0, 0}, {0, -1}}, {-2, 0}, {0, -2})), CPoints());
  // Turns of less and of more than 20 degrees.
  const auto bent = [&](float degrees) {
    const float a = degrees * g_fPi / 180.0f;
    const b2Vec2 t(std::cos(a), std::sin(a));
    return guards(Chain({{-1, 0}, {0, 0}, t}, {-2, 0}, 2.0f * t)).size();
  };
  EXPECT_EQ(bent(19.0f), 0u);
  EXPECT_EQ(bent(21.0f), 1u);
}

TEST(ImportSceneTest, EdgesThatGoOnAreNotGuardedWhereTheyMeet) {
  CGame game;
  b2Body* pBody = game.AddBody(b2_staticBody);
  CGame::AddFixture(pBody, CGame::Edge({-1, 0}, {0, 0}));
  CGame::AddFixture(pBody, CGame::Edge({1, 0}, {0, 0}));
  CGame::AddFixture(pBody, CGame::Edge({1, 0}, {1, 1}));
  EXPECT_EQ(GuardsOf(game), (std::vector<Vector2>{{-1, 0}, {1, 0}, {1, 1}}));
}

TEST(ImportSceneTest, EdgesThatTurnApartAreGuardedWhereTheyMeetNow) {
  const auto count = [](b2BodyType type) {
    CGame game;
    game.AddStatic(CGame::Edge({-1, 0}, {0, 0}));
    CGame::AddFixture(game.AddBody(type, {1, 0}), CGame::Edge({-1, 0}, {0, 0}));
    return GetAll<CPointDesc>(ImportScene(game.m_cWorld)).size();
  };
  EXPECT_EQ(count(b2_staticBody), 2u);
  EXPECT_EQ(count(b2_kinematicBody), 4u); // two at the place where they meet, one of which turns
}

TEST(ImportSceneTest, KinematicBodiesTurnAboutTheirPositions) {
  CGame game;
  b2Body* pBody = game.AddBody(b2_kinematicBody, {2, 1}, 0.4f);
  CGame::AddFixture(pBody, CGame::Edge({-0.5f, 0}, {1.5f, 0}));
  CGame::AddFixture(pBody, CGame::Circle({1.5f, 0}, 0.2f));
  pBody->SetAngularVelocity(-3.0f);
  const CSceneDesc scene = ImportScene(game.m_cWorld);
  for (int i = 0; i < 60; ++i)
    game.m_cWorld.Step(g_fDt, 8, 3);
  const b2Vec2 moved = pBody->GetWorldPoint({1.5f, 0});
  const Vector2 tip(moved.x, moved.y);
  for (const eBackend backend : {eBackend::Native, eBackend::Box2D}) {
    const auto pWorld = GetBackend(backend)->MakeWorld(scene.m_cWorld);
    const std::vector<CShapeId> ids = scene.AddTo(*pWorld);
    ASSERT_EQ(ids.size(), 4u); // and a guard at each end
    Steps(*pWorld, 60);
    // 60 roundings of an angle of up to 4, at a distance of 1.5.
    const float bound = 60 * 4 * 1.2e-7f * 1.5f;
    EXPECT_LT((pWorld->GetPos(ids[1]) - tip).norm(), bound);
    const auto& seg = static_cast<const CLineSeg&>(pWorld->GetShape(ids[0]));
    EXPECT_LT((seg.GetEndPt0() - tip).norm(), bound);
  }
  EXPECT_TRUE(scene.m_stdNotes.empty());
}

TEST(ImportSceneTest, ABallMayBeOffItsBodysPosition) {
  CGame game;
  b2Body* pBody = game.AddBody(b2_dynamicBody, {1, 1}, g_fPi / 2);
  CGame::AddFixture(pBody, CGame::Circle({0.3f, 0}, 0.1f));
  const CSceneDesc scene = ImportScene(game.m_cWorld);
  ASSERT_EQ(scene.m_stdBalls.size(), 1u);
  EXPECT_LT((scene.m_stdBalls[0].m_vPos - Vector2(1, 1.3f)).norm(), 4e-7f);
}

TEST(ImportSceneTest, SensorsFeelFromBothSidesAndHaveNoGuards) {
  CGame game;
  game.AddStatic(CGame::Edge({0, 0}, {1, 0}))->GetFixtureList()->SetSensor(true);
  game.AddStatic(OneSided({0, 1}, {1, 1}))->GetFixtureList()->SetSensor(true);
  const CSceneDesc scene = ImportScene(game.m_cWorld);
  ASSERT_EQ(scene.m_stdShapes.size(), 2u);
  for (const CLineSegDesc& seg : GetAll<CLineSegDesc>(scene)) {
    EXPECT_TRUE(seg.m_bIsSensor);
    EXPECT_EQ(seg.m_eSides, eSides::Both);
  }
}

TEST(ImportSceneTest, WhatNoShapeCanHaveIsRefusedWithItsBody) {
  const auto refusal = [](const CGame& game, const CImportOptions& options = {}) {
    return MessageOf<std::invalid_argument>([&] { ImportScene(game.m_cWorld, options); });
  };
  CGame game;
  game.AddStatic(CGame::Circle({0, 0}, 1));
  b2Body* pBall = game.AddBall({3, 0});
  EXPECT_EQ(refusal(game), "");
  pBall->SetLinearVelocity({NAN, 0});
  EXPECT_EQ(refusal(game).find("body 1 fixture 0: m_vVel is (nan, 0): expected "), 0u) << refusal(game);
  pBall->SetLinearVelocity({0, 0});
  pBall->GetFixtureList()->SetRestitution(-1.0f);
  EXPECT_EQ(refusal(game).find("body 1 fixture 0: restitution is -1: expected "), 0u) << refusal(game);
  pBall->GetFixtureList()->SetRestitution(0.0f);
  pBall->SetGravityScale(NAN);
  EXPECT_EQ(refusal(game).find("body 1 fixture 0: gravity scale is nan: expected "), 0u) << refusal(game);
  pBall->SetGravityScale(1.0f);
  EXPECT_EQ(refusal(game, {.m_fLengthUnit = 0.0f}).find("m_fLengthUnit is 0: "), 0u);
  EXPECT_EQ(refusal(game, {.m_fLengthUnit = 1e-19f}).find("m_fLengthUnit is 1e-19: "), 0u); // as of a world
  EXPECT_EQ(refusal(game, {.m_fTimeStep = NAN}).find("m_fTimeStep is nan: "), 0u);
  EXPECT_EQ(refusal(game, {.m_fLengthUnit = 1e18f}).find("body 1 fixture 0: m_vPos is (3e+18, 0): "), 0u);
}

} // namespace
} // namespace Shapes
