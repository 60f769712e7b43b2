// SPDX-License-Identifier: MIT
// Numbers for fields: distributions of the standard library differ between libraries.
#pragma once

#include <random>

namespace Shapes::Compare::Benchmark {

class CRandom {
public:
  /// Of the top 24 bits.
  float operator()(float low, float high) {
    return low + (high - low) * static_cast<float>(m_stdTwister() >> 8) * 0x1p-24f;
  }

private:
  std::mt19937 m_stdTwister{1};
};

} // namespace Shapes::Compare::Benchmark
