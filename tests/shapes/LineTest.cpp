// SPDX-License-Identifier: MIT
#include <Shapes/Line.h>
#include <Shapes/LineSeg.h>

#include "../Numbers.h"
#include "../geometry/Cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Shapes {
namespace {

using Tests::CRandom;
using Tests::ForEachCase;

TEST(Line, InterceptsFollowTheirFormulas) {
  const CLine line({2.0f, 1.0f}, 0.5f); // y = x/2, x = 2y
  EXPECT_FLOAT_EQ(line.GetGradient(), 0.5f);
  EXPECT_FLOAT_EQ(line.GetInverseGradient(), 2.0f);
  EXPECT_NEAR(line.GetYIntercept(), 0.0f, 2 * g_fUlp);
  EXPECT_NEAR(line.GetXIntercept(), 0.0f, 4 * g_fUlp);
}

TEST(Line, VerticalLineHasInfiniteGradientOfOneSign) {
  for (const float m : {g_fInf, -g_fInf}) {
    const CLine line({3.0f, 5.0f}, m);
    EXPECT_EQ(line.GetGradient(), g_fInf);
    EXPECT_EQ(line.GetInverseGradient(), 0.0f);
    EXPECT_EQ(line.GetYIntercept(), g_fInf);
    EXPECT_EQ(line.GetXIntercept(), 3.0f);
  }
}

TEST(Line, HorizontalLineHasInfiniteInverseGradient) {
  const CLine line({3.0f, 5.0f}, 0.0f);
  EXPECT_EQ(line.GetGradient(), 0.0f);
  EXPECT_EQ(line.GetInverseGradient(), g_fInf);
  EXPECT_EQ(line.GetXIntercept(), g_fInf);
  EXPECT_EQ(line.GetYIntercept(), 5.0f);
}

TEST(Line, VerticalLineIsComputedWithoutItsGradient) {
  // y = m x + b of the line x = 0, in its own numbers.
  const float m = g_fInf, x = 0.0f;
  EXPECT_TRUE(std::isnan(m * x + (5.0f - x * m)));

  const CLine line({0.0f, 5.0f}, g_fInf);
  EXPECT_EQ(line.ClosestPt({7.0f, -2.0f}), Vector2(0.0f, -2.0f));
  EXPECT_EQ(line.Intersect(CLine({4.0f, 1.0f}, 0.0f)), Vector2(0.0f, 1.0f));
  EXPECT_EQ(CLine({4.0f, 1.0f}, 0.0f).Intersect(line), Vector2(0.0f, 1.0f));
  const Vector2 p = line.Intersect(CLine({2.0f, 2.0f}, 1.0f));
  EXPECT_NEAR(p.x(), 0.0f, 4 * g_fUlp);
  EXPECT_NEAR(p.y(), 0.0f, 16 * g_fUlp);
}

TEST(Line, ParallelLinesHaveNoIntersection) {
  ForEachCase(32, 1000, [&](CRandom& random, int) {
    const float m = random.SignedScale(-30, 30);
    const CLine a(random.InSquare(100.0f), m), b(random.InSquare(100.0f), m);
    EXPECT_EQ(a.Intersect(b), Vector2(g_fInf, g_fInf)) << m;
  });
  // Vertical lines of either sign of infinity are parallel, though their gradients are not equal.
  EXPECT_EQ(CLine({1.0f, 0.0f}, g_fInf).Intersect(CLine({2.0f, 0.0f}, -g_fInf)), Vector2(g_fInf, g_fInf));
  EXPECT_EQ(CLine({1.0f, 0.0f}, 0.0f).Intersect(CLine({1.0f, 3.0f}, -0.0f)), Vector2(g_fInf, g_fInf));
}

} // namespace
} // namespace Shapes
