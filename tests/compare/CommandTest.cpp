// SPDX-License-Identifier: MIT
// shapes-compare as a user calls it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

struct CResult {
  int m_nExit;
  std::string m_sOutput; // both streams
};

class CommandTest : public testing::Test {
protected:
  void SetUp() override {
    const auto* pInfo = testing::UnitTest::GetInstance()->current_test_info();
    m_cFolder =
        fs::temp_directory_path() / ("shapes-compare-test-" + std::to_string(getpid()) + pInfo->name());
    fs::create_directories(m_cFolder);
  }
  void TearDown() override { fs::remove_all(m_cFolder); }

  static CResult Call(const std::string& arguments) {
    FILE* pPipe = popen((std::string(SHAPES_COMPARE) + " " + arguments + " 2>&1").c_str(), "r");
    CResult result{-1, ""};
    if (pPipe == nullptr) return result;
    char buffer[4096];
    while (const std::size_t n = fread(buffer, 1, sizeof buffer, pPipe))
      result.m_sOutput.append(buffer, n);
    const int status = pclose(pPipe);
    if (WIFEXITED(status)) result.m_nExit = WEXITSTATUS(status);
    return result;
  }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(m_cFolder / name) << text;
    return (m_cFolder / name).string();
  }
  std::string Read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(m_cFolder / name).rdbuf();
    return text.str();
  }
  void ExpectBadInput(const std::string& arguments, const std::string& reason) const {
    const CResult result = Call(arguments);
    EXPECT_EQ(result.m_nExit, 2) << result.m_sOutput;
    EXPECT_NE(result.m_sOutput.find(reason), std::string::npos) << result.m_sOutput;
  }

  fs::path m_cFolder;
};

TEST_F(CommandTest, RunWritesTheTableTheJsonAndTheCsv) {
  const CResult result = Call("run --scenes bowl,corner --quick --contacts 50 --out " + m_cFolder.string());
  ASSERT_EQ(result.m_nExit, 0) << result.m_sOutput;
  EXPECT_NE(result.m_sOutput.find("\nbowl "), std::string::npos);
  EXPECT_NE(result.m_sOutput.find("\ncorner "), std::string::npos);
  EXPECT_EQ(result.m_sOutput.find("spinner"), std::string::npos);

  const auto json = nlohmann::json::parse(Read("run.json"));
  ASSERT_EQ(json.at("scenes").size(), 2u);
  EXPECT_EQ(json.at("version"), 1);
  EXPECT_NE(json.at("command").get<std::string>().find("run --scenes bowl,corner --quick"),
            std::string::npos);
  for (const auto& scene : json.at("scenes")) {
    ASSERT_EQ(scene.at("engines").size(), 2u);
    EXPECT_EQ(scene.at("engines")[0].at("name"), "native");
    EXPECT_EQ(scene.at("engines")[1].at("name"), "box2d");
    for (const auto& engine : scene.at("engines")) {
      EXPECT_EQ(engine.at("contacts"), 50);
      EXPECT_LE(engine.at("missed"), engine.at("tunneled"));
      for (const char* key : {"median", "p95", "max"})
        EXPECT_TRUE(engine.at("setback_error").at(key).is_number());
      EXPECT_GT(engine.at("ns_per_ball_step"), 0.0);
      EXPECT_TRUE(engine.at("settings").at("time_step").is_number());
    }
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
}

TEST_F(CommandTest, TheSameCommandGivesTheSamePhysicsBitForBit) {
  const std::string once = (m_cFolder / "a").string(), again = (m_cFolder / "b").string();
  ASSERT_EQ(Call("run --scenes pinball,spinner --quick --contacts 100 --seed 5 --out " + once).m_nExit, 0);
  ASSERT_EQ(Call("run --scenes pinball,spinner --quick --contacts 100 --seed 5 --out " + again).m_nExit, 0);
  EXPECT_EQ(Read("a/contacts.csv"), Read("b/contacts.csv"));
  ASSERT_EQ(Call("run --scenes pinball,spinner --quick --contacts 100 --seed 6 --out " + again).m_nExit, 0);
  EXPECT_NE(Read("a/contacts.csv"), Read("b/contacts.csv")); // the control
}

TEST_F(CommandTest, ASceneOfOnesOwnIsRun) {
  const std::string file = Write("mine.json", R"({"name": "mine", "duration": 1, "time_step": 0.01,
    "bounds": {"left": -2, "bottom": -2, "right": 2, "top": 2},
    "shapes": [{"type": "arc", "position": [0, 0], "radius": 1, "angles": [0, 0]}],
    "balls": [{"position": [0.3, 0], "velocity": [3, 2], "radius": 0.1}]})");
  const CResult result = Call("scene " + file + " --quick --contacts 20 --out " + m_cFolder.string());
  EXPECT_EQ(result.m_nExit, 0) << result.m_sOutput;
  EXPECT_NE(result.m_sOutput.find("\nmine "), std::string::npos);
}

TEST_F(CommandTest, BadInputIsRefusedWithTheReason) {
  const std::string out = " --out " + m_cFolder.string();
  ExpectBadInput("run --scenes nothing" + out, "there is no scene 'nothing': expected one of");
  ExpectBadInput("run --seed x" + out, "--seed");
  ExpectBadInput("run --contacts 0" + out, "--contacts");
  ExpectBadInput("jump", "jump");
  ExpectBadInput("", "subcommand");
  ExpectBadInput("scene /nowhere/at_all.json" + out, "/nowhere/at_all.json");
  ExpectBadInput("scene " + Write("syntax.json", "{\n  \"name\": \"x\",,\n}") + out, "syntax.json:2:15");
  ExpectBadInput("scene " + Write("field.json", R"({"name": "x", "duration": 1,
    "bounds": {"left": -2, "bottom": -2, "right": 2, "top": 2},
    "shapes": [{"type": "circle", "position": [0, 0], "radius": -1}],
    "balls": [{"position": [1, 1], "radius": 0.1}]})") +
                     out,
                 "field.json: /shapes/0/radius: expected");
  ExpectBadInput("run --quick --out " + Write("file", "") + "/below", "file/below");
}

TEST_F(CommandTest, HelpAndListSucceed) {
  EXPECT_EQ(Call("--help").m_nExit, 0);
  EXPECT_EQ(Call("run --help").m_nExit, 0);
  const CResult list = Call("list");
  EXPECT_EQ(list.m_nExit, 0);
  EXPECT_NE(list.m_sOutput.find("pinball"), std::string::npos);
}

} // namespace
