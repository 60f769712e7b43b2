// SPDX-License-Identifier: MIT
#include "app/Progress.h"

#include <csignal>

#include "MadeScenes.h"
#include "scene/ExactGame.h"
#include "scene/Interrupt.h"

namespace Shapes::Compare {
namespace {

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
  CScene scene = Tests::MakeScene(10.0f, 1.0f);
  Tests::AddBall(scene, CDynamicCircleDesc({0, 0}, 0.1f, {1, 0}));
  const CStart start = MakeStart(scene, 1, 0);
  CGame game(scene, GetEngines()[Tests::g_nNative], start);
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
} // namespace Shapes::Compare
