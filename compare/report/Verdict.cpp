// SPDX-License-Identifier: MIT
// The verdicts, in sentences: of one scene, and of the whole run.
#include "Numbers.h"
#include "Report.h"
#include "metrics/Overall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace Shapes::Compare {
namespace {

// The upper end of the interval of a time against the lower one, above which something else was running.
constexpr double g_fDisturbed = 1.5;

// Least values that a sentence mentions: a rate of ghosts, of late responses, a relative change of the
// energy.
constexpr double g_fGhostsToTell = 0.001, g_fLateToTell = 0.02, g_fChangeToTell = 0.001;
constexpr double g_fLeastSpeed = 0.001; // relative errors of speeds below it are alike

// Figures of an engine for a sentence, of one scene or over all of them.
struct CCase {
  const CEngineRow* m_pRow;
  std::size_t m_nLost;
  std::optional<double> m_fDirection; // radians, p95
  double m_fSpeed;                    // error, relative, p95; 0 where none was compared
  double m_fNs;
  const CCost* m_pCost; // of one scene; nullptr over all of them

  std::string GetName() const { return m_pRow->m_sSpoken; }
};

bool LosesMore(const CCase& a, const CCase& b) {
  return a.m_nLost > b.m_nLost && CanBeToldApart(a.m_nLost, b.m_nLost);
}
bool IsLessExact(const CCase& a, const CCase& b) {
  return a.m_fDirection && b.m_fDirection && *a.m_fDirection > *b.m_fDirection &&
         *a.m_fDirection > g_fSameDirection;
}
// Beyond a bound of the grades that b keeps.
bool HasWorseSpeeds(const CCase& a, const CCase& b) {
  const auto isBetween = [&](double bound) { return b.m_fSpeed <= bound && bound < a.m_fSpeed; };
  return isBetween(g_cGood.m_fSpeed) || isBetween(g_cRough.m_fSpeed);
}

// The relative error of a speed, as "67%".
std::string SpeedText(double error) { return TwoDigits(100.0 * std::max(error, g_fLeastSpeed)) + "%"; }

// How many times the time of b a takes: in one scene as its table has it.
double Times(const CCase& a, const CCase& b) {
  return a.m_pCost != nullptr ? CompareCosts(*a.m_pCost, *b.m_pCost).m_fMedian : a.m_fNs / b.m_fNs;
}

// "loses 1 in 40", "5% of its bounces are more than 8 degrees off": the worst that there is to say of a,
// against b.
std::string Flaw(const CCase& a, const CCase& b, std::size_t n) {
  if (LosesMore(a, b)) return "loses " + LossText(a.m_nLost, n);
  if (IsLessExact(a, b))
    return fmt::format("5% of its bounces are more than {} off", DegreesText(*a.m_fDirection));
  return HasWorseSpeeds(a, b) ? fmt::format("5% of its speeds are more than {} off", SpeedText(a.m_fSpeed))
                              : "";
}

// The fastest of the engines that are faster than `than` by more than can be overlooked; nullptr if none is.
const CCase* FindFaster(const std::vector<CCase>& cases, const CCase& than) {
  const CCase* pBest = nullptr;
  for (const CCase& c : cases)
    if (Times(c, than) < 0.95 && (pBest == nullptr || c.m_fNs < pBest->m_fNs)) pBest = &c;
  return pBest;
}

const CCase* FindBox2D(const std::vector<CCase>& cases) {
  for (const CCase& c : cases)
    if (c.m_pRow->m_sName == std::string_view(g_sBox2D)) return &c;
  return nullptr;
}

std::string Bounces(double direction) {
  return fmt::format(", and 95% of its bounces are within {} of the exact direction", DegreesText(direction));
}

// "; native-approximate is 1.9 times as fast as native but loses 1 in 40".
std::string Price(const std::vector<CCase>& cases, const CCase& take, std::size_t n) {
  const CCase* pFaster = FindFaster(cases, take);
  if (pFaster == nullptr) return "";
  const std::string flaw = Flaw(*pFaster, take, n);
  if (flaw.empty()) return "";
  return fmt::format("; {} is {} as {} but {}", pFaster->GetName(), FasterText(Times(take, *pFaster)),
                     take.GetName(), flaw);
}

class CVerdict {
public:
  CVerdict(const CRunReport& report, const CSceneReport& scene) : m_cReport(report), m_cScene(scene) {
    for (std::size_t e = 0; e < m_cScene.m_stdEngines.size(); ++e) {
      m_stdCases.push_back({&GetEngineRow(Name(e)), Totals(e).GetTunneled(),
                            Totals(e)["direction_error"].GetP95(), Totals(e)["speed_error"].m_fP95,
                            Cost(e).m_cNsPerBallStep.m_fMedian, &Cost(e)});
    }
  }

