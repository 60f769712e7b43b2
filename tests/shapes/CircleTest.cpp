// SPDX-License-Identifier: MIT
// Circles, and their tangents through a point and common to two of them.
#include <Shapes/Circle.h>

#include "../Testing.h"

#include "traps/Traps.h"

namespace Shapes {
namespace {

CCircle Circle(const Vector2& p, float r) { return CCircle(CCircleDesc(p, r)); }

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

TEST(Circle, ClosestPtOfTheCentreIsTheTop) {
  EXPECT_EQ(Circle({1.0f, 1.0f}, 2.0f).ClosestPt({1.0f, 1.0f}), Vector2(1.0f, 3.0f));
}

TEST(CircleTangents, ThroughAPointOfTheCircleTouchThere) {
  Vector2 p0, p1;
  ASSERT_TRUE(Circle({0.0f, 0.0f}, 5.0f).Tangents({3.0f, 4.0f}, p0, p1));
  EXPECT_EQ(p0, Vector2(3.0f, 4.0f));
  EXPECT_EQ(p1, Vector2(3.0f, 4.0f));
}

TEST(CircleTangents, ThroughAPointInsideDoNotExist) {
  Vector2 p0(7.0f, 7.0f), p1(8.0f, 8.0f);
  EXPECT_FALSE(Circle({0.0f, 0.0f}, 5.0f).Tangents({3.0f, 3.9f}, p0, p1));
  EXPECT_FALSE(Circle({0.0f, 0.0f}, 5.0f).Tangents({0.0f, 0.0f}, p0, p1));
  EXPECT_FALSE(Circle({0.0f, 0.0f}, 0.0f).Tangents({0.0f, 0.0f}, p0, p1));
  const CWithoutTraps onPurpose;
  EXPECT_FALSE(Circle({0.0f, 0.0f}, 5.0f).Tangents({std::nanf(""), 9.0f}, p0, p1));
  EXPECT_EQ(p0, Vector2(7.0f, 7.0f)); // untouched
  EXPECT_EQ(p1, Vector2(8.0f, 8.0f));
}

TEST(CircleTangents, OfACircleWithoutExtentMeetInItsCentre) {
  Vector2 p0, p1;
  ASSERT_TRUE(Circle({3.0f, 4.0f}, 0.0f).Tangents({0.0f, 0.0f}, p0, p1));
  EXPECT_LE((p0 - Vector2(3.0f, 4.0f)).norm(), 8 * g_fUlp * 5);
  EXPECT_EQ(p0, p1);
}

TEST(CircleTangents, ScaleWithTheirCircle) {
  // Powers of two change no digits, however small or large.
  Vector2 a0, a1;
  ASSERT_TRUE(Circle({1.5f, 0.25f}, 0.75f).Tangents({-2.0f, 1.0f}, a0, a1));
  for (const int exponent : {-80, -59, -21, -20, -1, 1, 20, 21, 57, 58}) {
    const float s = std::ldexp(1.0f, exponent);
    Vector2 p0, p1;
    ASSERT_TRUE(Circle(s * Vector2(1.5f, 0.25f), s * 0.75f).Tangents(s * Vector2(-2.0f, 1.0f), p0, p1));
    EXPECT_EQ(p0, s * a0) << "2^" << exponent;
    EXPECT_EQ(p1, s * a1) << "2^" << exponent;
  }
}

TEST(CircleTangents, OfNestedOrInternallyTouchingCirclesDoNotExist) {
  const CCircle a = Circle({0.0f, 0.0f}, 5.0f);
  CLineSegDesc t0({7.0f, 7.0f}, {8.0f, 8.0f}), t1 = t0;
  for (const CCircle& b : {Circle({1.0f, 0.0f}, 2.0f), Circle({3.0f, 0.0f}, 2.0f), Circle({0.0f, 0.0f}, 5.0f),
                           Circle({0.0f, 0.0f}, 0.0f), Circle({3.0f, 4.0f}, 0.0f)}) {
    EXPECT_FALSE(a.Tangents(&b, t0, t1));
    EXPECT_FALSE(b.Tangents(&a, t0, t1));
    EXPECT_FALSE(a.Tangent(&b, t0));
  }
  EXPECT_EQ(t0.GetEndPt0(), Vector2(7.0f, 7.0f)); // untouched
  EXPECT_EQ(t1.GetEndPt1(), Vector2(8.0f, 8.0f));
}

TEST(CircleTangents, OnlyTheEndsOfTheDescriptorsAreSet) {
  CLineSegDesc t0({0.0f, 0.0f}, {1.0f, 0.0f}, 0.25f), t1;
  t0.m_eSides = eSides::Back;
  const CCircle b = Circle({9.0f, 0.0f}, 1.0f);
  ASSERT_TRUE(Circle({0.0f, 0.0f}, 2.0f).Tangents(&b, t0, t1));
  EXPECT_EQ(t0.m_fElasticity, 0.25f);
  EXPECT_EQ(t0.m_eSides, eSides::Back);
  EXPECT_EQ(t0.m_vPos, Vector2(t0.GetEndPt0() + 0.5f * (t0.GetEndPt1() - t0.GetEndPt0())));
}

TEST(CircleTangents, WithoutAnotherCircleAreRefused) {
  CLineSegDesc t0, t1;
  EXPECT_THROW(Circle({0.0f, 0.0f}, 1.0f).Tangents(nullptr, t0, t1), std::invalid_argument);
  EXPECT_THROW(Circle({0.0f, 0.0f}, 1.0f).Tangent(nullptr, t0), std::invalid_argument);
}

} // namespace
} // namespace Shapes
