// SPDX-License-Identifier: MIT
#pragma once

#include "../Trial.h"
#include "Statistics.h"

#include <vector>

namespace Shapes::Compare {

/// What an engine took for playing a scene, and what happened to the balls meanwhile.
struct CCost {
  CMedian m_cNsPerBallStep;         ///< Over the repeats; making the worlds is not counted.
  double m_fSimulatedSeconds = 0.0; ///< of all repeats together
  std::size_t m_nEscaped = 0;       ///< Balls that left the scene's bounds and were put back.
  std::size_t m_nNotFinite = 0;     ///< Balls whose position became NaN or infinite.
};

/// Plays the scene on each engine `repeats` times, the engines taking turns, from the same random starts;
/// each turn lasts at least `ballSteps` steps of one ball.
std::vector<CCost> MeasureCost(const CScene& scene, const std::vector<CEngine>& engines, std::uint64_t seed,
                               int repeats, std::size_t ballSteps);

} // namespace Shapes::Compare
