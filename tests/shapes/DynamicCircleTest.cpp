// SPDX-License-Identifier: MIT
#include "../GameClock.h"

#include "../Testing.h"

namespace Shapes {
namespace {

CDynamicCircle Ball(const Vector2& p, float r, const Vector2& v = Vector2::Zero(), float m = 1.0f,
                    float e = 1.0f) {
  return CDynamicCircle(CDynamicCircleDesc(p, r, v, m, e));
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

} // namespace
} // namespace Shapes
