// SPDX-License-Identifier: MIT
// A run on one screen of a terminal: a line for each scene as it is finished, and the result over all of
// them.
#include "Machine.h"
#include "Numbers.h"
#include "Report.h"
#include "Terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace Shapes::Compare {
namespace {

constexpr std::size_t g_nNameWidth = 18, g_nLostWidth = 8, g_nTimeWidth = 7;

// The name of an engine above a narrow column, in two lines.
struct CColumnName {
  std::string m_sAbove, m_sBelow;
};
CColumnName ColumnName(const CEngine& engine) {
  const std::size_t dash = engine.m_sName.find('-');
  if (dash == engine.m_sName.npos) return {"", engine.m_sName};
  const std::string kind = engine.m_sName.substr(dash + 1);
  return {engine.m_sName.substr(0, dash),
          kind.size() < g_nTimeWidth ? kind : kind.substr(0, g_nTimeWidth - 1)};
}

std::string HeadingLine(const std::vector<CEngine>& engines, const std::string& first,
                        std::string CColumnName::*pPart) {
  std::string line = fmt::format("{:<{}}", first, g_nNameWidth);
  for (const std::size_t width : {g_nLostWidth, g_nTimeWidth})
    for (const CEngine& engine : engines)
      line += fmt::format("{:>{}}", ColumnName(engine).*pPart, width);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string LostText(std::size_t lost, std::size_t n) {
  return lost == 0 && n > 0 ? "none" : RateText(lost, n);
}

double GeometricMean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double x : values)
    sum += std::log(x);
  return std::exp(sum / static_cast<double>(values.size()));
}

// One engine over all scenes with impacts.
struct COverall {
  std::size_t m_nImpacts = 0, m_nLost = 0;
  double m_fNs = 0.0;               ///< Geometric mean of the medians.
  CSummary m_cDirection;            ///< Radians, of all scenes together.
  std::vector<double> m_stdSpeedUp; ///< Time of box2d against this engine's, for each scene.
};

std::optional<std::size_t> FindEngine(const CRunReport& report, std::string_view name) {
  for (std::size_t e = 0; e < report.m_stdEngines.size(); ++e)
    if (report.m_stdEngines[e].m_sName == name) return e;
  return std::nullopt;
}

COverall MakeOverall(const CRunReport& report, std::size_t e) {
  COverall overall;
  std::vector<double> ns, directions;
  const auto box2d = FindEngine(report, g_sBox2D);
  for (const CSceneReport& scene : report.m_stdScenes) {
    const CTotals& totals = scene.m_stdEngines[e].m_cTotals;
    if (totals.m_nContacts == 0) continue;
    overall.m_nImpacts += totals.m_nContacts;
    overall.m_nLost += totals.GetTunneled();
    ns.push_back(scene.m_stdEngines[e].m_cCost.m_cNsPerBallStep.m_fMedian);
    if (box2d)
      overall.m_stdSpeedUp.push_back(
          CompareCosts(scene.m_stdEngines[*box2d].m_cCost, scene.m_stdEngines[e].m_cCost).m_fMedian);
    for (const CContact& contact : scene.m_cImpactTrials.m_stdContacts)
      if (contact.m_stdEngines[e].m_bCompared)
        directions.push_back(static_cast<double>(contact.m_stdEngines[e].m_fDirectionError));
  }
  if (!ns.empty()) overall.m_fNs = GeometricMean(ns);
  overall.m_cDirection = Summarise(std::move(directions));
  return overall;
}

std::string DirectionText(const CSummary& direction) {
  if (direction.m_nCount == 0) return "-";
  return direction.m_fP95 < g_fRounding ? "exact" : TwoDigits(direction.m_fP95 * 180.0 / std::numbers::pi);
}

// "6.1 times as fast", "1.2 times as slow", "as fast".
std::string SpeedText(double speedUp) {
  if (std::abs(speedUp - 1.0) < 0.05) return "as fast";
  const double ratio = speedUp < 1.0 ? 1.0 / speedUp : speedUp;
  return fmt::format("{:.{}f} times as {}", ratio, ratio < 9.95 ? 1 : 0, speedUp < 1.0 ? "slow" : "fast");
}

std::string OverallLine(const CEngine& engine, const COverall& overall) {
  const std::vector<double>& speed = overall.m_stdSpeedUp;
  std::string against;
  if (engine.m_sName != g_sBox2D && !speed.empty()) {
    const auto [least, most] = std::minmax_element(speed.begin(), speed.end());
    against = fmt::format("{:>11} ({} to {})", TwoDigits(GeometricMean(speed)), TwoDigits(*least),
                          TwoDigits(*most));
  }
  return fmt::format("{:<18}{:>11}{:>8}{:>9}{:>7}{}\n", engine.m_sName, CountText(overall.m_nLost),
                     LostText(overall.m_nLost, overall.m_nImpacts), DirectionText(overall.m_cDirection),
                     TimeText(overall.m_fNs), against);
}

