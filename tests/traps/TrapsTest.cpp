// SPDX-License-Identifier: MIT
// That what is to stop the program does, and nothing else: the control of a suite that passes with traps.
#include "../Testing.h"
#include "Naive.h"

#include "traps/Traps.h"

#include <cfenv>
#include <csignal>
#include <xmmintrin.h>

namespace Shapes::Tests {
namespace {

constexpr float g_fMax = std::numeric_limits<float>::max();
const testing::KilledBySignal g_cDies(SIGFPE);

TEST(TrapsDeathTest, WhatIsNotANumberStopsTheProgram) {
  EXPECT_EXIT(Quotient(0, 0), g_cDies, "");
  EXPECT_EXIT(Quotient(1, 0), g_cDies, "");
  EXPECT_EXIT(Product(g_fMax, 2), g_cDies, "");
  EXPECT_EXIT(IsLess(g_fNan, 1), g_cDies, "");
  const float infinity = std::numeric_limits<float>::infinity();
  CAabb2D box(Vector2(0, 1), Vector2(infinity, 0));
  EXPECT_EXIT(box.Translate(Vector2(-infinity, 0)), g_cDies, ""); // in the library
}

TEST(TrapsTest, WhatIsANumberDoesNot) {
  EXPECT_EQ(Quotient(1, 3), 1.0f / 3.0f); // inexact
  EXPECT_EQ(Quotient(std::numeric_limits<float>::denorm_min(), 2), 0.0f);
  EXPECT_FALSE(IsLess(std::numeric_limits<float>::infinity(), 1));
}

TEST(TrapsTest, NothingElseIsTrapped) {
  const volatile float zero = 0;
  const float nan = zero / zero;
  EXPECT_TRUE(nan != nan);
  EXPECT_EQ(Quotient(1, 2), 0.5f); // what was raised before does not trap now
  const CWithoutTraps onPurpose;
  EXPECT_TRUE(Quotient(0, 0) != 0);
  EXPECT_FALSE(IsLess(g_fNan, 1));
}

// What SSE traps now.
unsigned GetTrapped() { return ~_mm_getcsr() & (_MM_MASK_INVALID | _MM_MASK_DIV_ZERO | _MM_MASK_OVERFLOW); }

TEST(TrapsTest, AnExceptionLeavesTheLibraryWithoutThem) {
  EXPECT_EQ(GetTrapped(), 0u);
  EXPECT_THROW(CCircle(CCircleDesc({0, 0}, g_fNan)), std::invalid_argument);
  EXPECT_EQ(GetTrapped(), 0u);
}

TEST(TrapsTest, WhoHasThemOnKeepsThem) {
  std::feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(FE_DIVBYZERO);
  EXPECT_EQ(Quotient(1, 2), 0.5f);
  EXPECT_EQ(GetTrapped(), unsigned{_MM_MASK_DIV_ZERO});
  fedisableexcept(FE_DIVBYZERO);
}

} // namespace
} // namespace Shapes::Tests
