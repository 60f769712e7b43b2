// SPDX-License-Identifier: MIT
// The forms of a report, from one whose figures are known.
#include "SampleReport.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "report/Numbers.h"

namespace Shapes::Compare {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> Lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

std::vector<std::string> Fields(const std::string& line) {
  std::vector<std::string> fields{""};
  for (const char c : line)
    c == ',' ? fields.emplace_back() : fields.back() += c;
  return fields;
}

bool Contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

// As it was before it was broken into lines.
std::string Unwrapped(const std::string& text) {
  std::string plain;
  for (const char c : text)
    if (c != '\n' && !(c == ' ' && plain.ends_with(' ')))
      plain += c;
    else if (!plain.ends_with(' '))
      plain += ' ';
  return plain;
}

TEST(NumbersTest, AreWhatPeopleRead) {
  EXPECT_EQ(SizeText(0.0), "0");
  EXPECT_EQ(SizeText(0.0004), "4e-4");
  EXPECT_EQ(SizeText(2.3e-7), "2e-7");
  EXPECT_EQ(SizeText(9e-8), "<1e-7");
  EXPECT_EQ(SizeText(0.0005), "0.001");
  EXPECT_EQ(SizeText(1.23456), "1.235");
  EXPECT_EQ(SizeText(12.34), "12.3");
  EXPECT_EQ(SizeText(1e30), "1e+30");
  EXPECT_EQ(CountText(999), "999");
  EXPECT_EQ(CountText(1000), "1,000");
  EXPECT_EQ(CountText(1234567), "1,234,567");
  EXPECT_EQ(RateText(0, 0), "-");
  EXPECT_EQ(RateText(0, 20000), "<0.015%");
  EXPECT_EQ(RateText(0, 2), "<100%");
  EXPECT_EQ(RateText(203, 1000), "20.3%");
  EXPECT_EQ(RateText(6, 1000), "0.60%");
  EXPECT_EQ(RateText(7, 7), "100%");
  EXPECT_EQ(RateText(1, 20000), "0.0050%");
  EXPECT_EQ(RateTextWithError(1, 100000000), "<0.0001%");
  EXPECT_EQ(RateTextWithError(203, 1000), "20.3% +-2.5"); // Wilson: 17.9% to 22.9%
  EXPECT_EQ(RateTextWithError(0, 1000), "<0.3%");
  EXPECT_EQ(TwoDigits(12.3456), "12");
  EXPECT_EQ(TwoDigits(1234.5), "1234"); // to even
  EXPECT_EQ(TwoDigits(0.0123), "0.012");
  EXPECT_EQ(TwoDigits(0.0), "0");
  EXPECT_EQ(DegreesText(0.0), "0.001 degrees");
  EXPECT_EQ(DegreesText(0.01), "0.57 degrees");
  EXPECT_EQ(DegreesText(1.0), "57 degrees");
  EXPECT_EQ(LossText(0, 2000), "none of 2,000");
  EXPECT_EQ(LossText(1, 40), "1 in 40");
  EXPECT_EQ(LossText(7, 30000), "1 in 4,300");
  EXPECT_EQ(LossText(203, 1000), "1 in 4.9");
  EXPECT_EQ(LossText(450, 1000), "45%");
  EXPECT_EQ(LossText(0, 0), "-");
  EXPECT_EQ(FasterText(7.14), "7.1 times faster");
  EXPECT_EQ(FasterText(0.5), "2.0 times slower");
  EXPECT_EQ(FasterText(1.04), "as fast");
  EXPECT_EQ(FasterText(16.2), "16 times faster");
  EXPECT_TRUE(Overlap({0.1, 0.3}, {0.3, 0.4}));
  EXPECT_FALSE(Overlap({0.1, 0.3}, {0.31, 0.4}));
}

TEST(TableTest, ShowsTheEnginesBelowEachOther) {
  const std::string table = MakeTable(MakeSampleReport());
  const std::vector<std::string> lines = Lines(table);
  const auto scene = std::find(lines.begin(), lines.end(),
                               "spinner, 1,000 impacts"); // one line for each engine comes after it
  ASSERT_LT(scene - lines.begin() + 4, static_cast<std::ptrdiff_t>(lines.size()));
  const std::vector<std::vector<const char*>> expected{
      {"native ", " 0.60%", "1.2% +-0.7", "0.50%", "0.750", "2e-4", " 70"},
      {"native-approximate", " 10.1%", "20.3% +-2.5", "0.50%", "0.750", "0.040", "0.25%", " 50"},
      {"box2d ", " 0.30%", "0.60% +-0.51", "0.50%", "0.750", "0.020", " 500"},
      {"box2d-tuned ", " <0.3%", "0.50%", "0.750", "2e-6", " 800"}};
  for (std::size_t e = 0; e < expected.size(); ++e)
    for (const char* pText : expected[e])
      EXPECT_TRUE(Contains(scene[static_cast<std::ptrdiff_t>(e) + 1], pText))
          << pText << " in " << scene[static_cast<std::ptrdiff_t>(e) + 1];
  EXPECT_TRUE(
      Contains(Unwrapped(table),
               "Engines: native (what a game gets by default), native-approximate (no ball is swept), "
               "box2d (Box2D as it ships), box2d-tuned (Box2D "
               "set for accuracy)."));
  // The verdict comes after the table.
  EXPECT_TRUE(Contains(table, "\n  " + MakeVerdict(MakeSampleReport(), MakeSampleScene())[0].substr(0, 40)));
}

void ExpectFits(const std::string& table) {
  for (const std::string& line : Lines(table)) {
    EXPECT_LE(line.size(), 80u) << line;
    EXPECT_FALSE(line.ends_with(' ')) << line;
    EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; })) << line;
  }
}

