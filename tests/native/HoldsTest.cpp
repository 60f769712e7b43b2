// SPDX-License-Identifier: MIT
#include "../Testing.h"

#include "native/continuous/Holds.h"

#include <limits>

namespace Shapes::Native {
namespace {

CHold Of(bool isBall, const Vector2d& n, double speed) {
  return {0, isBall, n, speed, 0.0, std::numeric_limits<double>::infinity()};
}

// Between a floor that comes up and a ball that comes down.
TEST(Holds, ASqueezedBallGoesIntoABallSoonerThanIntoAShape) {
  for (const bool ballIsFirst : {true, false}) {
    CHolds holds;
    if (ballIsFirst) holds.Add(Of(true, {0, -1}, 1));
    holds.Add(Of(false, {0, 1}, 1));
    if (!ballIsFirst) holds.Add(Of(true, {0, -1}, 1));
    EXPECT_EQ(holds.ConstrainVel({3, 0}), Vector2d(3, 1));
  }
}

// As between the walls of a slot that is all but as wide as the ball.
TEST(Holds, WallsThatAreAllButParallelStopABall) {
  const double sine = 1e-3, cosine = std::sqrt(1.0 - sine * sine);
  CHolds holds;
  holds.Add(Of(false, {cosine, sine}, 0));
  holds.Add(Of(false, {-cosine, sine}, 0));
  EXPECT_LT(holds.ConstrainVel({0, -1}).norm(), 1e-12);
}

} // namespace
} // namespace Shapes::Native
