// SPDX-License-Identifier: MIT
// The fixtures of a shape on Box2D: chords within the tolerance, vertices that Box2D accepts, the solid side
// where it belongs.
#include "box2d_backend/world/FixtureShapes.h"

#include "Box2DTesting.h"

#include <cfenv>

namespace Shapes::Box2D {
namespace {

constexpr float g_fSkin = 0.00625f;

CFixtureShapes Make(const CShape& shape, float sagitta = g_fSagittaTolerance,
                    std::optional<float> skin = {}) {
  return CFixtureShapes::Make(shape, shape.GetPos(), CScale(1.0f), sagitta, skin);
}
CFixtureShapes MakeWithSkin(const CShape& shape, float sagitta = g_fSagittaTolerance) {
  return Make(shape, sagitta, g_fSkin);
}

CArc MakeArc(float R, float a0, float a1, eSides sides = eSides::Both, const Vector2& p = {0, 0}) {
  return CArc(Sided(CArcDesc(p, R, a0, a1), sides));
}

double Norm(const b2Vec2& v) { return std::hypot(static_cast<double>(v.x), static_cast<double>(v.y)); }

// Whether Box2D lets a ball of radius .1 at p touch an edge.
bool Touches(const b2EdgeShape& edge, const Vector2& p) {
  b2CircleShape ball;
  ball.m_radius = 0.1f;
  b2Manifold manifold;
  const b2Transform still(b2Vec2_zero, b2Rot(0)), there({p.x(), p.y()}, b2Rot(0));
  b2CollideEdgeAndCircle(&manifold, &edge, still, &ball, there);
  return manifold.pointCount > 0;
}

bool Touches(const CFixtureShapes& fixtures, const Vector2& p) {
  std::vector<b2EdgeShape> edges = fixtures.m_stdEdges;
  for (const CFixtureShapes::CChain& vertices : fixtures.m_stdChains) {
    b2ChainShape chain;
    CreateChain(vertices, chain);
    for (int32 i = 0; i < chain.GetChildCount(); ++i)
      chain.GetChildEdge(&edges.emplace_back(), i);
  }
  return std::ranges::any_of(edges, [&](const b2EdgeShape& edge) { return Touches(edge, p); });
}

/// An arc of random size, place in the world, span and number of chords.
struct CRandomArc {
  static CArc Make(CRandom& random, const Vector2& p, float R) {
    const float a0 = random.Uniform(0, 6.28f), a1 = random.Coin() ? random.Uniform(0, 6.28f) : a0;
    return MakeArc(R, a0, a1, eSides::Both, p);
  }

  CRandom& m_cRandom;
  Vector2 m_vPos = m_cRandom.InSquare(100);
  float m_fRadius = m_cRandom.Scale(-7, 9);
  float m_fSagitta = m_cRandom.Scale(-10, -5);
  CArc m_cArc = Make(m_cRandom, m_vPos, m_fRadius);
};

TEST(PiecesTest, AHalfCircleOfOneMetreHasSixteenChords) {
  EXPECT_EQ(CountArcPieces(1.0f, g_fPi, false, g_fSagittaTolerance), 16);
  EXPECT_EQ(Make(MakeArc(1, 0, g_fPi)).m_nArcPieces, 16);
  EXPECT_EQ(Make(MakeArc(1, 0, 0)).m_nArcPieces, 32);
  // A hundred times the tolerance needs a tenth of the chords, but no chord spans more than a quarter turn.
  EXPECT_EQ(CountArcPieces(1.0f, g_fPi, false, 100 * g_fSagittaTolerance), 2);
  EXPECT_EQ(CountArcPieces(1.0f, g_fTwoPi, true, 10.0f), 4);
  EXPECT_EQ(CountArcPieces(1e8f, g_fTwoPi, true, 1e-6f), g_nMaxArcPieces);
}

TEST(PiecesTest, NoRadiusAndATinyToleranceAreCountedWithoutADivisionBy0) {
  std::feclearexcept(FE_ALL_EXCEPT);
  EXPECT_EQ(CountArcPieces(0.0f, g_fTwoPi, true, g_fSagittaTolerance), 0);
  EXPECT_EQ(CountArcPieces(1e8f, g_fTwoPi, true, 1e-38f), g_nMaxArcPieces);
  EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO | FE_INVALID), 0);
}

