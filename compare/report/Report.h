// SPDX-License-Identifier: MIT
// The results of a run, and their forms of output.
#pragma once

#include "Replay.h"
#include "metrics/Cost.h"
#include "metrics/Effects.h"
#include "metrics/HeatMap.h"
#include "metrics/ImpactTrials.h"
#include "metrics/Lasting.h"
#include "metrics/LongRun.h"
#include "metrics/Totals.h"
#include "metrics/WorkPrecision.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace Shapes::Compare {

/// One engine on one scene.
struct CEngineReport {
  CTotals m_cTotals;
  std::size_t m_nGhosts = 0;
  std::vector<CBin> m_stdBins;
  CHistogram m_cHistogram;
  CCost m_cCost;
  CLongRun m_cLongRun;
  CLasting m_cLasting;
};

struct COverall; // of metrics/Overall.h

struct CSceneReport {
  CScene m_cScene;
  CImpactTrialResult m_cImpactTrials;
  CSummary m_cDifference; ///< between the first engine and FindOther
  std::vector<CEngineReport> m_stdEngines;
  CWorkPrecision m_cWork;
  CHeatMap m_cHeatMap;
  CEffectCosts m_cEffects;
  std::vector<CClip> m_stdClips;
};

struct CRunReport {
  std::string m_sCommand; ///< what reproduces it
  std::uint64_t m_nSeed = 1;
  std::size_t m_nContacts = 0; ///< asked for in each scene
  bool m_bInterrupted = false; ///< only the scenes that were finished are here
  std::vector<CEngine> m_stdEngines;
  std::vector<CSceneReport> m_stdScenes;
};

/// The first lines of a run on a terminal: the machine, and the heads of the columns of MakeSceneLine. All
/// text for terminals is ASCII, at most 80 columns wide. @param report  its engines and seed are read
std::string MakeHeading(const CRunReport& report);
/// One line of a scene that is finished: the engine to take, what it loses, its error and its time.
/// @param report  its engines are read
std::string MakeSceneLine(const CRunReport& report, const CSceneReport& scene);
/// The result over all scenes, a line for each engine, after the last scene.
std::string MakeSummary(const CRunReport& report);

/// Everything else as tables for a terminal, ASCII, at most 80 columns; MakeEffectTable is part of it.
std::string MakeTable(const CRunReport& report);

/// The cost of each effect in each scene, and the changes of the result where it is forced or forbidden.
/// Empty if none was measured.
std::string MakeEffectTable(const CRunReport& report);

/// Sentences about significant changes for the balls of a scene where an effect is forced or forbidden.
std::vector<std::string> MakeEffectChanges(const CSceneReport& scene);

/// The first things to know of one scene: which engine to take, and what it does; a sentence each,
/// one alone where nothing was judged.
std::vector<std::string> MakeVerdict(const CRunReport& report, const CSceneReport& scene);
/// All else that is wrong with an engine in a scene, a sentence each.
std::vector<std::string> MakeRemarks(const CRunReport& report, const CSceneReport& scene);
/// The same over all scenes: the engine to take and how fast it is, then what it does.
std::string MakeResult(const CRunReport& report, const COverall& overall);

/// Of run.json: it grows when a field changes its meaning or goes away.
inline constexpr int g_nRunVersion = 5;

/// run.json, as compare/run.schema.json describes it.
std::string MakeJson(const CRunReport& report);
/// The same for the page: in one line, figures with six digits, the seed as text.
std::string MakePageJson(const CRunReport& report);

/// The shapes and trajectories of all scenes, for the replay in the report: `engines` (names, the last is
/// "exact") and `scenes`, each with name, time_step, bounds, radii of the balls, shapes, clips, unit and
/// tracks. Points of a shape are its place, its two ends or its centre at angle 0; it has a center if it
/// turns. A clip has for each engine the index of a track, which engines that fly alike share, a list of
/// angles for each turning shape, and the frame of the worst contact, or 0. A track holds x and y of each
/// ball, frame by frame, as second differences in units, with 0 before the first frame; where a ball has no
/// place they are null, and it goes on from its last one.
std::string MakeReplayJson(const CRunReport& report);

/// contacts.csv: a row for each impact.
std::string MakeCsv(const CRunReport& report);

/// The charts of the page: {"overall": [wide, narrow], "scenes": {NAME: SVG}}.
std::string MakeChartsJson(const CRunReport& report);

/// report.html, which needs nothing but itself, from the three JSON texts.
std::string MakeHtml(const std::string& run, const std::string& replay, const std::string& charts);

/// Writes report.html, run.json and contacts.csv into a folder, which is made if it is not there; none of
/// those that are there is replaced before all are written whole.
/// @throws std::runtime_error naming the file that cannot be written
void WriteReport(const CRunReport& report, const std::filesystem::path& folder);

/// The chart over all scenes as SVG. @throws std::runtime_error naming the file that cannot be written
void WriteChart(const CRunReport& report, const std::filesystem::path& file);

/// Whether the folder can be written to, before any work is done; makes it.
/// @throws std::runtime_error naming the folder and the reason
void RequireWritable(const std::filesystem::path& folder);

/// The same for a chart beside a report in the folder: neither one of its files nor one of the scenes.
/// @throws std::runtime_error naming the file and the reason
void RequireChart(const std::filesystem::path& file, const std::filesystem::path& folder,
                  const std::vector<CScene>& scenes);

} // namespace Shapes::Compare
