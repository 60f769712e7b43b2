// SPDX-License-Identifier: MIT
// Kinematic shapes that move by their velocity: where they go, what they do to balls, what sensors see of
// them, the same on every engine.
#include "Backends.h"

namespace Shapes {
namespace {

CLineSegDesc Wall(const Vector2& v, float e = 1.0f) { // upright, at x = 0
  CLineSegDesc desc = Turning(CLineSegDesc({0, -2}, {0, 2}, e), 0);
  desc.m_vVel = v;
  return desc;
}

class CMovingWallContract : public CEveryBackend {};
SHAPES_ON_EVERY_BACKEND(CMovingWallContract);

// A wall at V against which a ball comes at v leaves it with 2 V - v, however fast it is: at 60 it moves by
// ten radii a step. Moved by SetPos instead it has no speed, which is the control.
TEST_P(CMovingWallContract, AWallGivesABallTwiceItsSpeed) {
  for (const float speed : {0.5f, 2.0f, 6.0f, 12.0f, 60.0f}) {
    SCOPED_TRACE(speed);
    const auto pWorld = Make();
    const CShapeId wall = pWorld->Add(Wall({speed, 0}));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({1, 0}, 0.1f, {-1, 0}));
    for (int i = 0; i < 300 && !(pWorld->GetVel(ball).x() > 0.0f); ++i)
      pWorld->Step();
    EXPECT_NEAR(pWorld->GetVel(ball).x(), 2.0f * speed + 1.0f, 1e-5f * speed);
    EXPECT_EQ(pWorld->GetVel(wall), Vector2(speed, 0));
    Steps(*pWorld, 20);
    EXPECT_GT(pWorld->GetPos(ball).x(), pWorld->GetPos(wall).x());
  }
  const auto pWorld = Make();
  const CShapeId wall = pWorld->Add(Wall({0, 0}));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({1, 0}, 0.1f, {-1, 0}));
  for (int i = 1; i <= 60; ++i) {
    pWorld->SetPos(wall, {2.0f * g_fDt * static_cast<float>(i), 0});
    pWorld->Step();
  }
  EXPECT_LT(pWorld->GetVel(ball).x(), 1.5f);
}

TEST_P(CMovingWallContract, ItIsWhereItsVelocityTakesIt) {
  const auto pWorld = Make();
  CLineSegDesc desc = Wall({0.3f, -0.7f});
  desc.m_vRotCenter = {0, 1};
  const CShapeId wall = pWorld->Add(desc);
  Steps(*pWorld, 6000);
  const float t = 100.0f; // seconds
  EXPECT_NEAR(pWorld->GetPos(wall).x(), 0.3f * t, 2e-5f);
  EXPECT_NEAR(pWorld->GetPos(wall).y(), -0.7f * t, 5e-5f);
  EXPECT_NEAR(pWorld->GetRotCenter(wall).y(), 1 - 0.7f * t, 5e-5f);
  pWorld->SetVel(wall, {0, 0});
  const Vector2 there = pWorld->GetPos(wall);
  Steps(*pWorld, 10);
  EXPECT_EQ(pWorld->GetPos(wall), there);
  pWorld->Reset(wall);
  EXPECT_EQ(pWorld->GetPos(wall), Vector2(0, 0));
  EXPECT_EQ(pWorld->GetRotCenter(wall), Vector2(0, 1));
}

// The middle of a bar that turns about it goes straight on, and its ends stay a bar's length apart.
TEST_P(CMovingWallContract, ACompoundMovesAndTurnsAsOne) {
  const auto pWorld = Make();
  const std::vector<CAnyShapeDesc> parts{CLineSegDesc({-1, 0}, {1, 0}), CPointDesc({1, 0})};
  const std::vector<CShapeId> ids = pWorld->AddCompound(parts, {0, 0}, 0.25f, {2, 0});
  Steps(*pWorld, 60);
  const auto& bar = static_cast<const CLineSeg&>(pWorld->GetShape(ids[0]));
  EXPECT_LT((bar.GetPos() - Vector2(2, 0)).norm(), 1e-5f);
  EXPECT_LT((pWorld->GetPos(ids[1]) - Vector2(2, 1)).norm(), 1e-5f);
  EXPECT_LT(std::min((bar.GetEndPt0() - pWorld->GetPos(ids[1])).norm(),
                     (bar.GetEndPt1() - pWorld->GetPos(ids[1])).norm()),
            1e-6f);
}

TEST_P(CMovingWallContract, WhereKinematicsIsForbiddenItStands) {
  const auto pWorld = Make({{}, {eEffect::Kinematics}});
  const CShapeId wall = pWorld->Add(Wall({2, 0}));
  pWorld->Add(CDynamicCircleDesc({1, 0}, 0.1f));
  Steps(*pWorld, 60);
  EXPECT_EQ(pWorld->GetPos(wall), Vector2(0, 0));
  EXPECT_EQ(pWorld->GetVel(wall), Vector2(2, 0)); // what was asked for
  EXPECT_EQ(pWorld->GetStats().m_nShapesTurned, 0u);
}

// One that crosses a ball within a step begins and ends.
TEST_P(CMovingWallContract, ASensorThatMovesSeesABallThatRests) {
  for (const float speed : {1.0f, 90.0f}) {
    const auto pWorld = Make();
    CLineSegDesc desc = Wall({speed, 0});
    desc.m_bIsSensor = true;
    const CShapeId sensor = pWorld->Add(desc);
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.75f, 0}, 0.1f));
    int begins = 0, ends = 0;
    for (int i = 0; i < 120; ++i) {
      pWorld->Step();
      for (const CSensorEvent& event : pWorld->GetSensorEvents()) {
        EXPECT_EQ(event.m_cShape, sensor);
        EXPECT_EQ(event.m_cBall, ball);
        ++(event.m_bBegin ? begins : ends);
      }
      for (const CContactEvent& event : pWorld->GetContacts())
        EXPECT_NEAR(event.m_vPOI.x(), 0.75f, 0.1f + 1e-4f);
    }
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(ends, 1);
    EXPECT_EQ(pWorld->GetVel(ball), Vector2(0, 0));
  }
}

TEST_P(CMovingWallContract, WhatCannotMoveIsRefused) {
  const auto pWorld = Make();
  CLineSegDesc desc = Wall({1, 0});
  desc.m_eMotionType = eMotion::Static;
  EXPECT_THROW(pWorld->Add(desc), std::invalid_argument);
  const CShapeId wall = pWorld->Add(Wall({1, 0}));
  EXPECT_THROW(pWorld->SetVel(wall, {g_fNan, 0}), std::invalid_argument);
  EXPECT_EQ(pWorld->GetVel(wall), Vector2(1, 0));
}

// Far out it stops at the limit of what coordinates may be, and nothing else happens.
TEST_P(CMovingWallContract, ItStopsAtTheGreatestLength) {
  const float limit = IsNative() ? g_fMaxLength : g_fMaxBox2DLength;
  const auto pWorld = Make();
  CPointDesc desc = Turning(CPointDesc({0.999f * limit, 0}), 0);
  desc.m_vVel = {1e-4f * limit, 0};
  const CShapeId point = pWorld->Add(desc);
  Steps(*pWorld, 100 * 60);
  const float x = pWorld->GetPos(point).x();
  EXPECT_LE(x, limit);
  EXPECT_GT(x, 0.999f * limit); // the control: it has moved
  pWorld->Step();
  EXPECT_EQ(pWorld->GetPos(point).x(), x);
}

} // namespace
} // namespace Shapes
