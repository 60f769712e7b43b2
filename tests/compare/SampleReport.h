// SPDX-License-Identifier: MIT
// A report that no run has made: every figure in it is known.
#pragma once

#include "MadeScenes.h"
#include "report/Report.h"

namespace Shapes::Compare {

using Tests::LoadBundled;

inline std::vector<std::string> Lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

inline CContact MakeSampleContact() {
  const CEngineContact right{.m_eOutcome = eOutcome::Correct,
                             .m_bDetected = true,
                             .m_fSetback = 0.5f,
                             .m_fSetbackError = 0.03125f,
                             .m_fSetbackErrorNormal = -0.015625f,
                             .m_fTimeError = -0.001953125f,
                             .m_fPOIError = 0.0078125f,
                             .m_fNormalError = 0.00390625f,
                             .m_bCompared = true,
                             .m_fDirectionError = 2.0f,
                             .m_fSpeedError = -0.0625f,
                             .m_fEnergyError = 4.0f,
                             .m_fPositionError = 5.0f,
                             .m_fPenetration = 6.0f};
  CEngineContact missed;
  missed.m_fPenetration = 7.0f;
  CEngineContact late = right;
  late.m_eOutcome = eOutcome::Late;
  late.m_fDirectionError = 0.0f;
  // In the order of the columns of contacts.csv.
  return {3,    14,   0,       ePair::SegmentEnd,          0.25f, 1.5f, 8.0f, 0.125f,
          0.5f, true, 0.0625f, {late, right, missed, late}};
}

/// Times of 11 repeats that scatter about `ns` by up to a twentieth; other engines scatter otherwise.
inline void SetSampleTimes(CCost& cost, double ns, std::size_t shift) {
  cost.m_stdRepeats.clear();
  for (std::size_t i = 0; i < 11; ++i)
    cost.m_stdRepeats.push_back(ns * (0.95 + 0.01 * static_cast<double>((i * shift) % 11)));
  cost.m_cNsPerBallStep = MedianWithInterval(cost.m_stdRepeats);
}

/// One engine that lost `tunneled` of 1000 balls.
inline CEngineReport MakeSampleEngine(std::size_t tunneled, double ns, double direction) {
  CEngineReport report;
  CTotals& t = report.m_cTotals;
  t.m_nContacts = 1000;
  t.m_nMissed = tunneled / 2;
  t.m_nWrongSide = tunneled - tunneled / 2;
  t.m_nLate = 5;
  t.m_nOverlapped = 20;
  for (CSummary& summary : t.m_stdSummaries) // of figures that are not named below
    summary = {800, 1.0, 2.0, 3.0};
  t["setback"] = {900, 0.5, 0.9, 1.0};
  t["setback_error"] = {900, 0.25, 0.75, 1.5};
  t["setback_error_normal"] = {900, -0.125, 0.5, 1.0};
  t["time_error"] = {900, 0.03, 0.04, 0.05};
  t["poi_error"] = {895, 0.11, 0.12, 0.13};
  t["normal_error"] = {895, 0.14, 0.15, 0.16};
  t["direction_error"] = {890, direction / 2, direction, direction * 2};
  t["speed_error"] = {890, 0.07, 0.08, 0.09};
  t["energy_error"] = {890, 0.21, 0.22, 0.23};
  t["position_error"] = {890, 0.24, 0.26, 0.27};
  t["penetration"] = {899, 0.0, 0.005, 0.02};
  report.m_nGhosts = 2;
  for (const char* pBy : {"travel", "incidence", "pair", "elasticity"})
    for (const char* pLabel : {"low", "high"})
      report.m_stdBins.push_back({pBy, pLabel, t});
  report.m_cHistogram.m_stdSetbackError.assign(g_nHistogramBins, 28);
  report.m_cHistogram.m_stdPenetration.assign(g_nHistogramBins, 29);
  SetSampleTimes(report.m_cCost, ns, tunneled % 10 + 1);
  report.m_cCost.m_fSimulatedSeconds = 100.0;
  report.m_cCost.m_nBallSteps = 6000;
  report.m_cCost.m_nContacts = 60;
  report.m_cLongRun.m_nBounces = 10000;
  report.m_cLongRun.m_fEnergyDrift = -0.03;
  report.m_cLasting = {200, 3, 0.06, 0.7, 0.05, 1.8, 2.5, {654.0, {640.0, 670.0}}};
  return report;
}

/// A world of the sample's effects: it takes `ns` and `instructions`, and loses `lost` of 60.
inline CEffectWorld MakeSampleWorld(double ns, std::optional<double> instructions, std::size_t lost) {
  CEffectWorld world;
  SetSampleTimes(world.m_cCost, ns, 1);
  world.m_fInstructions = instructions;
  world.m_cTotals.m_nContacts = 60;
  world.m_cTotals.m_nMissed = lost;
  world.m_cTotals["direction_error"] = {50, 0.01, 0.02, 0.03};
  world.m_cTotals["speed_error"] = {50, 0.001, 0.002, 0.003};
  world.m_cFlightError = {12, 0.25, 0.5, 0.75};
  return world;
}

/// A setting that takes `ns` for a second of a ball and loses `tunneled` of its contacts.
inline CSetting MakeSetting(const CEngine& engine, double ns, std::optional<double> error,
                            std::size_t contacts, std::size_t tunneled) {
  CSetting setting;
  setting.m_cEngine = engine;
  setting.m_cNsPerBallSecond = {ns, {ns, ns}};
  setting.m_fDirectionErrorP95 = error;
  setting.m_nContacts = contacts;
  setting.m_nTunneled = tunneled;
  return setting;
}

/// Settings of each engine with 1, 2, 4 and 8 substeps, and the reference.
inline CWorkPrecision MakeSampleWork() {
  CWorkPrecision work;
  for (std::size_t e = 0; e < Tests::GetKnownRows().size(); ++e)
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

/// Only native-approximate and box2d-tuned lose any. The ball does not fit into the corner with 2 and .25.
inline CHeatMap MakeSampleHeatMap() {
  CHeatMap map{{0.25, 0.5, 1, 2, 4, 8}, {0.25, 0.5, 1, 2}, 1.25, {}};
  for (const double size : map.m_stdSizes)
    for (const double speed : map.m_stdSpeeds) {
      const std::size_t n = size == 2 && speed == 0.25 ? 0 : 2000, i = map.m_stdCells.size();
      const double through = std::max(0.0, 1 - size / (map.m_fTravel * speed));
      map.m_stdCells.push_back(
          {n, {0, static_cast<std::size_t>(static_cast<double>(n) * through), 0, i * n / 23}});
    }
  return map;
}

/// In a scene that calls for all effects but BallPairs and Sensors: a step with each takes so many times as
/// long as one without it, and without Continuous 30 of 60 are lost instead of one.
inline CEffectCosts MakeSampleEffects(const std::vector<std::string>& engines = {g_sNative}) {
  CEffectCosts costs;
  for (const std::string& engine : engines)
    for (const auto& [effect, runs, ratio] : {std::tuple(eEffect::Gravity, 1.0, 1.15),
                                              {eEffect::Kinematics, 0.35, 5.5},
                                              {eEffect::BallPairs, 0.0, 1.4},
                                              {eEffect::Sensors, 0.0, 1.01},
                                              {eEffect::Events, 1.0, 0.9},
                                              {eEffect::Continuous, 1.0, 1.3}}) {
      CEffectWorld without = MakeSampleWorld(100, 1000, effect == eEffect::Continuous ? 30 : 1);
      if (effect == eEffect::Events) without.m_cTotals = {};
      costs.m_stdCosts.push_back({engine, effect, runs, "it moves 2 radii a substep, </script><b>1 < 2</b>",
                                  MakeSampleWorld(100 * ratio, 1000 * ratio, 1), without});
    }
  return costs;
}

/// Four engines on the spinner: native loses 12 of 1000 and takes 70 ns, native-approximate 203 and 50 ns,
/// box2d 6 and 500 ns, box2d-tuned none and 800 ns.
inline CSceneReport MakeSampleScene() {
  CSceneReport report;
  report.m_cScene = LoadBundled("spinner");
  report.m_cImpactTrials.m_stdContacts = {MakeSampleContact()};
  report.m_cImpactTrials.m_stdGhosts = {2, 2, 2, 2};
  report.m_cImpactTrials.m_nQuietSteps = 800;
  report.m_cImpactTrials.m_nTrials = 1200;
  report.m_cImpactTrials.m_cExcluded = {1, 2, 3, 0, ""};
  report.m_cDifference = {850, 0.06, 0.5, 1.25};
  report.m_stdEngines = {MakeSampleEngine(12, 70.0, 0.0002), MakeSampleEngine(203, 50.0, 0.04),
                         MakeSampleEngine(6, 500.0, 0.02), MakeSampleEngine(0, 800.0, 2e-6)};
  report.m_cWork = MakeSampleWork();
  report.m_cHeatMap = MakeSampleHeatMap();
  report.m_cEffects = MakeSampleEffects();
  CClip clip;
  clip.m_sName = "worst native";
  clip.m_nContact = 1;
  clip.m_sWhat = "native with segment: missed";
  clip.m_stdTracks = {{{1.0f, 2.0f}, {1.5f, 2.25f}},
                      {{1.0f, 2.0f}, {1.5f, 2.375f}},
                      {{1.0f, 2.0f}, {1.5f, 2.5f}},
                      {{1.0f, 2.0f}, {1.25f, 2.75f}},
                      {{1.0f, 2.0f}, {1.123456f, 3.0f}}};
  report.m_stdClips = {clip};
  return report;
}

/// The sample scene alone, with these engines.
inline CRunReport MakeSampleReport(const std::vector<std::size_t>& engines = {0, 1, 2, 3}) {
  CRunReport report;
  report.m_sCommand = "shapes-compare run";
  report.m_nSeed = 5;
  report.m_nContacts = 1000;
  report.m_stdEngines = GetEngines();
  report.m_stdScenes = {MakeSampleScene()};
  const auto keep = [&](auto& all) {
    const auto whole = all;
    all.clear();
    for (const std::size_t e : engines)
      all.push_back(whole[e]);
  };
  keep(report.m_stdEngines);
  keep(report.m_stdScenes[0].m_stdEngines);
  keep(report.m_stdScenes[0].m_cImpactTrials.m_stdContacts[0].m_stdEngines);
  return report;
}

/// The sample scene as it is where nothing could be judged.
inline CSceneReport MakeUndecidedScene() {
  CSceneReport report = MakeSampleScene();
  report.m_cScene.m_sName = "hopeless";
  report.m_cImpactTrials = {};
  report.m_cImpactTrials.m_stdGhosts = {0, 0, 0, 0};
  report.m_cImpactTrials.m_nTrials = 40;
  report.m_cImpactTrials.m_cExcluded.m_nUndecided = 40;
  report.m_cImpactTrials.m_cExcluded.m_sUndecided = "trial 0, step 2: ball 0 is jammed at (1, 2)";
  report.m_cDifference = {};
  for (CEngineReport& engine : report.m_stdEngines) {
    const CCost cost = engine.m_cCost;
    engine = {};
    engine.m_cHistogram.m_stdSetbackError.assign(g_nHistogramBins, 0);
    engine.m_cHistogram.m_stdPenetration.assign(g_nHistogramBins, 0);
    engine.m_cCost = cost;
    engine.m_cCost.m_nContacts = 0;
  }
  return report;
}

} // namespace Shapes::Compare
