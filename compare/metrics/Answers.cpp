// SPDX-License-Identifier: MIT
// What the ladder of a scene says to somebody who has to choose a setting.
#include "WorkPrecision.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace Shapes::Compare {
namespace {

double GetCost(const CRung& rung) { return rung.m_cNsPerBallSecond.m_fMedian; }

double GetTunneledRate(const CRung& rung) {
  return static_cast<double>(rung.GetAllTunneled()) / static_cast<double>(rung.GetAllContacts());
}

std::string Time(double ns) {
  if (ns < 999.5) return fmt::format("{:.0f} ns", ns);
  const double us = ns / 1000;
  return us < 9.95    ? fmt::format("{:.1f} us", us)
         : us < 999.5 ? fmt::format("{:.0f} us", us)
                      : fmt::format("{:.1f} ms", us / 1000);
}

std::string Setting(const CRung& rung) {
  return fmt::format("{} ({})", rung.m_cEngine.m_sName, rung.m_cEngine.GetLabel());
}

using CTest = std::function<bool(const CRung&)>;

// The cheapest rung of an engine (of any if the name is empty) that passes; nullptr if none does.
const CRung* FindCheapest(const std::vector<CRung>& rungs, const std::string& engine, const CTest& passes) {
  const CRung* pBest = nullptr;
  for (const CRung& rung : rungs) {
    if (rung.m_cEngine.m_sName == g_sExact || rung.m_nContacts == 0) continue;
    if (!engine.empty() && rung.m_cEngine.m_sName != engine) continue;
    if (passes(rung) && (pBest == nullptr || GetCost(rung) < GetCost(*pBest))) pBest = &rung;
  }
  return pBest;
}

// Whether native without Continuous does it too, and for less: then sweeping its balls is no answer.
bool IsBeatenByNative(const std::vector<CRung>& rungs, const CRung& rung, const CTest& passes) {
  if (rung.m_cEngine.m_sName != g_sNativeContinuous) return false;
  const CRung* pNative = FindCheapest(rungs, g_sNative, passes);
  return pNative != nullptr && GetCost(*pNative) <= GetCost(rung);
}

// How close one comes: the setting whose error, or share of lost balls, whichever is larger, is the smallest.
std::string Best(const std::vector<CRung>& rungs) {
  const CRung* pBest = nullptr;
  for (const CRung& rung : rungs) {
    if (rung.m_cEngine.m_sName == g_sExact || rung.m_nContacts == 0 || !rung.m_fDirectionErrorP95) continue;
    const auto key = [](const CRung& r) { return std::max(GetTunneledRate(r), *r.m_fDirectionErrorP95); };
    if (pBest == nullptr || key(rung) < key(*pBest)) pBest = &rung;
  }
  if (pBest == nullptr) return "";
  return fmt::format("; the best is {} with {:.2g} rad and {:.2g}% lost", Setting(*pBest),
                     *pBest->m_fDirectionErrorP95, 100.0 * GetTunneledRate(*pBest));
}

// One sentence: the cheapest of all, and what the other engines need for the same.
std::string Answer(const std::vector<CRung>& rungs, const std::string& what, const CTest& passes) {
  const CRung* pBest = FindCheapest(rungs, "", passes);
  if (pBest == nullptr) return fmt::format("{}: no setting that was tried{}.", what, Best(rungs));
  std::string text =
      fmt::format("{}: {}, {} per ball and second", what, Setting(*pBest), Time(GetCost(*pBest)));
  std::vector<std::string> seen{pBest->m_cEngine.m_sName, g_sExact};
  std::vector<std::string> without;
  for (const CRung& rung : rungs) {
    const std::string& engine = rung.m_cEngine.m_sName;
    if (std::find(seen.begin(), seen.end(), engine) != seen.end()) continue;
    seen.push_back(engine);
    const CRung* pOther = FindCheapest(rungs, engine, passes);
    if (pOther == nullptr)
      without.push_back(engine);
    else if (!IsBeatenByNative(rungs, *pOther, passes))
      text += fmt::format("; {} takes {:.1f} times as long", Setting(*pOther),
                          GetCost(*pOther) / GetCost(*pBest));
  }
  if (!without.empty()) text += fmt::format("; no setting of {} that was tried", fmt::join(without, " or "));
  return text + ".";
}

} // namespace

std::vector<std::string> MakeAnswers(const std::vector<CRung>& rungs, std::size_t proof) {
  const auto below = [](double bound) {
    return [bound](const CRung& rung) {
      return rung.m_fDirectionErrorP95 && *rung.m_fDirectionErrorP95 < bound && GetTunneledRate(rung) < bound;
    };
  };
  return {Answer(rungs, "Direction within .01 rad and less than 1% lost", below(0.01)),
          Answer(rungs, "Direction within .001 rad and less than .1% lost", below(0.001)),
          Answer(rungs, fmt::format("None lost in {} impacts", proof), [&](const CRung& rung) {
            return rung.GetAllTunneled() == 0 && rung.GetAllContacts() >= proof;
          })};
}

} // namespace Shapes::Compare
