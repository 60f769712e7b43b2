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
                             .m_fSpeedError = -3.0f,
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
  t["setback"] = {900, 0.5, 0.9, 1.0};
  t["setback_error"] = {900, 0.25, 0.75, 1.5};
  t["setback_error_normal"] = {900, -0.125, 0.5, 1.0};
  t["time_error"] = {900, 0.03, 0.04, 0.05};
  t["poi_error"] = {895, 0.11, 0.12, 0.13};
  t["normal_error"] = {895, 0.14, 0.15, 0.16};
  t["direction_error"] = {890, direction / 2, direction, direction * 2};
  t["speed_error"] = {890, 0.17, 0.18, 0.19};
  t["energy_error"] = {890, 0.21, 0.22, 0.23};
  t["position_error"] = {890, 0.24, 0.26, 0.27};
  t["penetration"] = {899, 0.0, 0.005, 0.02};
  report.m_nGhosts = 2;
  report.m_stdBins = {{"travel", "1 to 2", t}};
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

/// Native on a scene that calls for Kinematics in a quarter of the substeps, Events and Continuous:
/// kinematics cost half, continuous a tenth and what is lost without it, Events nothing, what does not run a
/// fifth.
inline CEffectCosts MakeSampleEffects() {
  CEffectCosts costs;
  const CEffectWorld called = MakeSampleWorld(100.0, 1000.0, 1);
  for (const eEffect e : g_stdEffects)
    costs.m_stdCosts.push_back({g_sNative, e, 0.0, "0 of them", MakeSampleWorld(120.0, 1100.0, 1), called});
  const auto callFor = [&](eEffect e, double runs, const char* pWhy, const CEffectWorld& without) {
    costs.m_stdCosts[static_cast<std::size_t>(e)] = {g_sNative, e, runs, pWhy, called, without};
  };
  callFor(eEffect::Kinematics, 0.25, "3 shapes rotate", MakeSampleWorld(100.0 / 1.5, 700.0, 1));
  callFor(eEffect::Events, 1.0, "1 solid ball", MakeSampleWorld(100.0, 1000.0, 1));
  callFor(eEffect::Continuous, 1.0, "2 radii", MakeSampleWorld(100.0 / 1.1, 900.0, 30));
  costs.m_stdCosts[static_cast<std::size_t>(eEffect::Events)].m_cWithout.m_cTotals = {};
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
  const auto setting = [](const CEngine& engine, std::optional<double> error) {
    CSetting made = MakeSetting(engine, 3000.0, error, 100, 20);
    made.m_cNsPerBallSecond.m_cInterval = {2900.0, 3100.0};
    made.m_nMissed = 10;
    return made;
  };
  const std::vector<CEngine> engines = GetEngines();
  report.m_cWork.m_stdSettings = {setting(engines[Tests::g_nNative], {}),
                                  setting(engines[Tests::g_nBox2D], 0.02),
                                  setting(engines[Tests::g_nTuned], 2e-6), setting({g_sExact, nullptr}, 0.0)};
  report.m_cWork.m_stdRecommendations = {{"Bounces within 1 degree", {1, 2}, {"native"}, {}},
                                         {"None lost in 100 impacts", {}, {"native", "box2d"}, 1}};
  report.m_cHeatMap.m_stdSpeeds = {1.0, 2.0};
  report.m_cHeatMap.m_stdSizes = {1.0};
  report.m_cHeatMap.m_fTravel = 1.25;
  report.m_cHeatMap.m_stdCells = {{50, {1, 3, 2, 0}}, {0, {0, 0, 0, 0}}};
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