  std::vector<std::string> Make() const {
    if (m_cScene.m_stdEngines.empty()) return {};
    const auto take = FindTake(m_cReport, m_cScene);
    if (!take) return {Nothing()};
    return {Use(*take) + '.', Figures(*take) + '.'};
  }

  // Sentences about further weaknesses.
  std::vector<std::string> Remarks() const {
    std::vector<std::string> parts;
    const auto& engines = m_cScene.m_stdEngines;
    if (engines.empty() || m_cScene.m_cImpactTrials.m_stdContacts.empty()) return parts;
    const auto add = [&](const char* pWhat, const auto& isTold, const auto& text) {
      for (std::size_t e = 0; e < engines.size(); ++e)
        if (isTold(e)) return parts.push_back(fmt::format("{}: {}.", pWhat, Each(text)));
    };
    const std::size_t quiet = m_cScene.m_cImpactTrials.m_nQuietSteps, n = Totals(0).m_nContacts;
    add(
        fmt::format("Over {:g} s, in which contact lasts", m_cScene.m_cScene.m_fLasting).c_str(),
        [&](std::size_t e) { return engines[e].m_cLasting.m_nBalls > 0; },
        [&](std::size_t e) { return LastingText(engines[e].m_cLasting); });
    add(
        "Balls became NaN or infinite", [&](std::size_t e) { return Cost(e).m_nNotFinite > 0; },
        [&](std::size_t e) { return CountText(Cost(e).m_nNotFinite); });
    add(
        "Turned back one or two steps late",
        [&](std::size_t e) { return Wilson(Totals(e).m_nLate, n).m_fLow > g_fLateToTell; },
        [&](std::size_t e) { return RateText(Totals(e).m_nLate, n); });
    add(
        "Of the steps in which a ball only passes by, it is turned all the same in",
        [&](std::size_t e) { return Wilson(engines[e].m_nGhosts, quiet).m_fLow > g_fGhostsToTell; },
        [&](std::size_t e) { return RateText(engines[e].m_nGhosts, quiet); });
    const auto speed = [&](std::size_t e) { return Totals(e)["speed_error"]; };
    add(
        "95% of the speeds after an impact are this close to the exact ones",
        [&](std::size_t e) { return speed(e).m_nCount > 0 && speed(e).m_fP95 > g_cGood.m_fSpeed; },
        [&](std::size_t e) { return speed(e).m_nCount == 0 ? "not known" : SpeedText(speed(e).m_fP95); });
    add(
        "Energy over many bounces",
        [&](std::size_t e) {
          return std::abs(engines[e].m_cLongRun.m_fEnergyDrift.value_or(0.0)) >= g_fChangeToTell;
        },
        [&](std::size_t e) { return EnergyText(engines[e].m_cLongRun); });
    const auto time = [&](std::size_t e) { return Cost(e).m_cNsPerBallStep.m_cInterval; };
    add(
        "The times were disturbed, by nanoseconds between",
        [&](std::size_t e) { return time(e).m_fHigh > g_fDisturbed * time(e).m_fLow; },
        [&](std::size_t e) { return fmt::format("{:.0f} and {:.0f}", time(e).m_fLow, time(e).m_fHigh); });
    return parts;
  }

private:
  const std::string& Name(std::size_t e) const { return m_cReport.m_stdEngines[e].m_sName; }
  const CTotals& Totals(std::size_t e) const { return m_cScene.m_stdEngines[e].m_cTotals; }
  const CCost& Cost(std::size_t e) const { return m_cScene.m_stdEngines[e].m_cCost; }

  std::string Each(const std::function<std::string(std::size_t)>& text) const {
    std::string all;
    for (std::size_t e = 0; e < m_cScene.m_stdEngines.size(); ++e)
      all += fmt::format("{}{} {}", all.empty() ? "" : ", ", Name(e), text(e));
    return all;
  }

  std::string Nothing() const {
    const CImpactTrialResult& r = m_cScene.m_cImpactTrials;
    if (r.m_cExcluded.m_nUndecided > 0)
      return fmt::format("Nothing is judged: the exact reference gave up {} of {} trials, the first at {}.",
                         r.m_cExcluded.m_nUndecided, r.m_nTrials, r.m_cExcluded.m_sUndecided);
    return fmt::format("There is nothing to judge: {} in {} trials.",
                       r.m_cExcluded.m_nResting + r.m_cExcluded.m_nAmbiguous + r.m_cExcluded.m_nSimultaneous >
                               0
                           ? "every impact was set aside"
                           : "no ball met anything",
                       r.m_nTrials);
  }

