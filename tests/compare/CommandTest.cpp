// SPDX-License-Identifier: MIT
// shapes-compare as a user calls it.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "CommandCalls.h"
#include "scene/Engines.h"

namespace {

namespace fs = std::filesystem;
using Shapes::Compare::Tests::CCommandTest;
using Shapes::Compare::Tests::CResult;

class CommandTest : public CCommandTest {
protected:
  void ExpectBadInput(const std::string& arguments, const std::string& reason) const {
    const CResult result = Call(arguments);
    EXPECT_EQ(result.m_nExit, 2) << result.m_sOutput;
    EXPECT_NE(result.m_sOutput.find(reason), std::string::npos) << result.m_sOutput;
  }
};

// Runs the program on a terminal of its own. `talk` gets what it has written so far, again and again, and
// says what is typed.
CResult CallOnTerminal(const std::string& arguments,
                       const std::function<std::string(const std::string&)>& talk) {
  CResult result{-1, ""};
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    signal(SIGINT, SIG_DFL);
    execl("/bin/sh", "sh", "-c", ("exec " + std::string(SHAPES_COMPARE) + " " + arguments).c_str(), nullptr);
    _exit(127);
  }
  if (child < 0) return result;
  char buffer[4096];
  for (ssize_t n; (n = read(terminal, buffer, sizeof buffer)) > 0;) { // ends with an error at the end
    result.m_sOutput.append(buffer, static_cast<std::size_t>(n));
    const std::string typed = talk(result.m_sOutput);
    if (!typed.empty() && write(terminal, typed.data(), typed.size()) < 0) break;
  }
  int status = 0;
  waitpid(child, &status, 0);
  close(terminal);
  if (WIFEXITED(status)) result.m_nExit = WEXITSTATUS(status);
  return result;
}

TEST_F(CommandTest, RunWritesTheTableAndThreeFiles) {
  const CResult result = Call("run --scenes corner,bowl --contacts 50 --out " + m_cFolder.string());
  ASSERT_EQ(result.m_nExit, 0) << result.m_sOutput;
  EXPECT_NE(result.m_sOutput.find("\nbowl  "), std::string::npos);
  EXPECT_NE(result.m_sOutput.find("\ncorner  "), std::string::npos);
  EXPECT_EQ(result.m_sOutput.find("spinner"), std::string::npos);
  EXPECT_NE(result.m_sOutput.find("\nResult: "), std::string::npos);
  EXPECT_NE(result.m_sOutput.find("report.html"), std::string::npos);
  EXPECT_EQ(result.m_sOutput.find('\r'), std::string::npos); // no progress where there is no terminal

  const auto json = nlohmann::json::parse(Read("run.json"));
  ASSERT_EQ(json.at("scenes").size(), 2u);
  EXPECT_EQ(json.at("scenes")[0].at("name"), "bowl"); // in the order of the folder
  EXPECT_EQ(json.at("interrupted"), false);
  EXPECT_EQ(json.at("command"),
            "shapes-compare run --scenes corner,bowl --contacts 50 --out " + m_cFolder.string());
  for (const auto& scene : json.at("scenes")) {
    const auto rows = Shapes::Compare::GetEngineRows();
    ASSERT_EQ(scene.at("engines").size(), rows.size());
    for (std::size_t e = 0; e < rows.size(); ++e)
      EXPECT_EQ(scene.at("engines")[e].at("name"), rows[e].m_sName);
    for (const auto& engine : scene.at("engines"))
      EXPECT_EQ(engine.at("contacts"), 50);
  }

  std::istringstream csv(Read("contacts.csv"));
  std::string line;
  std::size_t rows = 0, fields = 0;
  while (std::getline(csv, line)) {
    const auto n = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
    if (rows++ == 0) fields = n;
    EXPECT_EQ(n, fields) << line;
  }
  EXPECT_EQ(rows, 1u + 2u * 50u);

  const std::string page = Read("report.html");
  EXPECT_NE(page.find("<html"), std::string::npos);
  EXPECT_NE(page.find("corner"), std::string::npos);
}

TEST_F(CommandTest, TheSameCommandGivesTheSamePhysicsBitForBit) {
  const std::string once = (m_cFolder / "a").string(), again = (m_cFolder / "b").string();
  ASSERT_EQ(Call("run --scenes pinball,spinner --contacts 60 --seed 5 --out " + once).m_nExit, 0);
  ASSERT_EQ(Call("run --scenes pinball,spinner --contacts 60 --seed 5 --out " + again).m_nExit, 0);
  EXPECT_EQ(Read("a/contacts.csv"), Read("b/contacts.csv"));
  ASSERT_EQ(Call("run --scenes pinball,spinner --contacts 60 --seed 6 --out " + again).m_nExit, 0);
  EXPECT_NE(Read("a/contacts.csv"), Read("b/contacts.csv")); // the control
}

