// SPDX-License-Identifier: MIT
// The bounds of the kernels of src/native/narrowphase/Collide.h for points, segments and two balls, and of
// the approach speed.
#include "CollideTesting.h"

#include <Shapes/Backend.h>
#include <Shapes/Contact.h>
#include <Shapes/DynamicCircle.h>

#include <cmath>

namespace Shapes::Bounds {
namespace {

constexpr int g_nDetectBoundsTrials = 10000;

// As the square of a difference.
float NaiveDistance(const Vector2& p, const Vector2& q) {
  return std::sqrt(std::max(0.0f, p.squaredNorm() - 2.0f * p.dot(q) + q.squaredNorm()));
}

TEST(DetectBounds, PointCircle) {
  CRandom random(1701);
  CHitErrors errors("CollidePointCircle");
  CWorst naive("Setback from a point by squares");
  for (int i = 0; i < g_nDetectBoundsTrials; ++i) {
    const float r = AnySize(random);
    const CPoint point(CPointDesc(AnyPlace(random, r)));
    const float gap = AnyGap(random, r);
    const Vector2 p = point.GetPos() + AnyWay(random, gap);
    const CBall ball = Resting(random, p, r);
    const CVec e = Exact(p) - Exact(point.GetPos());
    const CFifty d = Norm(e);
    CHit hit;
    const bool got = CollidePointCircle(point, ball, hit);
    errors.SeeAnswer(got, r - d, g_fUlp * r);
    if (!got || d == 0) continue;
    errors.m_cPOI.See(Exact(hit.m_vPOI), Exact(point.GetPos()), 0);
    errors.m_cNorm.See(Exact(hit.m_vNorm), Unit(e), 2 * g_fUlp);
    errors.m_cSetback.See(abs(hit.m_fSetback - (r - d)), 2 * g_fUlp * r);
    naive.See(abs(r - NaiveDistance(p, point.GetPos()) - (r - d)), 2 * g_fUlp * r);
  }
  errors.ExpectKept(5000);
  naive.ExpectBroken();
}

TEST(DetectBounds, BallBall) {
  CRandom random(1702);
  CHitErrors errors("CollideBallBall");
  CWorst naive("Setback of two balls by squares");
  for (int i = 0; i < g_nDetectBoundsTrials; ++i) {
    const float r0 = AnySize(random), r1 = i % 3 ? r0 * random.Scale(-8, 8) : r0 * NearOne(random);
    const CBall other = Resting(random, AnyPlace(random, r0), r0);
    const float gap = AnyGap(random, r0 + r1);
    const Vector2 p = other.m_vPos + AnyWay(random, gap);
    const CBall ball = Resting(random, p, r1);
    const CVec e = Exact(p) - Exact(other.m_vPos);
    const CFifty d = Norm(e), r = CFifty(r0) + CFifty(r1);
    CHit hit;
    const bool got = CollideBallBall(other, ball, hit);
    errors.SeeAnswer(got, r - d, 2 * g_fUlp * r);
    if (!got || d == 0) continue;
    const CVec n = Unit(e);
    errors.m_cPOI.See(Exact(hit.m_vPOI), Exact(other.m_vPos) + CFifty(r0) * n,
                      3 * g_fUlp * (Norm(Exact(other.m_vPos)) + r0));
    errors.m_cNorm.See(Exact(hit.m_vNorm), n, 2 * g_fUlp);
    errors.m_cSetback.See(abs(hit.m_fSetback - (r - d)), 2 * g_fUlp * r);
    naive.See(abs(r0 + r1 - NaiveDistance(p, other.m_vPos) - (r - d)), 2 * g_fUlp * r);
  }
  errors.ExpectKept(5000);
  naive.ExpectBroken();
}

TEST(DetectBounds, LineSegCircle) {
  CRandom random(1703);
  CHitErrors errors("CollideLineSegCircle");
  CWorst naive("Setback from a segment by gradients");
  for (int i = 0; i < 2 * g_nDetectBoundsTrials; ++i) {
    const float size = AnySize(random), r = size * random.Scale(-10, 2);
    const Vector2 from = AnyPlace(random, size);
    const Vector2 to = from + AnyWay(random, size);
    const CLineSeg seg(CLineSegDesc(from, to));
    const Vector2 &p0 = seg.GetEndPt0(), &p1 = seg.GetEndPt1();
    if (p0 == p1) continue;
    const float share = i % 3 ? random.Uniform(-0.1f, 1.1f) : random.SignedScale(-24, -10);
    const float side = random.Coin() ? 1.0f : -1.0f;
    const float gap = side * AnyGap(random, r);
    const Vector2 on = i % 2 ? Vector2(p0 + share * (p1 - p0)) : Vector2(p1 - share * (p1 - p0));
    const Vector2 p = on + gap * seg.GetNormal();
    const CBall ball = Resting(random, p, r);
    const CVec e0 = Exact(p0), e1 = Exact(p1), e = Exact(p), t = Unit(e1 - e0);
    const CFifty s = Dot(e - e0, Left(t)), d0 = Gap(e, e0), d1 = Gap(e, e1);
    CHit hit;
    const bool got = CollideLineSegCircle(seg, ball, hit);
    // What is met overlaps, and is between both ends.
    const CFifty overlap = std::min({CFifty(r - abs(s)), Dot(e - e0, t), CFifty(-Dot(e - e1, t))});
    errors.SeeAnswer(got, overlap, 3 * g_fUlp * (d0 + d1));
    if (!got || abs(s) <= 3 * g_fUlp * d0) continue; // on the segment: either side
    errors.m_cPOI.See(Exact(hit.m_vPOI), ClosestOnSegment(e0, e1, e),
                      8 * g_fUlp * (Norm(e) + Norm(e0) + Gap(e0, e1)));
    errors.m_cNorm.See(Exact(hit.m_vNorm), s > 0 ? Left(t) : CFifty(-1) * Left(t), 2 * g_fUlp);
    const CFifty bound = 3 * g_fUlp * d0 + g_fUlp * r / 2;
    errors.m_cSetback.See(abs(hit.m_fSetback - (r - abs(s))), bound);
    const float m = (p1.y() - p0.y()) / (p1.x() - p0.x()), b = p0.y() - m * p0.x();
    naive.See(abs(r - std::abs(p.y() - m * p.x() - b) / std::sqrt(1.0f + m * m) - (r - abs(s))), bound);
  }
  errors.ExpectKept(5000);
  naive.ExpectBroken();
}

TEST(DetectBounds, ApproachSpeed) {
  CRandom random(1704);
  CWorst worst("CContactDesc::m_fSpeed"), naive("Approach speed as the loss of distance");
  const CBackend& native = *GetBackend(eBackend::Native);
  for (int i = 0; i < g_nDetectBoundsTrials; ++i) {
    const float size = AnySize(random), r = size * random.Scale(-10, 2);
    const Vector2 from = AnyPlace(random, size);
    const Vector2 to = from + AnyWay(random, size);
    CLineSegDesc desc(from, to);
    desc.m_fRotSpeed = random.SignedScale(-8, 6);
    desc.m_vRotCenter = from + AnyWay(random, size);
    CKinematicLineSeg seg(desc);
    if (from == to) continue;
    const Vector2 p = from + random.Uniform(0.1f, 0.9f) * (to - from) + 0.5f * r * seg.GetNormal();
    const Vector2 v =
        i % 2 ? AnyWay(random, AnySize(random)) : Vector2(NearOne(random) * seg.GetSurfaceVelocity(p));
    if (v.norm() > 1e12f) continue;
    CDynamicCircle ball(CDynamicCircleDesc(p, r, v));
    CContactDesc c(&seg, &ball);
    if (!native.CollisionDetected(c)) continue;
    const CVec e0 = Exact(seg.GetEndPt0()), e1 = Exact(seg.GetEndPt1()), e = Exact(p),
               n = Left(Unit(e1 - e0));
    const CFifty side = Dot(e - e0, n);
    if (abs(side) <= 3 * g_fUlp * Gap(e, e0)) continue;
    const CFifty spin = 2 * Pi() * CFifty(desc.m_fRotSpeed);
    const CVec surface = spin * Left(ClosestOnSegment(e0, e1, e) - Exact(desc.m_vRotCenter));
    const CFifty approach = -Dot(Exact(v) - surface, side > 0 ? n : CFifty(-1) * n),
                 exact = std::max(CFifty(0), approach);
    const CFifty atPOI = 8 * g_fUlp * (Norm(e) + Norm(e0) + Gap(e0, e1));
    const CFifty bound = 5 * g_fUlp * (Norm(Exact(v)) + Norm(surface)) + abs(spin) * atPOI;
    worst.See(abs(c.m_fSpeed - exact), bound);
    const float dt = 0x1p-10f;
    const float before = Length(p - c.m_vPOI), after = Length(Vector2(p + dt * v) - c.m_vPOI);
    naive.See(abs(std::max(0.0f, (before - after) / dt) - exact), bound);
  }
  worst.ExpectKept(5000);
  naive.ExpectBroken();
}

} // namespace
} // namespace Shapes::Bounds
