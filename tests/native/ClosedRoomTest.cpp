// SPDX-License-Identifier: MIT
// Balls that press on each other in closed rooms: by default none gets out, however many push it at once. The
// control is the same world with Continuous forbidden, which lets some out.
#include "NativeTesting.h"

namespace Shapes {
namespace {

/// A convex room, its corners counterclockwise.
using CRoom = std::vector<Vector2>;

std::unique_ptr<CWorld> MakeRoom(const CRoom& room, const CEffectChoice& effects, float gravity, float e) {
  auto pWorld = MakeNative(effects, gravity);
  AddRoom(*pWorld, room, e);
  return pWorld;
}

/// How many balls have their centres outside.
int CountOutside(const CRoom& room, const CWorld& world) {
  int n = 0;
  for (const Vector2& p : world.GetBallPositions()) {
    bool isInside = true;
    for (std::size_t i = 0; i < room.size(); ++i)
      isInside = isInside && Cross(room[(i + 1) % room.size()] - room[i], p - room[i]) > 0.0f;
    n += !isInside;
  }
  return n;
}

int PlayPile(const CEffectChoice& effects, int balls, int steps) {
  const CRoom room{{0, 0}, {6, 0}, {6, 40}, {0, 40}};
  const auto pWorld = MakeRoom(room, effects, 10.0f, 0.7f);
  CRandom random(15);
  for (int i = 0; i < balls; ++i) {
    const Vector2 p(0.5f + 0.5f * static_cast<float>(i % 11), 0.5f + 0.5f * static_cast<float>(i / 11));
    pWorld->Add(CDynamicCircleDesc(p + random.InSquare(0.02f), 0.2f, random.InSquare(0.5f), 1.0f, 0.7f));
  }
  Steps(*pWorld, steps);
  return CountOutside(room, *pWorld);
}

TEST(ClosedRoom, APileLosesNone) {
  EXPECT_EQ(PlayPile(g_cAutomatic, 200, 600), 0);
  EXPECT_GT(PlayPile(g_cApproximate, 200, 600), 0); // the control
}

int PlayRooms(const CEffectChoice& effects, int rooms) {
  CRandom random(15);
  SCOPED_TRACE(random.GetSeed());
  int lost = 0;
  for (int k = 0; k < rooms; ++k) {
    // A quadrangle about the origin, some of its corners sharp.
    CRoom room;
    float angle = random.Uniform(0.0f, 1.0f);
    for (int i = 0; i < 4; ++i) {
      room.push_back(random.Uniform(0.4f, 1.2f) * AngleToVector(angle));
      angle += 0.5f * g_fPi;
    }
    bool isConvex = true;
    for (std::size_t i = 0; i < 4; ++i)
      isConvex = isConvex && Cross(room[(i + 1) % 4] - room[i], room[(i + 2) % 4] - room[(i + 1) % 4]) > 0.0f;
    if (!isConvex) continue;
    const auto pWorld = MakeRoom(room, effects, random.Coin() ? 10.0f : 0.0f, random.Uniform(0.3f, 1.0f));
    const int balls = 1 + static_cast<int>(random.Below(6));
    for (int i = 0; i < balls; ++i)
      pWorld->Add(CDynamicCircleDesc(random.InSquare(0.05f), random.Uniform(0.03f, 0.2f),
                                     random.InSquare(1.0f), random.Uniform(0.1f, 10.0f),
                                     random.Uniform(0.3f, 1.0f)));
    const int atFirst = CountOutside(room, *pWorld);
    Steps(*pWorld, 600);
    lost += atFirst == 0 && CountOutside(room, *pWorld) > 0;
  }
  return lost;
}

TEST(ClosedRoom, RandomRoomsLoseNone) {
  EXPECT_EQ(PlayRooms(g_cAutomatic, 600), 0);
  EXPECT_GT(PlayRooms(g_cApproximate, 600), 5); // the control
}

// A ball that lies over a gap that is smaller than itself, pressed by another one, is stopped by the ends. It
// must not gather speed meanwhile.
TEST(ClosedRoom, AStoppedBallGathersNoSpeed) {
  const auto pWorld = MakeNative(g_cAutomatic, 10);
  pWorld->Add(CLineSegDesc({-2.0f, 0.0f}, {-0.04f, 0.0f}));
  pWorld->Add(CLineSegDesc({0.04f, 0.0f}, {2.0f, 0.0f}));
  pWorld->Add(CDynamicCircleDesc({0.0f, 0.05f}, 0.1f));
  pWorld->Add(CDynamicCircleDesc({0.0f, 0.2f}, 0.1f));
  // Of both; that they overlap at first may add as much as lifting them out takes, .042 and .092,
  // and a twentieth more, because they are set back in turns.
  const auto energy = [&] {
    float sum = 0.0f;
    for (std::size_t i = 0; i < 2; ++i)
      sum += 0.5f * pWorld->GetBallVelocities()[i].squaredNorm() + 10.0f * pWorld->GetBallPositions()[i].y();
    return sum;
  };
  const float most = energy() + 1.4f;
  for (int i = 0; i < 300; ++i) {
    pWorld->Step();
    ASSERT_LT(energy(), most) << "after step " << i;
  }
}

// A post that appears under a ball that is larger than the post pushes it out.
TEST(ClosedRoom, ABallIsNotTrappedInAPostThatIsSmaller) {
  for (const CEffectChoice& effects : {g_cAutomatic, g_cApproximate}) {
    const auto pWorld = MakeNative(effects);
    pWorld->Add(CCircleDesc({0.0f, 0.0f}, 0.1f));
    pWorld->Add(CLineSegDesc({0.38f, -1.0f}, {0.38f, 1.0f}));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.05f, 0.0f}, 0.15f));
    Steps(*pWorld, 10);
    EXPECT_GT(pWorld->GetPos(ball).norm(), 0.2f);
  }
}

} // namespace
} // namespace Shapes
