// SPDX-License-Identifier: MIT
// Slow balls bounce too: neither profile has a speed below which they stop.
#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

/// The velocity along y of a ball that comes down on the shape's top at the origin.
float Rebound(eProfile profile, const CAnyShapeDesc& shape, float speed) {
  auto pWorld = MakeBox2D(profile);
  pWorld->Add(shape);
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.1f + 0.0331f}, 0.1f, {0, -speed}));
  const int steps = static_cast<int>(2 * 0.0331f / speed / g_fDt) + 10;
  for (int i = 0; i < steps && pWorld->GetVel(ball).y() < 0; ++i)
    pWorld->Step();
  return pWorld->GetVel(ball).y();
}

TEST(TunedSlowTest, ASlowBallReboundsAtItsSpeed) {
  const std::vector<CAnyShapeDesc> shapes{CPointDesc({0, 0}), CLineSegDesc({-1, 0}, {1, 0}),
                                          CCircleDesc({0, -1}, 1)};
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned})
    for (std::size_t k = 0; k < shapes.size(); ++k)
      for (const float speed : {0.99f, 0.1f, 0.01f}) {
        SCOPED_TRACE(testing::Message() << "profile " << static_cast<int>(profile) << ", shape " << k);
        EXPECT_NEAR(Rebound(profile, shapes[k], speed), speed, 1e-5f);
      }
}

TEST(TunedSlowTest, ASlowBallReboundsFromAnArcAtItsSpeed) {
  const CArcDesc hill({0, -1}, 1, 0, 0), bowl({0, 1}, 1, 0, 0);
  for (const float speed : {0.99f, 0.1f, 0.01f}) {
    SCOPED_TRACE(speed);
    EXPECT_NEAR(Rebound(eProfile::Tuned, hill, speed), speed, 1e-5f);
    EXPECT_NEAR(Rebound(eProfile::Tuned, bowl, speed), speed, 1e-5f);
  }
  // The control: two chords of the shipped bowl join at its bottom, and the ball gains speed there.
  EXPECT_GT(std::abs(Rebound(eProfile::Shipped, bowl, 0.99f) - 0.99f), 0.01f);
}

TEST(TunedSlowTest, Box2DItselfStopsASlowBall) { // the control
  for (const float speed : {0.99f, 1.01f}) {
    b2World world(b2Vec2_zero);
    const b2BodyDef ground;
    b2EdgeShape edge;
    edge.SetTwoSided({-1, 0}, {1, 0});
    world.CreateBody(&ground)->CreateFixture(&edge, 0);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = {0, 0.15f};
    def.linearVelocity = {0, -speed};
    b2Body& ball = *world.CreateBody(&def);
    b2CircleShape circle;
    circle.m_radius = 0.1f;
    ball.CreateFixture(&circle, 1)->SetRestitution(1);
    for (int i = 0; i < 30; ++i)
      world.Step(g_fDt, 8, 3);
    EXPECT_NEAR(ball.GetLinearVelocity().y, speed < 1 ? 0 : speed, 1e-5f);
  }
}

} // namespace
} // namespace Shapes::Tests
