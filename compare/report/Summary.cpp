// SPDX-License-Identifier: MIT
// A run on one screen of a terminal: a line for each scene as it is finished, and the result over all of
// them.
#include "Machine.h"
#include "Numbers.h"
#include "Report.h"
#include "Terminal.h"
#include "metrics/Overall.h"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace Shapes::Compare {
namespace {

// The columns of scenes, and of engines.
constexpr const char* g_sSummaryRow = "{:<18} {:<18} {:>15} {:>9} {:>7} {:>8}";

std::string SummaryRow(std::string_view first, std::string_view second, std::string_view lost,
                       std::string_view degrees, std::string_view ns, std::string_view times) {
  std::string row = fmt::format(fmt::runtime(g_sSummaryRow), first, second, lost, degrees, ns, times);
  row.erase(row.find_last_not_of(' ') + 1);
  return row + '\n';
}

std::string Degrees(bool isKnown, double radians) {
  if (!isKnown) return "-";
  const std::string text = DegreesText(radians);
  if (radians < 0.001 * g_fDegree) return "<0.001";
  return text.substr(0, text.find(' '));
}

std::string Times(const std::optional<CMedian>& times) { return times ? TwoDigits(times->m_fMedian) : ""; }

// Nothing for good.
std::string_view Sign(eGrade grade) {
  return grade == eGrade::Good ? "" : grade == eGrade::Rough ? " ~" : " !";
}

} // namespace

std::string MakeHeading(const CRunReport& report) {
  const CMachine machine = DescribeMachine();
  return Wrap(fmt::format("Shapes {}, Box2D {}, {}; {}, {} cores; seed {}", machine.m_sShapes,
                          machine.m_sBox2D, machine.m_sCompiler, Ascii(machine.m_sCpu), machine.m_nCores,
                          report.m_nSeed),
              0, 2) +
         SummaryRow("scene", "take", "lost", "degrees", "ns",
                    FindEngine(report.m_stdEngines, g_sBox2D) ? "x box2d" : "");
}

std::string MakeSceneLine(const CRunReport& report, const CSceneReport& scene) {
  std::string name = Ascii(scene.m_cScene.m_sName);
  if (name.size() > 18) name = name.substr(0, 16) + "..";
  const auto take = FindTake(report, scene);
  if (!take) return fmt::format("{:<18} nothing to judge: see the report\n", name);
  const CEngineReport& engine = scene.m_stdEngines[*take];
  const CTotals& totals = engine.m_cTotals;
  const CSummary& direction = totals["direction_error"];
  const auto box2d = FindEngine(report.m_stdEngines, g_sBox2D);
  return SummaryRow(
      name, report.m_stdEngines[*take].m_sName,
      fmt::format("{}{}", LossText(totals.GetTunneled(), totals.m_nContacts), Sign(GradeOf(totals))),
      Degrees(direction.m_nCount > 0, direction.m_fP95), TimeText(engine.m_cCost.m_cNsPerBallStep.m_fMedian),
      Times(box2d ? std::optional(CompareCosts(scene.m_stdEngines[*box2d].m_cCost, engine.m_cCost))
                  : std::nullopt));
}

std::string MakeSummary(const CRunReport& report) {
  const COverall overall = MakeOverall(report);
  if (!overall.m_nTake) return "\nNothing was judged.\n";
  std::string text = "\n";
  for (std::size_t e = 0; e < overall.m_stdEngines.size(); ++e) {
    const CEngineOverall& engine = overall.m_stdEngines[e];
    text += SummaryRow(
        e == 0 ? "all scenes" : "", report.m_stdEngines[e].m_sName,
        fmt::format("{}{}", LossText(engine.m_nLost, overall.m_nImpacts), Sign(overall.GetGrade(e))),
        Degrees(engine.m_nCompared > 0, engine.m_cDirection.m_fValue), TimeText(engine.m_cNs.m_fMedian),
        Times(engine.m_cTimes));
  }
  text += '\n' + Wrap("Result: " + MakeResult(report, overall), 0, 2);
  text += Wrap(
      fmt::format("lost: went on where the exact ball turned back. degrees: error of 95% of the bounces. "
                  "ns: one step of one ball{}. ~ rough, ! poor.",
                  overall.m_stdEngines[0].m_cTimes ? "; x box2d: times as fast" : ""),
      0, 0);
  if (report.m_bInterrupted)
    text += fmt::format("Interrupted: only the scenes that were finished ({}) are here.\n",
                        report.m_stdScenes.size());
  return text;
}

} // namespace Shapes::Compare
