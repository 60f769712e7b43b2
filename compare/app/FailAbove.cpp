// SPDX-License-Identifier: MIT
#include "FailAbove.h"

#include "NearMatches.h"
#include "report/Numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace Shapes::Compare {

static std::vector<std::string> GetMetricNames() {
  std::vector<std::string> names;
  for (const CFigure& figure : GetFigures())
    names.push_back(figure.m_sKey);
  return names;
}

CLimit ParseLimit(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const std::string_view value = equals == text.npos ? "" : text.substr(equals + 1);
  if (FindFigure(name) == nullptr) throw std::invalid_argument(UnknownName("metric", name, GetMetricNames()));
  CLimit limit{std::string(name), 0.0};
  const auto [pEnd, error] = std::from_chars(value.data(), value.data() + value.size(), limit.m_fMost);
  if (error != std::errc() || pEnd != value.data() + value.size() || !std::isfinite(limit.m_fMost) ||
      limit.m_fMost < 0.0)
    throw std::invalid_argument(
        fmt::format("{}=VALUE: expected a finite number of at least 0, got '{}'", name, value));
  return limit;
}

namespace {

// So many that none of them lost shows the rate to be below.
double NeededFor(const CLimit& limit) { return 3.0 / limit.m_fMost; }

std::string_view GetRateOf(const CLimit& limit) { return FindFigure(limit.m_sMetric)->m_sRateOf; }

bool AreFew(const CLimit& limit, std::size_t impacts) {
  return FindFigure(limit.m_sMetric)->m_pRate != nullptr && limit.m_fMost > 0.0 &&
         static_cast<double>(impacts) < NeededFor(limit);
}

std::string FewText(const CLimit& limit, std::size_t n) {
  const std::string& metric = limit.m_sMetric;
  return fmt::format("{}={:g}: even with none, {} {} show only that the rate is below {:.2g}; {} are needed",
                     metric, limit.m_fMost, CountText(n), GetRateOf(limit),
                     std::min(1.0, 3.0 / static_cast<double>(n)),
                     CountText(static_cast<std::size_t>(std::ceil(std::min(NeededFor(limit), 1e18)))));
}

// Whether there was something to measure where an engine has no value of a figure: another engine has one, or
// the engine lost every impact.
bool IsLacking(const CFigure& figure, const CSceneReport& scene, const CEngineReport& engine) {
  const CTotals& totals = engine.m_cTotals;
  const bool isAllLost = totals.m_nContacts > 0 && totals.GetTunneled() == totals.m_nContacts;
  return (figure.m_pOfImpact != nullptr && isAllLost) ||
         std::any_of(scene.m_stdEngines.begin(), scene.m_stdEngines.end(), [&](const CEngineReport& other) {
           return GetLimited(figure, scene, other).has_value();
         });
}

} // namespace

std::string WarnOfFew(const CLimit& limit, std::size_t contacts) {
  // Where contact lasts balls are counted in other trials than those of impacts.
  return AreFew(limit, contacts) && GetRateOf(limit) != "balls" ? FewText(limit, contacts) + " (--contacts)"
                                                                : "";
}

std::vector<std::string> WarnOfFewFound(const CRunReport& report, std::span<const CLimit> limits) {
  std::vector<std::string> warnings;
  for (const CSceneReport& scene : report.m_stdScenes) {
    const std::string& name = scene.m_cScene.m_sName;
    const CImpactTrialResult& trials = scene.m_cImpactTrials;
    if (trials.m_stdContacts.size() < report.m_nContacts)
      warnings.push_back(fmt::format("{}: {} of {} impacts were found in {} trials", name,
                                     CountText(trials.m_stdContacts.size()), CountText(report.m_nContacts),
                                     CountText(trials.m_nTrials)));
    for (const CLimit& limit : limits) {
      const auto pRate = FindFigure(limit.m_sMetric)->m_pRate;
      if (pRate == nullptr || scene.m_stdEngines.empty() || !WarnOfFew(limit, report.m_nContacts).empty())
        continue;
      // The same for all engines; where there are none, nothing was measured.
      const std::size_t n = pRate(scene, scene.m_stdEngines.front()).m_nOf;
      if (n > 0 && AreFew(limit, n)) warnings.push_back(name + ": " + FewText(limit, n));
    }
  }
  return warnings;
}

std::vector<std::string> FindAbove(const CRunReport& report, std::span<const CLimit> limits) {
  std::vector<std::string> above;
  for (const CLimit& limit : limits) {
    const CFigure& figure = *FindFigure(limit.m_sMetric);
    bool measured = false;
    for (const CSceneReport& scene : report.m_stdScenes)
      for (std::size_t e = 0; e < scene.m_stdEngines.size(); ++e) {
        const std::optional<double> value = GetLimited(figure, scene, scene.m_stdEngines[e]);
        const std::string where =
            fmt::format("on {} with {}", scene.m_cScene.m_sName, report.m_stdEngines[e].m_sName);
        if (!value && IsLacking(figure, scene, scene.m_stdEngines[e])) {
          measured = true; // said here, for this engine
          above.push_back(
              limit.m_sMetric == "rest_time"
                  ? fmt::format("rest_time: not all balls come to rest {}: it cannot be held against {:.6g}",
                                where, limit.m_fMost)
                  : fmt::format("{} was not measured {}: it cannot be held against {:.6g}", figure.m_sKey,
                                where, limit.m_fMost));
        }
        measured |= value.has_value();
        // Written so that a NaN is above.
        if (value && !(*value <= limit.m_fMost))
          above.push_back(
              fmt::format("{} is {:.6g} {}: above {:.6g}", figure.m_sKey, *value, where, limit.m_fMost));
      }
    if (!measured)
      above.push_back(fmt::format("{} was not measured on any scene: it cannot be held against {:.6g}",
                                  figure.m_sKey, limit.m_fMost));
  }
  return above;
}

} // namespace Shapes::Compare
