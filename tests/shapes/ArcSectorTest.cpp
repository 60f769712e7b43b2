// SPDX-License-Identifier: MIT
// Which points lie in the sector of an arc (Arc.cpp).
#include <Shapes/Arc.h>

#include "../Numbers.h"
#include "../geometry/Cases.h"
#include "MakeShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Shapes {
namespace {

using Tests::CRandom;
using Tests::ForEachCase;

CArc RandomArc(CRandom& random) {
  const float r = random.Scale(-4, 4), a0 = random.Uniform(0.0f, 6.28f), a1 = random.Uniform(0.0f, 6.28f);
  return Arc({0.0f, 0.0f}, r, a0, a1);
}

TEST(ArcSector, TheCentreAndRaysOfAnyLengthAreInsideWithinRounding) {
  ForEachCase(93, 20000, [&](CRandom& random, int) {
    const CArc arc = RandomArc(random);
    EXPECT_TRUE(arc.PtInSector(arc.GetPos()));
    for (const Vector2& end : {arc.GetEndPt0(), arc.GetEndPt1()})
      EXPECT_TRUE(arc.PtInSector(random.Scale(-8, 8) * end));
  });
}

TEST(ArcSector, WhatIsOppositeToAShortArcIsOutside) {
  // Both ends round to the same float, or the span is below the rounding of a cross product.
  const CArc far = Arc({1000.0f, 1000.0f}, 1.0f, 0.0f, 1e-5f);
  EXPECT_TRUE(far.PtInSector({1001.0f, 1000.0f}));
  EXPECT_FALSE(far.PtInSector({999.0f, 1000.0f}));
  EXPECT_FALSE(far.PtInSector({998.0f, 1000.0f}));
  const CArc tiny = Arc({0.0f, 0.0f}, 1.0f, g_fPi / 4, std::nextafter(g_fPi / 4, 1.0f));
  EXPECT_FALSE(tiny.PtInSector(-tiny.GetEndPt0()));
  EXPECT_LE(far.GetAABB().GetWidth(), 1e-4f);
}

TEST(ArcSector, ShortArcsAreMet) {
  const CArc arc = Arc({0.0f, 0.0f}, 1.0f, 0.0f, 1e-7f);
  EXPECT_FALSE(arc.IsFullCircle());
  EXPECT_TRUE(arc.PtInSector({1.09f, 0.0f}));
  EXPECT_FALSE(arc.PtInSector({-1.09f, 0.0f}));
  EXPECT_FALSE(arc.PtInSector({0.0f, 1.0f}));
}

TEST(ArcSector, ASlitIsOutsideAndTheRestInside) {
  const CArc arc = Arc({0.0f, 0.0f}, 1.0f, 1e-3f, g_fTwoPi - 1e-3f);
  EXPECT_FALSE(arc.PtInSector({1.0f, 0.0f}));
  EXPECT_TRUE(arc.PtInSector({-1.0f, 0.0f}));
  EXPECT_TRUE(arc.PtInSector({1.0f, 0.002f}));
  EXPECT_TRUE(arc.PtInSector({1.0f, -0.002f}));
}

// The float next to pi is larger than pi, and so is the angle between the rounded ends: by 8.7e-8.
TEST(ArcSector, BothEndRaysOfHalfATurnBelongToIt) {
  for (const float r : {1.0f, 3.0f}) {
    const CArc arc = Arc({0.0f, 0.0f}, r, 0.0f, g_fPi);
    ASSERT_LT(arc.GetEndPt1().y(), 0.0f);
    for (const float far : {0.5f, 1.25f, 8.0f}) {
      EXPECT_TRUE(arc.PtInSector(far * arc.GetEndPt0())) << far;
      EXPECT_TRUE(arc.PtInSector(far * arc.GetEndPt1())) << far;
    }
    const float beyond = 10 * 1.2e-7f * r; // the bound of PtInSector
    EXPECT_FALSE(arc.PtInSector({r, -beyond}));
    EXPECT_FALSE(arc.PtInSector({-r, -beyond}));
    // The complement has the same end rays.
    const CArc below = Arc({0.0f, 0.0f}, r, g_fPi, 0.0f);
    EXPECT_TRUE(below.PtInSector(8.0f * below.GetEndPt0()));
    EXPECT_TRUE(below.PtInSector(8.0f * below.GetEndPt1()));
    EXPECT_FALSE(below.PtInSector({r, beyond}));
    EXPECT_FALSE(below.PtInSector({-r, beyond}));
  }
}

TEST(ArcSector, AcrossTheZeroAngleNothingIsLost) {
  const CArc arc = Arc({0.0f, 0.0f}, 1.0f, 350 * g_fPi / 180, 10 * g_fPi / 180);
  EXPECT_TRUE(arc.PtInSector({2.0f, 0.0f}));
  EXPECT_TRUE(arc.PtInSector({2.0f, 1e-9f}));
  EXPECT_TRUE(arc.PtInSector({2.0f, -1e-9f}));
  EXPECT_FALSE(arc.PtInSector({-2.0f, 0.0f}));
  EXPECT_FALSE(arc.PtInSector({0.0f, 2.0f}));
}

} // namespace
} // namespace Shapes