  // The engine to take, how it is against Box2D, and what a faster one would cost.
  std::string Use(std::size_t e) const {
    const CCase &take = m_stdCases[e], *pBox2D = FindBox2D(m_stdCases);
    const std::size_t n = Totals(0).m_nContacts;
    const std::string price = Price(m_stdCases, take, n);
    if (m_stdCases.size() == 1) return fmt::format("{} is alone here", take.GetName());
    if (pBox2D == nullptr) return fmt::format("Use {}{}", take.GetName(), price);
    if (pBox2D == &take) return "Use Box2D: no faster engine is as good here" + price;
    const bool isBetter =
        LosesMore(*pBox2D, take) || IsLessExact(*pBox2D, take) || HasWorseSpeeds(*pBox2D, take);
    return fmt::format("Use {}: {} Box2D here and {}{}", take.GetName(),
                       isBetter ? "better than" : "as good as", FasterText(Times(*pBox2D, take)), price);
  }

  // Its figures, beside those of Box2D.
  std::string Figures(std::size_t e) const {
    const CCase& take = m_stdCases[e];
    const CCase* pBox2D = FindBox2D(m_stdCases);
    const auto lost = [&](const CCase& c) { return LossText(c.m_nLost, Totals(0).m_nContacts); };
    std::string text = fmt::format("It loses {}", lost(take));
    if (take.m_fDirection) text += Bounces(*take.m_fDirection);
    if (pBox2D != nullptr && pBox2D != &take) {
      text += fmt::format("; Box2D loses {}", lost(*pBox2D));
      if (pBox2D->m_fDirection) text += fmt::format(" and is within {}", DegreesText(*pBox2D->m_fDirection));
    }
    return text;
  }

  static std::string LastingText(const CLasting& lasting) {
    std::string text = fmt::format("loses {}", LossText(lasting.m_nLost, lasting.m_nBalls));
    if (lasting.m_fOverlap) text += fmt::format(" and ends {} radii deep", SizeText(*lasting.m_fOverlap));
    if (lasting.m_fFlow) text += fmt::format(", {} balls pass in a second", TwoDigits(*lasting.m_fFlow));
    return text + fmt::format(", at {} ns a step", TimeText(lasting.m_cNsPerBallStep.m_fMedian));
  }

  static std::string EnergyText(const CLongRun& run) {
    if (!run.m_fEnergyDrift) return "not known";
    const double change = *run.m_fEnergyDrift, percent = 100.0 * std::abs(change);
    const std::string text = std::abs(change) < g_fChangeToTell ? "kept"
                             : change >= 1.0
                                 ? "times " + TwoDigits(1.0 + change)
                                 : fmt::format("{}{}%", change > 0.0 ? "+" : "-", TwoDigits(percent));
    return fmt::format("{} in {}", text, CountText(run.m_nBounces));
  }

  const CRunReport& m_cReport;
  const CSceneReport& m_cScene;
  std::vector<CCase> m_stdCases;
};

} // namespace

std::vector<std::string> MakeVerdict(const CRunReport& report, const CSceneReport& scene) {
  return CVerdict(report, scene).Make();
}

std::vector<std::string> MakeRemarks(const CRunReport& report, const CSceneReport& scene) {
  return CVerdict(report, scene).Remarks();
}

std::string MakeResult(const CRunReport& report, const COverall& overall) {
  if (!overall.m_nTake) return "Nothing was judged.";
  std::vector<CCase> cases;
  for (std::size_t e = 0; e < overall.m_stdEngines.size(); ++e) {
    const CEngineOverall& engine = overall.m_stdEngines[e];
    cases.push_back({&GetEngineRow(report.m_stdEngines[e].m_sName), engine.m_nLost,
                     engine.m_nCompared == 0 ? std::nullopt : std::optional(engine.m_cDirection.m_fValue),
                     engine.m_fSpeed, engine.m_cNs.m_fMedian, nullptr});
  }
  const CCase& take = cases[*overall.m_nTake];
  const CCase* pBox2D = FindBox2D(cases);
  const bool isAgainst = pBox2D != nullptr && pBox2D != &take;
  const std::string n = CountText(overall.m_nImpacts);
  const auto loss = [](const CCase& c) { return c.m_nLost == 0 ? "none" : CountText(c.m_nLost); };
  std::string text = cases.size() == 1 ? take.GetName() + ": " : fmt::format("Take {}: ", take.GetName());
  text += isAgainst
              ? FasterText(overall.m_stdEngines[*overall.m_nTake].m_cTimes->m_fMedian) + " as Box2D. It "
              : "it ";
  text += fmt::format("loses {} of {} impacts", loss(take), n);
  if (isAgainst) text += fmt::format(" (Box2D {})", loss(*pBox2D));
  if (take.m_fDirection) text += Bounces(*take.m_fDirection);
  if (isAgainst && take.m_fDirection && pBox2D->m_fDirection)
    text += fmt::format(" (Box2D {})", DegreesText(*pBox2D->m_fDirection));
  return text + Price(cases, take, overall.m_nImpacts) + '.';
}

} // namespace Shapes::Compare
