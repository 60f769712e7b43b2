// SPDX-License-Identifier: MIT
// shapes-compare: runs the same scenes on every engine against an exact reference.
#include "Child.h"
#include "FailAbove.h"
#include "FirstImpact.h"
#include "NearMatches.h"
#include "Options.h"
#include "Run.h"
#include "metrics/Instructions.h"
#include "report/Machine.h"
#include "report/Numbers.h"
#include "scene/Interrupt.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

namespace Shapes::Compare {
namespace {

constexpr int g_nAbove = 1, g_nBadInput = 2, g_nInterruptedExit = 130;

// The scenes of the source tree that this was built from, or those that were installed with the program.
std::filesystem::path FindScenes() {
  std::error_code error;
  if (std::filesystem::is_directory(SHAPES_SCENES_DIR, error)) return SHAPES_SCENES_DIR;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share/shapes/scenes";
}

struct COptions {
  std::vector<std::string> m_stdScenes;  // names; empty for all
  std::vector<std::string> m_stdEngines; // the same
  std::vector<std::string> m_stdLimits;  // METRIC=VALUE
  std::filesystem::path m_cFile;         // of `scene`
  std::filesystem::path m_cFolder = FindScenes();
  std::filesystem::path m_cOut = "build/report";
  std::uint64_t m_nSeed = 1;
  std::size_t m_nContacts = 0;  // as many as the sizes say
  std::filesystem::path m_cSvg; // empty for none
  bool m_bFull = false, m_bVerbose = false, m_bBrowse = false;
  bool m_bListEngines = false, m_bListFigures = false; // of `list`
  std::size_t m_nSteps = 0;                            // of `step-cost`
  std::vector<std::string> m_stdWorlds;                // the same

