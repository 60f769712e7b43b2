// SPDX-License-Identifier: MIT
// Which things hang together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace Shapes::Native {

/// A partition of 0 .. n - 1 that gets coarser (union-find).
class CGroups {
public:
  void Reset(std::size_t n) {
    m_stdRoot.resize(n);
    std::iota(m_stdRoot.begin(), m_stdRoot.end(), 0u);
  }
  /// One more, alone.
  void Add() { m_stdRoot.push_back(static_cast<std::uint32_t>(m_stdRoot.size())); }
  std::size_t Size() const { return m_stdRoot.size(); }
  /// The lowest of the group of k.
  std::uint32_t Find(std::uint32_t k) {
    while (m_stdRoot[k] != k)
      k = m_stdRoot[k] = m_stdRoot[m_stdRoot[k]]; // the way becomes shorter
    return k;
  }
  void Join(std::uint32_t a, std::uint32_t b) {
    const auto [first, last] = std::minmax({Find(a), Find(b)});
    m_stdRoot[last] = first;
  }

private:
  std::vector<std::uint32_t> m_stdRoot; // another one of the same group, or itself
};

} // namespace Shapes::Native
