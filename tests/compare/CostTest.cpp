// SPDX-License-Identifier: MIT
#include "metrics/Cost.h"

#include "SampleReport.h"

namespace Shapes::Compare {
namespace {

TEST(CostTest, TimePerContactIsThatOfThePlayBetween) {
  CCost cost;
  cost.m_cNsPerBallStep = {50.0, {45.0, 55.0}};
  cost.m_nBallSteps = 6000;
  EXPECT_FALSE(cost.GetNsPerContact().has_value());
  cost.m_nContacts = 60;
  EXPECT_EQ(cost.GetNsPerContact(), 5000.0);
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
  ASSERT_EQ(costs.size(), 5u);
  for (const CCost& cost : costs) {
    EXPECT_GT(cost.m_cNsPerBallStep.m_fMedian, 0.0);
    EXPECT_GE(cost.m_nBallSteps, 3u * 600u);
    EXPECT_EQ(cost.m_nEscaped + cost.m_nNotFinite, 0u);
    // The disc and the walls are met again and again, about as often by each.
    EXPECT_GT(cost.m_nContacts, 50u);
    EXPECT_NEAR(static_cast<double>(cost.m_nContacts), static_cast<double>(costs[0].m_nContacts),
                0.3 * static_cast<double>(costs[0].m_nContacts));
  }
  ASSERT_EQ(progress.size(), 15u);
  EXPECT_NEAR(progress[0], 1.0 / 15.0, 1e-12);
  EXPECT_NEAR(progress[14], 1.0, 1e-12);
}

TEST(CostTest, WithoutAnythingToMeetThereIsNoTimePerContact) { // the control of the one above
  CScene scene = LoadBundled("disc_in_square");
  scene.m_stdShapes.clear();
  const std::vector<CCost> costs = MeasureCost(scene, GetEngines(), 7, 2, 600);
  for (const CCost& cost : costs) {
    EXPECT_EQ(cost.m_nContacts, 0u);
    EXPECT_FALSE(cost.GetNsPerContact().has_value());
  }
}

TEST(CostTest, WhatTheProgressThrowsEndsIt) {
  struct CStop {};
  EXPECT_THROW(MeasureCost(LoadBundled("bowl"), GetEngines(), 7, 3, 100, [](double) { throw CStop(); }),
               CStop);
}

} // namespace
} // namespace Shapes::Compare
