// SPDX-License-Identifier: MIT
// How many instructions a step takes: unlike a time that is the same again, and small differences show.
#pragma once

#include "scene/Trial.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace Shapes::Compare {

struct CInstructions {
  std::vector<double> m_stdPerBallStep; ///< Of each world.
  std::string m_sWhyNot;                ///< Reason for a missing count; empty if there is one.
};

/// Counts the instructions of `steps` steps of each world, those that change the balls and what they meet and
/// not those that make the world. The same worlds in the same order give the same counts; in another order
/// they differ by about a tenth of a percent, because memory is looked for where there is some. `program` is
/// called again under valgrind's callgrind, as
///   program step-cost SCENE.json SEED STEPS WORLD...
/// and has to hand that over to PlayStepCost.
/// @param worlds  differ from GetEngines by one effect that is forced or forbidden, or nothing
/// @param check   called again and again meanwhile; what it throws ends it
CInstructions CountInstructions(const CScene& scene, const std::vector<CEngine>& worlds,
                                const std::string& program, std::uint64_t seed, std::size_t steps,
                                const std::function<void()>& check);

/// A world as one word: "native", with an effect that is forced "native+Gravity", forbidden "native~Gravity".
std::string ToWord(const CEngine& world);
/// @throws std::invalid_argument if it is none
CEngine FromWord(const std::string& word);

/// Plays the steps of each world, to be counted; those of the first one once more before.
void PlayStepCost(const CScene& scene, std::span<const std::string> words, std::uint64_t seed,
                  std::size_t steps);
/// One of them. Callgrind knows its end by its name.
void PlayCounted(const CScene& scene, const CEngine& world, std::uint64_t seed, std::size_t steps);

} // namespace Shapes::Compare
