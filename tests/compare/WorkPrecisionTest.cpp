// SPDX-License-Identifier: MIT
#include "metrics/WorkPrecision.h"

#include <set>

#include "MadeScenes.h"

namespace Shapes::Compare {
namespace {

CSetting MakeSetting(const std::string& engine, unsigned substeps, double ns, std::optional<double> error,
                     std::size_t contacts, std::size_t tunneled) {
  CSetting setting;
  setting.m_cEngine = {engine, nullptr};
  setting.m_cEngine.m_nSubsteps = substeps;
  setting.m_cNsPerBallSecond = {ns, {ns, ns}};
  setting.m_fDirectionErrorP95 = error;
  setting.m_nContacts = contacts;
  setting.m_nTunneled = tunneled;
  return setting;
}

TEST(WorkPrecision, TheLadderHasEachSettingOnceAndBeginsWithTheEnginesAsTheyCome) {
  std::set<std::string> labels;
  for (const CEngine& engine : GetParameterSweep())
    EXPECT_TRUE(labels.insert(engine.m_sName + ": " + engine.GetLabel()).second) << engine.GetLabel();
  EXPECT_TRUE(labels.count("native: as it comes"));
  EXPECT_TRUE(labels.count("box2d: as it comes"));
  EXPECT_TRUE(labels.count("native-approximate: 64 substeps"));
  EXPECT_TRUE(labels.count("box2d: 4 substeps, 10x scale, 1+1 iterations"));
  EXPECT_TRUE(labels.count("box2d-tuned: as it comes"));
  EXPECT_TRUE(labels.count("box2d-tuned: arcs 4x finer"));
  for (const char* pSubsteps : {"as it comes", "2 substeps", "4 substeps", "8 substeps"})
    EXPECT_TRUE(labels.count(std::string("native: ") + pSubsteps));
  EXPECT_EQ(labels.size(), 40u);
  for (const CEngine& engine : GetParameterSweep()) {
    EXPECT_EQ(engine.m_eProfile, GetEngineRow(engine.m_sName).m_eProfile);
    EXPECT_EQ(engine.m_cEffects, GetEngineRow(engine.m_sName).m_cEffects);
  }
}

TEST(WorkPrecision, TheFrontIsWhatNothingBeats) {
  std::vector<CSetting> settings{
      MakeSetting("native", 1, 100, .5, 100, 50), MakeSetting("native", 2, 200, .1, 100, 0),
      MakeSetting("box2d", 1, 300, .2, 100, 0),   MakeSetting("box2d", 2, 400, .05, 100, 1),
      MakeSetting("box2d", 4, 150, {}, 0, 0),     MakeSetting("native", 4, 200, .1, 100, 0),
      MakeSetting("exact", 1, 10, 0., 100, 0)}; // no engine to choose: it beats nobody
  MarkFronts(settings);
  const bool byError[] = {true, true, false, true, false, true, false};
  const bool byMisses[] = {true, true, false, false, false, true, false};
  for (std::size_t i = 0; i < settings.size(); ++i) {
    EXPECT_EQ(settings[i].m_bFrontByError, byError[i]) << i;
    EXPECT_EQ(settings[i].m_bFrontByMisses, byMisses[i]) << i;
  }
}

TEST(WorkPrecision, AnswersAreTheCheapestOfEachEngine) {
  std::vector<CSetting> settings{MakeSetting("native-approximate", 1, 1000, .5, 1000, 500),
                                 MakeSetting("native-approximate", 8, 8000, .009, 1000, 0),
                                 MakeSetting("box2d", 1, 40000, .002, 5000, 0),
                                 MakeSetting("box2d", 2, 60000, .0005, 500, 0),
                                 MakeSetting("exact", 1, 10, 0., 1000, 0)};
  settings[2].m_nConfirmationContacts = 95000;
  settings[1].m_nConfirmationContacts = 99000;
  settings[1].m_nConfirmationTunneled = 1; // lost in the proof
  const auto answers = MakeRecommendations(settings, 100000);
  using CNumbers = std::vector<std::size_t>;
  using CNames = std::vector<std::string>;
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0].m_sDemand, "Bounces within 0.6 degrees (.01 rad), fewer than 1 in 100 lost");
  EXPECT_EQ(answers[0].m_stdChoices, (CNumbers{1, 2}));
  EXPECT_TRUE(answers[0].m_stdWithout.empty());
  EXPECT_EQ(answers[1].m_stdChoices, (CNumbers{3}));
  EXPECT_EQ(answers[1].m_stdWithout, (CNames{"native-approximate"}));
  EXPECT_EQ(answers[2].m_sDemand, "None lost in 100,000 impacts");
  EXPECT_EQ(answers[2].m_stdChoices, (CNumbers{2}));
  EXPECT_FALSE(answers[2].m_nClosest);
  const auto none = MakeRecommendations({MakeSetting("native", 1, 1000, .5, 1000, 500)}, 10)[0];
  EXPECT_TRUE(none.m_stdChoices.empty());
  EXPECT_EQ(none.m_nClosest, 0u);
}

