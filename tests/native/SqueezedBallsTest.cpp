// SPDX-License-Identifier: MIT
// Balls of masses 1:1000, many in one place, in a shaft whose floor comes up faster and slower.
#include "NativeTesting.h"

namespace Shapes {
namespace {

struct CShaft {
  std::unique_ptr<CWorld> m_pWorld;
  float m_fHalf, m_fSpeed;
  CShapeId m_cFloor;

  CShaft(const CEffectChoice& effects, float radius, std::uint64_t seed) {
    CRandom random(seed);
    m_fHalf = random.Uniform(0.2f, 0.8f), m_fSpeed = random.Uniform(1.0f, 10.0f);
    m_pWorld = MakeNative(effects, 10);
    for (const float x : {-m_fHalf, m_fHalf})
      m_pWorld->Add(CLineSegDesc({x, -1}, {x, 100}));
    m_cFloor = m_pWorld->Add(Turning(CLineSegDesc({-2, 0}, {2, 0})));
    const int balls = 3 + static_cast<int>(random.Below(20));
    float y = 0.0f;
    for (int i = 0; i < balls; ++i) {
      float r = radius * random.Uniform(1.0f, 3.0f);
      y += 1.2f * r;
      r = std::min(r, 0.45f * m_fHalf);
      const float x = random.Uniform(-1.0f, 1.0f) * (m_fHalf - 1.01f * r);
      const float mass = std::pow(1000.0f, random.Uniform(0.0f, 1.0f));
      m_pWorld->Add(CDynamicCircleDesc({x, y + r}, r, {0, m_fSpeed}, mass, random.Coin() ? 0.0f : 0.5f));
    }
  }
  void Step(int step) {
    if (step % 30 == 0)
      m_pWorld->SetVel(m_cFloor, {0, m_fSpeed * (1.0f + 0.03f * static_cast<float>(step / 30 % 3 - 1))});
    m_pWorld->Step();
  }
  // How deep a ball is in a wall or in the floor, in its radii.
  float GetDepth() const {
    const float floor = m_pWorld->GetShape(m_cFloor).GetAABB().GetTopLeft().y();
    float deepest = 0.0f;
    for (const CShapeId id : m_pWorld->GetBallIds()) {
      const Vector2& p = m_pWorld->GetPos(id);
      const float r = m_pWorld->GetRadius(id);
      deepest = std::max({deepest, (std::abs(p.x()) + r - m_fHalf) / r, (floor + r - p.y()) / r});
    }
    return deepest;
  }
};

constexpr int g_nSteps = 100;
constexpr float g_fDeepest = 0.25f;

float GetDeepest(const CEffectChoice& effects, float radius, std::uint64_t seed) {
  CShaft shaft(effects, radius, seed);
  float deepest = 0.0f;
  for (int step = 0; step < g_nSteps; ++step) {
    shaft.Step(step);
    deepest = std::max(deepest, shaft.GetDepth());
  }
  return deepest;
}

TEST(SqueezedBalls, GoThroughNoShape) {
  struct CRow {
    float m_fRadius;
    std::vector<std::uint64_t> m_stdSeeds; // in which one got through once, besides the first ones
  };
  for (const CRow& row : {CRow{0.05f, {265, 377, 417, 498, 530}}, CRow{0.1f, {49, 96, 199, 263, 500}},
                          CRow{0.2f, {17, 224, 305}}}) {
    std::vector<std::uint64_t> seeds = row.m_stdSeeds;
    for (std::uint64_t seed = 0; seed < 10; ++seed)
      seeds.push_back(seed);
    for (const std::uint64_t seed : seeds) {
      SCOPED_TRACE(testing::Message() << "radius " << row.m_fRadius << ", seed " << seed);
      EXPECT_LT(GetDeepest(g_cAutomatic, row.m_fRadius, seed), g_fDeepest);
    }
  }
  EXPECT_GT(GetDeepest(g_cApproximate, 0.1f, 49), g_fDeepest) << "the control";
}

} // namespace
} // namespace Shapes
