// SPDX-License-Identifier: MIT
// The memory that the program holds: its operator new and delete count.
#pragma once

#include <cstddef>

namespace Shapes::Tests {

/// Blocks that are allocated now. A vector that grows stays one block, a leak does not.
std::size_t CountLiveBlocks();
/// Bytes in them.
std::size_t CountLiveBytes();
/// Blocks that were ever allocated.
std::size_t CountAllocations();

} // namespace Shapes::Tests
