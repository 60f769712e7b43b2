// SPDX-License-Identifier: MIT
// Suggestions for a misspelled name.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace Shapes::Compare {

/// The fewest letters to insert, delete, replace or swap with their neighbour that turn a into b, no place
/// being changed twice (the restricted distance of F. J. Damerau, CACM 7, 1964). Bytes count as letters.
std::size_t EditDistance(std::string_view a, std::string_view b);

/// The names within a third of the longer one's letters (one letter at least), nearest first, names that are
/// equally near in their order. Upper and lower case are the same.
std::vector<std::string> NearMatches(std::string_view name, std::span<const std::string> known);

/// "there is no scene 'pinbal': did you mean 'pinball'? Known: bowl, pinball". @param what "scene"
std::string UnknownName(std::string_view what, std::string_view name, std::span<const std::string> known);

} // namespace Shapes::Compare
