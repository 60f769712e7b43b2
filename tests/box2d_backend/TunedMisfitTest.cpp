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

// In a ring, in a half one with a lid, and in a box, of width 2.
std::unique_ptr<CWorld> MakeSmallRoom(int kind) {
  auto pWorld = MakeBox2D(eProfile::Tuned, {0, -10}, 1 / 60.0f);
  if (kind < 2) pWorld->Add(CArcDesc({0, 0}, 1, kind == 0 ? 0 : g_fPi, 0));
  if (kind == 1) pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  const Vector2 corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (std::size_t i = 0; kind == 2 && i < 4; ++i)
    pWorld->Add(CLineSegDesc(corners[i], corners[(i + 1) % 4]));
  return pWorld;
}

TEST(TunedMisfitTest, ABallFarBelowTheSlopStaysInARoom) {
  CRandom random(31);
  for (int kind = 0; kind < 3; ++kind)
    for (const float r : {0.0f, 1e-5f, 2e-4f, 0.001f, 0.002f})
      for (int trial = 0; trial < 20; ++trial) {
        SCOPED_TRACE(testing::Message() << "room " << kind << ", r = " << r << ", trial " << trial);
        auto pWorld = MakeSmallRoom(kind);
        const Vector2d v = (0.3 + 4 * random.Unit()) * UnitVector(360 * g_fDegree * random.Unit());
        const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, -0.3f}, r, v.cast<float>(), 1, 0.7f));
        for (int i = 0; i < 300; ++i) {
          pWorld->Step();
          const Vector2 p = pWorld->GetPos(ball);
          ASSERT_LT(kind == 2 ? p.cwiseAbs().maxCoeff() : p.norm(), 1.001f) << i;
          ASSERT_LT(p.y(), kind == 1 ? 0.001f : 2.0f) << i;
        }
      }
}

// The control: through what is open on its side it goes, however small it is.
TEST(TunedMisfitTest, ABallFarBelowTheSlopGoesThroughTheOpenSide) {
  for (const eSides sides : {eSides::Front, eSides::Back}) {
    auto pWorld = MakeBox2D(eProfile::Tuned, {0, -10}, 1 / 60.0f);
    CLineSegDesc floor({-9, 0}, {9, 0});
    floor.m_eSides = sides;
    pWorld->Add(floor);
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.3f}, 1e-5f, {1, 0}, 1, 0.0f));
    for (int i = 0; i < 60; ++i)
      pWorld->Step();
    EXPECT_EQ(pWorld->GetPos(ball).y() < -1, sides == eSides::Back);
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