TEST(SummaryTest, ShowsEachSceneInALineAndTheResultOverAll) {
  CRunReport report = MakeSampleReport();
  const std::vector<std::string> heading = Lines(MakeHeading(report));
  EXPECT_EQ(heading.back(),
            "scene              take                          lost   degrees      ns  x box2d");
  EXPECT_EQ(MakeSceneLine(report, report.m_stdScenes[0]),
            "spinner            box2d-tuned          none of 1,000    <0.001     800     0.62\n");
  EXPECT_TRUE(Contains(MakeSceneLine(report, MakeUndecidedScene()), "nothing to judge"));

  // What is lost, 95% of the directions in degrees (2 rad, and 0 on two engines), ns, times as fast.
  const std::string summary = MakeSummary(report);
  for (const char* pLine :
       {"all scenes         native                   1 in 83 !    <0.001      70      7.1\n",
        "                   native-approximate      1 in 4.9 !       115      50       10\n",
        "                   box2d                   1 in 170 ~         -     500        1\n",
        "                   box2d-tuned          none of 1,000    <0.001     800     0.62\n"})
    EXPECT_TRUE(Contains(summary, pLine)) << pLine << summary;
  EXPECT_TRUE(Contains(Unwrapped(summary), "Result: Take tuned Box2D: ")) << summary;
  EXPECT_FALSE(Contains(summary, "Interrupted"));
  report.m_bInterrupted = true;
  EXPECT_TRUE(Contains(MakeSummary(report), "Interrupted: only the scenes that were finished (1) are here."));
  report.m_stdScenes.clear();
  EXPECT_TRUE(Contains(MakeSummary(report), "Nothing was judged."));
}

TEST(SummaryTest, OneEngineAloneIsHeldAgainstNone) {
  CRunReport report = MakeSampleReport();
  report.m_stdEngines.resize(1);
  report.m_stdScenes[0].m_stdEngines.resize(1);
  EXPECT_TRUE(Contains(MakeSummary(report), "Result: native: it loses 12 of 1,000 balls"))
      << MakeSummary(report);
  EXPECT_FALSE(Contains(MakeSummary(report), "ox2"));
}

