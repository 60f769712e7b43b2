// SPDX-License-Identifier: MIT
#include "Numbers.h"
#include "Report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>

namespace Shapes::Compare {
namespace {

// The upper end of the interval of a time against the lower one, above which something else was running.
constexpr double g_fDisturbed = 1.5;

// What is too little to speak of: a rate of ghosts, of late responses, a relative change of the energy.
constexpr double g_fGhostsToTell = 0.001, g_fLateToTell = 0.02, g_fChangeToTell = 0.001;

// "a", "a and b", "a, b and c".
std::string JoinNames(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  const auto last = names.end() - 1;
  return names.size() == 1 ? *last : fmt::format("{} and {}", fmt::join(names.begin(), last, ", "), *last);
}

class CVerdict {
public:
  CVerdict(const CRunReport& report, const CSceneReport& scene) : m_cReport(report), m_cScene(scene) {
    for (std::size_t e = 0; e < m_cScene.m_stdEngines.size(); ++e)
      if (IsWorthNaming(e)) m_stdNamed.push_back(e);
  }

  std::vector<std::string> Make() const {
    if (m_cScene.m_stdEngines.empty()) return {};
    if (m_cScene.m_cImpactTrials.m_stdContacts.empty()) return {Nothing()};
    std::vector<std::string> sentences;
    if (const std::string text = Cheap(); !text.empty()) sentences.push_back(text);
    if (Count() > 1) sentences.push_back(Winners());
    for (const std::string& text : {Losses(), Time(), Direction()})
      sentences.push_back(text);
    const std::vector<std::string> asides = Asides();
    sentences.insert(sentences.end(), asides.begin(), asides.end());
    for (std::string& sentence : sentences)
      sentence += '.';
    return sentences;
  }

private:
  std::size_t Count() const { return m_stdNamed.size(); }
  const std::string& Name(std::size_t e) const { return m_cReport.m_stdEngines[e].m_sName; }
  const CTotals& Totals(std::size_t e) const { return m_cScene.m_stdEngines[e].m_cTotals; }
  const CCost& Cost(std::size_t e) const { return m_cScene.m_stdEngines[e].m_cCost; }

  std::optional<std::size_t> Find(std::string_view name) const {
    for (std::size_t e = 0; e < m_cScene.m_stdEngines.size(); ++e)
      if (Name(e) == name) return e;
    return std::nullopt;
  }

  // native-continuous is named where it tells something that native does not.
  bool IsWorthNaming(std::size_t e) const {
    const auto native = Find(g_sNative);
    if (Name(e) != g_sNativeContinuous || !native) return true;
    return AreLossesApart(e, *native) || DirectionText(e) != DirectionText(*native) ||
           GetAlarms(e) != GetAlarms(*native);
  }

  // The numbers of the engines, the least by `key` first.
  std::vector<std::size_t> SortedBy(const std::function<double(std::size_t)>& key) const {
    std::vector<std::size_t> order = m_stdNamed;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    return order;
  }

  // "native <text>, box2d <text>", in the order of the engines.
  std::string Each(const std::function<std::string(std::size_t)>& text) const {
    std::string all;
    for (const std::size_t e : m_stdNamed)
      all += fmt::format("{}{} {}", all.empty() ? "" : ", ", Name(e), text(e));
    return all;
  }

  std::vector<std::string> NamesOf(const std::function<bool(std::size_t)>& test) const {
    std::vector<std::string> names;
    for (const std::size_t e : m_stdNamed)
      if (test(e)) names.push_back(Name(e));
    return names;
  }

  std::string Nothing() const {
    const CImpactTrialResult& r = m_cScene.m_cImpactTrials;
    if (r.m_cExcluded.m_nUndecided > 0)
      return fmt::format("Nothing is judged: the exact reference gave up {} of {} trials, the first at {}.",
                         r.m_cExcluded.m_nUndecided, r.m_nTrials, r.m_cExcluded.m_sUndecided);
    return fmt::format("There is nothing to judge: {} in {} trials.",
                       r.m_cExcluded.m_nResting + r.m_cExcluded.m_nAmbiguous + r.m_cExcluded.m_nSimultaneous +
                                   r.m_cExcluded.m_nApproximate >
                               0
                           ? "every impact was set aside"
                           : "no ball met anything",
                       r.m_nTrials);
  }

  double Lost(std::size_t e) const { return static_cast<double>(Totals(e).GetTunneled()); }
  bool AreLossesApart(std::size_t a, std::size_t b) const {
    return CanBeToldApart(Totals(a).GetTunneled(), Totals(b).GetTunneled());
  }
  double Ns(std::size_t e) const { return Cost(e).m_cNsPerBallStep.m_fMedian; }
  bool AreTimesApart(std::size_t a, std::size_t b) const {
    return a != b && !Overlap(CompareCosts(Cost(a), Cost(b)).m_cInterval, {1.0, 1.0});
  }
  double DirectionError(std::size_t e) const {
    const CSummary& summary = Totals(e)["direction_error"];
    return summary.m_nCount == 0 ? std::numeric_limits<double>::infinity() : summary.m_fP95;
  }

