// SPDX-License-Identifier: MIT
// Some impacts are judged, others set aside, as the options say; and responses to what is not touched: a
// scene in which Box2D has them, by a mechanism that is known, and controls.
#include "MadeScenes.h"
#include "metrics/EngineResponse.h"
#include "metrics/Ghosts.h"
#include "metrics/ImpactTrials.h"
#include "scene/ExactGame.h"

namespace Shapes::Compare::Tests {
namespace {

// In the scene `corner` a ball often meets both walls in one step. Those are not compared at the end of the
// step, where the second impact shows too; counted with another game.
TEST(ImpactTrialRulesTest, OnlyAloneImpactsAreCompared) {
  const CScene scene = LoadBundled("corner");
  const CImpactTrialResult result = Judge(scene, 2000, 2000);
  std::map<std::pair<std::uint64_t, std::uint32_t>, std::size_t> impacts;
  std::size_t alone = 0, notAlone = 0;
  for (const CContact& contact : result.m_stdContacts) {
    CExactGame game(scene, MakeStart(scene, 5, contact.m_nTrial));
    while (game.GetSteps() <= contact.m_nStep)
      game.Step();
    const bool isAlone = game.GetEvents().size() == 1;
    ++(isAlone ? alone : notAlone);
    for (const CEngineContact& c : contact.m_stdEngines) {
      // A late one may have had another impact before the response.
      if (c.m_eOutcome == eOutcome::Late && isAlone) continue;
      ASSERT_EQ(c.m_bCompared, isAlone && c.m_eOutcome == eOutcome::Correct);
    }
    // Of both, only the first is judged.
    const double dt = static_cast<double>(scene.m_cWorld.m_fTimeStep);
    ASSERT_EQ(contact.m_fTime, static_cast<float>(game.GetEvents()[0].m_fTime / dt));
    ++impacts[{contact.m_nTrial, contact.m_nStep}];
  }
  EXPECT_GT(alone, 100u);
  EXPECT_GT(notAlone, 20u);
  for (const auto& [where, count] : impacts)
    EXPECT_EQ(count, 1u);
}

// A ball that bounces out: each of its impacts below 2 g dt is set aside, those above are judged.
TEST(ImpactTrialRulesTest, SlowImpactsAreResting) {
  CScene scene = MakeScene(2, 3, {CLineSegDesc({-1, 0}, {1, 0}, 0.7f)}, {CDynamicCircleDesc({0, 0.6f}, 0.1f)},
                           {0, -9.81f});
  const CImpactTrialResult result = Judge(scene, 1000, 20);
  const float slow = 2 * 9.81f / 60;
  EXPECT_GT(result.m_cExcluded.m_nResting, 20u);
  EXPECT_EQ(result.m_cExcluded.m_nAmbiguous, 0u);
  // From 3.1 m/s it takes 7 impacts to .37.
  EXPECT_GE(result.m_stdContacts.size(), 20u * 5);
  for (const CContact& contact : result.m_stdContacts)
    EXPECT_GT(contact.m_fApproach, slow);
  EXPECT_TRUE(std::any_of(result.m_stdContacts.begin(), result.m_stdContacts.end(),
                          [&](const CContact& c) { return c.m_fApproach < 2 * slow; }));
}

// An impact that rounding or the order of two decides is set aside; one that is off that by a little is
// judged.
TEST(ImpactTrialRulesTest, WhatRoundingOrAnOrderDecidesIsSetAside) {
  const auto expect = [](const std::vector<CAnyShapeDesc>& shapes, const CDynamicCircleDesc& ball,
                         const CDynamicCircleDesc& control, std::size_t CExcluded::*pWhy) {
    const CImpactTrialResult aside = Judge(MakeScene(4, 0.5f, shapes, {ball}), 10, 30),
                             judged = Judge(MakeScene(4, 0.5f, shapes, {control}), 10, 30);
    EXPECT_EQ(aside.m_cExcluded.*pWhy, 30u);
    EXPECT_TRUE(aside.m_stdContacts.empty());
    EXPECT_EQ(judged.m_cExcluded.*pWhy, 0u);
    EXPECT_EQ(judged.m_stdContacts.size(), 10u);
  };
  // It enters a circle by less than the rounding of its way.
  expect({CCircleDesc({0, 0}, 1)}, {{-1, 1.5f}, 0.5f, {3, -1e-9f}}, {{-1, 1.5f}, 0.5f, {3, -0.1f}},
         &CExcluded::m_nAmbiguous);
  // It overlaps at first.
  const CLineSegDesc upright({0, -3}, {0, 3}), level({-3, 0}, {3, 0});
  expect({upright}, {{-0.05f, 0}, 0.1f, {1, 0}}, {{-0.15f, 0}, 0.1f, {1, 0}}, &CExcluded::m_nAmbiguous);
  // Along the diagonal into a right angle, and straight into an obtuse one.
  expect({upright, level}, {{-1, -1}, 0.125f, {4, 4}}, {{-1.01f, -1}, 0.125f, {4, 4}},
         &CExcluded::m_nSimultaneous);
  expect({CLineSegDesc({-1, 0.25f}, {0, 0}), CLineSegDesc({0, 0}, {1, 0.25f})}, {{0, 1}, 0.1f, {0, -5}},
         {{0.01f, 1}, 0.1f, {0, -5}}, &CExcluded::m_nSimultaneous);
}

// A slow approach of a fast ball: it leaves the same way whether it bounces or slides.
TEST(ImpactTrialRulesTest, SlowImpactsAreJudgedWhereRestMakesNoDifference) {
  const auto run = [](float speed, float e) {
    // arrives with .1
    CScene scene = MakeScene(20, 0.5f, {CLineSegDesc({-20, 0}, {20, 0}, e)},
                             {CDynamicCircleDesc({0, 0.1005f}, 0.1f, {speed, 0})}, {0, -9.81f});
    return Judge(scene, 1000, 10);
  };
  const CImpactTrialResult fast = run(6, 0.5f);
  EXPECT_EQ(fast.m_cExcluded.m_nResting, 0u);
  EXPECT_GE(fast.m_stdContacts.size(), 10u);
  for (const CContact& contact : fast.m_stdContacts) {
    EXPECT_LT(contact.m_fApproach, 0.11f);
    for (const CEngineContact& c : contact.m_stdEngines)
      EXPECT_TRUE(c.HasTurnedBack());
  }
  EXPECT_GT(run(6, 1.0f).m_cExcluded.m_nResting, 9u);    // it bounces by .1 / 6 > .01 radians
  EXPECT_GT(run(0.3f, 0.5f).m_cExcluded.m_nResting, 9u); // slow
  EXPECT_EQ(run(0.4f, 0.0f).m_cExcluded.m_nResting, 0u); // nothing bounces
}

// An engine whose ball slides need not report it, but one whose ball flies on has missed it.
TEST(ImpactTrialRulesTest, ASlowImpactThatIsNotAnsweredIsMissed) {
  CScene scene = MakeScene(40, 0.5f, {},
                           {CDynamicCircleDesc({-0.102f, 0}, 0.1f, {0.1f, 20}, 1, 0.5f),
                            CDynamicCircleDesc({0.102f, 0}, 0.1f, {0, 20}, 1, 0.5f)},
                           {0, -9.81f});
  std::vector<CEngine> engines = GetEngines();
  engines[g_nApproximate].m_cEffects.m_cForbidden = {eEffect::BallPairs};
  const CImpactTrialResult result = Judge(scene, 20, 20, 5, engines);
  ASSERT_EQ(result.m_stdContacts.size(), 20u);
  for (const CContact& contact : result.m_stdContacts) {
    EXPECT_LT(contact.m_fApproach, 0.11f);
    EXPECT_EQ(contact.m_stdEngines[g_nApproximate].m_eOutcome, eOutcome::Missed);
    EXPECT_TRUE(contact.m_stdEngines[g_nNative].HasTurnedBack());
  }
}

// A bar sweeps through a box in which a ball has nowhere to go: nobody can say what happens, so it is said
// where it was.
TEST(ImpactTrialRulesTest, WhatTheReferenceGivesUpIsReported) {
  const auto [floor, right, top, left] = Walls({0, 0}, {0.25f, 0.25f});
  CScene scene = MakeScene(2, 2, {floor, right, top, left, Turning(CLineSegDesc({0, 0}, {1, 0}), 1)},
                           {CDynamicCircleDesc({0.12f, 0.13f}, 0.1f, {0.1f, 0})});
  const CImpactTrialResult result = Judge(scene, 100000, 3);
  const CExcluded& aside = result.m_cExcluded;
  EXPECT_EQ(result.m_nTrials, 3u);
  EXPECT_EQ(aside.m_nUndecided, 3u);
  EXPECT_EQ(aside.m_sUndecided.rfind("trial 0, step ", 0), 0u) << aside.m_sUndecided;
  EXPECT_TRUE(Says(aside.m_sUndecided, "ball 0"));
  scene.m_stdShapes.pop_back(); // the control: without the bar
  EXPECT_EQ(Judge(scene, 50, 3).m_cExcluded.m_nUndecided, 0u);
}

// An impact that one engine cannot hold is judged on none.
TEST(ImpactTrialRulesTest, WhatAnEngineRefusesIsReportedAndNotJudged) {
  CScene scene = MakeScene(1, 1e-7f, {CLineSegDesc({0, -1}, {0, 1})},
                           {CDynamicCircleDesc({-0.5f, 0}, 0.1f, {4e9f, 0})}); // Box2D takes 1e9
  scene.m_cWorld.m_fTimeStep = 1e-11f;
  const CImpactTrialResult result = Judge(scene, 10, 5);
  EXPECT_TRUE(result.m_stdContacts.empty());
  EXPECT_EQ(result.m_cExcluded.m_nUndecided, 5u);
  EXPECT_TRUE(Says(result.m_cExcluded.m_sUndecided, "m_vVel"));
  const std::vector<CEngine> native = {GetEngines()[g_nApproximate]}; // the control: it takes them
  EXPECT_EQ(Judge(scene, 10, 20, 5, native).m_stdContacts.size(), 10u);
}

TEST(ImpactTrialRulesTest, OptionsLeaveOutWhatTheySay) {
  const CScene scene = LoadBundled("tangent_joint");
  const CImpactTrialOptions all = MakeOptions(200, 1000);
  CImpactTrialOptions few = all;
  few.m_bAsk = few.m_bGhosts = false;
  const CImpactTrialResult full = RunImpactTrials(scene, GetEngines(), all),
                           lean = RunImpactTrials(scene, GetEngines(), few);
  EXPECT_GT(full.m_nQuietSteps, 100u);
  EXPECT_LE(full.m_nQuietSteps, 200u);
  EXPECT_EQ(lean.m_nQuietSteps, 0u);
  ASSERT_EQ(full.m_stdContacts.size(), 200u);
  ASSERT_EQ(lean.m_stdContacts.size(), 200u);
  std::size_t detected = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_FALSE(lean.m_stdContacts[i].m_bHasDifference);
    for (std::size_t e = 0; e < GetEngines().size(); ++e) {
      const auto &a = full.m_stdContacts[i].m_stdEngines[e], &b = lean.m_stdContacts[i].m_stdEngines[e];
      detected += a.m_bDetected;
      EXPECT_FALSE(b.m_bDetected);
      EXPECT_EQ(a.m_eOutcome, b.m_eOutcome);
      EXPECT_EQ(a.m_fDirectionError, b.m_fDirectionError);
      EXPECT_EQ(a.m_fPenetration, b.m_fPenetration);
    }
  }
  EXPECT_GT(detected, 300u);
}

// So engines do not see each other, and the same seed gives the same bits.
TEST(ImpactTrialRulesTest, AnEngineAloneMakesTheSameOfTheSameSeed) {
  const CScene scene = LoadBundled("pinball");
  const std::vector<CEngine> engines = GetEngines();
  const CImpactTrialResult all = Judge(scene, 200, 100);
  ASSERT_EQ(all.m_stdContacts.size(), 200u);
  for (std::size_t e = 0; e < engines.size(); ++e) {
    const CImpactTrialResult alone = Judge(scene, 200, 100, 5, {engines[e]});
    ASSERT_EQ(alone.m_stdContacts.size(), 200u);
    for (std::size_t i = 0; i < 200; ++i) {
      EXPECT_EQ(all.m_stdContacts[i].m_fTime, alone.m_stdContacts[i].m_fTime);
      EXPECT_TRUE(all.m_stdContacts[i].m_stdEngines[e] == alone.m_stdContacts[i].m_stdEngines[0]);
    }
    EXPECT_EQ(all.m_stdGhosts[e], alone.m_stdGhosts[0]);
    EXPECT_EQ(all.m_nQuietSteps, alone.m_nQuietSteps);
  }
  EXPECT_NE(Judge(scene, 200, 100, 6).m_stdContacts[0].m_fTime, all.m_stdContacts[0].m_fTime); // the control
}

// Profiles of one engine claim the same, so "apart" is of native and Box2D, whichever of them are there.
TEST(ImpactTrialRulesTest, ApartIsTheDistanceOfTwoBackends) {
  const CScene scene = LoadBundled("bowl");
  const std::vector<CEngine> engines = GetEngines();
  const auto judge = [&](const std::vector<CEngine>& some) {
    return Judge(scene, 50, 100, 5, some).m_stdContacts;
  };
  const auto all = judge(engines), tuned = judge({engines[g_nApproximate], engines[g_nTuned]}),
             profiles = judge({engines[g_nBox2D], engines[g_nTuned]});
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(all[i].m_bHasDifference && tuned[i].m_bHasDifference);
    EXPECT_GT(all[i].m_fDifference, 0.0f);
    EXPECT_EQ(all[i].m_fDifference, tuned[i].m_fDifference);
    EXPECT_FALSE(profiles[i].m_bHasDifference);
    EXPECT_EQ(all[i].m_stdEngines[g_nBox2D].m_fSetbackError, all[i].m_stdEngines[g_nTuned].m_fSetbackError);
  }
  EXPECT_EQ(all.size(), 50u);
}

