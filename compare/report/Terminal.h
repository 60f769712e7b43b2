// SPDX-License-Identifier: MIT
// Text that fits a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace Shapes::Compare {

/// Columns of a terminal.
inline constexpr std::size_t g_nWidth = 80;

/// Breaks a text between words, or within one that is longer than a line, and ends the last line. The first
/// line is indented by `first`, those after it by `rest`.
std::string Wrap(std::string_view text, std::size_t first, std::size_t rest);

/// Names that a user gives may hold anything; a terminal gets what can be printed.
std::string Ascii(std::string text);

} // namespace Shapes::Compare
