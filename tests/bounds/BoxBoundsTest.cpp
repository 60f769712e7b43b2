// SPDX-License-Identifier: MIT
// The bounds of Aabb2D.h, and those of CShape::GetAABB.
#include "Inputs.h"
#include "Worst.h"

#include <Shapes/Arc.h>
#include <Shapes/Point.h>

namespace Shapes::Bounds {
namespace {

constexpr int g_nBoxBoundsTrials = 5000;

TEST(BoxBounds, TranslateWidthAndHeight) {
  CKept moved("CAabb2D::Translate", g_nBoxBoundsTrials),
      width("CAabb2D::GetWidth, GetHt", g_nBoxBoundsTrials);
  CBroken naive("Width of a box that was moved");
  ForEachCase(1401, g_nBoxBoundsTrials, [&](CRandom& random, int) {
    const float size = AnySize(random);
    const Vector2 p = AnyPlace(random, size);
    const Vector2 q = p + AnyWay(random, size);
    CAabb2D box(p, q);
    const CVec tl = Exact(box.GetTopLeft()), br = Exact(box.GetBottomRt());
    const auto see = [&](CWorst& worst) {
      worst.See(abs(box.GetWidth() - (br.x - tl.x)), g_fUlp * (br.x - tl.x) / 2);
      worst.See(abs(box.GetHt() - (tl.y - br.y)), g_fUlp * (tl.y - br.y) / 2);
    };
    see(width);
    const Vector2 v = AnyPlace(random, size);
    box.Translate(v);
    see(naive);
    moved.SeeEach(box.GetTopLeft(), tl + Exact(v), 0.5);
    moved.SeeEach(box.GetBottomRt(), br + Exact(v), 0.5);
  });
}

TEST(BoxBounds, PointsAndSegmentsHaveExactBoxes) {
  ForEachCase(1402, g_nBoxBoundsTrials, [&](CRandom& random, int) {
    const float size = AnySize(random);
    const Vector2 p = AnyPlace(random, size);
    const Vector2 q = p + AnyWay(random, size);
    const CAabb2D point = CPoint(CPointDesc(p)).GetAABB(), seg = CLineSeg(CLineSegDesc(p, q)).GetAABB();
    ASSERT_TRUE(point.GetTopLeft() == p && point.GetBottomRt() == p);
    ASSERT_EQ(seg.GetTopLeft(), Vector2(std::min(p.x(), q.x()), std::max(p.y(), q.y())));
    ASSERT_EQ(seg.GetBottomRt(), Vector2(std::max(p.x(), q.x()), std::min(p.y(), q.y())));
  });
}

TEST(BoxBounds, Circles) {
  CKept worst("CCircle::GetAABB", g_nBoxBoundsTrials);
  CBroken naive("Box of a circle by its diameter");
  ForEachCase(1403, g_nBoxBoundsTrials, [&](CRandom& random, int) {
    const float r = AnySize(random);
    const Vector2 c = AnyPlace(random, r);
    const CCircle circle(CCircleDesc(c, r));
    const CAabb2D& box = circle.GetAABB();
    const auto see = [](CWorst& w, float is, const CFifty& exact) {
      w.See(abs(is - exact), g_fUlp * abs(exact) / 2);
    };
    const CFifty R = r, right = c.x() + R;
    see(worst, box.GetTopLeft().x(), c.x() - R);
    see(worst, box.GetBottomRt().x(), right);
    see(worst, box.GetTopLeft().y(), c.y() + R);
    see(worst, box.GetBottomRt().y(), c.y() - R);
    see(naive, box.GetTopLeft().x() + 2.0f * r, right);
  });
}

TEST(BoxBounds, Arcs) {
  CKept worst("CArc::GetAABB", g_nBoxBoundsTrials);
  CBroken naive("Box of an arc by its ends");
  ForEachCase(1404, 2 * g_nBoxBoundsTrials, [&](CRandom& random, int i) {
    const float r = AnySize(random);
    const Vector2 c = AnyPlace(random, r);
    const float a0 = AnyAngle(random);
    const float a1 = i % 3 ? AnyAngle(random) : a0 + (i % 2 ? g_fPi : -g_fPi) * NearOne(random);
    const CArcDesc desc(c, r, a0, a1);
    const CArc arc(desc);
    const CAabb2D& box = arc.GetAABB();
    CFifty span = Turn(CFifty(desc.GetAngle1()) - CFifty(desc.GetAngle0()));
    if (span == 0) span = 2 * Pi();
    const CArcOracle exact{Exact(c), r, desc.GetAngle0(), span};
    const CFifty bound = 4 * g_fUlp * (Norm(Exact(c)) + r);
    const CFifty right = c.x() + exact.Reach(0), top = c.y() + exact.Reach(Pi() / 2),
                 left = c.x() - exact.Reach(Pi()), bottom = c.y() - exact.Reach(3 * Pi() / 2);
    worst.See(abs(box.GetBottomRt().x() - right), bound);
    worst.See(abs(box.GetTopLeft().y() - top), bound);
    worst.See(abs(box.GetTopLeft().x() - left), bound);
    worst.See(abs(box.GetBottomRt().y() - bottom), bound);
    naive.See(abs(std::max(arc.GetEndPt0().x(), arc.GetEndPt1().x()) - right), bound);
  });
}

} // namespace
} // namespace Shapes::Bounds
