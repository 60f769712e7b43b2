// SPDX-License-Identifier: MIT
// shapes-compare: runs the same scenes on both engines against an exact reference.
#include "report/Report.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

namespace Shapes::Compare {
namespace {

constexpr int g_nBadInput = 2;

struct COptions {
  std::vector<std::string> m_stdScenes; // names; empty for all
  std::filesystem::path m_cFile;        // of `scene`
  std::filesystem::path m_cFolder = SHAPES_SCENES_DIR;
  std::filesystem::path m_cOut = "build/report";
  std::uint64_t m_nSeed = 1;
  std::size_t m_nContacts = 20000;
  bool m_bQuick = false;
};

// Bounds on the work of one scene, so that one in which little happens ends too.
constexpr std::uint64_t g_nTrialsPerContact = 20;
constexpr std::size_t g_nQuickContacts = 5000;

std::vector<CScene> SelectScenes(const COptions& options) {
  std::vector<CScene> all = LoadScenes(options.m_cFolder);
  if (options.m_stdScenes.empty()) return all;
  std::vector<CScene> selected;
  for (const std::string& name : options.m_stdScenes) {
    const auto it = std::find_if(all.begin(), all.end(), [&](const CScene& s) { return s.m_sName == name; });
    if (it == all.end()) {
      std::string known;
      for (const CScene& scene : all)
        known += " " + scene.m_sName;
      throw CSceneError(fmt::format("--scenes: there is no scene '{}': expected one of{}", name, known));
    }
    selected.push_back(*it);
  }
  return selected;
}

void Progress(const std::string& text) {
  if (isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K{}", text);
}

void Run(const std::vector<CScene>& scenes, const COptions& options, const std::string& command) {
  RequireWritable(options.m_cOut);
  CRunReport report;
  report.m_sCommand = command;
  report.m_nSeed = options.m_nSeed;
  report.m_nContacts =
      options.m_bQuick ? std::min(options.m_nContacts, g_nQuickContacts) : options.m_nContacts;
  report.m_stdEngines = GetEngines();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    Progress(fmt::format("{}/{} {}", i + 1, scenes.size(), scenes[i].m_sName));
    CRestartResult restarts = RunRestarts(scenes[i], report.m_stdEngines, options.m_nSeed, report.m_nContacts,
                                          g_nTrialsPerContact * report.m_nContacts);
    std::vector<CCost> costs =
        MeasureCost(scenes[i], report.m_stdEngines, options.m_nSeed, 11, options.m_bQuick ? 5000 : 50000);
    report.m_stdScenes.push_back({scenes[i], std::move(restarts), std::move(costs)});
  }
  Progress("");
  fmt::print("{}\n", MakeTable(report));
  WriteReport(report, options.m_cOut);
  fmt::print("Written to {}: run.json, contacts.csv\n", options.m_cOut.string());
}

void AddRunOptions(CLI::App& app, COptions& options) {
  app.add_option("--out", options.m_cOut, "Folder for run.json and contacts.csv")->capture_default_str();
  app.add_option("--seed", options.m_nSeed, "Seed of the random trials")->capture_default_str();
  app.add_option("--contacts", options.m_nContacts, "Impacts in each scene")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000000));
  app.add_flag("--quick", options.m_bQuick, "At most 5000 impacts in each scene, and shorter timing");
}

int Main(int argc, char** argv) {
  COptions options;
  CLI::App app(
      "Runs the same scenes on both engines of Shapes, against an exact reference, and says what differs: "
      "setback, tunneling, error, and time.",
      "shapes-compare");
  app.require_subcommand(1);
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

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int exit = app.exit(e);
    if (exit != 0 && !app.remaining().empty())
      fmt::print(stderr, "What is '{}'? Expected run, scene or list.\n", app.remaining().front());
    return exit == 0 ? 0 : g_nBadInput;
  }

  std::string command = "shapes-compare";
  for (int i = 1; i < argc; ++i)
    command += fmt::format(" {}", argv[i]);
  try {
    if (pList->parsed())
      for (const CScene& scene : LoadScenes(options.m_cFolder))
        fmt::print("{:<18}{}\n", scene.m_sName, scene.m_sDescription);
    else
      Run(pScene->parsed() ? std::vector<CScene>{LoadScene(options.m_cFile)} : SelectScenes(options), options,
          command);
  } catch (const std::exception& e) {
    Progress("");
    fmt::print(stderr, "shapes-compare: {}\n", e.what());
    return g_nBadInput;
  }
  return 0;
}

} // namespace
} // namespace Shapes::Compare

int main(int argc, char** argv) { return Shapes::Compare::Main(argc, argv); }