// A ball that flies to and fro between two walls, 5 millimetres above a floor of `pieces` segments that are
// joined in a line.
CScene OverFloor(int pieces, float height) {
  CScene scene = MakeScene(4, 10, {CLineSegDesc({-2, 0.05f}, {-2, 1}), CLineSegDesc({2, 0.05f}, {2, 1})},
                           {CDynamicCircleDesc({0, height}, 0.1f, {3, 0})});
  const float width = 4.0f / static_cast<float>(pieces);
  for (int i = 0; i < pieces; ++i) {
    const float x = -2.0f + width * static_cast<float>(i);
    AddShape(scene, CLineSegDesc({x, 0}, {x + width, 0}));
  }
  return scene;
}

// Box2D's edges have a skin of .01. A ball within it before a joint is nearest to the end of the next edge,
// whose normal leans back: it is braked. That is so while dx^2 + .105^2 < .11^2, dx < .0328, of every .2.
TEST(GhostsTest, JointsOfAFloorBumpABallOnBox2D) {
  const CImpactTrialResult result = Judge(OverFloor(20, 0.105f), 600);
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
    const CImpactTrialResult none = Judge(scene, 300);
    EXPECT_GT(none.m_nQuietSteps, 250u);
    EXPECT_EQ(none.m_stdGhosts[g_nApproximate] + none.m_stdGhosts[g_nBox2D], 0u);
  }
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