  // What is worse on one engine than on another; empty if nothing is.
  std::string Flaws(std::size_t e, std::size_t than) const {
    std::vector<const char*> flaws;
    if (Lost(e) > Lost(than) && AreLossesApart(e, than)) flaws.push_back("loses more");
    if (DirectionError(e) > DirectionError(than) && DirectionText(e) != DirectionText(than))
      flaws.push_back("has worse directions");
    return fmt::format("{}", fmt::join(flaws, " and "));
  }

  // "in 1/47 of the time".
  std::string TimeAgainst(std::size_t e, std::size_t other) const {
    const double ratio = CompareCosts(Cost(other), Cost(e)).m_fMedian;
    return ratio > 1.5 ? fmt::format("in 1/{:.0f} of the time", ratio)
                       : fmt::format("in {:.1f} times the time", 1.0 / ratio);
  }

  // What somebody who has balls of Box2D wants to know; the measure is what these do at the same impacts.
  std::string Cheap() const {
    const auto native = Find(g_sNative), box2d = Find(g_sBox2D);
    if (!native || !box2d) return {};
    const std::string question = "Are cheap balls as good as box2d's? ", flaws = Flaws(*native, *box2d);
    if (flaws.empty()) return fmt::format("{}Yes, native's are, {}", question, TimeAgainst(*native, *box2d));
    const auto continuous = Find(g_sNativeContinuous);
    if (!continuous || !IsWorthNaming(*continuous)) return fmt::format("{}No: native {}", question, flaws);
    const std::string left = Flaws(*continuous, *box2d);
    if (left.empty())
      return fmt::format("{}Not native's, which {}; native-continuous's are, {}", question, flaws,
                         TimeAgainst(*continuous, *box2d));
    return fmt::format("{}No: native {}, native-continuous {}", question, flaws,
                       left == flaws ? "too" : left);
  }

  // Who is the best in what, or no worse than the best as far as can be told.
  std::string Winners() const {
    const std::size_t lost = SortedBy([&](std::size_t e) { return Lost(e); })[0];
    const std::size_t straight = SortedBy([&](std::size_t e) { return DirectionError(e); })[0];
    const std::size_t fast = SortedBy([&](std::size_t e) { return Ns(e); })[0];
    const auto best = [&](const std::function<bool(std::size_t)>& test) {
      const std::vector<std::string> names = NamesOf(test);
      return names.size() == Count() ? "no difference" : JoinNames(names);
    };
    return fmt::format("Fewest lost: {}; best directions: {}; fastest: {}",
                       best([&](std::size_t e) { return !AreLossesApart(e, lost); }),
                       std::isinf(DirectionError(straight)) ? "not known" : best([&](std::size_t e) {
                         return DirectionText(e) == DirectionText(straight);
                       }),
                       best([&](std::size_t e) { return !AreTimesApart(e, fast); }));
  }

  // The one that loses most comes first.
  std::string Losses() const {
    const std::size_t n = Totals(0).m_nContacts;
    const std::vector<std::size_t> order = SortedBy([&](std::size_t e) { return -Lost(e); });
    if (Lost(order.front()) == 0.0)
      return fmt::format("{} a ball in {} impacts",
                         Count() == 1   ? Name(order.front()) + " does not lose"
                         : Count() == 2 ? "Neither loses"
                                        : "None loses",
                         CountText(n));
    const bool open = Count() > 1 && !AreLossesApart(order.front(), order.back());
    std::string text, ties;
    std::vector<std::string> without; // they come last
    for (std::size_t i = 0; i < Count(); ++i) {
      const std::size_t e = order[i], lost = Totals(e).GetTunneled();
      if (lost == 0) {
        without.push_back(Name(e));
        continue;
      }
      const std::string rate = RateTextWithError(lost, n);
      text += i == 0 ? fmt::format("{} loses {} of the balls", Name(e), rate)
                     : fmt::format(", {} {}", Name(e), rate);
      if (i > 0 && !open && !AreLossesApart(order[i - 1], e))
        ties += fmt::format("; {} and {} cannot be told apart", Name(order[i - 1]), Name(e));
    }
    if (!without.empty()) {
      const std::size_t last = order[Count() - without.size() - 1];
      if (!open && !AreLossesApart(last, order.back()))
        ties += fmt::format("; {} and {} cannot be told apart", Name(last), without.front());
      text += fmt::format(", {} none of {}", JoinNames(without), CountText(n));
    }
    return open ? fmt::format("Which one loses more cannot be told from {} impacts: {}", CountText(n), text)
                : text + ties;
  }

