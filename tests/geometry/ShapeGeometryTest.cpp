// SPDX-License-Identifier: MIT
#include "geometry/ShapeGeometry.h"

#include "../Testing.h"

namespace Shapes::Geometry {
namespace {

CLineSegDesc RandomLineSeg(CRandom& random) {
  const Vector2 p = random.InSquare(1.0f), q = random.InSquare(1.0f);
  return Turning(CLineSegDesc(p, q), 0, random.InSquare(1.0f));
}

CArcDesc RandomArc(CRandom& random) {
  const Vector2 p = random.InSquare(1.0f);
  const float R = random.Uniform(0.1f, 1), a0 = random.Uniform(0, 6.28f), a1 = random.Uniform(0, 6.28f);
  return Turning(CArcDesc(p, R, a0, a1), 0, random.InSquare(1.0f));
}

// However a segment has turned: its normal is the shape's, and across it.
TEST(Outline, TheFrontOfASegmentIsThatOfTheShape) {
  ForEachCase(80, 2000, [&](CRandom& random, int) {
    CKinematicLineSeg seg(RandomLineSeg(random));
    seg.SetOrientation(random.Uniform(0.0f, 6.28f));
    const CShapeGeometry o = MakeShapeGeometry(seg, 0.0);
    const Vector2d along = o.m_vPt1 - o.m_vPt0;
    ASSERT_LE((o.m_vFront - Wide(seg.GetNormal())).norm(), 4.0 * g_fUlp);
    ASSERT_NEAR(o.m_vFront.dot(along), 0.0, 0x1p-50);
    ASSERT_GT(Cross(along, o.m_vFront), 0.0);
    const bool inOrder = o.m_vPt0 == Wide(seg.GetEndPt0()) && o.m_vPt1 == Wide(seg.GetEndPt1());
    const bool swapped = o.m_vPt1 == Wide(seg.GetEndPt0()) && o.m_vPt0 == Wide(seg.GetEndPt1());
    ASSERT_TRUE(inOrder || swapped);
  });
}

TEST(Outline, TheEndsOfAnArcAreOnItsCircleAndItsSectorIsThatOfTheShape) {
  int inside = 0;
  ForEachCase(81, 2000, [&](CRandom& random, int) {
    const CArc arc(RandomArc(random));
    const CShapeGeometry o = MakeShapeGeometry(arc, 0.0);
    const double R = static_cast<double>(arc.GetRadius());
    for (const Vector2d& end : {o.m_vPt0, o.m_vPt1})
      ASSERT_NEAR((end - o.m_vCenter).norm(), R, 8.0 * 0x1p-52);
    ASSERT_LE((o.m_vPt0 - Wide(arc.GetEndPt0())).norm(), 4.0 * g_fUlp);
    ASSERT_LE((o.m_vPt1 - Wide(arc.GetEndPt1())).norm(), 4.0 * g_fUlp);
    for (int k = 0; k < 20; ++k) {
      const Vector2 p = arc.GetPos() + random.InSquare(2.0f);
      const Vector2d x = Wide(p) - o.m_vCenter;
      const bool near = InSector(o, x, 1e-5) != InSector(o, x, -1e-5); // an end ray
      if (near) continue;
      ASSERT_EQ(InSector(o, x, 0.0), arc.PtInSector(p));
      inside += arc.PtInSector(p);
    }
  });
  EXPECT_GT(inside, 10000);
}

TEST(Outline, FullAndAlmostFullArcsAreToldApart) {
  EXPECT_TRUE(MakeShapeGeometry(CArc(CArcDesc({0, 0}, 1, 1, 1)), 0.0).m_bFull);
  const CShapeGeometry almost = MakeShapeGeometry(CArc(CArcDesc({0, 0}, 1, 0.5f, 0.5f - 1e-6f)), 0.0);
  EXPECT_FALSE(almost.m_bFull);
  EXPECT_TRUE(almost.m_bWide);
  EXPECT_FALSE(MakeShapeGeometry(CArc(CArcDesc({0, 0}, 1, 0.5f, 0.5f + 1e-6f)), 0.0).m_bWide);
  // So short that both ends are one point: the angles know.
  EXPECT_TRUE(MakeShapeGeometry(CArc(CArcDesc({1e6f, 0}, 1e-3f, 0.5f, 0.4f)), 0.0).m_bWide);
  EXPECT_FALSE(MakeShapeGeometry(CArc(CArcDesc({1e6f, 0}, 1e-3f, 0.4f, 0.5f)), 0.0).m_bWide);
}

// Where the shape goes by its own rotation, in float.
TEST(Outline, ItTurnsAsTheShapeDoes) {
  ForEachCase(82, 2000, [&](CRandom& random, int) {
    const float revs = random.Uniform(-3.0f, 3.0f), dt = random.Uniform(0.0f, 0.3f);
    const double w = 2.0 * std::numbers::pi * static_cast<double>(revs), t = static_cast<double>(dt);
    CKinematicArc arc(RandomArc(random));
    CKinematicLineSeg seg(RandomLineSeg(random));
    arc.SetRotSpeed(revs);
    seg.SetRotSpeed(revs);
    const auto a = RotatedFor(MakeShapeGeometry(arc, w), t), s = RotatedFor(MakeShapeGeometry(seg, w), t);
    arc.Advance(dt);
    seg.Advance(dt);
    ASSERT_LE((a.m_vCenter - Wide(arc.GetPos())).norm(), 64.0 * g_fUlp);
    ASSERT_LE((a.m_vPt0 - Wide(arc.GetEndPt0())).norm(), 64.0 * g_fUlp);
    ASSERT_LE((a.m_vPt1 - Wide(arc.GetEndPt1())).norm(), 64.0 * g_fUlp);
    ASSERT_LE((s.m_vFront - Wide(seg.GetNormal())).norm(),
              64.0 * g_fUlp / static_cast<double>(Shapes::Length(seg.GetEndPt1() - seg.GetEndPt0())));
    // In whatever order they are now.
    const Vector2d middle = 0.5 * (s.m_vPt0 + s.m_vPt1);
    ASSERT_LE((middle - Wide(seg.GetPos())).norm(), 64.0 * g_fUlp);
    // Nothing of it is ever farther away than its size.
    for (const Vector2d& p : {a.m_vCenter, a.m_vPt0, a.m_vPt1})
      ASSERT_LE(p.cwiseAbs().maxCoeff(), a.m_fSize * (1.0 + 8.0 * 0x1p-52));
  });
}

TEST(Outline, WhatIsRoundAboutItsOwnCentreStaysButItsSurfaceMoves) {
  CCircleDesc desc = Turning(CCircleDesc({1, 2}, 0.5f), 0, {1, 2});
  CShapeGeometry o = MakeShapeGeometry(CKinematicCircle(desc), 3.0);
  EXPECT_EQ(o.m_fTurnSpeed, 0.0);
  EXPECT_EQ(o.m_fSpin, 3.0);
  desc.m_vRotCenter = {1, 2.5f};
  o = MakeShapeGeometry(CKinematicCircle(desc), 3.0);
  EXPECT_EQ(o.m_fTurnSpeed, 3.0);
}

TEST(Outline, LengthsHoldWhereSquaresUnderflow) {
  for (const double scale : {1e-300, 1e-200, 1e-150, 1e-45, 1.0, 1e28, 1e100}) {
    EXPECT_NEAR(Norm(scale * Vector2d(3, 4)) / scale, 5.0, 4.0 * 0x1p-52) << scale;
    EXPECT_NEAR(Unit(scale * Vector2d(3, 4), Vector2d::UnitX()).norm(), 1.0, 4.0 * 0x1p-52) << scale;
  }
  EXPECT_EQ(Unit(Vector2d::Zero(), Vector2d(0, 1)), Vector2d(0, 1));
}

} // namespace
} // namespace Shapes::Geometry
