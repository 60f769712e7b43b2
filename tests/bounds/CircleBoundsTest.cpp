// SPDX-License-Identifier: MIT
// The bounds of Circle.h and Arc.h.
#include "Inputs.h"
#include "Worst.h"

#include <Shapes/Arc.h>

namespace Shapes::Bounds {
namespace {

constexpr int g_nCircleBoundsTrials = 10000;

CCircle Circle(const Vector2& p, float r) { return CCircle(CCircleDesc(p, r)); }

TEST(CircleBounds, ClosestPtAndPtInCircle) {
  CKept closest("CCircle::ClosestPt", 9000), inside("CCircle::PtInCircle", 9000);
  CBroken naive("CCircle::ClosestPt by the gradient"), naiveInside("PtInCircle by squares");
  ForEachCase(1201, g_nCircleBoundsTrials, [&](CRandom& random, int i) {
    const float r = AnySize(random);
    const Vector2 c = AnyPlace(random, r);
    const float away = i % 2 ? r * NearOne(random) : r * random.Scale(-30, 10);
    const Vector2 q = c + AnyWay(random, away);
    if (q == c) return;
    const CCircle circle = Circle(c, r);
    const CVec ec = Exact(c), eq = Exact(q), exact = ClosestOnCircle(ec, r, eq);
    const CFifty d = Gap(ec, eq), bound = 3 * g_fUlp * (Norm(ec) + r);
    closest.See(Exact(circle.ClosestPt(q)), exact, bound);
    const Vector2 v = q - c;
    const float m = v.y() / v.x(), x = std::copysign(r / std::sqrt(1.0f + m * m), v.x());
    naive.See(Exact(Vector2(c + Vector2(x, m * x))), exact, bound);
    inside.SeeAnswer(!circle.PtInCircle(q), d - r, g_fUlp * d);
    naiveInside.SeeAnswer(q.dot(q) - 2.0f * q.dot(c) + c.dot(c) >= r * r, d - r, g_fUlp * d);
  });
}

// How well q is where a tangent through p touches: on the circle, and at a right angle to its radius.
void SeeTouch(CWorst& worst, const CVec& c, const CFifty& r, const CVec& p, const CVec& q,
              const CFifty& bound) {
  const CVec radius = q - c, way = q - p;
  worst.See(abs(Norm(radius) - r), bound);
  worst.See(abs(Dot(radius, way)), bound * (Norm(radius) + Norm(way)));
}

TEST(CircleBounds, TangentsThroughAPoint) {
  CKept touch("CCircle::Tangents through a point", 10000), where("where they touch", 10000),
      exists("that there are tangents through a point", 9000);
  CBroken naive("Tangent length d^2 - r^2");
  ForEachCase(1202, g_nCircleBoundsTrials, [&](CRandom& random, int i) {
    const float r = AnySize(random);
    const Vector2 c = AnyPlace(random, r);
    const float away = i % 2 ? r * NearOne(random) : r * (1.0f + random.Scale(-20, 8));
    const Vector2 p = c + AnyWay(random, away);
    const CVec ec = Exact(c), ep = Exact(p);
    const CFifty d = Gap(ec, ep);
    Vector2 q[2];
    const bool got = Circle(c, r).Tangents(p, q[0], q[1]);
    if (d == 0) return;
    exists.SeeAnswer(got, d - r, g_fUlp * d);
    if (!got) return;
    const CFifty bound = 10 * g_fUlp * (Norm(ep) + d);
    for (const int side : {1, -1}) {
      const CVec is = Exact(q[side < 0]);
      SeeTouch(touch, ec, r, ep, is, bound);
      if (d - r > 16 * g_fUlp * d) // else the exact one may not exist for the next float
        where.See(is, TouchPoint(ec, r, ep, side), bound * (1 + d / sqrt(d * d - r * r)));
    }
    const Vector2 v = c - p;
    const float df = v.norm(), phi = std::atan2(v.y(), v.x());
    const float delta = df * df - r * r, theta = phi + std::atan2(r, delta);
    SeeTouch(naive, ec, r, ep, Exact(Vector2(p + delta * Vector2(std::cos(theta), std::sin(theta)))), bound);
  });
}

TEST(CircleBounds, CommonTangents) {
  CKept touch("CCircle::Tangents of two circles", 10000), where("where they touch both", 10000),
      exists("that two circles have tangents", g_nCircleBoundsTrials);
  CBroken naive("Common tangents by the tangent length");
  ForEachCase(1203, g_nCircleBoundsTrials, [&](CRandom& random, int i) {
    const float r0 = AnySize(random);
    const float r1 = i % 4 == 0 ? r0 : i % 4 == 1 ? r0 * NearOne(random) : r0 * random.Scale(-12, 12);
    const Vector2 c0 = AnyPlace(random, r0);
    const float nested = std::abs(r0 - r1);
    const float away = i % 2 && nested > 0.0f ? nested * NearOne(random) : (r0 + r1) * random.Scale(-8, 8);
    const Vector2 c1 = c0 + AnyWay(random, away);
    const CVec e0 = Exact(c0), e1 = Exact(c1);
    const CFifty f0 = r0, f1 = r1, d = Gap(e0, e1);
    const CCircle a = Circle(c0, r0), b = Circle(c1, r1);
    CLineSegDesc t[2];
    const bool got = a.Tangents(&b, t[0], t[1]);
    exists.SeeAnswer(!got, abs(f0 - f1) - d, 2 * g_fUlp * d);
    if (!got || d - abs(f0 - f1) <= 16 * g_fUlp * d) return;
    const CFifty bound = 8 * g_fUlp * (Norm(e0) + Norm(e1) + f0 + f1);
    const CFifty slope = sqrt((d - f0 + f1) * (d + f0 - f1)) / d;
    for (const int side : {-1, 1}) {
      const CVec n = TouchDirection(e0, f0, e1, f1, side), x0 = e0 + f0 * n, x1 = e1 + f1 * n;
      CVec q0 = Exact(t[side > 0].GetEndPt0()), q1 = Exact(t[side > 0].GetEndPt1());
      if (Gap(q0, x0) + Gap(q1, x1) > Gap(q0, x1) + Gap(q1, x0)) std::swap(q0, q1); // by the order of ends
      SeeTouch(touch, e0, f0, q1, q0, bound);
      SeeTouch(touch, e1, f1, q0, q1, bound);
      where.See(q0, x0, bound * (1 + 1 / slope));
      where.See(q1, x1, bound * (1 + 1 / slope));
    }
    // From the point to which the smaller circle shrinks, its tangent of length d^2 - r^2.
    const Vector2 v = c1 - c0;
    const float df = v.norm(), shrunk = r0 - r1;
    const float angle = std::atan2(v.y(), v.x()) + std::atan2(df * df - shrunk * shrunk, shrunk);
    const Vector2 n(std::cos(angle), std::sin(angle));
    SeeTouch(naive, e0, f0, Exact(Vector2(c1 + r1 * n)), Exact(Vector2(c0 + r0 * n)), bound);
  });
}

constexpr int g_nArcBoundsTrials = 5000;

CArcDesc AnyArc(CRandom& random) {
  const float r = AnySize(random);
  const Vector2 c = AnyPlace(random, r);
  const float a0 = AnyAngle(random);
  // Any span, short ones, about half a turn, and all but a full one.
  const float half = g_fPi * NearOne(random);
  const float spans[] = {AnyAngle(random), random.SignedScale(-20, -2), half, -half};
  return CArcDesc(c, r, a0, a0 + spans[random.Below(4)]);
}

CArcOracle Exactly(const CArcDesc& desc) {
  const CFifty span = Turn(CFifty(desc.GetAngle1()) - CFifty(desc.GetAngle0()));
  return {Exact(desc.m_vPos), desc.m_fRadius, desc.GetAngle0(), span == 0 ? CFifty(2 * Pi()) : span};
}

CFifty Size(const CArcDesc& desc) { return Norm(Exact(desc.m_vPos)) + desc.m_fRadius; }

TEST(ArcBounds, EndsTangentsAndAngles) {
  CKept ends("CArc::GetEndPts", 4000), tangents("CArcDesc::GetTangents", 4000),
      atEnds("CArc::GetTangents", 4000), span("CArc::GetSpan", 4000), angle1("CArc::GetAngle1", 4000);
  CBroken naive("Ends of an arc by a root");
  ForEachCase(1301, g_nArcBoundsTrials, [&](CRandom& random, int) {
    const CArcDesc desc = AnyArc(random);
    const CArcOracle exact = Exactly(desc);
    const CArc arc(desc);
    const CFifty end1 = exact.m_fAngle0 + exact.m_fSpan, size = Size(desc), r = exact.m_fRadius;
    const CVec u0 = AtAngle(exact.m_fAngle0), u1 = AtAngle(end1);
    ends.See(Exact(arc.GetEndPt0()), exact.At(exact.m_fAngle0), 2 * g_fUlp * size);
    ends.See(Exact(arc.GetEndPt1()), exact.At(end1), 2 * g_fUlp * size);
    const float c = std::cos(desc.GetAngle0()), s = std::sin(desc.GetAngle0());
    naive.See(
        Exact(Vector2(desc.m_vPos + desc.m_fRadius * Vector2(c, std::copysign(std::sqrt(1.0f - c * c), s)))),
        exact.At(exact.m_fAngle0), 2 * g_fUlp * size);
    Vector2 t0, t1;
    desc.GetTangents(t0, t1);
    tangents.See(Exact(t0), Left(u0), g_fUlp);
    tangents.See(CFifty(-1) * Exact(t1), Left(u1), g_fUlp);
    arc.GetTangents(t0, t1);
    atEnds.See(Exact(t0), Left(u0), 4 * g_fUlp * size / r);
    atEnds.See(CFifty(-1) * Exact(t1), Left(u1), 4 * g_fUlp * size / r);
    if (arc.IsFullCircle()) return;
    span.See(abs(arc.GetSpan() - exact.m_fSpan), 6 * g_fUlp);
    const CFifty off = Turn(CFifty(arc.GetAngle1()) - end1);
    angle1.See(off < 3 ? off : CFifty(2 * Pi() - off), 12 * g_fUlp);
  });
}

// On the end rays and beside them, around the centre, and anywhere.
Vector2 AnyPointFor(CRandom& random, const CArc& arc) {
  const Vector2& end = random.Coin() ? arc.GetEndPt0() : arc.GetEndPt1();
  const Vector2 c = arc.GetPos();
  switch (random.Below(4)) {
  case 0: return Neighbour(random, end, 4);
  case 1: return c + random.Scale(-10, 10) * Vector2(end - c);
  case 2: return c - random.Scale(-10, 10) * Vector2(end - c);
  default: return c + AnyWay(random, arc.GetRadius() * random.Scale(-20, 8));
  }
}

TEST(ArcBounds, PtInSectorAndClosestPt) {
  CKept sector("CArc::PtInSector", 10000), distance("Distance of CArc::ClosestPt", 10000),
      on("CArc::ClosestPt off the arc", 10000);
  CBroken naive("PtInSector by angles from -pi to pi"), naiveClosest("Closest point by those angles");
  ForEachCase(1302, 3 * g_nArcBoundsTrials, [&](CRandom& random, int) {
    const CArcDesc desc = AnyArc(random);
    const CArc arc(desc);
    const CArcOracle exact = Exactly(desc);
    const Vector2 q = AnyPointFor(random, arc);
    if (q == arc.GetPos() || arc.IsFullCircle()) return;
    const CVec eq = Exact(q);
    const CFifty inside = exact.Inside(eq), bound = 10 * g_fUlp * Size(desc);
    sector.SeeAnswer(arc.PtInSector(q), inside, bound / exact.m_fRadius);

    const CVec best = exact.Closest(eq), is = Exact(arc.ClosestPt(q));
    const CFifty far = 2 * g_fUlp * Gap(eq, exact.m_vCenter);
    distance.See(abs(Gap(eq, is) - Gap(eq, best)), bound + far);
    on.See(is, exact.Closest(is), bound);

    const Vector2 v = q - arc.GetPos();
    const float angle = std::atan2(v.y(), v.x());
    naive.SeeAnswer(arc.GetAngle0() <= angle && angle <= arc.GetAngle1(), inside, bound / exact.m_fRadius);
    const float clamped = std::min(std::max(angle, arc.GetAngle0()), arc.GetAngle1());
    const CVec naiveIs = Exact(Vector2(arc.GetPos() + arc.GetRadius() * AngleToVector(clamped)));
    naiveClosest.See(abs(Gap(eq, naiveIs) - Gap(eq, best)), bound + far);
  });
}

// No error at all on this side: what is on an end ray is never outside.
TEST(ArcBounds, EndRaysBelongToTheSector) {
  int lost = 0;
  ForEachCase(1303, g_nArcBoundsTrials, [&](CRandom& random, int) {
    CArcDesc desc = AnyArc(random);
    const CArc anywhere(desc);
    ASSERT_TRUE(anywhere.PtInSector(anywhere.GetEndPt0()) && anywhere.PtInSector(anywhere.GetEndPt1()));
    desc.m_vPos = Vector2::Zero(); // there the ray can be followed without rounding
    const CArc arc(desc);
    const float far = std::ldexp(1.0f, static_cast<int>(random.Below(40)) - 20);
    for (const Vector2& end : {arc.GetEndPt0(), arc.GetEndPt1()}) {
      if (Vector2(far * end) / far != end) continue; // a denormal would be rounded
      ASSERT_TRUE(arc.PtInSector(far * end));
      const float angle = NormalizeAngle(std::atan2(end.y(), end.x()));
      const float past = NormalizeAngle(angle - arc.GetAngle0()),
                  span = NormalizeAngle(desc.GetAngle1() - desc.GetAngle0());
      lost += !arc.IsFullCircle() && past > span;
    }
  });
  EXPECT_GT(lost, 0); // by angles in [0, 2 pi)
}

} // namespace
} // namespace Shapes::Bounds
