// SPDX-License-Identifier: MIT
#include "geometry/AabbTree.h"

#include "../Testing.h"

namespace Shapes::Geometry {
namespace {

std::vector<std::uint32_t> BruteForce(const std::vector<CAabb2D>& boxes, const CAabb2D& box) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (boxes[i] && box) found.push_back(i);
  return found;
}

CAabb2D RandomBox(CRandom& random, float spread) {
  Vector2 p = random.InSquare(spread);
  if (random.Below(3) == 0) p = {std::round(p.x()), std::round(p.y())}; // many alike, edges in common
  switch (random.Below(4)) {
  case 0: return {p, p};                                      // points
  case 1: return {p, p + Vector2(random.Scale(-8, 8), 0.0f)}; // flat ones
  default: return {p, p + random.Vector(-8, 5)};
  }
}

std::vector<CAabb2D> RandomBoxes(CRandom& random, std::size_t n, float spread) {
  std::vector<CAabb2D> boxes;
  for (std::size_t i = 0; i < n; ++i)
    boxes.push_back(RandomBox(random, spread));
  return boxes;
}

CAabbTree MakeTree(const std::vector<CAabb2D>& boxes) {
  CAabbTree tree;
  tree.Build(boxes);
  return tree;
}

std::vector<std::uint32_t> Find(const CAabbTree& tree, const CAabb2D& box) {
  std::vector<std::uint32_t> found;
  tree.Query(box, found);
  std::sort(found.begin(), found.end());
  return found;
}

// Each query gives exactly what a look at every box gives, each item once.
void ExpectSame(const CAabbTree& tree, const std::vector<CAabb2D>& boxes, CRandom& random, float spread) {
  std::size_t total = 0;
  for (int q = 0; q < 200; ++q) {
    const CAabb2D box = RandomBox(random, 1.2f * spread);
    const std::vector<std::uint32_t> expected = BruteForce(boxes, box);
    ASSERT_EQ(Find(tree, box), expected) << "seed " << random.GetSeed();
    total += expected.size();
  }
  if (boxes.size() > 50 && spread < 100.0f) {
    EXPECT_GT(total, 0u);
  }
}

TEST(AabbTree, QueryEqualsBruteForce) {
  CRandom random(241);
  for (const std::size_t n : {1u, 2u, 3u, 5u, 16u, 100u, 1000u})
    for (const float spread : {1.0f, 30.0f, 1e6f}) {
      const std::vector<CAabb2D> boxes = RandomBoxes(random, n, spread);
      ExpectSame(MakeTree(boxes), boxes, random, spread);
    }
}

TEST(AabbTree, QueryEqualsBruteForceAfterRefit) {
  CRandom random(242);
  std::vector<CAabb2D> boxes = RandomBoxes(random, 300, 30.0f);
  CAabbTree tree = MakeTree(boxes);
  for (int k = 0; k < 5; ++k) {
    for (CAabb2D& box : boxes)
      if (random.Coin()) box = RandomBox(random, 30.0f); // not only a little
    tree.Refit(boxes);
    ExpectSame(tree, boxes, random, 30.0f);
  }
  // Without the refit it would answer by the old boxes.
  std::vector<CAabb2D> moved = boxes;
  for (CAabb2D& box : moved)
    box.Translate({1000.0f, 0.0f});
  const CAabb2D there({900.0f, 100.0f}, {1100.0f, -100.0f});
  EXPECT_TRUE(Find(tree, there).empty());
  tree.Refit(moved);
  EXPECT_EQ(Find(tree, there).size(), moved.size());
}

TEST(AabbTree, QueryEqualsBruteForceAfterSomeHaveGrown) {
  CRandom random(243);
  for (const std::size_t n : {1u, 2u, 3u, 100u}) {
    std::vector<CAabb2D> boxes = RandomBoxes(random, n, 30.0f);
    CAabbTree tree = MakeTree(boxes);
    for (int k = 0; k < 20; ++k) {
      const std::uint32_t item = random.Below(static_cast<std::uint32_t>(n));
      const CAabb2D more = RandomBox(random, 60.0f);
      boxes[item] += more.GetTopLeft();
      boxes[item] += more.GetBottomRt();
      tree.Grow(item, more);
      ExpectSame(tree, boxes, random, 60.0f);
    }
  }
}

TEST(AabbTree, CanBeBuiltAgainAndBeEmpty) {
  CAabbTree tree;
  const CAabb2D all({-1e18f, 1e18f}, {1e18f, -1e18f});
  EXPECT_TRUE(Find(tree, all).empty());
  tree.Build(std::vector<CAabb2D>{all, all, all});
  EXPECT_EQ(Find(tree, all), (std::vector<std::uint32_t>{0, 1, 2}));
  tree.Build({});
  tree.Refit({});
  EXPECT_TRUE(Find(tree, all).empty());
}

TEST(AabbTree, QueryAppendsAndFindsAllOfIdenticalBoxes) {
  const std::vector<CAabb2D> boxes(257, CAabb2D({0.0f, 1.0f}, {1.0f, 0.0f}));
  const CAabbTree tree = MakeTree(boxes);
  EXPECT_EQ(Find(tree, boxes[0]), BruteForce(boxes, boxes[0]));
  std::vector<std::uint32_t> found{7};
  tree.Query(boxes[0], found);
  EXPECT_EQ(found.size(), 258u);
  EXPECT_EQ(found[0], 7u);
}

TEST(Padded, LeavesRoomForTheRoundingOfAKernel) {
  ForEachCase(243, 10000, [&](CRandom& random, int) {
    const CAabb2D box = RandomBox(random, random.Scale(-10, 40));
    const float margin = random.Coin() ? 0.0f : random.Scale(-10, 40);
    const CAabb2D padded = Padded(box, margin);
    const double size = std::max({std::abs(box.GetTopLeft().x()), std::abs(box.GetTopLeft().y()),
                                  std::abs(box.GetBottomRt().x()), std::abs(box.GetBottomRt().y())});
    const double least = static_cast<double>(margin) + 8 * 0x1p-23 * (size + static_cast<double>(margin));
    EXPECT_LE(padded.GetTopLeft().x(), box.GetTopLeft().x() - least);
    EXPECT_GE(padded.GetTopLeft().y(), box.GetTopLeft().y() + least);
    EXPECT_GE(padded.GetBottomRt().x(), box.GetBottomRt().x() + least);
    EXPECT_LE(padded.GetBottomRt().y(), box.GetBottomRt().y() - least);
  });
}

} // namespace
} // namespace Shapes::Geometry
