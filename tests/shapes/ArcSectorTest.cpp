// SPDX-License-Identifier: MIT
// Which points lie in the sector of an arc (Arc.cpp).
#include <Shapes/Arc.h>

#include "../Numbers.h"
#include "../Random.h"
#include "MakeShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Shapes {
namespace {

using Tests::CRandom;

CArc RandomArc(CRandom& random) {
  const float r = random.Scale(-4, 4), a0 = random.Uniform(0.0f, 6.28f), a1 = random.Uniform(0.0f, 6.28f);
  return Arc({0.0f, 0.0f}, r, a0, a1);
}

TEST(ArcSector, OwnEndsAreAlwaysInside) {
  CRandom random(91);
  const auto check = [&](float span) {
    const Vector2 c = random.Vector(-10, 24);
    const float a0 = random.Uniform(0.0f, 6.28f);
    const CArc arc = Arc(c, random.Scale(-10, 10), a0, a0 + span);
    EXPECT_TRUE(arc.PtInSector(arc.GetEndPt0())) << "span " << span << " seed " << random.GetSeed();
    EXPECT_TRUE(arc.PtInSector(arc.GetEndPt1())) << "span " << span << " seed " << random.GetSeed();
  };
  for (int i = 0; i < 5000; ++i) {
    check(random.Uniform(0.0f, 6.28f));
    check(random.Scale(-30, -4));               // tiny
    check(g_fPi + random.SignedScale(-21, -4)); // close to pi
    check(g_fTwoPi - random.Scale(-20, -4));    // close to 2 pi
  }
}

TEST(ArcSector, EndRaysAndTheCentreAreInside) {
  // Angles as atan2 gives them lose exact end rays: both the stored angle and the one computed are rounded.
  CRandom random(92);
  int rays = 0, naiveLost = 0;
  for (int i = 0; i < 20000; ++i) {
    const CArc arc = RandomArc(random);
    EXPECT_TRUE(arc.PtInSector(arc.GetPos()));
    for (const Vector2& end : {arc.GetEndPt0(), arc.GetEndPt1()}) {
      const Vector2 p = std::ldexp(1.0f, static_cast<int>(random.Below(9)) - 4) * end; // exactly on the ray
      float a = std::atan2(p.y(), p.x());
      if (a < 0.0f) a += g_fTwoPi;
      const float a0 = arc.GetAngle0(), a1 = arc.GetAngle1();
      naiveLost += !(a0 < a1 ? a0 <= a && a <= a1 : a0 <= a || a <= a1);
      ++rays;
      EXPECT_TRUE(arc.PtInSector(p)) << "seed " << random.GetSeed();
    }
  }
  RecordProperty("naive_lost", naiveLost);
  EXPECT_GT(naiveLost, rays / 10); // measured: 5,681 of 40,000
}

TEST(ArcSector, RaysOfAnyLengthAreInsideWithinRounding) {
  CRandom random(93);
  for (int i = 0; i < 20000; ++i) {
    const CArc arc = RandomArc(random);
    for (const Vector2& end : {arc.GetEndPt0(), arc.GetEndPt1()})
      EXPECT_TRUE(arc.PtInSector(random.Scale(-8, 8) * end)) << "seed " << random.GetSeed();
  }
}

TEST(ArcSector, AgreesWithAnglesAwayFromTheEndRays) {
  CRandom random(94);
  int inside = 0, outside = 0;
  for (int i = 0; i < 200000; ++i) {
    const Vector2 c = random.Vector(-6, 12);
    const float R = random.Scale(-4, 6), a0 = random.Uniform(0.0f, 6.28f);
    float span = random.Uniform(0.01f, 6.27f);
    switch (random.Below(4)) {
    case 0: span = random.Scale(-18, -4); break;
    case 1: span = g_fPi + random.SignedScale(-21, -4); break;
    case 2: span = g_fTwoPi - random.Scale(-18, -4); break;
    default: break;
    }
    const CArcDesc desc(c, R, a0, a0 + span);
    if (desc.GetAngle0() == desc.GetAngle1()) continue;
    const CArc arc(desc);
    // Opposite to an end as often as anywhere: that is where a cross product alone cannot tell.
    Vector2 p = c + random.Vector(-4, 6);
    if (random.Below(4) == 0) p = c - random.Scale(-2, 2) * (arc.GetEndPt0() - c);
    const Vector2d u = Wide(p) - Wide(c);
    const double slack =
        8 * g_fUlp * (1.0 + (Wide(c).norm() + 1.0) * (1 / static_cast<double>(R) + 1 / u.norm()));
    double a = std::atan2(u.y(), u.x()) - static_cast<double>(desc.GetAngle0());
    while (a < 0.0)
      a += g_fPi2;
    const double exactSpan = [&] {
      const double s = static_cast<double>(desc.GetAngle1()) - static_cast<double>(desc.GetAngle0());
      return s > 0.0 ? s : s + g_fPi2;
    }();
    if (a < slack || a > g_fPi2 - slack || std::abs(a - exactSpan) < slack) continue;
    ASSERT_EQ(arc.PtInSector(p), a < exactSpan)
        << "centre (" << c.transpose() << ") R " << R << " angles " << desc.GetAngle0() << ' '
        << desc.GetAngle1() << " p (" << p.transpose() << ") seed " << random.GetSeed();
    ++(a < exactSpan ? inside : outside);
  }
  EXPECT_GT(inside, 20000);
  EXPECT_GT(outside, 20000);
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
