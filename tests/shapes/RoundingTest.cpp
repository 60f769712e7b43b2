// SPDX-License-Identifier: MIT
// That a double which is put into a float and taken out again has been rounded. g++ 12 with -O2 takes pairs
// of them (a vector!) for what they were before, unless it is told not to vectorise straight code.
#include <gtest/gtest.h>

// Seen from outside, so that it is compiled for any argument.
void RoundPair(const double* v, double* w);
void RoundPair(const double* v, double* w) {
  const float x = static_cast<float>(v[0]), y = static_cast<float>(v[1]);
  w[0] = static_cast<double>(x);
  w[1] = static_cast<double>(y);
}

namespace {

TEST(Rounding, PairsOfDoublesAreRoundedToFloat) {
  void (*volatile pRound)(const double*, double*) = RoundPair;
  const double v[2] = {0.1, 1.0 / 3.0};
  double w[2];
  pRound(v, w);
  EXPECT_EQ(w[0], 0x1.99999ap-4);
  EXPECT_EQ(w[1], 0x1.555556p-2);
}

} // namespace
