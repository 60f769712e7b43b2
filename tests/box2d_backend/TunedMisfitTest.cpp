// SPDX-License-Identifier: MIT
// Balls that are too small for Box2D's slop, and too large for a ring.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

// A bounce that is less than what gravity adds in the rest of the step is one through the surface for a ball
// whose radius is less than that way, g dt^2 / 2 at most: 1.4 mm here. Box2D's slop is 5 mm, or 1.25 mm in a
// tuned world.
TEST(TunedMisfitTest, ABallFarBelowTheSlopComesToRestOnASegment) {
  for (const float e : {0.0f, 0.5f})
    for (const float r : {0.0f, 1e-6f, 1e-4f})
      for (const float speed : {0.1f, 1.0f, 10.0f}) {
        SCOPED_TRACE(testing::Message() << "e = " << e << ", r = " << r << ", " << speed);
        auto pWorld = MakeBox2D(eProfile::Tuned, {0, -10});
        pWorld->Add(CLineSegDesc({-99, 0}, {99, 0}));
        const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, r + 0.5f}, r, {0.3f * speed, -speed}, 1, e));
        for (int i = 0; i < 300; ++i) {
          pWorld->Step();
          ASSERT_GT(pWorld->GetPos(ball).y(), -1e-3f) << i;
        }
        // It trembles within what Box2D takes for touching.
        if (speed < 10) {
          EXPECT_LT(pWorld->GetPos(ball).y(), 0.005f);
        }
      }
}

// A ball that does not fit is outside, however deep; it is met where it approaches, and here it does not.
TEST(TunedMisfitTest, ABallAroundARingStaysThereOrGoesOn) {
  for (const float r : {1.0f, 1.1f, 2.0f}) {
    SCOPED_TRACE(r);
    auto pWorld = MakeBox2D(eProfile::Tuned);
    pWorld->Add(CArcDesc({0, 0}, 1, 0, 0));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.05f, 0.02f}, r));
    for (int i = 0; i < 60; ++i)
      pWorld->Step();
    EXPECT_EQ(pWorld->GetPos(ball), Vector2(0.05f, 0.02f));
    pWorld->SetVel(ball, {1, 0});
    for (int i = 0; i < 30; ++i)
      pWorld->Step();
    EXPECT_NEAR(pWorld->GetPos(ball).x(), 0.55f, 1e-4f);
    EXPECT_EQ(pWorld->GetVel(ball), Vector2(1, 0));
  }
  auto pWorld = MakeBox2D(eProfile::Tuned); // the control: one that fits
  pWorld->Add(CArcDesc({0, 0}, 1, 0, 0));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.05f, 0.02f}, 0.9f, {1, 0}));
  for (int i = 0; i < 30; ++i)
    pWorld->Step();
  EXPECT_LT(pWorld->GetPos(ball).norm(), 0.11f);
}

} // namespace
} // namespace Shapes::Tests
