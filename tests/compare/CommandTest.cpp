// SPDX-License-Identifier: MIT
// shapes-compare as a user calls it.
#include "CommandCalls.h"
#include "SampleReport.h"
#include "scene/Engines.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <pty.h>

#include <csignal>
#include <cstdlib>

namespace {

namespace fs = std::filesystem;
using Shapes::Says;
using Shapes::Compare::Tests::CCommandTest;
using Shapes::Compare::Tests::CResult;

struct CInterrupted : CResult {
  std::string m_sBefore; // what was written when Ctrl-C was typed
};

class CommandTest : public CCommandTest {
protected:
  nlohmann::json ReadRun() const { return nlohmann::json::parse(Read("run.json")); }

  std::string WriteScene(const std::string& shapes, const std::string& balls, const std::string& more = "",
                         int seconds = 1, const char* pName = "mine.json") const {
    return Write(pName, fmt::format(R"({{"name": "mine", "duration": {}, {}
      "bounds": {{"left": -2e6, "bottom": -2, "right": 2e6, "top": 2}}, "shapes": [{}], "balls": [{}]}})",
                                    seconds, more, shapes, balls));
  }

  /// Runs the program on a terminal of its own, and types Ctrl-C once when it has written `mark`.
  CInterrupted Interrupt(const std::string& arguments, const std::string& mark) const {
    CInterrupted result{{-1, ""}, ""};
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) {
      signal(SIGINT, SIG_DFL);
      execl(
          "/bin/sh", "sh", "-c",
          ("exec " + std::string(SHAPES_COMPARE) + " " + arguments + " --out " + m_cFolder.string()).c_str(),
          nullptr);
      _exit(127);
    }
    if (child < 0) return result;
    char buffer[4096];
    for (ssize_t n; (n = read(terminal, buffer, sizeof buffer)) > 0;) { // ends with an error at the end
      result.m_sOutput.append(buffer, static_cast<std::size_t>(n));
      if (!result.m_sBefore.empty() || !result.Says(mark)) continue;
      result.m_sBefore = result.m_sOutput;
      if (write(terminal, "\x03", 1) < 0) break;
    }
    int status = 0;
    waitpid(child, &status, 0);
    close(terminal);
    if (WIFEXITED(status)) result.m_nExit = WEXITSTATUS(status);
    return result;
  }
};

TEST_F(CommandTest, RunWritesTheTableThreeFilesAndTheChart) {
  const std::string svg = (m_cFolder / "chart.svg").string();
  const CResult result = Run("run --scenes corner,bowl --contacts 50 --svg " + svg);
  ASSERT_EQ(result.m_nExit, 0) << result.m_sOutput;
  EXPECT_TRUE(result.Says("\nbowl  "));
  EXPECT_TRUE(result.Says("\ncorner  "));
  EXPECT_FALSE(result.Says("spinner"));
  EXPECT_TRUE(result.Says("\nResult: "));
  EXPECT_TRUE(result.Says("report.html"));
  EXPECT_FALSE(result.Says("\r")); // no progress where there is no terminal

  const auto json = ReadRun();
  ASSERT_EQ(json.at("scenes").size(), 2u);
  EXPECT_EQ(json.at("scenes")[0].at("name"), "bowl"); // in the order of the folder
  EXPECT_EQ(json.at("interrupted"), false);
  EXPECT_EQ(json.at("command"), "shapes-compare run --scenes corner,bowl --contacts 50 --svg " + svg +
                                    " --out " + m_cFolder.string());
  for (const auto& scene : json.at("scenes")) {
    EXPECT_EQ(scene.at("engines").size(), Shapes::Compare::GetEngineRows().size());
    for (const auto& engine : scene.at("engines"))
      EXPECT_EQ(engine.at("contacts"), 50);
  }

  const std::vector<std::string> lines = Shapes::Compare::Lines(Read("contacts.csv"));
  EXPECT_EQ(lines.size(), 1u + 2u * 50u);
  for (const std::string& line : lines)
    EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(lines[0], ',')) << line;

  EXPECT_TRUE(Says(Read("report.html"), "<html"));
  EXPECT_TRUE(Says(Read("report.html"), "corner"));
  EXPECT_TRUE(Read("chart.svg").starts_with("<svg ")) << Read("chart.svg").substr(0, 80);
  EXPECT_TRUE(Says(Read("chart.svg"), "data-engine=\"native\""));
}

