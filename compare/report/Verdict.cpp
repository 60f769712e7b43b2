// SPDX-License-Identifier: MIT
#include "Numbers.h"
#include "Report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace Shapes::Compare {
namespace {

// Both engines are asked at the same impacts, so what counts are those that only one of them lost (Q.
// McNemar, Psychometrika 12, 1947, with correction for continuity, 95%). That none was lost by both is on the
// safe side.
bool CanBeToldApart(std::size_t a, std::size_t b) {
  const double both = static_cast<double>(a) + static_cast<double>(b);
  const double apart = std::abs(static_cast<double>(a) - static_cast<double>(b));
  return apart - 1.0 > 1.959964 * std::sqrt(both);
}

// The upper end of the interval of a time against the lower one, above which something else was running.
constexpr double g_fDisturbed = 1.5;

// What is too little to speak of: a rate of ghosts, of late responses, a relative change of the energy.
constexpr double g_fGhostsToTell = 0.001, g_fLateToTell = 0.02, g_fChangeToTell = 0.001;

class CVerdict {
public:
  CVerdict(const CRunReport& report, const CSceneReport& scene) : m_cReport(report), m_cScene(scene) {}

  std::vector<std::string> Make() const {
    if (m_cScene.m_stdEngines.empty()) return {};
    if (m_cScene.m_cRestart.m_stdContacts.empty()) return {Nothing()};
    std::vector<std::string> sentences{Losses() + "; " + Time() + "."};
    if (const std::string text = Direction(); !text.empty()) sentences.push_back(text + ".");
    if (const std::string text = Aside(); !text.empty()) sentences.push_back(text + ".");
    return sentences;
  }

private:
  std::size_t Count() const { return m_cScene.m_stdEngines.size(); }
  const std::string& Name(std::size_t e) const { return m_cReport.m_stdEngines[e].m_sName; }
  const CTotals& Totals(std::size_t e) const { return m_cScene.m_stdEngines[e].m_cTotals; }
  const CCost& Cost(std::size_t e) const { return m_cScene.m_stdEngines[e].m_cCost; }

  // "native <text>, box2d <text>", in this order of the engines.
  std::string Each(const std::vector<std::size_t>& order,
                   const std::function<std::string(std::size_t)>& text) const {
    std::string all;
    for (const std::size_t e : order)
      all += fmt::format("{}{} {}", all.empty() ? "" : ", ", Name(e), text(e));
    return all;
  }
  std::string Each(const std::function<std::string(std::size_t)>& text) const { return Each(Order(), text); }
  std::vector<std::size_t> Order() const {
    std::vector<std::size_t> order(Count());
    for (std::size_t e = 0; e < order.size(); ++e)
      order[e] = e;
    return order;
  }

  std::string Nothing() const {
    const CRestartResult& r = m_cScene.m_cRestart;
    if (r.m_cSetAside.m_nUndecided > 0)
      return fmt::format("Nothing is judged: the exact reference gave up {} of {} trials, the first at {}.",
                         r.m_cSetAside.m_nUndecided, r.m_nTrials, r.m_cSetAside.m_sUndecided);
    return fmt::format("There is nothing to judge: {} in {} trials.",
                       r.m_cSetAside.m_nResting + r.m_cSetAside.m_nAmbiguous + r.m_cSetAside.m_nSimultaneous +
                                   r.m_cSetAside.m_nApproximate >
                               0
                           ? "every impact was set aside"
                           : "no ball met anything",
                       r.m_nTrials);
  }

