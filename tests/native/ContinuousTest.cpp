// SPDX-License-Identifier: MIT
// The native world with Continuous: what happens between impacts, and after many of them. Shots at each kind
// of shape are in tests/compare/ContinuousShotsTest.cpp.
#include "NativeTesting.h"

#include "Tolerances.h"

namespace Shapes {
namespace {

std::unique_ptr<CWorld> MakeContinuous(float gravity = 0) { return MakeNative(g_cContinuous, gravity); }

class ContinuousTest : public testing::Test {
protected:
  std::unique_ptr<CWorld> m_pWorld = MakeContinuous();
};

void AddSlot(CWorld& world) {
  for (const float y : {0.0f, 0.25f})
    world.Add(CLineSegDesc({-1, y}, {1, y}));
}

TEST_F(ContinuousTest, MomentumAndEnergyOfManyBallsAreKept) {
  CRandom random(3);
  SCOPED_TRACE(random.GetSeed());
  AddBox(*m_pWorld, 4);
  for (int i = 0; i < 40; ++i) {
    const Vector2 p(-3.5f + 0.9f * static_cast<float>(i % 8), -3.5f + 1.2f * static_cast<float>(i / 8));
    const float r = random.Uniform(0.1f, 0.4f), mass = random.Uniform(0.1f, 5);
    m_pWorld->Add(CDynamicCircleDesc(p, r, random.VectorOfLength(0, 200), mass));
  }
  const double before = GetEnergy(*m_pWorld, 0);
  Steps(*m_pWorld, 2000);
  // Velocities are rounded to floats in each step: a walk of 2000 half ulps, with a factor of 4.
  EXPECT_NEAR(GetEnergy(*m_pWorld, 0) / before, 1.0, 4 * std::sqrt(2000.0) * 0.5 * g_fUlp);
  EXPECT_GT(m_pWorld->GetStats().m_nContacts, 100000u);
  EXPECT_EQ(m_pWorld->GetStats().m_nBallsHalted, 0u);
  EXPECT_TRUE(AreWithin(*m_pWorld, 4));
}

// Balls of every speed in a closed table with everything in it that they may hit: none gets out, none gets
// into anything. It ends the fastest by the limit of impacts.
TEST_F(ContinuousTest, NoneLeavesAClosedTableAtAnySpeed) {
  for (int exponent = 0; exponent <= 59; exponent += 4) {
    CRandom random(7 + static_cast<std::uint64_t>(exponent));
    SCOPED_TRACE(testing::Message() << "speed 2^" << exponent << ", seed " << random.GetSeed());
    auto pWorld = MakeContinuous(10);
    AddBox(*pWorld, 4);
    pWorld->Add(CPointDesc({1, 1}));
    const CShapeId post = pWorld->Add(CCircleDesc({-2, 2}, 0.5f));
    pWorld->Add(CArcDesc({2, -2}, 0.75f, 0.5f, 4.0f));
    pWorld->Add(Turning(CLineSegDesc({-1, -2}, {1, -2}), 3, {0, -2}));
    pWorld->Add(Turning(CArcDesc({-2.5f, -2.5f}, 0.5f, 0, 2), -2, {-2.5f, -2}));
    for (int i = 0; i < 5; ++i) {
      const Vector2 v = std::ldexp(1.0f, exponent) * random.Direction();
      pWorld->Add(CDynamicCircleDesc({-3.0f + 1.25f * static_cast<float>(i), 3.25f}, 0.2f, v));
    }
    const auto isOutside = [&](const Vector2& p) {
      return (p - pWorld->GetPos(post)).norm() > 0.7f - 32 * g_fUlp;
    };
    InEachStep(*pWorld, 40, [&](int) {
      EXPECT_TRUE(AreWithin(*pWorld, 3.8f + 32 * g_fUlp));
      EXPECT_TRUE(AllBalls(*pWorld, isOutside)) << "in the post";
    });
    const bool isHalted = pWorld->GetStats().m_nBallsHalted > 0;
    EXPECT_TRUE(exponent <= 12 ? !isHalted : isHalted || exponent < 20);
  }
}

// docs/conventions.md promises it for radii from four units in the last place of the coordinates on. Slow
// ones are the hard ones: what an approach must exceed to be more than rounding is not much less than their
// radius.
TEST_F(ContinuousTest, ABallOfFourRoundingsGetsThroughNothing) {
  for (const float x : {1.0f, 1000.0f, 1048576.0f})
    for (const float roundings : {4.0f, 8.0f, 16.0f})
      for (std::uint64_t seed = 0; seed < 40; ++seed) {
        CRandom random(seed);
        const float r = roundings * (std::nextafter(x, 2.0f * x) - x), half = 8.0f * r;
        SCOPED_TRACE(testing::Message()
                     << "at " << x << ", r = " << roundings << " roundings, seed " << seed);
        auto pWorld = MakeContinuous();
        const float low = x - half, high = x + half;
        AddBox(*pWorld, {low, low}, {high, high});
        const float way = r * random.Scale(-8, 8);
        const CShapeId ball = pWorld->Add(CDynamicCircleDesc({x, x}, r, way / g_fDt * random.Direction()));
        InEachStep(*pWorld, 200, [&](int) {
          EXPECT_LE((pWorld->GetPos(ball) - Vector2(x, x)).cwiseAbs().maxCoeff(), half);
        });
      }
}

TEST_F(ContinuousTest, AHaltedBallIsReportedAndGoesOnInTheNextStep) {
  AddSlot(*m_pWorld);
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0, 0.12f}, 0.1f, {0, 8000}));
  m_pWorld->Add(CDynamicCircleDesc({0, 0.6f}, 0.1f, {0, 80}));
  InEachStep(*m_pWorld, 10, [&](int step) {
    EXPECT_EQ(Halted(*m_pWorld), std::vector{ball});
    EXPECT_EQ(m_pWorld->GetContacts().size(), g_nMaxImpacts);
    EXPECT_EQ(m_pWorld->GetStats().m_nBallsHalted, static_cast<std::uint64_t>(step) + 1);
    EXPECT_GE(m_pWorld->GetPos(ball).y(), 0.1f - g_fUlp);
    EXPECT_LE(m_pWorld->GetPos(ball).y(), 0.15f + g_fUlp);
    EXPECT_EQ(m_pWorld->GetVel(ball).norm(), 8000.0f);
  });
}

