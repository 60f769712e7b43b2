// SPDX-License-Identifier: MIT
// Begin and end of solid contacts, and the impulses of contacts: the same on every engine, in every mode.
#include "Backends.h"

#include <set>

namespace Shapes {
namespace {

using Tests::CRandom;

struct CMode {
  const char* m_sName;
  CEffectChoice m_cEffects;
  eProfile m_eProfile = eProfile::Shipped;
};

const CMode g_stdModes[] = {{"automatic", g_cAutomatic},
                            {"approximate", g_cApproximate},
                            {"continuous", g_cContinuous},
                            {"tuned", g_cAutomatic, eProfile::Tuned}};

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
  /// Steps, and gives begins and ends as "+" and "-".
  static std::string Step(CWorld& world, int n = 1) {
    std::string told;
    for (int i = 0; i < n; ++i) {
      world.Step();
      for (const CTouchEvent& event : world.GetTouchEvents())
        told += event.m_bBegin ? '+' : '-';
    }
    return told;
  }
};
SHAPES_ON_EVERY_BACKEND(CTouchContract);

std::string Repeated(const std::string& text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i)
    all += text;
  return all;
}

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
    std::string told;
    int bounces = 0;
    for (int i = 0; i < 600; ++i) {
      const float before = pWorld->GetVel(ball).y();
      told += Step(*pWorld);
      bounces += before < 0 && pWorld->GetVel(ball).y() > 0;
    }
    EXPECT_GT(bounces, 7); // of .9 s each
    if (told.size() % 2 != 0) told += '-';
    EXPECT_EQ(told, Repeated("+-", bounces));
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
  std::vector<CTouchEvent> seen;
  for (int i = 0; i < 30; ++i) {
    pWorld->Step();
    seen.insert(seen.end(), pWorld->GetTouchEvents().begin(), pWorld->GetTouchEvents().end());
  }
  ASSERT_GE(seen.size(), 4u);
  EXPECT_EQ(seen[0], (CTouchEvent{second, first, true}));
  EXPECT_EQ(seen[1], (CTouchEvent{second, first, false}));
  EXPECT_EQ(seen[2], (CTouchEvent{wall, second, true}));
  EXPECT_EQ(seen[3], (CTouchEvent{wall, second, false}));
}

TEST_P(CTouchContract, WhatIsRemovedOrTurnedOffCeasesToTouch) {
  for (const CParting& part : g_stdPartings) {
    SCOPED_TRACE(&part - g_stdPartings);
    const auto pWorld = Make(g_stdModes[0]);
    const CShapeId floor = pWorld->Add(CLineSegDesc({-5, 0}, {5, 0}));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.15f}, 0.1f, {0, 0}, 1, 0.0f));
    EXPECT_EQ(Step(*pWorld, 120), "+");
    part(*pWorld, floor, ball);
    EXPECT_EQ(Step(*pWorld), "-");
    EXPECT_EQ(pWorld->GetTouchEvents()[0], (CTouchEvent{floor, ball, false}));
    EXPECT_EQ(Step(*pWorld), "");
  }
}

TEST_P(CTouchContract, ASavedStateKnowsWhatTouches) {
  const auto pWorld = WithFloor(Make(g_stdModes[0]));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.15f}, 0.1f, {0, 0}, 1, 0.0f));
  const CSavedState above = pWorld->SaveState();
  EXPECT_EQ(Step(*pWorld, 120), "+");
  const CSavedState lying = pWorld->SaveState();
  pWorld->SetPos(ball, {0, 2});
  EXPECT_EQ(Step(*pWorld), "-");
  pWorld->LoadState(lying);
  EXPECT_TRUE(pWorld->GetTouchEvents().empty());
  EXPECT_EQ(Step(*pWorld, 60), "");
  pWorld->LoadState(above);
  EXPECT_EQ(Step(*pWorld, 120), "+");
  const auto pOther = Make(g_stdModes[0]);
  pOther->LoadState(lying);
  EXPECT_EQ(Step(*pOther, 60), "");
  pOther->Remove(ball);
  EXPECT_EQ(Step(*pOther), "-");
}

TEST_P(CTouchContract, RunsOnlyWhereItIsForced) {
  CWorldDesc desc;
  desc.m_vGravity = {0, -10};
  const auto pWorld = WithFloor(Backend().MakeWorld(desc));
  pWorld->Add(CDynamicCircleDesc({0, 0.15f}, 0.1f));
  EXPECT_EQ(Step(*pWorld, 60), "");
  EXPECT_GT(pWorld->GetStats().m_nContacts, 0u);
  EXPECT_EQ(pWorld->GetStats().GetSubstepsWith(eEffect::Touches), 0u);
  desc.m_cEffects = {{eEffect::Touches}, {eEffect::Events}};
  try {
    Backend().MakeWorld(desc);
    ADD_FAILURE() << "was taken";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("Touches"), std::string::npos);
  }
}

