// SPDX-License-Identifier: MIT
#include <Shapes/Circle.h>

#include "../Numbers.h"
#include "MakeShapes.h"

#include "traps/Traps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Shapes {
namespace {

TEST(Circle, IsWhatItsDescriptorSays) {
  EXPECT_EQ(CCircleDesc().m_eShapeType, eShape::Circle);
  const CCircle circle(CCircleDesc({1.0f, 2.0f}, 3.0f, 1.5f));
  EXPECT_EQ(circle.GetShapeType(), eShape::Circle);
  EXPECT_EQ(circle.GetMotionType(), eMotion::Static);
  EXPECT_EQ(circle.GetPos(), Vector2(1.0f, 2.0f));
  EXPECT_EQ(circle.GetRadius(), 3.0f);
  EXPECT_EQ(circle.GetElasticity(), 1.5f);
  EXPECT_EQ(circle.GetAABB().GetTopLeft(), Vector2(-2.0f, 5.0f));
  EXPECT_EQ(circle.GetAABB().GetBottomRt(), Vector2(4.0f, -1.0f));
}

TEST(Circle, PointsOfThePerimeterAreNotInside) {
  const CCircle circle = Circle({0.0f, 0.0f}, 5.0f);
  EXPECT_FALSE(circle.PtInCircle({3.0f, 4.0f}));
  EXPECT_FALSE(circle.PtInCircle({5.0f, 0.0f}));
  EXPECT_TRUE(circle.PtInCircle({std::nextafter(5.0f, 0.0f), 0.0f}));
  EXPECT_TRUE(circle.PtInCircle({0.0f, 0.0f}));
  EXPECT_FALSE(Circle({0.0f, 0.0f}, 0.0f).PtInCircle({0.0f, 0.0f}));
  const CWithoutTraps onPurpose;
  EXPECT_FALSE(circle.PtInCircle({std::nanf(""), 0.0f}));
}

TEST(Circle, PtInCircleNeedsNoSquaresThatUnderflowOrOverflow) {
  const auto naive = [](const Vector2& p, float r) { return p.squaredNorm() < r * r; };
  EXPECT_FALSE(naive({5e-24f, 0.0f}, 1e-23f)); // both squares are 0
  EXPECT_TRUE(Circle({0.0f, 0.0f}, 1e-23f).PtInCircle({5e-24f, 0.0f}));
  EXPECT_FALSE(Circle({0.0f, 0.0f}, 1e-23f).PtInCircle({2e-23f, 0.0f}));
  EXPECT_TRUE(Circle({0.0f, 0.0f}, 1e18f).PtInCircle({9e17f, 0.0f}));
  EXPECT_FALSE(Circle({0.0f, 0.0f}, 1e18f).PtInCircle({9e17f, 9e17f}));
}

TEST(Circle, ClosestPtIsOnTheNearSide) {
  const CCircle circle = Circle({1.0f, 1.0f}, 2.0f);
  const auto naive = [&](const Vector2& p) { // normal from the point to the centre
    return Vector2(circle.GetPos() + circle.GetRadius() * Normalize(circle.GetPos() - p));
  };
  const Vector2 p(6.0f, 1.0f);
  EXPECT_EQ(circle.ClosestPt(p), Vector2(3.0f, 1.0f));
  EXPECT_EQ(naive(p), Vector2(-1.0f, 1.0f));                       // the far side: off by the diameter
  EXPECT_EQ(circle.ClosestPt({1.0f, 0.5f}), Vector2(1.0f, -1.0f)); // from inside as well
}

TEST(Circle, ClosestPtOfTheCentreIsTheTop) {
  EXPECT_EQ(Circle({1.0f, 1.0f}, 2.0f).ClosestPt({1.0f, 1.0f}), Vector2(1.0f, 3.0f));
}

} // namespace
} // namespace Shapes
