// SPDX-License-Identifier: MIT
#include "FailAbove.h"

#include "NearMatches.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

using CValue = std::optional<double>;

// One engine on one scene.
struct CMeasured {
  const CSceneReport& m_cScene;
  const CEngineReport& m_cEngine;
};

CValue RateValue(std::size_t hits, std::size_t n) {
  return n == 0 ? CValue() : static_cast<double>(hits) / static_cast<double>(n);
}

CValue P95Value(const CSummary& s) { return s.m_nCount == 0 ? CValue() : s.m_fP95; }

CValue RateOf(const CMeasured& m, std::size_t hits) {
  return RateValue(hits, m.m_cEngine.m_cTotals.m_nContacts);
}

struct CMetric {
  const char* m_sName;
  CValue (*m_pGet)(const CMeasured& m);
  bool m_bIsRate = false; // of impacts: what was not seen in n of them may still be 3/n
};

// Absent where it was not measured.
constexpr CMetric g_stdMetrics[] = {
    {"missed", [](const CMeasured& m) { return RateOf(m, m.m_cEngine.m_cTotals.m_nMissed); }, true},
    {"wrong_side", [](const CMeasured& m) { return RateOf(m, m.m_cEngine.m_cTotals.m_nWrongSide); }, true},
    {"tunneled", [](const CMeasured& m) { return RateOf(m, m.m_cEngine.m_cTotals.GetTunneled()); }, true},
    {"overlapped", [](const CMeasured& m) { return RateOf(m, m.m_cEngine.m_cTotals.m_nOverlapped); }, true},
    {"ghost",
     [](const CMeasured& m) { return RateValue(m.m_cEngine.m_nGhosts, m.m_cScene.m_cRestart.m_nQuietSteps); },
     true},
    {"late", [](const CMeasured& m) { return RateOf(m, m.m_cEngine.m_cTotals.m_nLate); }, true},
    {"setback_error", [](const CMeasured& m) { return P95Value(m.m_cEngine.m_cTotals.m_cSetbackError); }},
    {"poi_error", [](const CMeasured& m) { return P95Value(m.m_cEngine.m_cTotals.m_cPOIError); }},
    {"time_error", [](const CMeasured& m) { return P95Value(m.m_cEngine.m_cTotals.m_cTimeError); }},
    {"normal_error", [](const CMeasured& m) { return P95Value(m.m_cEngine.m_cTotals.m_cNormalError); }},
    {"direction_error", [](const CMeasured& m) { return P95Value(m.m_cEngine.m_cTotals.m_cDirectionError); }},
    {"speed_error", [](const CMeasured& m) { return P95Value(m.m_cEngine.m_cTotals.m_cSpeedError); }},
    {"energy_error", [](const CMeasured& m) { return P95Value(m.m_cEngine.m_cTotals.m_cEnergyError); }},
    {"position_error", [](const CMeasured& m) { return P95Value(m.m_cEngine.m_cTotals.m_cPositionError); }},
    {"penetration", [](const CMeasured& m) { return P95Value(m.m_cEngine.m_cTotals.m_cPenetration); }},
    {"energy_drift",
     [](const CMeasured& m) {
       const CValue& drift = m.m_cEngine.m_cLongRun.m_fEnergyDrift;
       return drift ? CValue(std::abs(*drift)) : CValue();
     }},
    {"ns_per_ball_step",
     [](const CMeasured& m) { return CValue(m.m_cEngine.m_cCost.m_cNsPerBallStep.m_fMedian); }},
};

const CMetric* FindMetric(std::string_view name) {
  for (const CMetric& metric : g_stdMetrics)
    if (metric.m_sName == name) return &metric;
  return nullptr;
}

} // namespace

std::vector<std::string> GetMetricNames() {
  std::vector<std::string> names;
  for (const CMetric& metric : g_stdMetrics)
    names.push_back(metric.m_sName);
  return names;
}

CLimit ParseLimit(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const std::string_view value = equals == text.npos ? "" : text.substr(equals + 1);
  if (FindMetric(name) == nullptr) throw std::invalid_argument(UnknownName("metric", name, GetMetricNames()));
  CLimit limit{std::string(name), 0.0};
  const auto [pEnd, error] = std::from_chars(value.data(), value.data() + value.size(), limit.m_fMost);
  if (error != std::errc() || pEnd != value.data() + value.size() || !std::isfinite(limit.m_fMost) ||
      limit.m_fMost < 0.0)
    throw std::invalid_argument(
        fmt::format("{}=VALUE: expected a finite number of at least 0, got '{}'", name, value));
  return limit;
}

std::string WarnOfFew(const CLimit& limit, std::size_t contacts) {
  const double needed = 3.0 / limit.m_fMost;
  if (!FindMetric(limit.m_sMetric)->m_bIsRate || limit.m_fMost == 0.0 ||
      static_cast<double>(contacts) >= needed)
    return "";
  return fmt::format(
      "{}={:g}: that none is above in {} impacts shows no more than a rate below {:.2g}; it takes "
      "{:.0f} (--contacts)",
      limit.m_sMetric, limit.m_fMost, contacts, 3.0 / static_cast<double>(contacts), std::ceil(needed));
}

std::vector<std::string> FindAbove(const CRunReport& report, std::span<const CLimit> limits) {
  std::vector<std::string> above;
  for (const CLimit& limit : limits) {
    const CMetric& metric = *FindMetric(limit.m_sMetric);
    bool measured = false;
    for (const CSceneReport& scene : report.m_stdScenes)
      for (std::size_t e = 0; e < scene.m_stdEngines.size(); ++e) {
        const CValue value = metric.m_pGet({scene, scene.m_stdEngines[e]});
        measured |= value.has_value();
        // Written so that a NaN is above.
        if (value && !(*value <= limit.m_fMost))
          above.push_back(fmt::format("{} is {:.6g} on {} with {}: above {:.6g}", metric.m_sName, *value,
                                      scene.m_cScene.m_sName, report.m_stdEngines[e].m_sName, limit.m_fMost));
      }
    if (!measured)
      above.push_back(fmt::format("{} was not measured on any scene: it cannot be held against {:.6g}",
                                  metric.m_sName, limit.m_fMost));
  }
  return above;
}

} // namespace Shapes::Compare
