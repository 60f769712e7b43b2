// SPDX-License-Identifier: MIT
// Effects cost time, and change results; the instructions that they take are counted by another program.
#include "metrics/Effects.h"
#include "CommandCalls.h"
#include "MadeScenes.h"
#include "metrics/Instructions.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <set>

namespace Shapes::Compare::Tests {
namespace {

constexpr std::size_t g_nEffectsContacts = 60;

CEffectOptions MakeEffectOptions() {
  auto options = MakeOptions<CEffectOptions>(g_nEffectsContacts, 20 * g_nEffectsContacts, 1);
  options.m_nRepeats = 5;
  options.m_nBallSteps = 300;
  options.m_stdProgress = [](double) {};
  return options;
}

CEffectCosts Measure(const CScene& scene, const std::string& engine = g_sNative) {
  return MeasureEffects(scene, OnlyEngine(engine), MakeEffectOptions());
}

const CEffectCost& Get(const CEffectCosts& costs, eEffect e) {
  return costs.m_stdCosts.at(static_cast<std::size_t>(e));
}

std::size_t Lost(const CEffectWorld& world) { return world.m_cTotals.GetTunneled(); }

TEST(EffectsTest, WhatAsceneCallsForIsKnownWithTheReason) {
  const CEffectCosts costs = Measure(LoadBundled("pinball"));
  for (const eEffect e : {eEffect::Gravity, eEffect::BallPairs, eEffect::Sensors, eEffect::Events})
    EXPECT_DOUBLE_EQ(std::round(1e6 * Get(costs, e).m_fRuns), 1e6) << GetName(e);
  EXPECT_EQ(Get(costs, eEffect::Gravity).m_sWhy, "gravity is (0, -10), 4 balls");
  // Flippers rest most of the time, and the reason is of a step in which they do not.
  const CEffectCost& kinematics = Get(costs, eEffect::Kinematics);
  EXPECT_GT(kinematics.m_fRuns, 0.05);
  EXPECT_LT(kinematics.m_fRuns, 0.95);
  EXPECT_FALSE(Says(kinematics.m_sWhy, "0 shapes"));
  // The control: nothing of it.
  const CEffectCosts none = Measure(LoadBundled("corner"));
  for (const eEffect e : {eEffect::Gravity, eEffect::Kinematics, eEffect::BallPairs, eEffect::Sensors}) {
    EXPECT_EQ(Get(none, e).m_fRuns, 0.0) << GetName(e);
    EXPECT_FALSE(Get(none, e).IsCalledFor());
  }
  EXPECT_EQ(Get(none, eEffect::BallPairs).m_sWhy, "1 solid ball");
}

TEST(EffectsTest, OfEachBackendTheFirstIsMeasuredThatLeavesTheChoiceToTheScene) {
  std::set<std::string> measured;
  for (const CEffectCost& cost :
       MeasureEffects(LoadBundled("corner"), GetEngines(), MakeEffectOptions()).m_stdCosts)
    measured.insert(cost.m_sEngine);
  std::set<std::string> names;
  for (const CBackend& backend : GetBackends())
    names.emplace(backend.GetName());
  EXPECT_EQ(measured, names);
  EXPECT_FALSE(Measure(LoadBundled("corner"), "box2d-tuned").m_stdCosts.empty());
  EXPECT_TRUE(Measure(LoadBundled("corner"), g_sNativeApproximate).m_stdCosts.empty());
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

TEST(EffectsTest, WhatIsLostWithoutAnEffectIsToldOf) {
  const CEffectCost pairs = Get(Measure(LoadBundled("ball_on_ball")), eEffect::BallPairs);
  EXPECT_EQ(Lost(pairs.m_cWithout), g_nEffectsContacts);
  EXPECT_LT(Lost(pairs.m_cWith), g_nEffectsContacts / 10);
  // Without events there is nothing to judge, but its balls can be looked at.
  const CEffectCost events = Get(Measure(LoadBundled("corner")), eEffect::Events);
  EXPECT_EQ(events.m_cWith.m_cTotals.m_nContacts, g_nEffectsContacts);
  EXPECT_EQ(events.m_cWithout.m_cTotals.m_nContacts, 0u);
  EXPECT_GT(events.m_cWithout.m_cFlightError.m_nCount, 0u);
  const CEffectCosts costs = Measure(
      MakeScene(20, 1, {Sensor(CLineSegDesc({0, -1}, {0, 1}))}, {CDynamicCircleDesc({-1, 0}, 0.1f, {5, 0})}));
  EXPECT_GE(costs.m_nTouches, g_nEffectsContacts);
  EXPECT_EQ(Get(costs, eEffect::Sensors).m_cWith.m_nTouchesMissed, 0u);
  EXPECT_EQ(Get(costs, eEffect::Sensors).m_cWithout.m_nTouchesMissed, costs.m_nTouches);
  EXPECT_EQ(Get(costs, eEffect::Gravity).m_cWith.m_nTouchesMissed, 0u);
}

namespace fs = std::filesystem;

CEngine MakeAutomatic(std::size_t e) {
  CEngine engine = GetEngines().at(e);
  engine.m_cEffects = g_cAutomatic;
  return engine;
}

#ifdef SHAPES_SANITIZED
constexpr bool g_bHasSanitizer = true;
#else
constexpr bool g_bHasSanitizer = false;
#endif

// Valgrind runs no program that has a memory of its own making.
bool CanCount() { return !g_bHasSanitizer && FindProgram("valgrind").has_value(); }

CInstructions Count(const CScene& scene, const std::vector<CEngine>& worlds, std::size_t steps) {
  return CountInstructions(scene, worlds, SHAPES_COMPARE, 3, steps, [] {});
}

TEST(InstructionsTest, WorldsAreWords) {
  const CEngine native = MakeAutomatic(g_nNative), box2d = MakeAutomatic(g_nBox2D);
  EXPECT_EQ(ToWord(native), "native");
  EXPECT_EQ(ToWord(WithEffect(native, eEffect::BallPairs, true)), "native+BallPairs");
  EXPECT_EQ(ToWord(WithEffect(box2d, eEffect::Events, false)), "box2d~Events");
  for (const CEngine& engine : {native, box2d})
    for (const eEffect e : g_stdEffects)
      for (const bool forced : {true, false}) {
        const CEngine world = WithEffect(engine, e, forced), read = FromWord(ToWord(world));
        EXPECT_EQ(read.m_cEffects, world.m_cEffects);
        EXPECT_EQ(read.m_pBackend, world.m_pBackend);
      }
  EXPECT_EQ(FromWord("native").m_cEffects, g_cAutomatic);
  for (const char* pWord : {"", "native+", "native~Nothing", "jolt", "native+Gravity "})
    EXPECT_THROW(FromWord(pWord), std::invalid_argument) << pWord;
}

TEST(InstructionsTest, TheSameWorldTakesTheSameAndAnEffectThatRunsMore) {
  const CScene scene = LoadBundled("spinner");
  const CEngine native = MakeAutomatic(g_nNative), box2d = MakeAutomatic(g_nBox2D);
  const CEngine still = WithEffect(native, eEffect::Kinematics, false),
                weightless = WithEffect(native, eEffect::Gravity, false);
  const std::vector<CEngine> worlds{native, native, still, weightless, box2d, box2d};
  const CInstructions counted = Count(scene, worlds, 160);
  if (!CanCount()) {
    EXPECT_TRUE(counted.m_sWhyNot.starts_with("valgrind ")) << counted.m_sWhyNot;
    EXPECT_TRUE(counted.m_stdPerBallStep.empty());
    return;
  }
  ASSERT_EQ(counted.m_sWhyNot, "");
  ASSERT_EQ(counted.m_stdPerBallStep.size(), worlds.size());
  const auto& n = counted.m_stdPerBallStep;
  // The search for memory takes up to 1,400 instructions of a world, here .12%.
  EXPECT_NEAR(n[0], n[1], 0.004 * n[0]);
  EXPECT_NEAR(n[0], n[3], 0.004 * n[0]); // forbidden is what does not run anyway
  EXPECT_LT(n[2], 0.8 * n[0]);
  EXPECT_GT(n[2], 10.0);
  EXPECT_NEAR(n[4], n[5], 0.004 * n[4]);
  const CInstructions again = Count(scene, worlds, 160);
  for (std::size_t i = 0; i < n.size(); ++i)
    EXPECT_NEAR(again.m_stdPerBallStep.at(i), n[i], 0.004 * n[i]) << i;
  // Only steps are counted, not what is made before: twice as many take about as many each.
  EXPECT_NEAR(Count(scene, {native}, 320).m_stdPerBallStep.at(0), n[0], 0.3 * n[0]);
}

TEST(InstructionsTest, WhyTheyAreNotCountedIsSaid) {
  const std::vector<CEngine> worlds{MakeAutomatic(g_nNative)};
  CScene scene = LoadBundled("bowl");
  {
    const CPathVariable nowhere("/nowhere");
    EXPECT_EQ(Count(scene, worlds, 5).m_sWhyNot, "valgrind is not there");
  }
  const CTemporaryFolder folder;
  const fs::path fake = folder.GetPath() / "valgrind";
  const CPathVariable path(folder.GetPath().string() + ":" + std::getenv("PATH"));
  scene.m_cPath = "/nowhere/scene.json"; // one that was made without a file, which the last one looks for
  for (const auto& [pScript, pWhy] :
       {std::pair("echo '==1== Callgrind' >&2; echo 'no such scene' >&2; exit 3",
                  "valgrind failed with exit code 3: no such scene"),
        {"kill -9 $$", "valgrind failed with signal 9"},
        {"exit 0", "valgrind counted nothing"},
        {"shift; while [ \"$1\" != step-cost ]; do program=$1; shift; done; exec \"$program\" \"$@\"",
         "valgrind failed with exit code 2: shapes-compare: /nowhere/"}}) {
    std::ofstream(fake) << "#!/bin/sh\n" << pScript << "\n";
    fs::permissions(fake, fs::perms::owner_all);
    const std::string why = Count(scene, worlds, 5).m_sWhyNot;
    EXPECT_TRUE(why.starts_with(pWhy)) << why;
  }
}

TEST(ChildTest, ProgramsAreFoundOnThePath) {
  EXPECT_TRUE(FindProgram("sh"));
  EXPECT_FALSE(FindProgram("a_program_that_nobody_has"));
  const CPathVariable path(":/nowhere:/usr/bin:/bin");
  EXPECT_TRUE(FindProgram("env"));
}

TEST(ChildTest, WhatIsInterruptedIsKilledAtOnce) {
  struct CStop {};
  const CTemporaryFolder folder;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(
      RunProgram({"/bin/sh", "-c", "exec sleep 60"}, folder.GetPath() / "errors", [] { throw CStop(); }),
      CStop);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_EQ(RunProgram({"/bin/sh", "-c", "exit 0"}, folder.GetPath() / "errors", [] {}), ""); // the control
  EXPECT_THROW(RunProgram({"/nowhere/program"}, folder.GetPath() / "errors", [] {}), std::runtime_error);
}

TEST(ChildTest, FoldersAreGoneAfterwards) {
  fs::path path;
  {
    const CTemporaryFolder folder;
    path = folder.GetPath();
    std::ofstream(path / "file") << "text";
    EXPECT_TRUE(fs::exists(path / "file"));
  }
  EXPECT_FALSE(fs::exists(path));
}

} // namespace
} // namespace Shapes::Compare::Tests
