// SPDX-License-Identifier: MIT
// Balls that a game steers, step by step, into each other and against walls: they are solved together as a
// pile is, with gravity and without.
#include "NativeTesting.h"

#include <functional>

namespace Shapes {
namespace {

using CSteer = std::function<Vector2(const Vector2& place, const Vector2& velocity)>;

struct CSteered {
  std::unique_ptr<CWorld> m_pWorld;
  CSteer m_cSteer; // the velocity of a ball at the beginning of a step
};

constexpr float g_fHalf = 3, g_fSmall = 0.15f; // half of the room, radius

void AddBalls(CWorld& world, int balls, float e, std::uint64_t seed) {
  CRandom random(seed);
  for (int i = 0; i < balls; ++i)
    world.Add(CDynamicCircleDesc(random.InSquare(g_fHalf - 2 * g_fSmall), g_fSmall, {0, 0}, 1, e));
}

CSteered MakeCorner(float gravity, float speed, unsigned substeps = 1) {
  CSteered steered{MakeNative(g_cAutomatic, gravity, g_fDt, substeps),
                   [=](const Vector2&, const Vector2&) { return Vector2(-0.8f * speed, -0.6f * speed); }};
  AddBox(*steered.m_pWorld, g_fHalf);
  AddBalls(*steered.m_pWorld, 60, 0.3f, 1);
  return steered;
}

// All fall to the middle at 10 units/s^2, which only the game knows.
CSteered MakePlanet() {
  CSteered steered{MakeNative(g_cAutomatic), [](const Vector2& p, const Vector2& v) {
                     return Vector2(0.995f * v - 10 * g_fDt * p.normalized());
                   }};
  AddBox(*steered.m_pWorld, g_fHalf);
  AddBalls(*steered.m_pWorld, 60, 0, 2);
  return steered;
}

// A swarm that follows a goal, far from all walls.
CSteered MakeSwarm(float speed) {
  CSteered steered{MakeNative(g_cAutomatic, 10), [=](const Vector2& p, const Vector2&) {
                     return Vector2(speed * (Vector2(0.1f, 0.2f) - p).normalized());
                   }};
  AddBox(*steered.m_pWorld, 10);
  AddBalls(*steered.m_pWorld, 150, 0.5f, 3);
  return steered;
}

struct CPlayed {
  std::uint64_t m_nContacts = 0, m_nHalted = 0; // in the mean of a ball and a step; balls
  double m_fOverlap = 0;                        // the largest in the last tenth, in radii
  std::ptrdiff_t m_nLost = 0;
};

CPlayed Play(CSteered& steered, int steps, float half = g_fHalf) {
  CWorld& world = *steered.m_pWorld;
  CPlayed played;
  for (int step = 0; step < steps; ++step) {
    for (const CShapeId id : world.GetBallIds())
      world.SetVel(id, steered.m_cSteer(world.GetPos(id), world.GetVel(id)));
    world.Step();
    if (step * 10 > steps * 9) played.m_fOverlap = std::max(played.m_fOverlap, GetOverlap(world));
    played.m_nLost = std::max(played.m_nLost, CountBalls(world, [&](const Vector2& p) {
                                return !(p.allFinite() && p.cwiseAbs().maxCoeff() < half);
                              }));
  }
  const auto all = static_cast<std::uint64_t>(steps) * world.GetBallIds().size();
  played.m_nContacts = world.GetStats().m_nContacts / all;
  played.m_nHalted = world.GetStats().m_nBallsHalted;
  return played;
}

// By impacts, one after the other, each ball had 26 to 129 contacts a step, and a third to three quarters of
// all were halted in each: 11,890 to 26,367 times.
TEST(Steered, BallsThatAreDrivenIntoEachOtherAreSolvedTogether) {
  const auto expect = [](CSteered steered, const char* name, double overlap, float half = g_fHalf) {
    SCOPED_TRACE(name);
    const CPlayed played = Play(steered, 600, half);
    EXPECT_EQ(played.m_nLost, 0);
    EXPECT_LT(played.m_nContacts, 10u);
    EXPECT_LT(played.m_nHalted, 400u);
    EXPECT_LT(played.m_fOverlap, overlap);
  };
  expect(MakeCorner(0, 1), "a corner", 0.02);
  expect(MakeCorner(0, 5), "a corner, fast", 0.05);
  expect(MakeCorner(10, 1), "a corner, with gravity", 0.1);
  expect(MakeCorner(10, 5), "a corner, fast, with gravity", 0.05);
  expect(MakeCorner(10, 1, 4), "a corner, with gravity, four substeps", 0.01);
  expect(MakePlanet(), "a planet", 0.01);
  for (const float speed : {2.0f, 5.0f, 20.0f})
    expect(MakeSwarm(speed), "a swarm", 0.2, 10);
}

// Each ball is driven as far as its own diameter and more in a step.
TEST(Steered, DrivenBallsGoThroughNoWall) {
  for (const float gravity : {0.0f, 10.0f})
    for (const float speed : {1.0f, 20.0f, 300.0f})
      for (const bool isOneSided : {false, true}) {
        SCOPED_TRACE(testing::Message()
                     << "gravity " << gravity << ", speed " << speed << ", one-sided " << isOneSided);
        CSteered steered{MakeNative(g_cAutomatic, gravity), [=](const Vector2& p, const Vector2&) {
                           return Vector2(speed * (p + Vector2(-5, -4)).normalized());
                         }};
        for (CLineSegDesc wall : Walls({-g_fHalf, -g_fHalf}, {g_fHalf, g_fHalf}, 1)) {
          const bool isFrontInside = wall.GetNormal().dot(wall.GetEndPt0()) < 0;
          if (isOneSided) wall.m_eSides = isFrontInside ? eSides::Front : eSides::Back;
          steered.m_pWorld->Add(wall);
        }
        AddBalls(*steered.m_pWorld, 60, 0.3f, 4);
        EXPECT_EQ(Play(steered, 120).m_nLost, 0);
      }
}

// Balls that a game drives into a corner and then leaves alone gain nothing and come apart.
TEST(Steered, WhatIsLeftAloneGainsNoEnergy) {
  for (const float speed : {1.0f, 20.0f}) {
    CSteered steered = MakeCorner(0, speed);
    CWorld& world = *steered.m_pWorld;
    Play(steered, 300);
    const std::uint64_t halted = world.GetStats().m_nBallsHalted;
    double energy = GetEnergy(world, 0);
    InEachStep(world, 300, [&](int) {
      const double before = std::exchange(energy, GetEnergy(world, 0));
      EXPECT_LE(energy, before * (1 + 1e-6));
    });
    EXPECT_LT(world.GetStats().m_nBallsHalted - halted, 300u);
    EXPECT_LT(GetOverlap(world), 1e-3);
  }
}

// Without gravity, inelastic balls that are blown apart and come together again in clusters: if these are
// solved together only in every other step, 8,953 are halted.
TEST(Steered, AnExplosionEachSecondHaltsFew) {
  const std::unique_ptr<CWorld> pWorld = MakeNative(g_cAutomatic);
  AddBox(*pWorld, g_fHalf);
  AddBalls(*pWorld, 150, 0.3f, 1);
  for (int step = 0; step < 600; ++step) {
    if (step % 60 == 0)
      for (const CShapeId id : pWorld->GetBallIds()) {
        const Vector2 d = pWorld->GetPos(id) - Vector2(0, -2);
        pWorld->SetVel(id, pWorld->GetVel(id) + 30 / (1 + d.squaredNorm()) * d.normalized());
      }
    pWorld->Step();
  }
  EXPECT_LT(pWorld->GetStats().m_nBallsHalted, 5000u);
}

} // namespace
} // namespace Shapes
