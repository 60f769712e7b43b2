// SPDX-License-Identifier: MIT
#include "native/broadphase/ShapeGrid.h"

#include "../Testing.h"
#include "native/broadphase/StaticBroadPhase.h"
#include "traps/Traps.h"

namespace Shapes::Native {
namespace {

// As large as the spread, or small.
std::unique_ptr<CShape> RandomShape(CRandom& random, const Vector2& centre, float spread) {
  const std::uint32_t kind = random.Below(4);
  const Vector2 p = centre + random.InSquare(spread);
  return MakeAnyShape(random, kind, p, random.Coin() ? 1.0f : 0.8f * spread);
}

struct CShapes {
  explicit CShapes(std::vector<std::unique_ptr<CShape>> owned) : m_stdOwned(std::move(owned)) {
    std::vector<CAabb2D> boxes;
    for (const auto& pShape : m_stdOwned) {
      m_stdShapes.push_back({pShape.get(), static_cast<std::uint32_t>(m_stdShapes.size())});
      boxes.push_back(Geometry::Padded(pShape->GetAABB()));
    }
    m_cTree.Build(boxes);
  }
  bool Build(CShapeGrid& grid, float reach) const { return grid.Build(m_stdShapes, m_cTree, reach); }
  CShapeGrid MakeGrid(float reach) const {
    CShapeGrid grid;
    EXPECT_TRUE(Build(grid, reach));
    return grid;
  }

