// SPDX-License-Identifier: MIT
// Balls that a game puts where there is no room for them.
#include "NativeTesting.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

namespace Shapes {
namespace {

/// A convex room of 3 to 8 walls with their ends on a circle of radius 1, some of which meet at acute angles.
class CConvexRoom {
public:
  CConvexRoom(CWorld& world, CRandom& random) {
    const std::uint32_t n = 3 + random.Below(6);
    const float angle = 2 * std::numbers::pi_v<float> / static_cast<float>(n);
    for (std::uint32_t i = 0; i < n; ++i)
      m_stdCorners.push_back(AngleToVector(angle * (static_cast<float>(i) + random.Uniform(-0.25f, 0.25f))));
    for (std::uint32_t i = 0; i < n; ++i)
      world.Add(CLineSegDesc(m_stdCorners[i], m_stdCorners[(i + 1) % n], 0.5f));
  }
  /// How far inside p is, from the nearest wall; negative outside.
  float GetRoom(const Vector2& p) const {
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < m_stdCorners.size(); ++i) {
      const Vector2& from = m_stdCorners[i];
      const Vector2 way = (m_stdCorners[(i + 1) % m_stdCorners.size()] - from).normalized(), d = p - from;
      least = std::min(least, way.x() * d.y() - way.y() * d.x());
    }
    return least;
  }
  /// A place within `half` of `middle` that is inside by `least` at least and `most` at most.
  Vector2 Place(CRandom& random, const Vector2& middle, float half, float least, float most) const {
    Vector2 p;
    float room;
    do {
      p = middle + random.InSquare(half);
      room = GetRoom(p);
    } while (!(room > least && room < most));
    return p;
  }

private:
  std::vector<Vector2> m_stdCorners;
};

// The centre was up to .02 radii from a wall. Set back from one wall that took some through the next in an
// acute corner: single balls in 6 and 9 of 2,000 triangles.
TEST(PutBalls, IntoAnAcuteCornerComeOutOfTheWallsInsideTheRoom) {
  for (const float gravity : {0.0f, 10.0f})
    for (const int balls : {1, 10})
      for (std::uint64_t seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(testing::Message() << balls << " balls, gravity " << gravity << ", seed " << seed);
        CRandom random(seed);
        const auto pWorld = MakeNative(g_cAutomatic, gravity);
        const CConvexRoom room(*pWorld, random);
        const float r = random.Uniform(0.03f, 0.15f);
        const Vector2 first = room.Place(random, {0, 0}, 1, 0.02f * r, r);
        for (int i = 0; i < balls; ++i)
          pWorld->Add(CDynamicCircleDesc(i == 0 ? first : room.Place(random, first, 1.9f * r, 0.02f * r, 1),
                                         r, {0, 0}, 1, 0.5f));
        Steps(*pWorld, 60);
        // In a pile they give way bit by bit.
        const float least = balls > 1 && gravity > 0 ? 0 : 0.999f * r;
        ASSERT_TRUE(AllBalls(*pWorld, [&](const Vector2& p) { return room.GetRoom(p) > least; }));
      }
}

// Deep in each other and in a wall. Where they are set back from each other by a quarter of their radius
// whatever is in the way, one of them goes through the wall.
TEST(PutBalls, InEachOtherAndInAWallStayInTheRoom) {
  for (const int balls : {2, 3, 10})
    for (const bool isTurned : {false, true})
      for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(testing::Message() << balls << " balls, turned " << isTurned << ", seed " << seed);
        CRandom random(seed);
        const Eigen::Rotation2Df turn(isTurned ? 0.7f : 0.0f);
        const auto pWorld = MakeNative(g_cAutomatic);
        const Vector2 corners[] = {turn * Vector2(-1, -1), turn * Vector2(1, -1), turn * Vector2(1, 1),
                                   turn * Vector2(-1, 1)};
        for (std::size_t i = 0; i < 4; ++i)
          pWorld->Add(CLineSegDesc(corners[i], corners[(i + 1) % 4], 0.5f));
        const auto isInside = [&](const Vector2& p) {
          return (turn.inverse() * p).cwiseAbs().maxCoeff() < 1.0f;
        };
        const float r = random.Uniform(0.03f, 0.15f), deep = random.Uniform(0.02f, 1);
        const Vector2 first(1 - r * deep, random.Uniform(-1, 1) * (1 - 0.02f * r));
        for (int i = 0; i < balls; ++i) {
          Vector2 p = first;
          while (i > 0 && (p == first || p.cwiseAbs().maxCoeff() > 1 - 0.02f * r))
            p = first + random.InSquare(1.9f * r);
          pWorld->Add(CDynamicCircleDesc(turn * p, r, {0, 0}, 1, 0.5f));
        }
        Steps(*pWorld, 20);
        ASSERT_TRUE(AllBalls(*pWorld, isInside));
      }
}

} // namespace
} // namespace Shapes
