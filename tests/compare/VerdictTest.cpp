// SPDX-License-Identifier: MIT
// Verdicts follow from the figures.
#include "SampleReport.h"
#include "metrics/Overall.h"
#include "report/Numbers.h"

namespace Shapes::Compare {
namespace {

using Tests::g_nApproximate, Tests::g_nBox2D, Tests::g_nNative, Tests::g_nTuned;

std::string Use(const CRunReport& report) { return MakeVerdict(report, report.m_stdScenes[0]).at(0); }
std::string Does(const CRunReport& report) { return MakeVerdict(report, report.m_stdScenes[0]).at(1); }

TEST(VerdictTest, TheFastestOfTheBestGradeIsTakenAndWhatAFasterOneWouldLoseIsSaid) {
  EXPECT_EQ(Use(MakeSampleReport()),
            "Use tuned Box2D: better than Box2D here and 0.62 times as fast; native-approximate is 16 times "
            "as fast as tuned Box2D but loses 1 in 4.9.");
  CRunReport report = MakeSampleReport({g_nNative, g_nApproximate, g_nBox2D});
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  // 12 and 6 of 1,000 cannot be told apart, nor 12 from what rough allows; 30 can.
  EXPECT_EQ(Use(report).substr(0, 12), "Use native: ");
  engines[g_nNative] = MakeSampleEngine(30, 70.0, 0.0002);
  EXPECT_EQ(Use(report).substr(0, 12), "Use Box2D: n");
  engines[g_nNative] = MakeSampleEngine(0, 70.0, 0.0002);
  EXPECT_EQ(Use(report),
            "Use native: better than Box2D here and 7.1 times as fast; native-approximate is 1.4 times "
            "as fast as native but loses 1 in 4.9.");
  EXPECT_EQ(
      Does(report),
      "It loses none of 1,000, and 95% of its bounces are within 0.011 degrees of the exact direction; Box2D "
      "loses 1 in 170 and is within 1.1 degrees.");
  engines[g_nBox2D] = MakeSampleEngine(0, 500.0, 0.0002);
  EXPECT_EQ(Use(report).substr(0, 50), "Use native: as good as Box2D here and 7.1 times as");
  engines[g_nApproximate] = MakeSampleEngine(0, 50.0, 0.0002);
  EXPECT_EQ(Use(report), "Use native-approximate: as good as Box2D here and 10 times as fast.");
  // The world by default, where the faster one is so by chance only; the control is faster in every repeat.
  engines[g_nApproximate] = MakeSampleEngine(0, 69.9, 0.0002);
  SetSampleTimes(engines[g_nApproximate].m_cCost, 69.9, 5);
  EXPECT_EQ(Use(report).substr(0, 11), "Use native:");
  SetSampleTimes(engines[g_nApproximate].m_cCost, 55.0, 5);
  EXPECT_EQ(Use(report).substr(0, 23), "Use native-approximate:");
}

TEST(VerdictTest, WorseBouncesAreAReasonToo) {
  CRunReport report = MakeSampleReport({g_nNative, g_nApproximate, g_nBox2D});
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  for (const std::size_t e : {g_nNative, g_nApproximate})
    engines[e] = MakeSampleEngine(0, 50.0 + 10.0 * static_cast<double>(e), 0.1);
  engines[g_nBox2D] = MakeSampleEngine(0, 500.0, 0.01);
  EXPECT_EQ(Use(report),
            "Use Box2D: no faster engine is as good here; native is 10 times as fast as Box2D but 5% of its "
            "bounces are more than 5.7 degrees off.");
}

// The machine is slow for some repeats in which both engines are; their medians are of other repeats.
TEST(VerdictTest, SpeedsAreThoseOfTheTable) {
  CRunReport report = MakeSampleReport({g_nNative, g_nBox2D});
  auto& engines = report.m_stdScenes[0].m_stdEngines;
  for (CEngineReport& engine : engines)
    engine = MakeSampleEngine(0, 1.0, 0.0002);
  engines[0].m_cCost.m_stdRepeats = {10, 20, 30};
  engines[1].m_cCost.m_stdRepeats = {50, 200, 60};
  for (CEngineReport& engine : engines)
    engine.m_cCost.m_cNsPerBallStep = MedianWithInterval(engine.m_cCost.m_stdRepeats);
  EXPECT_EQ(Use(report), "Use native: as good as Box2D here and 5.0 times as fast."); // not 60 / 20
  EXPECT_TRUE(Says(MakeSceneLine(report, report.m_stdScenes[0]), " 5\n"));
}

TEST(VerdictTest, OneEngineAloneIsNotCompared) {
  const CRunReport report = MakeSampleReport({g_nBox2D});
  EXPECT_EQ(Use(report), "Box2D is alone here.");
  EXPECT_EQ(Does(report),
            "It loses 1 in 170, and 95% of its bounces are within 1.1 degrees of the exact direction.");
  // Without Box2D the one that loses least is the measure.
  CRunReport two = MakeSampleReport({g_nNative, g_nApproximate});
  two.m_stdScenes[0].m_stdEngines[0] = MakeSampleEngine(0, 70.0, 0.0002);
  EXPECT_EQ(Use(two), "Use native; native-approximate is 1.4 times as fast as native but loses 1 in 4.9.");
}

TEST(VerdictTest, TellsOfWhatElseIsWrongAndOnlyThen) {
  CRunReport report = MakeSampleReport({g_nNative, g_nBox2D});
  CSceneReport& scene = report.m_stdScenes[0];
  for (CEngineReport& engine : scene.m_stdEngines) {
    engine.m_nGhosts = 0;
    engine.m_cLongRun.m_fEnergyDrift = 0.0005; // too little to tell
    engine.m_cLasting = CLasting();
  }
  EXPECT_TRUE(MakeRemarks(report, scene).empty());
  scene.m_cScene.m_fLasting = 10.0f;
  scene.m_stdEngines[0].m_cLasting = {200, 3, 0.06, 0.7, 0.05, 1.8, 2.5, {654.0, {640.0, 670.0}}};
  scene.m_stdEngines[1].m_cLasting = {200, 0, 0.002, 0.7, 0.05, 1.8, {}, {1000.0, {640.0, 670.0}}};
  EXPECT_EQ(
      MakeRemarks(report, scene).at(0),
      "Over 10 s, in which contact lasts: native loses 1 in 67 and ends 0.060 radii deep, 2.5 balls pass in "
      "a second, at 654 ns a step, box2d loses none of 200 and ends 0.002 radii deep, at 1000 ns a step.");
  for (CEngineReport& engine : scene.m_stdEngines)
    engine.m_cLasting = CLasting();
  scene.m_stdEngines[0].m_cLongRun.m_fEnergyDrift = 0.0321;
  scene.m_stdEngines[1].m_cLongRun = {1000, 60.0, 2.5, {}, {}};
  scene.m_stdEngines[1].m_cTotals.m_nLate = 300;
  scene.m_stdEngines[0].m_cTotals["speed_error"] = {890, 0.0, 1e-7, 1e-6};
  scene.m_stdEngines[1].m_cTotals["speed_error"] = {890, -0.6, 0.67, 0.7};
  scene.m_stdEngines[1].m_nGhosts = 80;
  scene.m_stdEngines[0].m_cCost.m_nNotFinite = 3;
  scene.m_stdEngines[1].m_cCost.m_cNsPerBallStep.m_cInterval = {300.0, 600.0};
  EXPECT_EQ(
      MakeRemarks(report, scene),
      (std::vector<std::string>{
          "Balls became NaN or infinite: native 3, box2d 0.",
          "Turned back one or two steps late: native 0.50%, box2d 30.0%.",
          "Of the steps in which a ball only passes by, it is turned all the same in: native <0.38%, box2d "
          "10.0%.",
          "95% of the speeds after an impact are this close to the exact ones: native 0.1%, box2d 67%.",
          "Energy over many bounces: native +3.2% in 10,000, box2d times 3.5 in 1,000.",
          "The times were disturbed, by nanoseconds between: native 67 and 73, box2d 300 and 600."}));
}

TEST(VerdictTest, WhatWasNotMeasuredIsNotJudged) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes = {MakeUndecidedScene()};
  EXPECT_EQ(Use(report),
            "Nothing is judged: the exact reference gave up 40 of 40 trials, the first at trial 0, step 2: "
            "ball 0 is jammed at (1, 2).");
  EXPECT_EQ(MakeVerdict(report, report.m_stdScenes[0]).size(), 1u);
  CExcluded& aside = report.m_stdScenes[0].m_cImpactTrials.m_cExcluded;
  aside = {};
  EXPECT_EQ(Use(report), "There is nothing to judge: no ball met anything in 40 trials.");
  aside.m_nResting = 3;
  EXPECT_EQ(Use(report), "There is nothing to judge: every impact was set aside in 40 trials.");
}

TEST(OverallTest, GradesAreWhatTheBoundsAllow) {
  EXPECT_EQ(GradeOf(1, 1000, 1.0 * g_fDegree, 0.1), eGrade::Good);
  EXPECT_EQ(GradeOf(1, 300, {}, {}), eGrade::Good); // by chance
  EXPECT_EQ(GradeOf(40, 20000, {}, {}), eGrade::Rough);
  EXPECT_EQ(GradeOf(0, 1000, 1.001 * g_fDegree, {}), eGrade::Rough);
  EXPECT_EQ(GradeOf(0, 1000, 0.0, 0.101), eGrade::Rough);
  EXPECT_EQ(GradeOf(10, 1000, 10.0 * g_fDegree, 0.3), eGrade::Rough);
  EXPECT_EQ(GradeOf(240, 20000, 0.0, {}), eGrade::Poor);
  EXPECT_EQ(GradeOf(0, 1000, 0.2, {}), eGrade::Poor);
  EXPECT_EQ(GradeOf(0, 1000, 0.0, 0.301), eGrade::Poor);
  EXPECT_EQ(GradeOf(0, 0, 0.0, {}), eGrade::Unknown);
}

// The bounces of both go the right way, but those of Box2D are too slow.
TEST(OverallTest, SpeedsCountOfASceneAndOverAll) {
  CRunReport report = MakeSampleReport({g_nNative, g_nBox2D});
  CSceneReport& scene = report.m_stdScenes[0];
  for (std::size_t e = 0; e < 2; ++e) {
    scene.m_stdEngines[e] = MakeSampleEngine(0, e == 0 ? 500.0 : 50.0, 0.0002);
    CEngineContact& contact = scene.m_cImpactTrials.m_stdContacts[0].m_stdEngines[e];
    contact.m_bCompared = true;
    contact.m_fDirectionError = 0.0f;
  }
  EXPECT_EQ(GradeOf(scene.m_stdEngines[1].m_cTotals), eGrade::Good); // the control
  EXPECT_EQ(MakeOverall(report).GetGrade(1), eGrade::Good);
  EXPECT_EQ(FindTake(report, scene), 1u);
  scene.m_stdEngines[1].m_cTotals["speed_error"] = {890, -0.6, 0.67, 0.7};
  scene.m_cImpactTrials.m_stdContacts[0].m_stdEngines[1].m_fSpeedError = -0.25f;
  EXPECT_EQ(GradeOf(scene.m_stdEngines[1].m_cTotals), eGrade::Poor);
  EXPECT_EQ(MakeOverall(report).GetGrade(1), eGrade::Rough);
  EXPECT_EQ(FindTake(report, scene), 0u);
  EXPECT_EQ(Use(report),
            "Use native: better than Box2D here and 0.10 times as fast; Box2D is 10 times as fast as native "
            "but 5% of its speeds are more than 67% off.");
}

// Two scenes, in one of which everything takes four times as long.
TEST(OverallTest, TimesAreGeometricMeansAndCountsAreSums) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes.push_back(report.m_stdScenes[0]);
  auto& slow = report.m_stdScenes[1].m_stdEngines;
  for (std::size_t e = 0; e < slow.size(); ++e)
    for (double& ns : slow[e].m_cCost.m_stdRepeats)
      ns *= e == g_nBox2D ? 16.0 : 4.0;
  for (CEngineReport& engine : slow)
    engine.m_cCost.m_cNsPerBallStep = MedianWithInterval(engine.m_cCost.m_stdRepeats);
  report.m_stdScenes.push_back(MakeUndecidedScene()); // counts for nothing
  const COverall overall = MakeOverall(report);
  EXPECT_EQ(overall.m_nScenes, 2u);
  EXPECT_EQ(overall.m_nImpacts, 2000u);
  const CEngineOverall& native = overall.m_stdEngines[g_nNative];
  EXPECT_EQ(native.m_nLost, 24u);
  EXPECT_NEAR(native.m_cNs.m_fMedian, 140.0, 1.0);
  EXPECT_NEAR(native.m_cNsScenes.m_fLow, 70.0, 1.0);
  EXPECT_NEAR(native.m_cNsScenes.m_fHigh, 280.0, 4.0);
  ASSERT_TRUE(native.m_cTimes);
  EXPECT_NEAR(native.m_cTimes->m_fMedian, 2.0 * 500.0 / 70.0, 0.3);
  EXPECT_LE(native.m_cTimes->m_cInterval.m_fLow, native.m_cTimes->m_fMedian);
  EXPECT_GE(native.m_cTimes->m_cInterval.m_fHigh, native.m_cTimes->m_fMedian);
  EXPECT_NEAR(overall.m_stdEngines[g_nBox2D].m_cTimes->m_fMedian, 1.0, 1e-12);
  // Directions are those of all impacts: one in each scene, exact, or 2 rad on native-approximate.
  EXPECT_EQ(native.m_nCompared, 2u);
  EXPECT_EQ(native.m_cDirection.m_fValue, 0.0);
  EXPECT_EQ(overall.m_stdEngines[g_nApproximate].m_cDirection.m_fValue, 2.0);
  // On the line is what no other one beats in both.
  const bool front[] = {true, true, false, false};
  for (std::size_t e = 0; e < 4; ++e)
    EXPECT_EQ(overall.m_stdEngines[e].m_bFront, front[e]) << e;
  // An engine that has lost all has no direction, and beats nobody.
  for (CSceneReport& scene : report.m_stdScenes)
    for (CContact& contact : scene.m_cImpactTrials.m_stdContacts)
      contact.m_stdEngines[g_nApproximate].m_bCompared = false;
  EXPECT_TRUE(MakeOverall(report).m_stdEngines[g_nNative].m_bFront);
  report.m_stdScenes.clear();
  EXPECT_FALSE(MakeOverall(report).m_nTake);
}

TEST(OverallTest, TheResultBeginsWithTheEngineToTake) {
  CRunReport report = MakeSampleReport({g_nNative, g_nApproximate, g_nBox2D});
  report.m_stdScenes[0].m_stdEngines[g_nNative] = MakeSampleEngine(1, 70.0, 0.0002);
  const std::string result = MakeResult(report, MakeOverall(report));
  EXPECT_EQ(result,
            "Take native: 7.1 times as fast as Box2D. It loses 1 of 1,000 impacts (Box2D 6), and 95% "
            "of its bounces are within 0.001 degrees of the exact direction; native-approximate is 1.4 times "
            "as fast as native but loses 1 in 4.9.");
  CRunReport alone = MakeSampleReport({g_nNative, g_nApproximate});
  EXPECT_EQ(MakeResult(alone, MakeOverall(alone))
                .rfind("Take native: it loses 12 of 1,000 impacts, and 95% of its bounces are within ", 0),
            0u)
      << MakeResult(alone, MakeOverall(alone));
  report.m_stdScenes.clear();
  EXPECT_EQ(MakeResult(report, MakeOverall(report)), "Nothing was judged.");
}

} // namespace
} // namespace Shapes::Compare