// Without that bound the ball would have g_nMaxImpacts in each step, and be where it is now.
TEST_F(ContinuousTest, ABallThatAShapePressesOnAnotherIsHaltedSoon) {
  m_pWorld->Add(CLineSegDesc({0, -1}, {0, 1}, 0.5f));
  m_pWorld->Add(Moving(CLineSegDesc({0.21f, -1}, {0.21f, 1}, 0.5f), {-1, 0}));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0.1f, 0}, 0.1f, {0, 0}));
  InEachStep(*m_pWorld, 5, [&](int) {
    EXPECT_EQ(Halted(*m_pWorld), std::vector{ball});
    EXPECT_LE(m_pWorld->GetContacts().size(), 3 * g_nStuckImpacts);
    EXPECT_GT(m_pWorld->GetPos(ball).x(), 0);
  });
}

// But not one that gets out at a side, as along a slope, if only after many impacts at once.
TEST_F(ContinuousTest, ABallThatAShapePressesOnASlopeGetsOut) {
  for (const float angle : {0.2f, 0.3f, 0.5f}) {
    SCOPED_TRACE(angle);
    const auto pWorld = MakeContinuous(10);
    const Vector2 along(std::sin(angle), std::cos(angle));
    pWorld->Add(CLineSegDesc(-2 * along, 2 * along, 0.5f));
    const CShapeId wall = pWorld->Add(Moving(CLineSegDesc({-0.8f, -2}, {-0.8f, 2}, 0.5f), {3, 0}));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-0.45f, 0}, 0.1f, {0, 0}, 1, 0.5f));
    Steps(*pWorld, 15);
    EXPECT_NEAR(pWorld->GetPos(ball).x(), pWorld->GetPos(wall).x() + 0.1f, 1e-3);
    EXPECT_EQ(pWorld->GetStats().m_nBallsHalted, 0u);
  }
}

TEST_F(ContinuousTest, OthersBounceOffAHaltedBall) {
  AddSlot(*m_pWorld);
  m_pWorld->Add(CDynamicCircleDesc({0, 0.12f}, 0.1f, {0, 80000}));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({-0.5f, 0.125f}, 0.1f, {60, 0}));
  m_pWorld->Step();
  EXPECT_LT(m_pWorld->GetPos(ball).x(), -0.2f + g_fUlp);
  EXPECT_LT(m_pWorld->GetVel(ball).x(), 0.0f);
}

