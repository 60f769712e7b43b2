// SPDX-License-Identifier: MIT
#include "NativeTesting.h"

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

// A shape that leaves a ball no room does not take it along, whichever of the two has come first.
TEST(Holds, ABallThatIsLetGoByNoneKeepsOutOfTheOneThatRests) {
  const Vector2d rests = -Vector2d(0.01, 1).normalized();
  for (const bool pushingIsFirst : {true, false}) {
    CHolds holds;
    if (pushingIsFirst) holds.Add(Of(false, {0, 1}, 16));
    holds.Add(Of(false, rests, 0));
    if (!pushingIsFirst) holds.Add(Of(false, {0, 1}, 16));
    EXPECT_NEAR(rests.dot(holds.KeepVel(holds.ConstrainVel({3, 0}))), 0, 1e-15);
  }
}

// A ball that slides down a board, which goes through a wall that is all but parallel to it.
TEST(Holds, ABoardPressesNoBallThroughAWall) {
  for (const float angle : {-1.2f, -0.5f, 0.5f, 1.2f})
    for (const float between : {-0.04f, -0.01f, 0.0f, 0.01f, 0.04f})
      for (const float speed : {2.0f, 16.0f, 50.0f}) {
        SCOPED_TRACE(testing::Message() << "angle " << angle << ", " << between << " between, " << speed);
        const auto pWorld = MakeNative(g_cAutomatic, 10);
        const Vector2 board = AngleToVector(angle), wall = AngleToVector(angle + between);
        const Vector2 out(-board.y(), board.x()), in(wall.y(), -wall.x());
        pWorld->Add(CLineSegDesc(-50 * wall, 50 * wall, 0));
        pWorld->Add(Moving(CLineSegDesc(-50 * board - 2 * out, 50 * board - 2 * out, 0), speed * out));
        const CShapeId ball = pWorld->Add(CDynamicCircleDesc(-1.9f * out, 0.1f, {0, 0}, 1, 0));
        Steps(*pWorld, static_cast<int>(4 / (speed * g_fDt)));
        EXPECT_GT(pWorld->GetPos(ball).dot(in), 0);
      }
}

} // namespace
} // namespace Shapes::Native
