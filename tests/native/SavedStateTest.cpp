// SPDX-License-Identifier: MIT
// Games that save in every step, to go back to it later: piles and swarms go on as if nobody had saved them,
// and another world takes the same steps from there.
#include "NativeTesting.h"

#include "Piles.h"

namespace Shapes {
namespace {

CPile MakePushedPile(std::uint64_t seed) {
  return {MakeNative(g_cAutomatic, g_fPileGravity), {.m_eVessel = eVessel::Paddle}, CRandom(seed)};
}

/// Balls that a game drives to one place in a room, without gravity.
class CSwarm {
public:
  CSwarm() : m_pWorld(MakeNative(g_cAutomatic)) {
    AddBox(*m_pWorld, 3);
    CRandom random(4);
    for (int i = 0; i < 60; ++i)
      m_pWorld->Add(CDynamicCircleDesc(random.InSquare(2.7f), 0.15f, {0, 0}, 1, 0));
  }
  void Step() {
    for (const CShapeId id : m_pWorld->GetBallIds())
      m_pWorld->SetVel(id, 4 * (Vector2(1, 0.5f) - m_pWorld->GetPos(id)).normalized());
    m_pWorld->Step();
  }

  std::unique_ptr<CWorld> m_pWorld;
};

// With what a search begins with forgotten, a pile of 200 took 1.8 to 2.2 times as long, and under a paddle
// balls came to be 2 radii deep in each other instead of .28.
TEST(SavedState, APileThatIsSavedInEveryStepGoesOnAsIfItWereNot) {
  CPile saved = MakePushedPile(3), other = MakePushedPile(3);
  for (int step = 0; step < 400; ++step) {
    saved.m_pWorld->SaveState();
    saved.Step(step);
    other.Step(step);
    ASSERT_TRUE(HaveSameBits(*saved.m_pWorld, *other.m_pWorld)) << step;
  }
}

TEST(SavedState, ASwarmThatIsSavedInEveryStepGoesOnAsIfItWereNot) {
  CSwarm saved, other;
  for (int step = 0; step < 200; ++step) {
    saved.m_pWorld->SaveState();
    saved.Step();
    other.Step();
    ASSERT_TRUE(HaveSameBits(*saved.m_pWorld, *other.m_pWorld)) << step;
  }
}

TEST(SavedState, AnotherWorldTakesTheSameSteps) {
  CPile pile = MakePushedPile(3), other = MakePushedPile(5);
  for (int step = 0; step < 100; ++step)
    pile.Step(step);
  // Shapes and balls have other places in the arrays of the other one then.
  pile.m_pWorld->Remove(pile.m_pWorld->GetShapeIds()[0]);
  pile.m_pWorld->Remove(pile.m_pWorld->GetBallIds()[7]);
  other.m_pWorld->LoadState(pile.m_pWorld->SaveState());
  for (int step = 100; step < 300; ++step) {
    pile.Step(step);
    other.Step(step);
    ASSERT_TRUE(HaveSameBits(*pile.m_pWorld, *other.m_pWorld)) << step;
  }
}

TEST(SavedState, ASwarmInAnotherWorldTakesTheSameSteps) {
  CSwarm swarm, other;
  for (int step = 0; step < 60; ++step)
    swarm.Step();
  other.m_pWorld->LoadState(swarm.m_pWorld->SaveState());
  for (int step = 0; step < 60; ++step) {
    swarm.Step();
    other.Step();
    ASSERT_TRUE(HaveSameBits(*swarm.m_pWorld, *other.m_pWorld)) << step;
  }
}

// The control: Box2D hands on the places and velocities alone.
TEST(SavedState, APileThatHasBeenOnAnotherEngineTakesOtherSteps) {
  if (GetBackend(eBackend::Box2D) == nullptr) return;
  CPile pile = MakePushedPile(3);
  for (int step = 0; step < 100; ++step)
    pile.Step(step);
  const auto pBetween = GetBackend(eBackend::Box2D)->MakeWorld(pile.m_pWorld->GetDesc());
  pBetween->LoadState(pile.m_pWorld->SaveState());
  const CSavedState without = pBetween->SaveState();
  CPile other = MakePushedPile(3);
  other.m_pWorld->LoadState(without);
  EXPECT_TRUE(HaveSameBits(*pile.m_pWorld, *other.m_pWorld));
  pile.m_pWorld->Step();
  other.m_pWorld->Step();
  EXPECT_FALSE(HaveSameBits(*pile.m_pWorld, *other.m_pWorld));
}

// The rest of a double, beyond the float of a place far away, is no part of another place: a world that keeps
// no such rest flies the ball home, and it comes to a stop there.
TEST(SavedState, RoundingsOfAnotherPlaceAreForgotten) {
  const auto make = [](const char* pEngine, CEffects forbidden = {}) {
    CWorldDesc desc;
    desc.m_vGravity = {0, -10};
    desc.m_cEffects.m_cForbidden = forbidden;
    return GetBackend(pEngine)->MakeWorld(desc);
  };
  std::vector<std::unique_ptr<CWorld>> others;
  others.push_back(make("native", CEffects{eEffect::Continuous}));
  others.push_back(make("native", CEffects{eEffect::Gravity}));
  if (GetBackend("box2d") != nullptr) others.push_back(make("box2d"));
  for (const auto& pOther : others) {
    const auto pFar = make("native"), pHome = make("native");
    const CShapeId ball = pFar->Add(CDynamicCircleDesc({256, 0}, 0.5f, {0.3f, 0}));
    for (int i = 0; i < 21; ++i)
      pFar->Step();
    pOther->LoadState(pFar->SaveState());
    pOther->SetVel(ball, {-90, 0});
    while (pOther->GetPos(ball).x() > 3)
      pOther->Step();
    pHome->LoadState(pOther->SaveState());
    const float x = pHome->GetPos(ball).x();
    pHome->SetVel(ball, {0, 0});
    pHome->Step();
    EXPECT_EQ(pHome->GetPos(ball).x(), x);
  }
}

} // namespace
} // namespace Shapes