TEST(PiecesTest, TheSagittaIsWithinTheToleranceAndNoFewerChordsWouldDo) {
  int byTolerance = 0;
  ForEachCase(11, 20000, [&](CRandom& random, int) {
    const CRandomArc made{random};
    const double R = made.m_fRadius, span = made.m_cArc.GetSpan();
    const int n =
        CountArcPieces(made.m_fRadius, made.m_cArc.GetSpan(), made.m_cArc.IsFullCircle(), made.m_fSagitta);
    if (n == 0) return;
    SCOPED_TRACE(testing::Message() << "R = " << R << ", span = " << span);
    const auto sagitta = [&](int fixtures) { return R * (1 - std::cos(span / fixtures / 2)); };
    const bool chordsAreShort = R * span / n < 2.3 * Wide(g_fShortestEdge);
    EXPECT_TRUE(chordsAreShort || n >= g_nMaxArcPieces || sagitta(n) <= made.m_fSagitta * (1 + 1e-5)) << n;
    if (n == 1 || span / (n - 1) > 0.5 * Wide(g_fPi)) return;
    EXPECT_GT(sagitta(n - 1), made.m_fSagitta * (1 - 1e-5));
    ++byTolerance;
  });
  EXPECT_GT(byTolerance, 10000);
}

TEST(PiecesTest, VerticesAreOnTheCircleAndFarEnoughApart) {
  int chains = 0;
  ForEachCase(12, 5000, [&](CRandom& random, int) {
    const CRandomArc made{random};
    const CFixtureShapes fixtures = Make(made.m_cArc, made.m_fSagitta);
    const double R = made.m_fRadius;
    // A component of AngleToVector is within 1 ulp, and products and sums round; the last vertex is the end
    // of the arc, which was rounded at the arc's place in the world.
    const double onCircle = 4 * g_fUlp * R, atPlace = 4 * g_fUlp * (R + 100);
    for (const CFixtureShapes::CChain& chain : fixtures.m_stdChains) {
      ++chains;
      const auto& v = chain.m_stdVertices;
      ASSERT_EQ(v.size(), static_cast<std::size_t>(fixtures.m_nArcPieces) + (chain.m_bClosed ? 0 : 1));
      for (std::size_t i = 0; i < v.size(); ++i) {
        const bool atEnd = !chain.m_bClosed && (i == 0 || i + 1 == v.size());
        EXPECT_NEAR(Norm(v[i]), R, atEnd ? atPlace : onCircle);
        if (i == 0 && !chain.m_bClosed) continue;
        const b2Vec2& previous = i == 0 ? v.back() : v[i - 1];
        EXPECT_GE(Norm(v[i] - previous), g_fShortestEdge - (atEnd ? 2 * atPlace : onCircle));
      }
    }
  });
  EXPECT_GT(chains, 6000);
}

TEST(PiecesTest, VerticesFarFromTheOriginAreNotTooCloseForBox2D) {
  // About a rotation centre that is far away coordinates have large steps, and neighbours round to the same
  // ones. Box2D would stop the program.
  ForEachCase(15, 2000, [&](CRandom& random, int) {
    const CArc arc = CRandomArc::Make(random, {0, 0}, random.Scale(-7, 2));
    const Vector2 origin = random.Vector(10, 25);
    const CFixtureShapes fixtures = CFixtureShapes::Make(arc, origin, CScale(1), g_fSagittaTolerance);
    for (const CFixtureShapes::CChain& chain : fixtures.m_stdChains) {
      const auto& v = chain.m_stdVertices;
      ASSERT_GE(v.size(), chain.m_bClosed ? 3u : 2u);
      for (std::size_t i = chain.m_bClosed ? 0 : 1; i < v.size(); ++i)
        ASSERT_GT(Norm(v[i] - (i == 0 ? v.back() : v[i - 1])), b2_linearSlop);
    }
  });
}

