// SPDX-License-Identifier: MIT
// The recording of a replay; and the files of a report whose figures are known: contacts.csv, what is in
// report.html, and that they are written. What the page does in a browser is tested in ReportPageTest.cpp.
#include "CommandCalls.h"
#include "SampleReport.h"
#include "report/Replay.h"

#include <nlohmann/json.hpp>

#include <sys/stat.h>

namespace Shapes::Compare::Tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Of a line in which no field is in quotes.
static std::vector<std::string> Split(const std::string& line) {
  std::istringstream in(line + ',');
  std::vector<std::string> fields;
  for (std::string field; std::getline(in, field, ',');)
    fields.push_back(field);
  return fields;
}

TEST(CsvTest, HasAColumnForEveryFieldAndLeavesEmptyWhatWasNotMeasured) {
  std::string names = "scene,trial,step,ball,pair,time_in_step,travel_radii,approach_speed_units_per_s,"
                      "incidence_rad,elasticity,apart_radii";
  for (const CEngineRow& row : Tests::GetKnownRows()) {
    const std::string engine = std::string(",") + row.m_sName + '_';
    names += engine + "outcome";
    for (const CFigure& figure : GetImpactFigures())
      names += engine + figure.m_sKey + '_' +
               (figure.m_sUnit == std::string("units/s") ? "units_per_s" : figure.m_sUnit);
  }
  const std::vector<std::string> lines = Lines(MakeCsv(MakeSampleReport()));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], names);
  EXPECT_TRUE(lines[1].starts_with("spinner,3,14,0,segment end,0.25,1.5,8,0.125,0.5,0.0625,late,"))
      << lines[1];

  const std::vector<std::string> columns = Split(lines[0]), fields = Split(lines[1]);
  ASSERT_EQ(columns.size(), fields.size());
  std::map<std::string, std::string> row;
  for (std::size_t i = 0; i < columns.size(); ++i)
    EXPECT_TRUE(row.emplace(columns[i], fields[i]).second) << columns[i];
  const std::map<std::string, std::string> measured = {{"setback_radii", "0.5"},
                                                       {"setback_error_radii", "0.03125"},
                                                       {"poi_error_radii", "0.0078125"},
                                                       {"setback_error_normal_radii", "-0.015625"},
                                                       {"time_error_steps", "-0.0019531"},
                                                       {"normal_error_rad", "0.0039062"},
                                                       {"speed_error_relative", "-0.0625"},
                                                       {"energy_error_relative", "4"},
                                                       {"position_error_radii", "5"},
                                                       {"penetration_radii", "6"}};
  for (const auto& [name, value] : measured)
    for (const char* pEngine : {"native_", "native-approximate_", "box2d-tuned_"})
      EXPECT_EQ(row[pEngine + name], value) << pEngine << name;
  for (const char* pEngine : {"native_", "box2d-tuned_"}) {
    EXPECT_EQ(row[std::string(pEngine) + "outcome"], "late");
    EXPECT_EQ(row[std::string(pEngine) + "direction_error_rad"], "0");
  }
  EXPECT_EQ(row["native-approximate_direction_error_rad"], "2");
  EXPECT_EQ(row["native-approximate_outcome"], "correct");
  EXPECT_EQ(row["box2d_outcome"], "missed");
  EXPECT_EQ(row["box2d_direction_error_rad"], "");
  for (const auto& [name, value] : measured)
    EXPECT_EQ(row["box2d_" + name], name == "penetration_radii" ? "7" : "") << name;
}

TEST(CsvTest, QuotesNames) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes[0].m_cScene.m_sName = "a, \"b\"";
  EXPECT_TRUE(Lines(MakeCsv(report)).at(1).starts_with("\"a, \"\"b\"\"\",3,14"));
}

// In units of the scene. Tracks are written as second differences, and 0 is before them.
json UnpackTrack(const json& scene, const json& place) {
  const std::size_t n = 2 * scene.at("radii").size();
  std::vector<std::int64_t> last(n), step(n);
  json track = json::array();
  std::size_t i = 0;
  for (const json& turn : scene.at("tracks").at(place.get<std::size_t>())) {
    const std::size_t k = i++ % n;
    if (!turn.is_null()) last[k] += step[k] += turn.get<std::int64_t>();
    track.push_back(turn.is_null() ? turn : json(last[k]));
  }
  return track;
}

