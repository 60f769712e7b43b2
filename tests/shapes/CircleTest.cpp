// SPDX-License-Identifier: MIT
#include <Shapes/Circle.h>

#include "../Numbers.h"
#include "../Random.h"
#include "MakeShapes.h"

#include "traps/Traps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Shapes {
namespace {

using Tests::CRandom;

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

TEST(Circle, ClosestPtKeepsItsErrorBoundAndIsNoFartherThanAnyOther) {
  CRandom random(61);
  for (int i = 0; i < 300; ++i) {
    const Vector2 c = random.Vector(-10, 14);
    const float r = random.Scale(-10, 10);
    const Vector2 p = c + random.Vector(-12, 12);
    if (p == c) continue;
    const Vector2 q = Circle(c, r).ClosestPt(p);
    const Vector2d exact = Wide(c) + static_cast<double>(r) * (Wide(p) - Wide(c)).normalized();
    const double bound = 3 * g_fUlp * (Wide(c).norm() + static_cast<double>(r));
    EXPECT_LE((Wide(q) - exact).norm(), bound) << "seed " << random.GetSeed();
    for (int k = 0; k < 1000; ++k) {
      const double a = 0.002 * 3.14159265358979323846 * k;
      const Vector2d other = Wide(c) + static_cast<double>(r) * Vector2d(std::cos(a), std::sin(a));
      ASSERT_LE((Wide(q) - Wide(p)).norm(), (other - Wide(p)).norm() + bound) << "seed " << random.GetSeed();
    }
  }
}

TEST(Circle, BoxTouchesTheCircleWithinAnUlp) {
  CRandom random(62);
  for (int i = 0; i < 5000; ++i) {
    const Vector2 c = random.Vector(-10, 20);
    const float r = random.Scale(-10, 10);
    const CCircle circle = Circle(c, r);
    const double ulp = g_fUlp * (Wide(c).cwiseAbs().maxCoeff() + static_cast<double>(r));
    const Vector2d R(r, r);
    const Vector2d low(circle.GetAABB().GetTopLeft().x(), circle.GetAABB().GetBottomRt().y());
    const Vector2d high(circle.GetAABB().GetBottomRt().x(), circle.GetAABB().GetTopLeft().y());
    EXPECT_LE((low - (Wide(c) - R)).cwiseAbs().maxCoeff(), ulp) << "seed " << random.GetSeed();
    EXPECT_LE((high - (Wide(c) + R)).cwiseAbs().maxCoeff(), ulp);
  }
}

TEST(KinematicCircle, TurnsFromItsPoseAtConstructionAndResetsBitForBit) {
  CKinematicCircle circle(CCircleDesc({3.0f, 1.0f}, 0.5f));
  EXPECT_EQ(circle.GetMotionType(), eMotion::Kinematic);
  for (int i = 0; i < 3; ++i) {
    circle.Rotate({1.0f, 1.0f}, g_fPi / 2);
    EXPECT_LE((circle.GetPos() - Vector2(1.0f, 3.0f)).norm(), 12 * g_fUlp);
    EXPECT_NEAR(circle.GetAABB().GetTopLeft().y(), 3.5f, 12 * g_fUlp);
  }
  circle.Rotate({-7.0f, 2.0f}, 1.234f);
  circle.Reset();
  EXPECT_EQ(circle.GetPos(), Vector2(3.0f, 1.0f));
  EXPECT_EQ(circle.GetAABB().GetTopLeft(), Vector2(2.5f, 1.5f));
  EXPECT_EQ(circle.GetRadius(), 0.5f);
}

} // namespace
} // namespace Shapes
