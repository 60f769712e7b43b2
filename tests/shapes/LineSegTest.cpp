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

TEST(LineSeg, OfEqualXTheLowerEndIsFirst) {
  const CLineSegDesc desc({1.0f, 5.0f}, {1.0f, -2.0f});
  EXPECT_EQ(desc.GetEndPt0(), Vector2(1.0f, -2.0f));
  EXPECT_EQ(desc.GetEndPt1(), Vector2(1.0f, 5.0f));
  EXPECT_EQ(desc.GetNormal(), Vector2(-1.0f, 0.0f));
  EXPECT_EQ(desc.GetGradient(), std::numeric_limits<float>::infinity());
  Vector2 p0, p1;
  CLineSeg(desc).GetEndPts(p0, p1);
  EXPECT_EQ(p0, desc.GetEndPt0());
  EXPECT_EQ(p1, desc.GetEndPt1());
}

TEST(LineSeg, DescriptorKeepsEndsAndPositionTogether) {
  CLineSegDesc desc;
  desc.SetEndPts({4.0f, 2.0f}, {0.0f, 0.0f});
  Vector2 p0, p1;
  desc.GetEndPts(p0, p1);
  EXPECT_EQ(p0, Vector2(0.0f, 0.0f));
  EXPECT_EQ(p1, Vector2(4.0f, 2.0f));
  EXPECT_EQ(desc.m_vPos, Vector2(2.0f, 1.0f));
  EXPECT_FLOAT_EQ(desc.GetGradient(), 0.5f);
  EXPECT_LE((desc.GetNormal() - Vector2(-1.0f, 2.0f) / std::sqrt(5.0f)).norm(), 2 * g_fUlp);
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

TEST(KinematicLineSeg, NormalAndClosestPointAreContinuousThroughTheVertical) {
  CKinematicLineSeg seg(CLineSegDesc({-1.0f, 0.0f}, {1.0f, 0.0f}));
  const Vector2 q(0.7f, 0.4f);
  constexpr int n = 20000;
  constexpr double step = 4 * 3.14159265358979323846 / n;
  bool flipped = false;
  seg.Rotate({0.0f, 0.0f}, 0.0f);
  Vector2 normal = seg.GetNormal(), closest = seg.ClosestPt(q), t0, t1;
  seg.GetTangents(t0, t1);
  for (int i = 1; i <= n; ++i) {
    seg.Rotate({0.0f, 0.0f}, static_cast<float>(i * step));
    Vector2 s0, s1;
    seg.GetTangents(s0, s1);
    flipped |= (s0 - t0).norm() > 1.0f;
    t0 = s0;
    EXPECT_LE((seg.GetNormal() - normal).norm(), step + 16 * g_fUlp) << i; // an angle of 12 has ulps of 8
    // It slides along the segment by at most |q| and with it by at most |q| per radian.
    EXPECT_LE((seg.ClosestPt(q) - closest).norm(), 2 * step + 16 * g_fUlp) << i;
    EXPECT_LE(std::abs(seg.GetNormal().dot(s0)), 8 * g_fUlp) << i;
    normal = seg.GetNormal();
    closest = seg.ClosestPt(q);
  }
  EXPECT_TRUE(flipped); // the order of the ends did change on the way
}

TEST(LineSeg, HasTheSidesOfItsDescriptor) {
  const CLineSegDesc desc = Sided(CLineSegDesc({0.0f, 0.0f}, {1.0f, 0.0f}), eSides::Back);
  EXPECT_EQ(CLineSeg(desc).GetSides(), eSides::Back);
  EXPECT_EQ(CKinematicLineSeg(desc).GetSides(), eSides::Back);
}

} // namespace
} // namespace Shapes
