// SPDX-License-Identifier: MIT
#include "Turn.h"

#include <cmath>
#include <numbers>

namespace Shapes::Geometry {
namespace {

// 1 / n!, with the sign of the term.
constexpr double Term(int n) {
  double product = n % 4 < 2 ? 1.0 : -1.0;
  for (int k = 2; k <= n; ++k)
    product *= k;
  return 1.0 / product;
}

// Terms of every other power of z from n on. Of -pi/4 to pi/4: the first that is left out is below a
// thousandth of an ulp.
template <int n, int last>
double Sum(double z) {
  constexpr double term = Term(n);
  if constexpr (n == last)
    return term;
  else
    return term + z * Sum<n + 2, last>(z);
}

} // namespace

CTurn GetTurn(double angle) {
  if (!std::isless(std::abs(angle), 0x1p20)) return {std::cos(angle), std::sin(angle)};
  // The nearest integer: numbers as large as this have no fractions.
  constexpr double large = 0x1.8p52, quartersPerRadian = 0x1.45f306dc9c883p-1;
  const double quarters = (angle * quartersPerRadian + large) - large;
  // The first two parts of pi/2 have 33 bits, so that their multiples are exact; so is the first difference,
  // and the rounding of the second one is a number, too.
  constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34, third = 0x1.3198a2e037073p-69;
  const double rest = angle - quarters * first, next = quarters * second;
  const double x = rest - next, back = x - rest;
  const double tail = (rest - (x - back)) - (next + back) - quarters * third;

  const double z = x * x, half = 0.5 * z, most = 1.0 - half;
  const double s = x + (x * z * Sum<3, 17>(z) + tail * most);
  const double c = most + (((1.0 - most) - half) + (z * z * Sum<4, 18>(z) - x * tail));
  switch (static_cast<int>(quarters) & 3) {
  case 0: return {c, s};
  case 1: return {-s, c};
  case 2: return {-c, -s};
  default: return {s, -c};
  }
}

double TurnOn(double angle, float revsPerSecond, float dt) {
  constexpr double wholeTurn = 2.0 * std::numbers::pi;
  return std::fmod(angle + wholeTurn * static_cast<double>(revsPerSecond) * static_cast<double>(dt),
                   wholeTurn);
}

} // namespace Shapes::Geometry
