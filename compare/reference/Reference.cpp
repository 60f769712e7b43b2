// SPDX-License-Identifier: MIT
// The reference in double. The tests have another one, in 50 digits.
#include "ReferenceAnswer.h"
#include "ReferenceMeet.h"
#include "ReferenceRest.h"
#include "ReferenceSlide.h"
#include "ReferenceStep.h"

#include <cmath>
#include <numbers>

namespace Shapes::Compare {

// After many turns the rounding of 2 pi counts as many times, so what it leaves out is taken off as well. The
// library does the same for its angles; but what judges does not lean on what is judged.
template <>
double TakeTurnsOff(const double& angle) {
  constexpr double tau = 2.0 * std::numbers::pi,
                   rest = 2.4492935982947064e-16; // 2 pi is their sum to 33 digits
  const double below = std::fmod(angle, tau);
  if (std::abs(angle) < 4.0 * tau) return below;
  const double turns = (angle - below) / tau;
  return std::fmod(below - turns * rest, tau);
}

template class CReference<double>;

} // namespace Shapes::Compare