TEST(TableTest, FitsATerminalWhateverTheFiguresAndNames) {
  CRunReport report = MakeSampleReport();
  CSceneReport wild = MakeSampleScene();
  wild.m_cScene.m_sName =
      "a name \x1b[31m with \xc3\xa4 that is far longer than its column, and goes on and on until no "
      "line of any terminal can hold it any more, not even this one";
  for (CEngineReport& engine : wild.m_stdEngines) {
    engine.m_cTotals.m_nContacts = 100000000;
    engine.m_cTotals.m_nMissed = engine.m_cTotals.m_nWrongSide = 33333333;
    engine.m_cTotals["setback_error"] = {1, 1e30, 1e38, 1e38};
    engine.m_cTotals["direction_error"].m_fP95 = 3.14159;
    engine.m_cCost.m_cNsPerBallStep.m_fMedian = 12345678.0;
    engine.m_nGhosts = 800;
  }
  report.m_stdScenes.push_back(wild);
  wild.m_cScene.m_sName = std::string(300, 'x');
  for (CEngineReport& engine : wild.m_stdEngines) // the longest rates
    engine.m_cTotals.m_nMissed = engine.m_cTotals.m_nWrongSide = 1000;
  report.m_stdScenes.push_back(wild);
  report.m_stdScenes.push_back(MakeUndecidedScene());
  report.m_bInterrupted = true;
  ExpectFits(MakeTable(report));
  ExpectFits(MakeHeading(report) + MakeSummary(report));
  for (const CSceneReport& scene : report.m_stdScenes)
    ExpectFits(MakeSceneLine(report, scene));
  EXPECT_TRUE(Contains(MakeTable(report), "Interrupted: only the scenes that were finished (4) are here."));
  EXPECT_FALSE(Contains(MakeTable(MakeSampleReport()), "Interrupted"));
  report.m_stdScenes.clear();
  EXPECT_TRUE(Contains(MakeTable(report), "Interrupted before any scene was finished."));
}

TEST(TableTest, SaysWhereNothingCouldBeJudged) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes = {MakeUndecidedScene()};
  const std::string table = MakeTable(report);
  EXPECT_TRUE(Contains(Unwrapped(table),
                       "gave up 40 of 40 trials, the first at trial 0, step 2: ball 0 is jammed at (1, 2)"))
      << table;
  const std::vector<std::string> lines = Lines(table);
  const auto scene = std::find(lines.begin(), lines.end(), "hopeless, 0 impacts");
  ASSERT_LT(scene - lines.begin() + 4, static_cast<std::ptrdiff_t>(lines.size()));
  for (auto line = scene + 1; line <= scene + 4; ++line) {
    EXPECT_FALSE(Contains(*line, "%")) << *line; // no rate, not even of zero
    EXPECT_TRUE(Contains(*line, " - ")) << *line;
  }
  // Where only some trials are given up, that is said beside the figures.
  report.m_stdScenes = {MakeSampleScene()};
  EXPECT_FALSE(Contains(MakeTable(report), "gave up"));
  report.m_stdScenes[0].m_cImpactTrials.m_cExcluded.m_nUndecided = 1;
  report.m_stdScenes[0].m_cImpactTrials.m_cExcluded.m_sUndecided = "trial 7, step 1: somewhere";
  EXPECT_TRUE(Contains(Unwrapped(MakeTable(report)),
                       "gave up 1 of 1200 trials, the first at trial 7, step 1: somewhere."));
}

