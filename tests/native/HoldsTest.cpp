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

// Between a wall that rests and one that comes.
TEST(Holds, ASqueezedBallGoesIntoAShapeThatPushesSoonerThanIntoOneThatDoesNot) {
  for (const bool pushingIsFirst : {true, false}) {
    CHolds holds;
    if (pushingIsFirst) holds.Add(Of(false, {1, 0}, 1));
    holds.Add(Of(false, {-1, 0}, 0));
    if (!pushingIsFirst) holds.Add(Of(false, {1, 0}, 1));
    EXPECT_EQ(holds.ConstrainVel({0.5, 3}), Vector2d(0, 3));
  }
}

} // namespace
} // namespace Shapes::Native
