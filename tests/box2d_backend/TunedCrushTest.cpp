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
  for (std::uint64_t seed = g_nCrushSeed; seed < g_nCrushSeed + 4; ++seed) {
    SCOPED_TRACE(seed);
    const CCrush crush = Crush(Box2D::g_cTuned, seed);
    EXPECT_LT(crush.m_fFastest, 5 * g_fWallSpeed);
    EXPECT_LT(crush.m_fOverlap, 0.15f);
  }
  EXPECT_GT(Crush(without, g_nCrushSeed + 1).m_fOverlap, 0.3f); // the control
}

// Runs of ten seconds in which one of three balls gets out of a ring with a bar that turns in it and leaves
// them too little room.
int CountLostToABar(eSides sides, int runs) {
  CRandom random(g_nCrushSeed);
  int lost = 0;
  for (int run = 0; run < runs; ++run) {
    const auto pWorld = MakeBox2D(eProfile::Tuned, {0, 0}, 1 / 60.0f);
    CArcDesc ring({0, 0}, 1, 0, 0);
    ring.m_eSides = sides;
    pWorld->Add(ring);
    CLineSegDesc bar({-0.75f, 0}, {0.75f, 0});
    bar.m_eMotionType = eMotion::Kinematic;
    bar.m_fRotSpeed = 1;
    pWorld->Add(bar);
    for (int i = 0; i < 3; ++i) {
      const float vx = static_cast<float>(EitherSign(random, 1)),
                  vy = static_cast<float>(EitherSign(random, 1));
      pWorld->Add(CDynamicCircleDesc({0.5f * static_cast<float>(i - 1), 0.35f}, 0.15f, {vx, vy}, 1, 0.7f));
    }
    for (int i = 0; i < 600; ++i)
      pWorld->Step();
    lost += std::any_of(pWorld->GetBallPositions().begin(), pWorld->GetBallPositions().end(),
                        [](const Vector2& p) { return !(p.norm() < 1); });
  }
  return lost;
}

TEST(TunedCrushTest, ABallThatABarSqueezesStaysInItsRing) {
  EXPECT_EQ(CountLostToABar(eSides::Both, 10), 0);
  EXPECT_GT(CountLostToABar(eSides::Back, 3), 0); // the control: a ball may be on its way through this one
}

} // namespace
} // namespace Shapes::Tests
