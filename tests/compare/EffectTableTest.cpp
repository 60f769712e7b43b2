// SPDX-License-Identifier: MIT
// What the terminal is told of effects, from figures that are known.
#include "SampleReport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace Shapes::Compare {
namespace {

bool Contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

CEffectCost& Get(CRunReport& report, eEffect e) {
  return report.m_stdScenes[0].m_cEffects.m_stdCosts.at(static_cast<std::size_t>(e));
}

TEST(EffectTableTest, ShowsWhatEachEffectCosts) {
  CRunReport report = MakeSampleReport();
  EXPECT_TRUE(
      Contains(MakeEffectTable(report),
               "spinner\n native              (+20%)       +50%      (+20%)   (+20%)      ~0        +10%\n"))
      << MakeEffectTable(report);
  EXPECT_TRUE(Contains(MakeTable(report), MakeEffectTable(report)));
  SetSampleTimes(Get(report, eEffect::Kinematics).m_cWithout.m_cCost, 100.0 / 15, 1);
  SetSampleTimes(Get(report, eEffect::Gravity).m_cWith.m_cCost, 99.8, 1);
  SetSampleTimes(Get(report, eEffect::Sensors).m_cWith.m_cCost, 98.0, 1);
  EXPECT_TRUE(
      Contains(MakeEffectTable(report),
               "spinner\n native                (~0)        x15      (+20%)    (-2%)      ~0        +10%\n"))
      << MakeEffectTable(report);
}

TEST(EffectTableTest, TellsWhatASavingCosts) {
  CRunReport report = MakeSampleReport();
  const auto changes = [&] { return MakeEffectChanges(report.m_stdScenes[0]); };
  EXPECT_EQ(changes(), std::vector<std::string>{"native without Continuous: loses 50.0% instead of 1.7%."});
  EXPECT_TRUE(Contains(MakeEffectTable(report), "What else changes, at up to 60 impacts (p95 of errors):\n"
                                                "  spinner, native without Continuous: loses 50.0%"));
  Get(report, eEffect::Continuous).m_cWithout.m_cTotals.m_nMissed = 3; // chance
  EXPECT_TRUE(changes().empty());
  EXPECT_FALSE(Contains(MakeEffectTable(report), "What else"));

  CEffectCost& kinematics = Get(report, eEffect::Kinematics);
  kinematics.m_cWithout.m_cFlightError.m_fP95 = 3.0;
  kinematics.m_cWithout.m_cTotals["direction_error"].m_fP95 = 2.0;
  kinematics.m_cWithout.m_cTotals["speed_error"].m_fP95 = 0.1;
  EXPECT_EQ(changes(),
            std::vector<std::string>{
                "native without Kinematics: flies 3.000 radii off to the first impact instead of 0.500, "
                "directions within 2.000 rad instead of 0.020, speeds within 10.0% instead of 0.200%."});
  std::swap(kinematics.m_cWith, kinematics.m_cWithout); // better without it: that costs nothing
  EXPECT_TRUE(changes().empty());
  kinematics.m_fRuns = 0.0; // what becomes better with one that is forced is told
  std::swap(kinematics.m_cWith.m_cTotals, kinematics.m_cWithout.m_cTotals);
  kinematics.m_cWith.m_cFlightError = kinematics.m_cWithout.m_cFlightError;
  kinematics.m_cWith.m_cTotals["speed_error"] = kinematics.m_cWithout.m_cTotals["speed_error"];
  EXPECT_EQ(changes(), std::vector<std::string>{
                           "native with Kinematics: directions within 0.020 rad instead of 2.000."});
}

TEST(EffectTableTest, TellsOfTouchesThatAreMissed) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes[0].m_cEffects.m_nTouches = 50;
  Get(report, eEffect::Continuous).m_cWithout = Get(report, eEffect::Continuous).m_cWith;
  Get(report, eEffect::Kinematics).m_cWithout.m_nTouchesMissed = 50;
  EXPECT_EQ(MakeEffectChanges(report.m_stdScenes[0]),
            std::vector<std::string>{
                "native without Kinematics: misses 100% of the touches of sensors instead of none."});
}

TEST(EffectTableTest, FitsATerminalAndIsEmptyWhereNothingWasMeasured) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes[0].m_cScene.m_sName = std::string(300, 'x') + "\x1b";
  CEffectCosts& costs = report.m_stdScenes[0].m_cEffects;
  for (const CEffectCost& cost : MakeSampleEffects().m_stdCosts) {
    costs.m_stdCosts.push_back(cost);
    costs.m_stdCosts.back().m_sEngine = g_sBox2D;
  }
  for (CEffectCost& cost : costs.m_stdCosts)
    SetSampleTimes(cost.m_cWithout.m_cCost, 0.02, 1);
  std::istringstream lines(MakeEffectTable(report));
  std::size_t n = 0;
  for (std::string line; std::getline(lines, line); ++n) {
    EXPECT_LE(line.size(), 80u) << line;
    EXPECT_FALSE(line.ends_with(' ')) << line;
    EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; })) << line;
  }
  EXPECT_GT(n, 10u);
  costs = {};
  EXPECT_EQ(MakeEffectTable(report), "");
}

} // namespace
} // namespace Shapes::Compare
