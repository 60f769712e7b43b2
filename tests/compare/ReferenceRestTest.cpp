// SPDX-License-Identifier: MIT
// The exact reference where balls rest, slide, jam, pass or are only noticed.
#include "ReferenceTesting.h"

namespace Shapes::Compare::Tests {
namespace {

TEST(ReferenceRest, SensorIsReportedOncePerStep) {
  CExact reference = Make({Sensor(Wall({0, -1}, {0, 1})), Wall({1, -1}, {1, 1})},
                          {CDynamicCircleDesc({-1, 0}, .25f, {4, 0})});
  const CEvents events = Carry(reference, 1);
  // On its way out it is met again, in the same step: once.
  ASSERT_EQ(events.size(), 2u);
  EXPECT_TRUE(events[0].m_bIsSensor);
  EXPECT_NEAR(events[0].m_fTime, .75 / 4, 1e-15);
  EXPECT_EQ(events[0].m_vVelAfter, events[0].m_vVelBefore);
  EXPECT_FALSE(events[1].m_bIsSensor);
  EXPECT_NEAR(reference.GetBall(0).m_vPos.x(), -1 + 2 * 1.75 - 4, 1e-15 * 8);

  // A ball that is in it, whichever way it goes, is reported at once.
  reference.SetBall(0, {.1, 0}, {.001, 0});
  const CEvents inside = Carry(reference, .01);
  ASSERT_EQ(inside.size(), 1u);
  EXPECT_TRUE(inside[0].m_bOverlapped);
  EXPECT_EQ(inside[0].m_fTime, 0);
}

// A circle is a disk, which is seen from its middle, an arc is seen when the ball comes to it; there are no
// sides; and a ball may be a sensor too.
TEST(ReferenceRest, SensorsAreSeenFromAnywhereAndChangeNothing) {
  const CDynamicCircleDesc right({-1, 0}, .25f, {1, 0}), left({1, 0}, .25f, {-1, 0});
  std::vector<std::tuple<CShapes, CBalls, double>> cases = {
      {{Sensor(CCircleDesc({-1, 0}, 2))}, {right}, 0},
      {{Sensor(CArcDesc({-1, 0}, 2, 0, 0))}, {right}, 1.75},
      {{}, {Sensor(right), left}, .75}};
  for (const eSides sides : {eSides::Both, eSides::Front, eSides::Back})
    for (const CDynamicCircleDesc& ball : {right, left})
      cases.push_back({{Sensor(Sided(Wall({0, -1}, {0, 1}), sides))}, {ball}, .75});
  for (const auto& [shapes, balls, time] : cases) {
    CExact reference = Make(shapes, balls);
    const CEvents events = Carry(reference, 3);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_TRUE(events[0].m_bIsSensor);
    EXPECT_EQ(events[0].m_bIsBall, shapes.empty());
    EXPECT_NEAR(events[0].m_fTime, time, 1e-14);
    EXPECT_EQ(reference.GetBall(0).m_vVel, ToDouble(balls[0].m_vVel));
  }
}

TEST(ReferenceRest, WhatDoesNotCollideIsPassed) {
  enum eOff { None, Shape, Ball }; // none is the control
  for (const eOff off : {None, Shape, Ball}) {
    CExact reference = Make({Wall({0, -1}, {0, 1})}, {CDynamicCircleDesc({-1, 0}, .25f, {1, 0})});
    if (off == Shape) reference.SetCanCollide(0, false);
    if (off == Ball) reference.SetBallCanCollide(0, false);
    EXPECT_EQ(Carry(reference, 2).size(), off == None ? 1u : 0u);
    EXPECT_EQ(reference.GetBall(0).m_vPos == CVec2d(1, 0), off != None);
  }
}

TEST(ReferenceRest, PlacesAreExactAfterAHit) {
  // A ball without extent stays on its side of a slanted segment for ten thousand hits.
  const CVec2d along = CVec2d(2, .75).normalized(), n = Perp(along);
  CExact reference = MakeOne({Wall({-1, -.25f}, {1, .5f}), Wall({-1, .75f}, {1, 1.5f})}, 0, {0, .5}, 7 * n);
  CEvents events;
  while (events.size() < 10000) {
    reference.Step(1.0 / 60, events);
    ASSERT_GT((reference.GetBall(0).m_vPos - CVec2d(0, .125)).dot(n), -1e-12);
    ASSERT_LT((reference.GetBall(0).m_vPos - CVec2d(0, 1.125)).dot(n), 1e-12);
  }
}

TEST(ReferenceRest, JammedBallThrowsAndIsNamed) {
  const CShapes gap = {Wall({-1, 0}, {1, 0}), Wall({-1, 1.000002f}, {1, 1.000002f})};
  const CDynamicCircleDesc ball({.125f, .500001f}, .5f, {0, 1});
  CExact reference = Make(gap, {CDynamicCircleDesc({9, 9}, .1f), ball});
  EXPECT_TRUE(Says(MessageOf<std::runtime_error>([&] { Carry(reference, 1); }), "ball 1 at (0.125, 0.5"));
  // Control: a step in which it hits less often.
  CExact brief = Make(gap, {ball});
  EXPECT_NO_THROW(Carry(brief, 1e-4));
}

TEST(ReferenceRest, NearMissesAreCounted) {
  CExact reference = MakeOne({CPointDesc({0, 0})}, .5f, {-1.03, .5 * (1 + 1e-12)}, {1, 0});
  EXPECT_TRUE(Carry(reference, .1, 20).empty());
  EXPECT_EQ(reference.GetNearMissCount(), 1u);
  reference.SetBall(0, {-1, .5 * (1 - 1e-12)}, {1, 0});
  const CEvents events = Carry(reference, 2);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events[0].m_bGraze);
  EXPECT_EQ(reference.GetNearMissCount(), 1u);
}

// Random tables on which balls bounce, pile up and are batted. Nobody gets into anything. Without blades no
// energy is gained; where all is elastic and nothing pulls it is kept, to 8 roundings a bounce, and the
// momentum is what the shapes gave. The controls are elasticities a little below and above 1.
TEST(ReferenceRest, TablesKeepBallsApartAndEnergyFromGrowing) {
  enum eTable { Elastic, Dull, Lively, Piles, Batted, Tables };
  std::size_t bounces = 0, pairs = 0, slides = 0, rests = 0, gains = 0, jams = 0;
  for (std::uint64_t seed = 0; seed < 4 * Tables; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    CRandom random(seed);
    const auto table = static_cast<eTable>(seed % Tables);
    const auto elasticity = [&] {
      const float e[] = {1, 1 - 1e-4f, 1.01f};
      return table <= Lively ? e[table] : random.Coin() ? 0 : random.Uniform(0, 1);
    };
    const float g = table <= Lively ? 0 : 9.8f;
    // Piles lie in a bowl.
    CShapes shapes = table == Piles ? CShapes{CArcDesc({0, 0}, 4, 0, 0, elasticity())}
                                    : Box(4, table == Batted ? .5f : elasticity());
    for (int k = 0; k < 12; ++k) {
      const Vector2 p(-2.4f + 1.6f * static_cast<float>(k % 4), -2 + 1.6f * static_cast<float>(k / 4));
      const float e = elasticity(), size = random.Uniform(.1f, .5f), a = random.Uniform(0, 6);
      const float revs = random.Uniform(-2, 2);
      const CLineSegDesc wall = Wall(p, p + size * AngleToVector(a), e);
      if (k % 4 == 0) shapes.emplace_back(CCircleDesc(p, size, e));
      if (k % 4 == 1) shapes.emplace_back(CArcDesc(p, size, a, a + 3, e));
      if (k % 4 == 2) shapes.emplace_back(CPointDesc(p, e));
      if (k % 4 == 3) shapes.emplace_back(table == Batted ? Turning(wall, revs, p) : wall);
    }
    CBalls balls;
    for (int i = 0; i < 8; ++i) {
      const float r = random.Uniform(.05f, .25f), m = random.Uniform(.1f, 5);
      balls.emplace_back(Vector2(-2.45f + .7f * static_cast<float>(i), 2.6f), r, random.InSquare(5), m,
                         elasticity());
    }
    CExact reference = Make(shapes, balls, {0, -g});
    const auto energy = [&] { return Energy(reference, static_cast<double>(g), -4); };
    const double first = energy();
    double before = first, size = 0;
    for (std::size_t i = 0; i < balls.size(); ++i)
      size += reference.GetBall(i).m_fMass * reference.GetBall(i).m_vVel.norm();
    CVec2d momentum = Momentum(reference);
    std::size_t own = 0; // bounces of this table
    for (int step = 0; step < 400; ++step) {
      SCOPED_TRACE(step);
      CEvents events;
      try {
        events = Carry(reference, 1.0 / 60);
      } catch (const std::runtime_error& error) { // a jam, of which it says that it gives up
        ASSERT_TRUE(table == Piles || table == Batted) << error.what();
        ++jams;
        break;
      }
      for (const CExactEvent<double>& event : events) {
        ASSERT_FALSE(event.m_bOverlapped);
        ++own;
        pairs += event.m_bIsBall;
        if (!event.m_bIsBall)
          momentum += reference.GetBall(event.m_nBall).m_fMass * (event.m_vVelAfter - event.m_vVelBefore);
      }
      for (std::size_t i = 0; i < balls.size(); ++i) {
        const CExactBall<double>& ball = reference.GetBall(i);
        const double inside = -2 * g_fRest * ball.GetExtent();
        ASSERT_LT(ball.m_vPos.cwiseAbs().maxCoeff(), 4);
        ASSERT_GT(GetGap(reference, i), inside) << "ball " << i;
      }
      const double now = energy();
      gains += table == Lively && now > before * (1 + 1e-12);
      if (table != Lively && table != Batted) {
        ASSERT_LE(now, before * (1 + 1e-12));
      }
      before = now;
    }
    const double bound = 8 * g_fEps * static_cast<double>(own);
    if (table == Elastic) {
      EXPECT_NEAR(before / first, 1, bound);
      EXPECT_LE((Momentum(reference) - momentum).norm(), bound * size);
      EXPECT_EQ(reference.GetSlideCount(), 0u);
    }
    if (table == Dull) {
      EXPECT_LT(before / first, 1 - bound);
    }
    bounces += own;
    slides += reference.GetSlideCount();
    rests += reference.GetRestCount();
  }
  EXPECT_GT(bounces, 10000u);
  EXPECT_GT(pairs, 1000u);
  EXPECT_GT(slides, 500u);
  EXPECT_GT(rests, 200u);
  EXPECT_GT(gains, 10u);
  EXPECT_LE(jams, 2u);
}

TEST(ReferenceRest, RefusesWhatTheLibraryRefuses) {
  const float nan = std::nanf("");
  EXPECT_THROW(Make({CPointDesc({nan, 0})}, {}), std::invalid_argument);
  EXPECT_THROW(Make({CCircleDesc({0, 0}, -1)}, {}), std::invalid_argument);
  EXPECT_THROW(Make({CDynamicCircleDesc({0, 0}, 1)}, {}), std::invalid_argument);
  EXPECT_THROW(Make({}, {CDynamicCircleDesc({0, 0}, 1, {0, 0}, 0)}), std::invalid_argument);
  EXPECT_THROW(Make({}, {}, {nan, 0}), std::invalid_argument);
  CExact reference = Make({CPointDesc({0, 0})}, {CDynamicCircleDesc({3, 0}, 1)});
  CEvents events;
  EXPECT_THROW(reference.Step(-1, events), std::invalid_argument);
  EXPECT_THROW(reference.SetRotSpeed(0, 1), std::invalid_argument); // it is static
  EXPECT_THROW(reference.SetBall(1, {0, 0}, {0, 0}), std::out_of_range);
}

} // namespace
} // namespace Shapes::Compare::Tests
