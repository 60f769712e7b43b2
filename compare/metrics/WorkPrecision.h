// SPDX-License-Identifier: MIT
// Work and precision: a scene on a sweep of settings of each engine, what each costs and how exact it is.
#pragma once

#include "ImpactTrials.h"
#include "Statistics.h"

#include <optional>
#include <string>
#include <vector>

namespace Shapes::Compare {

/// All settings that are tried. A new one is a line in WorkPrecision.cpp.
/// @throws std::runtime_error if the Box2D engine was not built
std::vector<CEngine> GetParameterSweep();

/// The name of the exact reference, which has no backend.
inline constexpr const char* g_sExact = "exact";

/// One setting on one scene.
struct CSetting {
  CEngine m_cEngine;
  CMedian m_cNsPerBallSecond; ///< time for a simulated second of one ball
  /// 95th percentile, radians, of the contacts that were compared, with pi for each that tunneled: what goes
  /// on through the wall goes the wrong way. Absent if there were none.
  std::optional<double> m_fDirectionErrorP95;
  std::size_t m_nContacts = 0;
  std::size_t m_nMissed = 0, m_nTunneled = 0;
  /// Further impacts, which only settings without a loss are given, and how many of them tunneled.
  std::size_t m_nConfirmationContacts = 0, m_nConfirmationTunneled = 0;
  /// No other setting of an engine costs no more and is no worse, in this figure, without being the same in
  /// both.
  bool m_bFrontByError = false, m_bFrontByMisses = false;

  std::size_t GetAllTunneled() const { return m_nTunneled + m_nConfirmationTunneled; }
  std::size_t GetAllContacts() const { return m_nContacts + m_nConfirmationContacts; }
};

/// A demand that a user may have, and the cheapest settings that meet it, by their numbers.
struct CRecommendation {
  std::string m_sDemand;
  std::vector<std::size_t> m_stdChoices; ///< one of each engine, the cheapest of all first
  std::vector<std::string> m_stdWithout; ///< engines of which no setting that was tried meets it
  std::optional<std::size_t> m_nClosest; ///< where there is no choice: what comes closest
};

struct CWorkPrecision {
  std::vector<CSetting> m_stdSettings; ///< the sweep in its order, then the reference
  std::vector<CRecommendation> m_stdRecommendations;
};

/// Trials of each setting.
struct CParameterSweepOptions : CTrials {
  std::size_t m_nConfirmation = 0; ///< impacts without a miss that are called "no miss"
  std::size_t m_nBallSteps = 0;    ///< length of one timing
  int m_nRepeats = 11;             ///< timings of each setting, taking turns
};

/// Settings that lost nothing in m_nContacts impacts are given further ones, the cheapest of each engine
/// first, until one of that engine has lost nothing in m_nConfirmation. Which ones these are depends on the
/// times; all other counts do not.
CWorkPrecision MeasureWorkPrecision(const CScene& scene, const std::vector<CEngine>& sweep,
                                    const CParameterSweepOptions& options);

/// Marks the settings on the Pareto fronts.
void MarkFronts(std::vector<CSetting>& settings);

/// Three of settings that are measured: an error below .01 rad, below .001 rad, and none lost in `proof`.
std::vector<CRecommendation> MakeRecommendations(const std::vector<CSetting>& settings, std::size_t proof);

} // namespace Shapes::Compare
