// SPDX-License-Identifier: MIT
// Balls of a tuned world that roll, rest, pile up, and are pressed by walls.
#include "Piles.h"
#include "TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr double g_fMostOffFloor = 2 * g_fTunedOffset;
const Vector2 g_vGravity(0, -9.81f);

struct CStay {
  double m_fOff = 0;   // farthest from where they should be, metres
  double m_fSpeed = 0; // the most that one is too fast, or too slow
};

/// Of balls that should be in these places, or go on from there at `vel`, in some steps.
CStay Watch(CWorld& world, const std::vector<Vector2>& places, int steps, const Vector2& vel = {0, 0}) {
  CStay stay;
  for (int i = 1; i <= steps; ++i) {
    world.Step();
    const Vector2 way = static_cast<float>(i) * g_fDt * vel;
    for (std::size_t k = 0; k < places.size(); ++k) {
      stay.m_fOff = std::max<double>(stay.m_fOff, (world.GetBallPositions()[k] - places[k] - way).norm());
      stay.m_fSpeed = std::max<double>(stay.m_fSpeed, (world.GetBallVelocities()[k] - vel).norm());
    }
  }
  return stay;
}

/// Rolls along eleven segments in line, over their ten shared ends.
CStay Roll(const CTuning& tuning, float elasticity) {
  auto pWorld = MakeBox2D(tuning, g_vGravity);
  for (int i = 0; i < 11; ++i)
    pWorld->Add(CLineSegDesc({static_cast<float>(i), 0}, {static_cast<float>(i + 1), 0}));
  const Vector2 place(0.5f, 0.1f), vel(3, 0);
  pWorld->Add(CDynamicCircleDesc(place, 0.1f, vel, 1, elasticity));
  return Watch(*pWorld, {place}, 200, vel);
}

TEST(TunedFloorTest, ABallRollsOverTenJointsAndKeepsItsSpeed) {
  for (const float elasticity : {0.0f, 0.5f}) {
    SCOPED_TRACE(elasticity);
    const CStay stay = Roll(g_cTuned, elasticity);
    EXPECT_LE(stay.m_fOff, g_fMostOffFloor);
    EXPECT_LE(stay.m_fSpeed, 1e-4);
    EXPECT_GT(Roll(g_cShipped, elasticity).m_fOff, g_fMostOffFloor); // the control
  }
}

/// Lies for 60 s, after 2 s in which it may bounce if it is dropped.
CStay Rest(const CTuning& tuning, float elasticity, float drop) {
  auto pWorld = MakeBox2D(tuning, g_vGravity);
  pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  pWorld->Add(CDynamicCircleDesc({0, 0.1f + drop}, 0.1f, {0, 0}, 1, elasticity));
  if (drop > 0) Steps(*pWorld, 2 * 60);
  return Watch(*pWorld, {{0, 0.1f}}, 62 * 60);
}

TEST(TunedFloorTest, ABallRestsOnTheFloor) {
  for (const float elasticity : {0.0f, 0.5f})
    for (const float drop : {0.0f, 0.05f}) {
      SCOPED_TRACE(testing::Message() << "elasticity " << elasticity << ", from " << drop);
      const CStay stay = Rest(g_cTuned, elasticity, drop);
      EXPECT_LE(stay.m_fOff, g_fMostOffFloor);
      EXPECT_LE(stay.m_fSpeed, 0.01);
    }
  EXPECT_GT(Rest(g_cShipped, 0, 0).m_fOff, 2 * g_fMostOffFloor); // the control: above it, or trembling
  EXPECT_GT(Rest(g_cShipped, 0.5f, 0).m_fSpeed, 0.1);
}

