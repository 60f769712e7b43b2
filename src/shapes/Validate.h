// SPDX-License-Identifier: MIT
// Refusal of values that no shape can have, with a message that says which field, which value, and what is
// expected.
#pragma once

#include <Shapes/Shape.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace Shapes {

/// The shortest text that reads back as the same float.
std::string ToText(float value);
/// The same of both coordinates: "(1, 2)".
std::string ToText(const Vector2& v);

/// @throws std::invalid_argument "<field> is <value>: expected <what>"
[[noreturn]] void Refuse(const std::string& field, const std::string& value, const std::string& expected);

[[noreturn]] void RefuseRange(const char* field, float value, float least, float most);
[[noreturn]] void RefuseVector(const char* field, const Vector2& v, float most);

// The quiet comparisons, here and in Validate.cpp: what is not a number is to be refused, not to trap.

inline void RequireRange(const char* field, float value, float least, float most) {
  if (!(std::isgreaterequal(value, least) && std::islessequal(value, most)))
    RefuseRange(field, value, least, most);
}
void RequirePositive(const char* field, float value, float most);
void RequireFinite(const char* field, float value);
/// Each component finite and at most `most` in size.
inline void RequireVector(const char* field, const Vector2& v, float most) {
  if (!(std::islessequal(std::abs(v.x()), most) && std::islessequal(std::abs(v.y()), most)))
    RefuseVector(field, v, most);
}

/// Calls f. What it refuses is said to be of one of several: "shape 1: m_fRadius is -1: expected ..."
template <class F>
auto OfElement(const char* name, std::size_t i, const F& f) {
  try {
    return f();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(name) + " " + std::to_string(i) + ": " + error.what());
  }
}

/// One of the three.
void RequireSides(eSides sides);

} // namespace Shapes
