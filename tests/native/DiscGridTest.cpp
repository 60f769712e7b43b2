// SPDX-License-Identifier: MIT
#include "native/broadphase/DiscGrid.h"

#include "../Testing.h"
#include "traps/Traps.h"

namespace Shapes::Native {
namespace {

class CBalls {
public:
  std::vector<Vector2> m_stdPos;
  std::vector<float> m_stdRadius;
};

CDiscGrid MakeGrid(const CBalls& balls) {
  std::vector<CDiscGrid::CDisc> discs;
  for (std::size_t i = 0; i < balls.m_stdPos.size(); ++i)
    discs.push_back({balls.m_stdPos[i], balls.m_stdRadius[i]});
  CDiscGrid grid;
  grid.Build(discs);
  return grid;
}

// What the pair kernel would answer.
bool Overlap(const Vector2& p, float r, const Vector2& q, float s) { return Length(q - p) < r + s; }

std::vector<std::uint32_t> Ask(const CDiscGrid& grid, const Vector2& p, float r) {
  std::vector<std::uint32_t> found;
  grid.FindNear(p, r, [&found](std::uint32_t i) {
    found.push_back(i);
    return false;
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Every overlap is among the answers; returns how many overlaps there were.
std::size_t ExpectAllFound(const CDiscGrid& grid, const CBalls& balls, std::uint64_t seed) {
  std::size_t overlaps = 0;
  for (std::size_t i = 0; i < balls.m_stdPos.size(); ++i) {
    const std::vector<std::uint32_t> found = Ask(grid, balls.m_stdPos[i], balls.m_stdRadius[i]);
    for (std::uint32_t j = 0; j < balls.m_stdPos.size(); ++j) {
      if (!Overlap(balls.m_stdPos[i], balls.m_stdRadius[i], balls.m_stdPos[j], balls.m_stdRadius[j]))
        continue;
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), j))
          << i << " and " << j << " radii " << balls.m_stdRadius[i] << ' ' << balls.m_stdRadius[j] << " seed "
          << seed;
      overlaps += i != j;
    }
  }
  return overlaps;
}

// Balls of these radii, each placed where it just overlaps or just misses one of the others.
CBalls Clusters(CRandom& random, std::size_t n, const Vector2& centre, const std::function<float()>& radius) {
  CBalls balls;
  for (std::size_t i = 0; i < n; ++i) {
    const float r = radius();
    Vector2 p = centre + random.InSquare(std::max(1.0f, r));
    if (i > 0 && random.Below(8) != 0) {
      const auto j = random.Below(static_cast<std::uint32_t>(i));
      const float reach = r + balls.m_stdRadius[j];
      const float d = reach * (random.Coin() ? 0.9999f : random.Uniform(0.0f, 1.1f));
      p = balls.m_stdPos[j] + d * random.Direction();
    }
    balls.m_stdPos.push_back(p);
    balls.m_stdRadius.push_back(r);
  }
  return balls;
}

void Check(std::uint64_t seed, const Vector2& centre, const std::function<float(CRandom&)>& radius,
           bool mustOverlap = true) {
  CRandom random(seed);
  for (int trial = 0; trial < 5; ++trial) {
    CBalls balls = Clusters(random, 400, centre, [&] { return radius(random); });
    CDiscGrid grid = MakeGrid(balls);
    std::size_t overlaps = ExpectAllFound(grid, balls, seed);
    // Every other ball somewhere else, by way of Move.
    for (std::uint32_t i = 0; i < balls.m_stdPos.size(); i += 2) {
      const auto j = random.Below(static_cast<std::uint32_t>(balls.m_stdPos.size()));
      balls.m_stdPos[i] = balls.m_stdPos[j] +
                          (balls.m_stdRadius[i] + balls.m_stdRadius[j]) * random.VectorOfLength(0.0f, 1.1f);
      grid.Move(i, {balls.m_stdPos[i], balls.m_stdRadius[i]});
    }
    overlaps += ExpectAllFound(grid, balls, seed);
    if (mustOverlap) {
      EXPECT_GT(overlaps, 200u) << "nothing was tried";
    }
  }
}

TEST(DiscGrid, FindsEveryOverlapOfEqualBalls) {
  Check(251, {0.0f, 0.0f}, [](CRandom&) { return 0.5f; });
}

TEST(DiscGrid, FindsEveryOverlapOfMixedSizes) {
  Check(252, {0.0f, 0.0f}, [](CRandom& random) { return random.Scale(-20, 20); });
  Check(253, {0.0f, 0.0f}, [](CRandom& random) { return random.Below(20) ? random.Scale(-20, -15) : 1e6f; });
}

TEST(DiscGrid, FindsEveryOverlapOfBallsWithoutExtent) {
  Check(254, {0.0f, 0.0f}, [](CRandom& random) { return random.Coin() ? 0.0f : random.Scale(-10, 10); });
  Check(
      255, {0.0f, 0.0f}, [](CRandom&) { return 0.0f; }, false);
}

TEST(DiscGrid, FindsEveryOverlapFarOut) {
  for (const float far : {1e4f, 1e7f, 1e12f, 1e18f})
    Check(256, {far, -far}, [](CRandom& random) { return random.Scale(-20, 20); });
  Check(257, {-1e15f, 1e15f}, [](CRandom&) { return 1e9f; });
}

TEST(DiscGrid, FindsEveryOverlapOfTinyAndHugeBalls) {
  Check(258, {0.0f, 0.0f}, [](CRandom& random) { return random.Scale(-140, -130); });
  Check(259, {0.0f, 0.0f}, [](CRandom& random) { return random.Scale(50, 58); });
}

TEST(DiscGrid, CircleOfAnyRadiusIsAnswered) {
  CRandom random(260);
  const CBalls balls = Clusters(random, 300, {0.0f, 0.0f}, [&] { return random.Scale(-6, 2); });
  const CDiscGrid grid = MakeGrid(balls);
  for (int q = 0; q < 300; ++q) {
    const Vector2 p = random.Vector(-4, 8);
    const float r = random.Scale(-20, 20);
    const std::vector<std::uint32_t> found = Ask(grid, p, r);
    for (std::uint32_t j = 0; j < balls.m_stdPos.size(); ++j)
      if (Overlap(p, r, balls.m_stdPos[j], balls.m_stdRadius[j])) {
        ASSERT_TRUE(std::binary_search(found.begin(), found.end(), j)) << "seed " << random.GetSeed();
      }
  }
}

TEST(DiscGrid, DoesNotAnswerWithEverything) {
  // 2,500 balls a diameter apart and one large one: all of them as an answer would be right, and useless.
  CBalls balls;
  for (int x = 0; x < 50; ++x)
    for (int y = 0; y < 50; ++y) {
      balls.m_stdPos.push_back({static_cast<float>(x), static_cast<float>(y)});
      balls.m_stdRadius.push_back(0.4f);
    }
  balls.m_stdPos.push_back({100.0f, 100.0f});
  balls.m_stdRadius.push_back(40.0f);
  const CDiscGrid grid = MakeGrid(balls);
  std::size_t total = 0;
  for (std::size_t i = 0; i < 2500; ++i)
    total += Ask(grid, balls.m_stdPos[i], balls.m_stdRadius[i]).size();
  EXPECT_LT(total, 2500u * 30u);
}

TEST(DiscGrid, APositionThatIsNoNumberEndsTheQuery) {
  const CWithoutTraps onPurpose;
  const CDiscGrid grid = MakeGrid({{{0.0f, 0.0f}, {1.0f, 0.0f}}, {0.5f, 0.75f}});
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const Vector2& p : {Vector2(nan, 0.0f), Vector2(0.0f, inf), Vector2(-inf, nan)})
    EXPECT_LE(Ask(grid, p, 1.0f).size(), 2u);
}

TEST(DiscGrid, StopsWhereItIsToldTo) {
  const CDiscGrid grid = MakeGrid({{{0.0f, 0.0f}, {0.1f, 0.0f}, {0.2f, 0.0f}}, {0.5f, 0.5f, 0.5f}});
  int asked = 0;
  EXPECT_TRUE(grid.FindNear({0.0f, 0.0f}, 1.0f, [&](std::uint32_t) { return ++asked == 2; }));
  EXPECT_EQ(asked, 2);
}

TEST(DiscGrid, WithoutBallsThereIsNothingToFind) {
  EXPECT_TRUE(Ask(MakeGrid({}), {0.0f, 0.0f}, 1.0f).empty());
  CDiscGrid grid = MakeGrid({{{0.0f, 0.0f}}, {1.0f}});
  EXPECT_EQ(Ask(grid, {0.5f, 0.0f}, 1.0f), std::vector<std::uint32_t>{0});
  EXPECT_EQ(grid.Size(), 1u);
  grid.Build({});
  EXPECT_TRUE(Ask(grid, {0.0f, 0.0f}, 1.0f).empty());
}

} // namespace
} // namespace Shapes::Native