TEST(WorkPrecision, TheWorldByDefaultComesFirstWhereNoneIsFasterThanCanBeTold) {
  std::vector<CSetting> settings{MakeSetting("native", 1, 2050, .001, 1000, 0),
                                 MakeSetting("native-approximate", 1, 2000, .001, 1000, 0)};
  const auto first = [&] { return MakeRecommendations(settings, 1000)[0].m_stdChoices.at(0); };
  EXPECT_EQ(first(), 1u); // the control: intervals without width
  settings[0].m_cNsPerBallSecond.m_cInterval = {1990, 2100};
  EXPECT_EQ(first(), 0u);
}

TEST(WorkPrecision, SmallErrorsAloneDoNotMakeASettingGood) { // it loses every second ball
  EXPECT_TRUE(
      MakeRecommendations({MakeSetting("native", 1, 1000, 1e-6, 1000, 500)}, 10)[1].m_stdChoices.empty());
}

// On a small ladder: substeps make native exact where it lost half of the balls, and cost more.
TEST(WorkPrecision, SubstepsBuyPrecisionWithTime) {
  const CScene scene = LoadScene(SHAPES_SCENES_DIR "/head_on_wall.json");
  std::vector<CEngine> ladder = GetEngines();
  ladder.push_back(ladder[Tests::g_nApproximate]);
  ladder.back().m_nSubsteps = 8;
  CParameterSweepOptions options;
  options.m_nContacts = 300;
  options.m_nMostTrials = 6000;
  options.m_nConfirmation = 1000;
  options.m_nBallSteps = 2000;
  options.m_nRepeats = 7;
  double last = 0.0;
  options.m_stdProgress = [&](double done) {
    EXPECT_GE(done, 0.0);
    EXPECT_LE(done, 1.0);
    last = done;
  };
  const CWorkPrecision work = MeasureWorkPrecision(scene, ladder, options);
  EXPECT_EQ(last, 1.0);
  ASSERT_EQ(work.m_stdSettings.size(), 6u);
  const CSetting &one = work.m_stdSettings[Tests::g_nApproximate],
                 &box2d = work.m_stdSettings[Tests::g_nBox2D];
  const CSetting &eight = work.m_stdSettings[4], &exact = work.m_stdSettings[5];
  EXPECT_GT(one.m_nTunneled, one.m_nContacts / 3);
  EXPECT_EQ(eight.m_nTunneled, 0u);
  EXPECT_EQ(box2d.m_nTunneled, 0u);
  // What is lost goes the wrong way, however exact the others are.
  EXPECT_GT(one.m_fDirectionErrorP95.value(), 3.0);
  EXPECT_LT(eight.m_fDirectionErrorP95.value(), 1e-3);
  EXPECT_EQ(eight.m_nContacts, 300u);
  EXPECT_GE(eight.GetAllContacts(), 1000u); // the proof; a setting that has lost balls gets none
  EXPECT_EQ(one.GetAllContacts(), 300u);
  EXPECT_GT(eight.m_cNsPerBallSecond.m_fMedian, one.m_cNsPerBallSecond.m_fMedian);
  EXPECT_GT(exact.m_cNsPerBallSecond.m_fMedian, 0.0);
  EXPECT_EQ(exact.m_cEngine.m_sName, g_sExact);
  EXPECT_EQ(work.m_stdRecommendations.size(), 3u);
}

} // namespace
} // namespace Shapes::Compare
