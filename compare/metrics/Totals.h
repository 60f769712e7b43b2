// SPDX-License-Identifier: MIT
// Totals of one engine over the contacts of a scene: counts, summaries, and the same by bins.
#pragma once

#include "Figures.h"
#include "ImpactTrials.h"
#include "Statistics.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace Shapes::Compare {

/// Totals of an engine over contacts. Units are those of CEngineContact.
struct CTotals {
  std::size_t m_nContacts = 0;
  std::size_t m_nMissed = 0, m_nWrongSide = 0, m_nLate = 0;
  std::size_t m_nOverlapped = 0; ///< did not tunnel, but left the ball in the shape by more than g_fOverlap
  std::vector<CSummary> m_stdSummaries; ///< of GetImpactFigures

  CTotals() : m_stdSummaries(GetImpactFigures().size()) {}
  /// The summary of a figure of each impact: totals["setback_error"].
  CSummary& operator[](std::string_view key) { return m_stdSummaries[GetImpactFigureIndex(key)]; }
  const CSummary& operator[](std::string_view key) const { return m_stdSummaries[GetImpactFigureIndex(key)]; }

  /// The exact ball was turned back and this one went on: missed or wrong side.
  std::size_t GetTunneled() const { return m_nMissed + m_nWrongSide; }
};

/// Of engine number `engine` over all contacts.
CTotals MakeTotals(std::span<const CContact> contacts, std::size_t engine);

/// Of the distances between the first engine and FindOther.
CSummary SummariseDifference(std::span<const CContact> contacts);

/// The contacts of one kind.
struct CBin {
  std::string m_sBy; ///< "travel", "incidence", "pair" or "elasticity"
  std::string m_sLabel;
  CTotals m_cTotals;
};

/// By travel per step in radii, by angle of incidence, by pair and by elasticity; bins without a contact are
/// left out.
std::vector<CBin> MakeBins(std::span<const CContact> contacts, std::size_t engine);

/// Counts of setback errors and penetrations by quarters of powers of ten: value i counts those from edge i
/// up to edge i + 1; smaller ones are in the first, larger ones in the last. Those of MakeTotals are counted:
/// setback errors of detected pairs, penetrations without tunneling.
inline constexpr std::size_t g_nHistogramBins = 32;
/// Edge i, 0 .. g_nHistogramBins: 10^(i/4 - 6) radii.
double GetHistogramEdge(std::size_t i);
struct CHistogram {
  std::vector<std::size_t> m_stdSetbackError, m_stdPenetration;
};
CHistogram MakeHistogram(std::span<const CContact> contacts, std::size_t engine);

} // namespace Shapes::Compare