// Leaves out what depends on times (docs/run_json.md says which does), and the command.
void Strip(nlohmann::json& value) {
  for (const char* pKey : {"front_by_error", "front_by_misses", "answers", "verdict", "proof", "take",
                           "result", "front", "remarks", "command"})
    if (value.is_object()) value.erase(pKey);
  for (auto it = value.begin(); value.is_structured() && it != value.end();)
    if (value.is_object() && it.key().starts_with("ns_"))
      it = value.erase(it);
    else
      Strip(*it++);
}

TEST_F(CommandTest, TheSameCommandGivesTheSameBitsApartFromTimes) {
  const auto run = [&](int seed) {
    const CResult result =
        Run(fmt::format("run --scenes pinball,spinner,disc_in_square --contacts 40 --seed {}", seed));
    EXPECT_EQ(result.m_nExit, 0) << result.m_sOutput;
    nlohmann::json doc = ReadRun();
    Strip(doc);
    return std::pair(Read("contacts.csv"), doc.dump(1));
  };
  const auto once = run(5), again = run(5), other = run(6);
  EXPECT_EQ(once.first, again.first);
  EXPECT_EQ(once.second, again.second);
  EXPECT_NE(once.first, other.first); // the control
  EXPECT_NE(once.second, other.second);
}

TEST_F(CommandTest, EnginesAreChosen) {
  const auto engines = [&](const std::string& names) {
    EXPECT_EQ(Run("run --scenes bowl --contacts 20 --engines " + names).m_nExit, 0) << names;
    const auto json = ReadRun();
    std::string text;
    for (const auto& engine : json.at("scenes").at(0).at("engines"))
      text += engine.at("name").get<std::string>() + " ";
    for (const auto& row : json.at("work_precision"))
      EXPECT_NE((text + "exact ").find(row.at("engine").get<std::string>() + " "), text.npos) << row;
    return text;
  };
  EXPECT_EQ(engines("box2d,native-approximate,native"), "native native-approximate box2d ");
  EXPECT_EQ(engines("box2d-tuned,box2d-tuned"), "box2d-tuned ");
  EXPECT_EQ(engines("box2d --engines native"), "native box2d ");
  // The next word is the file.
  EXPECT_EQ(Run("scene --contacts 20 --engines native " SHAPES_SCENES_DIR "/bowl.json").m_nExit, 0);
}

// The line of the README that asks in CI whether a setting is good enough, of a bundled table.
TEST_F(CommandTest, FailAboveIsAGateThatPassesByDefaultAndFailsWithoutSweeps) {
  std::ifstream in(SHAPES_SOURCE_DIR "/README.md");
  const std::string program = "build/release/compare/shapes-compare ";
  std::string line;
  while (std::getline(in, line) && !line.starts_with(program + "scene mine.json"))
    ;
  const auto replace = [&](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from << " in " << text;
    return at == text.npos ? text : text.replace(at, from.size(), to);
  };
  line = replace(replace(line, program, ""), "mine.json", SHAPES_SCENES_DIR "/pinball.json");
  // Both at once: engines do not change each other's figures.
  const CResult both = Run(replace(line, "--engines native", "--engines native,native-approximate") +
                           " --fail-above ns_per_ball_step=1e9");
  EXPECT_EQ(both.m_nExit, 1) << both.m_sOutput;
  EXPECT_TRUE(both.Says(" on pinball with native-approximate: above "));
  EXPECT_FALSE(both.Says(" with native: above "));
  EXPECT_TRUE(fs::exists(m_cFolder / "run.json"));
  // Balls that are not swept are lost at the wall every other time, swept ones never.
  const std::string run = "run --scenes head_on_wall,bowl --contacts 100";
  EXPECT_EQ(Run(run + " --engines native,native-approximate,box2d --fail-above tunneled=.9").m_nExit, 0);
  EXPECT_EQ(Run(run + " --engines box2d --fail-above tunneled=.1").m_nExit, 0);
}

