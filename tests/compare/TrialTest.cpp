// SPDX-License-Identifier: MIT
#include "scene/Trial.h"
#include "MadeScenes.h"

#include <gtest/gtest.h>

namespace Shapes::Compare::Tests {
namespace {

TEST(TrialTest, ADrainedBallStartsAgainAsAtFirst) {
  CScene scene = MakeScene(4, 1);
  scene.m_cWorld.m_vGravity = {0, -10};
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
