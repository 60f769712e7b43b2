// SPDX-License-Identifier: MIT
#include "Machine.h"
#include "Numbers.h"
#include "Report.h"
#include "Terminal.h"

#include <fmt/format.h>

#include <string>

namespace Shapes::Compare {
namespace {

std::string P95Text(const CSummary& s) { return s.m_nCount == 0 ? "-" : SizeText(s.m_fP95); }

constexpr const char* g_sColumns = "{:<18}{:>8}{:>17}{:>8}{:>8}{:>7}{:>8}{:>6}\n";

std::string Header() {
  return fmt::format("{:<18}{:>8}{:>17}{:>8}{:>8}{:>7}\n", "", "", "", "", "setback", "dir.") +
         fmt::format(g_sColumns, "", "missed", "tunneled", "late", "p95", "p95", "ghosts", "ns");
}

std::string Rows(const CRunReport& report, const CSceneReport& scene) {
  const std::size_t impacts = scene.m_stdEngines.empty() ? 0 : scene.m_stdEngines[0].m_cTotals.m_nContacts;
  std::string text =
      Wrap(fmt::format("{}, {} impacts", Ascii(scene.m_cScene.m_sName), CountText(impacts)), 0, 2);
  for (std::size_t e = 0; e < scene.m_stdEngines.size(); ++e) {
    const CEngineReport& engine = scene.m_stdEngines[e];
    const CTotals& t = engine.m_cTotals;
    const std::size_t n = t.m_nContacts;
    text += fmt::format(g_sColumns, report.m_stdEngines[e].m_sName, RateText(t.m_nMissed, n),
                        RateTextWithError(t.GetTunneled(), n), RateText(t.m_nLate, n),
                        P95Text(t["setback_error"]), P95Text(t["direction_error"]),
                        RateText(engine.m_nGhosts, scene.m_cImpactTrials.m_nQuietSteps),
                        TimeText(engine.m_cCost.m_cNsPerBallStep.m_fMedian));
  }
  return text;
}

// The meanings of the names of the engines.
std::string Engines(const CRunReport& report) {
  std::string text = "Engines:";
  for (const CEngine& engine : report.m_stdEngines) {
    text += fmt::format("{} {}", &engine == &report.m_stdEngines.front() ? "" : ",", engine.m_sName);
    text += fmt::format(" ({})", GetEngineRow(engine.m_sName).m_sMeaning);
  }
  return text + ".";
}

std::string Verdict(const CRunReport& report, const CSceneReport& scene) {
  std::string text = Wrap(Ascii(scene.m_cScene.m_sName), 0, 2);
  std::vector<std::string> sentences = MakeVerdict(report, scene), remarks = MakeRemarks(report, scene);
  sentences.insert(sentences.end(), remarks.begin(), remarks.end());
  const CExcluded& aside = scene.m_cImpactTrials.m_cExcluded;
  if (aside.m_nUndecided > 0 && !scene.m_cImpactTrials.m_stdContacts.empty())
    sentences.push_back(fmt::format("The exact reference gave up {} of {} trials, the first at {}.",
                                    aside.m_nUndecided, scene.m_cImpactTrials.m_nTrials, aside.m_sUndecided));
  for (const std::string& sentence : sentences)
    text += Wrap(Ascii(sentence), 2, 4);
  return text;
}

} // namespace

std::string MakeTable(const CRunReport& report) {
  const CMachine machine = DescribeMachine();
  std::string text =
      Wrap(fmt::format("Shapes {}, Box2D {}, {}; {}, {} cores; seed {}", machine.m_sShapes, machine.m_sBox2D,
                       machine.m_sCompiler, Ascii(machine.m_sCpu), machine.m_nCores, report.m_nSeed),
           0, 2) +
      "\n" + Header();
  for (const CSceneReport& scene : report.m_stdScenes)
    text += Rows(report, scene);
  text += '\n';
  text +=
      Wrap("At each impact of an exact reference the engines take that one step anew, from the exact state. "
           "missed: no response. tunneled: missed, or pushed to the far side. late: turned back one or two "
           "steps later. setback: by how many ball radii CollisionDetected is off the exact place of the "
           "impact; the same in every mode and profile of an engine. dir.: error of the direction after it, "
           "radians. ghosts: responses to what was not touched, of the steps in which a ball passes close "
           "by. ns: time for "
           "one step of one ball. p95: 95th percentile. +-: half the 95% interval; < 3/n where none was "
           "seen in n. " +
               Engines(report),
           0, 0);
  for (const CSceneReport& scene : report.m_stdScenes)
    text += '\n' + Verdict(report, scene);
  text += MakeEffectTable(report);
  if (report.m_bInterrupted)
    text += report.m_stdScenes.empty()
                ? "\nInterrupted before any scene was finished.\n"
                : fmt::format("\nInterrupted: only the scenes that were finished ({}) are here.\n",
                              report.m_stdScenes.size());
  return text;
}

} // namespace Shapes::Compare
