// SPDX-License-Identifier: MIT
// Random numbers for the tests: the same on every machine and compiler. The state is SplitMix64 (G. Steele,
// D. Lea, C. Flood, OOPSLA 2014); floats are made by integer and IEEE operations alone, no library
// distribution.
// Two draws in one expression, or as two arguments of one call, have no fixed order in C++: name the first.
#pragma once

#include <Shapes/ShapeMath.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace Shapes::Tests {

class CRandom {
public:
  explicit CRandom(std::uint64_t seed) : m_nSeed(seed), m_nState(seed) {}

  /// The seed it was made with: print it where an expectation fails.
  std::uint64_t GetSeed() const { return m_nSeed; }

  std::uint64_t Next() {
    m_nState += 0x9E3779B97F4A7C15u;
    std::uint64_t z = m_nState;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// Below n, n > 0. The bias of at most n / 2^32 does not matter to a test.
  std::uint32_t Below(std::uint32_t n) { return static_cast<std::uint32_t>(((Next() >> 32) * n) >> 32); }
  bool Coin() { return (Next() >> 63) != 0; }

  /// In [0, 1), a multiple of 2^-53.
  double Unit() { return static_cast<double>(Next() >> 11) * 0x1p-53; }
  /// In [least, most], uniform.
  float Uniform(float least, float most) {
    const double a = least, b = most;
    return static_cast<float>(a + (b - a) * Unit());
  }
  /// A positive number of uniform binary exponent, leastExp .. mostExp.
  float Scale(int leastExp, int mostExp) {
    const int e = leastExp + static_cast<int>(Below(static_cast<std::uint32_t>(mostExp - leastExp + 1)));
    return static_cast<float>(std::ldexp(1.0 + Unit(), e));
  }
  /// The same, of either sign.
  float SignedScale(int leastExp, int mostExp) {
    const float f = Scale(leastExp, mostExp);
    return Coin() ? f : -f;
  }
  /// In the square from -half to half.
  Vector2 InSquare(float half) {
    const float x = Uniform(-half, half); // named, because the order of arguments is not fixed
    const float y = Uniform(-half, half);
    return {x, y};
  }
  /// A unit vector, all directions alike: by rejection, so that only sqrt is needed.
  Vector2 Direction() {
    for (;;) {
      const double x = 2.0 * Unit() - 1.0;
      const double y = 2.0 * Unit() - 1.0;
      const double d = std::sqrt(x * x + y * y);
      if (d > 0.01 && d <= 1.0) return {static_cast<float>(x / d), static_cast<float>(y / d)};
    }
  }

  /// A vector of any direction whose length has a uniform binary exponent.
  Vector2 Vector(int leastExp, int mostExp) {
    const float d = Scale(leastExp, mostExp);
    return d * Direction();
  }
  /// A vector of any direction and a length in [least, most].
  Vector2 VectorOfLength(float least, float most) {
    const float d = Uniform(least, most);
    return d * Direction();
  }

private:
  std::uint64_t m_nSeed;
  std::uint64_t m_nState;
};

/// How many of something a random test plays: what the variable of the environment says, else the usual
/// number.
inline std::uint64_t HowMany(const char* sVariable, std::uint64_t usual) {
  const char* sMany = std::getenv(sVariable);
  return sMany == nullptr ? usual : std::strtoull(sMany, nullptr, 10);
}

} // namespace Shapes::Tests
