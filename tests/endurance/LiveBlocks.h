// SPDX-License-Identifier: MIT
// What the program holds of memory: its operator new and delete count.
#pragma once

#include <cstddef>

namespace Shapes::Tests {

/// Blocks that are allocated now. A vector that grows stays one block, a leak does not.
std::size_t CountLiveBlocks();
/// Bytes in them.
std::size_t CountLiveBytes();

} // namespace Shapes::Tests
