// SPDX-License-Identifier: MIT
// Shapes that a game puts somewhere else in each step, as a player drags them, into balls.
#include "NativeTesting.h"

#include <numbers>
#include <vector>

namespace Shapes {
namespace {

constexpr float g_fRadius = 0.12f, g_fWay = 3; // of balls, and of the walls in each direction

/// Walls that go to and fro by SetPos, and balls in them.
class CDragged {
public:
  /// @param farthest  that the walls go in a step, radii of a ball
  CDragged(std::span<const CLineSegDesc> walls, int balls, float gravity, float farthest, std::uint64_t seed)
      : m_pWorld(MakeNative(g_cAutomatic, gravity)), m_fRate(farthest * g_fRadius / g_fWay) {
    CRandom random(seed);
    for (const CLineSegDesc& wall : walls)
      m_stdWalls.push_back(m_pWorld->Add(wall));
    for (const CShapeId id : m_stdWalls)
      m_stdFrom.push_back(m_pWorld->GetPos(id));
    const float pitch = 2.1f * g_fRadius;
    for (int i = 0; i < balls; ++i)
      m_pWorld->Add(CDynamicCircleDesc(
          Vector2(pitch * static_cast<float>(i % 7) - 0.8f, pitch * static_cast<float>(i / 7) + 0.2f) +
              random.InSquare(0.1f * g_fRadius),
          g_fRadius, random.InSquare(0.5f), 1, 0.3f));
    m_fStart = random.Uniform(0, 6);
  }
  void Put(int step) {
    const float t = m_fStart + m_fRate * static_cast<float>(step);
    const Vector2 start(std::sin(m_fStart), std::sin(0.7f * m_fStart));
    m_vNow = g_fWay * (Vector2(std::sin(t), std::sin(0.7f * t)) - start);
    for (std::size_t i = 0; i < m_stdWalls.size(); ++i)
      m_pWorld->SetPos(m_stdWalls[i], m_stdFrom[i] + m_vNow);
  }
  std::ptrdiff_t CountOutside(float height) const {
    return CountBalls(*m_pWorld, [&](const Vector2& p) {
      const Vector2 q = p - m_vNow;
      return !(q.allFinite() && std::abs(q.x()) < 1 && q.y() > 0 && q.y() < height);
    });
  }

  std::unique_ptr<CWorld> m_pWorld;

private:
  std::vector<CShapeId> m_stdWalls;
  std::vector<Vector2> m_stdFrom;
  Vector2 m_vNow = {0, 0};
  float m_fRate, m_fStart;
};

// Without gravity 11 to 205 of 240 got out, with .6 and .9 radii.
TEST(PutShapes, NoneGetsOutOfABoxThatIsDragged) {
  for (const float gravity : {0.0f, 10.0f})
    for (const float farthest : {0.3f, 0.6f, 0.9f})
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(testing::Message()
                     << "gravity " << gravity << ", radii " << farthest << ", seed " << seed);
        CDragged box(Walls({-1, 0}, {1, 2}, 0.5f), seed % 2 == 0 ? 20 : 40, gravity, farthest, seed);
        for (int step = 0; step < 300; ++step) {
          box.Put(step);
          box.m_pWorld->Step();
        }
        EXPECT_EQ(box.CountOutside(2), 0);
      }
}

// It is 25 radii high, and filled to a third. With each ball moved by at most a fifth of its radius half of
// them were spilled.
TEST(PutShapes, ACupThatIsDraggedSpillsNone) {
  const CLineSegDesc walls[] = {CLineSegDesc({-1, 0}, {1, 0}), CLineSegDesc({-1, 0}, {-1, 3}),
                                CLineSegDesc({1, 0}, {1, 3})};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CDragged cup(walls, 30, 10, 0.4f, seed);
    for (int step = 0; step < 600; ++step) {
      cup.Put(step);
      cup.m_pWorld->Step();
    }
    EXPECT_EQ(cup.CountOutside(3.2f), 0) << seed;
  }
}

// Circles that go to and fro through a box in turns, and come upon balls between each other and the walls by
// half of their radius a step.
TEST(PutShapes, TwoCirclesPressNoneOutOfABox) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CRandom random(seed);
    const auto pWorld = MakeNative(g_cAutomatic, 10);
    const float h = random.Uniform(0.4f, 1), r = random.Uniform(0.06f, 0.2f);
    AddBox(*pWorld, {-1, -h}, {1, h}, 0.5f);
    for (int ball = 0; ball < 3; ++ball)
      pWorld->Add(CDynamicCircleDesc({r * (2.1f * static_cast<float>(ball) - 2.1f), r - h}, r,
                                     random.InSquare(0.5f), 1, 0.5f));
    struct CPress {
      CShapeId m_cId;
      Vector2 m_vWay;
      float m_fSpeed; // radii of a ball per step
    };
    std::vector<CPress> presses;
    for (const float angle : {0.0f, std::numbers::pi_v<float>}) {
      const Vector2 way = AngleToVector(angle + random.Uniform(-0.5f, 0.5f));
      presses.push_back({pWorld->Add(CCircleDesc(-1.7f * way, random.Uniform(0.1f, 0.5f), 0.5f)), way,
                         random.Uniform(0.25f, 0.5f)});
    }
    for (int step = 0; step < 600; ++step) {
      for (const CPress& press : presses) {
        const float gone = std::fmod(press.m_fSpeed * r * static_cast<float>(step), 6.8f);
        pWorld->SetPos(press.m_cId, ((gone < 3.4f ? gone : 6.8f - gone) - 1.7f) * press.m_vWay);
      }
      pWorld->Step();
    }
    EXPECT_TRUE(AllBalls(*pWorld, [&](const Vector2& p) {
      return std::abs(p.x()) < 1 && std::abs(p.y()) < h;
    })) << seed;
  }
}

TEST(PutShapes, AnotherWorldThatIsLoadedBeforeTheStepTakesTheSameOne) {
  for (const float gravity : {0.0f, 10.0f}) {
    CDragged box(Walls({-1, 0}, {1, 2}, 0.5f), 40, gravity, 0.8f, 1);
    const auto pOther = MakeNative(g_cAutomatic, gravity);
    for (int step = 0; step < 150; ++step) {
      box.Put(step);
      pOther->LoadState(box.m_pWorld->SaveState());
      box.m_pWorld->Step();
      pOther->Step();
      ASSERT_TRUE(HaveSameBits(*box.m_pWorld, *pOther)) << step;
    }
  }
}

// It leaves no room between it and the floor. The ball falls asleep there later.
TEST(PutShapes, OneThatIsPutOntoABallGoesOverItAndTellsThat) {
  const auto pWorld = MakeNative(g_cAutomatic, 10);
  pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  const CShapeId lid = pWorld->Add(Turning(CLineSegDesc({-1, 1}, {1, 1})));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.2f}, 0.2f, {0, 0}, 1, 0));
  pWorld->Step();
  EXPECT_TRUE(Halted(*pWorld).empty());
  pWorld->SetPos(lid, pWorld->GetPos(lid) - Vector2(0, 0.7f));
  InEachStep(*pWorld, 20, [&](int) {
    EXPECT_EQ(Halted(*pWorld), std::vector<CShapeId>{ball});
    EXPECT_NEAR(Wide(pWorld->GetPos(ball).y()), 0.2, 1e-6);
  });
}

} // namespace
} // namespace Shapes
