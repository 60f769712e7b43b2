// SPDX-License-Identifier: MIT
#include "../Testing.h"

namespace Shapes {
namespace {

CSceneDesc Scene() {
  CSceneDesc scene;
  scene.m_cWorld.m_vGravity = {0, -10};
  scene.m_stdShapes = {CPointDesc({1, 2}), CLineSegDesc({0, 0}, {4, 0}), CCircleDesc({2, 2}, 0.5f)};
  scene.m_stdBalls = {CDynamicCircleDesc({1, 1}, 0.25f, {1, 0}), CDynamicCircleDesc({3, 1}, 0.25f)};
  return scene;
}

std::string ErrorOf(const CSceneDesc& scene, const std::string& name = "s", float seconds = 1.0f) {
  return MessageOf<std::invalid_argument>([&] { scene.ToJson(name, seconds); });
}

TEST(SceneDescTest, AddsShapesFirstAndGivesTheIdsInOrder) {
  const CSceneDesc scene = Scene();
  const auto pWorld = MakeWorld(scene.m_cWorld);
  const std::vector<CShapeId> ids = scene.AddTo(*pWorld);
  ASSERT_EQ(ids.size(), 5u);
  EXPECT_EQ(pWorld->GetShapeType(ids[1]), eShape::LineSeg);
  EXPECT_EQ(pWorld->GetMotionType(ids[3]), eMotion::Dynamic);
  EXPECT_EQ(pWorld->GetPos(ids[4]), Vector2(3, 1));
}

TEST(SceneDescTest, AddsAllOrNothing) {
  CSceneDesc scene = Scene();
  scene.m_stdBalls[1].m_fRadius = -1.0f;
  const auto pWorld = MakeWorld(scene.m_cWorld);
  const CShapeId before = pWorld->Add(CPointDesc({9, 9}));
  const auto refusal = [&] { return MessageOf<std::invalid_argument>([&] { scene.AddTo(*pWorld); }); };
  EXPECT_TRUE(Says(refusal(), "ball 1: m_fRadius is -1: expected"));
  EXPECT_EQ(pWorld->GetBallIds().size(), 0u);
  std::get<CCircleDesc>(scene.m_stdShapes[2]).m_fRadius = -2.0f;
  EXPECT_TRUE(Says(refusal(), "shape 2: m_fRadius is -2: expected"));
  EXPECT_TRUE(pWorld->Contains(before));
  for (std::uint32_t i = 0; i < 10; ++i)
    EXPECT_TRUE(CShapeId{before.m_nValue + 1 + i} > before && !pWorld->Contains({before.m_nValue + 1 + i}));
}

TEST(SceneDescTest, JsonIsThisText) {
  CSceneDesc scene = Scene();
  scene.m_stdNotes = {"One \"note\".", "And\nanother."};
  auto& seg = std::get<CLineSegDesc>(scene.m_stdShapes[1]);
  seg.m_eSides = eSides::Back;
  seg.m_bIsSensor = true;
  seg.m_cFilter = {2, 0xFFFF};
  scene.m_stdShapes.pop_back();
  scene.m_stdBalls.pop_back();
  scene.m_stdBalls[0].m_cFilter = {1, 6};
  EXPECT_EQ(scene.ToJson("a\\b", 2.5f), R"json({
  "name": "a\\b",
  "description": "One \"note\". And\u000aanother.",
  "length_unit": 1,
  "gravity": [0, -10],
  "time_step": 0.016666668,
  "duration": 2.5,
  "bounds": {"left": -2, "bottom": -2, "right": 6, "top": 4},
  "shapes": [
    {"type": "point", "position": [1, 2], "elasticity": 1},
    {"type": "line_segment", "p0": [0, 0], "p1": [4, 0], "sides": "back", "elasticity": 1, "sensor": true, "filter": [2, 65535]}
  ],
  "balls": [
    {"position": [1, 1], "velocity": [1, 0], "radius": 0.25, "mass": 1, "elasticity": 1, "filter": [1, 6]}
  ]
}
)json");
}

TEST(SceneDescTest, BoundsTakeInWhatTurns) {
  CSceneDesc scene = Scene();
  scene.m_stdShapes = {Turning(CLineSegDesc({3, 0}, {4, 0}))}; // turns about (0, 0), up to 4 away
  EXPECT_TRUE(Says(scene.ToJson("s", 1), R"("bounds": {"left": -8, "bottom": -8, "right": 8, "top": 8})"));
  scene.m_stdShapes.clear();
  scene.m_stdBalls = {CDynamicCircleDesc({1e8f, 0}, 0)}; // a box without extent, where 1 is below an ulp
  EXPECT_TRUE(
      Says(scene.ToJson("s", 1), R"("left": 99999904, "bottom": -100, "right": 100000096, "top": 100)"));
  scene.m_stdBalls = {CDynamicCircleDesc({0, 0}, 0)};
  EXPECT_TRUE(Says(scene.ToJson("s", 1), R"("left": -1, "bottom": -1, "right": 1, "top": 1)"));
}

TEST(SceneDescTest, WhatCannotBeWrittenIsRefused) {
  const auto refuse = [](const std::function<void(CSceneDesc&)>& change, const char* pBegin) {
    CSceneDesc scene = Scene();
    change(scene);
    EXPECT_EQ(ErrorOf(scene).find(pBegin), 0u) << ErrorOf(scene);
  };
  EXPECT_EQ(ErrorOf(Scene()), "");
  EXPECT_EQ(ErrorOf(Scene(), ""), "name is empty: expected a name of at least one letter");
  EXPECT_EQ(ErrorOf(Scene(), "s", 0.001f).find("seconds is 0.001: "), 0u);
  EXPECT_EQ(ErrorOf(Scene(), "s", NAN).find("seconds is nan: "), 0u);
  CSceneDesc empty = Scene();
  empty.m_stdBalls.clear();
  EXPECT_EQ(ErrorOf(empty), "m_stdBalls is empty: expected at least one ball: shapes-compare follows balls");
  refuse([](auto& s) { s.m_stdBalls[0].m_bIsSensor = true; }, "m_bIsSensor is true: ");
  refuse([](auto& s) { s.m_stdShapes.emplace_back(s.m_stdBalls[0]); }, "m_stdShapes is ");
  refuse([](auto& s) { s.m_stdBalls[0].m_vVel.x() = NAN; }, "m_vVel is (nan, 0): ");
  refuse([](auto& s) { s.m_cWorld.m_vGravity.x() = INFINITY; }, "m_vGravity is ");
  refuse([](auto& s) { s.m_cWorld.m_fTimeStep = 0; }, "m_fTimeStep is 0: ");
  refuse([](auto& s) { s.m_cWorld.m_cBox2D.m_fLengthUnit = -1; }, "m_fLengthUnit is -1: ");
}

} // namespace
} // namespace Shapes
