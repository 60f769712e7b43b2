// SPDX-License-Identifier: MIT
#pragma once

#include "Statistics.h"
#include "scene/Trial.h"

#include <functional>
#include <optional>
#include <vector>

namespace Shapes::Compare {

/// Time of an engine for playing a scene, and the balls that went astray meanwhile.
struct CCost {
  CMedian m_cNsPerBallStep;         ///< Over the repeats; making the worlds is not counted.
  std::vector<double> m_stdRepeats; ///< The same of each repeat, in their order.
  double m_fSimulatedSeconds = 0.0; ///< of all repeats together
  std::size_t m_nBallSteps = 0;     ///< of all repeats together
  std::size_t m_nContacts = 0;      ///< Contacts that were responded to, in the same time.
  std::size_t m_nEscaped = 0;       ///< Balls that left the scene's bounds and were put back.
  std::size_t m_nNotFinite = 0;     ///< Balls whose position became NaN or infinite.

  /// Time for as much play as has one contact, nanoseconds: most of it is spent between contacts. Absent if
  /// there was none.
  std::optional<double> GetNsPerContact() const;
};

/// How many times the time of b a takes, of each repeat.
std::vector<double> GetRatios(const CCost& a, const CCost& b);
/// The same in one: the median over the repeats, in which both had the same to do one
/// after the other, so that what slows the machine down for a while slows both.
CMedian CompareCosts(const CCost& a, const CCost& b);

/// Plays the scene on each engine `repeats` times, the engines taking turns, from the same random starts;
/// each turn lasts at least `ballSteps` steps of one ball. An engine without a backend is the exact
/// reference: where that gives up, or a ball leaves the bounds, the next start begins.
/// @param progress called after each turn with the share that is done; what it throws ends the measurement
std::vector<CCost> MeasureCost(const CScene& scene, const std::vector<CEngine>& engines, std::uint64_t seed,
                               int repeats, std::size_t ballSteps,
                               const std::function<void(double)>& progress = {});

} // namespace Shapes::Compare
