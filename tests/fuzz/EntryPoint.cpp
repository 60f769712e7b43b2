// SPDX-License-Identifier: MIT
// The entry that libFuzzer calls. SHAPES_FUZZ_TARGET is the function to be fuzzed.
#include "Fuzz.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* pBytes, std::size_t size) {
  try {
    Shapes::Fuzz::SHAPES_FUZZ_TARGET({pBytes, size});
  } catch (const Shapes::Fuzz::CBroken& broken) {
    std::fprintf(stderr, "Broken: %s\n", broken.what());
    std::abort();
  }
  return 0;
}