// Between their surfaces, at the least, in radii; of two balls both are counted.
TEST(GhostsTest, StepsFarFromEverythingAreNotCounted) {
  for (const auto& [gap, isNear] : {std::pair(0.5f, true), std::pair(0.95f, true), std::pair(1.05f, false)}) {
    SCOPED_TRACE(gap);
    const CDynamicCircleDesc ball({-0.5f, 0.2f + 0.1f * gap}, 0.1f, {60, 0});
    const CScene twoBalls = MakeScene(4, 1, {}, {ball, CDynamicCircleDesc({0.5f, 0}, 0.1f, {-60, 0})});
    EXPECT_EQ(JudgeOneStep(twoBalls).m_nQuietSteps, isNear ? 2u : 0u);
    const CScene floor = MakeScene(4, 1, {CLineSegDesc({-2, 0.1f}, {2, 0.1f})}, {ball});
    EXPECT_EQ(JudgeOneStep(floor).m_nQuietSteps, isNear ? 1u : 0u);
  }
}

// In Box2D's skin of .01. The one that comes nearer touches in the next step, the other one in none.
// Responses to two shapes in a step are one ghost.
TEST(GhostsTest, WhatIsTouchedInTheNextTwoStepsIsNoGhost) {
  const CLineSegDesc wall({0, -2}, {0, 2}), floor({-2, 0}, {2, 0});
  const auto expect = [](const std::vector<CAnyShapeDesc>& shapes, const Vector2& p, const Vector2& v,
                         std::size_t ghosts) {
    const CImpactTrialResult result = JudgeOneStep(MakeScene(4, 1, shapes, {CDynamicCircleDesc(p, 0.1f, v)}));
    EXPECT_EQ(result.m_nQuietSteps, 1u);
    EXPECT_EQ(result.m_stdGhosts[g_nBox2D], ghosts) << v.x();
    EXPECT_EQ(result.m_stdGhosts[g_nNative], 0u);
  };
  expect({wall}, {-0.109f, 0}, {0.3f, 0}, 0);
  expect({wall}, {-0.109f, 0}, {0.01f, 0}, 1);
  expect({wall, floor}, {-0.109f, 0.109f}, {0.01f, -0.01f}, 1);
}

