// SPDX-License-Identifier: MIT
#include "Naive.h"

namespace Shapes::Tests {

float Quotient(float a, float b) { return a / b; }
float Product(float a, float b) { return a * b; }
bool IsLess(float a, float b) { return a < b; }

} // namespace Shapes::Tests
