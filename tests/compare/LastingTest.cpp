// SPDX-License-Identifier: MIT
// Contact that lasts: figures of scenes in which what has to come out is known.
#include "metrics/Lasting.h"
#include "MadeScenes.h"

namespace Shapes::Compare::Tests {
namespace {

constexpr double g_fDt = 1.0 / 60.0;

CScene MakeLasting(float lasting) {
  CScene scene = MakeScene(4, 1);
  scene.m_fLasting = lasting;
  return scene;
}

CLasting Measure(const CScene& scene, std::size_t engine, int trials = 1) {
  return MeasureLasting(scene, {GetEngines()[engine]}, 1, trials).at(0);
}

TEST(LastingTest, WhatIsNotAskedForIsNotMeasured) {
  CScene scene = MakeLasting(0);
  AddBall(scene, {{0, 0}, 0.1f});
  const CLasting lasting = Measure(scene, g_nNative);
  EXPECT_EQ(lasting.m_nBalls, 0u);
  EXPECT_FALSE(lasting.m_fOverlap || lasting.m_fSpeed || lasting.m_fEnergyGained || lasting.m_fRestTime ||
               lasting.m_fFlow);
}

TEST(LastingTest, BallsOutsideOfTheBoundsAtTheEndAreLostAndAreLookedAtNoMore) {
  CScene scene = MakeLasting(1);
  AddBall(scene, {{0, 0}, 0.1f, {1, 0}});
  AddBall(scene, {{0, 1}, 0.1f, {4.25f, 0}});
  const CLasting lasting = Measure(scene, g_nNative, 3);
  EXPECT_EQ(lasting.m_nBalls, 6u);
  EXPECT_EQ(lasting.m_nLost, 3u);
  EXPECT_EQ(lasting.m_fSpeed, 4.25); // it is lost in the last tenth only
  scene.m_fLasting = 2;
  EXPECT_EQ(Measure(scene, g_nNative).m_fSpeed, 1.0);
}

// The end of a segment is open for the approximate mode: a ball stays in it.
TEST(LastingTest, OverlapsAreInRadiiOfTheSmallerBall) {
  CScene scene = MakeLasting(1);
  AddShape(scene, CLineSegDesc({-1, 0}, {0, 0}));
  AddBall(scene, {{0.03f, 0}, 0.1f});
  EXPECT_NEAR(Measure(scene, g_nApproximate).m_fOverlap.value(), 0.7, 1e-6);
  EXPECT_LT(Measure(scene, g_nNative).m_fOverlap.value(), 1e-5); // the control
  scene.m_stdBalls[0].m_cDesc.m_vPos = {1, 0};
  EXPECT_EQ(Measure(scene, g_nApproximate).m_fOverlap.value(), 0.0);

  AddBall(scene, {{1.25f, 0}, 0.2f});
  std::vector<CEngine> engines = GetEngines();
  engines[g_nApproximate].m_cEffects.m_cForbidden = CEffects::All();
  EXPECT_NEAR(MeasureLasting(scene, {engines[g_nApproximate]}, 1, 1)[0].m_fOverlap.value(), 0.5, 1e-6);
}

// A drop from h lands at t = sqrt(2 h / g), and each bounce takes 2 e^k t, until it is slower than the limit.
TEST(LastingTest, ADropIsAtRestAfterItsLastFastLanding) {
  CScene scene = MakeLasting(6);
  scene.m_cWorld.m_vGravity = {0, -10};
  AddShape(scene, CLineSegDesc({-3, 0}, {3, 0}, 0.5f));
  AddBall(scene, {{0, 1.1f}, 0.1f});
  const double slow = g_fAtRest * 10.0 * g_fDt;
  double time = std::sqrt(0.2), v = 10.0 * time;
  while (0.5 * v > slow)
    v *= 0.5, time += 2.0 * v / 10.0;
  const CLasting lasting = Measure(scene, g_nNative);
  EXPECT_NEAR(lasting.m_fRestTime.value(), time, g_fDt);
  EXPECT_LT(lasting.m_fSpeed.value(), 1e-6);
  EXPECT_LT(lasting.m_fEnergyGained.value(), 1e-6);
  scene.m_fLasting = 1; // the controls: it has not had the time, or does not come to rest
  EXPECT_FALSE(Measure(scene, g_nNative).m_fRestTime);
  scene.m_fLasting = 6;
  std::get<CLineSegDesc>(scene.m_stdShapes[0].m_cDesc).m_fElasticity = 1.0f;
  EXPECT_FALSE(Measure(scene, g_nNative).m_fRestTime);
}

TEST(LastingTest, EnergyFromNothingIsOnlyToldWhereNothingDoesWork) {
  CScene scene = MakeLasting(2);
  AddShape(scene, CLineSegDesc({-3, 0}, {3, 0}));
  AddBall(scene, {{0, 1}, 0.1f});
  EXPECT_FALSE(Measure(scene, g_nNative).m_fEnergyGained); // no gravity, no heights
  scene.m_cWorld.m_vGravity = {0, -10};
  EXPECT_TRUE(Measure(scene, g_nNative).m_fEnergyGained);
  std::get<CLineSegDesc>(scene.m_stdShapes[0].m_cDesc).m_fElasticity = 1.5f;
  EXPECT_FALSE(Measure(scene, g_nNative).m_fEnergyGained);
  // A ball that is set back gains what its weight does on the way: .05 of 4 units above the lowest place.
  CScene deep = MakeLasting(1);
  deep.m_cWorld.m_vGravity = {0, -10};
  AddShape(deep, CLineSegDesc({-3, 0}, {3, 0}, 0.0f));
  AddBall(deep, {{0, 0.05f}, 0.1f});
  EXPECT_NEAR(Measure(deep, g_nApproximate).m_fEnergyGained.value(), 0.05 / 4.05, 1e-3);
  // What another ball loses, which falls by 1 onto the floor, does not make up for it.
  AddBall(deep, {{2, 1.1f}, 0.1f});
  EXPECT_NEAR(Measure(deep, g_nApproximate).m_fEnergyGained.value(), 0.05 / (4.05 + 5.1), 1e-3);
}

TEST(LastingTest, FlowIsBallsPerSecondUntilTheLastOne) {
  CScene scene = MakeLasting(4);
  CLineSegDesc gate({-3, 0}, {3, 0});
  gate.m_bIsSensor = true;
  AddShape(scene, gate);
  for (const float height : {1.1f, 2.1f, 3.1f})
    AddBall(scene, {{height - 2, height}, 0.1f, {0, -1}});
  EXPECT_NEAR(Measure(scene, g_nNative).m_fFlow.value(), 1.0, 2.0 * g_fDt);
  scene.m_fLasting = 0.5f;
  EXPECT_EQ(Measure(scene, g_nNative).m_fFlow.value(), 0.0);
  scene.m_stdShapes.clear();
  EXPECT_FALSE(Measure(scene, g_nNative).m_fFlow);
}

// By default none is lost, however balls are pushed: a jammed row of them has to give way upward, and none is
// shot out of it. The worst of Box2D in trials of the paddle is faster than twelve. Where nothing pushes they
// do not overlap either. The control: balls that are never swept get out of the hourglass.
TEST(LastingTest, NoBundledSceneLosesABallByDefault) {
  for (const CScene& scene : LoadScenes(SHAPES_SCENES_DIR)) {
    const CLasting lasting = Measure(scene, g_nNative);
    EXPECT_EQ(lasting.m_nLost, 0u) << scene.m_sName;
    EXPECT_LT(lasting.m_fSpeed.value_or(0.0), 10.0) << scene.m_sName;
    if (!lasting.m_fEnergyGained) continue;
    EXPECT_LT(lasting.m_fOverlap.value(), 0.002) << scene.m_sName;
    EXPECT_LT(*lasting.m_fEnergyGained, 0.002) << scene.m_sName;
  }
  EXPECT_GT(Measure(LoadBundled("hourglass"), g_nApproximate).m_nLost, 0u);
}

} // namespace
} // namespace Shapes::Compare::Tests
