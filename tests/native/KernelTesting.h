// SPDX-License-Identifier: MIT
// What the tests of the pair kernels share.
#pragma once

#include "native/narrowphase/Collide.h"
#include "traps/Traps.h"

#include "../Numbers.h"
#include "../Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace Shapes::Native {

using Tests::CRandom;

/// A ball that has not moved in this step.
inline CBall Ball(const Vector2& p, float r, const Vector2& v = Vector2::Zero()) { return {p, p, v, r}; }

} // namespace Shapes::Native
