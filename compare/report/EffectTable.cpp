// SPDX-License-Identifier: MIT
#include "Numbers.h"
#include "Report.h"
#include "Terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace Shapes::Compare {
namespace {

// Below this no error is spoken of: a thousandth of a radian or of the speed, a tenth of a radius. And it has
// to be another by half.
constexpr double g_fErrorToTell = 0.001, g_fFlightToTell = 0.1, g_fOther = 1.5;

// "+12%", "x15", "~0" if it cannot be told from nothing or is less than half a percent; in brackets where it
// would not run by itself.
std::string CostText(const CEffectCost& cost) {
  const CMedian ratio = cost.GetRatio();
  const double percent = 100.0 * (ratio.m_fMedian - 1.0);
  const std::string text = Overlap(ratio.m_cInterval, {1.0, 1.0}) || std::abs(percent) < 0.5 ? "~0"
                           : ratio.m_fMedian < 9.95 ? fmt::format("{:+.0f}%", percent)
                                                    : fmt::format("x{:.0f}", ratio.m_fMedian);
  return cost.IsCalledFor() ? text + " " : "(" + text + ")";
}

// cell(e) of each effect g_stdEffects[e].
template <class F>
std::string Row(std::string_view name, const F& cell) {
  std::string row = fmt::format("{:<18}", name);
  for (std::size_t e = 0; e < std::size(g_stdEffects); ++e)
    row += fmt::format("{:>{}}", cell(e), std::max<std::size_t>(9, GetName(g_stdEffects[e]).size() + 2));
  row.erase(row.find_last_not_of(' ') + 1);
  return row + '\n';
}

std::string Rows(const CSceneReport& scene) {
  std::string text = Wrap(Ascii(scene.m_cScene.m_sName), 0, 2);
  const std::vector<CEffectCost>& costs = scene.m_cEffects.m_stdCosts;
  for (std::size_t i = 0; i + std::size(g_stdEffects) <= costs.size(); i += std::size(g_stdEffects))
    text += Row(" " + costs[i].m_sEngine, [&](std::size_t e) { return CostText(costs[i + e]); });
  return text;
}

// Differences of the balls in the world with the effect toggled from that which the scene calls for. Of a
// forbidden effect only those for the worse.
class CChanges {
public:
  CChanges(const CEffectCost& cost, std::size_t touches)
      : m_bWorseOnly(cost.IsCalledFor()),
        m_cOther(cost.IsCalledFor() ? cost.m_cWithout : cost.m_cWith),
        m_cCalled(cost.IsCalledFor() ? cost.m_cWith : cost.m_cWithout) {
    const CTotals &a = m_cOther.m_cTotals, &b = m_cCalled.m_cTotals;
    if (b.m_nContacts == a.m_nContacts)
      AddCount("loses {} instead of {}", a.GetTunneled(), b.GetTunneled(), a.m_nContacts);
    AddError("flies {} radii off to the first impact instead of {}", m_cOther.m_cFlightError,
             m_cCalled.m_cFlightError, 1.0, g_fFlightToTell);
    AddError("directions within {} rad instead of {}", a["direction_error"], b["direction_error"], 1.0,
             g_fErrorToTell);
    AddError("speeds within {}% instead of {}%", a["speed_error"], b["speed_error"], 100.0, g_fErrorToTell);
    AddCount("misses {} of the touches of sensors instead of {}", m_cOther.m_nTouchesMissed,
             m_cCalled.m_nTouchesMissed, touches);
  }
  std::string Join() const { return fmt::format("{}", fmt::join(m_stdTexts, ", ")); }

private:
  static std::string Share(std::size_t hits, std::size_t n) { return hits == 0 ? "none" : RateText(hits, n); }
  bool IsToldOf(double other, double called) const { return other > called || !m_bWorseOnly; }
  void AddCount(const char* pFormat, std::size_t other, std::size_t called, std::size_t n) {
    if (CanBeToldApart(other, called) && IsToldOf(static_cast<double>(other), static_cast<double>(called)))
      m_stdTexts.push_back(fmt::format(fmt::runtime(pFormat), Share(other, n), Share(called, n)));
  }
  void AddError(const char* pFormat, const CSummary& other, const CSummary& called, double factor,
                double least) {
    const double a = other.m_fP95, b = called.m_fP95, high = std::max(a, b);
    if (other.m_nCount == 0 || called.m_nCount == 0 || !IsToldOf(a, b)) return;
    if (high > least && high > g_fOther * std::min(a, b))
      m_stdTexts.push_back(fmt::format(fmt::runtime(pFormat), SizeText(factor * a), SizeText(factor * b)));
  }

  bool m_bWorseOnly;
  const CEffectWorld &m_cOther, &m_cCalled;
  std::vector<std::string> m_stdTexts;
};

} // namespace

std::vector<std::string> MakeEffectChanges(const CSceneReport& scene) {
  std::vector<std::string> sentences;
  for (const eEffect e : g_stdEffects) // engines below each other
    for (const CEffectCost& cost : scene.m_cEffects.m_stdCosts) {
      if (cost.m_eEffect != e) continue;
      const std::string changes = CChanges(cost, scene.m_cEffects.m_nTouches).Join();
      if (!changes.empty())
        sentences.push_back(fmt::format("{} {} {}: {}.", cost.m_sEngine,
                                        cost.IsCalledFor() ? "without" : "with", GetName(e), changes));
    }
  return sentences;
}

std::string MakeEffectTable(const CRunReport& report) {
  const auto isMeasured = [](const CSceneReport& scene) { return !scene.m_cEffects.m_stdCosts.empty(); };
  if (std::none_of(report.m_stdScenes.begin(), report.m_stdScenes.end(), isMeasured)) return "";
  std::string text =
      "\nEffects\n\n" + Row("", [](std::size_t e) { return fmt::format("{} ", GetName(g_stdEffects[e])); });
  for (const CSceneReport& scene : report.m_stdScenes)
    if (isMeasured(scene)) text += Rows(scene);
  text +=
      '\n' + Wrap("By how much a step takes longer with an effect than without it; ~0: cannot be told from "
                  "nothing. Without brackets: the scene calls for it, so it runs unless it is forbidden. In "
                  "brackets: it does not, so this costs nothing unless it is forced.",
                  0, 0);
  std::string changes;
  std::size_t impacts = 0;
  for (const CSceneReport& scene : report.m_stdScenes)
    for (const std::string& sentence : MakeEffectChanges(scene)) {
      changes += Wrap(Ascii(scene.m_cScene.m_sName + ", " + sentence), 2, 4);
      for (const CEffectCost& cost : scene.m_cEffects.m_stdCosts)
        impacts = std::max(impacts, cost.m_cWith.m_cTotals.m_nContacts);
    }
  if (!changes.empty())
    text += fmt::format("\nWhat else changes, at up to {} impacts (p95 of errors):\n", CountText(impacts)) +
            changes;
  return text;
}

} // namespace Shapes::Compare
