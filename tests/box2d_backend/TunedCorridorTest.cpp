// SPDX-License-Identifier: MIT
// A narrow corridor: dozens of hits in a step.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nTunedCorridorSeed = 49;

/// How many of 20 balls of .1 at 80 m/s leave a corridor of .25 within 1,000 hits; at 0 degrees they go
/// straight from wall to wall, 27 times a step.
int CountLost(eProfile profile, double degrees) {
  CRandom random(g_nTunedCorridorSeed);
  int lost = 0;
  for (int k = 0; k < 20; ++k) {
    auto pWorld = MakeBox2D(profile);
    for (const float y : {-0.125f, 0.125f})
      pWorld->Add(CLineSegDesc({-200, y}, {200, y}));
    const double y = EitherSign(random, 0.02), along = std::sin(degrees * g_fDegree),
                 across = std::cos(degrees * g_fDegree);
    const Vector2 v = (80 * Vector2d(along, across)).cast<float>();
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-100, static_cast<float>(y)}, 0.1f, v));
    const int steps = static_cast<int>(std::ceil(1000 * 0.05 / (80 * across) / g_fDt));
    bool isIn = true;
    for (int i = 0; i < steps && isIn; ++i) {
      pWorld->Step();
      isIn = std::abs(pWorld->GetPos(ball).y()) < 0.125f;
      if (!isIn) continue;
      EXPECT_NEAR(pWorld->GetVel(ball).x(), v.x(), 80 * 1e-4f);
      EXPECT_NEAR(std::abs(pWorld->GetVel(ball).y()), v.y(), 80 * 1e-4f);
    }
    lost += !isIn;
  }
  return lost;
}

TEST(TunedCorridorTest, ABallStaysForAThousandHits) {
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedCorridorSeed);
  for (const double degrees : {0, 20, 45, 70}) {
    SCOPED_TRACE(degrees);
    EXPECT_EQ(CountLost(eProfile::Tuned, degrees), 0);
  }
}

TEST(TunedCorridorTest, AShippedBallIsLost) { // the control
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedCorridorSeed);
  EXPECT_EQ(CountLost(eProfile::Shipped, 0), 20);
  EXPECT_GT(CountLost(eProfile::Shipped, 20), 0);
}

} // namespace
} // namespace Shapes::Tests