// A stand-in for the desktop's program is called with the page.
TEST_F(CommandTest, TheReportIsOpenedInTheDefaultBrowser) {
  const std::string browser =
      Write("xdg-open", "#!/bin/sh\necho \"$1\" > " + (m_cFolder / "part").string() + "; mv " +
                            (m_cFolder / "part").string() + " " + (m_cFolder / "opened").string() + "\n");
  fs::permissions(browser, fs::perms::owner_all);
  const Shapes::Compare::Tests::CPathVariable path(m_cFolder.string() + ":" + std::getenv("PATH"));
  EXPECT_EQ(Run("run --scenes bowl --contacts 10 --browse").m_nExit, 0);
  for (int i = 0; i < 500 && !fs::exists(m_cFolder / "opened"); ++i)
    usleep(10000); // it runs on its own
  EXPECT_TRUE(Says(Read("opened"), "report.html"));
}

TEST_F(CommandTest, ScenesAreShownAsTheyAreFinishedAndReportedAfterCtrlC) {
  const CInterrupted result = Interrupt("run --contacts 300", "2/23 ");
  EXPECT_TRUE(Says(result.m_sBefore, "ball_on_ball "));
  EXPECT_FALSE(Says(result.m_sBefore, "\nbowl "));
  EXPECT_EQ(result.m_nExit, 130) << result.m_sOutput;
  EXPECT_TRUE(result.Says("Interrupted: only the"));
  EXPECT_TRUE(result.Says("1/23 ball_on_ball  impacts 0%"));
  const auto json = ReadRun();
  EXPECT_EQ(json.at("interrupted"), true);
  EXPECT_GE(json.at("scenes").size(), 1u);
  EXPECT_LT(json.at("scenes").size(), 23u);
  EXPECT_TRUE(fs::exists(m_cFolder / "report.html") && fs::exists(m_cFolder / "contacts.csv"));
}

TEST_F(CommandTest, CtrlCBeforeTheFirstSceneLeavesAnEarlierReportAlone) {
  Write("run.json", "earlier");
  const CInterrupted result = Interrupt("run --scenes pinball", "1/1 ");
  EXPECT_EQ(result.m_nExit, 130) << result.m_sOutput;
  EXPECT_TRUE(result.Says("nothing is written"));
  EXPECT_EQ(Read("run.json"), "earlier");
  EXPECT_FALSE(fs::exists(m_cFolder / "report.html"));
}

TEST_F(CommandTest, EverySceneFitsOnOneScreen) {
  const CResult result = Run("run --contacts 10");
  ASSERT_EQ(result.m_nExit, 0) << result.m_sOutput;
  EXPECT_LE(std::ranges::count(result.m_sOutput, '\n'), 40) << result.m_sOutput;
  // Longer replays and larger counts make that of a full run some .4 MB larger, and it has to stay below 3.
  EXPECT_LT(fs::file_size(m_cFolder / "report.html"), 2'500'000u);
  const CResult verbose = Run("run --contacts 10 --scenes bowl,corner,spinner --verbose");
  EXPECT_GT(std::ranges::count(verbose.m_sOutput, '\n'), 60); // the control
}

TEST_F(CommandTest, ALongRunSaysBeforeHowLongItTakes) {
  const CInterrupted result = Interrupt("run --full", "1/23 ");
  const std::string before = result.m_sOutput.substr(0, result.m_sOutput.find("1/23 "));
  EXPECT_TRUE(Says(before, "this takes about 11 minutes"));
  EXPECT_FALSE(Run("run --scenes bowl --contacts 20").Says("minutes")); // the control
}

