// SPDX-License-Identifier: MIT
#include "geometry/Turn.h"

#include "../Testing.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <bit>

namespace Shapes::Geometry {
namespace {

// Enough for angles of which 60 bits are whole turns.
using CHundred = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>>;

double UlpOf(double x) {
  const double size = std::max(std::abs(x), std::numeric_limits<double>::min());
  return std::nextafter(size, 2.0 * size) - size;
}

// The error in ulp of the result.
double ErrorOf(double is, const CHundred& should) {
  return abs(CHundred(is) - should).convert_to<double>() / UlpOf(should.convert_to<double>());
}

double WorstErrorOf(double angle) {
  const CTurn turn = GetTurn(angle);
  return std::max(ErrorOf(turn.m_fCos, cos(CHundred(angle))), ErrorOf(turn.m_fSin, sin(CHundred(angle))));
}

TEST(Turn, ErrsByAtMostAnUlp) {
  double worst = 0.0;
  ForEachCase(281, 22000, [&](CRandom& random, int i) {
    // Every eleventh is huge.
    const int exponent =
        i % 11 == 0 ? 20 + static_cast<int>(random.Below(61)) : static_cast<int>(random.Below(50)) - 30;
    const double angle = std::ldexp(static_cast<double>(random.Uniform(-1.0f, 1.0f)), exponent);
    const double error = WorstErrorOf(angle);
    ASSERT_LE(error, 1.0) << angle;
    worst = std::max(worst, error);
  });
  EXPECT_GT(worst, 0.5) << "nothing is rounded";
}

TEST(Turn, ErrsByAtMostAnUlpBesideWholeQuarters) {
  for (int quarters = -1000; quarters <= 600000; quarters += quarters < 1000 ? 1 : 997)
    for (double angle = quarters * 1.57079632679489661923, end = std::nextafter(angle, 1e9); angle <= end;
         angle = std::nextafter(angle, 1e9))
      ASSERT_LE(WorstErrorOf(angle), 1.0) << quarters;
}

// One part of pi/2 less, and there the result is of the rest alone.
TEST(Turn, ControlOfTwoPartsOfAQuarterTurn) {
  const double angle = 314159.0 * 1.57079632679489661923, quarters = 314159.0;
  const double x = (angle - quarters * 0x1.921fb544p+0) - quarters * 0x1.0b4611a6p-34;
  EXPECT_GT(ErrorOf(std::abs(std::sin(x)), abs(cos(CHundred(angle)))), 1.0);
}

TEST(Turn, IsExactWhereItCanBe) {
  EXPECT_EQ(GetTurn(0.0).m_fCos, 1.0);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(GetTurn(0.0).m_fSin), 0u);
  const double tiny = std::numeric_limits<double>::min();
  EXPECT_EQ(GetTurn(tiny).m_fSin, tiny);
}

// The same on every compiler and machine.
TEST(Turn, HasTheseBits) {
  std::uint64_t hash = 14695981039346656037u;
  for (int i = -5000; i <= 5000; ++i) {
    const CTurn turn = GetTurn(i * 0.37);
    for (const double x : {turn.m_fCos, turn.m_fSin})
      hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 1099511628211u;
  }
  EXPECT_EQ(hash, 14851537671749465561u);
}

} // namespace
} // namespace Shapes::Geometry