TEST(PiecesTest, TheEndsOfChainsAndOfEdgesAreTheEndsOfTheArc) {
  for (const float span : {0.7f, 3.0f, 6.0f}) {
    const CArc arc = MakeArc(2, 1, 1 + span);
    const Vector2 p0 = arc.GetEndPt0(), p1 = arc.GetEndPt1();
    const auto expectEnds = [&](const b2Vec2& first, const b2Vec2& last) {
      EXPECT_LE(Norm(first - b2Vec2(p0.x(), p0.y())), 4 * 2 * g_fUlp);
      EXPECT_LE(Norm(last - b2Vec2(p1.x(), p1.y())), 4 * 2 * g_fUlp);
    };
    const CFixtureShapes fixtures = Make(arc);
    ASSERT_EQ(fixtures.m_stdChains.size(), 2u);
    const auto& outside = fixtures.m_stdChains[0];
    EXPECT_FALSE(outside.m_bClosed);
    expectEnds(outside.m_stdVertices.front(), outside.m_stdVertices.back());
    const auto edges = MakeWithSkin(arc).m_stdEdges;
    expectEnds(edges.front().m_vertex1, edges.back().m_vertex2);
    for (std::size_t i = 1; i < edges.size(); ++i)
      EXPECT_EQ(edges[i].m_vertex1, edges[i - 1].m_vertex2) << i;
  }
}

TEST(PiecesTest, AFullCircleIsALoopOrItsEdgesClose) {
  const CFixtureShapes fixtures = Make(MakeArc(2, 1, 1));
  ASSERT_EQ(fixtures.m_stdChains.size(), 2u);
  for (const CFixtureShapes::CChain& vertices : fixtures.m_stdChains) {
    EXPECT_TRUE(vertices.m_bClosed);
    b2ChainShape chain;
    CreateChain(vertices, chain);
    EXPECT_EQ(chain.GetChildCount(), fixtures.m_nArcPieces); // as many edges as vertices: it is closed
  }
  b2ChainShape open;
  const CFixtureShapes part = Make(MakeArc(2, 1, 4)); // the control
  CreateChain(part.m_stdChains[0], open);
  EXPECT_EQ(open.GetChildCount(), part.m_nArcPieces);
  EXPECT_EQ(open.m_count, open.GetChildCount() + 1);
  const CFixtureShapes withSkin = MakeWithSkin(MakeArc(2, 1, 1));
  ASSERT_EQ(withSkin.m_stdEdges.size(), static_cast<std::size_t>(withSkin.m_nArcPieces));
  EXPECT_EQ(withSkin.m_stdEdges.front().m_vertex1, withSkin.m_stdEdges.back().m_vertex2);
  for (const b2EdgeShape& edge : withSkin.m_stdEdges) // every vertex is as far out, the first as well
    EXPECT_NEAR(Norm(edge.m_vertex1), Norm(withSkin.m_stdEdges[1].m_vertex1), 8 * 2 * g_fUlp);
}

TEST(PiecesTest, SidesOfASegmentAreSolidAsAskedInEveryDirection) {
  ForEachCase(14, 1000, [&](CRandom& random, int) {
    const Vector2 p = random.InSquare(5), q = random.InSquare(5);
    CLineSegDesc desc(p, q);
    if ((desc.GetEndPt1() - desc.GetEndPt0()).norm() < 0.5f) return;
    for (const eSides sides : {eSides::Both, eSides::Front, eSides::Back}) {
      desc.m_eSides = sides;
      const CLineSeg seg(desc);
      const CFixtureShapes fixtures = Make(seg);
      ASSERT_EQ(fixtures.m_stdEdges.size(), 1u);
      EXPECT_EQ(fixtures.m_stdEdges[0].m_oneSided, sides != eSides::Both);
      const Vector2 n = 0.05f * seg.GetNormal();
      EXPECT_EQ(Touches(fixtures, n), sides != eSides::Back);
      EXPECT_EQ(Touches(fixtures, -n), sides != eSides::Front);
      // The ends are round on the solid side: a ball beyond the end still meets it.
      const Vector2 end = seg.GetEndPt1() - seg.GetPos();
      EXPECT_EQ(Touches(fixtures, end + 0.05f * end.normalized() + n), sides != eSides::Back);
    }
  });
}

