// SPDX-License-Identifier: MIT
// Balls that a game puts where there is no room for them.
#include "NativeTesting.h"

#include <Eigen/Geometry>

namespace Shapes {
namespace {

// Deep in each other and in a wall. When they were set back from each other first, that took a ball through
// the wall in 58, 130 and 866 of 2,000 such boxes; where it stopped at walls along which it was set back, in
// 1 to 5% of those whose walls are not quite at right angles.
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
