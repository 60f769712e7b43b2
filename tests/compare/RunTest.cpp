// SPDX-License-Identifier: MIT
#include "app/Run.h"

#include "SampleReport.h"
#include "scene/Interrupt.h"

namespace Shapes::Compare {
namespace {

constexpr std::size_t g_nRunContacts = 20;

CRunReport RunSome(const std::vector<CScene>& scenes, const std::function<void()>& check) {
  CProgress progress(scenes.size(), false);
  return RunScenes(scenes, GetEngines(), g_cQuickSizes.ForContacts(g_nRunContacts), 1, progress, check);
}

TEST(RunTest, SizesShrinkWithTheContactsAndDoNotGrow) {
  const CRunSizes fewer = g_cFullSizes.ForContacts(g_cFullSizes.m_nContacts / 10);
  EXPECT_EQ(fewer.m_nContacts, g_cFullSizes.m_nContacts / 10);
  EXPECT_EQ(fewer.m_nConfirmation, g_cFullSizes.m_nConfirmation / 10);
  EXPECT_EQ(fewer.m_nSweepContacts, g_cFullSizes.m_nSweepContacts / 10);
  const CRunSizes one = g_cFullSizes.ForContacts(1);
  EXPECT_EQ(one.m_nContacts, 1u);
  EXPECT_GE(one.m_nSweepContacts, 10u);
  EXPECT_GE(one.m_nBallSteps, 500u);
  const CRunSizes more = g_cFullSizes.ForContacts(10 * g_cFullSizes.m_nContacts);
  EXPECT_EQ(more.m_nContacts, 10 * g_cFullSizes.m_nContacts);
  EXPECT_EQ(more.m_nConfirmation, g_cFullSizes.m_nConfirmation);
}

TEST(RunTest, EverythingIsMeasuredOnEachScene) {
  std::size_t checks = 0;
  const CRunReport report = RunSome({LoadBundled("bowl"), LoadBundled("ball_on_ball")}, [&] { ++checks; });
  EXPECT_FALSE(report.m_bInterrupted);
  EXPECT_GT(checks, 100u);
  ASSERT_EQ(report.m_stdScenes.size(), 2u);
  for (const CSceneReport& scene : report.m_stdScenes) {
    SCOPED_TRACE(scene.m_cScene.m_sName);
    EXPECT_EQ(scene.m_cImpactTrials.m_stdContacts.size(), g_nRunContacts);
    EXPECT_GT(scene.m_cDifference.m_nCount, 0u);
    EXPECT_EQ(scene.m_cWork.m_stdSettings.size(), GetParameterSweep().size() + 1);
    EXPECT_FALSE(scene.m_cWork.m_stdRecommendations.empty());
    EXPECT_EQ(scene.m_cHeatMap.m_stdCells.empty(), scene.m_cScene.m_stdBalls.size() != 1);
    EXPECT_EQ(scene.m_stdClips.size(), 1 + GetEngineRows().size());
    ASSERT_EQ(scene.m_stdEngines.size(), GetEngineRows().size());
    for (const CEngineReport& engine : scene.m_stdEngines) {
      EXPECT_EQ(engine.m_cTotals.m_nContacts, g_nRunContacts);
      EXPECT_FALSE(engine.m_stdBins.empty());
      EXPECT_EQ(engine.m_cHistogram.m_stdSetbackError.size(), g_nHistogramBins);
      EXPECT_GT(engine.m_cCost.m_cNsPerBallStep.m_fMedian, 0.0);
      EXPECT_GT(engine.m_cLongRun.m_nBounces, 0u);
    }
  }
}

TEST(RunTest, OneEngineHasNoOtherToBeApartFrom) {
  CProgress progress(1, false);
  const CRunReport report = RunScenes({LoadBundled("bowl")}, {GetEngines()[Tests::g_nBox2D]},
                                      g_cQuickSizes.ForContacts(g_nRunContacts), 1, progress, [] {});
  ASSERT_EQ(report.m_stdScenes.at(0).m_stdEngines.size(), 1u);
  EXPECT_EQ(report.m_stdScenes[0].m_cDifference.m_nCount, 0u);
  for (const CSetting& setting : report.m_stdScenes[0].m_cWork.m_stdSettings)
    EXPECT_NE(setting.m_cEngine.m_sName, "native");
}

TEST(RunTest, AnInterruptKeepsWhatIsFinished) {
  const CScene first = LoadBundled("bowl"), second = LoadBundled("corner");
  std::size_t all = 0;
  RunSome({first}, [&] { ++all; });
  std::size_t checks = 0;
  const CRunReport report = RunSome({first, second}, [&] {
    if (++checks > all) throw CInterrupted();
  });
  EXPECT_TRUE(report.m_bInterrupted);
  ASSERT_EQ(report.m_stdScenes.size(), 1u);
  EXPECT_EQ(report.m_stdScenes[0].m_cScene.m_sName, "bowl");
  // At once: nothing is finished, and that is a report too.
  EXPECT_TRUE(RunSome({first}, [] { throw CInterrupted(); }).m_stdScenes.empty());
}

TEST(RunTest, AnErrorNamesItsScene) {
  CScene scene = LoadBundled("corner");
  scene.m_cWorld.m_fTimeStep = -1.0f;
  const auto run = [&] { RunSome({LoadBundled("bowl"), scene}, [] {}); };
  EXPECT_TRUE(Tests::MessageOf<std::exception>(run).starts_with("corner: "));
}

} // namespace
} // namespace Shapes::Compare
