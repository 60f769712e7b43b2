// SPDX-License-Identifier: MIT
#include "geometry/BoxOverlap.h"

#include "../Testing.h"

namespace Shapes::Geometry {
namespace {

const CBox2d g_cBox(Vector2d(1, 2), Vector2d(3, 4));

template <class TShape, class TDesc>
bool IsIn(const TDesc& desc) {
  return HasPointIn(MakeShapeGeometry(TShape(desc), 0.0), g_cBox);
}

TEST(BoxOverlap, AWayComesInThroughAnySide) {
  EXPECT_EQ(FindEntry(g_cBox, {0, 3}, {2, 0}, 1), 0.5);
  EXPECT_EQ(FindEntry(g_cBox, {4, 3}, {-2, 0}, 1), 0.5);
  EXPECT_EQ(FindEntry(g_cBox, {2, 0}, {0, 4}, 1), 0.5);
  EXPECT_EQ(FindEntry(g_cBox, {0, 1}, {4, 4}, 1), 0.25); // through a corner
  EXPECT_EQ(FindEntry(g_cBox, {2, 3}, {0, 0}, 1), 0);    // it is in it
  EXPECT_EQ(FindEntry(g_cBox, {0, 3}, {0, 1}, 1), g_fInf);
  EXPECT_EQ(FindEntry(g_cBox, {0, 3}, {-1, 0}, 1), g_fInf);
  EXPECT_EQ(FindEntry(g_cBox, {0, 3}, {2, 0}, 0.4), g_fInf); // too late
  EXPECT_EQ(FindEntry(g_cBox, {0, 5}, {3, 0.1}, 1), g_fInf); // past it
}

TEST(BoxOverlap, PointsAndSegments) {
  EXPECT_TRUE(IsIn<CPoint>(CPointDesc(Vector2(1, 4)))); // a corner
  EXPECT_FALSE(IsIn<CPoint>(CPointDesc(Vector2(0.9f, 3))));
  EXPECT_TRUE(IsIn<CLineSeg>(CLineSegDesc({0, 0}, {4, 6}))); // no end in it
  EXPECT_FALSE(IsIn<CLineSeg>(CLineSegDesc({0, 3}, {2, 6})));
}

TEST(BoxOverlap, OfCirclesTheCurveCounts) {
  EXPECT_TRUE(IsIn<CCircle>(CCircleDesc({0, 3}, 1.5f)));
  EXPECT_TRUE(IsIn<CCircle>(CCircleDesc({2, 3}, 0.5f)));  // all of it
  EXPECT_FALSE(IsIn<CCircle>(CCircleDesc({2, 3}, 1.5f))); // around the box
  EXPECT_FALSE(IsIn<CCircle>(CCircleDesc({0, 0}, 2)));
  EXPECT_FALSE(IsIn<CArc>(CArcDesc({2, 3}, 1.5f, 1, 1)));
}

TEST(BoxOverlap, AnArcMayCrossTheBoxWithItsEndsOutside) {
  EXPECT_TRUE(IsIn<CArc>(CArcDesc({2, 1}, 1.5f, 0.5f, 2.5f)));
  EXPECT_FALSE(IsIn<CArc>(CArcDesc({2, 1}, 1.5f, 2.5f, 0.5f))); // the other part of the circle
  EXPECT_TRUE(IsIn<CArc>(CArcDesc({2, 3}, 0.5f, 0, 1)));        // all of it
  EXPECT_TRUE(IsIn<CArc>(CArcDesc({4, 3}, 1.5f, 2, 4)));
  EXPECT_FALSE(IsIn<CArc>(CArcDesc({4, 3}, 1.5f, 5, 1)));
}

} // namespace
} // namespace Shapes::Geometry
