// SPDX-License-Identifier: MIT
// Balls that sleep: a change wakes all that it could move, and nothing else.
#include "NativeTesting.h"

#include "Tolerances.h"

namespace Shapes {
namespace {

constexpr float g_fHeapBall = 0.1f;

/// Heaps of six balls in trays with two walls, far from each other; and what may be put to them.
struct CHeaps {
  std::unique_ptr<CWorld> m_pWorld = MakeNative(g_cAutomatic, 10);
  std::vector<CShapeId> m_stdFloors, m_stdShapes;
  CShapeId m_cSpare, m_cSensor;

  explicit CHeaps(CRandom random, int heaps = 4) {
    for (int i = 0; i < heaps; ++i)
      AddHeap({20.0f * static_cast<float>(i), random.Uniform(-5, 5)}, random);
    m_cSpare = m_pWorld->Add(CCircleDesc({-50, 0}, 0.3f));
    m_cSensor = m_pWorld->Add(CCircleDesc({-60, 0}, 0.3f));
    m_pWorld->SetSensor(m_cSensor, true);
    Steps(*m_pWorld, 400);
  }

  /// Of the balls that have moved since these were the places, how far they are.
  static float GetFarthest(std::span<const Vector2> before, std::span<const Vector2> after) {
    float farthest = 0.0f;
    for (std::size_t i = 0; i < before.size(); ++i)
      farthest = std::max(farthest, (after[i] - before[i]).norm());
    return farthest;
  }

private:
  void AddHeap(const Vector2& at, CRandom& random) {
    for (const float side : {-1.0f, 1.0f})
      m_stdShapes.push_back(m_pWorld->Add(CLineSegDesc(at + Vector2(0.4f * side, 0), at + Vector2(side, 2))));
    m_stdFloors.push_back(m_pWorld->Add(Turning(CLineSegDesc(at - Vector2(2, 0), at + Vector2(2, 0)))));
    m_stdShapes.push_back(m_stdFloors.back());
    for (int i = 0; i < 6; ++i) {
      const Vector2 shift = random.InSquare(0.02f);
      m_pWorld->Add(CDynamicCircleDesc(at + Vector2(0, 0.2f + 0.21f * static_cast<float>(i)) + shift,
                                       g_fHeapBall, {0, 0}, 1, 0.2f));
    }
  }
};

struct CChange {
  const char* m_sName;
  std::function<void(CHeaps& heaps, CRandom& random)> m_stdMake;
  bool m_bMoves = true;             ///< Balls move by it, at least in some heaps.
  std::size_t m_nMostElsewhere = 0; ///< Of 16 heaps, as it throws balls about.
};

std::vector<CChange> GetChanges() {
  const auto ball = [](const CHeaps& heaps, CRandom& random) {
    const auto ids = heaps.m_pWorld->GetBallIds();
    return ids[random.Below(static_cast<std::uint32_t>(ids.size()))];
  };
  const auto shape = [](const CHeaps& heaps, CRandom& random) {
    return heaps.m_stdShapes[random.Below(static_cast<std::uint32_t>(heaps.m_stdShapes.size()))];
  };
  const auto floor = [](const CHeaps& heaps, CRandom& random) {
    return heaps.m_stdFloors[random.Below(static_cast<std::uint32_t>(heaps.m_stdFloors.size()))];
  };
  const CFilter none{1, 0};
  return {
      {"a ball gets a velocity",
       [=](auto& h, auto& r) {
         h.m_pWorld->SetVel(ball(h, r), {3, 4});
       },
       true, 4},
      {"a ball is elsewhere",
       [=](auto& h, auto& r) {
         h.m_pWorld->SetPos(ball(h, r), {-40, 0});
       }},
      {"a ball comes to others",
       [=](auto& h, auto& r) {
         const CShapeId mover = ball(h, r);
         h.m_pWorld->SetPos(mover, h.m_pWorld->GetPos(ball(h, r)) + Vector2(0.05f, 0.15f));
       }},
      {"a ball is removed", [=](auto& h, auto& r) { h.m_pWorld->Remove(ball(h, r)); }},
      {"a ball becomes a sensor", [=](auto& h, auto& r) { h.m_pWorld->SetSensor(ball(h, r), true); }},
      {"a ball is turned off", [=](auto& h, auto& r) { h.m_pWorld->SetCanCollide(ball(h, r), false); }},
      {"a ball meets nothing", [=](auto& h, auto& r) { h.m_pWorld->SetFilter(ball(h, r), none); }},
      {"a ball is added",
       [=](auto& h, auto& r) {
         h.m_pWorld->Add(
             CDynamicCircleDesc(h.m_pWorld->GetPos(ball(h, r)) + Vector2(0.05f, 0.15f), g_fHeapBall));
       }},
      {"a shape is added",
       [=](auto& h, auto& r) {
         h.m_pWorld->Add(CCircleDesc(h.m_pWorld->GetPos(ball(h, r)) + Vector2(0.1f, 0.1f), 0.1f));
       },
       true, 4},
      {"a shape is removed", [=](auto& h, auto& r) { h.m_pWorld->Remove(shape(h, r)); }},
      {"a floor is removed", [=](auto& h, auto& r) { h.m_pWorld->Remove(floor(h, r)); }},
      {"a floor goes down",
       [=](auto& h, auto& r) {
         const CShapeId id = floor(h, r);
         h.m_pWorld->SetPos(id, h.m_pWorld->GetPos(id) - Vector2(0, 5));
       }},
      {"a floor turns", [=](auto& h, auto& r) { h.m_pWorld->SetOrientation(floor(h, r), 0.3f); }},
      {"a floor becomes a sensor", [=](auto& h, auto& r) { h.m_pWorld->SetSensor(floor(h, r), true); }},
      {"a floor is turned off", [=](auto& h, auto& r) { h.m_pWorld->SetCanCollide(floor(h, r), false); }},
      {"a floor meets nothing", [=](auto& h, auto& r) { h.m_pWorld->SetFilter(floor(h, r), none); }},
      {"a floor moves",
       [=](auto& h, auto& r) {
         h.m_pWorld->SetVel(floor(h, r), {0, -0.5f});
       }},
      {"another shape comes",
       [=](auto& h, auto& r) {
         h.m_pWorld->SetPos(h.m_cSpare, h.m_pWorld->GetPos(ball(h, r)) + Vector2(0.2f, 0.3f));
       },
       true, 4},
      {"a sensor comes",
       [=](auto& h, auto& r) { h.m_pWorld->SetPos(h.m_cSensor, h.m_pWorld->GetPos(ball(h, r))); }, false},
      {"a sensor becomes solid",
       [=](auto& h, auto& r) {
         h.m_pWorld->SetPos(h.m_cSensor, h.m_pWorld->GetPos(ball(h, r)) + Vector2(0.2f, 0.3f));
         h.m_pWorld->SetSensor(h.m_cSensor, false);
       },
       true, 4},
      {"a ball is as elastic as never before",
       [=](auto& h, auto& r) { h.m_pWorld->SetElasticity(ball(h, r), 1); }, false},
  };
}

// After each change the balls go as they would if all had been woken. Where it throws them about, some that
// are woken earlier meet others elsewhere, in up to 9 of 100 heaps.
TEST(Sleep, AChangeWakesAllThatItCouldMove) {
  std::vector<CHeaps> all;
  std::vector<CSavedState> saved;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    all.emplace_back(CRandom(seed));
    saved.push_back(all.back().m_pWorld->SaveState());
    ASSERT_EQ(GetFastest(*all.back().m_pWorld), 0.0f);
  }
  for (const CChange& change : GetChanges()) {
    float farthest = 0.0f;
    std::vector<std::uint64_t> elsewhere; // seeds
    for (std::uint64_t seed = 0; seed < all.size(); ++seed) {
      CHeaps& heaps = all[seed];
      CWorld& world = *heaps.m_pWorld;
      const auto play = [&](bool isAllWoken) {
        world.LoadState(saved[seed]);
        CRandom random(seed);
        change.m_stdMake(heaps, random);
        world.LoadState(world.SaveState()); // what was changed is remembered
        if (isAllWoken) world.SetGravity(world.GetDesc().m_vGravity);
        const std::vector<Vector2> before(world.GetBallPositions().begin(), world.GetBallPositions().end());
        Steps(world, 10);
        const std::vector<Vector2> after(world.GetBallPositions().begin(), world.GetBallPositions().end());
        return std::pair(before, after);
      };
      const auto [before, woken] = play(true);
      const auto [same, after] = play(false);
      farthest = std::max(farthest, CHeaps::GetFarthest(before, woken));
      // A ball that hangs in the air is off by 1.4 radii.
      if (CHeaps::GetFarthest(woken, after) > 0.3f * g_fHeapBall) elsewhere.push_back(seed);
    }
    EXPECT_LE(elsewhere.size(), change.m_nMostElsewhere)
        << change.m_sName << ", seeds " << testing::PrintToString(elsewhere);
    EXPECT_EQ(farthest > 0.1f * g_fHeapBall, change.m_bMoves) << change.m_sName; // the control
  }
}

// Of four heaps one is looked at, as long as something is changed there.
TEST(Sleep, AChangeWakesNoOthers) {
  for (const CChange& change : GetChanges()) {
    SCOPED_TRACE(change.m_sName);
    CHeaps heaps{CRandom(9)};
    CWorld& world = *heaps.m_pWorld;
    const std::uint64_t before = world.GetStats().m_nBallsSwept;
    CRandom random(9);
    change.m_stdMake(heaps, random);
    Steps(world, 10);
    EXPECT_LE(world.GetStats().m_nBallsSwept - before, 10u * 13u); // of two heaps, and what was added
  }
}

/// Balls that the next step looks at.
std::uint64_t CountSwept(CWorld& world) {
  const std::uint64_t before = world.GetStats().m_nBallsSwept;
  world.Step();
  return world.GetStats().m_nBallsSwept - before;
}

// A player that is driven, an obstacle that is dragged, balls and bricks that come and go: the rest sleeps
// on.
TEST(Sleep, AGameThatGoesOnFarAwayWakesNone) {
  CHeaps heaps{CRandom(10)};
  CWorld& world = *heaps.m_pWorld;
  const CShapeId player = world.Add(CDynamicCircleDesc({-30, 0}, g_fHeapBall));
  std::uint64_t swept = 0;
  InEachStep(world, 200, [&](int step) {
    const float x = -30 + 0.01f * static_cast<float>(step);
    world.SetVel(player, {0.6f, 0.1f});
    world.SetPos(heaps.m_cSpare, {x - 10, 3});
    world.Remove(world.Add(CLineSegDesc({x, 5}, {x, 6})));
    world.Remove(world.Add(CDynamicCircleDesc({x, 8}, g_fHeapBall)));
    swept += CountSwept(world);
  });
  EXPECT_EQ(swept, 0u);
  world.SetGravity(world.GetDesc().m_vGravity);
  EXPECT_GT(CountSwept(world), 12u); // the control
}

// A game that slows all balls down in each step, which a ball at rest does not feel.
TEST(Sleep, ADragLeavesBallsAsleep) {
  CHeaps heaps{CRandom(12)};
  CWorld& world = *heaps.m_pWorld;
  const CSavedState asleep = world.SaveState();
  const auto playWithDrag = [&](int steps) {
    for (int step = 0; step < steps; ++step) {
      for (const CShapeId ball : world.GetBallIds())
        world.SetVel(ball, 0.99f * world.GetVel(ball));
      world.Step();
    }
  };
  playWithDrag(10);
  EXPECT_EQ(CountSwept(world), 0u);
  world.LoadState(asleep);
  world.SetGravity(world.GetDesc().m_vGravity);
  playWithDrag(120);
  EXPECT_EQ(CountSwept(world), 0u); // they have fallen asleep again
  world.SetElasticity(heaps.m_stdFloors[0], 0.3f);
  world.SetUserPtr(heaps.m_stdFloors[0], &world);
  EXPECT_EQ(CountSwept(world), 0u);
}

// More changes than are remembered.
TEST(Sleep, ThousandsOfChangesWakeAll) {
  for (const std::size_t more : {0u, 1u}) {
    CHeaps heaps{CRandom(11)};
    for (std::size_t i = 0; i < g_nMostDisturbed / 2 + more; ++i) // two for each: where it was, and is
      heaps.m_pWorld->SetPos(heaps.m_cSpare, {-50, static_cast<float>(i % 7)});
    EXPECT_EQ(CountSwept(*heaps.m_pWorld) > 12, more > 0);
  }
}

} // namespace
} // namespace Shapes
