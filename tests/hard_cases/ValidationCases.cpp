// SPDX-License-Identifier: MIT
// Inputs that are no numbers, or of no extent.
#include "HardCase.h"

namespace Shapes::HardCases {

std::vector<CHardCase> ValidationCases() {
  std::vector<CHardCase> cases;
  return cases;
}

} // namespace Shapes::HardCases