/// Three balls on a floor between two walls that are a little farther apart than a ball is wide: they lean
/// against the walls in turn.
CStay Stack(const CTuning& tuning, float elasticity) {
  auto pWorld = MakeBox2D(tuning, g_vGravity);
  pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  for (const float x : {-0.105f, 0.105f})
    pWorld->Add(CLineSegDesc({x, -0.5f}, {x, 2}));
  const float rise = std::sqrt(0.2f * 0.2f - 0.01f * 0.01f);
  const std::vector<Vector2> places{{-0.005f, 0.1f}, {0.005f, 0.1f + rise}, {-0.005f, 0.1f + 2 * rise}};
  for (const Vector2& p : places)
    pWorld->Add(CDynamicCircleDesc(p, 0.1f, {0, 0}, 1, elasticity));
  const CStay first = Watch(*pWorld, places, 10 * 60), last = Watch(*pWorld, places, 10 * 60);
  return {std::max(first.m_fOff, last.m_fOff), last.m_fSpeed};
}

TEST(TunedFloorTest, AStackBetweenTwoWallsStays) {
  for (const float elasticity : {0.0f, 0.5f}) {
    SCOPED_TRACE(elasticity);
    const CStay stay = Stack(g_cTuned, elasticity);
    EXPECT_LE(stay.m_fOff, 3 * g_fMostOffFloor); // three contacts carry the topmost
    EXPECT_LE(stay.m_fSpeed, 0.01);
  }
  const CStay shipped = Stack(g_cShipped, 0.5f); // the control
  EXPECT_GT(shipped.m_fOff, 3 * g_fMostOffFloor);
  EXPECT_GT(shipped.m_fSpeed, 0.1);
}

constexpr eVessel g_eVessels[] = {eVessel::Box, eVessel::V, eVessel::Bowl};
constexpr std::uint64_t g_nPileSeed = 83;

CPile MakePile(const CTuning& tuning, const CPileDesc& desc, const CEffects& forced = {},
               std::uint64_t seed = g_nPileSeed) {
  return {MakeBox2D(tuning, {0, -g_fPileGravity}, g_fDt, forced), desc, CRandom(seed)};
}

/// The deepest of a ball and the vessel, in radii.
double GetDepth(const CPile& pile) {
  double most = 0;
  for (const Vector2& p : pile.m_pWorld->GetBallPositions())
    most = std::max<double>(most, 1 - pile.GetRoom(p) / g_fLargestBall);
  return most;
}

TEST(TunedPileTest, APileSettlesAndLosesNone) {
  for (const eVessel kind : g_eVessels)
    for (const auto& [balls, e] : {std::pair(10, 0.0f), {10, 0.5f}, {10, 0.9f}, {50, 0.5f}, {50, 0.9f}}) {
      SCOPED_TRACE(testing::Message()
                   << "vessel " << static_cast<int>(kind) << ", " << balls << " balls, e = " << e);
      const CPile pile = MakePile(g_cTuned, {kind, balls, e});
      const double first = pile.GetEnergy();
      InEachStep(*pile.m_pWorld, 600, [&](int) {
        EXPECT_EQ(pile.CountLost(), 0);
        EXPECT_LE(pile.GetEnergy(), 1.001 * first);
      });
      // A ball that slides in a bowl slides on.
      EXPECT_LT(GetFastest(*pile.m_pWorld), kind == eVessel::Bowl ? 1.0 : 0.2);
      EXPECT_LT(GetOverlap(*pile.m_pWorld), 0.1);
    }
}

struct CSettling {
  double m_fOverlap = 0; // the largest after a step, of two balls or of a ball and the vessel, radii
  double m_fRise = 0;    // of the energy above the least so far, as a share of the first
};

