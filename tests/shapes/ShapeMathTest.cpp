// SPDX-License-Identifier: MIT
#include <Shapes/ShapeMath.h>

#include "../Testing.h"

namespace Shapes {
namespace {

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

TEST(ShapeMath, PerpTurnsCounterclockwiseAndIsExact) {
  EXPECT_EQ(perp({1.0f, 0.0f}), Vector2(0.0f, 1.0f));
  EXPECT_EQ(perp({0.0f, 1.0f}), Vector2(-1.0f, 0.0f));
  ForEachCase(11, 1000, [&](CRandom& random, int) {
    const Vector2 v = random.Vector(-60, 60);
    EXPECT_EQ(perp(perp(v)), -v);
    EXPECT_EQ(Length(perp(v)), Length(v));
    EXPECT_EQ(v.dot(perp(v)), 0.0f);
  });
}

TEST(ShapeMath, ZeroHasNoLengthNothingAlongItAndTheFallbackAsItsDirection) {
  EXPECT_EQ(Length(Vector2::Zero()), 0.0f);
  EXPECT_EQ(Normalize(Vector2::Zero()), Vector2(0.0f, 1.0f));
  EXPECT_EQ(Normalize(Vector2(-0.0f, 0.0f), {1.0f, 0.0f}), Vector2(1.0f, 0.0f));
  EXPECT_EQ(ParallelComponent({3.0f, -4.0f}, Vector2::Zero()), Vector2::Zero());
}

TEST(ShapeMath, NormalizeAngleStaysBelowTwoPiInFloat) {
  // Adding 2 pi to a tiny negative angle rounds to a float above 2 pi.
  const float naive = -1e-9f + g_fTwoPi;
  EXPECT_GE(Wide(naive), 2 * EIGEN_PI);
  EXPECT_EQ(NormalizeAngle(-1e-9f), 0.0f);
  EXPECT_FALSE(std::signbit(NormalizeAngle(-0.0f)));
  ForEachCase(17, 100000, [&](CRandom& random, int) {
    const float a = random.SignedScale(-149, 127);
    const float n = NormalizeAngle(a);
    EXPECT_GE(n, 0.0f) << a;
    EXPECT_LT(Wide(n), 2 * EIGEN_PI) << a;
    EXPECT_EQ(NormalizeAngle(n), n) << a;
  });
  for (const float a : {g_fTwoPi, -g_fTwoPi, std::nextafter(g_fTwoPi, 0.0f), -std::nextafter(g_fTwoPi, 0.0f)})
    EXPECT_LT(Wide(NormalizeAngle(a)), 2 * EIGEN_PI) << a;
}

TEST(ShapeMath, NormalizeAngleHandsBackWhatIsNotFinite) {
  EXPECT_EQ(NormalizeAngle(g_fInf), g_fInf);
  EXPECT_EQ(NormalizeAngle(-g_fInf), -g_fInf);
  EXPECT_TRUE(std::isnan(NormalizeAngle(g_fNan)));
}

} // namespace
} // namespace Shapes
