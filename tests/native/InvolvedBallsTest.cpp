// SPDX-License-Identifier: MIT
// The native world with Continuous takes up only balls that may meet something: none that does is left out,
// and what finds the shapes does not matter to what comes out.
#include "../Numbers.h"
#include "Random.h"

#include <Shapes/Shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace Shapes {
namespace {

using Tests::CRandom;

std::unique_ptr<CWorld> MakeSwept(const Vector2& g) {
  CWorldDesc desc;
  desc.m_fTimeStep = g_fDt;
  desc.m_vGravity = g;
  desc.m_cEffects = g_cContinuous;
  return GetBackend(eBackend::Native)->MakeWorld(desc);
}

// After the first substeps a grid that knows what is clear is there; it must not change anything.
TEST(InvolvedBallsTest, ABallThatTurnsRoundBelowACeilingMeetsItInEveryStep) {
  const float g = 10.0f, up = 0.5f * g * g_fDt, top = 0.5f * up * up / g, r = 0.25f * top;
  auto pWorld = MakeSwept({0, -g});
  // The ball would be back where it began at the end of the step.
  pWorld->Add(CLineSegDesc({-1, r + 0.9f * top}, {1, r + 0.9f * top}));
  CDynamicCircleDesc desc({0, 0}, r);
  desc.m_fElasticity = 0.0f;
  const CShapeId ball = pWorld->Add(desc);
  Vector2 first = Vector2::Zero();
  for (int i = 0; i < 3000; ++i) {
    pWorld->SetPos(ball, {0, 0});
    pWorld->SetVel(ball, {0, up});
    pWorld->Step();
    ASSERT_EQ(pWorld->GetContacts().size(), 1u) << i;
    if (i == 0) first = pWorld->GetPos(ball);
    ASSERT_EQ(pWorld->GetPos(ball), first) << i;
  }
}

// A light ball that a heavy one hits goes farther than either would have gone.
TEST(InvolvedBallsTest, ABallThatIsHitMeetsOneInTheOpenInTheSameStep) {
  for (const float place : {8.0f, 80.0f}) { // the control is out of its way
    auto pWorld = MakeSwept({0, 0});
    CDynamicCircleDesc heavy({0, 0}, 0.1f, {300, 0}), light({1, 0}, 0.1f);
    heavy.m_fMass = 1000.0f;
    light.m_fMass = 0.001f;
    pWorld->Add(heavy);
    pWorld->Add(light);
    const CShapeId inTheOpen = pWorld->Add(CDynamicCircleDesc({place, 0}, 0.1f));
    // Where there are few balls each looks at all of them.
    for (int i = 0; i < 100; ++i)
      pWorld->Add(CDynamicCircleDesc({static_cast<float>(i), 50}, 0.1f));
    pWorld->Step();
    EXPECT_EQ(pWorld->GetVel(inTheOpen).x() > 0.0f, place < 10.0f);
  }
}

// Balls that meet shapes only are moved one after the other.
TEST(InvolvedBallsTest, ContactsOfBallsThatMoveAloneAreToldInTheOrderOfTime) {
  CWorldDesc desc;
  desc.m_fTimeStep = g_fDt;
  desc.m_cEffects = {{}, CEffects{eEffect::BallPairs}};
  auto pWorld = GetBackend(eBackend::Native)->MakeWorld(desc);
  pWorld->Add(CLineSegDesc({-10, 0}, {10, 0}));
  pWorld->Add(CLineSegDesc({-10, 1}, {10, 1}));
  // The first one meets the floor late, the second one both in between, the third one at the same time as it.
  for (const auto& [x, y, v] : {std::tuple(-5.0f, 0.95f, -60.0f), {0.0f, 0.2f, -90.0f}, {5.0f, 0.2f, -90.0f}})
    pWorld->Add(CDynamicCircleDesc({x, y}, 0.1f, {0, v}));
  pWorld->Step();
  std::vector<CShapeId> balls;
  for (const CContactEvent& contact : pWorld->GetContacts())
    balls.push_back(contact.m_cBall);
  const auto ids = pWorld->GetBallIds();
  EXPECT_EQ(balls, (std::vector<CShapeId>{ids[1], ids[2], ids[1], ids[2], ids[0]}));
}

TEST(InvolvedBallsTest, AWorldThatGoesOnAndOneThatIsLoadedHaveTheSameBitsWhateverFindsTheShapes) {
  for (const bool falls : {true, false}) {
    CRandom random(271);
    auto pWorld = MakeSwept({0, falls ? -10.0f : 0.0f});
    for (const float at : {0.0f, 12.0f}) {
      pWorld->Add(CLineSegDesc({0, at}, {12, at}));
      pWorld->Add(CLineSegDesc({at, 0}, {at, 12}));
    }
    for (int i = 0; i < 60; ++i) {
      const Vector2 p = Vector2(6, 6) + random.InSquare(5.5f);
      if (random.Coin()) {
        pWorld->Add(CCircleDesc(p, random.Uniform(0.05f, 0.4f)));
      } else {
        CLineSegDesc bar(p, p + random.VectorOfLength(0.1f, 1.0f));
        bar.m_eMotionType = i % 10 == 0 ? eMotion::Kinematic : eMotion::Static;
        bar.m_vRotCenter = p;
        bar.m_fRotSpeed = i % 10 == 0 ? 0.5f : 0.0f;
        pWorld->Add(bar);
      }
    }
    for (int i = 0; i < 80; ++i) {
      const Vector2 p = Vector2(6, 6) + random.InSquare(5.5f), v = random.VectorOfLength(0.0f, 20.0f);
      CDynamicCircleDesc ball(p, random.Uniform(0.02f, 0.2f), v);
      ball.m_fElasticity = random.Uniform(0.3f, 1.0f);
      pWorld->Add(ball);
    }
    for (int i = 0; i < 100; ++i)
      pWorld->Step(); // by now it has its grid
    CWorldDesc desc = pWorld->GetDesc();
    const auto pLoaded = GetBackend(eBackend::Native)->MakeWorld(desc);
    std::size_t contacts = 0;
    for (int i = 0; i < 20; ++i) {
      pLoaded->LoadState(pWorld->SaveState()); // and this one never
      pWorld->Step();
      pLoaded->Step();
      contacts += pWorld->GetContacts().size();
      ASSERT_EQ(pWorld->GetContacts().size(), pLoaded->GetContacts().size()) << random.GetSeed();
      for (std::size_t k = 0; k < pWorld->GetBallIds().size(); ++k) {
        ASSERT_EQ(pWorld->GetBallPositions()[k], pLoaded->GetBallPositions()[k]) << i << ' ' << k;
        ASSERT_EQ(pWorld->GetBallVelocities()[k], pLoaded->GetBallVelocities()[k]) << i << ' ' << k;
      }
    }
    EXPECT_GT(contacts, 20u);
  }
}

// All centres are level: nothing in the row says that it can give way upwards.
TEST(InvolvedBallsTest, ARowThatAWallSqueezesIsLiftedInsteadOfMerging) {
  auto pWorld = MakeSwept({0, -10});
  pWorld->Add(CLineSegDesc({0, 0}, {10, 0}));
  pWorld->Add(CLineSegDesc({0, 0}, {0, 9}));
  CLineSegDesc wall({4, 0}, {4, 9});
  wall.m_eMotionType = eMotion::Kinematic;
  wall.m_vVel = {-2, 0};
  pWorld->Add(wall);
  for (int i = 0; i < 9; ++i)
    pWorld->Add(CDynamicCircleDesc({0.2f + 0.4f * static_cast<float>(i), 0.2f}, 0.2f, {0, 0}, 1, 0.5f));
  float least = 1.0f;
  for (int step = 0; step < 60; ++step) { // until it is half as wide
    pWorld->Step();
    const auto places = pWorld->GetBallPositions();
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        least = std::min(least, (places[i] - places[j]).norm());
  }
  EXPECT_GT(least, 0.15f); // of a diameter of .4
}

} // namespace
} // namespace Shapes
