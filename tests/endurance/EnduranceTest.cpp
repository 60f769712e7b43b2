// SPDX-License-Identifier: MIT
// Games that are played for long: 10^5 steps, or as many as SHAPES_ENDURANCE_STEPS says (run.sh). What is
// expected is in docs/testing.md.
#include "Endurance.h"

#include "native/NativeTesting.h"

#include <cstdio>

namespace Shapes::Tests {
namespace {

using namespace Compare;

constexpr std::size_t g_nControlSteps = 20000;
// Vectors that are used for the first time after the first tenth, such as the eight of the solver of piles.
constexpr std::ptrdiff_t g_nLateVectors = 16;
// Vectors of contacts, and of balls that touch, each of which grows where there are more than ever before.
constexpr std::size_t g_nVectorsOfContacts = 48;
// Steps of the pinball table, at least, in which the approximate way loses a ball.
constexpr std::size_t g_nStepsPerEscape = 1000000;
// Standard deviations: by chance in one of 10^6 runs.
constexpr double g_fFarApart = 5.0;

bool KeepsMemory(const CFigures& f) {
  return f.m_nBlocksMore <= g_nLateVectors && f.m_nBytesMore <= static_cast<std::ptrdiff_t>(f.m_nBytes);
}
bool KeepsEnergy(const CFigures& f) { return std::abs(f.m_fEnergyDrift) <= f.m_fEnergyBound; }
bool FliesAsItShould(const CFigures& f) { return std::abs(f.m_fFlightDrift) <= f.m_fFlightBound; }
bool IsAsWarmAsBefore(const CFigures& f) { return f.m_fHalvesApart <= g_fFarApart; }

std::string Text(const CFigures& f) {
  std::string text(1000, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(
      text.data(), text.size(),
      "%zu steps in %.1f s: %zu contacts (%zu of two balls), %zu drained, %zu escaped, fastest %.4g\n"
      "  energy drift %.3g, bound %.3g; flight drift %.3g, bound %.3g; halves %.2f deviations apart\n"
      "  %zu blocks and %zu bytes, %td and %td more; after load %s\n",
      f.m_nSteps, f.m_fSeconds, f.m_nContacts, f.m_nPairContacts, f.m_nDrained, f.m_nEscaped,
      static_cast<double>(f.m_fFastest), f.m_fEnergyDrift, f.m_fEnergyBound, f.m_fFlightDrift,
      f.m_fFlightBound, f.m_fHalvesApart, f.m_nBlocks, f.m_nBytes, f.m_nBlocksMore, f.m_nBytesMore,
      f.m_bSameAfterLoad ? "the same bits" : "other bits")));
  return text;
}

struct CWay {
  const char* m_sName;
  CEffectChoice m_cEffects;
};

class EnduranceTest : public testing::TestWithParam<CWay> {
protected:
  /// Expects what holds for every game.
  CFigures Play(const CScene& scene) const {
    const CFigures f = Endure(scene, GetParam().m_cEffects, HowMany("SHAPES_ENDURANCE_STEPS", 100000));
    std::printf("%s, %s: %s", scene.m_sName.c_str(), GetParam().m_sName, Text(f).c_str());
    EXPECT_TRUE(FliesAsItShould(f)) << Text(f);
    EXPECT_TRUE(KeepsMemory(f)) << Text(f);
    EXPECT_TRUE(f.m_bSameAfterLoad);
    return f;
  }
  CFigures Control(const CScene& scene, const CMeddling& meddling = {}) const {
    return Endure(scene, GetParam().m_cEffects, g_nControlSteps, meddling);
  }
};

INSTANTIATE_TEST_SUITE_P(Native, EnduranceTest,
                         testing::Values(CWay{"approximate", g_cApproximate},
                                         CWay{"continuous", g_cContinuous}),
                         [](const auto& way) { return way.param.m_sName; });

TEST_P(EnduranceTest, PinballGoesOnForever) {
  const CFigures f = Play(LoadBundled("pinball"));
  // Without Continuous a ball at a wall that is hit hard by another one may be set back through the wall.
  const bool sweeps = GetParam().m_cEffects == g_cContinuous;
  EXPECT_LE(f.m_nEscaped, sweeps ? 0 : f.m_nSteps / g_nStepsPerEscape);
  EXPECT_GT(f.m_nDrained, f.m_nSteps / 4000); // it is played, not at rest
  EXPECT_TRUE(IsAsWarmAsBefore(f)) << Text(f);
}

TEST_P(EnduranceTest, BallsInABoxGoOnForever) {
  const CFigures f = Play(MakeBoxOfBalls());
  EXPECT_EQ(f.m_nEscaped, 0u);
  EXPECT_GT(f.m_nPairContacts, f.m_nSteps / 2);
  EXPECT_TRUE(KeepsEnergy(f)) << Text(f);
}

// Controls: what each check is there for, it sees.

TEST_P(EnduranceTest, ALeakIsSeen) {
  std::vector<std::unique_ptr<int>> leaks;
  leaks.reserve(g_nControlSteps);
  const auto leak = [&](CPlayed&, std::size_t i) {
    if (i % 500 == 0) leaks.push_back(std::make_unique<int>());
  };
  const CFigures f = Control(LoadBundled("pinball"), {leak, {}});
  EXPECT_FALSE(KeepsMemory(f)) << Text(f);
}

TEST_P(EnduranceTest, AMissingWallIsSeen) {
  CScene pinball = LoadBundled("pinball"), box = MakeBoxOfBalls();
  std::erase_if(pinball.m_stdShapes, [](const CSceneShape& s) { return s.m_sName == "chute arc"; });
  box.m_stdShapes.pop_back();
  EXPECT_GT(Control(pinball).m_nEscaped, 0u);
  EXPECT_GT(Control(box).m_nEscaped, 0u);
}

TEST_P(EnduranceTest, AStateThatForgetsIsSeen) {
  const CScene scene = LoadBundled("pinball");
  const auto isSame = [&](const std::function<void(CPlayed&)>& forget) {
    return Control(scene, {{}, forget}).m_bSameAfterLoad;
  };
  EXPECT_TRUE(isSame([](CPlayed&) {}));
  EXPECT_FALSE(isSame([](CPlayed& p) { // one bit
    const CShapeId ball = p.GetBalls()[0];
    const Vector2 v = p.GetWorld().GetVel(ball);
    p.GetWorld().SetVel(ball, {v.x(), std::nextafter(v.y(), 100.0f)});
  }));
  EXPECT_FALSE(isSame([](CPlayed& p) { // how a flipper stands
    for (const CShapeId shape : p.GetShapes())
      if (p.GetWorld().GetMotionType(shape) == eMotion::Kinematic) p.GetWorld().SetOrientation(shape, 0.5f);
  }));
}

TEST_P(EnduranceTest, ElasticityThatIsNotQuiteOneIsSeen) {
  CScene scene = MakeBoxOfBalls();
  EXPECT_TRUE(KeepsEnergy(Control(scene)));
  for (CSceneBall& ball : scene.m_stdBalls)
    ball.m_cDesc.m_fElasticity = 1.00002f;
  const CFigures f = Control(scene);
  EXPECT_FALSE(KeepsEnergy(f)) << Text(f);
}

// From step `first` on.
CMeddling Drag(float share, std::size_t first) {
  return {[=](CPlayed& p, std::size_t i) {
            for (const CShapeId ball : p.GetBalls())
              if (i >= first) p.GetWorld().SetVel(ball, (1.0f - share) * p.GetWorld().GetVel(ball));
          },
          {}};
}

TEST_P(EnduranceTest, DragIsSeen) {
  const CScene scene = LoadBundled("pinball");
  const CFigures little = Control(scene, Drag(1e-5f, 0));
  EXPECT_FALSE(FliesAsItShould(little)) << Text(little);
  const CFigures late = Control(scene, Drag(0.03f, g_nControlSteps / 2));
  EXPECT_FALSE(IsAsWarmAsBefore(late)) << Text(late);
}

// Balls that fall through pegs, and are thrown up again.
std::unique_ptr<CWorld> MakePegs(const CEffectChoice& effects) {
  auto pWorld = MakeNative(effects, 10);
  AddBox(*pWorld, {0, 0}, {12, 12});
  for (int i = 1; i < 100; ++i) {
    const Vector2 place(1.2f * static_cast<float>(i % 10), 1.2f * static_cast<float>(i / 10));
    pWorld->Add(CCircleDesc(place, 0.15f));
    pWorld->Add(CDynamicCircleDesc(place + Vector2(0.6f, 0.5f), 0.1f, {0, 0}, 1, 0.5f));
  }
  return pWorld;
}

std::size_t CountAllocationsIn(CWorld& world, int steps) {
  const std::size_t before = CountAllocations();
  for (int i = 0; i < steps; ++i) {
    if (i % 100 == 0)
      for (const CShapeId ball : world.GetBallIds())
        world.SetVel(ball, {1.0f, 9.0f});
    world.Step();
  }
  return CountAllocations() - before;
}

TEST(AllocationTest, StepsOfAWarmWorldMakeNone) {
  for (const CEffectChoice& mode : {g_cAutomatic, g_cApproximate})
    for (const bool pairs : {true, false}) {
      CEffectChoice effects = mode;
      if (!pairs) effects.m_cForbidden.Set(eEffect::BallPairs);
      const auto pWorld = MakePegs(effects);
      EXPECT_GT(CountAllocationsIn(*pWorld, 1000), 10u) << "it was warm before";
      EXPECT_LE(CountAllocationsIn(*pWorld, 1000), g_nVectorsOfContacts);
    }
}

TEST(AllocationTest, ControlOfAVectorInEveryStepIsSeen) {
  const auto pWorld = MakePegs(g_cAutomatic);
  CountAllocationsIn(*pWorld, 1000);
  std::size_t ids = 0, before = CountAllocations();
  for (int i = 0; i < 1000; ++i) {
    pWorld->Step();
    ids += pWorld->GetShapeIds().size();
  }
  EXPECT_GE(CountAllocations() - before, 1000u);
  EXPECT_GT(ids, 0u);
}

} // namespace
} // namespace Shapes::Tests