  std::vector<std::unique_ptr<CShape>> m_stdOwned;
  std::vector<CShapeGrid::CPlaced> m_stdShapes;
  Geometry::CAabbTree m_cTree;
};

CShapes MakeRandom(CRandom& random, std::size_t n, const Vector2& centre, float spread) {
  std::vector<std::unique_ptr<CShape>> shapes;
  for (std::size_t i = 0; i < n; ++i)
    shapes.push_back(RandomShape(random, centre, spread));
  return CShapes(std::move(shapes));
}

CShapes MakePoints(const std::vector<Vector2>& places) {
  std::vector<std::unique_ptr<CShape>> points;
  for (const Vector2& p : places)
    points.push_back(std::make_unique<CPoint>(CPointDesc(p)));
  return CShapes(std::move(points));
}

std::vector<std::uint32_t> Ask(CShapeGrid& grid, const Vector2& p, float r) {
  std::vector<std::uint32_t> found;
  grid.ForEachNear(p, r, [&found](std::uint32_t order) {
    found.push_back(order);
    return true;
  });
  return found;
}

void Check(std::uint64_t seed, const Vector2& centre, float spread, float reach) {
  CRandom random(seed);
  SCOPED_TRACE(seed);
  std::size_t near = 0, answers = 0, clear = 0, asked = 0;
  for (int trial = 0; trial < 5; ++trial) {
    const CShapes shapes = MakeRandom(random, 1 + random.Below(200), centre, spread);
    CShapeGrid grid = shapes.MakeGrid(reach);
    for (int q = 0; q < 400; ++q, ++asked) {
      const Vector2 p = centre + random.InSquare(2.5f * spread);
      const float r = reach * random.Uniform(0.0f, 1.0f);
      const std::vector<std::uint32_t> found = Ask(grid, p, r);
      ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
      answers += found.size();
      const bool isClear = grid.IsClear(p, r);
      clear += isClear;
      // It may be asked whether more than its reach is clear; it need not know.
      const float more = reach * random.Uniform(1.0f, 4.0f);
      const bool isMoreClear = grid.IsClear(p, more);
      for (std::uint32_t order = 0; order < shapes.m_stdShapes.size(); ++order) {
        const float d = DistanceFrom(*shapes.m_stdOwned[order], p);
        ASSERT_FALSE(isMoreClear && d <= more) << order;
        if (d > r) continue;
        ++near;
        ASSERT_TRUE(std::binary_search(found.begin(), found.end(), order)) << order;
        ASSERT_FALSE(isClear) << order;
      }
    }
  }
  // Something was tried, and the answer is not everything.
  EXPECT_GT(near, 100u);
  EXPECT_LT(answers, 2 * near + asked);
  EXPECT_GT(clear, asked / 10);
}

TEST(ShapeGrid, FindsAllThatIsNear) { Check(261, {0.0f, 0.0f}, 10.0f, 0.3f); }
TEST(ShapeGrid, FindsAllThatIsNearFarOut) { Check(262, {3e4f, -7e4f}, 10.0f, 0.3f); }
TEST(ShapeGrid, FindsAllThatIsNearInPixels) { Check(263, {500.0f, 500.0f}, 1000.0f, 30.0f); }
TEST(ShapeGrid, FindsAllThatIsNearALargeBall) { Check(264, {0.0f, 0.0f}, 10.0f, 3.0f); }

TEST(ShapeGrid, ALineOfShapesHasNoCellForEachUnitOfItsSquare) {
  std::vector<Vector2> places;
  for (int i = 0; i < 100; ++i)
    places.emplace_back(1000.0f * static_cast<float>(i), 0.0f);
  const CShapes shapes = MakePoints(places);
  CShapeGrid grid = shapes.MakeGrid(0.5f);
  for (std::uint32_t i = 0; i < 100; ++i)
    EXPECT_EQ(Ask(grid, {1000.0f * static_cast<float>(i) + 0.3f, 0.1f}, 0.5f), std::vector<std::uint32_t>{i});
}

TEST(ShapeGrid, WhereFloatsWouldOverflowThereIsNone) {
  CShapeGrid grid;
  for (const float at : {1e13f, 1e18f}) {
    EXPECT_FALSE(MakePoints({{at, 0.0f}, {-at, 0.0f}}).Build(grid, 0.5f));
    EXPECT_FALSE(grid.IsBuilt());
  }
  EXPECT_FALSE(MakePoints({{0.0f, 0.0f}}).Build(grid, 0.0f));
  EXPECT_FALSE(MakePoints({}).Build(grid, 1.0f));
}

TEST(ShapeGrid, APositionThatIsNoNumberIsNearNothing) {
  const CWithoutTraps onPurpose;
  CRandom random(265);
  const CShapes shapes = MakeRandom(random, 10, {0.0f, 0.0f}, 1.0f);
  CShapeGrid grid = shapes.MakeGrid(0.5f);
  for (const Vector2& p : {Vector2(g_fNan, 0.0f), Vector2(0.0f, g_fInf), Vector2(-g_fInf, g_fNan)})
    EXPECT_TRUE(Ask(grid, p, 0.3f).empty());
}

// The broad phase with its grid gives all that a look at every shape gives, whatever has come or moved
// meanwhile.
TEST(StaticBroadPhase, FindsAllThatIsNearWhileShapesComeAndMove) {
  CRandom random(266);
  SCOPED_TRACE(random.GetSeed());
  std::vector<CShapeEntry> entries;
  const std::uint32_t still = 120;
  for (std::uint32_t i = 0; i < still; ++i)
    entries.emplace_back(CShapeId{i + 1}, RandomShape(random, {0.0f, 0.0f}, 10.0f));
  for (std::uint32_t i = still; i < still + 4; ++i) {
    CLineSegDesc bar = Turning(CLineSegDesc({0.0f, static_cast<float>(i - still)}, {2.0f, 0.0f}));
    bar.m_vVel = random.Direction();
    entries.emplace_back(CShapeId{i + 1}, std::make_unique<CLineSeg>(bar));
  }
  CStaticBroadPhase broadPhase;
  broadPhase.Build(entries);
  std::vector<std::uint32_t> found, room, called;
  std::size_t near = 0, answers = 0, all = 0;
  for (int step = 0; step < 300; ++step) {
    // Quiet times, one that moves, more than are looked at one by one, and some that come.
    const std::uint32_t moved = step % 100 < 40 ? 0 : step % 100 < 60 ? 1 : 100;
    for (std::uint32_t i = 0; i < moved; ++i) {
      const auto any = static_cast<std::uint32_t>(entries.size()) - 4;
      const std::uint32_t k = random.Below(any);
      CShapeEntry& entry = entries[k < still ? k : k + 4];
      entry.m_pShape->SetPos(random.InSquare(10.0f));
      broadPhase.Update(entry);
    }
    for (int i = 0; i < (step % 100 < 50 ? 2 : 0); ++i) {
      const Vector2 from = random.InSquare(10.0f);
      const CLineSegDesc line(from, from + random.InSquare(1.0f));
      entries.emplace_back(CShapeId{static_cast<std::uint32_t>(entries.size()) + 1},
                           std::make_unique<CLineSeg>(line));
      if (!broadPhase.Add(entries.back())) broadPhase.Build(entries);
    }
    for (std::uint32_t i = still; i < still + 4; ++i)
      entries[i].m_pShape->Advance(1.0f / 60.0f, 1e18f);
    broadPhase.BoxKinematic(0.0f);
    const float radius = step < 200 ? 0.2f : 0.9f;
    broadPhase.SetReach(4.5f * radius, radius);
    for (int q = 0; q < 100; ++q) {
      const Vector2 p = random.InSquare(11.0f);
      const float r = random.Uniform(0.0f, 1.5f);
      broadPhase.FindNear(p, r, found);
      ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
      ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
      answers += found.size();
      all += broadPhase.Size();
      called.clear();
      broadPhase.ForEachNear(p, r, room, [&](std::uint32_t order) {
        called.push_back(order);
        return called.size() < 3;
      });
      ASSERT_EQ(called.size(), std::min<std::size_t>(3, found.size()));
      ASSERT_TRUE(std::equal(called.begin(), called.end(), found.begin()));
      const bool isClear = broadPhase.IsClear(p, r);
      for (std::uint32_t order = 0; order < broadPhase.Size(); ++order) {
        if (DistanceFrom(*broadPhase.Get(order).m_pShape, p) > r) continue;
        ++near;
        ASSERT_TRUE(std::binary_search(found.begin(), found.end(), order));
        ASSERT_FALSE(isClear);
      }
    }
  }
  EXPECT_GT(near, 1000u);
  EXPECT_LT(answers, all / 10);
}

} // namespace
} // namespace Shapes::Native
