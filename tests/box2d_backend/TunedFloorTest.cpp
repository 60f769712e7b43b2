// SPDX-License-Identifier: MIT
// Balls that roll and rest on floors under gravity.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr double g_fMostOffFloor = 2 * g_fTunedOffset;
const Vector2 g_vGravity(0, -9.81f);

struct CStay {
  double m_fOff = 0;   // farthest from where they should be, metres
  double m_fSpeed = 0; // fastest
};

/// Rolls along eleven segments in line, over their ten sharedEnds; m_fSpeed is the largest change of speed.
CStay Roll(eProfile profile, float elasticity) {
  auto pWorld = MakeBox2D(profile, g_vGravity);
  for (int i = 0; i < 11; ++i)
    pWorld->Add(CLineSegDesc({static_cast<float>(i), 0}, {static_cast<float>(i + 1), 0}));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.5f, 0.1f}, 0.1f, {3, 0}, 1, elasticity));
  CStay stay;
  for (int i = 0; i < 200; ++i) {
    pWorld->Step();
    stay.m_fOff = std::max(stay.m_fOff, std::abs(pWorld->GetPos(ball).y() - 0.1));
    stay.m_fSpeed = std::max(stay.m_fSpeed, std::abs(pWorld->GetVel(ball).x() - 3.0));
  }
  EXPECT_NEAR(pWorld->GetPos(ball).x(), 10.5f, 0.02f); // all the way
  return stay;
}

TEST(TunedFloorTest, ABallRollsOverTenJointsAndKeepsItsSpeed) {
  for (const float elasticity : {0.0f, 0.5f}) {
    SCOPED_TRACE(elasticity);
    const CStay stay = Roll(eProfile::Tuned, elasticity);
    EXPECT_LE(stay.m_fOff, g_fMostOffFloor);
    EXPECT_LE(stay.m_fSpeed, 1e-4);
    EXPECT_GT(Roll(eProfile::Shipped, elasticity).m_fOff, g_fMostOffFloor); // the control
  }
}

/// Lies for 60 s, after 2 s in which it may bounce if it is dropped.
CStay Rest(eProfile profile, float elasticity, float drop) {
  auto pWorld = MakeBox2D(profile, g_vGravity);
  pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.1f + drop}, 0.1f, {0, 0}, 1, elasticity));
  CStay stay;
  for (int i = 0; i < 62 * 60; ++i) {
    pWorld->Step();
    if (drop > 0 && i < 2 * 60) continue;
    stay.m_fOff = std::max(stay.m_fOff, std::abs(pWorld->GetPos(ball).y() - 0.1));
    stay.m_fSpeed = std::max<double>(stay.m_fSpeed, pWorld->GetVel(ball).norm());
  }
  return stay;
}

TEST(TunedFloorTest, ABallRestsOnTheFloor) {
  for (const float elasticity : {0.0f, 0.5f})
    for (const float drop : {0.0f, 0.05f}) {
      SCOPED_TRACE(testing::Message() << "elasticity " << elasticity << ", from " << drop);
      const CStay stay = Rest(eProfile::Tuned, elasticity, drop);
      EXPECT_LE(stay.m_fOff, g_fMostOffFloor);
      EXPECT_LE(stay.m_fSpeed, 0.01);
    }
}

TEST(TunedFloorTest, AShippedBallRestsAboveItOrTrembles) { // the control
  EXPECT_GT(Rest(eProfile::Shipped, 0, 0).m_fOff, 2 * g_fMostOffFloor);
  EXPECT_GT(Rest(eProfile::Shipped, 0.5f, 0).m_fSpeed, 0.1);
}

/// Three balls on a floor between two walls that are a little farther apart than a ball is wide: they lean
/// against the walls in turn.
CStay Stack(eProfile profile, float elasticity) {
  auto pWorld = MakeBox2D(profile, g_vGravity);
  pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  for (const float x : {-0.105f, 0.105f})
    pWorld->Add(CLineSegDesc({x, -0.5f}, {x, 2}));
  std::vector<CShapeId> balls;
  std::vector<Vector2> places;
  for (int k = 0; k < 3; ++k) {
    const float rise = std::sqrt(0.2f * 0.2f - 0.01f * 0.01f);
    places.push_back({k == 1 ? 0.005f : -0.005f, 0.1f + static_cast<float>(k) * rise});
    balls.push_back(pWorld->Add(CDynamicCircleDesc(places.back(), 0.1f, {0, 0}, 1, elasticity)));
  }
  CStay stay;
  for (int i = 0; i < 20 * 60; ++i) {
    pWorld->Step();
    for (std::size_t k = 0; k < 3; ++k) {
      stay.m_fOff = std::max<double>(stay.m_fOff, (pWorld->GetPos(balls[k]) - places[k]).norm());
      if (i > 10 * 60) stay.m_fSpeed = std::max<double>(stay.m_fSpeed, pWorld->GetVel(balls[k]).norm());
    }
  }
  return stay;
}

TEST(TunedFloorTest, AStackBetweenTwoWallsStays) {
  for (const float elasticity : {0.0f, 0.5f}) {
    SCOPED_TRACE(elasticity);
    const CStay stay = Stack(eProfile::Tuned, elasticity);
    EXPECT_LE(stay.m_fOff, 3 * g_fMostOffFloor); // three contacts carry the topmost
    EXPECT_LE(stay.m_fSpeed, 0.01);
  }
  EXPECT_GT(Stack(eProfile::Shipped, 0.5f).m_fOff, 3 * g_fMostOffFloor); // the control
  EXPECT_GT(Stack(eProfile::Shipped, 0.5f).m_fSpeed, 0.1);
}

} // namespace
} // namespace Shapes::Tests