  CRunSizes GetSizes() const {
    const CRunSizes& sizes = m_bFull ? g_cFullSizes : g_cQuickSizes;
    return m_nContacts == 0 ? sizes : sizes.ForContacts(m_nContacts);
  }
};

// Before a run that takes minutes.
void AnnounceDuration(const COptions& options, std::size_t scenes) {
  const CRunSizes sizes = options.GetSizes();
  const CRunSizes& usual = options.m_bFull ? g_cFullSizes : g_cQuickSizes;
  // More impacts take more trials, a fifth of the time, and nothing else.
  const double ratio = static_cast<double>(sizes.m_nContacts) / static_cast<double>(usual.m_nContacts);
  const double share = ratio <= 1.0 ? ratio : 0.8 + 0.2 * ratio;
  const double minutes = share * static_cast<double>(scenes) *
                         (options.m_bFull ? g_fFullSceneSeconds : g_fQuickSceneSeconds) / 60.0;
  if (minutes < 1.0) return;
  fmt::print(stderr,
             "{} impacts in each of {} scenes: this takes about {:.0f} minutes. Ctrl-C ends it with what is "
             "finished.\n",
             CountText(sizes.m_nContacts), scenes, std::ceil(minutes));
}

// Opens a page as the desktop does; false where there is no program for it.
bool Browse(const std::filesystem::path& page) {
  for (const char* pName : {"xdg-open", "open"})
    if (const auto program = FindProgram(pName)) {
      StartProgram({program->string(), std::filesystem::absolute(page).string()});
      return true;
    }
  return false;
}

int Run(const std::vector<CScene>& scenes, const COptions& options, const std::string& command) {
  const std::vector<CEngine> engines = SelectEngines(GetEngines(), options.m_stdEngines);
  std::vector<CLimit> limits;
  for (const std::string& text : options.m_stdLimits)
    limits.push_back(ParseLimit(text));
  RequireWritable(options.m_cOut);
  if (!options.m_cSvg.empty()) RequireChart(options.m_cSvg, options.m_cOut, scenes);
  for (const CLimit& limit : limits)
    if (const std::string warning = WarnOfFew(limit, options.GetSizes().m_nContacts); !warning.empty())
      fmt::print(stderr, "shapes-compare: {}\n", warning);

  for (const CScene& scene : scenes) {
    RequireHeld(scene, engines);
    RequireImpact(scene, options.m_nSeed);
    if (const std::string warning = WarnOfSpeed(scene, engines); !warning.empty())
      fmt::print(stderr, "shapes-compare: {}\n", warning);
  }
  AnnounceDuration(options, scenes.size());

  CRunReport heading;
  heading.m_nSeed = options.m_nSeed;
  heading.m_stdEngines = engines;
  fmt::print("{}", MakeHeading(heading));
  std::fflush(stdout);
  CatchInterrupt();
  CProgress progress(scenes.size(), isatty(STDERR_FILENO) != 0);
  CRunReport report = RunScenes(scenes, engines, options.GetSizes(), options.m_nSeed, progress,
                                &CheckInterrupt, [&](const CSceneReport& scene) {
                                  fmt::print("{}", MakeSceneLine(heading, scene));
                                  std::fflush(stdout);
                                });
  report.m_sCommand = command;
  if (report.m_stdScenes.empty()) { // an earlier report stays as it is
    fmt::print(stderr, "shapes-compare: interrupted before a scene was finished; nothing is written\n");
    return g_nInterruptedExit;
  }
  fmt::print("{}", MakeSummary(report));
  if (options.m_bVerbose) fmt::print("{}\n", MakeTable(report));
  WriteReport(report, options.m_cOut);
  if (!options.m_cSvg.empty()) WriteChart(report, options.m_cSvg);
  const std::filesystem::path page = options.m_cOut / "report.html";
  fmt::print("Report: {}{}\n", page.string(),
             options.m_bVerbose ? "" : " (--browse opens it, --verbose prints it)");
  if (options.m_bBrowse && !Browse(page))
    fmt::print(stderr, "shapes-compare: neither xdg-open nor open was found: open {} yourself\n",
               page.string());

  const std::vector<std::string> above = FindAbove(report, limits);
  std::fflush(stdout);
  for (const std::string& warning : WarnOfFewFound(report, limits))
    fmt::print(stderr, "shapes-compare: {}\n", warning);
  for (const std::string& sentence : above)
    fmt::print(stderr, "shapes-compare: {}\n", sentence);
  if (report.m_bInterrupted) return g_nInterruptedExit;
  return above.empty() ? 0 : g_nAbove;
}

std::vector<std::string> GetEngineNames() {
  std::vector<std::string> names;
  for (const CEngineRow& row : GetEngineRows())
    names.push_back(row.m_sName);
  return names;
}

// "" or what is wrong with it.
std::string CheckSeed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [pEnd, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error == std::errc() && pEnd == text.data() + text.size()) return "";
  return fmt::format("expected a whole number from 0 to {}, got '{}'",
                     std::numeric_limits<std::uint64_t>::max(), text);
}

void AddRunOptions(CLI::App& app, COptions& options) {
  app.add_option("--engines", options.m_stdEngines,
                 fmt::format("Only these engines, separated by commas: {} (default: all)",
                             fmt::join(GetEngineNames(), ", ")))
      ->delimiter(',')
      ->allow_extra_args(false) // or the scene file that follows would be one
      ->type_name("NAME,...");
  app.add_option("--out", options.m_cOut, "Folder for report.html, run.json and contacts.csv")
      ->type_name("FOLDER")
      ->capture_default_str();
  app.add_option("--svg", options.m_cSvg, "Also write the chart of all scenes into FILE, as SVG")
      ->type_name("FILE");
  app.add_flag("--browse", options.m_bBrowse, "Open the report in the default browser");
  app.add_option("--seed", options.m_nSeed, "Seed of the random trials")
      ->capture_default_str()
      ->check(CLI::Validator(&CheckSeed, "", ""))
      ->type_name("N");
  app.add_option("--contacts", options.m_nContacts,
                 fmt::format("Impacts in each scene (default: {}, or {} with --full)",
                             g_cQuickSizes.m_nContacts, g_cFullSizes.m_nContacts))
      ->check(CLI::Range(1, 100000000))
      ->type_name("N");
  app.add_flag("--full", options.m_bFull,
               "The long run: more of everything, for figures that go into documents");
  app.add_flag("--verbose", options.m_bVerbose, "Print every table and the verdict of each scene");
  app.add_option("--fail-above", options.m_stdLimits,
                 "METRIC=VALUE: exit code 1 if it is above on any scene and engine; may be given "
                 "several times. METRIC is one of `shapes-compare list --figures`")
      ->type_name("METRIC=VALUE")
      ->allow_extra_args(false);
}

void ListScenes(const std::filesystem::path& folder) {
  const std::vector<CScene> scenes = LoadScenes(folder);
  std::size_t width = 0;
  for (const CScene& scene : scenes)
    width = std::max(width, scene.m_sName.size());
  for (const CScene& scene : scenes)
    fmt::print("{:<{}}  {}\n", scene.m_sName, width, scene.m_sDescription);
}

void ListEngines() {
  for (const CEngineRow& row : GetEngineRows())
    fmt::print("{:<19} {}\n", row.m_sName, row.m_sMeaning);
}

void ListFigures() {
  for (const CFigure& figure : GetFigures())
    fmt::print("{:<24} {:<9} {}\n", figure.m_sKey, figure.m_sUnit, figure.m_sLabel);
}

// Suggests a word for the first one of the command line that was not expected: an option, or the command
// itself.
std::string Suggest(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining(true);
  if (words.empty()) return {};
  const auto parsed = app.get_subcommands();
  if (!words.front().starts_with('-'))
    return parsed.empty()
               ? UnknownName("command", words.front(), std::vector<std::string>{"run", "scene", "list"})
               : "";
  std::vector<std::string> known;
  for (const CLI::Option* pOption : (parsed.empty() ? app : *parsed.front()).get_options())
    for (const std::string& name : pOption->get_lnames())
      known.push_back("--" + name);
  return UnknownName("option", words.front(), known);
}

std::string Version() {
  const CMachine machine = DescribeMachine();
  return fmt::format("shapes-compare {}\nBox2D {}, {}", machine.m_sShapes, machine.m_sBox2D,
                     machine.m_sCompiler);
}

int Main(int argc, char** argv) {
  COptions options;
  CLI::App app(
      "Runs the same scenes on every engine of Shapes, against an exact reference, and says what differs: "
      "setback, tunneling, error, and time.",
      "shapes-compare");
  app.require_subcommand(1);
  app.set_version_flag("--version", &Version, "Print the versions of the tool, Box2D and the compiler");
  app.set_help_all_flag("--help-all", "Print the options of all commands");
  app.footer("Exit codes: 0 done, 1 above a limit of --fail-above, 2 bad input or output that cannot be "
             "written, 130 interrupted (what was finished is reported).");
  CLI::App* pRun = app.add_subcommand("run", "Run the bundled scenes");
  pRun->add_option("--scenes", options.m_stdScenes, "Only these scenes, by name, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME,...");
  pRun->add_option("--folder", options.m_cFolder, "Folder of scene files (default: the bundled ones)")
      ->type_name("FOLDER");
  AddRunOptions(*pRun, options);
  CLI::App* pScene = app.add_subcommand("scene", "Run a scene file of your own");
  pScene->add_option("file", options.m_cFile, "Scene file (docs/scenes.md)")->required();
  AddRunOptions(*pScene, options);
  CLI::App* pList = app.add_subcommand("list", "Say which scenes are bundled");
  pList->add_option("--folder", options.m_cFolder, "Folder of scene files (default: the bundled ones)")
      ->type_name("FOLDER");
  pList->add_flag("--engines", options.m_bListEngines, "Say which engines there are instead");
  pList->add_flag("--figures", options.m_bListFigures, "Say which figures are measured instead");
  // The program calls itself so to count its instructions; not for users.
  CLI::App* pStepCost = app.add_subcommand("step-cost")->group("");
  pStepCost->add_option("file", options.m_cFile)->required();
  pStepCost->add_option("seed", options.m_nSeed)->required();
  pStepCost->add_option("steps", options.m_nSteps)->required();
  pStepCost->add_option("worlds", options.m_stdWorlds)->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const std::string suggestion = e.get_exit_code() == 0 ? "" : Suggest(app);
    if (suggestion.empty()) return app.exit(e) == 0 ? 0 : g_nBadInput;
    fmt::print(stderr, "shapes-compare: {}\n", suggestion);
    return g_nBadInput;
  }

  std::vector<std::string> words(argv, argv + argc);
  words.front() = "shapes-compare";
  try {
    if (pList->parsed()) {
      if (options.m_bListFigures)
        ListFigures();
      else
        options.m_bListEngines ? ListEngines() : ListScenes(options.m_cFolder);
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

// The text that was printed may still be on its way to a disk that is full.
int CheckOutput(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  fmt::print(stderr, "shapes-compare: the standard output cannot be written\n");
  return g_nBadInput;
}

} // namespace
} // namespace Shapes::Compare

int main(int argc, char** argv) {
  using namespace Shapes::Compare;
  return CheckOutput(Main(argc, argv));
}