TEST_F(ContinuousTest, ABallRollsOverTheJointsOfAFloor) {
  // No elasticity: it stays on the floor, and nothing of the joints is felt.
  auto pWorld = MakeContinuous(10);
  for (int i = 0; i < 20; ++i)
    pWorld->Add(CLineSegDesc({0.37f * static_cast<float>(i), 0}, {0.37f * static_cast<float>(i + 1), 0}, 0));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.2f, 0.1f}, 0.1f, {1, 0}));
  InEachStep(*pWorld, 360, [&](int) {
    EXPECT_NEAR(pWorld->GetPos(ball).y(), 0.1f, 2 * g_fUlp);
    EXPECT_NEAR(pWorld->GetVel(ball).x(), 1.0f, 1e-5f);
  });
  EXPECT_NEAR(pWorld->GetPos(ball).x(), 6.2f, 1e-3f);
}

TEST_F(ContinuousTest, ABallSlidesAlongTheInsideOfABowl) {
  // No elasticity and no gravity: it keeps to the wall and its speed, but for what g_nHops says.
  m_pWorld->Add(CArcDesc({0, 0}, 1, 0, 0, 0.0f));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0.8f, 0}, 0.2f, {0, 6}));
  const float hop = 0.1f / g_nHops, angle = hop / (2 * 0.8f);
  InEachStep(*m_pWorld, 60, [&](int) {
    EXPECT_LT(m_pWorld->GetPos(ball).norm(), 0.8f + 4 * g_fUlp);
    // Sagitta of the hop of a substep's g_nHops-th part, with a factor of 2.
    EXPECT_GT(m_pWorld->GetPos(ball).norm(), 0.8f - 2 * hop * hop / (8 * 0.8f));
  });
  // Each hop loses 1 - cos of its angle: 60 g_nHops of them, with a factor of 2.
  EXPECT_NEAR(m_pWorld->GetVel(ball).norm() / 6, 1, 2 * 60 * g_nHops * angle * angle / 2);
  EXPECT_EQ(m_pWorld->GetStats().m_nBallsHalted, 0u);
}

// Gravity alone is no impact: what lies does not hop, and what is elastic does not climb.
TEST_F(ContinuousTest, WhatLiesGoesOnLying) {
  const float r = 0.1f, diagonal = r * std::sqrt(2.0f);
  for (const float e : {0.0f, 0.5f, 1.0f, 2.0f}) {
    auto pWorld = MakeContinuous(9.8f);
    pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}, e)); // a floor
    pWorld->Add(CLineSegDesc({8, 2}, {10, 0}, e)); // a corner
    pWorld->Add(CLineSegDesc({10, 0}, {12, 2}, e));
    pWorld->Add(CArcDesc({20, 0}, 1, 0, 0, e)); // a bowl
    pWorld->Add(CPointDesc({30, 0}, e));
    for (const Vector2& p :
         {Vector2(0.3f, r), Vector2(0.3f, 3 * r), Vector2(10, diagonal), Vector2(20, r - 1), Vector2(30, r)})
      pWorld->Add(CDynamicCircleDesc(p, r));
    const CShapeId impact = pWorld->Add(CDynamicCircleDesc({-0.5f, r + 1e-3f}, r, {0, -0.1f}));
    const std::vector<Vector2> first(pWorld->GetBallPositions().begin(), pWorld->GetBallPositions().end());
    pWorld->Step();
    // An impact is an impact still, however slow. (A ball has the elasticity 1 by default.)
    const float speed = std::sqrt(0.01f + 2 * 9.8f * 1e-3f), time = (speed - 0.1f) / 9.8f;
    EXPECT_NEAR(pWorld->GetVel(impact).y(), e * speed - (e > 0 ? 9.8f * (g_fDt - time) : 0), 16 * g_fUlp);
    Steps(*pWorld, 10000);
    // Of the two balls on each other the solver lets this speed go on for one step, and then knows better.
    const float left = static_cast<float>(g_fRestingError * g_fRestingSteps) * 9.8f * g_fDt;
    for (std::size_t i = 0; i + 1 < first.size(); ++i)
      EXPECT_LT((pWorld->GetBallPositions()[i] - first[i]).norm(), i < 2 ? left * g_fDt : 1e-6f)
          << "ball " << i << ", elasticity " << e;
  }
}

// Neither lies on anything.
TEST_F(ContinuousTest, BallsThatFallInEachOtherComeApart) {
  auto pWorld = MakeContinuous(10);
  const CShapeId light = pWorld->Add(CDynamicCircleDesc({0, 10}, 0.5f, {0, 0}, 1));
  const CShapeId heavy = pWorld->Add(CDynamicCircleDesc({0.9f, 10}, 0.5f, {0, 0}, 3));
  Steps(*pWorld, 10);
  EXPECT_NEAR(pWorld->GetPos(light).x(), -0.075f, g_fSeparateError);
  EXPECT_NEAR(pWorld->GetPos(heavy).x(), 0.925f, g_fSeparateError);
  EXPECT_EQ(pWorld->GetPos(light).y(), pWorld->GetPos(heavy).y());
}

