// SPDX-License-Identifier: MIT
// CWorld, the same on every engine.
#include "Backends.h"

namespace Shapes {
namespace {

class CWorldContract : public CEveryBackend {
protected:
  std::unique_ptr<CWorld> m_pWorld = Make();
};
SHAPES_ON_EVERY_BACKEND(CWorldContract);

const CMotionLimits g_cBladeLimits = CMotionLimits::OfAngle(-1, 2);

// A little of everything, with several balls, for tests of states and of order.
std::unique_ptr<CWorld> MakeBusyWorld(const CBackend& backend) {
  auto pWorld = backend.MakeWorld(Described({0, -5}, 1.0f / 120.0f));
  pWorld->Add(CArcDesc({0, 0}, 4, 0, 0));
  pWorld->Add(CPointDesc(Vector2(0, -2)));
  pWorld->Add(CCircleDesc({1.5f, 0}, 0.4f, 1.2f));
  pWorld->Add(CLineSegDesc({-2, -2}, {-1, -2.5f}));
  CLineSegDesc blade = Turning(CLineSegDesc({-2, 1}, {-1, 1}), 0.7f, {-1.5f, 1});
  blade.m_cLimits = g_cBladeLimits;
  pWorld->Add(blade);
  pWorld->Add(Moving(CLineSegDesc({-3, -1}, {-3, 0}), {1.3f, 0.2f}));
  pWorld->Add(MakeZone({0, 2}, 0.5f));
  for (int i = 0; i < 6; ++i) {
    const float f = static_cast<float>(i);
    pWorld->Add(
        CDynamicCircleDesc({-1.5f + 0.6f * f, 1.5f + 0.1f * f}, 0.1f + 0.02f * f, {2 - f, f}, 1 + f, 0.9f));
  }
  return pWorld;
}

TEST_P(CWorldContract, AFreeBallFallsOnAParabolaOnNativeAndStepByStepElsewhere) {
  for (const CEffectChoice& choice : {g_cAutomatic, g_cApproximate}) {
    m_pWorld = Make(choice);
    m_pWorld->SetGravity({0, -10});
    const CShapeId id = m_pWorld->Add(CDynamicCircleDesc({1, 2}, 0.1f, {3, 4}));
    Steps(*m_pWorld, 60);
    const bool isParabola = IsNative() && !choice.m_cForbidden.Has(eEffect::Continuous);
    EXPECT_NEAR(m_pWorld->GetPos(id).y(), isParabola ? 1.0f : 1.0f - 5.0f / 60.0f, 1e-5f);
    EXPECT_NEAR(m_pWorld->GetPos(id).x(), 4.0f, 1e-5f);
    EXPECT_NEAR(m_pWorld->GetVel(id).y(), -6.0f, 1e-5f);
  }
}

TEST_P(CWorldContract, AnElasticityThatIsChangedCounts) {
  const CShapeId wall = m_pWorld->Add(CLineSegDesc({-10, 0}, {10, 0}, 0.5f));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0, 0.5f}, 0.1f, {3, -4}, 1.0f, 0.5f));
  m_pWorld->Step();
  m_pWorld->SetElasticity(wall, 1.5f);
  m_pWorld->SetElasticity(ball, 1.0f);
  Steps(*m_pWorld, 10);
  EXPECT_NEAR(m_pWorld->GetVel(ball).y(), 6.0f, 1e-4f);
}

// The wall is added after the ball and before it: neither may turn the normal around. Of two balls it points
// to the first.
TEST_P(CWorldContract, ContactsComeInTheConventionsOfTheLibrary) {
  const CAnyShapeDesc ball = CDynamicCircleDesc({0, 0.25f}, 0.1f, {0, -6}),
                      wall = CLineSegDesc({-1, 0}, {1, 0}),
                      other = CDynamicCircleDesc({0, -0.1f}, 0.1f, {0, 0}, 3);
  for (const auto& [first, second, isBallFirst] :
       {std::tuple(ball, wall, true), {wall, ball, false}, {ball, other, true}}) {
    const auto pWorld = Make();
    const CShapeId one = pWorld->Add(first), two = pWorld->Add(second);
    const std::vector<CContactEvent> seen = Impacts(*pWorld, 30);
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen[0].m_cShape, isBallFirst ? two : one);
    EXPECT_EQ(seen[0].m_cBall, isBallFirst ? one : two);
    EXPECT_NEAR(seen[0].m_vNorm.y(), 1.0f, 1e-5f);
    const bool isBall = pWorld->GetMotionType(seen[0].m_cShape) == eMotion::Dynamic;
    EXPECT_NEAR(seen[0].m_vPOI.y(), 0.0f,
                isBall && IsBox2D() ? 0.1f : Skin()); // Box2D may be a step late with two balls
    EXPECT_NEAR(seen[0].m_fSpeed, 6.0f, 1e-4f);
    EXPECT_FALSE(seen[0].m_bIsSensor);
    EXPECT_EQ(seen[0].m_fSetback, 0.0f); // it is fast: nobody sets it back
  }
}

