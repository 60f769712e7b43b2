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

// Repeats of which the median is `ns`, and the ends of its interval these shares of it.
inline void SetTimes(CCost& cost, double ns, double low = 0.97, double high = 1.04) {
  cost.m_stdRepeats = {low * ns, low * ns, ns, ns, ns, ns, ns, ns, ns, high * ns, high * ns};
  cost.m_cNsPerBallStep = MedianWithInterval(cost.m_stdRepeats);
}

// Figures that differ from engine to engine; what they are does not matter.
inline CEngineReport MakeEngine(std::size_t e, std::size_t lost, double ns, double degrees) {
  CEngineReport engine = MakeSampleEngine(lost, ns, degrees * std::numbers::pi / 180.0);
  engine.m_cTotals.m_nContacts = 30000;
  engine.m_nGhosts = e < 2 ? 0 : 3;
  engine.m_cLongRun = {100000, 800.0, e < 2 ? -0.0012 : 6.5, 0.002, {}};
  SetTimes(engine.m_cCost, ns);
  engine.m_stdBins.clear();
  const char* const bins[][2] = {{"travel", "< 0.5 r"},        {"travel", "0.5 - 1 r"},
                                 {"travel", "1 - 2 r"},        {"incidence", "0 - 30 deg"},
                                 {"incidence", "30 - 60 deg"}, {"pair", "segment"},
                                 {"pair", "segment end"},      {"elasticity", "< 1"}};
  for (const auto& [pBy, pLabel] : bins)
    engine.m_stdBins.push_back({pBy, pLabel, engine.m_cTotals});
  for (std::size_t i = 0; i < g_nHistogramBins; ++i) {
    const auto bell = [&](double middle) {
      return static_cast<std::size_t>(9000 * std::exp(-0.04 * std::pow(static_cast<double>(i) - middle, 2)));
    };
    engine.m_cHistogram.m_stdSetbackError[i] = bell(22.0 - 4.0 * static_cast<double>(e));
    engine.m_cHistogram.m_stdPenetration[i] = bell(5.0 + 4.0 * static_cast<double>(e));
  }
  return engine;
}

// Settings of each engine with 1, 2, 4 and 8 substeps, and the reference.
inline CWorkPrecision MakeWork() {
  CWorkPrecision work;
  for (std::size_t e = 0; e < GetEngineRows().size(); ++e)
    for (const unsigned substeps : {1u, 2u, 4u, 8u}) {
      const double n = substeps, column = static_cast<double>(e),
                   ns = 3000 * (1 + 7 * column) * (0.3 + 0.7 * n);
      CEngine engine = GetEngines()[e];
      engine.m_nSubsteps = substeps;
      const std::size_t lost = substeps == 8 ? 0 : static_cast<std::size_t>(1000 / n / (1 + column));
      CSetting setting = MakeSetting(engine, ns, 0.4 / n / std::pow(5, column), 5000, lost);
      setting.m_cNsPerBallSecond.m_cInterval = {0.96 * ns, 1.05 * ns};
      setting.m_nMissed = lost / 2;
      if (substeps == 8) setting.m_nConfirmationContacts = 95000;
      setting.m_bFrontByError = setting.m_bFrontByMisses = e < 2;
      work.m_stdSettings.push_back(setting);
    }
  work.m_stdSettings.push_back(MakeSetting({g_sExact, nullptr}, 200000, 0.0, 5000, 0));
  work.m_stdSettings.back().m_cNsPerBallSecond.m_cInterval = {190000, 210000};
  work.m_stdRecommendations = {
      {"Bounces within 0.6 degrees (.01 rad), fewer than 1 in 100 lost", {3, 11}, {"native-approximate"}, {}},
      {"Bounces within 0.06 degrees (.001 rad), fewer than 1 in 1,000 lost", {}, {"native", "box2d"}, 11},
      {"None lost in 100,000 impacts", {3, 11, 15}, {"native-approximate"}, {}}};
  return work;
}

// Of two engines, each with all effects: one of each kind.
inline CEffectCosts MakeEffects() {
  const auto world = [](double ns, double instructions, std::size_t lost, double flight) {
    CEffectWorld made;
    SetTimes(made.m_cCost, ns, (ns - 2) / ns, (ns + 3) / ns);
    made.m_fInstructions = instructions;
    made.m_cTotals.m_nContacts = 500;
    made.m_cTotals.m_nMissed = lost;
    made.m_cTotals["direction_error"] = made.m_cTotals["speed_error"] = {480, 0.01, 0.02, 0.03};
    made.m_cFlightError = {100, flight, flight, flight};
    return made;
  };
  CEffectCosts costs;
  for (const char* pEngine : {g_sNative, g_sBox2D})
    for (const auto& [effect, runs, ratio] : {std::tuple(eEffect::Gravity, 1.0, 1.15),
                                              {eEffect::Kinematics, 0.35, 5.5},
                                              {eEffect::BallPairs, 0.0, 1.4},
                                              {eEffect::Sensors, 0.0, 1.01},
                                              {eEffect::Events, 1.0, 0.9},
                                              {eEffect::Continuous, 1.0, 1.3}}) {
      CEffectWorld without = world(100, 800, effect == eEffect::Continuous ? 250 : 0, runs > 0 ? 20 : 0.01);
      without.m_cCost.m_stdRepeats.assign(11, 100.0);
      costs.m_stdCosts.push_back({pEngine, effect, runs, "it moves 2 radii a substep, </script><b>1 < 2</b>",
                                  world(100 * ratio, 800 * ratio, 0, 0.01), without});
    }
  return costs;
}

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

