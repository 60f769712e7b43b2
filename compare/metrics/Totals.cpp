// SPDX-License-Identifier: MIT
#include "Totals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace Shapes::Compare {
namespace {

bool HasTunneled(const CEngineContact& c) {
  return c.m_eOutcome == eOutcome::Missed || c.m_eOutcome == eOutcome::WrongSide;
}

double AsDouble(float x) { return static_cast<double>(x); }

// Gathers contacts of one engine until they are summarised.
class CGatherer {
public:
  void Add(const CEngineContact& c) {
    ++m_cTotals.m_nContacts;
    m_cTotals.m_nMissed += c.m_eOutcome == eOutcome::Missed;
    m_cTotals.m_nWrongSide += c.m_eOutcome == eOutcome::WrongSide;
    m_cTotals.m_nLate += c.m_eOutcome == eOutcome::Late;
    if (!HasTunneled(c)) {
      m_cTotals.m_nOverlapped += c.m_fPenetration > g_fOverlap;
      m_stdPenetration.push_back(AsDouble(c.m_fPenetration));
    }
    if (c.m_bDetected) {
      m_stdSetback.push_back(AsDouble(c.m_fSetback));
      m_stdSetbackError.push_back(AsDouble(c.m_fSetbackError));
      m_stdSetbackErrorNormal.push_back(AsDouble(c.m_fSetbackErrorNormal));
      m_stdTimeError.push_back(AsDouble(c.m_fTimeError));
    }
    if (c.HasTurnedBack()) {
      m_stdPOIError.push_back(AsDouble(c.m_fPOIError));
      m_stdNormalError.push_back(AsDouble(c.m_fNormalError));
    }
    if (c.m_bCompared) {
      m_stdDirectionError.push_back(AsDouble(c.m_fDirectionError));
      m_stdSpeedError.push_back(AsDouble(c.m_fSpeedError));
      m_stdEnergyError.push_back(AsDouble(c.m_fEnergyError));
      m_stdPositionError.push_back(AsDouble(c.m_fPositionError));
    }
  }

  bool IsEmpty() const { return m_cTotals.m_nContacts == 0; }

  // Once only: hands over what was gathered.
  CTotals Summarised() {
    m_cTotals.m_cSetback = Summarise(std::move(m_stdSetback));
    m_cTotals.m_cSetbackError = Summarise(std::move(m_stdSetbackError));
    m_cTotals.m_cSetbackErrorNormal = SummariseSigned(std::move(m_stdSetbackErrorNormal));
    m_cTotals.m_cTimeError = SummariseSigned(std::move(m_stdTimeError));
    m_cTotals.m_cPOIError = Summarise(std::move(m_stdPOIError));
    m_cTotals.m_cNormalError = Summarise(std::move(m_stdNormalError));
    m_cTotals.m_cDirectionError = Summarise(std::move(m_stdDirectionError));
    m_cTotals.m_cSpeedError = SummariseSigned(std::move(m_stdSpeedError));
    m_cTotals.m_cEnergyError = SummariseSigned(std::move(m_stdEnergyError));
    m_cTotals.m_cPositionError = Summarise(std::move(m_stdPositionError));
    m_cTotals.m_cPenetration = Summarise(std::move(m_stdPenetration));
    return m_cTotals;
  }

private:
  CTotals m_cTotals;
  std::vector<double> m_stdSetback, m_stdSetbackError, m_stdSetbackErrorNormal, m_stdTimeError;
  std::vector<double> m_stdPOIError, m_stdNormalError;
  std::vector<double> m_stdDirectionError, m_stdSpeedError, m_stdEnergyError, m_stdPositionError;
  std::vector<double> m_stdPenetration;
};

constexpr double g_fDegree = std::numbers::pi / 180.0;

// A way to sort contacts: bin i has the values from edge i - 1 up to edge i.
struct CSorting {
  const char* m_sBy;
  std::vector<double> m_stdEdges;
  std::vector<const char*> m_stdLabels; // one more than edges
  double (*m_pValue)(const CContact&);
};

const std::vector<CSorting>& GetSortings() {
  static const std::vector<CSorting> sortings = {
      {"travel",
       {0.25, 0.5, 1.0, 2.0, 4.0},
       {"< 0.25 r", "0.25 - 0.5 r", "0.5 - 1 r", "1 - 2 r", "2 - 4 r", ">= 4 r"},
       [](const CContact& c) { return AsDouble(c.m_fTravel); }},
      {"incidence",
       {15.0, 30.0, 45.0, 60.0, 75.0},
       {"0 - 15 deg", "15 - 30 deg", "30 - 45 deg", "45 - 60 deg", "60 - 75 deg", "75 - 90 deg"},
       [](const CContact& c) { return AsDouble(c.m_fIncidence) / g_fDegree; }},
      {"pair",
       {0.5, 1.5, 2.5, 3.5, 4.5, 5.5},
       {"point", "segment", "segment end", "circle", "arc", "arc end", "ball"},
       [](const CContact& c) { return static_cast<double>(c.m_ePair); }},
      // Products of exactly 1 have a bin of their own: there energy is kept.
      {"elasticity",
       {0.25, 0.5, 0.75, 1.0, std::nextafter(1.0, 2.0)},
       {"< 0.25", "0.25 - 0.5", "0.5 - 0.75", "0.75 - 1", "1", "> 1"},
       [](const CContact& c) { return AsDouble(c.m_fElasticity); }},
  };
  return sortings;
}

std::array<double, g_nHistogramBins + 1> MakeEdges() {
  std::array<double, g_nHistogramBins + 1> edges;
  for (std::size_t i = 0; i < edges.size(); ++i)
    edges[i] = std::pow(10.0, static_cast<double>(i) / 4.0 - 6.0);
  return edges;
}

const std::array<double, g_nHistogramBins + 1>& GetEdges() {
  static const auto edges = MakeEdges();
  return edges;
}

void Count(float value, std::vector<std::size_t>& counts) {
  // Only the edges between two bins decide, so both ends are open.
  const auto& edges = GetEdges();
  ++counts[static_cast<std::size_t>(std::upper_bound(edges.begin() + 1, edges.end() - 1, AsDouble(value)) -
                                    (edges.begin() + 1))];
}

} // namespace