TEST(CsvTest, HasAColumnForEveryFieldAndLeavesEmptyWhatWasNotMeasured) {
  const std::vector<std::string> lines = Lines(MakeCsv(MakeSampleReport()));
  ASSERT_EQ(lines.size(), 2u);
  const std::vector<std::string> names = Fields(lines[0]), values = Fields(lines[1]);
  ASSERT_EQ(names.size(), 11u + GetEngineRows().size() * 12u);
  ASSERT_EQ(values.size(), names.size());
  const auto value = [&](const std::string& name) {
    const auto it = std::find(names.begin(), names.end(), name);
    return it == names.end() ? "no such column" : values[static_cast<std::size_t>(it - names.begin())];
  };
  const std::pair<const char*, const char*> expected[] = {
      {"scene", "spinner"},
      {"trial", "3"},
      {"step", "14"},
      {"ball", "0"},
      {"pair", "segment end"},
      {"time_in_step", "0.25"},
      {"travel_radii", "1.5"},
      {"approach_speed_units_per_s", "8"},
      {"incidence_rad", "0.125"},
      {"elasticity", "0.5"},
      {"apart_radii", "0.0625"},
      {"native_outcome", "late"},
      {"native-approximate_outcome", "correct"},
      {"native-approximate_setback_radii", "0.5"},
      {"native-approximate_setback_error_radii", "0.03125"},
      {"native-approximate_setback_error_normal_radii", "-0.015625"},
      {"native-approximate_time_error_steps", "-0.0019531"},
      {"native-approximate_poi_error_radii", "0.0078125"},
      {"native-approximate_normal_error_rad", "0.0039062"},
      {"native-approximate_direction_error_rad", "2"},
      {"native-approximate_speed_error_relative", "-3"},
      {"native-approximate_energy_error_relative", "4"},
      {"native-approximate_position_error_radii", "5"},
      {"native-approximate_penetration_radii", "6"},
      {"box2d_outcome", "missed"},
      {"box2d_setback_radii", ""},
      {"box2d_poi_error_radii", ""},
      {"box2d_direction_error_rad", ""},
      {"box2d_penetration_radii", "7"},
      {"box2d-tuned_outcome", "late"},
      {"box2d-tuned_direction_error_rad", "0"}};
  for (const auto& [name, text] : expected)
    EXPECT_EQ(value(name), text) << name;
}

TEST(CsvTest, QuotesNames) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes[0].m_cScene.m_sName = "a, \"b\"";
  EXPECT_TRUE(Lines(MakeCsv(report)).at(1).starts_with("\"a, \"\"b\"\"\",3,14"));
}

// In units of the scene. Tracks are written as second differences, and 0 is before them.
nlohmann::json UnpackTrack(const nlohmann::json& scene, const nlohmann::json& place) {
  const std::size_t n = 2 * scene.at("radii").size();
  std::vector<std::int64_t> last(n), step(n);
  nlohmann::json track = nlohmann::json::array();
  std::size_t i = 0;
  for (const nlohmann::json& turn : scene.at("tracks").at(place.get<std::size_t>())) {
    const std::size_t k = i++ % n;
    if (!turn.is_null()) last[k] += step[k] += turn.get<std::int64_t>();
    track.push_back(turn.is_null() ? turn : nlohmann::json(last[k]));
  }
  return track;
}