TEST_F(CommandTest, EnginesAreChosen) {
  const std::string rest = " --scenes bowl --contacts 20 --out " + m_cFolder.string();
  const auto engines = [&](const std::string& names) {
    EXPECT_EQ(Call("run --engines " + names + rest).m_nExit, 0) << names;
    const auto json = nlohmann::json::parse(Read("run.json"));
    std::string text;
    for (const auto& engine : json.at("scenes").at(0).at("engines"))
      text += engine.at("name").get<std::string>() + " ";
    return text;
  };
  EXPECT_EQ(engines("box2d"), "box2d ");
  EXPECT_EQ(engines("native"), "native ");
  EXPECT_EQ(engines("box2d,native"), "native box2d ");
  EXPECT_EQ(engines("box2d,native-approximate,native"), "native native-approximate box2d ");
  EXPECT_EQ(engines("box2d-tuned"), "box2d-tuned ");
}

TEST_F(CommandTest, FailAboveIsAGate) {
  const std::string run = "run --scenes head_on_wall,bowl --contacts 100 --out " + m_cFolder.string();
  // Balls that are not swept are lost at the wall every other time, swept ones never.
  const CResult above = Call(run + " --fail-above tunneled=.1 --fail-above ns_per_ball_step=1e9");
  EXPECT_EQ(above.m_nExit, 1);
  EXPECT_NE(above.m_sOutput.find(" on head_on_wall with native-approximate: above 0.1"), std::string::npos)
      << above.m_sOutput;
  EXPECT_EQ(above.m_sOutput.find("with native: above"), std::string::npos) << above.m_sOutput;
  EXPECT_EQ(above.m_sOutput.find("with box2d: above"), std::string::npos) << above.m_sOutput;
  EXPECT_TRUE(fs::exists(m_cFolder / "run.json"));
  EXPECT_EQ(Call(run + " --fail-above tunneled=.9").m_nExit, 0);
  EXPECT_EQ(Call(run + " --engines box2d --fail-above tunneled=.1").m_nExit, 0);
}

// The line of the README that asks in CI whether a setting is good enough, of a bundled table.
TEST_F(CommandTest, TheGateOfTheReadmePassesByDefaultAndFailsWithoutSweeps) {
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
  line = replace(replace(line, program, ""), "mine.json", SHAPES_SCENES_DIR "/pinball.json") + " --out " +
         m_cFolder.string();
  // Both at once: engines do not change each other's figures, and what is not above passes
  // (FailAboveIsAGate).
  const CResult both = Call(replace(line, "--engines native", "--engines native,native-approximate"));
  EXPECT_EQ(both.m_nExit, 1) << both.m_sOutput;
  EXPECT_NE(both.m_sOutput.find(" on pinball with native-approximate: above "), std::string::npos)
      << both.m_sOutput;
  EXPECT_EQ(both.m_sOutput.find(" with native: above "), std::string::npos) << both.m_sOutput;
}

TEST_F(CommandTest, TheChartIsWrittenAsSvg) {
  const fs::path file = m_cFolder / "chart.svg";
  ASSERT_EQ(
      Call("run --scenes bowl --contacts 20 --out " + m_cFolder.string() + " --svg " + file.string()).m_nExit,
      0);
  const std::string svg = Read("chart.svg");
  EXPECT_TRUE(svg.starts_with("<svg ")) << svg.substr(0, 80);
  EXPECT_NE(svg.find("data-engine=\"native\""), svg.npos);
}

