// SPDX-License-Identifier: MIT
#include "Interrupt.h"

#include <csignal>

namespace Shapes::Compare {
namespace {

volatile std::sig_atomic_t g_nInterrupted = 0;

} // namespace

void CatchInterrupt() {
  g_nInterrupted = 0;
  struct sigaction old = {};
  sigaction(SIGINT, nullptr, &old);
  if (old.sa_handler == SIG_IGN) return;
  struct sigaction action = {};
  action.sa_handler = [](int) { g_nInterrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
}

void CheckInterrupt() {
  if (g_nInterrupted != 0) throw CInterrupted();
}

} // namespace Shapes::Compare
