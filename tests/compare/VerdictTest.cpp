// SPDX-License-Identifier: MIT
// What the verdicts say follows from the figures.
#include "SampleReport.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace Shapes::Compare {
namespace {

std::string Text(const CRunReport& report, std::size_t scene = 0) {
  std::string text;
  for (const std::string& sentence : MakeVerdict(report, report.m_stdScenes[scene]))
    text += sentence + "\n";
  return text;
}

void ExpectSays(const CRunReport& report, const std::string& part, bool expected = true) {
  EXPECT_EQ(Text(report).find(part) != std::string::npos, expected) << part << "\nin\n" << Text(report);
}

TEST(VerdictTest, TheOneThatLosesMoreComesFirst) {
  CRunReport report = MakeSampleReport();
  ExpectSays(report,
             "native loses 20.3% +-2.5 of the balls, box2d 0.60% +-0.51; native takes 1/10 of the time "
             "(50 ns against 500 ns for a step of a ball).");
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  std::swap(engines[0], engines[1]);
  ExpectSays(report,
             "box2d loses 20.3% +-2.5 of the balls, native 0.60% +-0.51; box2d takes 1/10 of the time");
}

TEST(VerdictTest, DisturbedTimesAreSaidToBe) {
  CRunReport report = MakeSampleReport();
  ExpectSays(report, "disturbed", false);
  CCost& cost = report.m_stdScenes[0].m_stdEngines[1].m_cCost;
  cost.m_cNsPerBallStep.m_cInterval = {300.0, 600.0};
  ExpectSays(report, "500 ns, disturbed: 300 to 600");
}

TEST(VerdictTest, WhatCannotBeToldApartIsNotCompared) {
  CRunReport report = MakeSampleReport();
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  engines = {MakeSampleEngine(8, 100.0, 0.02), MakeSampleEngine(6, 104.0, 0.02)};
  ExpectSays(report, "Which one loses more cannot be told from 1,000 impacts: native loses 0.80% +-0.58 of "
                     "the balls, box2d 0.60% "
                     "+-0.51; their times cannot be told apart (100 ns and 104 ns");
  ExpectSays(report, "95% of its directions are within 0.020 rad on both");
  // The control: figures that are apart.
  engines[0] = MakeSampleEngine(80, 60.0, 0.03);
  ExpectSays(report, "cannot be told", false);
  // The intervals of 19 and 6 overlap, and yet they are apart: both were asked at the same impacts.
  engines[0] = MakeSampleEngine(19, 60.0, 0.03);
  ExpectSays(report, "cannot be told from", false);
  engines[0] = MakeSampleEngine(15, 60.0, 0.03);
  ExpectSays(report, "cannot be told from");
  engines[0] = MakeSampleEngine(80, 60.0, 0.03);
  ExpectSays(report, "native takes 58% of the time");
  ExpectSays(report, "are within 0.030 rad on native, within 0.020 rad on box2d.");
}

TEST(VerdictTest, DirectionsAreExactOrWithinWhatTheDigitsShow) {
  CRunReport report = MakeSampleReport();
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  engines = {MakeSampleEngine(8, 100.0, 0.0), MakeSampleEngine(6, 104.0, 0.0001)};
  ExpectSays(report, "95% of its directions are exact on native, within 0.001 rad on box2d.");
  engines[1].m_cTotals.m_cDirectionError.m_fP95 = 0.0;
  ExpectSays(report, "95% of its directions are exact on both.");
  engines[1].m_cTotals.m_cDirectionError = {};
  ExpectSays(report, "exact on native, not known on box2d.");
}

TEST(VerdictTest, NoneIsOfHowMany) {
  CRunReport report = MakeSampleReport();
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  engines[1] = MakeSampleEngine(0, 500.0, 0.02);
  ExpectSays(report, "box2d none of 1,000");
  engines[0] = MakeSampleEngine(0, 50.0, 0.02);
  ExpectSays(report, "Neither loses a ball in 1,000 impacts;");
}

TEST(VerdictTest, OneEngineAloneIsNotCompared) {
  CRunReport report = MakeSampleReport();
  report.m_stdEngines = {GetEngines()[1]};
  report.m_stdScenes[0].m_stdEngines = {MakeSampleEngine(0, 500.0, 0.02)};
  ExpectSays(report, "box2d does not lose a ball in 1,000 impacts; a step of a ball takes 500 ns.");
  report.m_stdScenes[0].m_stdEngines = {MakeSampleEngine(10, 500.0, 0.02)};
  ExpectSays(report, "box2d loses 1.0% +-0.6 of the balls; a step");
  ExpectSays(report, "native", false);
  ExpectSays(report, "oth", false);
}

TEST(VerdictTest, TellsOfWhatElseIsWrongAndOnlyThen) {
  CRunReport report = MakeSampleReport();
  CSceneReport& scene = report.m_stdScenes[0];
  for (CEngineReport& engine : scene.m_stdEngines) {
    engine.m_nGhosts = 0;
    engine.m_cLongRun.m_fEnergyDrift = 0.0005; // too little to tell
  }
  EXPECT_EQ(MakeVerdict(report, scene).size(), 2u);
  scene.m_stdEngines[0].m_cLongRun.m_fEnergyDrift = 0.0321;
  scene.m_stdEngines[1].m_cLongRun.m_fEnergyDrift = -0.5;
  ExpectSays(report, "Energy over many bounces: native +3.2% in 10,000, box2d -50% in 10,000.");
  scene.m_stdEngines[1].m_cLongRun.m_fEnergyDrift = 0.0;
  ExpectSays(report, "native +3.2% in 10,000, box2d kept in 10,000.");
  scene.m_stdEngines[1].m_cLongRun = {1000, 60.0, 2.5, {}, {}};
  ExpectSays(report, "native +3.2% in 10,000, box2d times 3.5 in 1,000.");
  scene.m_stdEngines[1].m_cTotals.m_nLate = 300;
  ExpectSays(report, "Turned back one or two steps late: native 0.50%, box2d 30.0%.");
  scene.m_stdEngines[1].m_nGhosts = 80;
  ExpectSays(report, "native <0.38%, box2d 10.0%");
  scene.m_stdEngines[0].m_cCost.m_nNotFinite = 3;
  ExpectSays(report, "NaN or infinite: native 3, box2d 0");
  EXPECT_EQ(MakeVerdict(report, scene).size(), 3u);
}

TEST(VerdictTest, WhatWasNotMeasuredIsNotJudged) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes = {MakeUndecidedScene()};
  ExpectSays(
      report,
      "Nothing is judged: the exact reference gave up 40 of 40 trials, the first at trial 0, step 2: ");
  ExpectSays(report, "%", false);
  CSetAside& aside = report.m_stdScenes[0].m_cRestart.m_cSetAside;
  aside = {};
  ExpectSays(report, "There is nothing to judge: no ball met anything in 40 trials.");
  aside.m_nResting = 3;
  ExpectSays(report, "There is nothing to judge: every impact was set aside in 40 trials.");
}

} // namespace
} // namespace Shapes::Compare
