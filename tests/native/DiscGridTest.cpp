// SPDX-License-Identifier: MIT
#include "native/broadphase/DiscGrid.h"

#include "../Testing.h"
#include "traps/Traps.h"

namespace Shapes::Native {
namespace {

using CDisc = CDiscGrid::CDisc;

CDiscGrid MakeGrid(const std::vector<CDisc>& discs) {
  CDiscGrid grid;
  grid.Build(discs);
  return grid;
}

// The answer of the pair kernel.
bool Overlap(const CDisc& a, const CDisc& b) {
  return Length(b.m_vCenter - a.m_vCenter) < a.m_fRadius + b.m_fRadius;
}

std::vector<std::uint32_t> Ask(const CDiscGrid& grid, const CDisc& disc) {
  std::vector<std::uint32_t> found;
  grid.FindNear(disc.m_vCenter, disc.m_fRadius, [&found](std::uint32_t i) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Each of the discs that this one overlaps is among the answers; returns how many there were.
std::size_t ExpectFound(const CDiscGrid& grid, const std::vector<CDisc>& discs, const CDisc& disc) {
  const std::vector<std::uint32_t> found = Ask(grid, disc);
  std::size_t overlaps = 0;
  for (std::uint32_t j = 0; j < discs.size(); ++j) {
    if (!Overlap(disc, discs[j])) continue;
    EXPECT_TRUE(std::binary_search(found.begin(), found.end(), j))
        << j << ", radii " << disc.m_fRadius << ' ' << discs[j].m_fRadius;
    ++overlaps;
  }
  return overlaps;
}

// Of all of them; returns how often one overlaps another.
std::size_t ExpectAllFound(const CDiscGrid& grid, const std::vector<CDisc>& discs) {
  std::size_t overlaps = 0;
  for (const CDisc& disc : discs)
    overlaps += ExpectFound(grid, discs, disc) - Overlap(disc, disc);
  return overlaps;
}

// Discs of these radii, each placed where it just overlaps or just misses one of the others.
std::vector<CDisc> Clusters(CRandom& random, std::size_t n, const Vector2& centre,
                            const std::function<float()>& radius) {
  std::vector<CDisc> discs;
  for (std::size_t i = 0; i < n; ++i) {
    const float r = radius();
    Vector2 p = centre + random.InSquare(std::max(1.0f, r));
    if (i > 0 && random.Below(8) != 0) {
      const CDisc& other = discs[random.Below(static_cast<std::uint32_t>(i))];
      const float d = (r + other.m_fRadius) * (random.Coin() ? 0.9999f : random.Uniform(0.0f, 1.1f));
      p = other.m_vCenter + d * random.Direction();
    }
    discs.push_back({p, r});
  }
  return discs;
}

void Check(std::uint64_t seed, const Vector2& centre, const std::function<float(CRandom&)>& radius,
           bool mustOverlap = true) {
  CRandom random(seed);
  SCOPED_TRACE(seed);
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<CDisc> discs = Clusters(random, 400, centre, [&] { return radius(random); });
    CDiscGrid grid = MakeGrid(discs);
    std::size_t overlaps = ExpectAllFound(grid, discs);
    // Every other one somewhere else, by way of Move.
    for (std::uint32_t i = 0; i < discs.size(); i += 2) {
      const CDisc& other = discs[random.Below(static_cast<std::uint32_t>(discs.size()))];
      const float reach = discs[i].m_fRadius + other.m_fRadius;
      discs[i].m_vCenter = other.m_vCenter + reach * random.VectorOfLength(0.0f, 1.1f);
      grid.Move(i, discs[i]);
    }
    overlaps += ExpectAllFound(grid, discs);
    if (mustOverlap) {
      EXPECT_GT(overlaps, 200u) << "nothing was tried";
    }
  }
}

TEST(DiscGrid, FindsEveryOverlap) {
  const Vector2 origin(0.0f, 0.0f);
  const auto anySize = [](CRandom& random) { return random.Scale(-20, 20); };
  Check(251, origin, [](CRandom&) { return 0.5f; });
  Check(252, origin, anySize);
  // A few large ones among small ones.
  Check(253, origin, [](CRandom& random) { return random.Below(20) ? random.Scale(-20, -15) : 1e6f; });
  for (const float far : {1e4f, 1e7f, 1e12f, 1e18f})
    Check(256, {far, -far}, anySize);
  Check(257, {-1e15f, 1e15f}, [](CRandom&) { return 1e9f; });
  Check(258, origin, [](CRandom& random) { return random.Scale(-140, -130); }); // denormal
  Check(259, origin, [](CRandom& random) { return random.Scale(50, 58); });
}

TEST(DiscGrid, FindsEveryOverlapOfBallsWithoutExtent) {
  Check(254, {0.0f, 0.0f}, [](CRandom& random) { return random.Coin() ? 0.0f : random.Scale(-10, 10); });
  const bool mustOverlap = false;
  Check(
      255, {0.0f, 0.0f}, [](CRandom&) { return 0.0f; }, mustOverlap);
}

TEST(DiscGrid, CircleOfAnyRadiusIsAnswered) {
  CRandom random(260);
  const std::vector<CDisc> discs = Clusters(random, 300, {0.0f, 0.0f}, [&] { return random.Scale(-6, 2); });
  const CDiscGrid grid = MakeGrid(discs);
  for (int q = 0; q < 300; ++q) {
    const Vector2 p = random.Vector(-4, 8);
    ExpectFound(grid, discs, {p, random.Scale(-20, 20)});
  }
}

TEST(DiscGrid, DoesNotAnswerWithEverything) {
  // 2,500 balls a diameter apart and one large one: all of them as an answer would be right, and useless.
  std::vector<CDisc> discs;
  for (int i = 0; i < 2500; ++i)
    discs.push_back({{static_cast<float>(i / 50), static_cast<float>(i % 50)}, 0.4f});
  discs.push_back({{100.0f, 100.0f}, 40.0f});
  const CDiscGrid grid = MakeGrid(discs);
  std::size_t total = 0;
  for (std::size_t i = 0; i < 2500; ++i)
    total += Ask(grid, discs[i]).size();
  EXPECT_LT(total, 2500u * 30u);
}

TEST(DiscGrid, APositionThatIsNoNumberEndsTheQuery) {
  const CWithoutTraps onPurpose;
  const CDiscGrid grid = MakeGrid({{{0.0f, 0.0f}, 0.5f}, {{1.0f, 0.0f}, 0.75f}});
  for (const Vector2& p : {Vector2(g_fNan, 0.0f), Vector2(0.0f, g_fInf), Vector2(-g_fInf, g_fNan)})
    EXPECT_LE(Ask(grid, {p, 1.0f}).size(), 2u);
}

TEST(DiscGrid, WithoutBallsThereIsNothingToFind) {
  EXPECT_TRUE(Ask(MakeGrid({}), {{0.0f, 0.0f}, 1.0f}).empty());
  CDiscGrid grid = MakeGrid({{{0.0f, 0.0f}, 1.0f}});
  EXPECT_EQ(Ask(grid, {{0.5f, 0.0f}, 1.0f}), std::vector<std::uint32_t>{0});
  EXPECT_EQ(grid.Size(), 1u);
  grid.Build({});
  EXPECT_TRUE(Ask(grid, {{0.0f, 0.0f}, 1.0f}).empty());
}

} // namespace
} // namespace Shapes::Native
