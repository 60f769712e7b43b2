// SPDX-License-Identifier: MIT
// Long runs: what is kept in which scene, and drifts that are known.
#include "metrics/LongRun.h"
#include "MadeScenes.h"

#include <numbers>

namespace Shapes::Compare::Tests {
namespace {

TEST(LongRunTest, WhatIsKeptDependsOnTheScene) {
  const auto expect = [](const CScene& scene, bool energy, bool freePath, bool centre) {
    const CKept kept = FindKept(scene);
    EXPECT_EQ(kept.m_bEnergy, energy) << scene.m_sName;
    EXPECT_EQ(kept.m_bFreePath, freePath) << scene.m_sName;
    EXPECT_EQ(kept.m_cCentre.has_value(), centre) << scene.m_sName;
  };
  expect(LoadBundled("elastic_drop"), true, false, false);
  expect(LoadBundled("disc_in_square"), true, true, false);
  expect(LoadBundled("bowl"), true, true, true);
  expect(LoadBundled("ball_on_ball"), true, false, false);
  expect(LoadBundled("spinner"), false, false, false);
  expect(LoadBundled("pinball"), false, false, false);

  CScene bowl = LoadBundled("bowl");
  AddShape(bowl, CCircleDesc({0, 0}, 0.25f));
  expect(bowl, true, true, true);
  EXPECT_EQ(*FindKept(bowl).m_cCentre, Vector2(0, 0));
  std::get<CCircleDesc>(bowl.m_stdShapes.back().m_cDesc).m_fElasticity = 0.5f;
  expect(bowl, false, false, true); // hits towards the centre take no angular momentum
  std::get<CCircleDesc>(bowl.m_stdShapes.back().m_cDesc).m_vPos.x() = 0.125f;
  expect(bowl, false, false, false);
  CScene open = LoadBundled("bowl");
  AddShape(open, CArcDesc({0, 0}, 0.5f, 0, 3));
  expect(open, true, true, false); // its ends are not round about the centre
  CScene sensor = LoadBundled("bowl");
  AddShape(sensor, CCircleDesc({0, 0}, 0.25f));
  std::get<CCircleDesc>(sensor.m_stdShapes.back().m_cDesc).m_bIsSensor = true;
  expect(sensor, false, false, true);
}

// A ball between two walls that are D apart for its centre, L a step. Native puts it at the wall at the end
// of the step in which it overlaps, so that every way takes the next whole number of steps above D / L; the
// exact one takes D / L.
TEST(LongRunTest, FreePathOfNativeBetweenWallsIsRoundedUpToSteps) {
  for (const double length : {0.03, 0.047, 0.08}) {
    SCOPED_TRACE(length);
    CScene scene =
        MakeScene(2, 1, {CLineSegDesc({-0.6f, -1}, {-0.6f, 1}), CLineSegDesc({0.6f, -1}, {0.6f, 1})},
                  {CDynamicCircleDesc({0, 0}, 0.1f, {static_cast<float>(60 * length), 0})});
    const auto runs = MeasureLongRuns(scene, GetEngines(), 3, 4000, 1000000);
    ASSERT_EQ(runs.size(), GetEngineRows().size());
    const double steps = 1.0 / length;
    ASSERT_TRUE(runs[g_nApproximate].m_fFreePathError);
    // The first and the last way of each of the 16 trials are cut, each by one in 250 at most.
    EXPECT_NEAR(*runs[g_nApproximate].m_fFreePathError, std::ceil(steps) / steps - 1, 2.0 / 250);
    // Box2D goes on for the rest of the step; its walls are off by .0037 to -.01 each.
    ASSERT_TRUE(runs[g_nBox2D].m_fFreePathError);
    EXPECT_NEAR(*runs[g_nBox2D].m_fFreePathError, 0, 0.02 + 2.0 / 250);
    // Its walls are where they are.
    ASSERT_TRUE(runs[g_nTuned].m_fFreePathError);
    EXPECT_NEAR(*runs[g_nTuned].m_fFreePathError, 0, 2.0 / 250);
    EXPECT_NEAR(*runs[g_nApproximate].m_fEnergyDrift, 0.0, 1e-3); // nothing but signs changes
    EXPECT_EQ(runs[g_nApproximate].m_nBounces, 4000u);
    EXPECT_NEAR(runs[g_nApproximate].m_fSeconds, 4000 * std::ceil(steps) / 60,
                0.01 * runs[g_nApproximate].m_fSeconds);
  }
}

// The approximate mode may lose height until the ball lies there (docs/effects.md): the drift is that of the
// height above the lowest place of the bounds, each bounce for as long as it takes.
TEST(LongRunTest, EnergyIsThatOfTheHeightAboveTheLowestPlace) {
  CScene scene =
      MakeScene(3, 1, {CLineSegDesc({-1, 0}, {1, 0})}, {CDynamicCircleDesc({0, 2}, 0.1f)}, {0, -10});
  const std::vector<CEngine> engines{GetEngines()[g_nApproximate]};
  const CLongRun run = MeasureLongRuns(scene, engines, 3, 400, 100000).at(0);
  const CStart start = MakeStart(scene, 3, 0);
  CGame game(scene, engines[0], start);
  std::vector<double> heights;
  for (auto steps = std::lround(run.m_fSeconds * 60); steps > 0; --steps) {
    game.Step();
    heights.push_back(static_cast<double>(game.GetWorld().GetBallPositions()[0].y()));
  }
  double sum = 0.0, time = 0.0;
  for (std::size_t i = 1; i < heights.size() / 10; ++i)
    if (heights[i - 1] < heights[i] && heights[i] >= heights[i + 1])
      sum += std::pow(heights[i], 1.5), time += std::sqrt(heights[i]);
  const double first = sum / time, last = heights.back();
  ASSERT_NEAR(last, 0.1, 0.01);
  EXPECT_NEAR(run.m_fEnergyDrift.value(), (last - first) / (first + 3.0), 0.05);
}

// Semi-implicit steps keep the energy of an elastic drop; Box2D bounces with the speed to which gravity has
// added in the same step, and gains until it leaves the scene at ten times its height.
TEST(LongRunTest, EnergyOfAnElasticDrop) {
  const auto runs = MeasureLongRuns(LoadBundled("elastic_drop"), GetEngines(), 1, 1000, 1000000);
  ASSERT_TRUE(runs[g_nApproximate].m_fEnergyDrift && runs[g_nBox2D].m_fEnergyDrift);
  EXPECT_EQ(runs[g_nApproximate].m_nBounces, 1000u);
  // 2 m in 1.25 s: documented as .0035 of the height in 300 s, that is 240 bounces.
  EXPECT_NEAR(*runs[g_nApproximate].m_fEnergyDrift, 0.0, 0.0035 / 240 * 1000);
  EXPECT_LT(runs[g_nBox2D].m_nBounces, 1000u); // it has left
  EXPECT_GT(*runs[g_nBox2D].m_fEnergyDrift, 1.0);
  EXPECT_FALSE(runs[g_nApproximate].m_fFreePathError);
  EXPECT_FALSE(runs[g_nApproximate].m_fAngularMomentumDrift);
}

// In a bowl native sets the ball back towards the centre after it has flown on along the wall: its place is
// nearer to the tangent through the centre, and angular momentum is lost at every bounce.
TEST(LongRunTest, AngularMomentumInABowl) {
  CScene scene = LoadBundled("bowl");
  scene.m_stdBalls[0].m_fTurn = 0;
  scene.m_stdBalls[0].m_cDesc.m_vPos = {0.5f, 0};
  const auto runs = MeasureLongRuns(scene, GetEngines(), 1, 100, 100000);
  ASSERT_TRUE(runs[g_nApproximate].m_fAngularMomentumDrift && runs[g_nBox2D].m_fAngularMomentumDrift);
  EXPECT_NE(*runs[g_nApproximate].m_fAngularMomentumDrift, 0.0);
  EXPECT_NEAR(*runs[g_nApproximate].m_fEnergyDrift, 0.0, 1e-2);
  // The control: finer steps lose less.
  std::vector<CEngine> fine = {GetEngines()[g_nApproximate]};
  fine[0].m_nSubsteps = 16;
  const auto finer = MeasureLongRuns(scene, fine, 1, 100, 100000);
  EXPECT_LT(std::abs(*finer[0].m_fAngularMomentumDrift),
            0.5 * std::abs(*runs[g_nApproximate].m_fAngularMomentumDrift));
}

TEST(LongRunTest, WhereLittleHappensThereIsNoFigure) {
  for (const char* pName : {"head_on_wall", "ball_on_ball", "corner"}) {
    for (const CLongRun& run : MeasureLongRuns(LoadBundled(pName), GetEngines(), 1, 1000, 100000)) {
      EXPECT_LT(run.m_nBounces, 100u);
      EXPECT_LT(run.m_fSeconds, 10.0); // it ends where the ball has left
      EXPECT_FALSE(run.m_fEnergyDrift || run.m_fFreePathError || run.m_fAngularMomentumDrift);
    }
  }
  // A ball that lies still ends the run, too, and one that nothing holds goes on up to the limit.
  CScene still = MakeScene(1, 1, {CLineSegDesc({-1, 0}, {1, 0})}, {CDynamicCircleDesc({0, 0.5f}, 0.1f)});
  EXPECT_EQ(MeasureLongRuns(still, GetEngines(), 1, 10, 1000)[0].m_fSeconds, 0.0);
  still.m_stdBalls[0].m_cDesc.m_vVel = {0, 1e-6f};
  EXPECT_NEAR(MeasureLongRuns(still, GetEngines(), 1, 10, 1000)[0].m_fSeconds, 1000.0 / 60, 1e-3);
}

TEST(LongRunTest, TheSameSeedGivesTheSameBits) {
  const auto run = [](std::uint64_t seed) {
    return MeasureLongRuns(LoadBundled("disc_in_square"), GetEngines(), seed, 1000, 100000);
  };
  const auto a = run(4), b = run(4), c = run(5);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].m_fEnergyDrift, b[i].m_fEnergyDrift);
    EXPECT_EQ(a[i].m_fFreePathError, b[i].m_fFreePathError);
    EXPECT_EQ(a[i].m_fSeconds, b[i].m_fSeconds);
    EXPECT_NE(a[i].m_fFreePathError, c[i].m_fFreePathError);
  }
}

} // namespace
} // namespace Shapes::Compare::Tests