TEST(ReplayJsonTest, HoldsShapesAndTracks) {
  CRunReport report = MakeSampleReport();
  CScene& scene = report.m_stdScenes[0].m_cScene;
  CArcDesc arc(Vector2(1, 2), 3, 5, 1);
  arc.m_bIsSensor = true;
  scene.m_stdShapes.push_back({arc, "", std::nullopt, false});
  scene.m_stdShapes.push_back({CCircleDesc(Vector2(-1, 0), 0.5f), "", std::nullopt, false});
  scene.m_stdShapes.push_back({CArcDesc(Vector2(0, 0), 1, 0, 0), "", std::nullopt, false});
  const auto json = nlohmann::json::parse(MakeReplayJson(report));
  EXPECT_EQ(json.at("engines"),
            nlohmann::json({"native", "native-approximate", "box2d", "box2d-tuned", "exact"}));
  const auto& s = json.at("scenes").at(0);
  EXPECT_EQ(s.at("name"), "spinner");
  EXPECT_EQ(s.at("bounds"), nlohmann::json({{"left", -45}, {"bottom", -45}, {"right", 45}, {"top", 45}}));
  ASSERT_EQ(s.at("radii").size(), 1u);
  EXPECT_FLOAT_EQ(s.at("radii")[0].get<float>(), 0.1f);

  const auto& shapes = s.at("shapes");
  ASSERT_EQ(shapes.size(), 6u);
  EXPECT_EQ(shapes[0],
            nlohmann::json::parse(
                R"({"type":"segment","points":[[-1,0],[1,0]],"sensor":false,"turns":true,"center":[0,0]})"));
  EXPECT_EQ(shapes[1].at("type"), "point");
  EXPECT_EQ(shapes[1].at("points"), nlohmann::json::parse("[[-1,0]]"));
  EXPECT_EQ(shapes[3].at("type"), "arc");
  EXPECT_EQ(shapes[3].at("sensor"), true);
  EXPECT_EQ(shapes[3].at("turns"), false);
  EXPECT_FALSE(shapes[3].contains("center"));
  // From 5 counterclockwise to 1 + 2 pi.
  EXPECT_EQ(shapes[3].at("angles"), nlohmann::json({5, 7.28319}));
  EXPECT_EQ(shapes[4].at("type"), "circle");
  EXPECT_EQ(shapes[4].at("radius"), 0.5);
  EXPECT_EQ(shapes[5].at("angles"), nlohmann::json({0, 6.28319})); // the full circle

  const auto& clip = s.at("clips").at(0);
  EXPECT_EQ(clip.at("title"), "Worst contact of native");
  EXPECT_EQ(clip.at("frames"), 2);
  EXPECT_EQ(clip.at("contact"), 1);
  EXPECT_EQ(clip.at("ball"), 0);
  // 90 units wide, five digits: three decimals.
  EXPECT_EQ(s.at("unit"), 0.001);
  EXPECT_EQ(UnpackTrack(s, clip.at("tracks").at(4)), nlohmann::json({1000, 2000, 1123, 3000}));
  // The three shapes of the compound turn, twice a second.
  ASSERT_EQ(clip.at("orientations").size(), 3u);
  const double turn = 2 * 2 * 3.14159265358979 / 60;
  EXPECT_EQ(clip.at("orientations")[0][0], 0);
  EXPECT_NEAR(clip.at("orientations")[2][1].get<double>(), turn, 1e-5); // rounded to five decimals
}

TEST(ReplayJsonTest, WhatIsNotFiniteOrFarFromAnyPictureIsNull) {
  for (const float nowhere :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e30f}) {
    CRunReport report = MakeSampleReport();
    auto& track = report.m_stdScenes[0].m_stdClips[0].m_stdTracks[1];
    track.insert(track.begin() + 1, Vector2(nowhere, 2.0f));
    const auto s = nlohmann::json::parse(MakeReplayJson(report)).at("scenes").at(0);
    EXPECT_EQ(UnpackTrack(s, s.at("/clips/0/tracks/1"_json_pointer)),
              nlohmann::json({1000, 2000, nullptr, 2000, 1500, 2375})); // and then it goes on
  }
}

TEST(ReplayJsonTest, SmallBallsKeepTwoDigits) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes[0].m_cScene.m_stdBalls[0].m_cDesc.m_fRadius = 0.0005f;
  const auto s = nlohmann::json::parse(MakeReplayJson(report)).at("scenes").at(0);
  EXPECT_EQ(s.at("unit"), 0.00001);
  EXPECT_EQ(UnpackTrack(s, s.at("/clips/0/tracks/4"_json_pointer)).at(2), 112346);
}

TEST(ReplayJsonTest, EnginesThatFlyAlikeShareATrackInAllClips) {
  CRunReport report = MakeSampleReport();
  auto& clips = report.m_stdScenes[0].m_stdClips;
  clips.push_back(clips.front());
  const auto tracks = [&] {
    return nlohmann::json::parse(MakeReplayJson(report)).at("/scenes/0/tracks"_json_pointer).size();
  };
  EXPECT_EQ(tracks(), 5u); // those of the second clip are alike
  clips[1].m_stdTracks[0][1].x() += 0.001f;
  EXPECT_EQ(tracks(), 6u); // the control
}