// A stand-in for the desktop's program is called with the page.
TEST_F(CommandTest, TheReportIsOpenedInTheDefaultBrowser) {
  const std::string browser =
      Write("xdg-open", "#!/bin/sh\necho \"$1\" > " + (m_cFolder / "part").string() + "; mv " +
                            (m_cFolder / "part").string() + " " + (m_cFolder / "opened").string() + "\n");
  fs::permissions(browser, fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", (m_cFolder.string() + ":" + path).c_str(), 1);
  EXPECT_EQ(Call("run --scenes bowl --contacts 10 --browse --out " + m_cFolder.string()).m_nExit, 0);
  setenv("PATH", path.c_str(), 1);
  for (int i = 0; i < 500 && !fs::exists(m_cFolder / "opened"); ++i)
    usleep(10000); // it runs on its own
  EXPECT_NE(Read("opened").find("report.html"), std::string::npos);
}

TEST_F(CommandTest, CtrlCReportsWhatIsFinished) {
  bool typed = false;
  const CResult result =
      CallOnTerminal("run --contacts 300 --out " + m_cFolder.string(), [&](const std::string& output) {
        const bool now = !typed && output.find("2/23 ") != std::string::npos;
        typed |= now;
        return now ? "\x03" : "";
      });
  EXPECT_EQ(result.m_nExit, 130) << result.m_sOutput;
  EXPECT_NE(result.m_sOutput.find("Interrupted: only the"), std::string::npos) << result.m_sOutput;
  EXPECT_NE(result.m_sOutput.find("1/23 ball_on_ball  impacts 0%"), std::string::npos) << result.m_sOutput;
  const auto json = nlohmann::json::parse(Read("run.json"));
  EXPECT_EQ(json.at("interrupted"), true);
  EXPECT_GE(json.at("scenes").size(), 1u);
  EXPECT_LT(json.at("scenes").size(), 23u);
  EXPECT_TRUE(fs::exists(m_cFolder / "report.html") && fs::exists(m_cFolder / "contacts.csv"));
}

TEST_F(CommandTest, CtrlCBeforeTheFirstSceneLeavesAnEarlierReportAlone) {
  Write("run.json", "earlier");
  bool typed = false;
  const CResult result =
      CallOnTerminal("run --scenes pinball --out " + m_cFolder.string(), [&](const std::string& output) {
        const bool now = !typed && output.find("1/1 ") != std::string::npos;
        typed |= now;
        return now ? "\x03" : "";
      });
  EXPECT_EQ(result.m_nExit, 130) << result.m_sOutput;
  EXPECT_NE(result.m_sOutput.find("nothing is written"), std::string::npos) << result.m_sOutput;
  EXPECT_EQ(Read("run.json"), "earlier");
  EXPECT_FALSE(fs::exists(m_cFolder / "report.html"));
}

TEST_F(CommandTest, ASceneOfOnesOwnIsRun) {
  const std::string file = Write("mine.json", R"({"name": "mine", "duration": 1, "time_step": 0.01,
    "bounds": {"left": -2, "bottom": -2, "right": 2, "top": 2},
    "shapes": [{"type": "arc", "position": [0, 0], "radius": 1, "angles": [0, 0]}],
    "balls": [{"position": [0.3, 0], "velocity": [3, 2], "radius": 0.1}]})");
  const CResult result = Call("scene " + file + " --contacts 20 --out " + m_cFolder.string());
  EXPECT_EQ(result.m_nExit, 0) << result.m_sOutput;
  EXPECT_NE(result.m_sOutput.find("\nmine  "), std::string::npos);
}

TEST_F(CommandTest, EverySceneFitsOnOneScreen) {
  const CResult result = Call("run --contacts 10 --out " + m_cFolder.string());
  ASSERT_EQ(result.m_nExit, 0) << result.m_sOutput;
  EXPECT_LE(std::count(result.m_sOutput.begin(), result.m_sOutput.end(), '\n'), 40) << result.m_sOutput;
  // Longer replays and larger counts make that of a full run some .4 MB larger, and it has to stay below 3.
  EXPECT_LT(fs::file_size(m_cFolder / "report.html"), 2'500'000u);
  const CResult verbose =
      Call("run --contacts 10 --scenes bowl,corner,spinner --verbose --out " + m_cFolder.string());
  EXPECT_GT(std::count(verbose.m_sOutput.begin(), verbose.m_sOutput.end(), '\n'), 60); // the control
}

TEST_F(CommandTest, ScenesAreShownAsTheyAreFinished) {
  std::string early;
  CallOnTerminal("run --contacts 300 --out " + m_cFolder.string(), [&](const std::string& output) {
    const bool now = early.empty() && output.find("2/23 ") != std::string::npos;
    if (now) early = output;
    return now ? "\x03" : "";
  });
  EXPECT_NE(early.find("ball_on_ball "), std::string::npos) << early;
  EXPECT_EQ(early.find("\nbowl "), std::string::npos) << early;
}