TEST_P(CWorldContract, ShapesAndBallsAreRemoved) {
  const CShapeId wall = m_pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  const CShapeId other = m_pWorld->Add(CDynamicCircleDesc({5, 5}, 0.1f));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0, 0.3f}, 0.1f, {0, -2}));
  m_pWorld->Remove(wall);
  m_pWorld->Remove(other);
  EXPECT_FALSE(m_pWorld->Contains(wall));
  EXPECT_FALSE(m_pWorld->Contains(other));
  Steps(*m_pWorld, 30);
  EXPECT_FLOAT_EQ(m_pWorld->GetVel(ball).y(), -2.0f);
  EXPECT_THROW(m_pWorld->Remove(wall), std::invalid_argument);
  EXPECT_THROW(m_pWorld->GetPos(other), std::invalid_argument);
  ASSERT_EQ(m_pWorld->GetBallIds().size(), 1u);
  EXPECT_EQ(m_pWorld->GetBallIds()[0], ball);
  EXPECT_TRUE(m_pWorld->GetShapeIds().empty());
  const CShapeId next = m_pWorld->Add(CPointDesc(Vector2(0, 0)));
  EXPECT_GT(next, ball); // ids are not used again
  const CShapeId last = m_pWorld->Add(CCircleDesc({9, 9}, 1));
  EXPECT_EQ(m_pWorld->GetShapeIds(), (std::vector<CShapeId>{next, last}));
}

TEST_P(CWorldContract, WhatWasAskedStaysWhenWhatItIsOfIsRemoved) {
  auto pWorld = MakeBusyWorld(Backend());
  const CShapeId ball = pWorld->GetBallIds()[0], blade{5};
  const Vector2 &p = pWorld->GetPos(ball), &v = pWorld->GetVel(ball), &center = pWorld->GetRotCenter(blade);
  const CFilter& filter = pWorld->GetFilter(ball);
  const CMotionLimits& limits = pWorld->GetLimits(blade);
  pWorld->SetFilter(pWorld->GetBallIds()[1], {2, 2});
  pWorld->Remove(ball);
  pWorld->Remove(blade);
  EXPECT_EQ(p, Vector2(-1.5f, 1.5f));
  EXPECT_EQ(v, Vector2(2, 0));
  EXPECT_EQ(center, Vector2(-1.5f, 1));
  EXPECT_EQ(filter, CFilter());
  EXPECT_EQ(limits, g_cBladeLimits);
}

TEST_P(CWorldContract, UserPointersStayWithTheirShapes) {
  auto pWorld = MakeBusyWorld(Backend());
  int tags[2];
  const CShapeId ball = pWorld->GetBallIds()[3];
  const CShapeId shape{1};
  pWorld->SetUserPtr(ball, &tags[0]);
  pWorld->SetUserPtr(shape, &tags[1]);
  pWorld->Remove(pWorld->GetBallIds()[0]);
  pWorld->Step();
  EXPECT_EQ(pWorld->GetUserPtr(ball), &tags[0]);
  EXPECT_EQ(pWorld->GetUserPtr(shape), &tags[1]);
  EXPECT_EQ(pWorld->GetUserPtr(pWorld->GetBallIds()[0]), nullptr);
}

TEST_P(CWorldContract, TheBulkViewsAreWhatTheIdsSay) {
  auto pWorld = MakeBusyWorld(Backend());
  Steps(*pWorld, 50);
  const auto ids = pWorld->GetBallIds();
  ASSERT_EQ(ids.size(), 6u);
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    EXPECT_EQ(pWorld->GetPos(ids[i]), pWorld->GetBallPositions()[i]);
    EXPECT_EQ(pWorld->GetVel(ids[i]), pWorld->GetBallVelocities()[i]);
    EXPECT_EQ(pWorld->GetMotionType(ids[i]), eMotion::Dynamic);
    EXPECT_EQ(pWorld->GetShapeType(ids[i]), eShape::Circle);
    EXPECT_FLOAT_EQ(pWorld->GetMass(ids[i]), 1.0f + static_cast<float>(i));
    EXPECT_FLOAT_EQ(pWorld->GetRadius(ids[i]), 0.1f + 0.02f * static_cast<float>(i));
  }
}