inline CSceneReport MakeScene(const std::string& name) {
  CSceneReport report = MakeSampleScene();
  report.m_cScene = ParseScene("made.json", R"({"name": "made", "duration": 10, "gravity": [0, -10],
    "bounds": {"left": -10, "bottom": -10, "right": 10, "top": 10},
    "shapes": [{"type": "line_segment", "p0": [-2, -1], "p1": [2, -1]}, {"type": "line_segment", "p0": [2, -1], "p1": [2, 1]},
               {"type": "arc", "position": [0, 1], "radius": 2, "angles": [0, 3.14159]},
               {"type": "line_segment", "p0": [-2, 1], "p1": [-2, -1]},
               {"type": "circle", "position": [1.2, 0.6], "radius": 0.3},
               {"type": "circle", "position": [-1.2, 1.6], "radius": 0.3, "sensor": true},
               {"type": "arc", "position": [0, 2], "radius": 0.2}, {"type": "point", "position": [-1, 0.2]},
               {"type": "line_segment", "p0": [-0.4, 0.5], "p1": [0.4, 0.5], "motion": "kinematic",
                "rotation_speed": 1, "rotation_center": [0, 0.5]}],
    "balls": [{"position": [-1, 0], "radius": 0.1}, {"position": [0.3, 0], "radius": 0.15}]})");
  report.m_cScene.m_sName = name;
  report.m_cScene.m_sDescription =
      "Made up: two balls in a box with a bar that turns, </script><b>1 < 2</b> & \"quotes\".";
  CImpactTrialResult& trials = report.m_cImpactTrials;
  trials.m_nQuietSteps = 54321;
  for (CEngineContact& contact : trials.m_stdContacts[0].m_stdEngines) {
    contact = trials.m_stdContacts[0].m_stdEngines[Tests::g_nApproximate]; // a correct one
    contact.m_fDirectionError = 0.0f;
  }
  trials.m_stdContacts[0].m_stdEngines[Tests::g_nBox2D].m_fDirectionError = 0.21f; // 12 degrees
  report.m_stdEngines = {MakeEngine(0, 7, 70, 0.02), MakeEngine(1, 3000, 50, 1.55),
                         MakeEngine(2, 50, 500, 12), MakeEngine(3, 7, 800, 0.05)};
  report.m_cWork = MakeWork();
  CHeatMap& map = report.m_cHeatMap;
  map = {{0.25, 0.5, 1, 2, 4, 8}, {0.25, 0.5, 1, 2}, 1.25, {}};
  for (const double size : map.m_stdSizes)
    for (const double speed : map.m_stdSpeeds) {
      const std::size_t n = size == 2 && speed == 0.25 ? 0 : 2000, i = map.m_stdCells.size();
      const double through = std::max(0.0, 1 - size / (map.m_fTravel * speed));
      map.m_stdCells.push_back(
          {n, {0, static_cast<std::size_t>(static_cast<double>(n) * through), 0, i * n / 23}});
    }
  report.m_cEffects = MakeEffects();
  report.m_stdClips = {MakeClip("start", "", 0)};
  for (const CEngineRow& row : GetEngineRows())
    report.m_stdClips.push_back(
        MakeClip(std::string("worst ") + row.m_sName, "sent off 0.61 rad", g_nWorstContact));
  return report;
}

inline const json g_cNoSummary = {{"count", 0}, {"median", nullptr}, {"p95", nullptr}, {"max", nullptr}};

inline CRunReport MakeReport(const std::vector<std::string>& scenes) {
  CRunReport report = MakeSampleReport();
  report.m_nSeed = 1;
  report.m_stdScenes.clear();
  for (const std::string& name : scenes)
    report.m_stdScenes.push_back(MakeScene(name));
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
        "Take native: 7.1 times as fast as Box2D. It loses 7 of 30,000 impacts (Box2D 50), and "
        "95% of its bounces are within 0.001 degrees of the exact direction (Box2D 12 degrees); "
        "native-approximate is faster but loses 1 in 10.";
  return documents;
}

/// One full scene of two engines for each name: work precision, heat map, bins, clips.
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
      row["with"]["direction_error"] = g_cNoSummary;
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