/// Sums over several piles while they settle; none is lost.
CSettling Settle(const CTuning& tuning, eVessel kind, int balls, int runs, int steps) {
  CSettling sum;
  for (int run = 0; run < runs; ++run) {
    const CPile pile = MakePile(tuning, {kind, balls}, {}, g_nPileSeed + static_cast<std::uint64_t>(run));
    const double first = pile.GetEnergy();
    double least = first, overlap = 0, rise = 0;
    for (int i = 0; i < steps; ++i) {
      pile.m_pWorld->Step();
      EXPECT_EQ(pile.CountLost(), 0) << i;
      overlap = std::max({overlap, GetOverlap(*pile.m_pWorld), GetDepth(pile)});
      least = std::min(least, pile.GetEnergy());
      rise = std::max(rise, (pile.GetEnergy() - least) / first);
    }
    sum.m_fOverlap += overlap;
    sum.m_fRise += rise;
  }
  return sum;
}

// Where Box2D moves balls into each other it moves them apart again, also upwards. The bottom of a V at 30
// units per second, with 200 balls, is where most press on one.
TEST(TunedPileTest, APileThatSettlesOverlapsAndGainsLessThanOnShippedBox2D) {
  for (const eVessel kind : g_eVessels)
    for (const int balls : {10, 50, 200}) {
      SCOPED_TRACE(testing::Message() << "vessel " << static_cast<int>(kind) << ", " << balls << " balls");
      const int runs = balls == 200 ? 1 : 4, steps = balls == 200 ? 300 : 240;
      const CSettling tuned = Settle(g_cTuned, kind, balls, runs, steps),
                      shipped = Settle(g_cShipped, kind, balls, runs, steps);
      EXPECT_LT(tuned.m_fOverlap, shipped.m_fOverlap);
      EXPECT_LT(tuned.m_fRise, 0.5 * shipped.m_fRise);
      if (balls != 200 || kind != eVessel::V) continue;
      const CSettling control = Settle(Without(&CTuning::m_bAdaptiveSubsteps), kind, balls, runs, steps);
      EXPECT_GT(control.m_fOverlap, 2 * tuned.m_fOverlap);
      EXPECT_GT(control.m_fRise, 2 * tuned.m_fRise);
    }
}

TEST(TunedPileTest, APileIsSolvedAboutAsOftenAsByShippedBox2D) {
  const auto count = [](const CTuning& tuning, eVessel kind, int steps) {
    const CPile pile = MakePile(tuning, {kind, 10}, {eEffect::Events}); // for the listener, which counts
    Steps(*pile.m_pWorld, steps);
    return static_cast<double>(pile.m_pWorld->GetStats().m_nEngineContacts);
  };
  for (const eVessel kind : g_eVessels)
    EXPECT_LT(count(g_cTuned, kind, 600), 3 * count(g_cShipped, kind, 600)) << static_cast<int>(kind);
  EXPECT_GT(count(Without(&CTuning::m_bLastingContact), eVessel::V, 300),
            10 * count(g_cShipped, eVessel::V, 300)); // the control
}

TEST(TunedPileTest, BallsInOnePlaceComeApart) {
  const auto solve = [](const CTuning& tuning, int balls, int steps) {
    auto pWorld = MakeBox2D(tuning, {0, -g_fPileGravity}, g_fDt, {eEffect::Events});
    pWorld->Add(CArcDesc({0, 0}, 4, 0, 0));
    CRandom random(83);
    for (int i = 0; i < balls; ++i)
      pWorld->Add(CDynamicCircleDesc({EitherSign<float>(random, 1e-3), 0}, g_fLargestBall, {0, 0}, 1, 0.5f));
    Steps(*pWorld, steps);
    for (const Vector2& p : pWorld->GetBallPositions())
      EXPECT_LT(p.norm(), 4);
    return static_cast<double>(pWorld->GetStats().m_nEngineContacts);
  };
  EXPECT_LT(solve(g_cTuned, 60, 120), 2 * solve(g_cShipped, 60, 120));
  EXPECT_GT(solve(Without(&CTuning::m_bLastingContact), 12, 12),
            10 * solve(g_cShipped, 12, 12)); // the control
}

constexpr std::uint64_t g_nCrushSeed = 47;
constexpr float g_fCrushRadius = 0.2f, g_fWallSpeed = 2;