TEST_F(CommandTest, TheNumberOfContactsIsObeyed) {
  for (const int contacts : {30, 2100}) { // less and more than a run has by itself
    const CResult result = Call(fmt::format(
        "run --scenes head_on_wall --engines native --contacts {} --out {}", contacts, m_cFolder.string()));
    ASSERT_EQ(result.m_nExit, 0) << result.m_sOutput;
    EXPECT_EQ(nlohmann::json::parse(Read("run.json")).at("/scenes/0/engines/0/contacts"_json_pointer),
              contacts);
  }
  const CResult full =
      Call("run --scenes head_on_wall --engines native --full --contacts 40 --out " + m_cFolder.string());
  ASSERT_EQ(full.m_nExit, 0) << full.m_sOutput;
  EXPECT_EQ(nlohmann::json::parse(Read("run.json")).at("/scenes/0/engines/0/contacts"_json_pointer), 40);
}

TEST_F(CommandTest, ALongRunSaysBeforeHowLongItTakes) {
  bool typed = false;
  const CResult result =
      CallOnTerminal("run --full --out " + m_cFolder.string(), [&](const std::string& output) {
        const bool now = !typed && output.find("1/23 ") != std::string::npos;
        typed |= now;
        return now ? "\x03" : "";
      });
  const std::size_t told = result.m_sOutput.find("this takes about 11 minutes");
  ASSERT_NE(told, std::string::npos) << result.m_sOutput;
  EXPECT_LT(told, result.m_sOutput.find("1/23 "));
  EXPECT_EQ(Call("run --scenes bowl --contacts 20 --out " + m_cFolder.string()).m_sOutput.find("minutes"),
            std::string::npos); // the control
}

// A ball that flies away from the only wall; one that flies at it is the control.
TEST_F(CommandTest, ASceneInWhichNothingIsMetIsRefusedWithinASecond) {
  const auto scene = [&](int direction, const char* pMore) {
    return Write("mine.json", fmt::format(R"({{"name": "mine", "duration": 1000,
      "bounds": {{"left": -2e6, "bottom": -2, "right": 2e6, "top": 2}},
      "shapes": [{{"type": "line_segment", "p0": [1, -1], "p1": [1, 1]}}{}],
      "balls": [{{"position": [0, 0], "velocity": [{}, 0], "radius": 0.1}}]}})",
                                          pMore, 3 * direction));
  };
  const auto refuse = [&](const std::string& file) {
    const CResult result = Call("scene " + file + " --full --out " + m_cFolder.string());
    EXPECT_EQ(result.m_nExit, 2) << result.m_sOutput;
    const std::size_t at = result.m_sOutput.find("none met anything in ");
    ASSERT_NE(at, std::string::npos) << result.m_sOutput;
    // By steps and not by a clock, which sanitizers slow down: a million of them take half a second.
    int trials = 0, thousands = 0;
    ASSERT_EQ(std::sscanf(result.m_sOutput.c_str() + at, "none met anything in %d random trials (%d,",
                          &trials, &thousands),
              2)
        << result.m_sOutput;
    EXPECT_LT(thousands, 1000);
  };
  refuse(scene(-1, ""));
  // A sensor gives no impact.
  refuse(scene(-1, R"(, {"type": "circle", "position": [-9, 0], "radius": 1, "sensor": true})"));
  EXPECT_FALSE(fs::exists(m_cFolder / "run.json"));
  EXPECT_EQ(Call("scene " + scene(1, "") + " --contacts 5 --out " + m_cFolder.string()).m_nExit, 0);
}

// So many balls that the search for a first impact ends before the first one, which is no reason to refuse
// them.
TEST_F(CommandTest, ManyBallsThatFallForAWhileAreNoEmptyScene) {
  std::string balls;
  for (int i = 0; i < 300; ++i)
    balls += fmt::format(R"({}{{"position": [{}, 1], "radius": 0.1}})", i == 0 ? "" : ",", 0.3 * i);
  const std::string file = Write("many.json", R"({"name": "many", "duration": 1, "gravity": [0, -10],
    "bounds": {"left": -2, "bottom": -2, "right": 100, "top": 2},
    "shapes": [{"type": "line_segment", "p0": [-1, 0], "p1": [99, 0]}], "balls": [)" +
                                                  balls + "]}");
  const CResult result = Call("scene " + file + " --engines native --contacts 1 --out " + m_cFolder.string());
  EXPECT_EQ(result.m_nExit, 0) << result.m_sOutput;
}

