// SPDX-License-Identifier: MIT
#include <Shapes/ShapeMath.h>

#include "../Numbers.h"
#include "../Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace Shapes {
namespace {

using Tests::CRandom;

// The macro as a bare if: what it swallows is shown below.
#define NaiveFailIf(x)                                                                                       \
  if (x) return false;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdangling-else"
// Both mean: true unless `guarded`; if guarded, false.
bool NaiveElse(bool guarded, bool bad) {
  if (guarded) NaiveFailIf(bad) else return true;
  return false;
}
#pragma GCC diagnostic pop

bool SafeElse(bool guarded, bool bad) {
  if (guarded)
    FailIf(bad);
  else
    return true;
  return false;
}

TEST(ShapeMath, FailIfDoesNotTakeTheElseOfItsCaller) {
  EXPECT_TRUE(SafeElse(false, false));
  EXPECT_FALSE(SafeElse(true, false));
  EXPECT_FALSE(SafeElse(true, true));
  EXPECT_FALSE(NaiveElse(false, false)); // the else went to the macro's if
  EXPECT_TRUE(NaiveElse(true, false));
}

TEST(ShapeMath, FailIfConditionsCanRefuseNan) {
  const auto naive = [](float d, float r) {
    FailIf(d >= r);
    return true;
  };
  const auto safe = [](float d, float r) {
    FailIf(!(d < r));
    return true;
  };
  EXPECT_TRUE(naive(g_fNan, 1.0f)); // NaN is let through
  EXPECT_FALSE(safe(g_fNan, 1.0f));
  EXPECT_FALSE(safe(0.0f, g_fNan));
  EXPECT_TRUE(safe(0.5f, 1.0f));
}

TEST(ShapeMath, PerpTurnsCounterclockwiseAndIsExact) {
  EXPECT_EQ(perp({1.0f, 0.0f}), Vector2(0.0f, 1.0f));
  EXPECT_EQ(perp({0.0f, 1.0f}), Vector2(-1.0f, 0.0f));
  CRandom random(11);
  for (int i = 0; i < 1000; ++i) {
    const Vector2 v = random.Vector(-60, 60);
    EXPECT_EQ(perp(perp(v)), -v) << "seed " << random.GetSeed();
    EXPECT_EQ(Length(perp(v)), Length(v));
    EXPECT_EQ(v.dot(perp(v)), 0.0f);
  }
}

TEST(ShapeMath, CrossIsPositiveCounterclockwiseAndZeroOnItself) {
  EXPECT_EQ(Cross({1.0f, 0.0f}, {0.0f, 1.0f}), 1.0f);
  EXPECT_EQ(Cross({0.0f, 1.0f}, {1.0f, 0.0f}), -1.0f);
  CRandom random(12);
  for (int i = 0; i < 10000; ++i) {
    const Vector2 a = random.Vector(-20, 20), b = random.Vector(-20, 20);
    EXPECT_EQ(Cross(a, a), 0.0f);
    const double up = Wide(a.x()) * Wide(b.y()), down = Wide(a.y()) * Wide(b.x());
    EXPECT_NEAR(Cross(a, b), up - down, g_fUlp * (std::abs(up) + std::abs(down)))
        << "seed " << random.GetSeed();
  }
}

TEST(ShapeMath, LengthNeitherOverflowsNorUnderflows) {
  const auto naive = [](const Vector2& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); };
  EXPECT_EQ(naive({1e-23f, 0.0f}), 0.0f);
  EXPECT_EQ(naive({2e19f, 0.0f}), g_fInf);
  EXPECT_EQ(Length({1e-23f, 0.0f}), 1e-23f);
  EXPECT_EQ(Length({2e19f, 0.0f}), 2e19f);
  EXPECT_EQ(Length({3.0f, 4.0f}), 5.0f);
  EXPECT_EQ(Length(Vector2::Zero()), 0.0f);
  EXPECT_EQ(Length({std::numeric_limits<float>::denorm_min(), 0.0f}),
            std::numeric_limits<float>::denorm_min());
  CRandom random(13);
  for (int i = 0; i < 10000; ++i) {
    const Vector2 v = random.Vector(-120, 125);
    const double exact = Wide(v).norm();
    EXPECT_NEAR(Length(v), exact, 2 * g_fUlp * exact) << "seed " << random.GetSeed();
  }
}

TEST(ShapeMath, NormalizeGivesUnitLengthAtEveryScale) {
  const auto naive = [](const Vector2& v) { return Vector2(v / std::sqrt(v.x() * v.x() + v.y() * v.y())); };
  EXPECT_FALSE(naive({1e-30f, 0.0f}).allFinite()); // the square underflows
  CRandom random(14);
  for (int i = 0; i < 20000; ++i) {
    const float scale = random.Scale(-149, 126);
    const Vector2 v = scale * random.Direction();
    if (v == Vector2::Zero()) continue;
    const Vector2 n = Normalize(v);
    EXPECT_NEAR(Wide(n).norm(), 1.0, 2 * g_fUlp) << v.transpose() << " seed " << random.GetSeed();
    const Vector2d exact = Wide(v) / Wide(v).norm();
    EXPECT_LE((Wide(n) - exact).norm(), g_fUlp) << v.transpose() << " seed " << random.GetSeed();
  }
}

TEST(ShapeMath, NormalizeOfZeroGivesTheFallback) {
  EXPECT_EQ(Normalize(Vector2::Zero()), Vector2(0.0f, 1.0f));
  EXPECT_EQ(Normalize(Vector2(-0.0f, 0.0f), {1.0f, 0.0f}), Vector2(1.0f, 0.0f));
}

