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

// The sample without native-continuous.
CRunReport OfThree() {
  CRunReport report = MakeSampleReport();
  report.m_stdEngines.erase(report.m_stdEngines.begin() + Tests::g_nContinuous);
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  engines.erase(engines.begin() + Tests::g_nContinuous);
  return report;
}

// The sample with native and box2d only.
CRunReport OfTwo(const CEngineReport& native, const CEngineReport& box2d) {
  CRunReport report = OfThree();
  report.m_stdEngines.resize(2);
  report.m_stdScenes[0].m_stdEngines = {native, box2d};
  return report;
}

TEST(VerdictTest, TheOneThatLosesMoreComesFirstAndTheFastest) {
  CRunReport report = OfThree();
  ExpectSays(report, "native loses 20.3% +-2.5 of the balls, box2d 0.60% +-0.51, box2d-tuned none of 1,000.");
  ExpectSays(report, "A step of a ball takes 50 ns on native, 500 ns on box2d (10 times as long), 800 ns on "
                     "box2d-tuned (16 times as long).");
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  std::swap(engines[0], engines[1]);
  ExpectSays(report, "box2d loses 20.3% +-2.5 of the balls, native 0.60% +-0.51, box2d-tuned none of 1,000.");
  ExpectSays(report, "A step of a ball takes 50 ns on box2d, 500 ns on native (10 times as long), 800");
}

TEST(VerdictTest, WhoWinsIsSaid) {
  CRunReport report = OfThree();
  const auto first = [&] { return MakeVerdict(report, report.m_stdScenes[0])[1]; };
  EXPECT_EQ(first(), "Fewest lost: box2d-tuned; best directions: box2d-tuned; fastest: native.");
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  engines[1] = MakeSampleEngine(2, 51.0, 2.4e-6); // 0 and 2, and 2.0e-6 and 2.4e-6, cannot be told apart
  EXPECT_EQ(first(), "Fewest lost: box2d and box2d-tuned; best directions: box2d and box2d-tuned; fastest: "
                     "native and box2d.");
  engines[0] = engines[1] = engines[2];
  EXPECT_EQ(first(), "Fewest lost: no difference; best directions: no difference; fastest: no difference.");
  for (CEngineReport& engine : engines)
    engine.m_cTotals["direction_error"] = {};
  EXPECT_EQ(first(), "Fewest lost: no difference; best directions: not known; fastest: no difference.");
}

TEST(VerdictTest, WhetherCheapBallsWillDoIsSaidFirst) {
  CRunReport report = MakeSampleReport();
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  const auto expectFirst = [&](const std::string& answer) {
    EXPECT_EQ(MakeVerdict(report, report.m_stdScenes[0])[0],
              "Are cheap balls as good as box2d's? " + answer + ".");
  };
  expectFirst("Not native's, which loses more; native-continuous's are, in 1/7 of the time");
  engines[Tests::g_nContinuous] = MakeSampleEngine(14, 650.0, 0.02);
  expectFirst("Not native's, which loses more; native-continuous's are, in 1.3 times the time");
  engines[Tests::g_nContinuous] = MakeSampleEngine(12, 70.0, 0.03);
  expectFirst("No: native loses more, native-continuous has worse directions");
  engines[Tests::g_nNative] = MakeSampleEngine(203, 50.0, 0.04);
  expectFirst("No: native loses more and has worse directions, native-continuous has worse directions");
  engines[Tests::g_nNative] = MakeSampleEngine(12, 50.0, 0.04);
  expectFirst("No: native has worse directions, native-continuous too");
  engines[Tests::g_nNative] = MakeSampleEngine(12, 50.0, 0.02);
  expectFirst("Yes, native's are, in 1/10 of the time");
}

