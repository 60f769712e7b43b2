// SPDX-License-Identifier: MIT
// Random cases of one test.
#pragma once

#include "../Random.h"

#include <gtest/gtest.h>

namespace Shapes::Tests {

/// Calls f with random numbers and the number of the case; stops after the first one that fails, and names
/// it.
template <class F>
void ForEachCase(std::uint64_t seed, int n, F f) {
  CRandom random(seed);
  for (int i = 0; i < n; ++i) {
    f(random, i);
    if (!testing::Test::HasFailure()) continue;
    ADD_FAILURE() << "in case " << i << " of seed " << seed;
    return;
  }
}

} // namespace Shapes::Tests
