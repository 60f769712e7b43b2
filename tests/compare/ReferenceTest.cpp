// SPDX-License-Identifier: MIT
// The exact reference on cases with known answers; and under gravity: balls that bounce, come to rest, lie on
// floors, in wedges and on each other, and roll off.
#include "ReferenceTesting.h"

namespace Shapes::Compare::Tests {
namespace {

TEST(Reference, BallsMeetAsOftenAndLeaveAsTheyShould) {
  const auto expect = [](const char* pName, const CShapes& shapes, const CBalls& balls, double seconds,
                         std::size_t hits, const std::vector<CVec2d>& velocities, double tolerance = 0) {
    for (const int steps : {1, 128, 2000}) {
      SCOPED_TRACE(testing::Message() << pName << ", " << steps << " steps");
      CExact reference = Make(shapes, balls);
      EXPECT_EQ(Carry(reference, seconds / steps, steps).size(), hits);
      for (std::size_t i = 0; i < balls.size(); ++i)
        EXPECT_LE((reference.GetBall(i).m_vVel - velocities[i]).norm(), tolerance);
    }
  };
  const auto ball = [](const Vector2& p, const Vector2& v, float r, float e = 1) {
    return CDynamicCircleDesc(p, r, v, 1, e);
  };
  for (const float e : {.25f, .5f})
    expect("by the product of elasticities", {},
           {ball({-1, 0}, {1, 0}, .25f, e), ball({1, 0}, {-1, 0}, .25f, .75f - e)}, 1, 1,
           {{-.125, 0}, {.125, 0}}, 1e-15);
  for (const bool meet : {true, false}) { // the first gives its speed to the second, which comes back with it
    CLineSegDesc wall = Wall({1, -1}, {1, 1});
    CBalls balls = {ball({-1, 0}, {4, 0}, .1f), ball({0, 0}, {0, 0}, .1f)};
    wall.m_cFilter = {1, 2};
    balls[0].m_cFilter = {4, 2};
    balls[1].m_cFilter = {2, meet ? CFilter().m_nMask : std::uint16_t{2}};
    expect("filters", {wall}, balls, 1, meet ? 3u : 0u, {{meet ? -4.0 : 4.0, 0}, {0, 0}}, 1e-12);
  }
  // Where no direction leads away the normal is against the velocity: one that leaves must not be taken for
  // one that comes. Into the last circle a ball with a radius does not fit.
  const std::pair<CAnyShapeDesc, float> shapes[] = {
      {CPointDesc({0, 0}), 0},      {Wall({0, -1}, {0, 1}), 0},      {Wall({0, 0}, {0, 1}), 0},
      {CCircleDesc({-1, 0}, 1), 0}, {CArcDesc({-1, 0}, 1, 0, 0), 0}, {CCircleDesc({0, 0}, .125f), .25f}};
  for (const auto& [shape, least] : shapes)
    for (const double v : {1.0, -1.0})
      for (const float r : {least, .25f})
        expect("centre on a shape", {shape}, {ball({0, 0}, {static_cast<float>(v), 0}, r)}, .25, 1,
               {{-v, 0}});
  for (const float r : {.25f, 0.f})
    expect("balls at one place", {}, {ball({0, 0}, {1, 0}, r), ball({0, 0}, {0, 0}, r)}, .25, 1,
           {{0, 0}, {1, 0}});
  for (const float y : {0.f, 1.f, -700.3f}) // at the origin too, where nothing has a size
    expect("balls without radius", {Wall({-1, y}, {1, y}), CPointDesc({2, y})},
           {ball({0, y + 1}, {0, -1}, 0), ball({2, y + 1}, {0, -1}, 0)}, 1.25, 2, {{0, 1}, {0, 1}});
  for (const eSides sides : {eSides::Both, eSides::Front})
    for (const double side : {1.0, -1.0}) { // some steps end while it is half way through
      const bool passes = sides == eSides::Front && side < 0;
      expect("one-way gate", {Sided(Wall({-1, 0}, {1, 0}), sides)},
             {ball({.1f, static_cast<float>(side)}, {0, static_cast<float>(-side)}, .25f)}, 2,
             passes ? 0u : 1u, {{0, passes ? -side : side}});
    }
}

TEST(Reference, ASpeedBeyondDoublesIsRefused) {
  const auto carry = [](float e) {
    CExact exact = Make(Box(1, e), {CDynamicCircleDesc({.1f, 0}, .25f, {1, 0})});
    Carry(exact, 2);
    return exact.GetBall(0).m_vVel.norm();
  };
  EXPECT_NEAR(carry(1), 1, 1e-12);
  // A thousand times as fast after each impact, and so a thousand times as early.
  EXPECT_THROW(carry(1000), std::runtime_error);
}

// Through memory: g++ 12 at -O2 takes a pair of conversions to float and back for none.
CVec2d AsFloats(const CVec2d& v) {
  volatile float x = static_cast<float>(v.x()), y = static_cast<float>(v.y());
  return {static_cast<double>(x), static_cast<double>(y)};
}

// The state from which a step of an engine starts.
void RoundToFloat(CExact& reference) {
  for (std::size_t i = 0; i < reference.GetBallCount(); ++i)
    reference.SetBall(i, AsFloats(reference.GetBall(i).m_vPos), AsFloats(reference.GetBall(i).m_vVel));
}

TEST(ReferenceGravity, RoundingToFloatsRounds) {
  volatile double third = 1.0 / 3;
  EXPECT_NE(AsFloats({third, third}).x(), third);
}

// Never in, never out by more than the float that its place was rounded to and the hop that this allows: it
// falls from one rounding, and bounces no higher. From exact places it rests at once and stays.
TEST(ReferenceGravity, RestsOnAFloorFromExactAndFromRoundedPlaces) {
  for (const float e : {0.0f, .5f, .9f, 1.0f})
    for (const float tilt : {0.0f, 1.0f, 3.0f})
      for (const bool rounded : {true, false}) {
        SCOPED_TRACE(testing::Message() << "e " << e << " tilt " << tilt << " rounded " << rounded);
        // Gravity is straight into the floor, whichever way it is tilted.
        const Vector2 along = Vector2(3, tilt).normalized();
        const CVec2d n = Perp(CVec2d(Vector2(3, tilt).cast<double>())).normalized();
        CExact reference = Make({Wall({-3, -tilt}, {3, tilt}, e)}, {CDynamicCircleDesc({0, 0}, .3f)},
                                9.81f * Vector2(along.y(), -along.x()));
        const double r = reference.GetBall(0).m_fRadius, rounding = rounded ? 0x1p-24 : 1e-13;
        reference.SetBall(0, r * n, {0, 0});
        double least = 1, most = -1;
        std::size_t events = 0;
        for (int i = 0; i < 10000; ++i) {
          if (rounded) RoundToFloat(reference);
          events += Carry(reference, 1.0 / 60).size();
          const double gap = reference.GetBall(0).m_vPos.dot(n) - r;
          least = std::min(least, gap);
          most = std::max(most, gap);
        }
        EXPECT_GE(least, -rounding);
        EXPECT_EQ(reference.GetSlideCount(), 0u);
        // Elastic balls may gain a rounding of height where a step begins; the others lose it.
        if (rounded && e == 1) continue;
        EXPECT_LE(most, 2 * rounding);
        EXPECT_GT(reference.GetRestCount(), 100u);
        if (rounded) continue;
        EXPECT_EQ(events, 0u);
        EXPECT_EQ(reference.GetRestCount(), 10000u);
        // Of a direction that floats do not have a little is left along the floor.
        EXPECT_LE(std::abs(reference.GetBall(0).m_vVel.dot(n)), 1e-12);
        if (tilt != 1) {
          EXPECT_LE(reference.GetBall(0).m_vVel.norm(), 1e-12);
        }
      }
}

// Over a joint. Fast enough it flies off at the end at once: v^2 > g r. Slower it goes round the end first.
TEST(ReferenceGravity, RollsOffTheEndAndFalls) {
  for (const double v : {2.0, .5}) {
    SCOPED_TRACE(v);
    CExact reference = MakeOne({Wall({-4, 0}, {-.5f, 0}, .5f), Wall({-.5f, 0}, {0, 0}, .5f)}, .25f, {-1, .25},
                               {v, 0}, g_vPull);
    Carry(reference, 1 / v + .4);
    const CExactBall<double>& ball = reference.GetBall(0);
    if (v == 2.0) {
      EXPECT_NEAR((ball.m_vPos - CVec2d(v * .4, .25 - .5 * g_fPull * .16)).norm(), 0, 1e-12);
      EXPECT_NEAR((ball.m_vVel - CVec2d(v, -g_fPull * .4)).norm(), 0, 1e-12);
    } else {
      EXPECT_LT(ball.m_vPos.y(), 0);
      EXPECT_GT(ball.m_vPos.norm(), .25);
      // Nothing has been gained but the height.
      EXPECT_NEAR(Energy(reference, g_fPull), .5 * v * v + g_fPull * .25, 1e-12);
      EXPECT_GT(reference.GetSlideCount(), 0u);
    }
  }
}

// In a wedge it touches both sides; of a dropped pair the lower one comes to rest, then the upper one on it.
TEST(ReferenceGravity, WhatFallsComesToRestAndStaysThere) {
  const auto expect = [](const char* pName, const CShapes& shapes, const CBalls& balls,
                         const std::vector<CVec2d>& places, double bound) {
    SCOPED_TRACE(pName);
    CExact reference = Make(shapes, balls, g_vPull);
    Carry(reference, 10);
    EXPECT_TRUE(Carry(reference, 1.0 / 60, 600).empty());
    for (std::size_t i = 0; i < balls.size(); ++i) {
      EXPECT_NEAR((reference.GetBall(i).m_vPos - places[i]).norm(), 0, bound);
      EXPECT_NEAR(reference.GetBall(i).m_vVel.norm(), 0, 1e-12);
    }
    const bool isRound = std::holds_alternative<CCircleDesc>(shapes[0]); // there it slides, to no end
    EXPECT_EQ(reference.GetRestCount() > 1000u, !isRound);
    EXPECT_EQ(reference.GetSlideCount() > 600u, isRound);
    for (int i = 0; i < 600; ++i) {
      RoundToFloat(reference);
      Carry(reference, 1.0 / 60);
    }
    for (std::size_t i = 0; i < balls.size(); ++i)
      EXPECT_NEAR((reference.GetBall(i).m_vPos - places[i]).norm(), 0, 1e-6);
  };
  const double across = .25 * std::sqrt(2), x = (across - .25 * std::sqrt(5)) / 3;
  const auto ball = [](float y, float m, float e) { return CDynamicCircleDesc({0, y}, .25f, {0, 0}, m, e); };
  for (const float e : {0.0f, .5f, .8f})
    expect("wedge", {Wall({-2, 2}, {0, 0}, e), Wall({0, 0}, {1, 2}, e)}, {ball(1, 1, 1)}, {{x, across - x}},
           1e-12);
  for (const float e : {.5f, .25f})
    expect("lowest place of a ring", {CCircleDesc({0, 2}, 2, e)}, {ball(1.25f, 1, 1)}, {{0, .25}}, 1e-13);
  for (const float e : {0.0f, .5f, 1.0f})
    expect("standing", {Wall({-2, 0}, {2, 0}, e)}, {ball(.25f, 3, e), ball(.75f, 5, e)}, {{0, .25}, {0, .75}},
           1e-13);
  expect("dropped", {Wall({-2, 0}, {2, 0}, .5f)}, {ball(.5f, 3, .7f), ball(1.5f, 1, .7f)},
         {{0, .25}, {0, .75}}, 1e-12);
}

// 16 roundings of the energy a bounce.
TEST(ReferenceGravity, ElasticBounceKeepsItsEnergy) {
  for (const bool curved : {false, true}) {
    SCOPED_TRACE(curved);
    const CShapes shapes = {curved ? CAnyShapeDesc(CCircleDesc({0, -1}, 1))
                                   : CAnyShapeDesc(Wall({-1, -.0f}, {1, 0}))};
    CExact reference = Make(shapes, {CDynamicCircleDesc({0, 1}, .25f)}, g_vPull);
    const double energy = g_fPull * .75;
    std::size_t bounces = 0;
    for (const double dt : {1.0 / 60, 30.0})
      while (bounces < (dt < 1 ? 5000u : 10000u)) {
        bounces += Carry(reference, dt).size();
        ASSERT_NEAR(Energy(reference, g_fPull, .25) / energy, 1,
                    16 * g_fEps * static_cast<double>(bounces + 1))
            << bounces;
      }
    EXPECT_EQ(reference.GetSlideCount() + reference.GetRestCount(), 0u);
  }
  // Control: an elasticity a little off.
  CExact lossy = Make({Wall({-1, 0}, {1, 0}, 1 - 1e-6f)}, {CDynamicCircleDesc({0, 1}, .25f)}, g_vPull);
  const std::size_t bounces = Carry(lossy, 30).size();
  EXPECT_LT(Energy(lossy, g_fPull, .25) / (g_fPull * .75), 1 - 16 * g_fEps * static_cast<double>(bounces));
}

} // namespace
} // namespace Shapes::Compare::Tests