TEST(PiecesTest, WhatIsTooSmallForBox2DBecomesAPointOrACircle) {
  const auto expectCircle = [](const CShape& shape, float r, const Vector2& p) {
    for (const std::optional<float> skin : {std::optional<float>(), std::optional(g_fSkin)}) {
      const auto fixtures = CFixtureShapes::Make(shape, {0, 0}, CScale(1), g_fSagittaTolerance, skin);
      ASSERT_EQ(fixtures.m_stdCircles.size(), 1u);
      EXPECT_TRUE(fixtures.m_stdEdges.empty() && fixtures.m_stdChains.empty());
      EXPECT_EQ(fixtures.m_nArcPieces, 0);
      EXPECT_EQ(fixtures.m_stdCircles[0].m_radius, r + skin.value_or(0));
      EXPECT_NEAR(fixtures.m_stdCircles[0].m_p.x, p.x(), 1e-6f);
      EXPECT_NEAR(fixtures.m_stdCircles[0].m_p.y, p.y(), 1e-6f);
    }
  };
  expectCircle(CPoint(CPointDesc(Vector2(3, 4))), 0, {3, 4});
  expectCircle(CCircle(CCircleDesc({3, 4}, 2)), 2, {3, 4});
  expectCircle(CLineSeg(CLineSegDesc({3, 4}, {3.009f, 4})), 0, {3.0045f, 4});
  expectCircle(CLineSeg(CLineSegDesc({3, 4}, {3, 4})), 0, {3, 4});
  expectCircle(MakeArc(0.005f, 0, 1, eSides::Both, {3, 4}), 0,
               {3 + 0.005f * std::cos(0.5f), 4 + 0.005f * std::sin(0.5f)});
  expectCircle(MakeArc(0, 0, 1, eSides::Both, {3, 4}), 0, {3, 4});
  expectCircle(MakeArc(0.005f, 0, 0, eSides::Both, {3, 4}), 0.005f, {3, 4});
  // The control: a little longer, and they are what they are.
  const CLineSeg seg(CLineSegDesc({3, 4}, {3.011f, 4}));
  ASSERT_EQ(Make(seg).m_stdEdges.size(), 1u);
  EXPECT_EQ(Make(seg).m_stdEdges[0].m_radius, b2_polygonRadius); // as Box2D has it
  EXPECT_EQ(MakeWithSkin(seg).m_stdEdges[0].m_radius, g_fSkin);
  EXPECT_EQ(Make(MakeArc(0.013f, 0, 1)).m_stdChains.size(), 2u);
  EXPECT_EQ(Make(MakeArc(0.006f, 0, 0)).m_stdChains.size(), 2u);
}

double Distance(const b2EdgeShape& edge, const b2Vec2& p) {
  const b2Vec2 way = edge.m_vertex2 - edge.m_vertex1;
  const float along = std::clamp(b2Dot(p - edge.m_vertex1, way) / b2Dot(way, way), 0.0f, 1.0f);
  return Norm(p - edge.m_vertex1 - along * way);
}

