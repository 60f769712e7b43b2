// SPDX-License-Identifier: MIT
// Random tables on the native engine with Continuous: whatever is in them, nobody gets out.
#include "NativeTesting.h"

#include "Tolerances.h"

namespace Shapes {
namespace {

constexpr float g_fHalf = 4.0f;

struct CTable {
  std::unique_ptr<CWorld> m_pWorld;
  std::vector<CShapeId> m_stdBalls;

  float GetFarthest(CShapeId ball) const {
    return m_pWorld->GetPos(ball).cwiseAbs().maxCoeff() + m_pWorld->GetRadius(ball);
  }
};

/// Walls around up to 11 shapes and 8 balls, which may begin in one another.
CTable MakeTable(std::uint64_t seed, bool turning, const CEffectChoice& choice) {
  CRandom random(seed);
  const float gravity = random.Coin() ? 10.0f : 0.0f;
  CTable table{MakeNative(choice, gravity, g_fDt, 1 + random.Below(2)), {}};
  CWorld& world = *table.m_pWorld;
  const float e = random.Coin() ? 1.0f : random.Uniform(0, 1.1f);
  AddBox(world, g_fHalf, e);
  const auto add = [&](auto shape) {
    shape.m_fElasticity = e;
    if (turning && random.Coin()) {
      const Vector2 center = shape.m_vPos + random.VectorOfLength(0, 0.5f);
      shape = Turning(shape, random.Uniform(-5, 5), center);
    }
    world.Add(shape);
  };
  const std::uint32_t shapes = random.Below(12);
  for (std::uint32_t i = 0; i < shapes; ++i) {
    const Vector2 p = random.InSquare(3);
    const float r = random.Scale(-4, -1), a = random.Uniform(0, 6.28f);
    switch (random.Below(4)) {
    case 0: add(CPointDesc(p)); break;
    case 1: add(CLineSegDesc(p, p + random.VectorOfLength(0, 1))); break;
    case 2: add(CCircleDesc(p, r)); break;
    default: add(CArcDesc(p, r, a, random.Uniform(0, 6.28f)));
    }
  }
  const std::uint32_t balls = 1 + random.Below(8);
  const float fastest = random.Scale(-4, 14);
  for (std::uint32_t i = 0; i < balls; ++i) {
    const Vector2 p = random.InSquare(3.4f), v = random.VectorOfLength(0, fastest);
    const float r = random.Scale(-5, -2), mass = random.Scale(-4, 4);
    table.m_stdBalls.push_back(
        world.Add(CDynamicCircleDesc(p, r, v, mass, random.Coin() ? 1.0f : random.Uniform(0, 1))));
  }
  return table;
}

TEST(ContinuousRandomTest, NobodyGetsOutOfATable) {
  for (const bool turning : {false, true})
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << (turning ? ", turning" : ""));
      const CTable table = MakeTable(seed, turning, g_cContinuous);
      for (int step = 0; step < 100; ++step) {
        table.m_pWorld->Step();
        for (const CShapeId ball : table.m_stdBalls)
          ASSERT_LT(table.m_pWorld->GetPos(ball).cwiseAbs().maxCoeff(), g_fHalf) << "step " << step;
      }
    }
}

// Where nothing turns nobody is squeezed: once what began in one another is apart, balls stay out of the
// walls by all but rounding. In 4,000 such tables it was never more than 24 times that of one impact.
TEST(ContinuousRandomTest, AndNobodyIsInAWall) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const CTable table = MakeTable(seed, false, g_cContinuous);
    for (int step = 0; step < 100; ++step) {
      table.m_pWorld->Step();
      for (const CShapeId ball : table.m_stdBalls)
        if (step >= 10) {
          ASSERT_LT(table.GetFarthest(ball), g_fHalf + 24 * g_fTouchRounding * 2 * g_fHalf)
              << "step " << step;
        }
    }
  }
}

// The control of both.
TEST(ContinuousRandomTest, AsTheyDoInTheApproximateWay) {
  std::size_t out = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const CTable table = MakeTable(seed, false, g_cApproximate);
    Steps(*table.m_pWorld, 100);
    for (const CShapeId ball : table.m_stdBalls)
      out += table.GetFarthest(ball) > g_fHalf + 1;
  }
  EXPECT_GT(out, 100u);
}

} // namespace
} // namespace Shapes
