// SPDX-License-Identifier: MIT
// A run over scenes, its progress, and its end by Ctrl-C.
#include "app/Run.h"
#include "SampleReport.h"
#include "app/Progress.h"
#include "metrics/Cost.h"
#include "metrics/Effects.h"
#include "scene/ExactGame.h"
#include "scene/Interrupt.h"

#include <csignal>

namespace Shapes::Compare::Tests {
namespace {

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

// The progress of the other measurements is looked at where those are measured.
TEST(RunTest, TheProgressOfWhatIsMeasuredMayEndIt) {
  const CScene scene = LoadBundled("head_on_wall");
  std::vector<double> shares;
  CImpactTrialOptions trials = MakeOptions(20, 100);
  trials.m_stdProgress = [&](double share) { shares.push_back(share); };
  const CImpactTrialResult result = RunImpactTrials(scene, GetEngines(), trials);
  EXPECT_EQ(result.m_nTrials, shares.size());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
  EXPECT_EQ(Judge(scene, 0, 100).m_nTrials, 0u);
  struct CStop {};
  const auto stop = [](double) { throw CStop(); };
  auto effects = MakeOptions<CEffectOptions>(10, 100, 1);
  effects.m_stdProgress = trials.m_stdProgress;
  shares.clear();
  MeasureEffects(scene, GetEngines(), effects);
  EXPECT_GT(shares.size(), 10u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()) && shares.front() >= 0.0);
  EXPECT_TRUE(shares.back() > 0.5 && shares.back() <= 1.0) << shares.back();
  trials.m_stdProgress = effects.m_stdProgress = stop;
  EXPECT_THROW(RunImpactTrials(scene, GetEngines(), trials), CStop);
  EXPECT_THROW(MeasureEffects(scene, GetEngines(), effects), CStop);
  EXPECT_THROW(MeasureCost(scene, GetEngines(), 7, 3, 100, stop), CStop);
}

TEST(RunTest, BallsThatBox2DHoldsBackAreNamed) {
  CScene scene = LoadBundled("bowl");
  scene.m_cWorld.m_fTimeStep = 0.0625f;
  scene.m_cWorld.m_cBox2D.m_fLengthUnit = 1.0f;
  scene.m_stdBalls[0].m_cDesc.m_vVel = {0.0f, -32.0f};
  EXPECT_EQ(WarnOfSpeed(scene, GetEngines()), "");
  scene.m_stdBalls[0].m_fSpeedSpread = 0.5f;
  EXPECT_NE(WarnOfSpeed(scene, GetEngines()), "");
  scene.m_stdBalls[0].m_cDesc.m_vVel = {0.0f, -64.0f};
  EXPECT_EQ(WarnOfSpeed(scene, GetEngines()),
            "bowl: a ball moves by 6 units in a step, and Box2D moves none by more than 2 length_units (1 "
            "each): set length_unit");
  for (const std::size_t e : {g_nNative, g_nTuned}) // which cuts steps
    EXPECT_EQ(WarnOfSpeed(scene, {GetEngines()[e]}), "");
  scene.m_cWorld.m_cBox2D.m_fLengthUnit = 3.0f;
  EXPECT_EQ(WarnOfSpeed(scene, GetEngines()), "");
}

TEST(RunTest, AnErrorNamesItsScene) {
  CScene scene = LoadBundled("corner");
  scene.m_cWorld.m_fTimeStep = -1.0f;
  CProgress progress(2, false);
  const auto run = [&] {
    RunScenes({LoadBundled("bowl"), scene}, GetEngines(), g_cQuickSizes.ForContacts(20), 1, progress, [] {});
  };
  EXPECT_TRUE(MessageOf<std::exception>(run).starts_with("corner: "));
}

constexpr eStage g_stdAllParts[] = {eStage::ImpactTrials, eStage::ParameterSweep, eStage::Timing,
                                    eStage::HeatMap,      eStage::Effects,        eStage::LongRuns,
                                    eStage::Lasting,      eStage::Replay};

TEST(ProgressTest, PartsFillTheTimeOfASceneInTheirOrder) {
  double last = 0.0;
  for (const eStage part : g_stdAllParts) {
    EXPECT_DOUBLE_EQ(ShareOfScene(part, 0.0), last);
    EXPECT_GT(ShareOfScene(part, 1.0), last);
    EXPECT_EQ(ShareOfScene(part, 7.0), ShareOfScene(part, 1.0));
    last = ShareOfScene(part, 1.0);
  }
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(ProgressTest, TheTimeLeftIsGuessedFromTheTimeSoFar) {
  EXPECT_EQ(ProgressText(2, 15, "pinball", eStage::ImpactTrials, 0.42, 1.0), "3/15 pinball  impacts 42%");
  // Half of the work is done.
  const auto text = [](double seconds) {
    return ProgressText(1, 2, "b", eStage::ImpactTrials, 0.0, seconds);
  };
  EXPECT_EQ(text(6.0), "2/2 b  impacts 0%  a few seconds left");
  EXPECT_EQ(text(42.0), "2/2 b  impacts 0%  about 40 s left");
  EXPECT_EQ(text(130.0), "2/2 b  impacts 0%  about 2 min left");
  EXPECT_EQ(ProgressText(0, 2, "a", eStage::ImpactTrials, 0.0, 99.0),
            "1/2 a  impacts 0%"); // nothing to guess from
}

class CInterruptTest : public testing::Test {
protected:
  CInterruptTest() { sigaction(SIGINT, nullptr, &m_cOld); }
  ~CInterruptTest() override {
    signal(SIGINT, SIG_IGN);
    CatchInterrupt(); // forgets what came
    sigaction(SIGINT, &m_cOld, nullptr);
  }
  struct sigaction m_cOld = {};
};

TEST_F(CInterruptTest, TheFirstIsCaughtTheSecondKills) {
  signal(SIGINT, SIG_DFL);
  CatchInterrupt();
  EXPECT_NO_THROW(CheckInterrupt());
  raise(SIGINT);
  EXPECT_THROW(CheckInterrupt(), CInterrupted);
  EXPECT_THROW(CheckInterrupt(), CInterrupted); // it stays so
  struct sigaction now = {};
  sigaction(SIGINT, nullptr, &now);
  EXPECT_EQ(now.sa_handler, SIG_DFL);
  EXPECT_EXIT(raise(SIGINT), testing::KilledBySignal(SIGINT), "");
}

// So that neither a long trial nor a slow one has to end before.
TEST_F(CInterruptTest, EveryStepOfAGameEndsByIt) {
  const CScene scene = MakeScene(10, 1, {}, {CDynamicCircleDesc({0, 0}, 0.1f, {1, 0})});
  const CStart start = MakeStart(scene, 1, 0);
  CGame game(scene, GetEngines()[g_nNative], start);
  CExactGame exact(scene, start);
  signal(SIGINT, SIG_DFL);
  CatchInterrupt();
  EXPECT_NO_THROW(game.Step());
  EXPECT_NO_THROW(exact.Step());
  raise(SIGINT);
  EXPECT_THROW(game.Step(), CInterrupted);
  EXPECT_THROW(exact.Step(), CInterrupted);
}

TEST_F(CInterruptTest, WhatIsIgnoredStaysIgnored) {
  signal(SIGINT, SIG_IGN);
  CatchInterrupt();
  raise(SIGINT);
  EXPECT_NO_THROW(CheckInterrupt());
}

} // namespace
} // namespace Shapes::Compare::Tests
