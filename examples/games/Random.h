// SPDX-License-Identifier: MIT
// Random numbers that are the same on every compiler: a linear congruential generator of 64 bits.
#pragma once

#include <cstdint>

namespace Shapes::Games {

class CRandom {
public:
  explicit CRandom(std::uint32_t seed) : m_nState(seed * 0x9E3779B97F4A7C15u + 1) {}

  /// From [low, high).
  float operator()(float low, float high) {
    m_nState = m_nState * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (static_cast<float>(m_nState >> 40) / 16777216.0f);
  }

private:
  std::uint64_t m_nState;
};

} // namespace Shapes::Games
