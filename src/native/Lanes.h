// SPDX-License-Identifier: MIT
// Work on balls that do not meet each other, shared between threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace Shapes::Native {

/// Cuts balls into lanes, ranges that may be worked on at the same time. Each lane writes to places of its
/// own; taken in their order these hold what one lane for all balls would have written.
class CLanes {
public:
  /// @param threads  at least 1. Where the library was built without SHAPES_WITH_THREADS lanes run one after
  ///                 the other.
  explicit CLanes(unsigned threads);
  ~CLanes();
  /// Lanes for n balls: one for few. More than threads, as some lanes have more to do.
  /// @returns at least 1
  std::size_t Count(std::size_t n) const;
  /// Calls f(lane, begin, end) for each lane, which handles the balls from begin to end, and waits for all.
  void ForEach(std::size_t n, std::size_t lanes,
               const std::function<void(std::size_t, std::size_t, std::size_t)>& f) const;

private:
  class CThreads;
  std::size_t m_nMost;                  // lanes
  std::unique_ptr<CThreads> m_pThreads; // none where there is one
};

} // namespace Shapes::Native
