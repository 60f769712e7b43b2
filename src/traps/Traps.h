// SPDX-License-Identifier: MIT
// With the option SHAPES_TRAP_FLOATS every invalid operation, division by zero and overflow in the code of
// the shapes and of the native engine stops the program with SIGFPE. docs/testing.md says more.
#pragma once

namespace Shapes {

/// As long as it lives nothing is trapped in its thread. For what is not a number on purpose, and for other
/// people's code. Nothing at all where the option is off.
class CWithoutTraps {
public:
#ifdef SHAPES_TRAP_FLOATS
  CWithoutTraps();
  ~CWithoutTraps();
#else
  CWithoutTraps() {}
  ~CWithoutTraps() {}
#endif
  CWithoutTraps(const CWithoutTraps&) = delete;
  CWithoutTraps& operator=(const CWithoutTraps&) = delete;
};

} // namespace Shapes
