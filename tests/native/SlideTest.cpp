// SPDX-License-Identifier: MIT
// Balls that slide on circles under gravity, held to the exact reference.
#include "NativeTesting.h"

#include "reference/Reference.h"

namespace Shapes {
namespace {

/// A ball begins to slide on a shape about the origin that has no elasticity. It is looked at until .3 s
/// after it has left that, or for 100 s.
/// @param most  how far it may be off, and also its velocity after it has left
/// @returns steps for which it has flown
int ExpectExactWay(const CAnyShapeDesc& shape, const Vector2d& p, float r, const Vector2& v, double most) {
  const auto pWorld = MakeNative(g_cAutomatic, 10);
  pWorld->Add(shape);
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc(p.cast<float>(), r, v));
  Compare::CReference<double> exact(std::array{shape}, std::array{CDynamicCircleDesc({0, 0}, r)}, {0, -10});
  exact.SetBall(0, p, Wide(v));
  std::vector<Compare::CExactEvent<double>> events;
  const double length = p.norm(), first = EnergyOf(*pWorld, ball, 10, -length);
  int flown = 0;
  InEachStep(*pWorld, 6000, [&](int) {
    if (flown == 18) return;
    exact.Step(Wide(g_fDt), events);
    flown += exact.GetForce(0, 0) == 0.0;
    const double off = (Wide(pWorld->GetPos(ball)) - exact.GetBall(0).m_vPos).norm();
    EXPECT_LT(off, most);
    EXPECT_NEAR(EnergyOf(*pWorld, ball, 10, -length), first, 2e-6 * (1.0 + first));
    if (flown == 0) {
      EXPECT_NEAR(Wide(pWorld->GetPos(ball).norm()), length, 1e-6);
    }
    if (flown == 18) {
      EXPECT_LT(off + (Wide(pWorld->GetVel(ball)) - exact.GetBall(0).m_vVel).norm(), most);
    }
  });
  EXPECT_TRUE(events.empty());
  EXPECT_EQ(pWorld->GetStats().m_nBallsHalted, 0u);
  return flown;
}

TEST(Slide, ABallSlidesInABowlAsAPendulum) {
  for (const double amplitude : {0.1, 0.5, 1.0, 1.5}) {
    SCOPED_TRACE(amplitude);
    const Vector2d start = 0.75 * Vector2d(std::sin(amplitude), -std::cos(amplitude));
    // A period is off by a hundred thousandth: where it is fastest the ball is late by so much of 100 s.
    const double fastest = std::sqrt(2.0 * 10.0 * (0.75 + start.y()));
    const CArcDesc bowl({0, 0}, 1, 0, 0, 0.0f);
    EXPECT_EQ(ExpectExactWay(bowl, start, 0.25f, {0, 0}, 1e-5 * 100.0 * fastest), 0);
  }
}

// Of a part of the way that turns by g_fSlideTurn the end is off by its fourth power / 24, in radii. Errors
// of the parts of half a circle add up, and grow as the angle from the top does.
constexpr double g_fBound = 4e-4;

TEST(Slide, ABallLeavesACircleWhereItWouldBePulled) {
  for (const float v : {0.1f, 0.5f, 1.0f, 2.0f}) {
    SCOPED_TRACE(v);
    const CCircleDesc circle({0, 0}, 0.375f, 0.0f);
    EXPECT_EQ(ExpectExactWay(circle, {0, 0.5}, 0.125f, {v, 0}, g_fBound), 18);
  }
}

// From the level of its middle to `end` radians right of the bottom.
TEST(Slide, ABallLeavesABowlAtItsEnd) {
  const double length = Wide(0.6f) - Wide(0.1f);
  for (const float end : {0.3f, 0.8f, 1.2f}) {
    SCOPED_TRACE(end);
    const CArcDesc bowl({0, 0}, 0.6f, 3.0f, 4.712389f + end, 0.0f);
    EXPECT_EQ(ExpectExactWay(bowl, {-length, 0}, 0.1f, {0, 0}, g_fBound), 18);
  }
}

// It goes along with the bowl, which is all that a bowl in even motion changes.
TEST(Slide, InABowlThatMovesEvenlyABallSlidesAsInOneAtRest) {
  const Vector2 vel(3, 1), start(0.45f, -0.6f);
  const auto pResting = MakeNative(g_cAutomatic, 10), pMoving = MakeNative(g_cAutomatic, 10);
  const auto bowl = Turning(CArcDesc({0, 0}, 1, 0, 0, 0.0f));
  pResting->Add(bowl);
  const CShapeId moving = pMoving->Add(bowl);
  pMoving->SetVel(moving, vel);
  const CShapeId a = pResting->Add(CDynamicCircleDesc(start, 0.25f, {0, 0}));
  const CShapeId b = pMoving->Add(CDynamicCircleDesc(start, 0.25f, vel));
  InEachStep(*pResting, 120, [&](int) {
    pMoving->Step();
    const Vector2 inBowl = pMoving->GetPos(b) - pMoving->GetPos(moving);
    EXPECT_LT((inBowl - pResting->GetPos(a)).norm(), 4 * 4.8e-7f); // roundings of places up to 8 units
  });
}

} // namespace
} // namespace Shapes