TEST_F(ContinuousTest, ATurningBarCarriesABallAlong) {
  // No elasticity: the bar pushes the ball before it, never through it.
  m_pWorld->Add(Turning(CLineSegDesc({0.5f, 0}, {3, 0}, 0.0f), 1));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({1, 0.3f}, 0.1f));
  InEachStep(*m_pWorld, 10, [&](int step) {
    const Vector2 n = perp(AngleToVector(g_fTwoPi * g_fDt * static_cast<float>(step + 1)));
    EXPECT_GT(m_pWorld->GetPos(ball).dot(n), 0.1f - 1e-5f);
  });
  EXPECT_GT(m_pWorld->GetVel(ball).norm(), 6.0f);
  EXPECT_EQ(m_pWorld->GetStats().m_nBallsHalted, 0u);
}

// There the normal is against the velocity, and a ball that has bounced must not be taken for one that comes.
TEST_F(ContinuousTest, ACentreExactlyOnAShapeGoesBackWhereItCameFrom) {
  const CAnyShapeDesc shapes[] = {
      CPointDesc({0, 0}),           CCircleDesc({0, 0}, 0),  CLineSegDesc({0, -1}, {0, 1}),
      CLineSegDesc({0, 0}, {0, 1}), CCircleDesc({-1, 0}, 1), CArcDesc({-1, 0}, 1, 0, 0)};
  for (const CAnyShapeDesc& shape : shapes)
    for (const float vx : {1.0f, -1.0f}) {
      SCOPED_TRACE(testing::Message() << "shape " << &shape - shapes << ", v = " << vx);
      auto pWorld = MakeContinuous();
      pWorld->Add(shape);
      const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 0.25f, {vx, 0}));
      pWorld->Step();
      EXPECT_EQ(pWorld->GetContacts().size(), 1u);
      EXPECT_EQ(pWorld->GetVel(ball), Vector2(-vx, 0));
      EXPECT_NEAR(pWorld->GetPos(ball).x(), -vx * (0.25f + g_fDt), 4 * g_fUlp);
    }
}

TEST_F(ContinuousTest, TwoBallsThatMoveIntoEachOtherAtOnePlacePart) {
  const CShapeId first = m_pWorld->Add(CDynamicCircleDesc({0, 0}, 0.25f, {1, 0}));
  const CShapeId second = m_pWorld->Add(CDynamicCircleDesc({0, 0}, 0.25f));
  m_pWorld->Step();
  EXPECT_EQ(m_pWorld->GetVel(first), Vector2(0, 0));
  EXPECT_EQ(m_pWorld->GetVel(second), Vector2(1, 0));
  EXPECT_NEAR(m_pWorld->GetPos(second).x() - m_pWorld->GetPos(first).x(), 0.5f + g_fDt, 4 * g_fUlp);
}

// Its centre has come through the platform when it turns round, but not all of it; one whose centre has not
// falls back.
TEST_F(ContinuousTest, ABallThatTurnsRoundInAOneSidedPlatformLiesOnIt) {
  constexpr double r = 0.1, g = 10.0, below = 0.5;
  for (const double highest : {-0.02, 0.02, 0.05, 0.09}) {
    SCOPED_TRACE(testing::Message() << "turns round at " << highest);
    const auto pWorld = MakeNative(g_cAutomatic, static_cast<float>(g));
    pWorld->Add(Sided(CLineSegDesc({-1, 0}, {1, 0}), eSides::Front));
    const double speed = std::sqrt(2 * g * (highest + below));
    const CDynamicCircleDesc desc({0, -static_cast<float>(below)}, static_cast<float>(r),
                                  {0, static_cast<float>(speed)}, 1, 0.5f);
    const CShapeId ball = pWorld->Add(desc);
    const int rising = static_cast<int>(speed / (g * Wide(g_fDt)));
    Steps(*pWorld, rising);
    const double t = rising * Wide(g_fDt);
    EXPECT_NEAR(Wide(pWorld->GetPos(ball).y()), -below + speed * t - g * t * t / 2, 1e-6); // on its parabola
    Steps(*pWorld, 60);
    if (highest > 0)
      EXPECT_NEAR(Wide(pWorld->GetPos(ball).y()), r, 1e-6);
    else
      EXPECT_LT(pWorld->GetPos(ball).y(), -1);
  }
}