TEST(PiecesTest, TheSkinsOfAnArcReachBeyondItAsAskedAndNotMuchFarther) {
  int arcs = 0, fewChords = 0;
  double farthest = 0;
  ForEachCase(16, 1000, [&](CRandom& random, int) {
    const CRandomArc made{random};
    const CArc& arc = made.m_cArc;
    const CFixtureShapes fixtures = MakeWithSkin(arc, made.m_fSagitta);
    const int n = fixtures.m_nArcPieces;
    if (n == 0 || n > 200) return;
    ++arcs, fewChords += n <= 3;
    ASSERT_EQ(fixtures.m_stdEdges.size(), static_cast<std::size_t>(n));
    EXPECT_TRUE(fixtures.m_stdChains.empty() && fixtures.m_stdCircles.empty());
    const double R = made.m_fRadius, span = arc.GetSpan();
    const double sagitta = R * (1 - std::cos(span / n / 2)), rounding = 8 * g_fUlp * (R + 100);
    for (int i = 0; i <= 8 * n; ++i) {
      const float angle = arc.GetAngle0() + arc.GetSpan() * static_cast<float>(i) / static_cast<float>(8 * n);
      const Vector2 u = made.m_fRadius * AngleToVector(angle);
      double most = -1;
      for (const b2EdgeShape& edge : fixtures.m_stdEdges)
        most = std::max(most, static_cast<double>(edge.m_radius) - Distance(edge, {u.x(), u.y()}));
      EXPECT_GE(most, static_cast<double>(g_fSkin) - rounding) << i << " of " << 8 * n;
    }
    for (const b2EdgeShape& edge : fixtures.m_stdEdges)
      for (int i = 0; i <= 8; ++i) {
        const b2Vec2 p = edge.m_vertex1 + static_cast<float>(i) / 8 * (edge.m_vertex2 - edge.m_vertex1);
        const Vector2 at = made.m_vPos + Vector2(p.x, p.y);
        const double out = static_cast<double>((at - arc.ClosestPt(at)).norm() + edge.m_radius - g_fSkin);
        EXPECT_LE(out, 2 * sagitta + rounding);
        if (sagitta > 100 * rounding) farthest = std::max(farthest, out / sagitta);
      }
  });
  EXPECT_GT(arcs, 500);
  EXPECT_GT(fewChords, 50);
  EXPECT_GT(farthest, 1.4); // the bound is not idle
}

TEST(PiecesTest, ChordsOnTheCircleWouldNeedAllOfTheSagitta) { // the control of chords that are half outside
  const CArc arc = MakeArc(1, 0, g_fPi);
  const CFixtureShapes fixtures = MakeWithSkin(arc), inside = Make(arc);
  const double sagitta = 1 - std::cos(static_cast<double>(g_fPi) / 32);
  const b2EdgeShape& edge = fixtures.m_stdEdges[8];
  const b2Vec2 middle = 0.5f * (edge.m_vertex1 + edge.m_vertex2);
  EXPECT_NEAR(1 - Norm(middle), 0.5 * sagitta, 0.01 * sagitta);
  EXPECT_NEAR(Norm(edge.m_vertex1) - 1, 0.5 * sagitta, 0.01 * sagitta);
  const auto& v = inside.m_stdChains[0].m_stdVertices;
  EXPECT_NEAR(1 - Norm(0.5f * (v[8] + v[9])), sagitta, 0.01 * sagitta);
}

TEST(PiecesTest, SidesOfAnArcAreSolidAsAskedWithASkinAndWithout) {
  for (const auto& [a0, a1] : {std::pair(0.0f, g_fPi), std::pair(0.0f, 0.0f), std::pair(1.0f, 6.5f)})
    for (int i = 0; i < 24; ++i) {
      const float angle = 1.1f + 1.9f * static_cast<float>(i) / 24;
      const Vector2 outside = 1.05f * AngleToVector(angle), inside = 0.95f * AngleToVector(angle);
      for (const eSides sides : {eSides::Both, eSides::Front, eSides::Back}) {
        const CArc arc = MakeArc(1, a0, a1, sides);
        EXPECT_EQ(Make(arc).m_stdChains.size(), sides == eSides::Both ? 2u : 1u);
        for (const CFixtureShapes& fixtures : {Make(arc), MakeWithSkin(arc)}) {
          EXPECT_EQ(Touches(fixtures, outside), sides != eSides::Back) << angle;
          EXPECT_EQ(Touches(fixtures, inside), sides != eSides::Front) << angle;
        }
      }
    }
}

} // namespace
} // namespace Shapes::Box2D
