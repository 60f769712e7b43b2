// SPDX-License-Identifier: MIT
#include "Endurance.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> g_nBlocks, g_nBytes, g_nAllocations;

void* TryAllocate(std::size_t size) noexcept {
  void* p = std::malloc(size == 0 ? 1 : size);
  if (p == nullptr) return nullptr;
  ++g_nBlocks;
  ++g_nAllocations;
  g_nBytes += malloc_usable_size(p);
  return p;
}

void* Allocate(std::size_t size) {
  void* p = TryAllocate(size);
  if (p == nullptr) throw std::bad_alloc();
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
std::size_t CountAllocations() { return g_nAllocations; }

} // namespace Shapes::Tests

// All forms, because those of a sanitizer do not call each other. Nothing here is aligned by more than malloc
// does.
void* operator new(std::size_t size) { return Allocate(size); }
void* operator new[](std::size_t size) { return Allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return TryAllocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return TryAllocate(size); }
void operator delete(void* p) noexcept { Free(p); }
void operator delete[](void* p) noexcept { Free(p); }
void operator delete(void* p, std::size_t) noexcept { Free(p); }
void operator delete[](void* p, std::size_t) noexcept { Free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { Free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { Free(p); }
