// SPDX-License-Identifier: MIT
// Naked ends of arcs: a tuned world bounces off them as off points, from beyond, from outside and inside.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nTunedArcEndSeed = 67;

/// How many of 1,000 shots at the ends of an arc of radius 1, r = .1, up to 85 degrees from the normal and 90
/// m/s, are off by more than .01 radians and what surfaces that are g_fTunedOffset off explain. Shots that a
/// surface so little off sends elsewhere altogether have no resolution and are left out.
int CountWrong(eProfile profile, double degrees) {
  CRandom random(g_nTunedArcEndSeed);
  CRange range(MakeBox2D(profile), {CArcDesc({0, 0}, 1, 0, static_cast<float>(degrees * g_fDegree))}, 0.1f);
  int wrong = 0;
  for (int k = 0; k < 1000;) {
    const Vector2d end = UnitVector(random.Coin() ? degrees * g_fDegree : 0);
    const Vector2d n = UnitVector(360 * g_fDegree * random.Unit());
    const double incidence = EitherSign(random, 85 * g_fDegree), phase = random.Unit();
    const double speed = 1 + 89 * random.Unit();
    const auto shot = range.Aim({end, n, incidence, speed, phase, 3});
    if (!shot || shot->m_fAllowance > 0.5) continue;
    ++k;
    wrong += range.DirectionError(*shot) > 0.01 + shot->m_fAllowance;
  }
  return wrong;
}

TEST(TunedArcEndTest, NakedEndsAreRound) {
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedArcEndSeed);
  for (const double degrees : {90, 180, 270, 340}) {
    SCOPED_TRACE(degrees);
    EXPECT_EQ(CountWrong(eProfile::Tuned, degrees), 0);
    EXPECT_GT(CountWrong(eProfile::Shipped, degrees), 100); // the control
  }
}

} // namespace
} // namespace Shapes::Tests
