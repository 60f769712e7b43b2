// SPDX-License-Identifier: MIT
// Threads share balls that do not meet each other, and nothing that comes out depends on it.
#include "../../src/native/Lanes.h"

#include "NativeTesting.h"

#include "../Hash.h"

namespace Shapes::Native {
namespace {

using Tests::CHash;

TEST(Lanes, HoldEachBallOnceInItsOrder) {
  for (const unsigned threads : {1u, 2u, 5u})
    for (const std::size_t n : {0u, 1u, 1000u, 5000u, 100001u}) {
      const CLanes lanes(threads);
      const std::size_t count = lanes.Count(n);
      ASSERT_EQ(count > 1, threads > 1 && n > 1000) << threads << " threads, " << n;
      ASSERT_LE(count, lanes.Count(std::numeric_limits<std::size_t>::max()));
      std::vector<std::pair<std::size_t, std::size_t>> ranges(count);
      lanes.ForEach(n, count, [&](std::size_t lane, std::size_t begin, std::size_t end) {
        ranges[lane] = {begin, end};
      });
      std::size_t next = 0;
      for (const auto& [begin, end] : ranges) {
        ASSERT_EQ(begin, next);
        next = end;
      }
      ASSERT_EQ(next, n);
    }
}

// With impulses and counts.
void AddAllTo(CHash& hash, const CWorld& world) {
  AddTo(hash, world);
  for (const CContactEvent& c : world.GetContacts())
    hash.Add(c.m_fImpulse);
  const CWorldStats stats = world.GetStats();
  for (const std::uint64_t n : {stats.m_nShapeTests, stats.m_nSweeps, stats.m_nBallsSwept, stats.m_nContacts,
                                stats.m_nSensorTests, stats.m_nSensorHits, stats.m_nBallsAccelerated})
    hash.Add(static_cast<std::uint32_t>(n));
}

CEffectChoice WithoutPairs(CEffectChoice choice) {
  choice.m_cForbidden.Set(eEffect::BallPairs);
  return choice;
}

constexpr float g_fHalf = 12.0f;

// A crowd of pegs, and balls that meet no others.
std::unique_ptr<CWorld> MakeField(const CEffectChoice& choice, float gravity, unsigned threads) {
  CRandom random(18);
  auto pWorld = MakeNative(WithoutPairs(choice), gravity, g_fDt, 2, threads);
  AddBox(*pWorld, g_fHalf);
  for (const CAnyShapeDesc& peg : MakeCrowd(random, 160, g_fHalf - 1, 0.7f))
    pWorld->Add(peg);
  for (int i = 0; i < 2600; ++i) {
    const Vector2 p = random.InSquare(g_fHalf - 0.5f), v = random.VectorOfLength(0, 8);
    pWorld->Add(CDynamicCircleDesc(p, random.Uniform(0.03f, 0.1f), v, 1.0f, 0.7f));
  }
  return pWorld;
}

// A shape that is moved, a ball that comes and one that goes on the way.
std::uint64_t Play(CWorld& world) {
  CHash hash;
  for (int step = 0; step < 40; ++step) {
    if (step == 18) world.SetPos(world.GetShapeIds()[6], {1, 1});
    if (step == 24) world.Add(CDynamicCircleDesc({0.5f, 0.25f}, 0.05f, {3, 1}));
    if (step == 28) world.Remove(world.GetBallIds()[77]);
    world.Step();
    AddAllTo(hash, world);
  }
  return hash.Get();
}

// Every tenth ball has too many impacts in each of two substeps.
TEST(Lanes, EachTellsTheBallsThatWereHalted) {
  for (const unsigned threads : {1u, 2u}) {
    const auto pWorld = MakeNative(WithoutPairs(g_cContinuous), 0, g_fDt, 2, threads);
    for (const float y : {0.0f, 0.25f})
      pWorld->Add(CLineSegDesc({-1, y}, {1, y}));
    std::vector<CShapeId> fast;
    for (int i = 0; i < 2600; ++i) {
      const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.12f}, 0.1f, {0, i % 10 ? 1.0f : 2e4f}));
      if (i % 10 == 0) fast.push_back(ball);
    }
    pWorld->Step();
    EXPECT_EQ(Halted(*pWorld), fast) << threads << " threads";
    EXPECT_EQ(pWorld->GetStats().m_nBallsHalted, 2 * fast.size());
  }
}

TEST(Lanes, NeitherBitsNorContactsNorCountsDependOnThem) {
  for (const CEffectChoice& choice : {g_cContinuous, g_cApproximate})
    for (const float gravity : {0.0f, 10.0f}) {
      SCOPED_TRACE(gravity);
      const std::uint64_t alone = Play(*MakeField(choice, gravity, 1));
      for (const unsigned threads : {2u, 4u})
        EXPECT_EQ(Play(*MakeField(choice, gravity, threads)), alone) << threads << " threads";
      // The control: one more ball.
      const auto pOther = MakeField(choice, gravity, 2);
      pOther->Add(CDynamicCircleDesc({0, 0}, 0.05f, {1, 0}));
      EXPECT_NE(Play(*pOther), alone);
    }
}

// Without a grid that has lasted, and where balls meet each other, one lane has to do.
TEST(Lanes, ShapesThatMoveInEachStepAndBallsThatMeetStayInOne) {
  const auto play = [](unsigned threads, bool pairs) {
    const auto pWorld = MakeNative(pairs ? g_cAutomatic : WithoutPairs(g_cAutomatic), 10, g_fDt, 1, threads);
    CRandom random(5);
    const CShapeId wall = pWorld->Add(CLineSegDesc({-20, 0}, {20, 0}));
    for (int i = 0; i < 1200; ++i) {
      const Vector2 v = random.InSquare(2), p = random.InSquare(15) + Vector2(0, 16);
      pWorld->Add(CDynamicCircleDesc(p, 0.05f, v));
    }
    CHash hash;
    for (int step = 0; step < 20; ++step) {
      if (!pairs) pWorld->SetPos(wall, {0, 0.01f * static_cast<float>(step)});
      pWorld->Step();
      AddAllTo(hash, *pWorld);
    }
    return hash.Get();
  };
  for (const bool pairs : {false, true})
    EXPECT_EQ(play(4, pairs), play(1, pairs)) << pairs;
}

} // namespace
} // namespace Shapes::Native
