// SPDX-License-Identifier: MIT
// Random numbers that RapidCheck draws, for the inputs of bounds/. Where a property fails, it replaces them
// by simpler ones, toward sizes of 1 and the first of several kinds.
#pragma once

#include "../Testing.h"

#include <rapidcheck.h>

namespace Shapes::Properties {

/// With the members of CRandom.
class CDrawn {
public:
  std::uint32_t Below(std::uint32_t n) const { return *rc::gen::inRange(0u, n); }
  bool Coin() const { return *rc::gen::arbitrary<bool>(); }
  /// In [0, 1), a multiple of 2^-20.
  float Unit() const { return std::ldexp(static_cast<float>(Below(1u << 20)), -20); }
  float Uniform(float least, float most) const { return least + Unit() * (most - least); }
  /// An integer, toward 0.
  int Whole(int least, int most) const {
    const int simple = std::clamp(0, least, most), farthest = std::max(simple - least, most - simple);
    const int off = static_cast<int>(Below(static_cast<std::uint32_t>(farthest) + 1));
    const bool isUp = off <= most - simple && (off > simple - least || Coin());
    return isUp ? simple + off : simple - off;
  }
  float Scale(int leastExp, int mostExp) const {
    const int exponent = Whole(leastExp, mostExp);
    return std::ldexp(1.0f + Unit(), exponent);
  }
  float SignedScale(int leastExp, int mostExp) const {
    const float f = Scale(leastExp, mostExp);
    return Coin() ? -f : f;
  }
  Vector2 InSquare(float half) const {
    const float x = Uniform(-half, half), y = Uniform(-half, half);
    return {x, y};
  }
  Vector2 Direction() const { return AngleToVector(Uniform(0.0f, g_fTwoPi)); }
};
inline constexpr CDrawn g_cDrawn;

} // namespace Shapes::Properties
