// SPDX-License-Identifier: MIT
#include "Totals.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Shapes::Compare {
namespace {

double AsDouble(float x) { return static_cast<double>(x); }

// Gathers contacts of one engine until they are summarised.
class CGatherer {
public:
  void Add(const CEngineContact& c) {
    ++m_cTotals.m_nContacts;
    m_cTotals.m_nMissed += c.m_eOutcome == eOutcome::Missed;
    m_cTotals.m_nWrongSide += c.m_eOutcome == eOutcome::WrongSide;
    m_cTotals.m_nLate += c.m_eOutcome == eOutcome::Late;
    m_cTotals.m_nOverlapped += !c.HasTunneled() && c.m_fPenetration > g_fOverlap;
    const auto figures = GetImpactFigures();
    for (std::size_t i = 0; i < figures.size(); ++i)
      if (figures[i].m_pIsMeasured(c) &&
          (figures[i].m_pIsSummarised == nullptr || figures[i].m_pIsSummarised(c)))
        m_stdValues[i].push_back(AsDouble(c.*figures[i].m_pOfImpact));
  }

  bool IsEmpty() const { return m_cTotals.m_nContacts == 0; }

  // Once only: hands over what was gathered.
  CTotals Summarised() {
    const auto figures = GetImpactFigures();
    for (std::size_t i = 0; i < figures.size(); ++i) {
      const auto summarise = figures[i].m_bIsSigned ? SummariseSigned : Summarise;
      m_cTotals.m_stdSummaries[i] = summarise(std::move(m_stdValues[i]));
    }
    return m_cTotals;
  }

private:
  CTotals m_cTotals;
  std::vector<std::vector<double>> m_stdValues = std::vector<std::vector<double>>(GetImpactFigures().size());
};

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

const std::array<double, g_nHistogramBins + 1>& GetEdges() {
  static const auto edges = [] {
    std::array<double, g_nHistogramBins + 1> made;
    for (std::size_t i = 0; i < made.size(); ++i)
      made[i] = std::pow(10.0, static_cast<double>(i) / 4.0 - 6.0);
    return made;
  }();
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
    if (!c.HasTunneled()) Count(c.m_fPenetration, histogram.m_stdPenetration);
  }
  return histogram;
}

} // namespace Shapes::Compare
