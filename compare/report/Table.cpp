// SPDX-License-Identifier: MIT
#include "Machine.h"
#include "Numbers.h"
#include "Report.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace Shapes::Compare {
namespace {

constexpr std::size_t g_nWidth = 116;

// Breaks a text between words, or within one that is longer than a line. The first line is indented by
// `first`, those after it by `rest`.
std::string Wrap(std::string_view text, std::size_t first, std::size_t rest) {
  std::string wrapped(first, ' ');
  std::size_t column = first;
  bool atStart = true;
  while (!text.empty()) {
    const std::size_t end = std::min({text.find(' '), text.size(), g_nWidth - rest});
    if (!atStart && column + 1 + end > g_nWidth) {
      wrapped += '\n' + std::string(rest, ' ');
      column = rest;
    } else if (!atStart) {
      wrapped += ' ';
      ++column;
    }
    atStart = false;
    wrapped += text.substr(0, end);
    column += end;
    text.remove_prefix(end);
    if (text.starts_with(' ')) text.remove_prefix(1);
  }
  return wrapped + '\n';
}

// Names that a user gives may hold anything; a terminal gets what can be printed.
std::string Ascii(std::string text) {
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

std::string Figure(const CSummary& s, double CSummary::*pFigure) {
  return s.m_nCount == 0 ? "-" : SizeText(s.*pFigure);
}

std::string Header() {
  return fmt::format("{:<17} {:<7}{:>8}{:>17}{:>17}{:>17}{:>11}\n", "", "", "", "", "", "setback error",
                     "direction") +
         fmt::format("{:<17} {:<7}{:>8}{:>17}{:>17}{:>9}{:>8}{:>11}{:>11}{:>9}\n", "scene", "engine",
                     "impacts", "missed", "tunneled", "median", "p95", "p95, rad", "ghosts", "ns");
}

// A name that is too long has a line of its own.
std::string Rows(const CRunReport& report, const CSceneReport& scene) {
  const std::string name = Ascii(scene.m_cScene.m_sName);
  const bool isLong = name.size() > 17;
  std::string text = isLong ? Wrap(name, 0, 2) : "";
  for (std::size_t e = 0; e < scene.m_stdEngines.size(); ++e) {
    const CEngineReport& engine = scene.m_stdEngines[e];
    const CTotals& t = engine.m_cTotals;
    const std::size_t n = t.m_nContacts;
    text += fmt::format(
        "{:<17} {:<7}{:>8}{:>17}{:>17}{:>9}{:>8}{:>11}{:>11}{:>9.0f}\n", e == 0 && !isLong ? name : "",
        report.m_stdEngines[e].m_sName, n, RateTextWithError(t.m_nMissed, n),
        RateTextWithError(t.GetTunneled(), n), Figure(t.m_cSetbackError, &CSummary::m_fMedian),
        Figure(t.m_cSetbackError, &CSummary::m_fP95), Figure(t.m_cDirectionError, &CSummary::m_fP95),
        RateText(engine.m_nGhosts, scene.m_cRestart.m_nQuietSteps),
        engine.m_cCost.m_cNsPerBallStep.m_fMedian);
  }
  return text;
}

std::string Verdict(const CRunReport& report, const CSceneReport& scene) {
  std::string text = Wrap(Ascii(scene.m_cScene.m_sName), 0, 2);
  std::vector<std::string> sentences = MakeVerdict(report, scene);
  const CSetAside& aside = scene.m_cRestart.m_cSetAside;
  if (aside.m_nUndecided > 0 && !scene.m_cRestart.m_stdContacts.empty())
    sentences.push_back(fmt::format("The exact reference gave up {} of {} trials, the first at {}.",
                                    aside.m_nUndecided, scene.m_cRestart.m_nTrials, aside.m_sUndecided));
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
           "missed: no response. tunneled: missed, or pushed to the far side. setback error: distance "
           "from the exact place of the impact, in ball radii. direction: error of the velocity after it. "
           "ghosts: responses to what was not touched, of the steps in which a ball passes close by. ns: "
           "time for one step of one ball. +-: half the 95% interval; < 3/n where none was seen in n.",
           0, 0);
  for (const CSceneReport& scene : report.m_stdScenes)
    text += '\n' + Verdict(report, scene);
  if (report.m_bInterrupted)
    text += report.m_stdScenes.empty()
                ? "\nInterrupted before any scene was finished.\n"
                : fmt::format("\nInterrupted: only the scenes that were finished ({}) are here.\n",
                              report.m_stdScenes.size());
  return text;
}

} // namespace Shapes::Compare
