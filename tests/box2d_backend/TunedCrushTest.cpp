// SPDX-License-Identifier: MIT
// Walls that push: balls that have too little room are not shot out of it, and do not stay in each other.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"
#include "box2d_backend/world/OwnedEngine.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nCrushSeed = 47;
constexpr float g_fCrushRadius = 0.2f, g_fWallSpeed = 2;

struct CCrush {
  float m_fFastest = 0;
  float m_fOverlap = 0; // radii, at the end
};

// Twenty balls on a floor, between two walls that close until nine are where six have room, stay there for
// two seconds, open, and close again, three times.
CCrush Crush(const Box2D::CTuning& tuning, std::uint64_t seed) {
  CWorldDesc desc;
  desc.m_vGravity = {0, -10};
  desc.m_fTimeStep = 1 / 60.0f;
  const auto pWorld = Box2D::MakeWorld(desc, tuning);
  pWorld->Add(CLineSegDesc({-3, 0}, {3, 0}));
  CShapeId walls[2];
  for (const int side : {-1, 1}) {
    const float x = 2.2f * static_cast<float>(side);
    CLineSegDesc wall({x, 0.05f}, {x, 9});
    wall.m_eMotionType = eMotion::Kinematic;
    walls[side > 0] = pWorld->Add(wall);
  }
  CRandom random(seed);
  for (int i = 0; i < 20; ++i) {
    const float aside = static_cast<float>(EitherSign(random, 0.01));
    CDynamicCircleDesc ball(
        {-0.94f + 0.47f * static_cast<float>(i % 5) + aside, 0.4f + 0.5f * static_cast<float>(i / 5)},
        g_fCrushRadius);
    ball.m_fElasticity = 0.5f;
    pWorld->Add(ball);
  }
  CCrush crush;
  const auto play = [&](float inward, int steps) {
    for (const int side : {-1, 1})
      pWorld->SetVel(walls[side > 0], {-static_cast<float>(side) * inward, 0});
    for (int i = 0; i < steps; ++i) {
      pWorld->Step();
      for (const Vector2& v : pWorld->GetBallVelocities())
        crush.m_fFastest = std::max(crush.m_fFastest, v.norm());
    }
  };
  for (int round = 0; round < 3; ++round) {
    play(g_fWallSpeed, 33);
    play(0, 120);
    if (round < 2) play(-g_fWallSpeed, 33);
  }
  const auto p = pWorld->GetBallPositions();
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      crush.m_fOverlap = std::max(crush.m_fOverlap, 2 - (p[i] - p[j]).norm() / g_fCrushRadius);
  return crush;
}

TEST(TunedCrushTest, BallsThatWallsPressTogetherAreNeitherShotOutNorStayInEachOther) {
  Box2D::CTuning without = Box2D::g_cTuned;
  without.m_bLastingContact = false;
  float control = 0;
  for (std::uint64_t seed = g_nCrushSeed; seed < g_nCrushSeed + 4; ++seed) {
    SCOPED_TRACE(seed);
    const CCrush crush = Crush(Box2D::g_cTuned, seed);
    EXPECT_LT(crush.m_fFastest, 5 * g_fWallSpeed);
    EXPECT_LT(crush.m_fOverlap, 0.15f);
    control = std::max(control, Crush(without, seed).m_fOverlap);
  }
  EXPECT_GT(control, 0.3f);
}

} // namespace
} // namespace Shapes::Tests
