// SPDX-License-Identifier: MIT
// Single pairs: the loop of a game that moves its ball itself and asks the library about one shape.
#pragma once

namespace Shapes::Compare::Benchmark {

/// Registers, for each engine and kind of shape, a turn of that loop with a ball far from the shape, and with
/// one that has just run into it.
void RegisterPairs();

} // namespace Shapes::Compare::Benchmark
