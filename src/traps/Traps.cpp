// SPDX-License-Identifier: MIT
// Part of the library only where SHAPES_TRAP_FLOATS is on. The compiler then calls what is here at the
// beginning and at the end of every function of src/shapes and src/native (-finstrument-functions), so that
// none of them has to know of it, and none can be forgotten.
#include "Traps.h"

#include <xmmintrin.h>

#define SHAPES_NOT_INSTRUMENTED __attribute__((no_instrument_function))

namespace {

// The control register of SSE alone: feenableexcept sets that of the x87, too, with which nothing is computed
// here, and took three quarters of the time of tests that ask a world for much.
constexpr unsigned g_nMasks = _MM_MASK_INVALID | _MM_MASK_DIV_ZERO | _MM_MASK_OVERFLOW;

thread_local int g_nInside = 0;      // functions of the library that are being run
thread_local int g_nWithout = 0;     // scopes without traps
thread_local unsigned g_nBefore = 0; // what was masked when the library was called

SHAPES_NOT_INSTRUMENTED void TurnOn() {
  g_nBefore = _mm_getcsr() & g_nMasks;
  _mm_setcsr(_mm_getcsr() & ~(g_nMasks | _MM_EXCEPT_MASK)); // what happened before would trap now
}

SHAPES_NOT_INSTRUMENTED void TurnOff() { _mm_setcsr(_mm_getcsr() | g_nBefore); }

} // namespace

namespace Shapes {

CWithoutTraps::CWithoutTraps() {
  if (g_nWithout++ == 0 && g_nInside > 0) TurnOff();
}

CWithoutTraps::~CWithoutTraps() {
  if (--g_nWithout == 0 && g_nInside > 0) TurnOn();
}

} // namespace Shapes

extern "C" {

void __cyg_profile_func_enter(void*, void*) SHAPES_NOT_INSTRUMENTED;
void __cyg_profile_func_exit(void*, void*) SHAPES_NOT_INSTRUMENTED;

void __cyg_profile_func_enter(void*, void*) {
  if (g_nInside++ == 0 && g_nWithout == 0) TurnOn();
}

void __cyg_profile_func_exit(void*, void*) {
  if (--g_nInside == 0 && g_nWithout == 0) TurnOff();
}
}
