// SPDX-License-Identifier: MIT
// Box2D moves nothing by more than 2 metres and turns nothing by more than a quarter turn a step. A tuned
// world does not let it come to that; a shipped one says so.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nTunedClampSeed = 46;

TEST(TunedClampTest, AFastBallKeepsItsSpeedBitForBit) {
  auto pWorld = MakeBox2D(eProfile::Tuned);
  const Vector2 v(300, 400);
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 0.1f, v));
  for (int i = 0; i < 100; ++i) {
    pWorld->Step();
    ASSERT_EQ(pWorld->GetVel(ball), v) << "after step " << i;
  }
  const Vector2 exact = 100 * g_fDt * v;
  EXPECT_LE((pWorld->GetPos(ball) - exact).norm(), 1e-3f * exact.norm());
  EXPECT_EQ(pWorld->GetStats().m_nMovesClamped, 0u);
  EXPECT_GT(pWorld->GetStats().m_nEngineSteps, pWorld->GetStats().m_nSubsteps);
}

/// After 6 steps with 500 m/s towards a wall 20 away.
Vector2 SpeedAfterAWall(CWorld& world) {
  world.Add(CLineSegDesc({20, -5}, {20, 5}));
  const CShapeId ball = world.Add(CDynamicCircleDesc({0, 0}, 0.1f, {500, 0}));
  for (int i = 0; i < 6; ++i)
    world.Step();
  return world.GetVel(ball);
}

TEST(TunedClampTest, AFastBallBouncesOffAWallAtItsSpeed) {
  auto pWorld = MakeBox2D(eProfile::Tuned);
  const Vector2 v = SpeedAfterAWall(*pWorld);
  EXPECT_NEAR(v.x(), -500, 500 * 1e-6f);
  EXPECT_EQ(v.y(), 0);
}

TEST(TunedClampTest, AShippedBallIsSlowedDownAndItIsCounted) { // the control
  auto pWorld = MakeBox2D(eProfile::Shipped);
  EXPECT_LT(SpeedAfterAWall(*pWorld).norm(), 121);
  EXPECT_GE(pWorld->GetStats().m_nMovesClamped, 1u);
}

/// How many of 200 balls at rest that a spinner of 30 rev/s, half a turn a step, should hit in its second
/// quarter turn stay at rest.
int CountMissed(eProfile profile, std::uint64_t& turnsClamped) {
  CRandom random(g_nTunedClampSeed);
  int missed = 0;
  turnsClamped = 0;
  for (int k = 0; k < 200; ++k) {
    auto pWorld = MakeBox2D(profile);
    CLineSegDesc desc(Vector2(0, 0), Vector2(1, 0));
    desc.m_eMotionType = eMotion::Kinematic;
    desc.m_fRotSpeed = 30;
    const CShapeId spinner = pWorld->Add(desc);
    const Vector2d place = 0.7 * UnitVector(1.8 + random.Unit());
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc(place.cast<float>(), 0.05f));
    pWorld->Step();
    missed += pWorld->GetVel(ball).norm() == 0;
    EXPECT_NEAR(pWorld->GetOrientation(spinner), g_fPi, 1e-5f);
    turnsClamped += pWorld->GetStats().m_nTurnsClamped;
  }
  return missed;
}

TEST(TunedClampTest, AFastSpinnerTurnsByAllOfItsAngle) {
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedClampSeed);
  std::uint64_t turnsClamped = 0;
  EXPECT_EQ(CountMissed(eProfile::Tuned, turnsClamped), 0);
  EXPECT_EQ(turnsClamped, 0u);
}

TEST(TunedClampTest, AShippedSpinnerTurnsByLessAndItIsCounted) { // the control
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedClampSeed);
  std::uint64_t turnsClamped = 0;
  EXPECT_EQ(CountMissed(eProfile::Shipped, turnsClamped), 200);
  EXPECT_EQ(turnsClamped, 200u);
}

} // namespace
} // namespace Shapes::Tests