// Balls that come, go, are turned off, become sensors, and a state that is loaded now and then.
TEST_P(CTouchContract, EveryBeginHasItsEndWhateverHappens) {
  for (const CMode& mode : g_stdModes)
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(testing::Message() << mode.m_sName << ", seed " << seed);
      CRandom random(seed);
      const auto pWorld = WithFloor(Make(mode));
      for (const float x : {-2.0f, 2.0f})
        pWorld->Add(CLineSegDesc({x, 0}, {x, 5}));
      const CShapeId bumper = pWorld->Add(CCircleDesc({0, 1}, 0.4f));
      std::set<std::pair<CShapeId, CShapeId>> touching, savedTouching;
      CSavedState saved = pWorld->SaveState();
      int begins = 0;
      for (int i = 0; i < 400; ++i) {
        const auto balls = pWorld->GetBallIds();
        const CShapeId ball =
            balls.empty() ? CShapeId() : balls[random.Below(static_cast<std::uint32_t>(balls.size()))];
        switch (random.Below(16)) {
        case 0:
        case 1:
          if (balls.size() < 12)
            pWorld->Add(CDynamicCircleDesc({random.Uniform(-1.5f, 1.5f), random.Uniform(2.0f, 4.0f)},
                                           random.Uniform(0.1f, 0.2f), random.InSquare(3), 1, 0.5f));
          break;
        case 2:
          if (balls.size() > 6) pWorld->Remove(ball);
          break;
        case 3: pWorld->SetCanCollide(bumper, !pWorld->GetCanCollide(bumper)); break;
        case 4: pWorld->SetSensor(bumper, !pWorld->GetSensor(bumper)); break;
        case 5:
          if (!balls.empty()) pWorld->SetVel(ball, random.InSquare(6));
          break;
        case 6:
          saved = pWorld->SaveState();
          savedTouching = touching;
          break;
        case 7:
          if (random.Below(4) != 0) break;
          pWorld->LoadState(saved);
          touching = savedTouching;
          break;
        default: break;
        }
        pWorld->Step();
        for (const CTouchEvent& event : pWorld->GetTouchEvents()) {
          const std::pair pair(event.m_cBall, event.m_cShape);
          ASSERT_EQ(event.m_bBegin ? touching.insert(pair).second : touching.erase(pair) == 1, true);
          begins += event.m_bBegin;
        }
      }
      EXPECT_GT(begins, 50); // where little happens little is shown
      while (!pWorld->GetBallIds().empty())
        pWorld->Remove(pWorld->GetBallIds()[0]);
      EXPECT_EQ(Step(*pWorld).size(), touching.size());
    }
}

// What the floor gives in all is what gravity takes and what the ball has got: within what two substeps of
// gravity give, because a ball that comes to rest in the middle of one is carried from the next one on.
TEST_P(CTouchContract, ImpulsesAddUpToTheMomentum) {
  for (const float e : {0.0f, 0.5f, 1.0f})
    for (const CMode& mode : g_stdModes) {
      SCOPED_TRACE(testing::Message() << mode.m_sName << ", elasticity " << e);
      const auto pWorld = WithFloor(Make(mode));
      const float m = 2;
      const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.6f}, 0.1f, {0, 0}, m, e));
      float given = 0, weight = 0;
      // No longer than until it sleeps.
      for (int i = 0; i < 45; ++i) {
        pWorld->Step();
        weight += m * 10 * g_fDt;
        for (const CContactEvent& contact : pWorld->GetContacts())
          given += contact.m_fImpulse;
      }
      EXPECT_NEAR(given, weight + m * pWorld->GetVel(ball).y(), 2 * m * 10 * g_fDt);
    }
}

TEST_P(CTouchContract, AnImpulseIsThatOfTheReducedMass) {
  for (const CMode& mode : g_stdModes) {
    SCOPED_TRACE(mode.m_sName);
    const auto pWorld = Make(mode, {0, 0});
    pWorld->Add(CDynamicCircleDesc({0, 0}, 0.1f, {3, 0}, 2, 0.5f));
    const CShapeId second = pWorld->Add(CDynamicCircleDesc({0.5f, 0}, 0.1f, {0, 0}, 6));
    float impulse = 0;
    for (int i = 0; i < 20; ++i) {
      pWorld->Step();
      for (const CContactEvent& contact : pWorld->GetContacts())
        impulse += contact.m_fImpulse;
    }
    EXPECT_NEAR(impulse, 1.5f * 1.5f * 3, 1e-5f); // (1 + e) m0 m1 / (m0 + m1) v, of some roundings
    EXPECT_NEAR(6 * pWorld->GetVel(second).x(), impulse, 1e-5f);
  }
}

} // namespace
} // namespace Shapes
