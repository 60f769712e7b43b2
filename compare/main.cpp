// SPDX-License-Identifier: MIT
// shapes-compare: runs the same scenes on every engine against an exact reference.
#include "FailAbove.h"
#include "Interrupt.h"
#include "Options.h"
#include "Run.h"
#include "metrics/Instructions.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

namespace Shapes::Compare {
namespace {

constexpr int g_nAbove = 1, g_nBadInput = 2, g_nInterruptedExit = 130;

struct COptions {
  std::vector<std::string> m_stdScenes;  // names; empty for all
  std::vector<std::string> m_stdEngines; // the same
  std::vector<std::string> m_stdLimits;  // METRIC=VALUE
  std::filesystem::path m_cFile;         // of `scene`
  std::filesystem::path m_cFolder = SHAPES_SCENES_DIR;
  std::filesystem::path m_cOut = "build/report";
  std::uint64_t m_nSeed = 1;
  std::size_t m_nContacts = g_cFullSizes.m_nContacts;
  bool m_bQuick = false;
  std::size_t m_nSteps = 0;             // of `step-cost`
  std::vector<std::string> m_stdWorlds; // the same

  CRunSizes GetSizes() const {
    const CRunSizes& sizes = m_bQuick ? g_cQuickSizes : g_cFullSizes;
    return sizes.ForContacts(m_bQuick ? std::min(m_nContacts, sizes.m_nContacts) : m_nContacts);
  }
};

int Run(const std::vector<CScene>& scenes, const COptions& options, const std::string& command) {
  const std::vector<CEngine> engines = SelectEngines(GetEngines(), options.m_stdEngines);
  std::vector<CLimit> limits;
  for (const std::string& text : options.m_stdLimits)
    limits.push_back(ParseLimit(text));
  RequireWritable(options.m_cOut);
  for (const CLimit& limit : limits)
    if (const std::string warning = WarnOfFew(limit, options.GetSizes().m_nContacts); !warning.empty())
      fmt::print(stderr, "shapes-compare: {}\n", warning);

  CatchInterrupt();
  CProgress progress(scenes.size(), isatty(STDERR_FILENO) != 0);
  CRunReport report =
      RunScenes(scenes, engines, options.GetSizes(), options.m_nSeed, progress, &CheckInterrupt);
  report.m_sCommand = command;
  if (report.m_stdScenes.empty()) { // an earlier report stays as it is
    fmt::print(stderr, "shapes-compare: interrupted before a scene was finished; nothing is written\n");
    return g_nInterruptedExit;
  }
  fmt::print("{}\n", MakeTable(report));
  WriteReport(report, options.m_cOut);
  fmt::print("Written to {}: report.html (open it in a browser), run.json, contacts.csv\n",
             options.m_cOut.string());

  const std::vector<std::string> above = FindAbove(report, limits);
  std::fflush(stdout);
  for (const std::string& sentence : above)
    fmt::print(stderr, "shapes-compare: {}\n", sentence);
  if (report.m_bInterrupted) return g_nInterruptedExit;
  return above.empty() ? 0 : g_nAbove;
}

void AddRunOptions(CLI::App& app, COptions& options) {
  app.add_option("--engines", options.m_stdEngines,
                 "Only these engines, separated by commas: native, native-continuous, box2d, box2d-tuned "
                 "(default: all)")
      ->delimiter(',');
  app.add_option("--out", options.m_cOut, "Folder for report.html, run.json and contacts.csv")
      ->capture_default_str();
  app.add_option("--seed", options.m_nSeed, "Seed of the random trials")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  app.add_option("--contacts", options.m_nContacts, "Impacts in each scene")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000000));
  app.add_flag("--quick", options.m_bQuick,
               fmt::format("At most {} impacts in each scene, and less of everything else",
                           g_cQuickSizes.m_nContacts));
  app.add_option("--fail-above", options.m_stdLimits,
                 fmt::format("METRIC=VALUE: exit code 1 if it is above on any scene and engine; may be given "
                             "several times. METRIC is one of {}",
                             fmt::join(GetMetricNames(), ", ")))
      ->type_name("METRIC=VALUE")
      ->allow_extra_args(false);
}

void List(const std::filesystem::path& folder) {
  const std::vector<CScene> scenes = LoadScenes(folder);
  std::size_t width = 0;
  for (const CScene& scene : scenes)
    width = std::max(width, scene.m_sName.size());
  for (const CScene& scene : scenes)
    fmt::print("{:<{}}  {}\n", scene.m_sName, width, scene.m_sDescription);
}

int Main(int argc, char** argv) {
  COptions options;
  CLI::App app(
      "Runs the same scenes on every engine of Shapes, against an exact reference, and says what differs: "
      "setback, tunneling, error, and time.",
      "shapes-compare");
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done, 1 above a limit of --fail-above, 2 bad input, 130 interrupted (what was "
             "finished is reported).");
  CLI::App* pRun = app.add_subcommand("run", "Run the bundled scenes");
  pRun->add_option("--scenes", options.m_stdScenes, "Only these scenes, by name, separated by commas")
      ->delimiter(',');
  pRun->add_option("--folder", options.m_cFolder, "Folder of scene files")->capture_default_str();
  AddRunOptions(*pRun, options);
  CLI::App* pScene = app.add_subcommand("scene", "Run a scene file of your own");
  pScene->add_option("file", options.m_cFile, "Scene file (docs/scenes.md)")->required();
  AddRunOptions(*pScene, options);
  CLI::App* pList = app.add_subcommand("list", "Say which scenes are bundled");
  pList->add_option("--folder", options.m_cFolder, "Folder of scene files")->capture_default_str();
  // What the program is called with by itself to have its instructions counted; not for users.
  CLI::App* pStepCost = app.add_subcommand("step-cost")->group("");
  pStepCost->add_option("file", options.m_cFile)->required();
  pStepCost->add_option("seed", options.m_nSeed)->required();
  pStepCost->add_option("steps", options.m_nSteps)->required();
  pStepCost->add_option("worlds", options.m_stdWorlds)->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int exit = app.exit(e);
    if (exit != 0 && !app.remaining().empty())
      fmt::print(stderr, "What is '{}'? Expected run, scene or list.\n", app.remaining().front());
    return exit == 0 ? 0 : g_nBadInput;
  }

  std::vector<std::string> words(argv, argv + argc);
  words.front() = "shapes-compare";
  try {
    if (pList->parsed()) {
      List(options.m_cFolder);
      return 0;
    }
    if (pStepCost->parsed()) {
      PlayStepCost(LoadScene(options.m_cFile), options.m_stdWorlds, options.m_nSeed, options.m_nSteps);
      return 0;
    }
    return Run(pScene->parsed() ? std::vector<CScene>{LoadScene(options.m_cFile)}
                                : SelectScenes(LoadScenes(options.m_cFolder), options.m_stdScenes),
               options, JoinCommand(words));
  } catch (const std::exception& e) {
    fmt::print(stderr, "shapes-compare: {}\n", e.what());
    return g_nBadInput;
  }
}

} // namespace
} // namespace Shapes::Compare

int main(int argc, char** argv) { return Shapes::Compare::Main(argc, argv); }
