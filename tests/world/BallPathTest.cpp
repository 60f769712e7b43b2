// SPDX-License-Identifier: MIT
// The way of a ball against brute force: many places of it, each asked for its distance.
#include "world/BallPath.h"

#include "../Testing.h"

#include "Tolerances.h"

#include <cfenv>

namespace Shapes {
namespace {

double DistanceByShape(const CShape& shape, const Vector2d& p) {
  return Wide(SensedDistanceFrom(shape, p.cast<float>()));
}

std::vector<CPathVertex> RandomWay(CRandom& random, int bends) {
  std::vector<CPathVertex> way{{0.0, Wide(random.InSquare(3))}};
  for (int i = 1; i <= bends; ++i)
    way.push_back({static_cast<double>(i) / (bends + 1), Wide(random.InSquare(3))});
  way.push_back({1.0, Wide(random.InSquare(3))});
  return way;
}

TEST(BallPathTest, TheClosestApproachIsThatOfManyPlaces) {
  constexpr int places = 400;
  constexpr double rounding = 1e-5; // of DistanceByShape: 8 ulp of 10
  int crossed = 0;
  ForEachCase(11, 4000, [&](CRandom& random, int trial) {
    const auto pShape = MakeAnyShape(random, static_cast<std::uint32_t>(trial), random.InSquare(2), 2);
    const auto way = RandomWay(random, trial % 3);
    const CZone::CApproach near = CZone(*pShape).Approach(way);
    const double parts = static_cast<double>(way.size() - 1);
    double least = 1e9, spacing = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
      spacing = std::max(spacing, (way[i + 1].m_vPos - way[i].m_vPos).norm() * parts / places);
    for (int k = 0; k <= places; ++k)
      least = std::min(least, DistanceByShape(*pShape, GetPos(way, static_cast<double>(k) / places)));
    ASSERT_LE(near.m_fDistance, least + rounding);
    ASSERT_GE(near.m_fDistance, least - spacing / 2 - rounding);
    // And it is where it says.
    ASSERT_NEAR(DistanceByShape(*pShape, near.m_vPos), near.m_fDistance, rounding);
    ASSERT_NEAR((GetPos(way, near.m_fTime) - near.m_vPos).norm(), 0, 1e-12);
    crossed += near.m_fDistance == 0.0;
  });
  EXPECT_GT(crossed, 400);
}

TEST(BallPathTest, ATouchHasItsPointOnTheShapeAndItsNormalToTheBall) {
  int touched = 0, atEnd = 0;
  ForEachCase(12, 4000, [&](CRandom& random, int trial) {
    const auto pShape = MakeAnyShape(random, static_cast<std::uint32_t>(trial), random.InSquare(2), 2);
    const auto way = RandomWay(random, trial % 2);
    const double r = random.Uniform(0.05f, 0.5f);
    const CZone zone(*pShape);
    const auto touch = zone.Touch(way, r);
    ASSERT_EQ(touch.has_value(), zone.Approach(way).m_fDistance < r);
    if (!touch) return;
    ++touched;
    atEnd += touch->m_bAtEnd;
    const Vector2d p = GetPos(way, touch->m_fTime);
    ASSERT_EQ(touch->m_bAtEnd, touch->m_fTime == 1.0);
    ASSERT_NEAR(touch->m_vNorm.norm(), 1, 1e-12);
    const bool isDisk = pShape->GetShapeType() == eShape::Circle;
    const double d = isDisk ? (p - touch->m_vPOI).dot(touch->m_vNorm) : (p - touch->m_vPOI).norm();
    ASSERT_LT(d, r + 1e-12);
    ASSERT_NEAR((touch->m_vPOI + d * touch->m_vNorm - p).norm(), 0, 1e-6); // ends are rounded off the circle
    ASSERT_NEAR(isDisk ? 0 : DistanceByShape(*pShape, touch->m_vPOI), 0, 1e-5);
  });
  EXPECT_GT(touched, 1000);
  EXPECT_GT(atEnd, 100);
}

TEST(BallPathTest, WhereTheCentreIsOnTheShapeTheNormalIsAgainstTheWay) {
  const CLineSeg seg(CLineSegDesc({-1, 0}, {1, 0}));
  const CArc arc(CArcDesc({0, -5}, 5, 0, g_fPi));
  const CPoint point(CPointDesc(Vector2(0, 0)));
  const CCircle dot(CCircleDesc({0, 0}, 0));
  for (const CShape* pShape : {static_cast<const CShape*>(&seg), static_cast<const CShape*>(&arc),
                               static_cast<const CShape*>(&point), static_cast<const CShape*>(&dot)})
    for (const double y : {3.0, -3.0}) {
      const CPathVertex through[] = {{0.0, {0, y}}, {1.0, {0, -y}}};
      const auto touch = CZone(*pShape).Touch(through, 0.1);
      ASSERT_TRUE(touch);
      EXPECT_NEAR(touch->m_vNorm.y(), y / 3.0, 1e-12);
      EXPECT_NEAR(touch->m_fTime, 0.5, 1e-12);
      EXPECT_FALSE(touch->m_bAtEnd);
      const CPathVertex until[] = {{0.0, {0, y}}, {1.0, {0, 0}}};
      const auto last = CZone(*pShape).Touch(until, 0.1);
      ASSERT_TRUE(last);
      EXPECT_NEAR(last->m_vNorm.y(), y / 3.0, 1e-12);
      EXPECT_TRUE(last->m_bAtEnd);
    }
  // At rest: up, or the front, which of this segment is up too.
  const CPathVertex rests[] = {{0.0, {0, 0}}, {1.0, {0, 0}}};
  for (const CShape* pShape : {static_cast<const CShape*>(&seg), static_cast<const CShape*>(&point)})
    EXPECT_EQ(CZone(*pShape).Touch(rests, 0.1)->m_vNorm.y(), 1);
}

TEST(BallPathTest, TouchingExactlyIsNone) {
  const CZone zone(CLineSeg(CLineSegDesc({-1, 0}, {1, 0})));
  const CPathVertex along[] = {{0.0, {-3, 0.25}}, {1.0, {3, 0.25}}};
  EXPECT_FALSE(zone.Touch(along, 0.25));
  EXPECT_TRUE(zone.Touch(along, 0.25 + 1e-15));
}

TEST(BallPathTest, ATurnedWayErrsByAHundredthOfTheRadius) {
  double worst = 0, worstOfOne = 0;
  ForEachCase(13, 500, [&](CRandom& random, int trial) {
    const auto way = RandomWay(random, trial % 3);
    const Vector2d center = Wide(random.InSquare(2));
    const double turn = random.Uniform(-3, 3), r = random.Uniform(0.05f, 0.5f);
    std::vector<CPathVertex> turned;
    MakeRotatedPath(way, center, turn, {0, 0}, r, turned);
    for (int k = 0; k <= 1000; ++k) {
      const double t = k / 1000.0;
      const Vector2d exact = Turn(GetPos(way, t), center, (1.0 - t) * turn);
      worst = std::max(worst, (GetPos(turned, t) - exact).norm() / r);
      const CPathVertex chord[] = {turned.front(), turned.back()};
      worstOfOne = std::max(worstOfOne, (GetPos(chord, t) - exact).norm() / r);
    }
    ASSERT_EQ(turned.back().m_vPos, way.back().m_vPos); // the frame is that of the end
  });
  EXPECT_LE(worst, static_cast<double>(g_fRotatedPathError) * (1 + 1e-6));
  EXPECT_GT(worst, 0.5 * static_cast<double>(g_fRotatedPathError)); // not finer than it needs to be
  EXPECT_GT(worstOfOne, 1);                                         // the control
}

TEST(BallPathTest, AWildTurnEnds) { // 10^9 turns a second for a second, and a ball without extent
  const CPathVertex way[] = {{0.0, {1, 0}}, {1.0, {2, 0}}};
  std::vector<CPathVertex> turned;
  MakeRotatedPath(way, {0, 0}, 6e9, {0, 0}, 0.1, turned);
  EXPECT_EQ(turned.size(), 1u + g_nMaxTurnParts);
  std::feclearexcept(FE_ALL_EXCEPT);
  MakeRotatedPath(way, {0, 0}, 1, {0, 0}, 0, turned);
  EXPECT_EQ(turned.size(), 1u + g_nMaxTurnParts);
  MakeRotatedPath(way, {0, 0}, 0, {0, 0}, 0, turned); // which does not bend
  EXPECT_EQ(turned.size(), 2u);
  EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO | FE_INVALID), 0);
}

TEST(BallPathTest, ARelativeWayIsTheDifferenceAtAnyTime) {
  ForEachCase(14, 200, [&](CRandom& random, int trial) {
    const auto a = RandomWay(random, trial % 4), b = RandomWay(random, trial / 4 % 4);
    std::vector<CPathVertex> relative;
    MakeRelativePath(a, b, relative);
    for (int k = 0; k <= 100; ++k) {
      const double t = k / 100.0;
      ASSERT_NEAR((GetPos(relative, t) - (GetPos(a, t) - GetPos(b, t))).norm(), 0, 1e-12) << t;
    }
  });
}

TEST(BallPathTest, TheVelocityIsThatBeforeABend) {
  const CPathVertex way[] = {{0.0, {0, 0}}, {0.25, {1, 0}}, {0.25, {1, 0}}, {1.0, {1, 3}}};
  EXPECT_EQ(GetVelocity(way, 0.0), Vector2d(4, 0));
  EXPECT_EQ(GetVelocity(way, 0.25), Vector2d(4, 0));
  EXPECT_EQ(GetVelocity(way, 0.26), Vector2d(0, 4));
  EXPECT_EQ(GetVelocity(way, 1.0), Vector2d(0, 4));
}

} // namespace
} // namespace Shapes
