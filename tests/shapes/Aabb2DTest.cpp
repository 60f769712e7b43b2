// SPDX-License-Identifier: MIT
#include <Shapes/Aabb2D.h>

#include "../Testing.h"

#include "traps/Traps.h"

namespace Shapes {
namespace {

// A number on a coarse grid, so that edges often coincide.
float Coarse(CRandom& random) { return 0.25f * static_cast<float>(random.Below(41)) - 5.0f; }

CAabb2D Box(float l, float t, float r, float b) { return {Vector2(l, t), Vector2(r, b)}; }

TEST(Aabb2D, EmptyBoxMeetsNothingAndGrowsToAPoint) {
  const CAabb2D empty;
  EXPECT_FALSE(empty && empty);
  EXPECT_FALSE(empty && Box(-1e18f, 1e18f, 1e18f, -1e18f));
  EXPECT_FALSE(Box(-1e18f, 1e18f, 1e18f, -1e18f) && empty);
  EXPECT_FALSE(empty && Vector2(0.0f, 0.0f));
  EXPECT_EQ(empty.GetWidth(), 0.0f);
  EXPECT_EQ(empty.GetHt(), 0.0f);
  CAabb2D moved;
  moved.Translate({1.0f, 1.0f});
  EXPECT_FALSE(moved && Box(-1e18f, 1e18f, 1e18f, -1e18f));
  CAabb2D grown;
  grown += Vector2(5.0f, 6.0f);
  EXPECT_EQ(grown.GetTopLeft(), Vector2(5.0f, 6.0f));
  EXPECT_EQ(grown.GetBottomRt(), Vector2(5.0f, 6.0f));
}

TEST(Aabb2D, AssignmentShrinksToAPoint) {
  CAabb2D box = Box(-1.0f, 1.0f, 1.0f, -1.0f);
  box = Vector2(5.0f, 6.0f);
  EXPECT_EQ(box.GetTopLeft(), Vector2(5.0f, 6.0f));
  EXPECT_EQ(box.GetBottomRt(), Vector2(5.0f, 6.0f));
  EXPECT_TRUE(box && Vector2(5.0f, 6.0f));
  EXPECT_EQ(box.GetWidth(), 0.0f);
}

TEST(Aabb2D, BoxesMeetExactlyIfBothTheirShadowsOverlap) {
  int met = 0, touching = 0;
  ForEachCase(22, 200000, [&](CRandom& random, int) {
    const float ax0 = Coarse(random), ax1 = Coarse(random), ay0 = Coarse(random), ay1 = Coarse(random);
    const float bx0 = Coarse(random), bx1 = Coarse(random), by0 = Coarse(random), by1 = Coarse(random);
    const CAabb2D a = Box(ax0, ay0, ax1, ay1), b = Box(bx0, by0, bx1, by1);
    const auto gap = [](float a0, float a1, float b0, float b1) { // above 0 if disjoint, 0 if touching
      return std::max(std::min(b0, b1) - std::max(a0, a1), std::min(a0, a1) - std::max(b0, b1));
    };
    const float apart = std::max(gap(ax0, ax1, bx0, bx1), gap(ay0, ay1, by0, by1));
    ASSERT_EQ(a && b, apart <= 0.0f);
    ASSERT_EQ(b && a, a && b);
    met += apart <= 0.0f;
    touching += apart == 0.0f;
  });
  EXPECT_GT(met, 20000); // the trial is of use: both answers occur, and edges that coincide
  EXPECT_LT(met, 180000);
  EXPECT_GT(touching, 2000);
}

TEST(Aabb2D, EdgesAndCornersBelongToTheBox) {
  const CAabb2D box = Box(-1.0f, 2.0f, 3.0f, -4.0f);
  for (const Vector2& p : {Vector2(-1, 2), Vector2(3, 2), Vector2(-1, -4), Vector2(3, -4), Vector2(0, 2)})
    EXPECT_TRUE(box && p) << p.transpose();
  for (const Vector2& p : {Vector2(-1.001f, 0), Vector2(3.001f, 0), Vector2(0, 2.001f), Vector2(0, -4.001f)})
    EXPECT_FALSE(box && p) << p.transpose();
}

TEST(Aabb2D, NanNeverIntersects) {
  const CWithoutTraps onPurpose;
  // The four ways to miss, negated: the same as the library's test for numbers, but true for NaN.
  const auto naive = [](const CAabb2D& a, const CAabb2D& b) {
    return !(a.GetBottomRt().x() < b.GetTopLeft().x() || a.GetTopLeft().x() > b.GetBottomRt().x() ||
             a.GetBottomRt().y() > b.GetTopLeft().y() || a.GetTopLeft().y() < b.GetBottomRt().y());
  };
  const CAabb2D good = Box(-1.0f, 1.0f, 1.0f, -1.0f);
  for (int i = 0; i < 4; ++i) {
    float c[4] = {-1.0f, 1.0f, 1.0f, -1.0f};
    c[i] = g_fNan;
    const CAabb2D bad = Box(c[0], c[1], c[2], c[3]);
    EXPECT_TRUE(naive(good, bad)) << i;
    EXPECT_FALSE(good && bad) << i;
    EXPECT_FALSE(bad && good) << i;
    EXPECT_FALSE(bad && Vector2(0.0f, 0.0f)) << i;
  }
  EXPECT_FALSE(good && Vector2(g_fNan, 0.0f));
  EXPECT_FALSE(good && Vector2(0.0f, g_fNan));
  CAabb2D grown = good;
  grown += Vector2(g_fNan, 0.0f);
  grown += Vector2(0.0f, 0.0f);
  EXPECT_FALSE(grown && good); // once taken in it stays
}

} // namespace
} // namespace Shapes
