// SPDX-License-Identifier: MIT
#include "Lanes.h"

#include "../Tolerances.h"

#include <algorithm>

#ifdef SHAPES_WITH_THREADS
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace Shapes::Native {

#ifdef SHAPES_WITH_THREADS

class CLanes::CThreads {
public:
  // More than the machine has would be refused, with a warning.
  explicit CThreads(unsigned threads)
      : m_cArena(std::min(static_cast<int>(threads), tbb::info::default_concurrency())) {}

  template <class F>
  void Run(std::size_t lanes, const F& f) {
    m_cArena.execute([&] { tbb::parallel_for(std::size_t{0}, lanes, f, tbb::simple_partitioner()); });
  }

private:
  tbb::task_arena m_cArena;
};

#else

class CLanes::CThreads {
public:
  explicit CThreads(unsigned) {}

  template <class F>
  void Run(std::size_t lanes, const F& f) {
    for (std::size_t lane = 0; lane < lanes; ++lane)
      f(lane);
  }
};

#endif

CLanes::CLanes(unsigned threads) : m_nMost(threads > 1 ? threads * g_nLanesPerThread : 1) {
  if (threads > 1) m_pThreads = std::make_unique<CThreads>(threads);
}

CLanes::~CLanes() = default;

std::size_t CLanes::Count(std::size_t n) const {
  const std::size_t lanes = std::min(m_nMost, n / g_nLeastInLane);
  return std::max<std::size_t>(lanes, 1);
}

void CLanes::ForEach(std::size_t n, std::size_t lanes,
                     const std::function<void(std::size_t, std::size_t, std::size_t)>& f) const {
  if (lanes == 1) return f(0, 0, n);
  m_pThreads->Run(lanes, [&](std::size_t lane) { f(lane, n * lane / lanes, n * (lane + 1) / lanes); });
}

} // namespace Shapes::Native
