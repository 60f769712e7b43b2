// SPDX-License-Identifier: MIT
// The cost of accuracy, and the steps at which balls tunnel.
#include "metrics/WorkPrecision.h"
#include "SampleReport.h"
#include "metrics/Cost.h"
#include "metrics/HeatMap.h"

#include <algorithm>

namespace Shapes::Compare::Tests {
namespace {

TEST(WorkPrecision, TheLadderHasEachSettingOnceAndBeginsWithTheEnginesAsTheyCome) {
  std::set<std::string> labels;
  for (const CEngine& engine : GetParameterSweep()) {
    EXPECT_TRUE(labels.insert(engine.m_sName + ": " + engine.GetLabel()).second) << engine.GetLabel();
    EXPECT_EQ(engine.m_eProfile, GetEngineRow(engine.m_sName).m_eProfile);
    EXPECT_EQ(engine.m_cEffects, GetEngineRow(engine.m_sName).m_cEffects);
  }
  for (const char* pLabel : {"native: as it comes", "native: 2 substeps", "native: 4 substeps",
                             "native: 8 substeps", "native-approximate: 64 substeps", "box2d: as it comes",
                             "box2d: 4 substeps, 10x scale, 1+1 iterations", "box2d-tuned: as it comes",
                             "box2d-tuned: arcs 4x finer"})
    EXPECT_TRUE(labels.contains(pLabel)) << pLabel;
  EXPECT_EQ(labels.size(), 40u + 4u * (GetEngineRows().size() - GetKnownRows().size()));
}

TEST(WorkPrecision, TheFrontIsWhatNothingBeats) {
  std::vector<CSetting> settings{
      MakeSetting({"native", nullptr}, 100, .5, 100, 50), MakeSetting({"native", nullptr}, 200, .1, 100, 0),
      MakeSetting({"box2d", nullptr}, 300, .2, 100, 0),   MakeSetting({"box2d", nullptr}, 400, .05, 100, 1),
      MakeSetting({"box2d", nullptr}, 150, {}, 0, 0),     MakeSetting({"native", nullptr}, 200, .1, 100, 0),
      MakeSetting({"exact", nullptr}, 10, 0., 100, 0)}; // no engine to choose: it beats nobody
  MarkFronts(settings);
  const bool byError[] = {true, true, false, true, false, true, false};
  const bool byMisses[] = {true, true, false, false, false, true, false};
  for (std::size_t i = 0; i < settings.size(); ++i) {
    EXPECT_EQ(settings[i].m_bFrontByError, byError[i]) << i;
    EXPECT_EQ(settings[i].m_bFrontByMisses, byMisses[i]) << i;
  }
}

TEST(WorkPrecision, AnswersAreTheCheapestOfEachEngine) {
  std::vector<CSetting> settings{MakeSetting({"native-approximate", nullptr}, 1000, .5, 1000, 500),
                                 MakeSetting({"native-approximate", nullptr}, 8000, .009, 1000, 0),
                                 MakeSetting({"box2d", nullptr}, 40000, .002, 5000, 0),
                                 MakeSetting({"box2d", nullptr}, 60000, .0005, 500, 0),
                                 MakeSetting({"exact", nullptr}, 10, 0., 1000, 0)};
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
  const auto none = MakeRecommendations({MakeSetting({"native", nullptr}, 1000, .5, 1000, 500)}, 10)[0];
  EXPECT_TRUE(none.m_stdChoices.empty());
  EXPECT_EQ(none.m_nClosest, 0u);
  // Small errors alone do not make a setting good that loses every second ball.
  EXPECT_TRUE(MakeRecommendations({MakeSetting({"native", nullptr}, 1000, 1e-6, 1000, 500)}, 10)[1]
                  .m_stdChoices.empty());
}

TEST(WorkPrecision, TheWorldByDefaultComesFirstWhereNoneIsFasterThanCanBeTold) {
  std::vector<CSetting> settings{MakeSetting({"native", nullptr}, 2050, .001, 1000, 0),
                                 MakeSetting({"native-approximate", nullptr}, 2000, .001, 1000, 0)};
  const auto first = [&] { return MakeRecommendations(settings, 1000)[0].m_stdChoices.at(0); };
  EXPECT_EQ(first(), 1u); // the control: intervals without width
  settings[0].m_cNsPerBallSecond.m_cInterval = {1990, 2100};
  EXPECT_EQ(first(), 0u);
}

// On a small ladder: substeps make native exact where it lost half of the balls, and cost more.
TEST(WorkPrecision, SubstepsBuyPrecisionWithTime) {
  const CScene scene = LoadScene(SHAPES_SCENES_DIR "/head_on_wall.json");
  std::vector<CEngine> ladder = GetEngines();
  ladder.push_back(ladder[g_nApproximate]);
  ladder.back().m_nSubsteps = 8;
  auto options = MakeOptions<CParameterSweepOptions>(300, 6000, 1);
  options.m_nConfirmation = 1000;
  options.m_nBallSteps = 2000;
  options.m_nRepeats = 7;
  double last = 0.0, longest = 0.0;
  options.m_stdProgress = [&](double done) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    longest = std::max(longest, done - last);
    last = done;
  };
  const CWorkPrecision work = MeasureWorkPrecision(scene, ladder, options);
  EXPECT_EQ(last, 1.0);
  EXPECT_LT(longest, 0.1); // the proof goes on before one's eyes, too
  ASSERT_EQ(work.m_stdSettings.size(), ladder.size() + 1);
  const CSetting &one = work.m_stdSettings[g_nApproximate], &box2d = work.m_stdSettings[g_nBox2D];
  const CSetting &eight = work.m_stdSettings[ladder.size() - 1], &exact = work.m_stdSettings.back();
  EXPECT_GT(one.m_nTunneled, one.m_nContacts / 3);
  EXPECT_EQ(eight.m_nTunneled, 0u);
  EXPECT_EQ(box2d.m_nTunneled, 0u);
  // A lost ball goes the wrong way, however exact the others are.
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

TEST(CostTest, CostsAreComparedRepeatByRepeat) {
  // The machine is ten times as slow in half of the repeats: the times overlap, their ratios do not.
  CCost a, b;
  for (int i = 0; i < 12; ++i) {
    const double slow = i % 2 == 0 ? 1.0 : 10.0;
    a.m_stdRepeats.push_back(50.0 * slow);
    b.m_stdRepeats.push_back((100.0 + i) * slow);
  }
  const CMedian ratio = CompareCosts(a, b);
  EXPECT_NEAR(ratio.m_fMedian, 50.0 / 105.0, 0.01);
  EXPECT_LT(ratio.m_cInterval.m_fHigh, 0.5);
  const CInterval ia = MedianWithInterval(a.m_stdRepeats).m_cInterval,
                  ib = MedianWithInterval(b.m_stdRepeats).m_cInterval;
  EXPECT_TRUE(ia.m_fLow < ib.m_fHigh && ib.m_fLow < ia.m_fHigh); // the control
}

TEST(CostTest, EnginesAndTheReferenceTakeTurnsOnTheSameStarts) {
  const CScene scene = LoadBundled("disc_in_square");
  std::vector<CEngine> engines = GetEngines();
  engines.push_back({g_sExact, nullptr});
  std::vector<double> progress;
  const std::vector<CCost> costs =
      MeasureCost(scene, engines, 7, 3, 600, [&](double done) { progress.push_back(done); });
  ASSERT_EQ(costs.size(), engines.size());
  for (const CCost& cost : costs) {
    EXPECT_GT(cost.m_cNsPerBallStep.m_fMedian, 0.0);
    EXPECT_GE(cost.m_nBallSteps, 3u * 600u);
    EXPECT_EQ(cost.m_nEscaped + cost.m_nNotFinite, 0u);
    // The disc and the walls are met again and again, about as often by each.
    EXPECT_GT(cost.m_nContacts, 50u);
    EXPECT_NEAR(static_cast<double>(cost.m_nContacts), static_cast<double>(costs[0].m_nContacts),
                0.3 * static_cast<double>(costs[0].m_nContacts));
  }
  // Without anything to meet, the control, there is no time per contact.
  EXPECT_DOUBLE_EQ(costs[0].GetNsPerContact().value(), costs[0].m_cNsPerBallStep.m_fMedian *
                                                           static_cast<double>(costs[0].m_nBallSteps) /
                                                           static_cast<double>(costs[0].m_nContacts));
  CScene empty = scene;
  empty.m_stdShapes.clear();
  for (const CCost& cost : MeasureCost(empty, GetEngines(), 7, 2, 600)) {
    EXPECT_EQ(cost.m_nContacts, 0u);
    EXPECT_FALSE(cost.GetNsPerContact().has_value());
  }
  const std::size_t turns = 3 * engines.size();
  ASSERT_EQ(progress.size(), turns);
  EXPECT_NEAR(progress[0], 1.0 / static_cast<double>(turns), 1e-12);
  EXPECT_NEAR(progress.back(), 1.0, 1e-12);
}

void Ignore(double) {}

TEST(HeatMap, HeadOnEachCellHoldsTheFormula) { // tunneled max(0, 1 - r / (v dt))
  const CHeatMap map = MeasureHeatMap(LoadBundled("head_on_wall"), GetEngines(), 3, 400, Ignore);
  EXPECT_NEAR(map.m_fTravel, 2.0, 1e-6);
  ASSERT_EQ(map.m_stdCells.size(), map.m_stdSpeeds.size() * map.m_stdSizes.size());
  std::size_t told = 0;
  for (std::size_t i = 0; i < map.m_stdCells.size(); ++i) {
    const double speed = map.m_stdSpeeds[i % map.m_stdSpeeds.size()];
    const double size = map.m_stdSizes[i / map.m_stdSpeeds.size()];
    SCOPED_TRACE("speed " + std::to_string(speed) + ", size " + std::to_string(size));
    const CHeatCell& cell = map.m_stdCells[i];
    ASSERT_EQ(cell.m_nContacts, 400u);
    const double rate = std::max(0.0, 1.0 - size / (map.m_fTravel * speed));
    EXPECT_TRUE(Holds(cell.m_stdTunneled[g_nApproximate], 400, rate))
        << cell.m_stdTunneled[g_nApproximate] << " not " << 400 * rate;
    // The control: with the size of another row the formula does not hold.
    if (rate > 0.2 && rate < 0.8)
      told += !Holds(cell.m_stdTunneled[g_nApproximate], 400, std::max(0.0, 2 * rate - 1));
  }
  EXPECT_GT(told, 3u);
}

TEST(HeatMap, OnlyScenesWithOneBallThatMovesHaveOne) {
  EXPECT_TRUE(MeasureHeatMap(LoadBundled("ball_on_ball"), GetEngines(), 3, 10, Ignore).m_stdCells.empty());
  EXPECT_TRUE(MeasureHeatMap(LoadBundled("elastic_drop"), GetEngines(), 3, 10, Ignore).m_stdCells.empty());
}

} // namespace
} // namespace Shapes::Compare::Tests
