// SPDX-License-Identifier: MIT
// What counts as an answer to an impact, where it is easy to take another response for it.
#include "MadeScenes.h"
#include "metrics/Statistics.h"
#include "metrics/Totals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace Shapes::Compare::Tests {
namespace {

constexpr float g_fBallRadius = 0.05f;
constexpr std::size_t g_nJudgeContacts = 2000;

// The ball flies to the right by this many radii per step.
CDynamicCircleDesc Flying(const Vector2& p, float radii) {
  return {p, g_fBallRadius, {radii * g_fBallRadius * 60, 0}};
}

CImpactTrialResult Judge(const CScene& scene, std::size_t contacts = g_nJudgeContacts) {
  CImpactTrialOptions options;
  options.m_nSeed = 11;
  options.m_nContacts = contacts;
  options.m_nMostTrials = 4 * contacts;
  return RunImpactTrials(scene, GetEngines(), options);
}

// Head-on at 6 radii a step: tunneled 1 - 1/6, missed 1 - 2/6. The floor answers in every step, and is no
// answer to the wall.
TEST(ImpactEvaluatorTest, ARollingBallHasNotAnsweredTheWallThatItMissed) {
  CScene scene = MakeScene(3, 0.1f);
  scene.m_cWorld.m_vGravity = {0, -10};
  CLineSegDesc floor({-3, 0}, {3, 0});
  floor.m_fElasticity = 0.0f;
  AddShape(scene, floor);
  AddShape(scene, CLineSegDesc({0, -0.01f}, {0, 1}));
  AddBall(scene, Flying({-1, g_fBallRadius}, 6));
  const CImpactTrialResult result = Judge(scene);
  ASSERT_EQ(result.m_stdContacts.size(), g_nJudgeContacts);
  const CTotals native = MakeTotals(result.m_stdContacts, g_nApproximate);
  EXPECT_TRUE(Holds(native.GetTunneled(), g_nJudgeContacts, 5.0 / 6)) << native.GetTunneled();
  EXPECT_TRUE(Holds(native.m_nMissed, g_nJudgeContacts, 4.0 / 6)) << native.m_nMissed;
  EXPECT_FALSE(Holds(native.m_nMissed, g_nJudgeContacts, 0)); // as if the floor had answered
}

// A point that the ball passed has no side on which it could be wrong.
TEST(ImpactEvaluatorTest, TheFloorIsNoAnswerToAPointThatTheBallPassed) {
  CScene scene = MakeScene(3, 0.1f);
  scene.m_cWorld.m_vGravity = {0, -10};
  CLineSegDesc floor({-3, 0}, {3, 0});
  floor.m_fElasticity = 0.0f;
  AddShape(scene, floor);
  AddShape(scene, CPointDesc(Vector2(0, 0.8f * g_fBallRadius)));
  AddBall(scene, Flying({-1, g_fBallRadius}, 6));
  const CImpactTrialResult result = Judge(scene);
  ASSERT_EQ(result.m_stdContacts.size(), g_nJudgeContacts);
  const CTotals native = MakeTotals(result.m_stdContacts, g_nApproximate);
  EXPECT_TRUE(Holds(native.m_nMissed, g_nJudgeContacts, 4.0 / 6)) << native.m_nMissed;
}

// The exact ball bounces off the end of a segment, which is open in the approximate mode: there the ball is
// met when its centre is beside the segment, so many steps after the impact.
TEST(ImpactEvaluatorTest, AResponseIsLateForTwoStepsAndMissingThen) {
  const float r = 0.5f, dt = 1.0f / 60;
  for (const auto& [steps, outcome] :
       {std::pair(1.98f, eOutcome::Late), std::pair(3.0001f, eOutcome::Missed)}) {
    CScene scene = MakeScene(3, 0.2f);
    AddShape(scene, CLineSegDesc({0, 0}, {2, 0}));
    const Vector2 v(0.1f / (steps * dt), -0.3f), impact(-0.1f, std::sqrt(r * r - 0.01f));
    AddBall(scene, {impact - 3.3f * dt * v, r, v});
    const CImpactTrialResult result = Judge(scene, 50);
    ASSERT_EQ(result.m_stdContacts.size(), 50u);
    for (const CContact& contact : result.m_stdContacts) {
      EXPECT_EQ(contact.m_ePair, ePair::SegmentEnd);
      EXPECT_EQ(contact.m_stdEngines[g_nApproximate].m_eOutcome, outcome)
          << steps << " steps, impact at " << contact.m_fTime;
    }
  }
}

// Box2D moves nothing by more than 2 metres a step: a ball that wants to go 4 loses half of its speed.
TEST(ImpactEvaluatorTest, ABallThatIsTooSlowHasANegativeError) {
  CScene scene = MakeScene(30, 1);
  AddShape(scene, CLineSegDesc({10, -20}, {10, 20}));
  AddBall(scene, {{0, 0}, 0.5f, {240, 0}});
  std::size_t compared = 0;
  for (const CContact& contact : Judge(scene, 100).m_stdContacts) {
    const CEngineContact& c = contact.m_stdEngines[g_nBox2D];
    if (!c.m_bCompared) continue;
    ++compared;
    EXPECT_NEAR(c.m_fSpeedError, -0.5f, 1e-3f);
    EXPECT_NEAR(c.m_fEnergyError, -0.75f, 1e-3f);
  }
  EXPECT_GT(compared, 10u);
}

// A ball that got into a ring unseen is turned back by its far side a step later, with the right normal.
TEST(ImpactEvaluatorTest, ABallThatIsInARingHasTunneled) {
  CScene scene = MakeScene(3, 0.12f);
  AddShape(scene, CCircleDesc({0, 0}, 0.35f));
  AddBall(scene, Flying({-1.2f, 0}, 6));
  const CImpactTrialResult result = Judge(scene);
  ASSERT_EQ(result.m_stdContacts.size(), g_nJudgeContacts);
  const CTotals native = MakeTotals(result.m_stdContacts, g_nApproximate);
  EXPECT_TRUE(Holds(native.GetTunneled(), g_nJudgeContacts, 5.0 / 6)) << native.GetTunneled();
}

// Of two sides that are met at once, the first that is answered decides where the ball goes: nobody can be
// held against that.
TEST(ImpactEvaluatorTest, TwoSidesAtOnceAreSetAside) {
  CScene scene = MakeScene(3, 1);
  AddShape(scene, CLineSegDesc({-1, 0.25f}, {0, 0}));
  AddShape(scene, CLineSegDesc({0, 0}, {1, 0.25f}));
  AddBall(scene, {{0, 1}, 0.1f, {0, -5}});
  const CImpactTrialResult both = Judge(scene, 20);
  EXPECT_EQ(both.m_cExcluded.m_nSimultaneous, both.m_nTrials);
  scene.m_stdBalls[0].m_cDesc.m_vPos.x() = 0.01f; // the control: one comes first
  const CImpactTrialResult one = Judge(scene, 20);
  EXPECT_EQ(one.m_cExcluded.m_nSimultaneous, 0u);
  EXPECT_EQ(one.m_stdContacts.size(), 20u);
}

TEST(ImpactEvaluatorTest, APointBallIsJudgedInFiniteTime) {
  CScene scene = MakeScene(3, 1);
  CLineSegDesc gate({-1, 0}, {1, 0.3f});
  gate.m_eSides = eSides::Front;
  AddShape(scene, gate);
  AddShape(scene, CLineSegDesc({-2, 1}, {2, 1.1f}));
  AddBall(scene, {{0.1f, -1}, 0, {1, 6}});
  EXPECT_EQ(Judge(scene, 20).m_stdContacts.size(), 20u);
}

TEST(ImpactEvaluatorTest, FlippersGoOnInTheStepsAfterTheImpact) {
  const CScene scene = LoadScene(std::string(SHAPES_SCENES_DIR) + "/pinball.json");
  CTrialWorld world(scene, GetEngines()[g_nApproximate], MakeStart(scene, 1, 0).m_stdBalls, 0.0);
  std::size_t flips = 0, changed = 0;
  for (const double time : {0.0, 0.3, 0.6}) {
    world.Flip(scene, time);
    for (std::size_t i = 0; i < scene.m_stdShapes.size(); ++i) {
      if (!scene.m_stdShapes[i].m_cFlip) continue;
      const float speed =
          RotSpeedAt(scene.m_stdShapes[i], time, static_cast<double>(scene.m_cWorld.m_fTimeStep));
      EXPECT_EQ(world.m_pWorld->GetRotSpeed(world.m_stdShapes[i]), speed);
      ++flips;
      changed += speed != 0.0f;
    }
  }
  EXPECT_GT(changed, 0u);
  EXPECT_LT(changed, flips);
}

} // namespace
} // namespace Shapes::Compare::Tests