CTotals MakeTotals(std::span<const CContact> contacts, std::size_t engine) {
  CGatherer gatherer;
  for (const CContact& contact : contacts)
    gatherer.Add(contact.m_stdEngines[engine]);
  return gatherer.Summarised();
}

CSummary SummariseDifference(std::span<const CContact> contacts) {
  std::vector<double> differences;
  for (const CContact& contact : contacts)
    if (contact.m_bHasDifference) differences.push_back(AsDouble(contact.m_fDifference));
  return Summarise(std::move(differences));
}

std::vector<CBin> MakeBins(std::span<const CContact> contacts, std::size_t engine) {
  std::vector<CBin> bins;
  for (const CSorting& sorting : GetSortings()) {
    std::vector<CGatherer> gatherers(sorting.m_stdLabels.size());
    for (const CContact& contact : contacts) {
      const auto& edges = sorting.m_stdEdges;
      const auto i = std::upper_bound(edges.begin(), edges.end(), sorting.m_pValue(contact)) - edges.begin();
      gatherers[static_cast<std::size_t>(i)].Add(contact.m_stdEngines[engine]);
    }
    for (std::size_t i = 0; i < gatherers.size(); ++i)
      if (!gatherers[i].IsEmpty())
        bins.push_back({sorting.m_sBy, sorting.m_stdLabels[i], gatherers[i].Summarised()});
  }
  return bins;
}

double GetHistogramEdge(std::size_t i) { return GetEdges().at(i); }

CHistogram MakeHistogram(std::span<const CContact> contacts, std::size_t engine) {
  CHistogram histogram;
  histogram.m_stdSetbackError.assign(g_nHistogramBins, 0);
  histogram.m_stdPenetration.assign(g_nHistogramBins, 0);
  for (const CContact& contact : contacts) {
    const CEngineContact& c = contact.m_stdEngines[engine];
    if (c.m_bDetected) Count(c.m_fSetbackError, histogram.m_stdSetbackError);
    if (!HasTunneled(c)) Count(c.m_fPenetration, histogram.m_stdPenetration);
  }
  return histogram;
}

} // namespace Shapes::Compare
