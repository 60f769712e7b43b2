// SPDX-License-Identifier: MIT
#include "NearMatches.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace Shapes::Compare {
namespace {

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

} // namespace

std::size_t EditDistance(std::string_view a, std::string_view b) {
  // Rows i - 2, i - 1 and i of the table whose entry (i, j) is the distance of the first i and j letters.
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    now[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(now);
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], before[j - 2] + 1);
    }
  }
  return now[b.size()];
}

std::vector<std::string> NearMatches(std::string_view name, std::span<const std::string> known) {
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& candidate : known) {
    const std::size_t distance = EditDistance(Lower(name), Lower(candidate));
    if (distance <= std::max<std::size_t>(std::max(name.size(), candidate.size()) / 3, 1))
      near.emplace_back(distance, candidate);
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (auto& [distance, candidate] : near)
    names.push_back(std::move(candidate));
  return names;
}

std::string UnknownName(std::string_view what, std::string_view name, std::span<const std::string> known) {
  const std::vector<std::string> near = NearMatches(name, known);
  return fmt::format("there is no {} '{}'{} Known: {}", what, name,
                     near.empty() ? "." : fmt::format(": did you mean '{}'?", fmt::join(near, "' or '")),
                     fmt::join(known, ", "));
}

} // namespace Shapes::Compare
