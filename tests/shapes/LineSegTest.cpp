// SPDX-License-Identifier: MIT
// Lines and segments.
#include <Shapes/LineSeg.h>

#include "../Testing.h"

namespace Shapes {
namespace {

TEST(Line, VerticalLineHasInfiniteGradientOfOneSign) {
  for (const float m : {g_fInf, -g_fInf}) {
    const CLine line({3.0f, 5.0f}, m);
    EXPECT_EQ(line.GetGradient(), g_fInf);
    EXPECT_EQ(line.GetInverseGradient(), 0.0f);
    EXPECT_EQ(line.GetYIntercept(), g_fInf);
    EXPECT_EQ(line.GetXIntercept(), 3.0f);
  }
}

TEST(Line, ParallelLinesHaveNoIntersection) {
  ForEachCase(32, 1000, [&](CRandom& random, int) {
    const float m = random.SignedScale(-30, 30);
    const CLine a(random.InSquare(100.0f), m), b(random.InSquare(100.0f), m);
    EXPECT_EQ(a.Intersect(b), Vector2(g_fInf, g_fInf)) << m;
  });
  // Vertical lines of either sign of infinity are parallel, though their gradients are not equal.
  EXPECT_EQ(CLine({1.0f, 0.0f}, g_fInf).Intersect(CLine({2.0f, 0.0f}, -g_fInf)), Vector2(g_fInf, g_fInf));
  EXPECT_EQ(CLine({1.0f, 0.0f}, 0.0f).Intersect(CLine({1.0f, 3.0f}, -0.0f)), Vector2(g_fInf, g_fInf));
}

TEST(LineSeg, OneWithoutLengthActsAsAPoint) {
  const CLineSeg seg(CLineSegDesc({1.0f, 1.0f}, {1.0f, 1.0f}));
  Vector2 t0, t1;
  seg.GetTangents(t0, t1);
  EXPECT_EQ(t0, Vector2(1.0f, 0.0f));
  EXPECT_EQ(t1, Vector2(-1.0f, 0.0f));
  EXPECT_EQ(seg.GetNormal(), Vector2(0.0f, 1.0f));
  for (const Vector2& q :
       {Vector2(1.0f, 3.0f), Vector2(-5.0f, 1.0f), Vector2(1.0f, 1.0f), Vector2(9.0f, 0.0f)})
    EXPECT_EQ(seg.ClosestPt(q), Vector2(1.0f, 1.0f));
}

TEST(LineSeg, OneWhoseLengthSquaredUnderflowsStillHasADirection) {
  const CLineSeg seg(CLineSegDesc({0.0f, 0.0f}, {1e-30f, 0.0f}));
  EXPECT_EQ(seg.GetNormal(), Vector2(0.0f, 1.0f));
  EXPECT_EQ(seg.ClosestPt({0.0f, 2.0f}), Vector2(0.0f, 0.0f));
  EXPECT_EQ(seg.ClosestPt({1.0f, 2.0f}), Vector2(1e-30f, 0.0f));
}

TEST(LineSeg, SetPosTakesTheEndsAlong) {
  CLineSeg seg(CLineSegDesc({0.0f, 0.0f}, {4.0f, 2.0f}));
  seg.SetPos({10.0f, 10.0f});
  EXPECT_EQ(seg.GetPos(), Vector2(10.0f, 10.0f));
  EXPECT_EQ(seg.GetEndPt0(), Vector2(8.0f, 9.0f));
  EXPECT_EQ(seg.GetEndPt1(), Vector2(12.0f, 11.0f));
  EXPECT_EQ(seg.GetAABB().GetTopLeft(), Vector2(8.0f, 11.0f));
  EXPECT_EQ(seg.GetAABB().GetBottomRt(), Vector2(12.0f, 9.0f));
  const Vector2 closest = seg.ClosestPt({10.0f, 10.0f}); // the line went along
  EXPECT_LE((closest - Vector2(10.0f, 10.0f)).norm(), 8 * g_fUlp * 20);
}

TEST(LineSeg, HasTheSidesOfItsDescriptor) {
  const CLineSegDesc desc = Sided(CLineSegDesc({0.0f, 0.0f}, {1.0f, 0.0f}), eSides::Back);
  EXPECT_EQ(CLineSeg(desc).GetSides(), eSides::Back);
  EXPECT_EQ(CKinematicLineSeg(desc).GetSides(), eSides::Back);
}

} // namespace
} // namespace Shapes
