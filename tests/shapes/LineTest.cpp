// SPDX-License-Identifier: MIT
#include <Shapes/Line.h>
#include <Shapes/LineSeg.h>

#include "../Numbers.h"
#include "../Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace Shapes {
namespace {

using Tests::CRandom;

// Closest point as the crossing with the line of gradient -1/m through q, all in gradients and intercepts.
Vector2 NaiveClosestPt(const Vector2& p, float m, const Vector2& q) {
  const float m1 = -1.0f / m, b0 = p.y() - p.x() * m, b1 = q.y() - q.x() * m1;
  const float x = (b1 - b0) / (m - m1);
  return {x, m * x + b0};
}

TEST(Line, InterceptsFollowTheirFormulas) {
  const CLine line({2.0f, 1.0f}, 0.5f); // y = x/2, x = 2y
  EXPECT_FLOAT_EQ(line.GetGradient(), 0.5f);
  EXPECT_FLOAT_EQ(line.GetInverseGradient(), 2.0f);
  EXPECT_NEAR(line.GetYIntercept(), 0.0f, 2 * g_fUlp);
  EXPECT_NEAR(line.GetXIntercept(), 0.0f, 4 * g_fUlp);
  CRandom random(31);
  for (int i = 0; i < 1000; ++i) {
    const Vector2 p = random.InSquare(10.0f);
    const float m = random.SignedScale(-3, 3);
    const CLine l(p, m);
    // y = m x + b and x = y/m + c at two places; b and c are different numbers.
    const double b = l.GetYIntercept(), c = l.GetXIntercept();
    EXPECT_NEAR(p.y(), m * p.x() + b, 16 * g_fUlp * 200) << "seed " << random.GetSeed();
    EXPECT_NEAR(p.x(), p.y() / m + c, 16 * g_fUlp * 200);
    EXPECT_NEAR(b, -m * c, 32 * g_fUlp * 400);
  }
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
  CRandom random(32);
  for (int i = 0; i < 1000; ++i) {
    const float m = random.SignedScale(-30, 30);
    const CLine a(random.InSquare(100.0f), m), b(random.InSquare(100.0f), m);
    EXPECT_EQ(a.Intersect(b), Vector2(g_fInf, g_fInf)) << m << " seed " << random.GetSeed();
  }
  // Vertical lines of either sign of infinity are parallel, though their gradients are not equal.
  EXPECT_EQ(CLine({1.0f, 0.0f}, g_fInf).Intersect(CLine({2.0f, 0.0f}, -g_fInf)), Vector2(g_fInf, g_fInf));
  EXPECT_EQ(CLine({1.0f, 0.0f}, 0.0f).Intersect(CLine({1.0f, 3.0f}, -0.0f)), Vector2(g_fInf, g_fInf));
}

TEST(Line, IntersectionErrorGrowsWithOneOverTheSine) {
  CRandom random(33);
  for (int i = 0; i < 20000; ++i) {
    const Vector2 p = random.InSquare(100.0f), q = random.InSquare(100.0f);
    const float m0 = random.SignedScale(-8, 8);
    const float m1 = random.SignedScale(-8, 8);
    const Vector2d t0 = Vector2d(1.0, m0).normalized(), t1 = Vector2d(1.0, m1).normalized();
    const double sine = t0.x() * t1.y() - t0.y() * t1.x();
    if (std::abs(sine) < 1e-4) continue;
    const Vector2d d = Wide(q) - Wide(p);
    const double s = (d.x() * t1.y() - d.y() * t1.x()) / sine;
    const Vector2d exact = Wide(p) + s * t0;
    const double scale = Wide(p).norm() + d.norm() + std::abs(s);
    EXPECT_LE((Wide(CLine(p, m0).Intersect(CLine(q, m1))) - exact).norm(),
              8 * g_fUlp * scale / std::abs(sine))
        << "seed " << random.GetSeed();
  }
}

TEST(Line, ClosestPtKeepsItsErrorBoundInEveryDirection) {
  CRandom random(34);
  for (int i = 0; i < 50000; ++i) {
    const Vector2 p = random.Vector(-10, 12);
    const Vector2 q = random.Vector(-10, 12);
    const float m = i % 10 == 0 ? g_fInf : random.SignedScale(-40, 40);
    const Vector2d t = std::isinf(m) ? Vector2d(0.0, 1.0) : Vector2d(1.0, m).normalized();
    const Vector2d exact = Wide(p) + (Wide(q) - Wide(p)).dot(t) * t;
    EXPECT_LE((Wide(CLine(p, m).ClosestPt(q)) - exact).norm(),
              8 * g_fUlp * (Wide(q).norm() + (Wide(q) - Wide(p)).norm()))
        << "m " << m << " seed " << random.GetSeed();
  }
}

TEST(Line, ClosestPtOfANearlyVerticalLineDoesNotGoThroughItsGradient) {
  const Vector2 p0(500.0f, 0.0f), p1(500.001f, 600.0f), q(510.0f, 300.0f);
  const Vector2d t = (Wide(p1) - Wide(p0)).normalized();
  const Vector2d exact = Wide(p0) + (Wide(q) - Wide(p0)).dot(t) * t;
  const Vector2 naive = NaiveClosestPt(p0, (p1.y() - p0.y()) / (p1.x() - p0.x()), q);
  EXPECT_NEAR((Wide(naive) - exact).norm(), 12.0, 0.5);
  const Vector2 closest = CLineSeg(CLineSegDesc(p0, p1)).ClosestPt(q);
  EXPECT_LE((Wide(closest) - exact).norm(), 8 * g_fUlp * (Wide(q).norm() + 600.0));
  EXPECT_NEAR(closest.x(), 500.0005f, 1e-3);
  EXPECT_NEAR(closest.y(), 300.0000167f, 1e-3);
}

TEST(Line, ClosestPtOfAHorizontalLineDoesNotGoThroughItsGradient) {
  const Vector2 naive = NaiveClosestPt({0.0f, 0.0f}, 0.0f, {0.5f, 0.5f}); // -1/0 is -Inf
  EXPECT_FALSE(naive.allFinite());
  const Vector2 closest = CLineSeg(CLineSegDesc({0.0f, 0.0f}, {1.0f, 0.0f})).ClosestPt({0.5f, 0.5f});
  EXPECT_NEAR(closest.x(), 0.5f, 4 * g_fUlp);
  EXPECT_NEAR(closest.y(), 0.0f, 4 * g_fUlp);
}

TEST(Line, HugeAndTinyGradientsComeBack) {
  CRandom random(35);
  for (int i = 0; i < 1000; ++i) {
    const float m = random.SignedScale(-60, 60);
    EXPECT_NEAR(CLine({0.0f, 0.0f}, m).GetGradient() / m, 1.0, 4 * g_fUlp) << "seed " << random.GetSeed();
  }
}

} // namespace
} // namespace Shapes
