// SPDX-License-Identifier: MIT
// Several steps of a world at once.
#pragma once

#include <Shapes/World.h>

namespace Shapes {

inline void Steps(CWorld& world, int n) {
  for (int i = 0; i < n; ++i)
    world.Step();
}

} // namespace Shapes
