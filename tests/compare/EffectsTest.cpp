// SPDX-License-Identifier: MIT
#include "metrics/Effects.h"

#include "MadeScenes.h"

namespace Shapes::Compare {
namespace {

using Tests::AddBall;
using Tests::AddShape;
using Tests::LoadBundled;
using Tests::MakeScene;

constexpr std::size_t g_nEffectsContacts = 60;

CEffectOptions MakeOptions() {
  CEffectOptions options;
  options.m_nContacts = g_nEffectsContacts;
  options.m_nMostTrials = 20 * g_nEffectsContacts;
  options.m_nRepeats = 5;
  options.m_nBallSteps = 300;
  options.m_stdProgress = [](double) {};
  return options;
}

CEffectCosts Measure(const CScene& scene, const std::string& engine = g_sNative) {
  std::vector<CEngine> engines = GetEngines();
  std::erase_if(engines, [&](const CEngine& e) { return e.m_sName != engine; });
  return MeasureEffects(scene, engines, MakeOptions());
}

const CEffectCost& Get(const CEffectCosts& costs, eEffect e) {
  return costs.m_stdCosts.at(static_cast<std::size_t>(e));
}

std::size_t Lost(const CEffectWorld& world) { return world.m_cTotals.GetTunneled(); }

TEST(EffectsTest, NativeAndBox2DAsItShipsAreMeasuredWithEachEffect) {
  std::size_t calls = 0;
  double last = 0.0;
  CEffectOptions options = MakeOptions();
  options.m_nBallSteps = 50;
  options.m_stdProgress = [&](double done) {
    ++calls;
    EXPECT_GE(done, 0.0);
    EXPECT_LE(done, 1.0);
    last = done;
  };
  const CEffectCosts costs = MeasureEffects(LoadBundled("bowl"), GetEngines(), options);
  ASSERT_EQ(costs.m_stdCosts.size(), 12u);
  EXPECT_GT(calls, g_nEffectsContacts / 2);
  EXPECT_GT(last, 0.5);
  for (std::size_t i = 0; i < 12; ++i) {
    const CEffectCost& cost = costs.m_stdCosts[i];
    EXPECT_EQ(cost.m_sEngine, i < 6 ? "native" : "box2d");
    EXPECT_EQ(cost.m_eEffect, g_stdEffects[i % 6]);
    EXPECT_FALSE(cost.m_sWhy.empty());
    EXPECT_GT(cost.m_cWith.m_cCost.m_cNsPerBallStep.m_fMedian, 0.0);
    EXPECT_GT(cost.m_cWithout.m_cCost.m_cNsPerBallStep.m_fMedian, 0.0);
    EXPECT_FALSE(cost.m_cWith.m_fInstructions.has_value());
  }
  EXPECT_EQ(costs.m_sNotCounted, "only a full run does");
  EXPECT_TRUE(Measure(LoadBundled("bowl"), "box2d-tuned").m_stdCosts.empty());
}

TEST(EffectsTest, WhatAsceneCallsForIsKnownWithTheReason) {
  const CEffectCosts costs = Measure(LoadBundled("pinball"));
  for (const eEffect e : {eEffect::Gravity, eEffect::BallPairs, eEffect::Sensors, eEffect::Events})
    EXPECT_DOUBLE_EQ(std::round(1e6 * Get(costs, e).m_fRuns), 1e6) << GetName(e);
  EXPECT_EQ(Get(costs, eEffect::Gravity).m_sWhy, "gravity is (0, -10), 4 balls");
  // Flippers rest most of the time, and the reason is of a step in which they do not.
  const CEffectCost& kinematics = Get(costs, eEffect::Kinematics);
  EXPECT_GT(kinematics.m_fRuns, 0.05);
  EXPECT_LT(kinematics.m_fRuns, 0.95);
  EXPECT_EQ(kinematics.m_sWhy.find("0 shapes"), std::string::npos) << kinematics.m_sWhy;
  // The control: nothing of it.
  const CEffectCosts none = Measure(LoadBundled("corner"));
  for (const eEffect e : {eEffect::Gravity, eEffect::Kinematics, eEffect::BallPairs, eEffect::Sensors}) {
    EXPECT_EQ(Get(none, e).m_fRuns, 0.0) << GetName(e);
    EXPECT_FALSE(Get(none, e).IsCalledFor());
  }
  EXPECT_EQ(Get(none, eEffect::BallPairs).m_sWhy, "1 solid ball");
}

TEST(EffectsTest, WhatIsNotCalledForChangesNothingAndWhatIsDoes) {
  const CEffectCosts spinner = Measure(LoadBundled("spinner"));
  const CEffectCost& gravity = Get(spinner, eEffect::Gravity);
  EXPECT_EQ(Lost(gravity.m_cWith), Lost(gravity.m_cWithout));
  EXPECT_EQ(gravity.m_cWith.m_cTotals["direction_error"].m_fMax,
            gravity.m_cWithout.m_cTotals["direction_error"].m_fMax);
  const CEffectCost& kinematics = Get(spinner, eEffect::Kinematics);
  EXPECT_EQ(kinematics.m_cWith.m_cTotals.m_nContacts, g_nEffectsContacts);
  EXPECT_GT(kinematics.m_cWithout.m_cTotals["direction_error"].m_fP95,
            1.5 * kinematics.m_cWith.m_cTotals["direction_error"].m_fP95);
}

TEST(EffectsTest, WithoutBallPairsEveryBallIsLost) {
  const CEffectCosts costs = Measure(LoadBundled("ball_on_ball"));
  EXPECT_EQ(Lost(Get(costs, eEffect::BallPairs).m_cWithout), g_nEffectsContacts);
  EXPECT_LT(Lost(Get(costs, eEffect::BallPairs).m_cWith), g_nEffectsContacts / 10);
}

// A ball that drops for t seconds is off by g t^2 / 2 without gravity, and by rounding with it.
TEST(EffectsTest, FlightsWithoutGravityAreAsFarOffAsABallFalls) {
  // falls 3.32 in 48.9 steps
  CScene scene = MakeScene(20, 1, {CLineSegDesc({-1, -3.42f}, {1, -3.42f})},
                           {CDynamicCircleDesc({0, 0}, 0.1f)}, {0, -10});
  const CEffectCost gravity = Get(Measure(scene), eEffect::Gravity);
  const double t = 0.8, r = 0.1;
  ASSERT_GT(gravity.m_cWithout.m_cFlightError.m_nCount, 3u);
  // Looked at after 48 steps: .8 s.
  EXPECT_NEAR(gravity.m_cWithout.m_cFlightError.m_fMedian, 5 * t * t / r, 1e-3);
  EXPECT_LT(gravity.m_cWith.m_cFlightError.m_fMedian, 1e-5);
}

TEST(EffectsTest, WithoutSensorsNoTouchIsToldOfAndWithThemEach) {
  CScene scene = MakeScene(20, 1);
  CLineSegDesc gate({0, -1}, {0, 1});
  gate.m_bIsSensor = true;
  AddShape(scene, gate);
  AddBall(scene, {{-1, 0}, 0.1f, {5, 0}});
  const CEffectCosts costs = Measure(scene);
  EXPECT_GE(costs.m_nTouches, g_nEffectsContacts);
  EXPECT_EQ(Get(costs, eEffect::Sensors).m_cWith.m_nTouchesMissed, 0u);
  EXPECT_EQ(Get(costs, eEffect::Sensors).m_cWithout.m_nTouchesMissed, costs.m_nTouches);
  EXPECT_EQ(Get(costs, eEffect::Gravity).m_cWith.m_nTouchesMissed, 0u);
}

TEST(EffectsTest, WithoutEventsThereIsNothingToJudge) {
  const CEffectCosts costs = Measure(LoadBundled("corner"));
  const CEffectCost& events = Get(costs, eEffect::Events);
  EXPECT_EQ(events.m_cWith.m_cTotals.m_nContacts, g_nEffectsContacts);
  EXPECT_EQ(events.m_cWithout.m_cTotals.m_nContacts, 0u);
  EXPECT_GT(events.m_cWithout.m_cFlightError.m_nCount, 0u); // its balls can be looked at
}

TEST(EffectsTest, WhatTheProgressThrowsEndsIt) {
  struct CStop {};
  CEffectOptions options = MakeOptions();
  options.m_stdProgress = [](double) { throw CStop(); };
  EXPECT_THROW(MeasureEffects(LoadBundled("bowl"), GetEngines(), options), CStop);
}

} // namespace
} // namespace Shapes::Compare
