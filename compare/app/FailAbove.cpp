// SPDX-License-Identifier: MIT
#include "FailAbove.h"

#include "NearMatches.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace Shapes::Compare {
std::vector<std::string> GetMetricNames() {
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

std::string WarnOfFew(const CLimit& limit, std::size_t contacts) {
  const double needed = 3.0 / limit.m_fMost;
  if (FindFigure(limit.m_sMetric)->m_pRate == nullptr || limit.m_fMost == 0.0 ||
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
    const CFigure& figure = *FindFigure(limit.m_sMetric);
    bool measured = false;
    for (const CSceneReport& scene : report.m_stdScenes)
      for (std::size_t e = 0; e < scene.m_stdEngines.size(); ++e) {
        const std::optional<double> value = GetLimited(figure, scene, scene.m_stdEngines[e]);
        measured |= value.has_value();
        // Written so that a NaN is above.
        if (value && !(*value <= limit.m_fMost))
          above.push_back(fmt::format("{} is {:.6g} on {} with {}: above {:.6g}", figure.m_sKey, *value,
                                      scene.m_cScene.m_sName, report.m_stdEngines[e].m_sName, limit.m_fMost));
      }
    if (!measured)
      above.push_back(fmt::format("{} was not measured on any scene: it cannot be held against {:.6g}",
                                  figure.m_sKey, limit.m_fMost));
  }
  return above;
}

} // namespace Shapes::Compare
