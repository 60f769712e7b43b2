// SPDX-License-Identifier: MIT
// The table of figures: one row each. The totals, run.json, contacts.csv, --fail-above, `list --figures` and
// the page read it; docs/accuracy.md defines the figures.
#pragma once

#include "ImpactTrials.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace Shapes::Compare {

struct CEngineReport;
struct CSceneReport;

/// So many of so many; a rate.
struct CHits {
  std::size_t m_nHits = 0, m_nOf = 0;
};

/// A figure of one engine on one scene. Exactly one of the three functions is there.
struct CFigure {
  const char* m_sKey;   ///< "setback_error": in run.json and of --fail-above
  const char* m_sGroup; ///< what stands above it on the page
  const char* m_sLabel; ///< what it is, in words
  const char* m_sUnit;  ///< "radii", "steps", "rad", "relative" (to the exact value), "change" (over a run),
                        ///< "balls", "ns", "s", "units/s", "balls/s"
  bool m_bIsSigned = false;

  /// Of each impact: its value, and whether it was measured there. Summarised over the impacts.
  float CEngineContact::*m_pOfImpact = nullptr;
  bool (*m_pIsMeasured)(const CEngineContact&) = nullptr;
  bool (*m_pIsSummarised)(const CEngineContact&) = nullptr; ///< of those that were measured; null for all
  /// A rate, and of what: "impacts", "quiet steps", "balls".
  CHits (*m_pRate)(const CSceneReport&, const CEngineReport&) = nullptr;
  const char* m_sRateOf = nullptr;
  /// Of the whole run; absent where it was not measured.
  std::optional<double> (*m_pOfRun)(const CSceneReport&, const CEngineReport&) = nullptr;
  bool m_bIsCount = false; ///< a whole number
};

/// The form of a figure in run.json: "rate", "impact" (a summary over impacts), "run" (a number) or "count"
/// (a whole number).
const char* GetKind(const CFigure& figure);

/// All figures, in the order in which they are shown.
std::span<const CFigure> GetFigures();
/// Those of each impact, which come one after the other.
std::span<const CFigure> GetImpactFigures();

/// nullptr if there is none of that name.
const CFigure* FindFigure(std::string_view key);
/// Which of GetImpactFigures it is. @throws std::out_of_range naming the key if there is none
std::size_t GetImpactFigureIndex(std::string_view key);

/// The one number that --fail-above holds against a limit: a rate, the 95th percentile, or the size of a
/// value.
std::optional<double> GetLimited(const CFigure& figure, const CSceneReport& scene,
                                 const CEngineReport& engine);

} // namespace Shapes::Compare