// A ball that flies away from the only wall; one that flies at it is the control.
TEST_F(CommandTest, ASceneInWhichNothingIsMetIsRefusedWithinASecond) {
  const auto run = [&](int speed, const std::string& more, const char* pOptions) {
    return Run("scene " +
               WriteScene(R"({"type": "line_segment", "p0": [1, -1], "p1": [1, 1]})" + more,
                          fmt::format(R"({{"position": [0, 0], "velocity": [{}, 0], "radius": 0.1}})", speed),
                          "", 1000) +
               pOptions);
  };
  // A sensor gives no impact.
  for (const char* pMore :
       {"", R"(, {"type": "circle", "position": [-9, 0], "radius": 1, "sensor": true})"}) {
    const CResult result = run(-3, pMore, " --full");
    EXPECT_EQ(result.m_nExit, 2) << result.m_sOutput;
    // By steps and not by a clock, which sanitizers slow down: a million of them take half a second.
    int trials = 0, thousands = 1000;
    const std::size_t at = std::min(result.m_sOutput.find("none met anything in "), result.m_sOutput.size());
    std::sscanf(result.m_sOutput.c_str() + at, "none met anything in %d random trials (%d,", &trials,
                &thousands);
    EXPECT_LT(thousands, 1000) << result.m_sOutput;
  }
  EXPECT_FALSE(fs::exists(m_cFolder / "run.json"));
  EXPECT_EQ(run(3, "", " --contacts 5").m_nExit, 0);
}

// So many balls that the search for a first impact ends before the first one, which is no reason to refuse
// them.
TEST_F(CommandTest, ManyBallsThatFallForAWhileAreNoEmptyScene) {
  std::string balls;
  for (int i = 0; i < 300; ++i)
    balls += fmt::format(R"({}{{"position": [{}, 1], "radius": 0.1}})", i == 0 ? "" : ",", 0.3 * i);
  const CResult result = Run("scene " +
                             WriteScene(R"({"type": "line_segment", "p0": [-1, 0], "p1": [99, 0]})", balls,
                                        R"("gravity": [0, -10],)") +
                             " --engines native --contacts 1");
  EXPECT_EQ(result.m_nExit, 0) << result.m_sOutput;
  EXPECT_TRUE(result.Says("\nmine  "));
}

