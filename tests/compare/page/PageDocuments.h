// SPDX-License-Identifier: MIT
// Documents as a run would give them to the page, made up.
#pragma once

#include "SampleReport.h"

#include <nlohmann/json.hpp>

namespace Shapes::Compare {
using nlohmann::json;

struct CPageDocuments {
  json m_cRun, m_cReplay, m_cCharts;
};

/// The frame of the worst contact of the clips of full scenes, and the ball whose it is.
inline constexpr int g_nWorstContact = 14, g_nWorstBall = 1;

inline constexpr std::size_t g_nFrames = 31;

// Balls that bounce on the floor at y = -1, each engine a bit aside of the last track, that of the reference.
inline CClip MakeClip(const std::string& name, const std::string& what, std::size_t contact) {
  CClip clip;
  clip.m_sName = name;
  clip.m_sWhat = what;
  clip.m_nContact = contact;
  clip.m_nBall = g_nWorstBall;
  for (const auto& [sink, sideways] :
       {std::pair(0.02f, 0.5f), {0.08f, 1.5f}, {0.04f, 0.8f}, {-0.02f, 0.3f}, {0.0f, 0.0f}}) {
    std::vector<Vector2> track;
    for (std::size_t f = 0; f < g_nFrames; ++f)
      for (const float x0 : {-1.0f, 0.3f}) {
        const float t = static_cast<float>(f) / 60, off = t - g_nWorstContact / 60.0f,
                    after = std::max(0.0f, off);
        track.emplace_back(x0 + 2 * t + sideways * after,
                           -0.9f + 6 * std::abs(off) - (after > 0 ? sink : 0.0f));
      }
    clip.m_stdTracks.push_back(track);
  }
  return clip;
}

// The sample with all kinds of shapes, effects of two engines whose times scatter, and a clip of each engine.
inline CSceneReport MakePageScene(const std::string& name) {
  CSceneReport report = MakeSampleScene();
  report.m_cScene = Tests::MakeScene(
      10, 10,
      {CLineSegDesc({-2, -1}, {2, -1}), CLineSegDesc({2, -1}, {2, 1}), CArcDesc({0, 1}, 2, 0, g_fPi),
       CLineSegDesc({-2, 1}, {-2, -1}), CCircleDesc({1.2f, 0.6f}, 0.3f), MakeZone({-1.2f, 1.6f}, 0.3f),
       CArcDesc({0, 2}, 0.2f, 0, 0), CPointDesc({-1, 0.2f}),
       Turning(CLineSegDesc({-0.4f, 0.5f}, {0.4f, 0.5f}), 1, {0, 0.5f})},
      {CDynamicCircleDesc({-1, 0}, 0.1f), CDynamicCircleDesc({0.3f, 0}, 0.15f)}, {0, -10});
  report.m_cScene.m_sName = name;
  report.m_cScene.m_sDescription = "Made up: two balls in a box with a bar that turns, </script><b>1 < 2</b> "
                                   "& \"quotes\", and a word of many letters: " +
                                   std::string(300, 'y');
  report.m_stdEngines[Tests::g_nNative].m_nGhosts = 0;
  // So that Box2D has a direction too, and its mark and label in the overview.
  auto& engines = report.m_cImpactTrials.m_stdContacts[0].m_stdEngines;
  engines[Tests::g_nBox2D] = engines[Tests::g_nApproximate];
  engines[Tests::g_nBox2D].m_fDirectionError = 0.21f;
  report.m_cEffects = MakeSampleEffects({g_sNative, g_sBox2D});
  for (CEffectCost& cost : report.m_cEffects.m_stdCosts) {
    cost.m_cWithout.m_cCost.m_stdRepeats.assign(11, 100.0);
    if (cost.IsCalledFor()) cost.m_cWithout.m_cFlightError = {12, 20, 20, 20};
  }
  report.m_stdClips = {MakeClip("start", "", 0)};
  for (const CEngineRow& row : Tests::GetKnownRows())
    report.m_stdClips.push_back(
        MakeClip(std::string("worst ") + row.m_sName, "sent off 0.61 rad", g_nWorstContact));
  return report;
}

inline CRunReport MakeReport(const std::vector<std::string>& scenes) {
  CRunReport report = MakeSampleReport();
  report.m_nSeed = 1;
  report.m_stdScenes.clear();
  for (const std::string& name : scenes)
    report.m_stdScenes.push_back(MakePageScene(name));
  return report;
}

inline CPageDocuments ToDocuments(const CRunReport& report) {
  CPageDocuments documents{json::parse(MakePageJson(report)), json::parse(MakeReplayJson(report)),
                           json::parse(MakeChartsJson(report))};
  documents.m_cRun["machine"] = {{"shapes", "0.1.0 (1234567)"},
                                 {"box2d", "2.4.1"},
                                 {"compiler", "g++ 12.2.0, Release"},
                                 {"cpu", "Some CPU"},
                                 {"cores", 8}};
  // In words of its own: that of one scene alone says the same as its verdict.
  if (!report.m_stdScenes.empty())
    documents.m_cRun["overall"]["result"] =
        "Take native: 7.1 times as fast as Box2D. It loses 12 of 1,000 impacts (Box2D 6), and "
        "95% of its bounces are within 0.001 degrees of the exact direction (Box2D 12 degrees); "
        "native-approximate is faster but loses 1 in 4.9.";
  return documents;
}

/// One full scene for each name.
inline CPageDocuments MakePageDocuments(const std::vector<std::string>& scenes) {
  return ToDocuments(MakeReport(scenes));
}

/// Runs leave out, scene by scene, whatever they may: no contacts, one engine, nulls for all that may be
/// null, no clips.
inline CPageDocuments MakeSparsePageDocuments() {
  CRunReport made = MakeReport({"full", "no_contacts", "one_engine", "nulls", "no_clips"});
  made.m_bInterrupted = true;
  CSceneReport &none = made.m_stdScenes[1], undecided = MakeUndecidedScene();
  none.m_cImpactTrials = undecided.m_cImpactTrials;
  none.m_cDifference = {};
  none.m_stdEngines = undecided.m_stdEngines;
  none.m_cWork = {};
  none.m_cHeatMap = {};
  CPageDocuments report = ToDocuments(made);
  const auto dropRows = [&](const char* pTable, const char* pScene) {
    json& rows = report.m_cRun[pTable];
    rows.erase(
        std::remove_if(rows.begin(), rows.end(), [&](const json& row) { return row["scene"] == pScene; }),
        rows.end());
  };

  json& single = report.m_cRun["scenes"][2];
  single["engines"] = json::array({single["engines"][0]}); // one in braces alone is a copy for some compilers
  single["apart"] = nullptr;
  single["heat_map"] = nullptr;

  json& nulls = report.m_cRun["scenes"][3];
  for (const char* pKey : {"description", "gravity", "features", "verdict", "remarks", "answers", "take",
                           "set_aside", "heat_map", "apart"})
    nulls[pKey] = nullptr;
  for (json& engine : nulls["engines"])
    for (auto& [key, value] : engine.items())
      if (key != "name") value = nullptr;
  dropRows("work_precision", "nulls");

  dropRows("effects", "one_engine");
  for (json& row : report.m_cRun["effects"])
    if (row["scene"] == "nulls") {
      row["with"]["instructions_per_ball_step"] = row["without"]["instructions_per_ball_step"] = nullptr;
      row["runs"] = row["why"] = row["ns_ratio"] = row["ns_ratio_interval"] = nullptr;
      row["with"]["direction_error"] = {
          {"count", 0}, {"median", nullptr}, {"p95", nullptr}, {"max", nullptr}};
    }
  nulls["not_counted"] = "valgrind is not there";

  // A ball that left the numbers, and a scene that was not recorded at all.
  json& nulled = report.m_cReplay["scenes"][3];
  for (std::size_t i = 80; i < 90; ++i)
    nulled["tracks"][0][i] = nullptr;
  nulled["clips"][0]["orientations"] = json::array();
  report.m_cReplay["scenes"][2]["clips"] = json::array();
  report.m_cReplay["scenes"].erase(4);
  report.m_cRun["scenes"][4]["features"] = {"gravity"};
  return report;
}

} // namespace Shapes::Compare
