// SPDX-License-Identifier: MIT
// Arcs: angles, ends, closest point, box, rotation, and which points are in their sector.
#include <Shapes/Arc.h>

#include "../Testing.h"

namespace Shapes {
namespace {

CArc Arc(const Vector2& p, float r, float a0, float a1) { return CArc(CArcDesc(p, r, a0, a1)); }
float Degrees(float a) { return a * g_fPi / 180.0f; }
Vector2d OnCircle(const CArc& arc, double a) {
  return Wide(arc.GetPos()) + static_cast<double>(arc.GetRadius()) * Vector2d(std::cos(a), std::sin(a));
}
// Spans of every kind: any, tiny, close to pi, close to 2 pi, full.
CArcDesc RandomArc(CRandom& random, int centreExp) {
  const Vector2 p = random.Vector(-6, centreExp);
  const float r = random.Scale(-6, 8), a0 = random.Uniform(0.0f, 6.28f);
  float span = random.Uniform(0.01f, 6.27f);
  switch (random.Below(5)) {
  case 0: span = random.Scale(-12, -4); break;
  case 1: span = g_fPi + random.SignedScale(-21, -4); break;
  case 2: span = g_fTwoPi - random.Scale(-12, -4); break;
  case 3: span = 0.0f; break;
  default: break;
  }
  return CArcDesc(p, r, a0, a0 + span);
}

TEST(Arc, IsWhatItsDescriptorSays) {
  CArcDesc desc({1.0f, 2.0f}, 3.0f, 0.5f, 1.5f);
  desc.m_eSides = eSides::Front;
  const CArc arc(desc);
  EXPECT_EQ(arc.GetRadius(), 3.0f);
  EXPECT_EQ(arc.GetAngle0(), 0.5f);
  EXPECT_NEAR(arc.GetAngle1(), 1.5f, 2 * g_fUlp);
  EXPECT_EQ(arc.GetSpan(), 1.0f);
  EXPECT_EQ(arc.GetSides(), eSides::Front);
  EXPECT_FALSE(arc.IsFullCircle());
  Vector2 p0, p1, d0, d1;
  arc.GetEndPts(p0, p1);
  desc.GetEndPts(d0, d1);
  EXPECT_TRUE(p0 == d0 && p1 == d1 && p0 == arc.GetEndPt0() && p1 == arc.GetEndPt1());
}

TEST(Arc, AnglesAreReducedAndStayBelowTwoPi) {
  CArcDesc desc({0.0f, 0.0f}, 1.0f, -1e-9f, 7.0f);
  EXPECT_EQ(desc.GetAngle0(), 0.0f);
  EXPECT_NEAR(desc.GetAngle1(), 7.0 - g_fPi2, g_fUlp);
  ForEachCase(81, 10000, [&](CRandom& random, int) {
    const float a0 = random.Uniform(-100.0f, 100.0f), a1 = random.Uniform(-100.0f, 100.0f);
    desc.SetAngles(a0, a1);
    for (const float a : {desc.GetAngle0(), desc.GetAngle1()}) {
      EXPECT_GE(a, 0.0f);
      EXPECT_LT(static_cast<double>(a), g_fPi2);
    }
  });
}

TEST(Arc, EqualAnglesAreTheFullCircle) {
  for (const float a : {0.0f, 1.0f, 3.0f, 6.0f}) {
    const CArc arc = Arc({0.0f, 0.0f}, 1.0f, a, a);
    EXPECT_TRUE(arc.IsFullCircle());
    EXPECT_NEAR(arc.GetSpan(), g_fPi2, 4 * g_fUlp);
    EXPECT_EQ(arc.GetAngle1(), arc.GetAngle0());
    for (int k = 0; k < 360; ++k)
      EXPECT_TRUE(arc.PtInSector(AngleToVector(Degrees(static_cast<float>(k)))));
    EXPECT_EQ(arc.GetAABB().GetTopLeft(), Vector2(-1.0f, 1.0f));
    EXPECT_EQ(arc.GetAABB().GetBottomRt(), Vector2(1.0f, -1.0f));
  }
}

TEST(Arc, AnglesAWholeTurnApartAreTheFullCircle) {
  // Reduced one by one they would leave an arc of 1.7e-7: the float next to 2 pi is above it by that.
  EXPECT_GT(NormalizeAngle(g_fTwoPi), 1e-7f);
  for (const auto& [a0, a1] : {std::pair(0.0f, g_fTwoPi), std::pair(g_fTwoPi, 0.0f), std::pair(-g_fPi, g_fPi),
                               std::pair(1.0f, 1.0f + g_fTwoPi), std::pair(0.0f, -g_fTwoPi)})
    EXPECT_TRUE(Arc({0.0f, 0.0f}, 1.0f, a0, a1).IsFullCircle()) << a0 << " to " << a1;
  // A slit that is above the rounding of its angles stays one.
  EXPECT_FALSE(Arc({0.0f, 0.0f}, 1.0f, 1e-5f, g_fTwoPi - 1e-5f).IsFullCircle());
  EXPECT_FALSE(Arc({0.0f, 0.0f}, 1.0f, 0.0f, g_fTwoPi - 1e-5f).IsFullCircle());
}

TEST(Arc, ClosestPtOfTheCentreIsItsFirstEnd) {
  const CArc arc = Arc({0.0f, 0.0f}, 2.0f, Degrees(45), Degrees(135));
  EXPECT_EQ(arc.ClosestPt({0.0f, 0.0f}), arc.GetEndPt0());
}

TEST(Arc, SetPosTakesTheEndsAlong) {
  CArc arc = Arc({0.0f, 0.0f}, 2.0f, 0.0f, Degrees(90));
  arc.SetPos({8.0f, 16.0f});
  EXPECT_EQ(arc.GetEndPt0(), Vector2(10.0f, 16.0f));
  EXPECT_LE((arc.GetEndPt1() - Vector2(8.0f, 18.0f)).norm(), 4 * g_fUlp * 20);
  EXPECT_EQ(arc.GetAABB().GetBottomRt().x(), 10.0f);
  EXPECT_TRUE(arc.PtInSector({9.0f, 17.0f}));
  EXPECT_FALSE(arc.PtInSector({7.0f, 15.0f}));
}

TEST(KinematicArc, TurnsFromItsPoseAtConstruction) {
  CKinematicArc arc(CArcDesc({2.0f, 0.0f}, 1.0f, 0.0f, Degrees(90)));
  for (int i = 0; i < 3; ++i) {
    arc.Rotate({0.0f, 0.0f}, g_fPi / 2);
    EXPECT_LE((arc.GetPos() - Vector2(0.0f, 2.0f)).norm(), 12 * g_fUlp);
    EXPECT_LE((arc.GetEndPt0() - Vector2(0.0f, 3.0f)).norm(), 16 * g_fUlp);
    EXPECT_LE((arc.GetEndPt1() - Vector2(-1.0f, 2.0f)).norm(), 16 * g_fUlp);
    EXPECT_NEAR(arc.GetAngle0(), g_fPi / 2, 2 * g_fUlp);
    EXPECT_NEAR(arc.GetAngle1(), g_fPi, 4 * g_fUlp);
    Vector2 t0, t1;
    arc.GetTangents(t0, t1);
    EXPECT_LE((t0 - Vector2(-1.0f, 0.0f)).norm(), 16 * g_fUlp);
    EXPECT_LE((t1 - Vector2(0.0f, 1.0f)).norm(), 16 * g_fUlp);
    EXPECT_NEAR(arc.GetAABB().GetTopLeft().y(), 3.0f, 16 * g_fUlp);
    EXPECT_NEAR(arc.GetAABB().GetTopLeft().x(), -1.0f, 16 * g_fUlp);
  }
}

TEST(KinematicArc, KeepsItsSpanAndItsSectorAtEveryAngle) {
  ForEachCase(86, 2000, [&](CRandom& random, int) {
    const CArcDesc desc = RandomArc(random, 4);
    CKinematicArc arc(desc);
    const float span = arc.GetSpan();
    const Vector2 centre = random.InSquare(10.0f);
    arc.Rotate(centre, random.Uniform(-100.0f, 100.0f));
    EXPECT_EQ(arc.GetSpan(), span);
    EXPECT_EQ(arc.IsFullCircle(), desc.GetAngle0() == desc.GetAngle1());
    EXPECT_TRUE(arc.PtInSector(arc.GetEndPt0()));
    EXPECT_TRUE(arc.PtInSector(arc.GetEndPt1()));
    // Far from its ends, the middle is in and what is opposite to it is out.
    const double middle = arc.GetAngle0() + 0.5 * static_cast<double>(span);
    if (span > 0.05f) {
      EXPECT_TRUE(arc.PtInSector(OnCircle(arc, middle).cast<float>()));
    }
    if (span < 6.2f) {
      EXPECT_FALSE(arc.PtInSector(OnCircle(arc, middle + g_fPi2 / 2).cast<float>())) << "span " << span;
    }
  });
}

TEST(ArcSector, IsBetweenItsEnds) {
  struct CRow {
    CArc m_cArc;
    std::vector<Vector2> m_stdInside, m_stdOutside;
  };
  const float quarter = g_fPi / 4, next = std::nextafter(quarter, 1.0f);
  const CRow rows[] = {
      // Both ends round to the same float, or the span is below the rounding of a cross product.
      {Arc({1000, 1000}, 1, 0, 1e-5f), {{1001, 1000}}, {{999, 1000}, {998, 1000}}},
      {Arc({0, 0}, 1, quarter, next), {{0, 0}}, {-AngleToVector(quarter)}},
      {Arc({0, 0}, 1, 0, 1e-7f), {{1.09f, 0}}, {{-1.09f, 0}, {0, 1}}},
      // A slit.
      {Arc({0, 0}, 1, 1e-3f, g_fTwoPi - 1e-3f), {{-1, 0}, {1, 0.002f}, {1, -0.002f}, {0, 0}}, {{1, 0}}},
      // Across the angle 0.
      {Arc({0, 0}, 1, Degrees(350), Degrees(10)), {{2, 0}, {2, 1e-9f}, {2, -1e-9f}}, {{-2, 0}, {0, 2}}}};
  for (const auto& [arc, inside, outside] : rows) {
    SCOPED_TRACE(testing::Message() << arc.GetAngle0() << " to " << arc.GetAngle1());
    EXPECT_FALSE(arc.IsFullCircle());
    for (const Vector2& p : inside)
      EXPECT_TRUE(arc.PtInSector(p)) << p.transpose();
    for (const Vector2& p : outside)
      EXPECT_FALSE(arc.PtInSector(p)) << p.transpose();
  }
  EXPECT_LE(rows[0].m_cArc.GetAABB().GetWidth(), 1e-4f);
}

// The float next to pi is larger than pi, and so is the angle between the rounded ends: by 8.7e-8.
TEST(ArcSector, BothEndRaysOfHalfATurnBelongToIt) {
  for (const float r : {1.0f, 3.0f}) {
    const CArc arc = Arc({0.0f, 0.0f}, r, 0.0f, g_fPi);
    ASSERT_LT(arc.GetEndPt1().y(), 0.0f);
    for (const float far : {0.5f, 1.25f, 8.0f}) {
      EXPECT_TRUE(arc.PtInSector(far * arc.GetEndPt0())) << far;
      EXPECT_TRUE(arc.PtInSector(far * arc.GetEndPt1())) << far;
    }
    const float beyond = 10 * 1.2e-7f * r; // the bound of PtInSector
    EXPECT_FALSE(arc.PtInSector({r, -beyond}));
    EXPECT_FALSE(arc.PtInSector({-r, -beyond}));
    // The complement has the same end rays.
    const CArc below = Arc({0.0f, 0.0f}, r, g_fPi, 0.0f);
    EXPECT_TRUE(below.PtInSector(8.0f * below.GetEndPt0()));
    EXPECT_TRUE(below.PtInSector(8.0f * below.GetEndPt1()));
    EXPECT_FALSE(below.PtInSector({r, beyond}));
    EXPECT_FALSE(below.PtInSector({-r, beyond}));
  }
}

} // namespace
} // namespace Shapes
