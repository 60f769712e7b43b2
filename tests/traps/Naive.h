// SPDX-License-Identifier: MIT
// Code that is written without a thought of what a divisor may be, compiled like the code of the library.
#pragma once

namespace Shapes::Tests {

float Quotient(float a, float b);
float Product(float a, float b);
bool IsLess(float a, float b);

} // namespace Shapes::Tests