TEST(ReplayJsonTest, HoldsShapesAndTracks) {
  CRunReport report = MakeSampleReport();
  CScene& scene = report.m_stdScenes[0].m_cScene;
  AddShape(scene, Sensor(CArcDesc({1, 2}, 3, 5, 1)));
  AddShape(scene, CCircleDesc({-1, 0}, 0.5f));
  AddShape(scene, CArcDesc({0, 0}, 1, 0, 0));
  const auto doc = json::parse(MakeReplayJson(report));
  EXPECT_EQ(doc.at("engines"), json({"native", "native-approximate", "box2d", "box2d-tuned", "exact"}));
  const auto& s = doc.at("scenes").at(0);
  EXPECT_EQ(s.at("name"), "spinner");
  EXPECT_EQ(s.at("bounds"), json({{"left", -45}, {"bottom", -45}, {"right", 45}, {"top", 45}}));
  ASSERT_EQ(s.at("radii").size(), 1u);
  EXPECT_FLOAT_EQ(s.at("radii")[0].get<float>(), 0.1f);

  // The arc goes from 5 counterclockwise to 1 + 2 pi.
  EXPECT_EQ(s.at("shapes"), json::parse(R"([
    {"type": "segment", "points": [[-1, 0], [1, 0]], "sensor": false, "turns": true, "center": [0, 0]},
    {"type": "point", "points": [[-1, 0]], "sensor": false, "turns": true, "center": [0, 0]},
    {"type": "point", "points": [[1, 0]], "sensor": false, "turns": true, "center": [0, 0]},
    {"type": "arc", "points": [[1, 2]], "radius": 3, "angles": [5, 7.28319], "sensor": true, "turns": false},
    {"type": "circle", "points": [[-1, 0]], "radius": 0.5, "sensor": false, "turns": false},
    {"type": "arc", "points": [[0, 0]], "radius": 1, "angles": [0, 6.28319], "sensor": false, "turns": false}])"));

  const auto& clip = s.at("clips").at(0);
  EXPECT_EQ(clip.at("title"), "Worst contact of native");
  EXPECT_EQ(clip.at("frames"), 2);
  EXPECT_EQ(clip.at("contact"), 1);
  EXPECT_EQ(clip.at("ball"), 0);
  // 90 units wide, five digits: three decimals.
  EXPECT_EQ(s.at("unit"), 0.001);
  EXPECT_EQ(UnpackTrack(s, clip.at("tracks").at(4)), json({1000, 2000, 1123, 3000}));
  // The three shapes of the compound turn, twice a second.
  ASSERT_EQ(clip.at("orientations").size(), 3u);
  const double turn = 2 * 2 * 3.14159265358979 / 60;
  EXPECT_EQ(clip.at("orientations")[0][0], 0);
  EXPECT_NEAR(clip.at("orientations")[2][1].get<double>(), turn, 1e-5); // rounded to five decimals
}

TEST(ReplayJsonTest, WhatIsNotFiniteOrFarFromAnyPictureIsNull) {
  for (const float nowhere : {g_fNan, g_fInf, -1e30f}) {
    CRunReport report = MakeSampleReport();
    auto& track = report.m_stdScenes[0].m_stdClips[0].m_stdTracks[1];
    track.insert(track.begin() + 1, Vector2(nowhere, 2.0f));
    const auto s = json::parse(MakeReplayJson(report)).at("scenes").at(0);
    EXPECT_EQ(UnpackTrack(s, s.at("/clips/0/tracks/1"_json_pointer)),
              json({1000, 2000, nullptr, 2000, 1500, 2375})); // and then it goes on
  }
}

TEST(ReplayJsonTest, SmallBallsKeepTwoDigitsAndWhoFliesAlikeSharesATrackInAllClips) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes[0].m_cScene.m_stdBalls[0].m_cDesc.m_fRadius = 0.0005f;
  auto& clips = report.m_stdScenes[0].m_stdClips;
  clips.push_back(clips.front());
  const json s = json::parse(MakeReplayJson(report)).at("scenes").at(0);
  EXPECT_EQ(s.at("unit"), 0.00001);
  EXPECT_EQ(UnpackTrack(s, s.at("/clips/0/tracks/4"_json_pointer)).at(2), 112346);
  EXPECT_EQ(s.at("tracks").size(), 5u); // those of the second clip are alike
  clips[1].m_stdTracks[0][1].x() += 0.001f;
  EXPECT_EQ(json::parse(MakeReplayJson(report)).at("/scenes/0/tracks"_json_pointer).size(),
            6u); // the control
}

