// SPDX-License-Identifier: MIT
#include "../GameClock.h"

#include "../Testing.h"

namespace Shapes {
namespace {

CDynamicCircle Ball(const Vector2& p, float r, const Vector2& v = Vector2::Zero(), float m = 1.0f,
                    float e = 1.0f) {
  return CDynamicCircle(CDynamicCircleDesc(p, r, v, m, e));
}

// Detects with the native engine, which must answer true, and responds.
CContactDesc Collide(CShape& shape, CDynamicCircle& ball) {
  CContactDesc c(&shape, &ball);
  EXPECT_TRUE(GetBackend(eBackend::Native)->CollisionDetected(c));
  ball.CollisionResponse(c);
  return c;
}

TEST(DynamicCircle, IsWhatItsDescriptorSays) {
  EXPECT_EQ(CDynamicCircleDesc().m_eMotionType, eMotion::Dynamic);
  const CDynamicCircle ball = Ball({1.0f, 2.0f}, 0.5f, {3.0f, 4.0f}, 2.0f, 0.75f);
  EXPECT_EQ(ball.GetShapeType(), eShape::Circle);
  EXPECT_EQ(ball.GetMotionType(), eMotion::Dynamic);
  EXPECT_EQ(ball.GetPos(), Vector2(1.0f, 2.0f));
  EXPECT_EQ(ball.GetPrevPos(), Vector2(1.0f, 2.0f));
  EXPECT_EQ(ball.GetRadius(), 0.5f);
  EXPECT_EQ(ball.GetVel(), Vector2(3.0f, 4.0f));
  EXPECT_EQ(ball.GetMass(), 2.0f);
  EXPECT_EQ(ball.GetElasticity(), 0.75f);
  EXPECT_FALSE(ball.GetSpeedCapped());
  EXPECT_FALSE(ball.GetRotating());
}

TEST(DynamicCircle, MoveChangesTheVelocityFirst) {
  CGameClock::Set(0.5f, -8.0f);
  CDynamicCircle ball = Ball({1.0f, 2.0f}, 0.5f, {4.0f, 0.0f});
  ball.move();
  CGameClock::Set(g_fDt, 0.0f);
  EXPECT_EQ(ball.GetVel(), Vector2(4.0f, -4.0f));
  EXPECT_EQ(ball.GetPos(), Vector2(3.0f, 0.0f));
  EXPECT_EQ(ball.GetPrevPos(), Vector2(1.0f, 2.0f));
  EXPECT_EQ(ball.GetAABB().GetTopLeft(), Vector2(2.5f, 0.5f));
}

TEST(DynamicCircle, WithoutAGameThereIsNoGravityAndSixtyStepsASecond) {
  CDynamicCircle ball = Ball({0.0f, 0.0f}, 0.5f, {60.0f, 0.0f});
  ball.move();
  EXPECT_EQ(ball.GetVel(), Vector2(60.0f, 0.0f));
  EXPECT_NEAR(ball.GetPos().x(), 1.0f, 2 * g_fUlp);
}

TEST(DynamicCircle, SetPosForgetsWhereItWas) {
  CDynamicCircle ball = Ball({0.0f, 0.0f}, 0.5f, {60.0f, 0.0f});
  ball.move();
  ball.SetPos({5.0f, 6.0f});
  EXPECT_EQ(ball.GetPrevPos(), Vector2(5.0f, 6.0f));
  EXPECT_EQ(ball.GetPos(), Vector2(5.0f, 6.0f));
}

TEST(DynamicCollision, MovesAndKicksBoth) {
  CDynamicCircle a = Ball({0.0f, 0.0f}, 0.5f, {0.0f, 0.0f}, 1.0f),
                 b = Ball({0.0f, 0.9f}, 0.5f, {2.0f, -4.0f}, 3.0f);
  const CContactDesc c = Collide(a, b);
  EXPECT_EQ(c.m_vNorm, Vector2(0.0f, 1.0f));
  EXPECT_EQ(c.m_vPOI, Vector2(0.0f, 0.5f));
  EXPECT_EQ(c.m_fSpeed, 4.0f);
  EXPECT_NEAR(a.GetPos().y(), -0.075, 2 * g_fUlp);
  EXPECT_NEAR(b.GetPos().y(), 0.925, 2 * g_fUlp);
  EXPECT_EQ(a.GetVel(), Vector2(0.0f, -6.0f)); // 2 m / (m + M) of 4
  EXPECT_EQ(b.GetVel(), Vector2(2.0f, -2.0f));
  EXPECT_NEAR(a.GetAABB().GetTopLeft().y(), 0.425, 4 * g_fUlp); // boxes follow
  EXPECT_NEAR(b.GetAABB().GetBottomRt().y(), 0.425, 4 * g_fUlp);
}

TEST(CollisionResponse, OfAnotherBallsContactIsRefused) {
  CLineSeg floor(CLineSegDesc({-1.0f, 0.0f}, {1.0f, 0.0f}));
  CDynamicCircle ball = Ball({0.0f, 0.05f}, 0.1f), other = Ball({0.0f, 0.05f}, 0.1f);
  CContactDesc c(&floor, &ball);
  ASSERT_TRUE(GetBackend(eBackend::Native)->CollisionDetected(c));
  EXPECT_THROW(other.CollisionResponse(c), std::invalid_argument);
  EXPECT_THROW(ball.CollisionResponse(CContactDesc(nullptr, &ball)), std::invalid_argument);
  EXPECT_EQ(other.GetPos(), Vector2(0.0f, 0.05f));
}

TEST(CollisionResponse, OfGreatElasticityStaysFiniteAndIsFlagged) {
  CLineSeg floor(CLineSegDesc({-1.0f, 0.0f}, {1.0f, 0.0f}, 1000.0f));
  CDynamicCircle ball = Ball({0.0f, 0.05f}, 0.1f, {0.0f, -1.0f});
  int bounces = 0;
  while (!ball.GetSpeedCapped() && bounces < 50) {
    ball.SetPos({0.0f, 0.05f});
    ball.SetVel({0.0f, -ball.GetVel().norm()});
    Collide(floor, ball);
    ++bounces;
  }
  EXPECT_EQ(bounces, 7); // 1000^6 is the limit of 1e18, which rounding may not pass
  EXPECT_NEAR(ball.GetVel().y() / g_fMaxSpeed, 1.0, 2 * g_fUlp);
  float uncapped = 1.0f;
  for (int i = 0; i < 13; ++i)
    uncapped *= 1000.0f;
  EXPECT_TRUE(std::isinf(uncapped));
}

} // namespace
} // namespace Shapes
