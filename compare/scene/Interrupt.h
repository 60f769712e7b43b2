// SPDX-License-Identifier: MIT
// Ctrl-C ends a run in order: what is finished is reported. A second one ends the program at once.
#pragma once

namespace Shapes::Compare {

/// Thrown where a run is to end. Not a std::exception, so that no handler takes it for an error.
struct CInterrupted {};

/// From now on the first SIGINT is remembered and gives the signal its default action back. Where the caller
/// of the program ignores the signal, as for jobs in the background, it stays ignored.
void CatchInterrupt();

/// Called by each step of a game, so that no scene is too slow to be ended.
/// @throws CInterrupted once the signal has come
void CheckInterrupt();

} // namespace Shapes::Compare