TEST(VerdictTest, ContinuousIsNamedOnlyWhereItTellsSomething) {
  CRunReport report = MakeSampleReport();
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  const auto expectNamed = [&](bool expected) { ExpectSays(report, "native-continuous", expected); };
  expectNamed(true);
  ExpectSays(report,
             "native loses 20.3% +-2.5 of the balls, native-continuous 1.2% +-0.7, box2d 0.60% +-0.51, "
             "box2d-tuned none of 1,000; native-continuous and box2d cannot be told apart.");
  ExpectSays(report,
             "takes 50 ns on native, 70 ns on native-continuous (1.4 times as long), 500 ns on box2d");
  engines[Tests::g_nContinuous] = MakeSampleEngine(201, 90.0, 0.0001); // only slower, by what the tables say
  expectNamed(false);
  ExpectSays(report, "native loses 20.3% +-2.5 of the balls, box2d 0.60% +-0.51, box2d-tuned none of 1,000.");
  engines[Tests::g_nContinuous].m_cTotals["direction_error"].m_fP95 = 0.0002;
  expectNamed(true);
  engines[Tests::g_nContinuous] = MakeSampleEngine(201, 90.0, 0.0001);
  engines[Tests::g_nContinuous].m_cLongRun.m_fEnergyDrift = 0.0; // native's is told of
  expectNamed(true);
  engines.erase(engines.begin()); // without native it is an engine like any other
  report.m_stdEngines.erase(report.m_stdEngines.begin());
  engines[0] = engines[1];
  expectNamed(true);
}

TEST(VerdictTest, DisturbedTimesAreSaidToBe) {
  CRunReport report = OfThree();
  ExpectSays(report, "disturbed", false);
  CCost& cost = report.m_stdScenes[0].m_stdEngines[1].m_cCost;
  cost.m_cNsPerBallStep.m_cInterval = {300.0, 600.0};
  ExpectSays(report, "500 ns on box2d (10 times as long; disturbed, 300 to 600), 800 ns");
}

TEST(VerdictTest, WhatCannotBeToldApartIsNotCompared) {
  const CEngineReport box2d = MakeSampleEngine(6, 104.0, 0.02);
  CRunReport report = OfTwo(MakeSampleEngine(8, 100.0, 0.02), box2d);
  ExpectSays(report, "Fewest lost: no difference; best directions: no difference; fastest: no difference.");
  ExpectSays(report, "Which one loses more cannot be told from 1,000 impacts: native loses 0.80% +-0.58 of "
                     "the balls, box2d 0.60% +-0.51.");
  ExpectSays(report, "A step of a ball takes 100 ns on native, 104 ns on box2d (cannot be told apart).");
  ExpectSays(report, "95% of its directions are within 0.020 rad on both");
  // The control: figures that are apart.
  report = OfTwo(MakeSampleEngine(80, 60.0, 0.03), box2d);
  ExpectSays(report, "cannot be told", false);
  ExpectSays(report, "60 ns on native, 104 ns on box2d (1.7 times as long)");
  ExpectSays(report, "are within 0.030 rad on native, within 0.020 rad on box2d.");
  // The intervals of 19 and 6 overlap, and yet they are apart: both were asked at the same impacts.
  ExpectSays(OfTwo(MakeSampleEngine(19, 60.0, 0.03), box2d), "cannot be told from", false);
  ExpectSays(OfTwo(MakeSampleEngine(15, 60.0, 0.03), box2d), "cannot be told from");
}

TEST(VerdictTest, OfSeveralEnginesThoseThatCannotBeToldApartAreNamed) {
  CRunReport report = OfThree();
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  engines[2] = MakeSampleEngine(4, 800.0, 0.02);
  ExpectSays(report, "native loses 20.3% +-2.5 of the balls, box2d 0.60% +-0.51, box2d-tuned 0.40% +-0.43; "
                     "box2d and box2d-tuned cannot be told apart.");
  ExpectSays(report, "are within 1e-4 rad on native, within 0.020 rad on box2d and box2d-tuned.");
  engines[0] = MakeSampleEngine(8, 50.0, 0.02);
  ExpectSays(report, "Which one loses more cannot be told from 1,000 impacts: native loses");
  ExpectSays(report, "cannot be told apart", false); // that says it all
  ExpectSays(report, "are within 0.020 rad on all.");
  engines[0] = engines[1] = engines[2] = MakeSampleEngine(0, 50.0, 0.02);
  ExpectSays(report, "None loses a ball in 1,000 impacts.");
}

TEST(VerdictTest, DirectionsAreExactOrWithinWhatTheDigitsShow) {
  CRunReport report = OfTwo(MakeSampleEngine(8, 100.0, 0.0), MakeSampleEngine(6, 104.0, 0.0001));
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  ExpectSays(report, "95% of its directions are exact on native, within 1e-4 rad on box2d.");
  engines[1].m_cTotals["direction_error"].m_fP95 = 0.9e-7; // rounding
  ExpectSays(report, "95% of its directions are exact on both.");
  engines[1].m_cTotals["direction_error"] = {};
  ExpectSays(report, "exact on native, not known on box2d.");
}

