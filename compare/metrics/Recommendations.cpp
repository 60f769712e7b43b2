// SPDX-License-Identifier: MIT
// Recommendations from the parameter sweep of a scene.
#include "WorkPrecision.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace Shapes::Compare {
namespace {

double GetCost(const CSetting& setting) { return setting.m_cNsPerBallSecond.m_fMedian; }

double GetTunneledRate(const CSetting& setting) {
  return static_cast<double>(setting.GetAllTunneled()) / static_cast<double>(setting.GetAllContacts());
}

std::string Time(double ns) {
  if (ns < 999.5) return fmt::format("{:.0f} ns", ns);
  const double us = ns / 1000;
  return us < 9.95    ? fmt::format("{:.1f} us", us)
         : us < 999.5 ? fmt::format("{:.0f} us", us)
                      : fmt::format("{:.1f} ms", us / 1000);
}

std::string Setting(const CSetting& setting) {
  return fmt::format("{} ({})", setting.m_cEngine.m_sName, setting.m_cEngine.GetLabel());
}

using CTest = std::function<bool(const CSetting&)>;

// The cheapest setting of an engine (of any if the name is empty) that passes; nullptr if none does.
const CSetting* FindCheapest(const std::vector<CSetting>& settings, const std::string& engine,
                             const CTest& passes) {
  const CSetting* pBest = nullptr;
  for (const CSetting& setting : settings) {
    if (setting.m_cEngine.m_sName == g_sExact || setting.m_nContacts == 0) continue;
    if (!engine.empty() && setting.m_cEngine.m_sName != engine) continue;
    if (passes(setting) && (pBest == nullptr || GetCost(setting) < GetCost(*pBest))) pBest = &setting;
  }
  return pBest;
}

// Whether native without Continuous does it too, and for less: then sweeping its balls is no answer.
bool IsBeatenByNative(const std::vector<CSetting>& settings, const CSetting& setting, const CTest& passes) {
  if (setting.m_cEngine.m_sName != g_sNativeContinuous) return false;
  const CSetting* pNative = FindCheapest(settings, g_sNative, passes);
  return pNative != nullptr && GetCost(*pNative) <= GetCost(setting);
}

// How close one comes: the setting whose error, or share of lost balls, whichever is larger, is the smallest.
std::string Best(const std::vector<CSetting>& settings) {
  const CSetting* pBest = nullptr;
  for (const CSetting& setting : settings) {
    if (setting.m_cEngine.m_sName == g_sExact || setting.m_nContacts == 0 || !setting.m_fDirectionErrorP95)
      continue;
    const auto key = [](const CSetting& r) { return std::max(GetTunneledRate(r), *r.m_fDirectionErrorP95); };
    if (pBest == nullptr || key(setting) < key(*pBest)) pBest = &setting;
  }
  if (pBest == nullptr) return "";
  return fmt::format("; the best is {} with {:.2g} rad and {:.2g}% lost", Setting(*pBest),
                     *pBest->m_fDirectionErrorP95, 100.0 * GetTunneledRate(*pBest));
}

// One sentence: the cheapest of all, and what the other engines need for the same.
std::string Answer(const std::vector<CSetting>& settings, const std::string& what, const CTest& passes) {
  const CSetting* pBest = FindCheapest(settings, "", passes);
  if (pBest == nullptr) return fmt::format("{}: no setting that was tried{}.", what, Best(settings));
  std::string text =
      fmt::format("{}: {}, {} per ball and second", what, Setting(*pBest), Time(GetCost(*pBest)));
  std::vector<std::string> seen{pBest->m_cEngine.m_sName, g_sExact};
  std::vector<std::string> without;
  for (const CSetting& setting : settings) {
    const std::string& engine = setting.m_cEngine.m_sName;
    if (std::find(seen.begin(), seen.end(), engine) != seen.end()) continue;
    seen.push_back(engine);
    const CSetting* pOther = FindCheapest(settings, engine, passes);
    if (pOther == nullptr)
      without.push_back(engine);
    else if (!IsBeatenByNative(settings, *pOther, passes))
      text += fmt::format("; {} takes {:.1f} times as long", Setting(*pOther),
                          GetCost(*pOther) / GetCost(*pBest));
  }
  if (!without.empty()) text += fmt::format("; no setting of {} that was tried", fmt::join(without, " or "));
  return text + ".";
}

} // namespace

std::vector<std::string> MakeRecommendations(const std::vector<CSetting>& settings, std::size_t proof) {
  const auto below = [](double bound) {
    return [bound](const CSetting& setting) {
      return setting.m_fDirectionErrorP95 && *setting.m_fDirectionErrorP95 < bound &&
             GetTunneledRate(setting) < bound;
    };
  };
  return {Answer(settings, "Direction within .01 rad and less than 1% lost", below(0.01)),
          Answer(settings, "Direction within .001 rad and less than .1% lost", below(0.001)),
          Answer(settings, fmt::format("None lost in {} impacts", proof), [&](const CSetting& setting) {
            return setting.GetAllTunneled() == 0 && setting.GetAllContacts() >= proof;
          })};
}

} // namespace Shapes::Compare