TEST(ShapeMath, ParallelComponentLeavesARestAtRightAngles) {
  CRandom random(15);
  for (int i = 0; i < 10000; ++i) {
    const Vector2 v = random.Vector(-10, 10), w = random.Vector(-80, 60);
    const Vector2 p = ParallelComponent(v, w);
    const Vector2d what = Wide(w).normalized();
    const double size = Wide(v).norm();
    EXPECT_LE(std::abs(Wide(Vector2(v - p)).dot(what)), 4 * g_fUlp * size) << "seed " << random.GetSeed();
    EXPECT_LE(std::abs(Wide(p).dot(Vector2d(-what.y(), what.x()))), 4 * g_fUlp * size);
  }
  EXPECT_EQ(ParallelComponent({3.0f, -4.0f}, {0.0f, 2.0f}), Vector2(0.0f, -4.0f));
  EXPECT_EQ(ParallelComponent({3.0f, -4.0f}, Vector2::Zero()), Vector2::Zero());
}

TEST(ShapeMath, RotatePtKeepsItsErrorBound) {
  CRandom random(16);
  for (int i = 0; i < 20000; ++i) {
    const Vector2 c = random.Vector(-10, 10);
    const Vector2 p = c + random.Vector(-10, 10);
    const float a = random.Uniform(-100.0f, 100.0f);
    const Vector2d d = Wide(p) - Wide(c);
    const double cosine = std::cos(Wide(a)), sine = std::sin(Wide(a));
    const Vector2d exact = Wide(c) + Vector2d(cosine * d.x() - sine * d.y(), sine * d.x() + cosine * d.y());
    EXPECT_LE((Wide(RotatePt(p, c, a)) - exact).norm(), 3 * g_fUlp * (Wide(c).norm() + d.norm()))
        << "seed " << random.GetSeed();
  }
  EXPECT_EQ(RotatePt({3.0f, 4.0f}, {1.0f, 1.0f}, 0.0f), Vector2(3.0f, 4.0f));
}

TEST(ShapeMath, RotatePtByAHugeAngleKeepsTheRadius) {
  const Vector2 p = RotatePt({1.0f, 0.0f}, Vector2::Zero(), 1e6f);
  EXPECT_NEAR(Wide(p).norm(), 1.0, g_fUlp);
  const Vector2 reduced = RotatePt({1.0f, 0.0f}, Vector2::Zero(), NormalizeAngle(1e6f));
  EXPECT_LE((p - reduced).norm(), 8 * g_fUlp); // 1 ulp of an angle below 2 pi is 4 ulp of 1
}

TEST(ShapeMath, NormalizeAngleStaysBelowTwoPiInFloat) {
  // Adding 2 pi to a tiny negative angle rounds to a float above 2 pi.
  const float naive = -1e-9f + g_fTwoPi;
  EXPECT_GE(Wide(naive), 2 * EIGEN_PI);
  EXPECT_EQ(NormalizeAngle(-1e-9f), 0.0f);
  EXPECT_FALSE(std::signbit(NormalizeAngle(-0.0f)));
  CRandom random(17);
  for (int i = 0; i < 100000; ++i) {
    const float a = random.SignedScale(-149, 127);
    const float n = NormalizeAngle(a);
    EXPECT_GE(n, 0.0f) << a;
    EXPECT_LT(Wide(n), 2 * EIGEN_PI) << a << " seed " << random.GetSeed();
    EXPECT_EQ(NormalizeAngle(n), n) << a;
  }
  for (const float a : {g_fTwoPi, -g_fTwoPi, std::nextafter(g_fTwoPi, 0.0f), -std::nextafter(g_fTwoPi, 0.0f)})
    EXPECT_LT(Wide(NormalizeAngle(a)), 2 * EIGEN_PI) << a;
}

TEST(ShapeMath, NormalizeAngleKeepsItsErrorBound) {
  // 2 pi as a sum of two doubles; a - k hi is exact in one fused operation for the k in use here.
  constexpr double hi = 6.283185307179586477, lo = 2.449293598294706414e-16;
  CRandom random(18);
  double worst = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const float a = random.SignedScale(-20, 28);
    const double k = std::floor(Wide(a) / hi);
    const double exact = std::fma(-k, lo, std::fma(-k, hi, Wide(a)));
    const float n = NormalizeAngle(a);
    if (exact < 1e-6 || exact > 6.28318) continue; // which end of the range is a matter of rounding there
    const double ulp = Wide(std::nextafter(n, 10.0f)) - Wide(n);
    worst = std::max(worst, std::abs(Wide(n) - exact) / ulp);
  }
  EXPECT_LE(worst, 1.0) << "seed " << random.GetSeed();
}

TEST(ShapeMath, NormalizeAngleHandsBackWhatIsNotFinite) {
  EXPECT_EQ(NormalizeAngle(g_fInf), g_fInf);
  EXPECT_EQ(NormalizeAngle(-g_fInf), -g_fInf);
  EXPECT_TRUE(std::isnan(NormalizeAngle(g_fNan)));
}

TEST(ShapeMath, AngleToVectorIsWithinAnUlpOfEachComponent) {
  CRandom random(19);
  const auto ulp = [](float f) { return Wide(std::nextafter(std::abs(f), 10.0f)) - Wide(std::abs(f)); };
  for (int i = 0; i < 20000; ++i) {
    const float a = i == 0 ? g_fPi / 2 : random.Uniform(-50.0f, 50.0f);
    const Vector2 v = AngleToVector(a);
    EXPECT_NEAR(v.x(), static_cast<double>(std::cos(static_cast<long double>(a))), ulp(v.x())) << a;
    EXPECT_NEAR(v.y(), static_cast<double>(std::sin(static_cast<long double>(a))), ulp(v.y())) << a;
  }
}

} // namespace
} // namespace Shapes
