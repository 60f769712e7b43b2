// SPDX-License-Identifier: MIT
// Responses to what is not touched: a scene in which Box2D has them, by a mechanism that is known, and
// controls.
#include "metrics/Ghosts.h"
#include "MadeScenes.h"
#include "metrics/ImpactTrials.h"
#include "scene/ExactGame.h"

namespace Shapes::Compare::Tests {
namespace {

// A ball that flies to and fro between two walls, 5 millimetres above a floor of `pieces` segments that are
// joined in a line.
CScene OverFloor(int pieces, float height) {
  CScene scene = MakeScene(4, 10);
  const float width = 4.0f / static_cast<float>(pieces);
  for (int i = 0; i < pieces; ++i) {
    const float x = -2.0f + width * static_cast<float>(i);
    AddShape(scene, CLineSegDesc({x, 0}, {x + width, 0}));
  }
  AddShape(scene, CLineSegDesc({-2, 0.05f}, {-2, 1}));
  AddShape(scene, CLineSegDesc({2, 0.05f}, {2, 1}));
  AddBall(scene, {{0, height}, 0.1f, {3, 0}});
  return scene;
}

CImpactTrialResult JudgeGhosts(const CScene& scene, std::size_t contacts) {
  return Judge(scene, contacts, 10 * contacts, 1);
}

// Box2D's edges have a skin of .01. A ball within it before a joint is nearest to the end of the next edge,
// whose normal leans back: it is braked. That is so while dx^2 + .105^2 < .11^2, dx < .0328, of every .2.
TEST(GhostsTest, JointsOfAFloorBumpABallOnBox2D) {
  const CImpactTrialResult result = JudgeGhosts(OverFloor(20, 0.105f), 600);
  ASSERT_GT(result.m_nQuietSteps, 550u);
  EXPECT_LE(result.m_nQuietSteps, 600u);
  EXPECT_EQ(result.m_stdGhosts[g_nApproximate], 0u);
  const double n = static_cast<double>(result.m_nQuietSteps),
               rate = std::sqrt(0.11 * 0.11 - 0.105 * 0.105) / 0.2;
  EXPECT_NEAR(static_cast<double>(result.m_stdGhosts[g_nBox2D]), n * rate,
              4 * std::sqrt(n * rate * (1 - rate)));
  EXPECT_EQ(result.m_stdGhosts[g_nTuned], 0u); // it knows which pieces are joined
  // The controls: a floor without joints, and a ball outside of the skin.
  for (const CScene& scene : {OverFloor(1, 0.105f), OverFloor(20, 0.112f)}) {
    const CImpactTrialResult none = JudgeGhosts(scene, 300);
    EXPECT_GT(none.m_nQuietSteps, 250u);
    EXPECT_EQ(none.m_stdGhosts[g_nApproximate] + none.m_stdGhosts[g_nBox2D], 0u);
  }
}

// What is farther away than a radius is not passed: only the steps beside the walls are quiet ones.
TEST(GhostsTest, StepsFarFromEverythingAreNotCounted) {
  const CImpactTrialResult near = JudgeGhosts(OverFloor(1, 0.195f), 300),
                           far = JudgeGhosts(OverFloor(1, 0.205f), 300);
  EXPECT_GT(near.m_nQuietSteps, 250u);
  EXPECT_GT(far.m_nQuietSteps, 100u);
  // With 3 m/s, the ball is within a radius of a wall in 4 to 6 of the 76 steps between two impacts.
  CScene lone = OverFloor(1, 0.205f);
  lone.m_stdShapes.erase(lone.m_stdShapes.begin() + 1, lone.m_stdShapes.end());
  EXPECT_EQ(JudgeGhosts(lone, 10).m_nQuietSteps, 0u);
}

// A response that comes before its time is none: Box2D's skin answers the ball a step before it is there.
TEST(GhostsTest, EarlyAnswersAreNoGhosts) {
  // three thousandths a step, so it is in the skin for three
  CScene scene = MakeScene(4, 10, {CLineSegDesc({0, -2}, {0, 2}), CLineSegDesc({-1, -2}, {-1, 2})},
                           {CDynamicCircleDesc({-0.5f, 0}, 0.1f, {0.2f, 0})});
  const CImpactTrialResult result = JudgeGhosts(scene, 300);
  EXPECT_GT(result.m_nQuietSteps, 250u);
  EXPECT_EQ(result.m_stdGhosts[g_nApproximate], 0u);
  // The third step before the impact may still be in the skin: that one is a ghost by definition.
  EXPECT_LT(result.m_stdGhosts[g_nBox2D], 60u);
}

// One step from the start of the scene as it is, with so many impacts before that each quiet step is drawn.
CImpactTrialResult JudgeOneStep(const CScene& scene) {
  const std::vector<CEngine> engines = GetEngines();
  CStart start;
  for (const CSceneBall& ball : scene.m_stdBalls)
    start.m_stdBalls.push_back(ball.m_cDesc);
  CExactGame game(scene, start);
  game.Step();
  CImpactTrialResult result;
  result.m_stdContacts.resize(1000);
  result.m_stdGhosts.assign(engines.size(), 0);
  CGhostHunter(scene, engines).Judge(game, result);
  return result;
}

// Between their surfaces, at the least, in radii; both are counted.
TEST(GhostsTest, TwoBallsPassEachOtherWithinARadius) {
  for (const auto& [gap, quiet] : {std::pair(0.5f, 2u), std::pair(0.95f, 2u), std::pair(1.05f, 0u)}) {
    CScene scene = MakeScene(4, 1, {},
                             {CDynamicCircleDesc({-0.5f, 0}, 0.1f, {60, 0}),
                              CDynamicCircleDesc({0.5f, 0.2f + 0.1f * gap}, 0.1f, {-60, 0})});
    EXPECT_EQ(JudgeOneStep(scene).m_nQuietSteps, quiet) << gap;
  }
}

// In Box2D's skin of .01. The one that comes nearer touches in the next step, the other one in none.
TEST(GhostsTest, WhatIsTouchedInTheNextTwoStepsIsNoGhost) {
  for (const auto& [speed, ghosts] : {std::pair(0.3f, 0u), std::pair(0.01f, 1u)}) {
    CScene scene = MakeScene(4, 1, {CLineSegDesc({0, -2}, {0, 2})},
                             {CDynamicCircleDesc({-0.109f, 0}, 0.1f, {speed, 0})});
    const CImpactTrialResult result = JudgeOneStep(scene);
    EXPECT_EQ(result.m_nQuietSteps, 1u);
    EXPECT_EQ(result.m_stdGhosts[g_nBox2D], ghosts) << speed;
    EXPECT_EQ(result.m_stdGhosts[g_nNative], 0u);
  }
}

TEST(GhostsTest, ResponsesToTwoShapesInAStepAreOneGhost) {
  CScene scene = MakeScene(4, 1, {CLineSegDesc({0, -2}, {0, 2}), CLineSegDesc({-2, 0}, {2, 0})},
                           {CDynamicCircleDesc({-0.109f, 0.109f}, 0.1f, {0.01f, -0.01f})});
  EXPECT_EQ(JudgeOneStep(scene).m_stdGhosts[g_nBox2D], 1u);
}

} // namespace
} // namespace Shapes::Compare::Tests
