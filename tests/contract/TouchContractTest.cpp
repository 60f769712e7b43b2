// SPDX-License-Identifier: MIT
// Begin and end of solid contacts, and the impulses of contacts: the same on every engine, in every mode.
#include "Backends.h"

namespace Shapes {
namespace {

class CTouchContract : public CEveryBackend {
protected:
  std::unique_ptr<CWorld> Make(const CMode& mode, const Vector2& gravity = {0, -10}) const {
    CEffectChoice choice = mode.m_cEffects;
    choice.m_cForced.Set(eEffect::Touches);
    return CEveryBackend::Make(choice, mode.m_eProfile, gravity);
  }
  static std::unique_ptr<CWorld> WithFloor(std::unique_ptr<CWorld> pWorld) {
    pWorld->Add(CLineSegDesc({-5, 0}, {5, 0}));
    return pWorld;
  }
  static std::string Step(CWorld& world, int n = 1) { return Marks(world, &CWorld::GetTouchEvents, n); }
};
SHAPES_ON_EVERY_BACKEND(CTouchContract);

TEST_P(CTouchContract, ABallThatLiesBeginsOnceAndEndsWhenItLeaves) {
  for (const CMode& mode : g_stdModes) {
    SCOPED_TRACE(mode.m_sName);
    const auto pWorld = WithFloor(Make(mode));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.15f}, 0.1f, {0, 0}, 1, 0.0f));
    EXPECT_EQ(Step(*pWorld, 600), "+"); // sleeping included
    pWorld->SetVel(ball, {0, 3});
    EXPECT_EQ(Step(*pWorld, 10), "-");
    EXPECT_EQ(Step(*pWorld, 600), "+");
    EXPECT_EQ(pWorld->GetStats().GetSubstepsWith(eEffect::Touches), 1210u);
  }
}

// A bounce is where the velocity turns upward.
TEST_P(CTouchContract, ABallThatBouncesBeginsAndEndsWithEachBounce) {
  for (const CMode& mode : g_stdModes) {
    SCOPED_TRACE(mode.m_sName);
    const auto pWorld = WithFloor(Make(mode));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 1.1f}, 0.1f));
    std::string told, bounces;
    for (int i = 0; i < 600; ++i) {
      const float before = pWorld->GetVel(ball).y();
      told += Step(*pWorld);
      if (before < 0 && pWorld->GetVel(ball).y() > 0) bounces += "+-";
    }
    EXPECT_GT(bounces.size(), 2u * 7u); // of .9 s each
    if (told.size() % 2 != 0) told += '-';
    EXPECT_EQ(told, bounces);
  }
}

TEST_P(CTouchContract, BallsInAPileTouchOn) {
  for (const CMode& mode : {g_stdModes[0], g_stdModes[3]}) {
    SCOPED_TRACE(mode.m_sName);
    const auto pWorld = WithFloor(Make(mode));
    pWorld->Add(CLineSegDesc({-0.35f, 0}, {-0.35f, 3}));
    pWorld->Add(CLineSegDesc({0.35f, 0}, {0.35f, 3}));
    for (int i = 0; i < 6; ++i)
      pWorld->Add(
          CDynamicCircleDesc({-0.2f + 0.37f * static_cast<float>(i % 2), 0.2f + 0.3f * static_cast<float>(i)},
                             0.15f, {0, 0}, 1, 0.2f));
    Step(*pWorld, 300);
    EXPECT_EQ(Step(*pWorld, 300), "");
    pWorld->SetGravity({0, 10});
    const std::string told = Step(*pWorld, 60);
    EXPECT_GE(std::count(told.begin(), told.end(), '-'), 1); // the floor
  }
}

TEST_P(CTouchContract, NamesBothAsContactsDo) {
  const auto pWorld = Make(g_stdModes[0], {0, 0});
  const CShapeId first = pWorld->Add(CDynamicCircleDesc({0, 0}, 0.1f, {3, 0}));
  const CShapeId wall = pWorld->Add(CLineSegDesc({1, -1}, {1, 1}));
  const CShapeId second = pWorld->Add(CDynamicCircleDesc({0.5f, 0}, 0.1f));
  const std::vector<CTouchEvent> seen = Told(*pWorld, 30, &CWorld::GetTouchEvents);
  ASSERT_GE(seen.size(), 4u);
  EXPECT_EQ(seen[0], (CTouchEvent{second, first, true}));
  EXPECT_EQ(seen[1], (CTouchEvent{second, first, false}));
  EXPECT_EQ(seen[2], (CTouchEvent{wall, second, true}));
  EXPECT_EQ(seen[3], (CTouchEvent{wall, second, false}));
}

TEST_P(CTouchContract, RunsOnlyWhereItIsForced) {
  CWorldDesc desc = Described({0, -10});
  const auto pWorld = WithFloor(Backend().MakeWorld(desc));
  pWorld->Add(CDynamicCircleDesc({0, 0.15f}, 0.1f));
  EXPECT_EQ(Step(*pWorld, 60), "");
  EXPECT_GT(pWorld->GetStats().m_nContacts, 0u);
  EXPECT_EQ(pWorld->GetStats().GetSubstepsWith(eEffect::Touches), 0u);
  desc.m_cEffects = {{eEffect::Touches}, {eEffect::Events}};
  EXPECT_TRUE(Says(MessageOf<std::invalid_argument>([&] { Backend().MakeWorld(desc); }), "Touches"));
}

// The floor gives in all what gravity takes and what the ball has got: within what two substeps of gravity
// give, because a ball that comes to rest in the middle of one is carried from the next one on.
TEST_P(CTouchContract, ImpulsesAddUpToTheMomentum) {
  for (const float e : {0.0f, 0.5f, 1.0f})
    for (const CMode& mode : g_stdModes) {
      SCOPED_TRACE(testing::Message() << mode.m_sName << ", elasticity " << e);
      const auto pWorld = WithFloor(Make(mode));
      const float m = 2;
      const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.6f}, 0.1f, {0, 0}, m, e));
      float given = 0;
      for (const CContactEvent& contact : Told(*pWorld, 45, &CWorld::GetContacts)) // until it sleeps
        given += contact.m_fImpulse;
      EXPECT_NEAR(given, 45 * m * 10 * g_fDt + m * pWorld->GetVel(ball).y(), 2 * m * 10 * g_fDt);
    }
}

TEST_P(CTouchContract, AnImpulseIsThatOfTheReducedMass) {
  for (const CMode& mode : g_stdModes) {
    SCOPED_TRACE(mode.m_sName);
    const auto pWorld = Make(mode, {0, 0});
    pWorld->Add(CDynamicCircleDesc({0, 0}, 0.1f, {3, 0}, 2, 0.5f));
    const CShapeId second = pWorld->Add(CDynamicCircleDesc({0.5f, 0}, 0.1f, {0, 0}, 6));
    float impulse = 0;
    for (const CContactEvent& contact : Told(*pWorld, 20, &CWorld::GetContacts))
      impulse += contact.m_fImpulse;
    EXPECT_NEAR(impulse, 1.5f * 1.5f * 3, 1e-5f); // (1 + e) m0 m1 / (m0 + m1) v, of some roundings
    EXPECT_NEAR(6 * pWorld->GetVel(second).x(), impulse, 1e-5f);
  }
}

} // namespace
} // namespace Shapes
