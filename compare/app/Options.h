// SPDX-License-Identifier: MIT
// Scenes and engines from the command line, or the reason of a refusal.
#pragma once

#include "scene/Trial.h"

#include <span>
#include <string>
#include <vector>

namespace Shapes::Compare {

/// Scenes by name, each once, in the order of `all`; all of them if no name is given.
/// @throws std::invalid_argument naming a scene that is not there, and those with a similar name
std::vector<CScene> SelectScenes(std::vector<CScene> all, std::span<const std::string> names);

/// The same for engines.
std::vector<CEngine> SelectEngines(std::vector<CEngine> all, std::span<const std::string> names);

/// A command as one line that a shell reads as these words.
std::string JoinCommand(std::span<const std::string> words);

} // namespace Shapes::Compare
