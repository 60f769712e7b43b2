// SPDX-License-Identifier: MIT
#include "Validate.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace Shapes {

std::string ToText(float value) {
  std::array<char, 32> text;
#ifdef __cpp_lib_to_chars
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
#else // libc++ before 14: the shortest of the texts that read back as the value
  std::string shortest;
  for (int digits = std::numeric_limits<float>::max_digits10; digits > 0; --digits) {
    std::snprintf(text.data(), text.size(), "%.*g", digits, static_cast<double>(value));
    const std::string read = text.data();
    if (shortest.empty() || (read.size() < shortest.size() && std::strtof(read.c_str(), nullptr) == value))
      shortest = read;
  }
  return shortest;
#endif
}

std::string ToText(const Vector2& v) {
  std::string text = "(";
  return text.append(ToText(v.x())).append(", ").append(ToText(v.y())).append(")");
}

void Refuse(const std::string& field, const std::string& value, const std::string& expected) {
  throw std::invalid_argument(field + " is " + value + ": expected " + expected);
}

void RefuseRange(const char* field, float value, float least, float most) {
  Refuse(field, ToText(value), "a number from " + ToText(least) + " to " + ToText(most));
}

void RefuseVector(const char* field, const Vector2& v, float most) {
  Refuse(field, ToText(v), "finite coordinates of at most " + ToText(most) + " in size");
}

void RequirePositive(const char* field, float value, float most) {
  if (!(std::isgreater(value, 0.0f) && std::islessequal(value, most)))
    Refuse(field, ToText(value), "a number above 0, up to " + ToText(most));
}

void RequireFinite(const char* field, float value) {
  if (!std::isfinite(value)) Refuse(field, ToText(value), "a finite number");
}

void RequireSides(eSides sides) {
  if (sides != eSides::Both && sides != eSides::Front && sides != eSides::Back)
    Refuse("m_eSides", std::to_string(static_cast<int>(sides)), "Both, Front or Back");
}

} // namespace Shapes