TEST(PageJsonTest, IsTheRunWithSixDigits) {
  CRunReport report = MakeSampleReport();
  report.m_nSeed = 12345678901234567890u;
  report.m_stdScenes[0].m_stdEngines[0].m_cTotals["direction_error"].m_fP95 = 0.123456789;
  const auto run = json::parse(MakeJson(report));
  auto page = json::parse(MakePageJson(report));
  EXPECT_EQ(page.at("seed"), "12345678901234567890"); // too large for a number of JavaScript
  page["seed"] = run.at("seed");
  const json::json_pointer p95("/scenes/0/engines/0/direction_error/p95");
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

using CWriteTest = CFolderTest;

TEST_F(CWriteTest, WhatCannotBeWrittenIsKnownBefore) {
  RequireWritable(m_cFolder / "new" / "folder");
  EXPECT_TRUE(fs::is_empty(m_cFolder / "new" / "folder")); // nothing is left by the look
  Write("run.json", "kept");
  RequireWritable(m_cFolder);
  EXPECT_EQ(Read("run.json"), "kept");

  fs::create_directory(m_cFolder / "report.html"); // a folder in the place of a file
  EXPECT_TRUE(Says(MessageOf<std::runtime_error>([&] { RequireWritable(m_cFolder); }), "report.html"));
  EXPECT_THROW(RequireWritable(m_cFolder / "run.json"), std::runtime_error);
}

// A pipe would be waited for.
TEST_F(CWriteTest, AChartTakesNoOtherFilesPlace) {
  CScene scene = LoadBundled("bowl");
  scene.m_cPath = Write("mine.json", "scene");
  const auto refusal = [&](const fs::path& file) {
    return MessageOf<std::runtime_error>([&] { RequireChart(m_cFolder / file, m_cFolder, {scene}); });
  };
  fs::create_symlink("mine.json", m_cFolder / "link.svg");
  fs::create_symlink("run.json", m_cFolder / "to_run.svg"); // leads to nothing yet
  ASSERT_EQ(mkfifo((m_cFolder / "pipe").c_str(), 0600), 0);
  for (const auto& [pFile, pReason] : {std::pair("mine.json", "mine.json: is a scene of this run"),
                                       {"link.svg", "link.svg: is a scene of this run"},
                                       {"run.json", "run.json: is a file of the report"},
                                       {"to_run.svg", "to_run.svg: is a file of the report"},
                                       {"pipe", "pipe: cannot be written (expected a regular file"},
                                       {".", "cannot be written (expected a regular file"},
                                       {"no/chart.svg", "chart.svg: cannot be written (No such file"}})
    EXPECT_TRUE(Says(refusal(pFile), pReason)) << pFile;
  RequireChart(m_cFolder / "chart.svg", m_cFolder, {scene});
  EXPECT_FALSE(fs::exists(m_cFolder / "chart.svg")); // nothing is left by the look
  EXPECT_EQ(Read("mine.json"), "scene");
}

TEST_F(CWriteTest, LinksStayAndWhatTheyLeadToIsWritten) {
  fs::create_directory(m_cFolder / "far");
  fs::create_symlink("far/chart.svg", m_cFolder / "link.svg"); // leads to nothing yet
  for (int i = 0; i < 2; ++i) {
    RequireChart(m_cFolder / "link.svg", m_cFolder, {});
    WriteChart(MakeSampleReport(), m_cFolder / "link.svg");
    EXPECT_TRUE(fs::is_symlink(m_cFolder / "link.svg"));
    EXPECT_TRUE(Read("far/chart.svg").starts_with("<svg "));
  }
}

// The name of one part is taken by a folder that is not empty.
TEST_F(CWriteTest, WhereOneFileCannotBeWrittenAllStayAsTheyAre) {
  for (const char* pName : {"report.html", "run.json", "contacts.csv"})
    Write(pName, "old");
  fs::create_directories(m_cFolder / "contacts.csv.part" / "full");
  EXPECT_TRUE(Says(MessageOf<std::runtime_error>([&] { WriteReport(MakeSampleReport(), m_cFolder); }),
                   "contacts.csv: cannot be written"));
  for (const char* pName : {"report.html", "run.json", "contacts.csv"})
    EXPECT_EQ(Read(pName), "old");
  EXPECT_FALSE(fs::exists(m_cFolder / "report.html.part") || fs::exists(m_cFolder / "run.json.part"));
}

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++n;
  return n;
}

TEST(HtmlTest, HoldsTheDocumentsWhateverIsInThem) {
  const std::string run = R"({"a": "</script><script>alert(1)</script><!-- {{replay}} & \" \\ ü"})";
  const std::string replay = R"({"b": [1, 2, "<b>"]})";
  const std::string charts = R"({"overall": ["<svg></svg>"]})";
  const std::string page = MakeHtml(run, replay, charts);
  for (const auto& [pId, text] : {std::pair("run", run), {"replay", replay}, {"charts", charts}}) {
    const std::string open = std::string("<script type=\"application/json\" id=\"") + pId + "\">";
    const std::size_t begin = page.find(open) + open.size();
    EXPECT_EQ(json::parse(page.substr(begin, page.find("</script>", begin) - begin)), json::parse(text));
  }
}