TEST(VerdictTest, NoneIsOfHowMany) {
  CRunReport report = OfTwo(MakeSampleEngine(203, 50.0, 0.02), MakeSampleEngine(0, 500.0, 0.02));
  ExpectSays(report, "box2d none of 1,000");
  CRunReport three = OfThree();
  three.m_stdScenes[0].m_stdEngines[1] = MakeSampleEngine(0, 500.0, 0.02);
  ExpectSays(three, "native loses 20.3% +-2.5 of the balls, box2d and box2d-tuned none of 1,000.");
  report.m_stdScenes[0].m_stdEngines[0] = MakeSampleEngine(0, 50.0, 0.02);
  ExpectSays(report, "Neither loses a ball in 1,000 impacts.");
}

TEST(VerdictTest, OneEngineAloneIsNotCompared) {
  CRunReport report = OfThree();
  report.m_stdEngines = {GetEngines()[Tests::g_nBox2D]};
  report.m_stdScenes[0].m_stdEngines = {MakeSampleEngine(0, 500.0, 0.02)};
  ExpectSays(report, "box2d does not lose a ball in 1,000 impacts.\nA step of a ball takes 500 ns on box2d.");
  report.m_stdScenes[0].m_stdEngines = {MakeSampleEngine(10, 500.0, 0.02)};
  ExpectSays(report, "box2d loses 1.0% +-0.6 of the balls.\nA step");
  ExpectSays(report, "native", false);
  ExpectSays(report, "Fewest", false);
  ExpectSays(report, "oth", false);
}

TEST(VerdictTest, TellsOfWhatElseIsWrongAndOnlyThen) {
  CRunReport report = OfThree();
  CSceneReport& scene = report.m_stdScenes[0];
  for (CEngineReport& engine : scene.m_stdEngines) {
    engine.m_nGhosts = 0;
    engine.m_cLongRun.m_fEnergyDrift = 0.0005; // too little to tell
  }
  EXPECT_EQ(MakeVerdict(report, scene).size(), 5u);
  scene.m_stdEngines[0].m_cLongRun.m_fEnergyDrift = 0.0321;
  scene.m_stdEngines[1].m_cLongRun.m_fEnergyDrift = -0.5;
  ExpectSays(report,
             "Energy over many bounces: native +3.2% in 10,000, box2d -50% in 10,000, box2d-tuned kept "
             "in 10,000.");
  scene.m_stdEngines[1].m_cLongRun = {1000, 60.0, 2.5, {}, {}};
  ExpectSays(report, "native +3.2% in 10,000, box2d times 3.5 in 1,000");
  scene.m_stdEngines[1].m_cTotals.m_nLate = 300;
  ExpectSays(report, "Turned back one or two steps late: native 0.50%, box2d 30.0%, box2d-tuned 0.50%.");
  scene.m_stdEngines[1].m_nGhosts = 80;
  ExpectSays(report, "native <0.38%, box2d 10.0%, box2d-tuned <0.38%.");
  scene.m_stdEngines[0].m_cCost.m_nNotFinite = 3;
  ExpectSays(report, "NaN or infinite: native 3, box2d 0, box2d-tuned 0.");
  EXPECT_EQ(MakeVerdict(report, scene).size(), 9u);
}

TEST(VerdictTest, WhatWasNotMeasuredIsNotJudged) {
  CRunReport report = OfThree();
  report.m_stdScenes = {MakeUndecidedScene()};
  ExpectSays(
      report,
      "Nothing is judged: the exact reference gave up 40 of 40 trials, the first at trial 0, step 2: ");
  ExpectSays(report, "%", false);
  CExcluded& aside = report.m_stdScenes[0].m_cImpactTrials.m_cExcluded;
  aside = {};
  ExpectSays(report, "There is nothing to judge: no ball met anything in 40 trials.");
  aside.m_nResting = 3;
  ExpectSays(report, "There is nothing to judge: every impact was set aside in 40 trials.");
}

} // namespace
} // namespace Shapes::Compare
