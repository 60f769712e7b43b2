// SPDX-License-Identifier: MIT
#include "metrics/Instructions.h"

#include "MadeScenes.h"
#include "app/Child.h"
#include "metrics/Effects.h"

#include <chrono>
#include <cstdlib>
#include <fstream>

namespace Shapes::Compare {
namespace {

namespace fs = std::filesystem;
using Tests::LoadBundled;

CEngine MakeAutomatic(std::size_t e) {
  CEngine engine = GetEngines().at(e);
  engine.m_cEffects = g_cAutomatic;
  return engine;
}

// A PATH for as long as this is.
class CPath {
public:
  explicit CPath(const std::string& path) : m_sOld(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  ~CPath() { setenv("PATH", m_sOld.c_str(), 1); }
  CPath(const CPath&) = delete;
  CPath& operator=(const CPath&) = delete;

private:
  std::string m_sOld;
};

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
  const CEngine native = MakeAutomatic(Tests::g_nNative), box2d = MakeAutomatic(Tests::g_nBox2D);
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
  const CEngine native = MakeAutomatic(Tests::g_nNative), box2d = MakeAutomatic(Tests::g_nBox2D);
  const std::vector<CEngine> worlds{native,
                                    native,
                                    WithEffect(native, eEffect::Kinematics, false),
                                    WithEffect(native, eEffect::Gravity, false),
                                    box2d,
                                    box2d};
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
  const std::vector<CEngine> worlds{MakeAutomatic(Tests::g_nNative)};
  CScene scene = LoadBundled("bowl");
  {
    const CPath nowhere("/nowhere");
    EXPECT_EQ(Count(scene, worlds, 5).m_sWhyNot, "valgrind is not there");
  }
  const CTemporaryFolder folder;
  const fs::path fake = folder.GetPath() / "valgrind";
  const auto script = [&](const std::string& text) {
    std::ofstream(fake) << "#!/bin/sh\n" << text << "\n";
    fs::permissions(fake, fs::perms::owner_all);
  };
  const CPath path(folder.GetPath().string() + ":" + std::getenv("PATH"));
  script("echo '==1== Callgrind' >&2; echo 'no such scene' >&2; exit 3");
  EXPECT_EQ(Count(scene, worlds, 5).m_sWhyNot, "valgrind failed with exit code 3: no such scene");
  script("kill -9 $$");
  EXPECT_EQ(Count(scene, worlds, 5).m_sWhyNot, "valgrind failed with signal 9");
  script("exit 0");
  EXPECT_EQ(Count(scene, worlds, 5).m_sWhyNot, "valgrind counted nothing");
  // A scene that was made without a file.
  script("shift; while [ \"$1\" != step-cost ]; do program=$1; shift; done; exec \"$program\" \"$@\"");
  scene.m_cPath = "/nowhere/scene.json";
  EXPECT_EQ(
      Count(scene, worlds, 5).m_sWhyNot.find("valgrind failed with exit code 2: shapes-compare: /nowhere/"),
      0u)
      << Count(scene, worlds, 5).m_sWhyNot;
}

TEST(ChildTest, ProgramsAreFoundOnThePath) {
  EXPECT_TRUE(FindProgram("sh"));
  EXPECT_FALSE(FindProgram("a_program_that_nobody_has"));
  const CPath path(":/nowhere:/usr/bin:/bin");
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
} // namespace Shapes::Compare