  std::string Losses() const {
    const std::size_t n = Totals(0).m_nContacts;
    const auto lost = [&](std::size_t e) { return Totals(e).GetTunneled(); };
    std::vector<std::size_t> order = Order();
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return lost(a) > lost(b); });
    if (lost(order.front()) == 0)
      return fmt::format("{} a ball in {} impacts",
                         Count() == 2 ? "Neither loses" : Name(0) + " does not lose", CountText(n));
    const bool open = Count() == 2 && !CanBeToldApart(lost(0), lost(1));
    // The one that loses more comes first.
    std::string text;
    for (const std::size_t e : order) {
      const std::string rate =
          lost(e) == 0 ? fmt::format("none of {}", CountText(n)) : RateTextWithError(lost(e), n);
      text += text.empty() ? fmt::format("{} loses {} of the balls", Name(e), rate)
                           : fmt::format(", {} {}", Name(e), rate);
    }
    return open ? fmt::format("Which one loses more cannot be told from {} impacts: {}", CountText(n), text)
                : text;
  }

  std::string Time() const {
    const auto ns = [&](std::size_t e) { return Cost(e).m_cNsPerBallStep.m_fMedian; };
    const auto whole = [](double x) { return CountText(static_cast<std::size_t>(std::lround(x))); };
    const auto each = [&](std::size_t e) {
      const CInterval& i = Cost(e).m_cNsPerBallStep.m_cInterval;
      if (i.m_fHigh <= g_fDisturbed * i.m_fLow) return whole(ns(e)) + " ns";
      return fmt::format("{} ns, disturbed: {} to {}", whole(ns(e)), whole(i.m_fLow), whole(i.m_fHigh));
    };
    if (Count() != 2) return fmt::format("a step of a ball takes {}", each(0));
    const CMedian ratio01 = CompareCosts(Cost(0), Cost(1));
    if (Overlap(ratio01.m_cInterval, {1.0, 1.0}))
      return fmt::format("their times cannot be told apart ({} and {} for a step of a ball)", each(0),
                         each(1));
    const std::size_t fast = ratio01.m_fMedian < 1.0 ? 0 : 1, slow = 1 - fast;
    const double ratio = std::max(ratio01.m_fMedian, 1.0 / ratio01.m_fMedian);
    const std::string part =
        ratio >= 1.95 ? fmt::format("1/{:.0f}", ratio) : fmt::format("{:.0f}%", 100.0 / ratio);
    return fmt::format("{} takes {} of the time ({} against {} for a step of a ball)", Name(fast), part,
                       each(fast), each(slow));
  }

  std::string Direction() const {
    const auto error = [&](std::size_t e) -> std::string {
      const CSummary& summary = Totals(e).m_cDirectionError;
      if (summary.m_nCount == 0) return "not known";
      if (summary.m_fP95 == 0.0) return "exact";
      // Within what the digits show.
      return fmt::format("within {} rad", summary.m_fP95 < 0.0005 ? "0.001" : SizeText(summary.m_fP95));
    };
    std::string text = "Where the ball is turned back, 95% of its directions are ";
    if (Count() == 2 && error(0) == error(1)) return text + error(0) + " on both";
    for (std::size_t e = 0; e < Count(); ++e)
      text += fmt::format("{}{} on {}", e == 0 ? "" : ", ", error(e), Name(e));
    return text;
  }

  // What else there is to tell.
  std::string Aside() const {
    std::vector<std::string> parts;
    const auto any = [&](const std::function<bool(std::size_t)>& test) {
      const std::vector<std::size_t> order = Order();
      return std::any_of(order.begin(), order.end(), test);
    };
    const auto& engines = m_cScene.m_stdEngines;
    if (any([&](std::size_t e) { return Cost(e).m_nNotFinite > 0; }))
      parts.push_back("Balls became NaN or infinite: " +
                      Each([&](std::size_t e) { return CountText(Cost(e).m_nNotFinite); }));
    if (any([&](std::size_t e) {
          return Wilson(Totals(e).m_nLate, Totals(e).m_nContacts).m_fLow > g_fLateToTell;
        }))
      parts.push_back("Turned back one or two steps late: " + Each([&](std::size_t e) {
                        return RateText(Totals(e).m_nLate, Totals(e).m_nContacts);
                      }));
    const std::size_t quiet = m_cScene.m_cRestart.m_nQuietSteps;
    if (any([&](std::size_t e) { return Wilson(engines[e].m_nGhosts, quiet).m_fLow > g_fGhostsToTell; }))
      parts.push_back("Of the steps in which a ball only passes by, it is turned all the same in " +
                      Each([&](std::size_t e) { return RateText(engines[e].m_nGhosts, quiet); }));
    if (any([&](std::size_t e) { return std::abs(EnergyChange(engines[e].m_cLongRun)) >= g_fChangeToTell; }))
      parts.push_back("Energy over many bounces: " +
                      Each([&](std::size_t e) { return EnergyText(engines[e].m_cLongRun); }));
    return fmt::format("{}", fmt::join(parts, ". "));
  }

  // Relative, over the whole run; 0 where the scene does not keep the energy.
  static double EnergyChange(const CLongRun& run) { return run.m_fEnergyDrift.value_or(0.0); }

  static std::string EnergyText(const CLongRun& run) {
    if (!run.m_fEnergyDrift) return "not known";
    const double change = EnergyChange(run), percent = 100.0 * std::abs(change);
    const std::string text = std::abs(change) < g_fChangeToTell ? "kept"
                             : change >= 1.0
                                 ? "times " + TwoDigits(1.0 + change)
                                 : fmt::format("{}{}%", change > 0.0 ? "+" : "-", TwoDigits(percent));
    return fmt::format("{} in {}", text, CountText(run.m_nBounces));
  }

  const CRunReport& m_cReport;
  const CSceneReport& m_cScene;
};

} // namespace

std::vector<std::string> MakeVerdict(const CRunReport& report, const CSceneReport& scene) {
  return CVerdict(report, scene).Make();
}

} // namespace Shapes::Compare