TEST_P(CWorldContract, ASavedStateContinuesWithTheSameBits) {
  auto pWorld = MakeBusyWorld(Backend());
  auto pOther = MakeBusyWorld(Backend());
  const CShapeId blade{5};
  for (const int before : {5, 25, 200}) { // the blade is under way, and at a stop
    Steps(*pWorld, before);
    const CSavedState saved = pWorld->SaveState();
    pOther->Remove(pOther->GetBallIds()[1]); // whatever the other one held is replaced
    pOther->LoadState(saved);
    EXPECT_EQ(pOther->GetLimits(blade), g_cBladeLimits);
    for (CWorld* p : {pWorld.get(), pOther.get()}) {
      Steps(*p, 100);
      p->SetRotSpeed(blade, -p->GetRotSpeed(blade));
      Steps(*p, 200);
    }
    EXPECT_TRUE(HaveSameBits(*pWorld, *pOther));
    EXPECT_EQ(pWorld->GetOrientation(blade), pOther->GetOrientation(blade));
  }
  pOther->Step(); // the control: one step more is not the same
  EXPECT_NE(pWorld->GetBallPositions()[0], pOther->GetBallPositions()[0]);
  EXPECT_THROW(pWorld->LoadState(CSavedState()), std::invalid_argument);
}

TEST_P(CWorldContract, AfterAStateOfAnotherWorldTheIdsAreThoseOfTheState) {
  auto pWorld = Backend().MakeWorld(CWorldDesc()), pOther = Backend().MakeWorld(CWorldDesc());
  const CShapeId mine = pWorld->Add(CPointDesc(Vector2(1, 1))), gone = pWorld->Add(CPointDesc(Vector2(2, 2)));
  const CShapeId its = pOther->Add(CCircleDesc({3, 3}, 1));
  pOther->SetGravity({0, -3});
  pWorld->LoadState(pOther->SaveState());
  EXPECT_EQ(pWorld->GetDesc().m_vGravity, Vector2(0, -3)); // the state's, too
  EXPECT_EQ(mine, its);                                    // as the comment of LoadState warns
  EXPECT_EQ(pWorld->GetShapeType(mine), eShape::Circle);
  EXPECT_THROW(pWorld->GetPos(gone), std::invalid_argument);
  EXPECT_GT(pWorld->Add(CPointDesc(Vector2(4, 4))), gone); // neither world's ids are given again
}

// Another world throws it up, by its user, or by a floor that moves, and gives the state back.
TEST_P(CWorldContract, ABallThatSleptAndWasThrownByAnotherWorldFallsWhereItWasLeft) {
  for (const CEffects& forbidden : {CEffects(), CEffects{eEffect::Continuous}})
    for (const bool byFloor : {false, true}) {
      const auto pHome = GetBackend(eBackend::Native)->MakeWorld(Described({0, -10}));
      const CShapeId floor = pHome->Add(Turning(CLineSegDesc({-9, 0}, {9, 0}), 0)),
                     ball = pHome->Add(CDynamicCircleDesc({0, 0.5f}, 0.5f));
      Steps(*pHome, 60);
      const auto pOther = Backend().MakeWorld(Described({0, -10}, g_fDt, 1, {{}, forbidden}));
      pOther->LoadState(pHome->SaveState());
      pOther->SetVel(byFloor ? floor : ball, {0, byFloor ? 2.0f : 4.0f}); // a ball gets twice that of a floor
      Steps(*pOther, 3);
      pOther->SetVel(floor, {0, 0});
      Steps(*pOther, 27);
      const float left = pOther->GetPos(ball).y();
      ASSERT_GT(left, 1.0f);
      pHome->LoadState(pOther->SaveState());
      Steps(*pHome, 20);
      EXPECT_LT(pHome->GetPos(ball).y(), left - 0.1f);
    }
}

TEST_P(CWorldContract, SubstepsCutTheStep) {
  auto pWhole = Backend().MakeWorld(Described({0, 0}, 1.0f / 30.0f, 4));
  auto pParts = Backend().MakeWorld(Described({0, 0}, 1.0f / 120.0f));
  for (CWorld* p : {pWhole.get(), pParts.get()}) {
    p->Add(CLineSegDesc({-10, 0}, {10, 0}));
    p->Add(CDynamicCircleDesc({0, 0.5f}, 0.1f, {1, -3}));
  }
  Steps(*pWhole, 20);
  Steps(*pParts, 80);
  EXPECT_TRUE(HaveSameBits(*pWhole, *pParts));
  EXPECT_EQ(pWhole->GetStats().m_nSteps, 20u);
  EXPECT_EQ(pWhole->GetStats().m_nSubsteps, 80u);
}

} // namespace
} // namespace Shapes