TEST(HtmlTest, EveryPartAndColourIsThereAndEndsWhereItShould) {
  const std::string page = MakeHtml("{}", "{}", "{}");
  EXPECT_EQ(Count(page, "{{"), 0u);
  EXPECT_EQ(Count(page, "<script"), Count(page, "</script>"));
  EXPECT_EQ(Count(page, "<style>"), 1u);
  EXPECT_EQ(Count(page, "</style>"), 1u);
  EXPECT_TRUE(Says(page, "Chart.js v3"));
  EXPECT_TRUE(Says(page, "default-src 'none'"));
  for (const char* pOutside : {"src=\"", "url(", "@import", "<link rel=\"stylesheet\""})
    EXPECT_EQ(Count(page, pOutside), 0u) << pOutside;
  // The colours of the table of engines, on white and on black.
  for (const CEngineRow& row : GetEngineRows())
    for (const std::string& colour : {row.m_sColour, row.m_sDark})
      EXPECT_EQ(Count(page, "--" + row.m_sName + ": " + colour + ";"), 1u) << row.m_sName;
}

struct CReplay {
  CScene m_cScene;
  CImpactTrialResult m_cImpactTrials;
  std::vector<CClip> m_stdClips;
};

CReplay Make(const std::string& name) {
  CReplay replay;
  replay.m_cScene = LoadBundled(name);
  replay.m_cImpactTrials = Judge(replay.m_cScene, 200, 4000);
  replay.m_stdClips = MakeClips(replay.m_cScene, GetEngines(), replay.m_cImpactTrials, 5, 120);
  return replay;
}

Vector2 At(const CClip& clip, std::size_t track, std::size_t frame, std::size_t balls) {
  return clip.m_stdTracks[track][frame * balls + clip.m_nBall];
}

TEST(Replay, AllTracksStartTogetherAndHaveTheSameLength) {
  for (const char* name : {"pinball", "ball_on_ball", "spinner"}) {
    SCOPED_TRACE(name);
    const CReplay replay = Make(name);
    const std::size_t balls = replay.m_cScene.m_stdBalls.size();
    ASSERT_EQ(replay.m_stdClips.size(), 1 + GetEngineRows().size());
    EXPECT_EQ(replay.m_stdClips[0].m_sName, "start");
    for (std::size_t e = 0; e < GetEngineRows().size(); ++e)
      EXPECT_EQ(replay.m_stdClips[e + 1].m_sName, std::string("worst ") + GetEngineRows()[e].m_sName);
    for (const CClip& clip : replay.m_stdClips) {
      ASSERT_EQ(clip.m_stdTracks.size(), GetEngineRows().size() + 1);
      for (const auto& track : clip.m_stdTracks) {
        EXPECT_EQ(track.size(), clip.m_stdTracks[0].size());
        EXPECT_TRUE(std::equal(track.begin(), track.begin() + static_cast<std::ptrdiff_t>(balls),
                               clip.m_stdTracks[0].begin()));
      }
      EXPECT_LT(clip.m_nContact, clip.GetFrames(balls));
    }
  }
}

TEST(Replay, TheWorstContactOfNativeAtAWallIsWhereItTunnels) {
  const CReplay replay = Make("head_on_wall");
  const CClip& clip = replay.m_stdClips.at(1 + g_nApproximate);
  const std::size_t exact = clip.m_stdTracks.size() - 1;
  EXPECT_TRUE(Says(clip.m_sWhat, "native-approximate"));
  ASSERT_GT(clip.m_nContact, 0u);
  // Up to the frame before, all fly alike; at the contact the exact ball has turned back, and some steps
  // later native's is on the other side of the wall, which is at x = 0.
  const std::size_t k = clip.m_nContact, late = clip.GetFrames(1) - 1;
  EXPECT_LT((At(clip, g_nApproximate, k - 1, 1) - At(clip, exact, k - 1, 1)).norm(), 1e-5f);
  EXPECT_GT(At(clip, exact, k - 1, 1).x(), At(clip, exact, late, 1).x()); // turned back
  EXPECT_LT(At(clip, exact, late, 1).x(), 0.0f);
  EXPECT_GT(At(clip, g_nApproximate, late, 1).x(), 0.0f);
}

} // namespace
} // namespace Shapes::Compare::Tests
