// SPDX-License-Identifier: MIT
// Scenes in which no ball meets anything are refused before a run spends minutes on them.
#pragma once

#include "scene/Scene.h"

#include <cstdint>

namespace Shapes::Compare {

/// Plays random trials on the exact reference until a ball meets a ball or a shape that is no sensor. Gives
/// up after 1,000 trials, or a fifth of a second or so; a scene of which not even one trial can be played in
/// that time is not refused.
/// @throws CSceneError naming the file and what was tried, if no ball met anything
void RequireImpact(const CScene& scene, std::uint64_t seed);

} // namespace Shapes::Compare