struct CCrush {
  float m_fFastest = 0;
  double m_fOverlap = 0; // radii, at the end
};

// Twenty balls on a floor, between two walls that close until nine are where six have room, stay there for
// two seconds, open, and close again, three times.
CCrush Crush(const CTuning& tuning, std::uint64_t seed) {
  const auto pWorld = MakeBox2D(tuning, {0, -10});
  pWorld->Add(CLineSegDesc({-3, 0}, {3, 0}));
  const CShapeId left = pWorld->Add(Turning(CLineSegDesc({-2.2f, 0.05f}, {-2.2f, 9}))),
                 right = pWorld->Add(Turning(CLineSegDesc({2.2f, 0.05f}, {2.2f, 9})));
  CRandom random(seed);
  for (int i = 0; i < 20; ++i) {
    const float x = -0.94f + 0.47f * static_cast<float>(i % 5) + EitherSign<float>(random, 0.01);
    const float y = 0.4f + 0.5f * static_cast<float>(i / 5);
    pWorld->Add(CDynamicCircleDesc({x, y}, g_fCrushRadius, {0, 0}, 1, 0.5f));
  }
  CCrush crush;
  const auto play = [&](float inward, int steps) {
    pWorld->SetVel(left, {inward, 0});
    pWorld->SetVel(right, {-inward, 0});
    for (int i = 0; i < steps; ++i) {
      pWorld->Step();
      crush.m_fFastest = std::max(crush.m_fFastest, GetFastest(*pWorld));
    }
  };
  for (int round = 0; round < 3; ++round) {
    play(g_fWallSpeed, 33);
    play(0, 120);
    if (round < 2) play(-g_fWallSpeed, 33);
  }
  crush.m_fOverlap = GetOverlap(*pWorld);
  return crush;
}

TEST(TunedCrushTest, BallsThatWallsPressTogetherAreNeitherShotOutNorStayInEachOther) {
  for (std::uint64_t seed = g_nCrushSeed; seed < g_nCrushSeed + 4; ++seed) {
    SCOPED_TRACE(seed);
    const CCrush crush = Crush(g_cTuned, seed);
    EXPECT_LT(crush.m_fFastest, 5 * g_fWallSpeed);
    EXPECT_LT(crush.m_fOverlap, 0.15);
  }
  EXPECT_GT(Crush(Without(&CTuning::m_bLastingContact), g_nCrushSeed + 1).m_fOverlap, 0.3); // the control
}

// Runs of ten seconds in which one of three balls gets out of a ring with a bar that turns in it and leaves
// them too little room.
int CountLostToABar(eSides sides, int runs) {
  CRandom random(g_nCrushSeed);
  int lost = 0;
  for (int run = 0; run < runs; ++run) {
    const auto pWorld = MakeBox2D(g_cTuned, {0, 0});
    pWorld->Add(Sided(CArcDesc({0, 0}, 1, 0, 0), sides));
    pWorld->Add(Turning(CLineSegDesc({-0.75f, 0}, {0.75f, 0}), 1));
    for (int i = 0; i < 3; ++i) {
      const float vx = EitherSign<float>(random, 1), vy = EitherSign<float>(random, 1);
      pWorld->Add(CDynamicCircleDesc({0.5f * static_cast<float>(i - 1), 0.35f}, 0.15f, {vx, vy}, 1, 0.7f));
    }
    Steps(*pWorld, 600);
    lost += std::ranges::any_of(pWorld->GetBallPositions(), [](const Vector2& p) { return !(p.norm() < 1); });
  }
  return lost;
}

TEST(TunedCrushTest, ABallThatABarSqueezesStaysInItsRing) {
  EXPECT_EQ(CountLostToABar(eSides::Both, 10), 0);
  EXPECT_GT(CountLostToABar(eSides::Back, 3), 0); // the control: a ball may be on its way through this one
}

} // namespace
} // namespace Shapes::Tests
