// SPDX-License-Identifier: MIT
// The bounds of CShape::Rotate and GetSurfaceVelocity.
#include "Inputs.h"
#include "Worst.h"

#include <Shapes/Arc.h>
#include <Shapes/Point.h>

#include <cmath>

namespace Shapes::Bounds {
namespace {

constexpr int g_nRotationBoundsTrials = 5000;

TEST(RotationBounds, Rotate) {
  CRandom random(1501);
  CWorst points("CKinematicPoint::Rotate"), circles("CKinematicCircle::Rotate"),
      segments("CKinematicLineSeg::Rotate"), arcs("CKinematicArc::Rotate"), naive("Rotate in eight parts");
  for (int i = 0; i < g_nRotationBoundsTrials; ++i) {
    const float size = AnySize(random);
    const Vector2 center = AnyPlace(random, size);
    const Vector2 p = center + AnyWay(random, size);
    const Vector2 q = p + AnyWay(random, size);
    const float angle = i % 2 ? AnyAngle(random) : random.SignedScale(0, 29);
    const auto see = [&](CWorst& worst, const Vector2& is, const Vector2& was) {
      worst.See(Exact(is), Turned(Exact(was), Exact(center), angle),
                3 * g_fUlp * (Norm(Exact(center)) + Gap(Exact(was), Exact(center))));
    };
    CKinematicPoint point{CPointDesc(p)};
    point.Rotate(center, angle);
    see(points, point.GetPos(), p);

    CKinematicCircle circle{CCircleDesc(p, size)};
    circle.Rotate(center, angle);
    see(circles, circle.GetPos(), p);

    const CLineSegDesc desc(p, q);
    CKinematicLineSeg seg(desc);
    seg.Rotate(center, angle);
    // Which end comes first may have changed.
    const CVec t0 = Turned(Exact(desc.GetEndPt0()), Exact(center), angle);
    const bool swapped = Gap(Exact(seg.GetEndPt0()), t0) > Gap(Exact(seg.GetEndPt1()), t0);
    see(segments, swapped ? seg.GetEndPt1() : seg.GetEndPt0(), desc.GetEndPt0());
    see(segments, swapped ? seg.GetEndPt0() : seg.GetEndPt1(), desc.GetEndPt1());

    const CArcDesc arcDesc(p, size, AnyAngle(random), 1.0f);
    CKinematicArc arc(arcDesc);
    const Vector2 end0 = arc.GetEndPt0(), end1 = arc.GetEndPt1();
    arc.Rotate(center, angle);
    see(arcs, arc.GetPos(), p);
    see(arcs, arc.GetEndPt0(), end0);
    see(arcs, arc.GetEndPt1(), end1);

    Vector2 turned = p;
    for (int k = 0; k < 8; ++k)
      turned = RotatePt(turned, center, angle / 8.0f);
    see(naive, turned, p);
  }
  for (const CWorst* pWorst : {&points, &circles, &segments, &arcs})
    pWorst->ExpectKept(g_nRotationBoundsTrials);
  naive.ExpectBroken();
}

TEST(RotationBounds, GetSurfaceVelocity) {
  CRandom random(1502);
  CWorst worst("CShape::GetSurfaceVelocity"), naive("Surface velocity by a short turn");
  for (int i = 0; i < g_nRotationBoundsTrials; ++i) {
    const float size = AnySize(random);
    CPointDesc desc(AnyPlace(random, size));
    desc.m_vRotCenter = AnyPlace(random, size);
    desc.m_fRotSpeed = random.SignedScale(-10, 10);
    const CKinematicPoint point(desc);
    const Vector2 q = desc.m_vRotCenter + AnyWay(random, size);
    const CVec exact = (2 * Pi() * CFifty(desc.m_fRotSpeed)) * Left(Exact(q) - Exact(desc.m_vRotCenter));
    const auto see = [&](CWorst& w, const Vector2& is) {
      w.See(abs(is.x() - exact.x), 2 * g_fUlp * abs(exact.x));
      w.See(abs(is.y() - exact.y), 2 * g_fUlp * abs(exact.y));
    };
    see(worst, point.GetSurfaceVelocity(q));
    const float dt = 0x1p-10f / std::abs(desc.m_fRotSpeed);
    see(naive, (RotatePt(q, desc.m_vRotCenter, g_fTwoPi * desc.m_fRotSpeed * dt) - q) / dt);
  }
  worst.ExpectKept(g_nRotationBoundsTrials);
  naive.ExpectBroken();
}

} // namespace
} // namespace Shapes::Bounds