// By this the page of all scenes stays below 3 MB.
TEST(ReplayJsonTest, AFreeFlightTakesAtMostThreeBytesACoordinate) {
  CRunReport report = MakeSampleReport();
  CClip& clip = report.m_stdScenes[0].m_stdClips[0];
  constexpr std::size_t n = 1000;
  const auto size = [&](const auto& place) {
    std::vector<Vector2> track;
    for (std::size_t frame = 0; frame < n; ++frame)
      track.push_back(place(static_cast<float>(frame)));
    clip.m_stdTracks.assign(6, track);
    return nlohmann::json::parse(MakeReplayJson(report)).at("/scenes/0/tracks/0"_json_pointer).dump().size();
  };
  const std::size_t most = 3 * 2 * n;
  EXPECT_LE(size([](float i) { return Vector2(-30.0f + 0.06789f * i, 12.3456f - 0.01234f * i); }), most);
  // The control: a ball that is anywhere in each frame takes all its digits.
  EXPECT_GT(size([](float i) { return Vector2(40.0f * std::sin(i * i), 30.0f * std::cos(i * i)); }), most);
}

TEST(PageJsonTest, IsTheRunWithSixDigits) {
  CRunReport report = MakeSampleReport();
  report.m_nSeed = 1234567890123;
  report.m_stdScenes[0].m_stdEngines[0].m_cTotals["direction_error"].m_fP95 = 0.123456789;
  const auto run = nlohmann::json::parse(MakeJson(report)),
             page = nlohmann::json::parse(MakePageJson(report));
  EXPECT_EQ(page.at("seed"), 1234567890123); // no figure
  const nlohmann::json::json_pointer p95("/scenes/0/engines/0/direction_error/p95");
  EXPECT_EQ(page.at(p95), 0.123457);
  EXPECT_EQ(run.at(p95), 0.123456789);
  const auto flat = page.flatten(), whole = run.flatten();
  ASSERT_EQ(flat.size(), whole.size());
  for (const auto& [key, value] : whole.items()) {
    if (!value.is_number_float())
      EXPECT_EQ(flat.at(key), value) << key;
    else
      EXPECT_NEAR(flat.at(key).get<double>(), value.get<double>(), 0.5001e-5 * std::abs(value.get<double>()))
          << key;
  }
}

class CWriteTest : public testing::Test {
protected:
  CWriteTest()
      : m_cFolder(
            fs::path(testing::TempDir()) /
            (std::string("shapes-write-") + testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(m_cFolder);
  }
  ~CWriteTest() override { fs::remove_all(m_cFolder); }
  fs::path m_cFolder;
};

TEST_F(CWriteTest, ThreeFilesAreWritten) {
  const CRunReport report = MakeSampleReport();
  WriteReport(report, m_cFolder / "new" / "folder");
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(m_cFolder / "new" / "folder")) {
    EXPECT_GT(entry.file_size(), 500u) << entry.path();
    ++files;
  }
  EXPECT_EQ(files, 3u);
  std::ostringstream json;
  json << std::ifstream(m_cFolder / "new" / "folder" / "run.json").rdbuf();
  EXPECT_EQ(json.str(), MakeJson(report));
}

TEST_F(CWriteTest, WhatCannotBeWrittenIsKnownBefore) {
  RequireWritable(m_cFolder);
  EXPECT_TRUE(fs::is_empty(m_cFolder)); // nothing is left by the look
  std::ofstream(m_cFolder / "run.json") << "kept";
  RequireWritable(m_cFolder);
  EXPECT_EQ(fs::file_size(m_cFolder / "run.json"), 4u);

  fs::create_directory(m_cFolder / "report.html"); // a folder in the place of a file
  try {
    RequireWritable(m_cFolder);
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_TRUE(Contains(e.what(), "report.html")) << e.what();
  }
  EXPECT_THROW(RequireWritable(m_cFolder / "run.json"), std::runtime_error);
}

} // namespace
} // namespace Shapes::Compare
