// SPDX-License-Identifier: MIT
// The exact reference in 50 digits, which the one in double is held against.
#include "reference/ReferenceAnswer.h"
#include "reference/ReferenceMeet.h"
#include "reference/ReferenceRest.h"
#include "reference/ReferenceSlide.h"
#include "reference/ReferenceStep.h"
#include "reference/Scalar.h"

namespace Shapes::Compare {

template <>
CFifty TakeTurnsOff(const CFifty& angle) {
  return fmod(angle, Tau<CFifty>());
}

template class CReference<CFifty>;

} // namespace Shapes::Compare
