// SPDX-License-Identifier: MIT
#include "FirstImpact.h"

#include "report/Numbers.h"
#include "scene/ExactGame.h"

#include <fmt/format.h>

#include <algorithm>

namespace Shapes::Compare {
namespace {

constexpr std::uint64_t g_nMostTrials = 1000;
// Questions whether a ball meets something in a step, some 100 ns each.
constexpr std::uint64_t g_nMostQuestions = 1'000'000;

bool HasImpact(const CExactGame& game) {
  const auto& events = game.GetEvents();
  return std::any_of(events.begin(), events.end(), [](const auto& event) { return !event.m_bIsSensor; });
}

} // namespace

void RequireImpact(const CScene& scene, std::uint64_t seed) {
  const std::size_t steps = GetStepsPerTrial(scene), balls = scene.m_stdBalls.size();
  const std::uint64_t questions = balls * (scene.m_stdShapes.size() + balls);
  std::uint64_t trials = 0, played = 0; // trials that were played to their end
  const auto isTooLong = [&] { return played * questions >= g_nMostQuestions; };
  for (; trials < g_nMostTrials && !isTooLong(); ++trials) {
    CExactGame game(scene, MakeStart(scene, seed, trials));
    try {
      for (std::size_t i = 0; i < steps && game.IsInBounds(); ++i) {
        if (isTooLong() && trials == 0) return; // too large to be decided in short
        if (isTooLong()) break;
        game.Step();
        ++played;
        if (HasImpact(game)) return;
      }
    } catch (const std::exception&) { // something happened that the reference cannot hold: the run reports it
      return;
    }
  }
  throw CSceneError(fmt::format(
      "{}: expected balls that meet something, but none met anything in {} random trials ({} steps): are "
      "position, velocity, spread, duration and bounds as they are meant?",
      scene.m_cPath.string(), CountText(trials), CountText(played)));
}

} // namespace Shapes::Compare