TEST_F(CommandTest, BadInputIsRefusedWithTheReason) {
  fs::create_directories(m_cFolder / "empty");
  const std::string syntax = "scene " + Write("syntax.json", "{\n  \"name\": \"x\",,\n}");
  const std::string ball = R"({"position": [1, 1], "velocity": [1e18, 0], "radius": 0.1})";
  const std::string field = "scene " + WriteScene(R"({"type": "circle", "position": [0, 0], "radius": -1})",
                                                  ball, "", 1, "field.json");
  const std::string fast = "scene " + WriteScene(R"({"type": "point", "position": [0, 0]})", ball);
  const std::pair<std::string, const char*> cases[] = {
      {"run --scenes bowl,pinbal",
       "there is no scene 'pinbal': did you mean 'pinball'? Known: ball_on_ball, "},
      {"run --engines bux2d",
       "there is no engine 'bux2d': did you mean 'box2d'? Known: native, native-approximate,"},
      {"run --engines ''", "there is no engine ''. Known: native, native-approximate, box2d, box2d-tuned"},
      {"run --fail-above tunnelled=0", "there is no metric 'tunnelled': did you mean 'tunneled'?"},
      {"run --fail-above missed=-1", "missed=VALUE: expected a finite number of at least 0, got '-1'"},
      {"run --seed -1", "--seed: expected a whole number from 0 to 18446744073709551615, got '-1'"},
      {"run --seed 18446744073709551616", "--seed: expected a whole number"},
      {"run --seed 1.5", "--seed: expected a whole number"},
      {"run --folder " + (m_cFolder / "empty").string(), "empty: expected a folder of scenes"},
      {"run --contacts 0", "--contacts"},
      {"rum", "there is no command 'rum': did you mean 'run'? Known: run, scene, list"},
      {"run scene mine.json", "following arguments were not expected"},
      {"run --sede 3", "there is no option '--sede': did you mean '--seed'?"},
      {"run --fail_above missed=1", "did you mean '--fail-above'?"},
      {"scene /nowhere/at_all.json", "/nowhere/at_all.json"},
      {syntax, "syntax.json:2:15"},
      {field, "field.json: /shapes/0/radius: expected"},
      {fast,
       "mine.json: /balls/0/velocity: expected finite coordinates of at most 1e+09 in size, got [1e+18,0] on "
       "box2d (--engines takes others)"},
      {fast + " --engines native", "none met anything"}, // which holds it
      {"", "subcommand"},
      {"run --scenes bowl --svg " + (m_cFolder / "no/chart.svg").string(), "no/chart.svg: cannot be written"},
      {"run --out " + Write("file", "") + "/below", "file/below"},
  };
  for (const auto& [arguments, reason] : cases) {
    const bool hasFolder = arguments.empty() || arguments.find("--out") != arguments.npos;
    const CResult result = hasFolder ? Call(arguments) : Run(arguments);
    EXPECT_EQ(result.m_nExit, 2) << arguments;
    EXPECT_TRUE(result.Says(reason));
  }
  // All of this is known before any work is done.
  EXPECT_FALSE(fs::exists(m_cFolder / "run.json"));
}

TEST_F(CommandTest, HelpAndListSucceed) {
  for (const auto& [pArguments, pText] : {std::pair("--help", "Usage: "),
                                          {"run --help", "--contacts"},
                                          {"--version", "shapes-compare 0."},
                                          {"list", "pinball"}}) {
    const CResult result = Call(pArguments);
    EXPECT_EQ(result.m_nExit, 0) << pArguments;
    EXPECT_TRUE(result.Says(pText));
  }
}

TEST_F(CommandTest, OutputThatCannotBeWrittenIsNoSuccess) {
  for (const char* pArguments : {"list", "run --help"}) {
    const CResult result = Call(std::string("-c '" SHAPES_COMPARE " ") + pArguments + " >/dev/full'", "sh");
    EXPECT_EQ(result.m_nExit, 2) << pArguments;
    EXPECT_TRUE(result.Says("standard output cannot be written"));
  }
}

// compare/run.sh answers these without a compiler; PATH has nothing to build with.
TEST_F(CommandTest, TheScriptKnowsTheOptionsWithoutABuild) {
  fs::create_directories(m_cFolder / "bin");
  for (const char* pTool : {"bash", "cat", "dirname", "grep", "sort", "xargs", "echo"})
    fs::create_symlink(fs::exists(std::string("/usr/bin/") + pTool) ? std::string("/usr/bin/") + pTool
                                                                    : std::string("/bin/") + pTool,
                       m_cFolder / "bin" / pTool);
  const auto script = [&](const std::string& arguments) {
    return Call("", "env PATH='" + (m_cFolder / "bin").string() +
                        "' bash " SHAPES_SOURCE_DIR "/compare/run.sh " + arguments);
  };
  const CResult help = script("--help");
  EXPECT_EQ(help.m_nExit, 0);
  EXPECT_EQ(help.m_sOutput, Call("run --help").m_sOutput) << "compare/run_help.txt is what it prints";
  const CResult wrong = script("--scenes bowl --ful");
  EXPECT_EQ(wrong.m_nExit, 2);
  EXPECT_TRUE(wrong.Says("there is no option '--ful'. Known: --browse"));
  const CResult right = script("--full --scenes=bowl"); // the control: goes on to the build
  EXPECT_NE(right.m_nExit, 0);
  EXPECT_FALSE(right.Says("there is no option"));
}

} // namespace