// Which engine to take: the fastest of those that lose no more than Box2D as it ships.
std::string Result(const CRunReport& report, const std::vector<COverall>& overall) {
  const auto box2d = FindEngine(report, g_sBox2D);
  if (!box2d || overall.size() < 2 || overall[*box2d].m_nImpacts == 0) return {};
  const std::size_t most = overall[*box2d].m_nLost;
  std::size_t best = *box2d;
  for (std::size_t e = 0; e < overall.size(); ++e)
    if ((overall[e].m_nLost <= most || !CanBeToldApart(overall[e].m_nLost, most)) &&
        overall[e].m_fNs < overall[best].m_fNs)
      best = e;
  const std::string n = CountText(overall[best].m_nImpacts);
  if (best == *box2d)
    return fmt::format("Result: no other engine loses as few balls as box2d ({} of {}) in less time.",
                       CountText(most), n);
  const auto count = [](std::size_t lost) { return lost == 0 ? "none" : CountText(lost); };
  return fmt::format("Result: {} loses {} of {} balls, box2d {}; it is {} as box2d.",
                     report.m_stdEngines[best].m_sName, count(overall[best].m_nLost), n, count(most),
                     SpeedText(GeometricMean(overall[best].m_stdSpeedUp)));
}

} // namespace

std::string MakeHeading(const CRunReport& report) {
  const CMachine machine = DescribeMachine();
  std::string text =
      Wrap(fmt::format("Shapes {}, Box2D {}, {}; {}, {} cores; seed {}", machine.m_sShapes, machine.m_sBox2D,
                       machine.m_sCompiler, Ascii(machine.m_sCpu), machine.m_nCores, report.m_nSeed),
           0, 2) +
      '\n';
  const std::size_t engines = report.m_stdEngines.size();
  const std::string groups =
      fmt::format("{:<{}}{:>{}}{:>{}}", "", g_nNameWidth, "balls lost", g_nLostWidth * engines,
                  engines == 1 ? " ns" : "ns a ball-step", g_nTimeWidth * engines);
  return text + groups + '\n' + HeadingLine(report.m_stdEngines, "", &CColumnName::m_sAbove) +
         HeadingLine(report.m_stdEngines, "scene", &CColumnName::m_sBelow);
}

std::string MakeSceneLine(const CSceneReport& scene) {
  std::string name = Ascii(scene.m_cScene.m_sName);
  if (name.size() >= g_nNameWidth) name = name.substr(0, g_nNameWidth - 3) + "..";
  std::string line = fmt::format("{:<{}}", name, g_nNameWidth);
  if (scene.m_cImpactTrials.m_stdContacts.empty()) return line + "  nothing to judge: see the report\n";
  for (const CEngineReport& engine : scene.m_stdEngines)
    line += fmt::format("{:>{}}", LostText(engine.m_cTotals.GetTunneled(), engine.m_cTotals.m_nContacts),
                        g_nLostWidth);
  for (const CEngineReport& engine : scene.m_stdEngines)
    line += fmt::format("{:>{}}", TimeText(engine.m_cCost.m_cNsPerBallStep.m_fMedian), g_nTimeWidth);
  return line + '\n';
}

std::string MakeSummary(const CRunReport& report) {
  std::vector<COverall> overall;
  for (std::size_t e = 0; e < report.m_stdEngines.size(); ++e)
    overall.push_back(MakeOverall(report, e));
  if (overall.empty() || overall.front().m_nImpacts == 0) return "\nNothing was judged.\n";
  const std::string impacts = fmt::format("{} impacts", CountText(overall.front().m_nImpacts));
  std::string text = fmt::format("\n{:<18}{:>11}{:>8}{:>9}{:>7}{}\n", impacts, "lost", "", "degrees", "ns",
                                 FindEngine(report, g_sBox2D) ? "   times as fast as box2d" : "");
  for (std::size_t e = 0; e < overall.size(); ++e)
    text += OverallLine(report.m_stdEngines[e], overall[e]);
  if (const std::string result = Result(report, overall); !result.empty()) text += '\n' + Wrap(result, 0, 2);
  std::string legend =
      "lost: the exact ball is turned back, this one goes on. degrees: error of the direction after an "
      "impact, in 95% of them less. ns: nanoseconds for one step of one ball.";
  if (FindEngine(report, g_sBox2D))
    legend += " Times are geometric means of the scenes, with the extremes in brackets.";
  text += '\n' + Wrap(legend, 0, 0);
  if (report.m_bInterrupted)
    text += fmt::format("Interrupted: only the scenes that were finished ({}) are here.\n",
                        report.m_stdScenes.size());
  return text;
}

} // namespace Shapes::Compare
