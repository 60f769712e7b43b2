// SPDX-License-Identifier: MIT
#include "LiveBlocks.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> g_nBlocks, g_nBytes;

void* Allocate(std::size_t size) {
  void* p = std::malloc(size == 0 ? 1 : size);
  if (p == nullptr) throw std::bad_alloc();
  ++g_nBlocks;
  g_nBytes += malloc_usable_size(p);
  return p;
}

void Free(void* p) {
  if (p == nullptr) return;
  --g_nBlocks;
  g_nBytes -= malloc_usable_size(p);
  std::free(p);
}

} // namespace

namespace Shapes::Tests {

std::size_t CountLiveBlocks() { return g_nBlocks; }
std::size_t CountLiveBytes() { return g_nBytes; }

} // namespace Shapes::Tests

// The forms for arrays and those that do not throw call these. Nothing here is aligned by more than malloc
// does.
void* operator new(std::size_t size) { return Allocate(size); }
void operator delete(void* p) noexcept { Free(p); }
void operator delete(void* p, std::size_t) noexcept { Free(p); }
