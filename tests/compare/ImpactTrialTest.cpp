// SPDX-License-Identifier: MIT
// Single contacts whose figures follow from geometry, and what counts as an answer to an impact, where it is
// easy to take another response for it.
#include "MadeScenes.h"
#include "metrics/Totals.h"

namespace Shapes::Compare::Tests {
namespace {

constexpr double g_fRadius = 0.1, g_fStep = 1.0 / 60.0, g_fPairSpeed = 0.3 * g_fRadius / g_fStep;
constexpr std::size_t g_nRestartContacts = 400;

// Positions of size 1 in float, in radii, and some of them added up.
constexpr double g_fRounding = 8 * 1.2e-7 / g_fRadius;

// A ball that flies `normal` and `along` radii a step at and along the wall x = 0.
CScene AtWall(double normal, double along, float e = 1.0f) {
  const Vector2d v = g_fRadius / g_fStep * Vector2d(normal, along);
  return MakeScene(5, 1, {CLineSegDesc({0, -4}, {0, 4}, e)},
                   {CDynamicCircleDesc({-1, -0.5f}, static_cast<float>(g_fRadius), v.cast<float>())});
}

// The rest of the step after the impact, as a share.
double Rest(const CContact& c) { return 1.0 - Wide(c.m_fTime); }

// Too close to where the answer changes for float to tell.
bool IsClose(double x, double edge) { return std::abs(x - edge) < 1e-4; }

// The exact ball comes back from the wall for the rest of the step; native leaves it at the wall. A ball that
// is pushed through is claimed to have been on the far side: two radii too far, and too late by the time that
// it takes to fly them; there it is free.
TEST(ImpactTrialTest, HeadOnFiguresOfNativeFollowFromThePhase) {
  for (const auto& [length, e] :
       {std::pair(0.7, 1.0f), {1.5, 1.0f}, {1.5, 0.5f}, {1.8, 1.0f}, {2.0, 0.5f}, {4.0, 1.0f}}) {
    SCOPED_TRACE(length);
    std::map<eOutcome, std::size_t> seen;
    const CImpactTrialResult result = Judge(AtWall(length, 0, e), g_nRestartContacts);
    ASSERT_EQ(result.m_stdContacts.size(), g_nRestartContacts);
    for (const CContact& contact : result.m_stdContacts) {
      // Where the centre ends, in radii behind the wall: native sees it between -1 and 1, and takes the side.
      const double end = Rest(contact) * length - 1;
      if (IsClose(end, 0) || IsClose(end, 1)) continue;
      const eOutcome expected = end < 0   ? eOutcome::Correct
                                : end < 1 ? eOutcome::WrongSide
                                          : eOutcome::Missed;
      const CEngineContact& c = contact.m_stdEngines[g_nApproximate];
      ASSERT_EQ(c.m_eOutcome, expected) << end;
      EXPECT_EQ(c.m_bCompared, expected == eOutcome::Correct);
      ++seen[expected];
      if (expected != eOutcome::Missed) {
        EXPECT_NEAR(c.m_fPenetration, 0.0, g_fRounding);
      }
      if (expected == eOutcome::Correct) {
        EXPECT_NEAR(c.m_fPositionError, Wide(e) * length * Rest(contact), 3 * g_fRounding);
        EXPECT_EQ(c.m_fDirectionError, 0.0f);
        EXPECT_NEAR(c.m_fSpeedError, 0.0, 2.4e-7);
        EXPECT_NEAR(c.m_fEnergyError, 0.0, 4.8e-7);
        EXPECT_EQ(c.m_fNormalError, 0.0f);
      } else if (expected == eOutcome::WrongSide) {
        EXPECT_NEAR(c.m_fSetbackError, 2.0, g_fRounding);
        EXPECT_NEAR(c.m_fSetbackErrorNormal, -2.0, g_fRounding);
        EXPECT_NEAR(c.m_fTimeError, 2.0 / length, g_fRounding);
      }
      // The control: Box2D sweeps. Where its wall, which lies up to .01 farther in, is reached in the next
      // step only, it is late.
      const eOutcome box2d = contact.m_stdEngines[g_nBox2D].m_eOutcome;
      EXPECT_TRUE(box2d == eOutcome::Correct || (box2d == eOutcome::Late && Rest(contact) * length < 0.11))
          << end;
    }
    EXPECT_EQ(seen.size(), length < 1 ? 1u : length < 3 ? 2u : 3u);
    for (const auto& [outcome, count] : seen)
      EXPECT_GT(count, g_nRestartContacts / 5) << GetName(outcome);
  }
}

// At a slant native looks straight at the wall from where the ball is at the end of the step, and so is off
// by what the ball has flown along the wall since the impact.
TEST(ImpactTrialTest, ContactsAreDescribedAndTheSetbackErrorOfNativeAtASlantIsAlongTheWall) {
  const CImpactTrialResult result = Judge(AtWall(0.9, 1.2), g_nRestartContacts);
  ASSERT_EQ(result.m_stdContacts.size(), g_nRestartContacts);
  EXPECT_EQ(result.m_nTrials, g_nRestartContacts); // one impact in each
  for (std::size_t i = 0; i < g_nRestartContacts; ++i) {
    const CContact& contact = result.m_stdContacts[i];
    EXPECT_EQ(contact.m_nTrial, i);
    EXPECT_EQ(contact.m_nBall, 0u);
    EXPECT_EQ(contact.m_ePair, ePair::Segment);
    EXPECT_NEAR(contact.m_fTravel, 1.5, 1e-6); // 3, 4, 5
    EXPECT_NEAR(contact.m_fApproach, 5.4, 1e-5);
    EXPECT_NEAR(contact.m_fIncidence, std::acos(0.6), 1e-6);
    EXPECT_TRUE(contact.m_fTime >= 0.0f && contact.m_fTime <= 1.0f);
    // From x = -1 + phase to x = -r at .09 a step.
    EXPECT_TRUE(contact.m_nStep >= 8u && contact.m_nStep <= 10u);
    const CEngineContact& c = contact.m_stdEngines[g_nApproximate];
    ASSERT_TRUE(c.m_bDetected);
    const double rest = Rest(contact), slid = 1.2 * rest;
    EXPECT_NEAR(c.m_fSetback, 0.9 * rest, g_fRounding);
    EXPECT_NEAR(c.m_fSetbackError, slid, g_fRounding);
    EXPECT_NEAR(c.m_fSetbackErrorNormal, 0.0, g_fRounding);
    EXPECT_NEAR(c.m_fTimeError, slid * 1.2 / (1.5 * 1.5), g_fRounding);
    EXPECT_NEAR(c.m_fPOIError, slid, g_fRounding);
    EXPECT_EQ(c.m_fNormalError, 0.0f);
    EXPECT_NEAR(c.m_fDirectionError, 0.0, 4e-7);
    // Straight ahead it is right, so only what was lost across the wall is an error of the position.
    EXPECT_NEAR(c.m_fPositionError, 0.9 * rest, 3 * g_fRounding);
    // The control: Box2D sweeps along the way, and is off by its slop of at most .1 radii across the wall.
    const CEngineContact& b = contact.m_stdEngines[g_nBox2D];
    ASSERT_TRUE(b.m_bDetected);
    EXPECT_LE(std::abs(b.m_fSetbackErrorNormal), 0.101f);
    EXPECT_LE(b.m_fSetbackError, 0.101f * 1.5f / 0.9f);
    EXPECT_NEAR(contact.m_fDifference, Wide(c.m_fSetbackError), 0.17);
  }
}

// Two balls of these masses that come to each other at .3 radii a step each, aside by `aside`.
CScene TwoBalls(float m0, float e0, float m1, float aside) {
  const float v = static_cast<float>(g_fPairSpeed), r = static_cast<float>(g_fRadius);
  return MakeScene(
      5, 1, {},
      {CDynamicCircleDesc({-0.5f, 0}, r, {v, 0}, m0, e0), CDynamicCircleDesc({0.5f, aside}, r, {-v, 0}, m1)});
}

// Box2D sweeps no two balls: those that meet within a step are seen at the beginning of the next one. Until
// then they are in each other by all that they flew since.
TEST(ImpactTrialTest, Box2DAnswersTwoBallsAStepLate) {
  const CImpactTrialResult result = Judge(TwoBalls(2, 1, 1, 0), g_nRestartContacts);
  ASSERT_EQ(result.m_stdContacts.size(), g_nRestartContacts);
  for (const CContact& contact : result.m_stdContacts) {
    EXPECT_EQ(contact.m_ePair, ePair::Ball);
    EXPECT_NEAR(contact.m_fApproach, 2 * g_fPairSpeed, 1e-5);
    const auto &native = contact.m_stdEngines[g_nApproximate], &box2d = contact.m_stdEngines[g_nBox2D];
    if (!IsClose(Rest(contact), 0)) {
      EXPECT_EQ(native.m_eOutcome, eOutcome::Correct);
      EXPECT_EQ(box2d.m_eOutcome, eOutcome::Late);
      EXPECT_TRUE(native.m_bCompared && box2d.m_bCompared);
      EXPECT_GT(box2d.m_fPositionError, 0.0f);
    }
    EXPECT_NEAR(box2d.m_fDirectionError, 0.0, 1e-6); // at the end of the step in which it has answered
    EXPECT_NEAR(box2d.m_fEnergyError, 0.0, 1e-6);
    EXPECT_NEAR(box2d.m_fPenetration, 0.6 * Rest(contact), 2 * g_fRounding);
    EXPECT_NEAR(native.m_fPenetration, 0.0, 2 * g_fRounding);
    EXPECT_NEAR(native.m_fDirectionError, 0.0, 1e-6);
    EXPECT_NEAR(native.m_fEnergyError, 0.0, 1e-6); // of both
  }
}

// Energy of two balls is that of both: a ball of elasticity .5 loses some, which is no error.
TEST(ImpactTrialTest, EnergyOfAPairIsOfBoth) {
  bool differs = false;
  for (const CContact& contact : Judge(TwoBalls(3, 0.5f, 1, 0.1f), g_nRestartContacts).m_stdContacts) {
    const CEngineContact& c = contact.m_stdEngines[g_nApproximate];
    EXPECT_EQ(contact.m_fElasticity, 0.5f);
    if (!c.m_bCompared) continue;
    // The normal of native is off here, so what goes where differs. With d = the angle between the normals,
    // each response takes (1 - e^2)/2 of the reduced mass times the approach along its own normal squared.
    const double approach = Wide(contact.m_fApproach), all = 0.5 * 4.0 * g_fPairSpeed * g_fPairSpeed;
    const double incidence = Wide(contact.m_fIncidence), d = Wide(c.m_fNormalError);
    const double loss = 0.5 * 0.75 * 0.75; // reduced mass 3/4
    const double exact = all - loss * approach * approach;
    const auto engine = [&](double angle) {
      const double along = approach / std::cos(incidence) * std::cos(angle);
      return (all - loss * along * along) / exact - 1.0;
    };
    const double nearer = std::min(std::abs(engine(incidence + d) - Wide(c.m_fEnergyError)),
                                   std::abs(engine(incidence - d) - Wide(c.m_fEnergyError)));
    EXPECT_NEAR(nearer, 0.0, 2e-5);
    differs |= std::abs(c.m_fEnergyError - c.m_fSpeedError) > 1e-3f;
  }
  EXPECT_TRUE(differs); // the control: it is not the ball's alone
}

TEST(ImpactTrialTest, EveryPairHasItsName) {
  const auto first = [](const CAnyShapeDesc& shape, const Vector2& from, const Vector2& v) {
    CScene scene = MakeScene(5, 2, {shape}, {CDynamicCircleDesc(from, static_cast<float>(g_fRadius), v)});
    const CImpactTrialResult result = Judge(scene, 1);
    return result.m_stdContacts.empty() ? std::string("none") : GetName(result.m_stdContacts[0].m_ePair);
  };
  const CLineSegDesc segment({-1, 0}, {1, 0});
  const CArcDesc arc({0, 0}, 1, 0, g_fPi);
  EXPECT_EQ(first(CPointDesc({0, 0}), {0, 2}, {0, -3}), "point");
  EXPECT_EQ(first(segment, {0, 2}, {0, -3}), "segment");
  EXPECT_EQ(first(segment, {-3, 0}, {3, 0}), "segment end");
  EXPECT_EQ(first(CCircleDesc({0, 0}, 1), {0, 2}, {0, -3}), "circle");
  EXPECT_EQ(first(arc, {0, 2}, {0, -3}), "arc");
  EXPECT_EQ(first(arc, {1, -2}, {0, 3}), "arc end");
  EXPECT_STREQ(GetName(eOutcome::WrongSide), "wrong side"); // the other outcomes: CsvTest
}

constexpr float g_fBallRadius = 0.05f;
constexpr std::size_t g_nJudgeContacts = 2000;

// The ball flies to the right by this many radii per step.
CDynamicCircleDesc Flying(const Vector2& p, float radii) {
  return {p, g_fBallRadius, {radii * g_fBallRadius * 60, 0}};
}

// Head-on at 6 radii a step: tunneled 1 - 1/6, missed 1 - 2/6. The floor, which answers in every step, is no
// answer to the wall or the point. A point has no side that could be wrong; a ball that got into a ring
// unseen is turned back by its far side a step later, with the right normal.
TEST(ImpactEvaluatorTest, AnotherResponseIsNoAnswerToWhatWasMissed) {
  const CLineSegDesc floor({-3, 0}, {3, 0}, 0.0f);
  const CDynamicCircleDesc rolling = Flying({-1, g_fBallRadius}, 6);
  const CScene behindWall =
                   MakeScene(3, 0.1f, {floor, CLineSegDesc({0, -0.01f}, {0, 1})}, {rolling}, {0, -10}),
               behindPoint =
                   MakeScene(3, 0.1f, {floor, CPointDesc({0, 0.8f * g_fBallRadius})}, {rolling}, {0, -10}),
               inRing = MakeScene(3, 0.12f, {CCircleDesc({0, 0}, 0.35f)}, {Flying({-1.2f, 0}, 6)});
  for (const CScene* pScene : {&behindWall, &behindPoint, &inRing}) {
    const CImpactTrialResult result = Judge(*pScene, g_nJudgeContacts);
    ASSERT_EQ(result.m_stdContacts.size(), g_nJudgeContacts);
    const CTotals native = MakeTotals(result.m_stdContacts, g_nApproximate);
    if (pScene != &behindPoint) {
      EXPECT_TRUE(Holds(native.GetTunneled(), g_nJudgeContacts, 5.0 / 6)) << native.GetTunneled();
    }
    if (pScene == &inRing) continue;
    EXPECT_TRUE(Holds(native.m_nMissed, g_nJudgeContacts, 4.0 / 6)) << native.m_nMissed;
    EXPECT_FALSE(Holds(native.m_nMissed, g_nJudgeContacts, 0)); // as if the floor had answered
  }
}

// The exact ball bounces off the end of a segment, which is open in the approximate mode: there the ball is
// met when its centre is beside the segment, so many steps after the impact.
TEST(ImpactEvaluatorTest, AResponseIsLateForTwoStepsAndMissingThen) {
  const float r = 0.5f, dt = 1.0f / 60;
  for (const auto& [steps, outcome] :
       {std::pair(1.98f, eOutcome::Late), std::pair(3.0001f, eOutcome::Missed)}) {
    const Vector2 v(0.1f / (steps * dt), -0.3f), impact(-0.1f, std::sqrt(r * r - 0.01f));
    const CImpactTrialResult result = Judge(MakeScene(3, 0.2f, {CLineSegDesc({0, 0}, {2, 0})},
                                                      {CDynamicCircleDesc(impact - 3.3f * dt * v, r, v)}),
                                            50);
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
  CScene scene =
      MakeScene(30, 1, {CLineSegDesc({10, -20}, {10, 20})}, {CDynamicCircleDesc({0, 0}, 0.5f, {240, 0})});
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

TEST(ImpactEvaluatorTest, APointBallIsJudgedInFiniteTime) {
  const CScene scene = MakeScene(
      3, 1, {Sided(CLineSegDesc({-1, 0}, {1, 0.3f}), eSides::Front), CLineSegDesc({-2, 1}, {2, 1.1f})},
      {CDynamicCircleDesc({0.1f, -1}, 0, {1, 6})});
  EXPECT_EQ(Judge(scene, 20).m_stdContacts.size(), 20u);
}

} // namespace
} // namespace Shapes::Compare::Tests
