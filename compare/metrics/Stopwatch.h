// SPDX-License-Identifier: MIT
// How long this thread has worked.
#pragma once

#include <time.h>

#include <algorithm>
#include <chrono>

namespace Shapes::Compare {

/// Runs from its construction on. The processor's time of the thread leaves out what others take on a loaded
/// machine, but reading it takes some 0.2 us; the clock on the wall reads ten times as fast. The smaller of
/// both is right wherever one of them is.
class CStopwatch {
public:
  std::chrono::nanoseconds GetElapsed() const {
    const std::chrono::nanoseconds wall = std::chrono::steady_clock::now() - m_cWall;
    return std::min(wall, GetThreadTime() - m_cThread);
  }

private:
  static std::chrono::nanoseconds GetThreadTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  }

  std::chrono::nanoseconds m_cThread = GetThreadTime(); // read first: the other one begins as late as can be
  std::chrono::steady_clock::time_point m_cWall = std::chrono::steady_clock::now();
};

} // namespace Shapes::Compare