TEST_F(ContinuousTest, ABallThatRestsIsNotTakenUpByAOneSidedPlatformThatSinksPastIt) {
  const auto pWorld = MakeNative(g_cAutomatic, 10);
  pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  pWorld->Add(Sided(Moving(CLineSegDesc({-1, 0.5f}, {1, 0.5f}), {0, -0.1f}), eSides::Front));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.1f}, 0.1f, {0, 0}, 1, 0.5f));
  InEachStep(*pWorld, 360, [&](int) { EXPECT_NEAR(Wide(pWorld->GetPos(ball).y()), 0.1, 1e-6); });
}

// The upper one is in the gate; they overlap by a rounding.
TEST_F(ContinuousTest, TwoBallsThatTouchComeThroughAOneSidedGate) {
  m_pWorld->Add(Sided(CLineSegDesc({-1, 0}, {1, 0}), eSides::Front));
  const CShapeId lower = m_pWorld->Add(CDynamicCircleDesc({0, 0.02f}, 0.1f, {0, 1}));
  const CShapeId upper = m_pWorld->Add(CDynamicCircleDesc({0, 0.22f}, 0.1f, {0, 1}));
  m_pWorld->Step();
  EXPECT_NEAR(m_pWorld->GetPos(lower).y(), 0.02f + g_fDt, 4 * g_fUlp);
  EXPECT_NEAR(m_pWorld->GetPos(upper).y(), 0.22f + g_fDt, 4 * g_fUlp);
}

// Wherever in a step it is met, also at its end, and wherever the wall is.
TEST_F(ContinuousTest, ABallWithoutRadiusStaysOnItsSide) {
  for (const float y : {0.0f, 1.0f, 0.1f, -700.3f})
    for (const float dt : {1.0f, 0.25f, 1.0f / 60.0f, 0.1f})
      for (const float r : {0.0f, 1e-30f, 1e-9f}) {
        SCOPED_TRACE(testing::Message() << "y = " << y << ", step " << dt << ", r = " << r);
        const auto pWorld = MakeNative(g_cContinuous, 0, dt);
        pWorld->Add(CLineSegDesc({-1, y}, {1, y}));
        for (const Vector2& v : {Vector2(0, 1), Vector2(0.1f, 0.7f)}) {
          pWorld->Add(CDynamicCircleDesc({-0.5f, y + 1}, r, -v));
          pWorld->Add(CDynamicCircleDesc({0.5f, y - 1}, r, v));
        }
        for (float t = 0; t < 3; t += dt)
          pWorld->Step();
        for (std::size_t i = 0; i < 4; ++i) {
          const float side = i % 2 == 0 ? 1.0f : -1.0f;
          EXPECT_GT(side * (pWorld->GetBallPositions()[i].y() - y), 0) << "ball " << i;
          EXPECT_GT(side * pWorld->GetBallVelocities()[i].y(), 0) << "ball " << i;
        }
        EXPECT_EQ(pWorld->GetStats().m_nBallsHalted, 0u);
      }
}

TEST_F(ContinuousTest, WithoutGravityWhatMeetsNothingHasTheBitsOfTheApproximateWay) {
  CRandom random(11);
  SCOPED_TRACE(random.GetSeed());
  std::vector<CDynamicCircleDesc> balls;
  for (int i = 0; i < 50; ++i)
    balls.emplace_back(Vector2(3.0f * static_cast<float>(i), 0), 0.1f,
                       Vector2{random.Uniform(-0.1f, 0.1f), random.Uniform(-100, 100)});
  auto pSwept = MakeContinuous(), pApproximate = MakeNative(g_cApproximate);
  for (CWorld* pWorld : {pSwept.get(), pApproximate.get()}) {
    pWorld->Add(CLineSegDesc({-1000, -10000}, {1000, -10000}));
    for (const CDynamicCircleDesc& ball : balls)
      pWorld->Add(ball);
    Steps(*pWorld, 300);
  }
  EXPECT_TRUE(HaveSameBits(*pSwept, *pApproximate));
}

TEST_F(ContinuousTest, DoesNotDependOnTheOrderOfShapes) {
  CRandom random(5);
  SCOPED_TRACE(random.GetSeed());
  std::vector<CLineSegDesc> walls;
  for (int i = 0; i < 30; ++i)
    walls.push_back(CLineSegDesc{random.InSquare(4), random.InSquare(4)});
  const auto play = [&] {
    auto pWorld = MakeContinuous();
    for (const CLineSegDesc& wall : walls)
      pWorld->Add(wall);
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 1e-3f, {50, 31}));
    Steps(*pWorld, 50);
    return pWorld->GetPos(ball);
  };
  const Vector2 p = play();
  std::reverse(walls.begin(), walls.end());
  EXPECT_EQ(play(), p);
}

} // namespace
} // namespace Shapes
