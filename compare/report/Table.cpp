// SPDX-License-Identifier: MIT
#include "Machine.h"
#include "Report.h"

#include <fmt/format.h>

namespace Shapes::Compare {
namespace {

// A length in radii: three digits that matter, without a row of zeros where it is tiny.
std::string Radii(double x) {
  if (x == 0.0) return "0";
  if (x < 0.0005) return "<.001";
  return x < 9.9995 ? fmt::format("{:.3f}", x) : fmt::format("{:.1f}", x);
}

std::string Summary(const CSummary& s) {
  if (s.m_nCount == 0) return fmt::format("{:>7} {:>7} {:>7}", "-", "-", "-");
  return fmt::format("{:>7} {:>7} {:>7}", Radii(s.m_fMedian), Radii(s.m_fP95), Radii(s.m_fMax));
}

// A rate in percent with half the width of its interval; zero seen in n is less than 3 in n, with 95%
// confidence.
std::string Rate(std::size_t hits, std::size_t n) {
  if (n == 0) return "-";
  if (hits == 0) return fmt::format("<{:.2g}%", 300.0 / static_cast<double>(n));
  const CInterval i = Wilson(hits, n);
  const double percent = 100.0 * static_cast<double>(hits) / static_cast<double>(n);
  const double half = 50.0 * (i.m_fHigh - i.m_fLow);
  return percent < 1.0 ? fmt::format("{:.3f}% +-{:.3f}", percent, half)
                       : fmt::format("{:.1f}% +-{:.1f}", percent, half);
}

} // namespace

std::string MakeTable(const CRunReport& report) {
  const CMachine machine = DescribeMachine();
  std::string text =
      fmt::format("Shapes {}, Box2D {}, {}\n{}, {} cores; seed {}\n\n"
                  "Every scene is played by an exact reference. At each impact both engines are started from "
                  "the exact state at\n"
                  "the beginning of that step. Missed: no response. Tunneled: missed, or pushed to the far "
                  "side. Setback: how far\n"
                  "the engine sets the ball back along the normal. Error: where it puts the ball at the "
                  "impact, against the exact\n"
                  "place. Lengths are in ball radii. ns: time for one step of one ball, median.\n\n",
                  machine.m_sShapes, machine.m_sBox2D, machine.m_sCompiler, machine.m_sCpu, machine.m_nCores,
                  report.m_nSeed);
  text += fmt::format("{:<33}{:<24}{:>13}{:>24}{:>8}\n", "", "", "setback", "error", "");
  text += fmt::format("{:<17}{:<8}{:>7} {:>14} {:>14} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>6}\n", "scene",
                      "engine", "impacts", "missed", "tunneled", "median", "p95", "max", "median", "p95",
                      "max", "ns");
  for (const CSceneReport& scene : report.m_stdScenes) {
    const std::size_t n = scene.m_cRestart.m_stdContacts.size();
    for (std::size_t e = 0; e < report.m_stdEngines.size(); ++e) {
      const CEngineTotals& t = scene.m_cRestart.m_stdEngines[e];
      text += fmt::format("{:<17}{:<8}{:>7} {:>14} {:>14} {} {} {:>6.0f}\n",
                          e == 0 ? scene.m_cScene.m_sName : "", report.m_stdEngines[e].m_sName, n,
                          Rate(t.m_nMissed, n), Rate(t.GetTunneled(), n), Summary(t.m_cSetback),
                          Summary(t.m_cSetbackError), scene.m_stdCosts[e].m_cNsPerBallStep.m_fMedian);
    }
    const double native = scene.m_stdCosts[0].m_cNsPerBallStep.m_fMedian;
    const double box2d = scene.m_stdCosts[1].m_cNsPerBallStep.m_fMedian;
    text += fmt::format("{:<17}{:<8}{:>62} {} {:>5.1f}x\n", "", "apart", "",
                        Summary(scene.m_cRestart.m_cDifference), box2d / native);
  }
  text += "\n+-: half the width of the 95% interval. Apart: distance between the places where the two "
          "engines put the ball\n"
          "at the same impact, and how many times the time of native Box2D takes.\n";
  for (const CSceneReport& scene : report.m_stdScenes)
    for (std::size_t e = 0; e < report.m_stdEngines.size(); ++e) {
      const CCost& c = scene.m_stdCosts[e];
      if (c.m_nNotFinite > 0)
        text += fmt::format("{} on {}: {} balls became NaN or infinite\n", scene.m_cScene.m_sName,
                            report.m_stdEngines[e].m_sName, c.m_nNotFinite);
    }
  return text;
}

} // namespace Shapes::Compare
