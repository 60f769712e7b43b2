// SPDX-License-Identifier: MIT
#include "scene/Trial.h"
#include "MadeScenes.h"

#include <numbers>

namespace Shapes::Compare::Tests {
namespace {

TEST(FlipTest, TurnsStaysGoesBackAndRests) {
  const CFlip flip{1.0f, 0.5f, 2.0f, 0.0f}; // pi radians per second: a way takes 1/pi = 0.318 s
  const float rounding = 4.0f * 1.2e-7f;
  EXPECT_EQ(FlipOrientation(flip, 0.0), 0.0f);
  EXPECT_NEAR(FlipOrientation(flip, 0.1), 0.1 * std::numbers::pi, rounding);
  EXPECT_EQ(FlipOrientation(flip, 0.4), 1.0f);
  EXPECT_EQ(FlipOrientation(flip, 0.999), 1.0f);
  EXPECT_NEAR(FlipOrientation(flip, 1.1), 1.0 - 0.1 * std::numbers::pi, rounding);
  EXPECT_EQ(FlipOrientation(flip, 1.4), 0.0f);
  EXPECT_EQ(FlipOrientation(flip, 1.999), 0.0f);

  CFlip mirrored = flip, later = flip;
  mirrored.m_fAngle = -1.0f;
  later.m_fPhase = 0.25f;
  for (int i = -4000; i < 4000; ++i) {
    const double t = i / 1024.0;
    EXPECT_EQ(FlipOrientation(mirrored, t), -FlipOrientation(flip, t));
    EXPECT_EQ(FlipOrientation(flip, t + 2.0), FlipOrientation(flip, t)); // exact: t and the period are binary
    EXPECT_EQ(FlipOrientation(later, t), FlipOrientation(flip, t + 0.25));
    const float step = FlipOrientation(flip, t + 1.0 / 1024.0) - FlipOrientation(flip, t);
    EXPECT_LE(std::abs(step), std::numbers::pi / 1024.0 + rounding)
        << "never faster than its speed, t = " << t;
  }
}

TEST(ShuttleTest, GoesStaysComesBackAndRests) {
  const CShuttle shuttle{{3, -4}, 10.0f, 2.0f, 0.5f}; // a way takes half a second
  const auto expect = [&](double t, double share) {
    EXPECT_NEAR((ShuttleOffset(shuttle, t - 0.5) - share * Eigen::Vector2d(3, -4)).norm(), 0.0, 1e-12) << t;
  };
  expect(0.0, 0.0), expect(0.25, 0.5), expect(0.5, 1.0), expect(0.999, 1.0);
  expect(1.125, 0.75), expect(1.5, 0.0), expect(1.75, 0.0), expect(2.25, 0.5), expect(-1.75, 0.5);
  EXPECT_TRUE(ShuttleOffset({{0, 0}, 1.0f, 1.0f}, 0.3).isZero(0.0));
}

TEST(TrialTest, ADrainedBallStartsAgainAsAtFirst) {
  CScene scene = MakeScene(4, 1, {}, {}, {0, -10});
  CLineSegDesc drain({-3, 0}, {3, 0});
  drain.m_bIsSensor = true;
  AddShape(scene, drain);
  scene.m_stdShapes[0].m_bIsDrain = true;
  AddBall(scene, {{0, 1}, 0.1f, {0.5f, 0}});
  AddBall(scene, {{1, 3}, 0.1f, {-0.5f, 0}}); // falls longer
  const CStart start = MakeStart(scene, 1, 0);
  for (const std::size_t engine : {g_nNative, g_nApproximate, g_nBox2D}) {
    CGame game(scene, GetEngines()[engine], start);
    while (game.GetDrained() == 0)
      game.Step();
    const CWorld& world = game.GetWorld();
    EXPECT_EQ(world.GetBallPositions()[0], start.m_stdBalls[0].m_vPos);
    EXPECT_EQ(world.GetBallVelocities()[0], start.m_stdBalls[0].m_vVel);
    EXPECT_NE(world.GetBallPositions()[1], start.m_stdBalls[1].m_vPos); // the control
    EXPECT_LT(world.GetBallVelocities()[1].y(), -1.0f);
  }
}

} // namespace
} // namespace Shapes::Compare::Tests