TEST_F(CommandTest, BadInputIsRefusedWithTheReason) {
  const std::string out = " --out " + m_cFolder.string();
  ExpectBadInput("run --scenes pinbal" + out,
                 "there is no scene 'pinbal': did you mean 'pinball'? Known: ball_on_ball, ");
  ExpectBadInput("run --scenes bowl,nothing_like_it" + out, "there is no scene 'nothing_like_it'. Known: ");
  ExpectBadInput("run --engines bux2d" + out,
                 "there is no engine 'bux2d': did you mean 'box2d'? Known: native, native-approximate,");
  ExpectBadInput("run --fail-above tunnelled=0" + out,
                 "there is no metric 'tunnelled': did you mean 'tunneled'?");
  ExpectBadInput("run --fail-above missed=-1" + out,
                 "missed=VALUE: expected a finite number of at least 0, got '-1'");
  ExpectBadInput("run --fail-above missed=nan" + out, "got 'nan'");
  ExpectBadInput("run --fail-above missed" + out, "got ''");
  ExpectBadInput("run --seed x" + out, "--seed");
  ExpectBadInput("run --seed -1" + out, "--seed");
  fs::create_directories(m_cFolder / "empty");
  ExpectBadInput("run --folder " + (m_cFolder / "empty").string() + out,
                 "empty: expected a folder of scenes");
  ExpectBadInput("run --contacts 0" + out, "--contacts");
  ExpectBadInput("jump", "there is no command 'jump'. Known: run, scene, list");
  ExpectBadInput("rum" + out, "there is no command 'rum': did you mean 'run'?");
  ExpectBadInput("run scene mine.json" + out, "following arguments were not expected");
  ExpectBadInput("run --sede 3" + out, "there is no option '--sede': did you mean '--seed'?");
  ExpectBadInput("run --ful" + out, "there is no option '--ful': did you mean '--full'?");
  ExpectBadInput("run --fail_above missed=1" + out, "did you mean '--fail-above'?");
  ExpectBadInput("", "subcommand");
  ExpectBadInput("scene /nowhere/at_all.json" + out, "/nowhere/at_all.json");
  ExpectBadInput("scene " + Write("syntax.json", "{\n  \"name\": \"x\",,\n}") + out, "syntax.json:2:15");
  ExpectBadInput("scene " + Write("field.json", R"({"name": "x", "duration": 1,
    "bounds": {"left": -2, "bottom": -2, "right": 2, "top": 2},
    "shapes": [{"type": "circle", "position": [0, 0], "radius": -1}],
    "balls": [{"position": [1, 1], "radius": 0.1}]})") +
                     out,
                 "field.json: /shapes/0/radius: expected");
  const std::string fast = Write("fast.json", R"({"name": "x", "duration": 1,
    "bounds": {"left": -2, "bottom": -2, "right": 2, "top": 2},
    "shapes": [{"type": "point", "position": [0, 0]}],
    "balls": [{"position": [1, 1], "velocity": [1e18, 0], "radius": 0.1}]})");
  ExpectBadInput("scene " + fast + out,
                 "fast.json: /balls/0/velocity: expected finite coordinates of at most 1e+09 in size, got "
                 "[1e+18,0] on box2d (--engines takes others)");
  ExpectBadInput("scene " + fast + " --engines native" + out, "none met anything"); // which holds it
  ExpectBadInput("run --out " + Write("file", "") + "/below", "file/below");
  // All of this is known before any work is done.
  EXPECT_FALSE(fs::exists(m_cFolder / "run.json"));
}

TEST_F(CommandTest, HelpAndListSucceed) {
  EXPECT_EQ(Call("--help").m_nExit, 0);
  EXPECT_EQ(Call("run --help").m_nExit, 0);
  const CResult version = Call("--version");
  EXPECT_EQ(version.m_nExit, 0);
  EXPECT_EQ(version.m_sOutput.rfind("shapes-compare 0.", 0), 0u) << version.m_sOutput;
  const CResult list = Call("list");
  EXPECT_EQ(list.m_nExit, 0);
  EXPECT_NE(list.m_sOutput.find("pinball"), std::string::npos);
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
  EXPECT_EQ(help.m_sOutput, Call("run --help").m_sOutput)
      << "compare/run_help.txt is what the program prints";
  const CResult wrong = script("--scenes bowl --ful");
  EXPECT_EQ(wrong.m_nExit, 2);
  EXPECT_NE(wrong.m_sOutput.find("there is no option '--ful'. Known: --browse"), std::string::npos)
      << wrong.m_sOutput;
  const CResult right = script("--full --scenes=bowl"); // the control: goes on to the build
  EXPECT_NE(right.m_nExit, 0);
  EXPECT_EQ(right.m_sOutput.find("there is no option"), std::string::npos) << right.m_sOutput;
}

} // namespace
