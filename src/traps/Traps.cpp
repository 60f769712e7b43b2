// SPDX-License-Identifier: MIT
// Part of the library only where SHAPES_TRAP_FLOATS is on. The compiler then calls what is here at the
// beginning and at the end of every function of src/shapes and src/native (-finstrument-functions), so that
// none of them has to know of it, and none can be forgotten.
#include "Traps.h"

#include <cfenv>

#define SHAPES_NOT_INSTRUMENTED __attribute__((no_instrument_function))

namespace {

constexpr int g_nTraps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

thread_local int g_nInside = 0;  // functions of the library that are being run
thread_local int g_nWithout = 0; // scopes without traps
thread_local int g_nBefore = 0;  // what was trapped when the library was called

SHAPES_NOT_INSTRUMENTED void TurnOn() {
  g_nBefore = fegetexcept();
  std::feclearexcept(FE_ALL_EXCEPT); // or what happened before would trap now
  feenableexcept(g_nTraps);
}

SHAPES_NOT_INSTRUMENTED void TurnOff() { fedisableexcept(g_nTraps & ~g_nBefore); }

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