  // The fastest comes first.
  std::string Time() const {
    const auto whole = [](double x) { return CountText(static_cast<std::size_t>(std::lround(x))); };
    const std::vector<std::size_t> order = SortedBy([&](std::size_t e) { return Ns(e); });
    const std::size_t fast = order.front();
    std::string text = "A step of a ball takes";
    for (const std::size_t e : order) {
      std::vector<std::string> remarks;
      const double ratio = CompareCosts(Cost(e), Cost(fast)).m_fMedian;
      if (e != fast && !AreTimesApart(e, fast))
        remarks.push_back("cannot be told apart");
      else if (e != fast)
        remarks.push_back(fmt::format("{:.{}f} times as long", ratio, ratio < 9.95 ? 1 : 0));
      const CInterval& i = Cost(e).m_cNsPerBallStep.m_cInterval;
      if (i.m_fHigh > g_fDisturbed * i.m_fLow)
        remarks.push_back(fmt::format("disturbed, {} to {}", whole(i.m_fLow), whole(i.m_fHigh)));
      text += fmt::format("{} {} ns on {}", e == fast ? "" : ",", whole(Ns(e)), Name(e));
      if (!remarks.empty()) text += fmt::format(" ({})", fmt::join(remarks, "; "));
    }
    return text;
  }

  std::string DirectionText(std::size_t e) const {
    const double error = DirectionError(e);
    if (std::isinf(error)) return "not known";
    return error < g_fRounding ? "exact" : fmt::format("within {} rad", SizeText(error));
  }

  // Engines with the same figure are named together.
  std::string Direction() const {
    std::string text = "Where the ball is turned back, 95% of its directions are ";
    std::vector<std::string> seen;
    for (const std::size_t e : m_stdNamed) {
      const std::string error = DirectionText(e);
      if (std::find(seen.begin(), seen.end(), error) != seen.end()) continue;
      const std::vector<std::string> names =
          NamesOf([&](std::size_t other) { return DirectionText(other) == error; });
      const bool all = Count() > 1 && names.size() == Count();
      text += fmt::format("{}{} on {}", seen.empty() ? "" : ", ", error,
                          !all           ? JoinNames(names)
                          : Count() == 2 ? "both"
                                         : "all");
      seen.push_back(error);
    }
    return text;
  }

  // What else may be wrong with an engine.
  struct CAlarms {
    bool m_bNotFinite, m_bLate, m_bGhosts, m_bEnergy;
    friend bool operator==(const CAlarms&, const CAlarms&) = default;
  };
  CAlarms GetAlarms(std::size_t e) const {
    const CEngineReport& engine = m_cScene.m_stdEngines[e];
    return {Cost(e).m_nNotFinite > 0, Wilson(Totals(e).m_nLate, Totals(e).m_nContacts).m_fLow > g_fLateToTell,
            Wilson(engine.m_nGhosts, m_cScene.m_cImpactTrials.m_nQuietSteps).m_fLow > g_fGhostsToTell,
            std::abs(EnergyChange(engine.m_cLongRun)) >= g_fChangeToTell};
  }

  // What else there is to tell.
  std::vector<std::string> Asides() const {
    std::vector<std::string> parts;
    const auto any = [&](bool CAlarms::*pAlarm) {
      return !NamesOf([&](std::size_t e) { return GetAlarms(e).*pAlarm; }).empty();
    };
    const auto& engines = m_cScene.m_stdEngines;
    if (any(&CAlarms::m_bNotFinite))
      parts.push_back("Balls became NaN or infinite: " +
                      Each([&](std::size_t e) { return CountText(Cost(e).m_nNotFinite); }));
    if (any(&CAlarms::m_bLate))
      parts.push_back("Turned back one or two steps late: " + Each([&](std::size_t e) {
                        return RateText(Totals(e).m_nLate, Totals(e).m_nContacts);
                      }));
    const std::size_t quiet = m_cScene.m_cImpactTrials.m_nQuietSteps;
    if (any(&CAlarms::m_bGhosts))
      parts.push_back("Of the steps in which a ball only passes by, it is turned all the same in " +
                      Each([&](std::size_t e) { return RateText(engines[e].m_nGhosts, quiet); }));
    if (any(&CAlarms::m_bEnergy))
      parts.push_back("Energy over many bounces: " +
                      Each([&](std::size_t e) { return EnergyText(engines[e].m_cLongRun); }));
    return parts;
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
  std::vector<std::size_t> m_stdNamed; // the engines that there is something to say about
};

} // namespace

std::vector<std::string> MakeVerdict(const CRunReport& report, const CSceneReport& scene) {
  return CVerdict(report, scene).Make();
}

} // namespace Shapes::Compare