// ---- What counts as a response of an engine.

TEST(EngineResponse, IsWhatChangesTheVelocityOrThePlaceOfABall) {
  CContactEvent nothing;
  nothing.m_fSpeed = nothing.m_fSetback = nothing.m_fImpulse = 0;
  EXPECT_FALSE(IsResponse(nothing));
  for (float CContactEvent::*pChange :
       {&CContactEvent::m_fSpeed, &CContactEvent::m_fSetback, &CContactEvent::m_fImpulse}) {
    CContactEvent event = nothing;
    event.*pChange = 1;
    EXPECT_TRUE(IsResponse(event));
    event.m_bIsSensor = true;
    EXPECT_FALSE(IsResponse(event));
  }
}

TEST(EngineResponse, ABallThatLiesIsCarriedAndDoesNotBounce) {
  for (const CBackend& backend : GetBackends()) {
    CWorldDesc desc;
    desc.m_vGravity = {0, -10};
    const auto pWorld = backend.MakeWorld(desc);
    pWorld->Add(CLineSegDesc({-5, 0}, {5, 0}));
    CDynamicCircleDesc ball({0, 0.5f}, 0.5f);
    ball.m_fElasticity = 0.0f;
    const CShapeId id = pWorld->Add(ball);
    pWorld->Step();
    pWorld->Step();
    EXPECT_EQ(CountBounces(*pWorld), 0u) << backend.GetName();
    const auto contacts = pWorld->GetContacts();
    EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(), [&](const CContactEvent& event) {
      return AsSeenBy(event, id).has_value();
    })) << backend.GetName();
  }
}

// Balls that are held by a wall before they could bounce off it have been answered: in a chute of Box2D, in a
// pile on native.
TEST(EngineResponse, BallsThatAreHeldHaveBeenAnswered) {
  const auto count = [](const char* pScene, std::string_view engine) {
    const CImpactTrialResult result = Judge(LoadBundled(pScene), 2000, 100000, 1, OnlyEngine(engine));
    EXPECT_GE(result.m_stdContacts.size(), 2000u);
    return std::count_if(result.m_stdContacts.begin(), result.m_stdContacts.end(),
                         [](const CContact& c) { return c.m_stdEngines[0].m_eOutcome == eOutcome::Missed; });
  };
  EXPECT_EQ(count("chute", "box2d-tuned"), 0);
  EXPECT_EQ(count("closing_gates", "native"), 0);
}

} // namespace
} // namespace Shapes::Compare::Tests
