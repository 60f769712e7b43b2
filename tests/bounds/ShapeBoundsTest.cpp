// SPDX-License-Identifier: MIT
// The bounds of Line.h, LineSeg.h, Circle.h, Arc.h and Aabb2D.h, and those of CShape::GetAABB.
#include "Inputs.h"
#include "Worst.h"

#include "traps/Traps.h"

namespace Shapes::Bounds {
namespace {

// p is the point that defines a line: of a segment its end 0.

constexpr int g_nLineBoundsTrials = 20000;

// From the gradient of the line and the one across it.
Vector2 NaiveClosestPt(const Vector2& p, float m, const Vector2& q) {
  const float m1 = -1.0f / m, b0 = p.y() - p.x() * m, b1 = q.y() - q.x() * m1;
  const float x = (b1 - b0) / (m - m1);
  return {x, m * x + b0};
}

CVec Along(float m) { return std::isinf(m) ? CVec{0, 1} : Unit(CVec{1, m}); }

float AnyGradient(CRandom& random) { return random.Below(20) ? random.SignedScale(-60, 60) : g_fInf; }

TEST(LineBounds, ClosestPtOfALine) {
  CKept worst("CLine::ClosestPt", g_nLineBoundsTrials);
  CBroken naive("CLine::ClosestPt by gradients");
  ForEachCase(1101, g_nLineBoundsTrials, [&](CRandom& random, int) {
    const auto [size, p, q] = AnyPlaces(random);
    const float m = AnyGradient(random);
    const CVec exact = ClosestOnLine(Exact(p), Along(m), Exact(q));
    const CFifty bound = 4 * g_fUlp * (Norm(Exact(q)) + Gap(Exact(q), Exact(p)));
    worst.See(Exact(CLine(p, m).ClosestPt(q)), exact, bound);
    naive.See(Exact(NaiveClosestPt(p, m, q)), exact, bound);
  });
}

TEST(LineBounds, Intersect) {
  CKept worst("CLine::Intersect", 10000);
  CBroken naive("CLine::Intersect by gradients");
  ForEachCase(1102, g_nLineBoundsTrials, [&](CRandom& random, int i) {
    const auto [size, p, q] = AnyPlaces(random);
    const float m0 = AnyGradient(random), m1 = i % 3 ? AnyGradient(random) : m0 * NearOne(random);
    const CVec d0 = Along(m0), d1 = Along(m1);
    const CFifty sine = abs(Cross(d0, d1));
    if (sine < CFifty(0x1p-20)) return;
    const CVec exact = Crossing(Exact(p), d0, Exact(q), d1);
    const CFifty bound =
        8 * g_fUlp * (Norm(Exact(p)) + Gap(Exact(p), Exact(q)) + Gap(exact, Exact(p))) / sine;
    worst.See(Exact(CLine(p, m0).Intersect(CLine(q, m1))), exact, bound);
    const float b0 = p.y() - p.x() * m0, b1 = q.y() - q.x() * m1, x = (b1 - b0) / (m0 - m1);
    naive.See(Exact(Vector2(x, m0 * x + b0)), exact, bound);
  });
}

// Whether float holds it with all its digits.
bool IsNormal(const CFifty& f) { return abs(f) >= CFifty(0x1p-120) && abs(f) <= CFifty(0x1p120); }

// Gradients and intercepts of anything that has them, against its exact point and direction.
void SeeGradients(const CLine& line, const CVec& p, const CVec& d, CWorst& gradients, CWorst& intercepts) {
  // Of the line x = m y + c, or of its mirror image y = m x + c.
  const auto see = [&](const CFifty& dx, const CFifty& dy, const CFifty& px, const CFifty& py, float gotM,
                       float gotC) {
    if (dy == 0) {
      EXPECT_EQ(gotM, g_fInf);
      EXPECT_EQ(gotC, g_fInf);
      return;
    }
    const CFifty m = dx / dy;
    if (m == 0 || IsNormal(m)) gradients.See(abs(gotM - m), 3 * g_fUlp * abs(m));
    if (IsNormal(m) && IsNormal(m * py))
      intercepts.See(abs(gotC - (px - m * py)), 4 * g_fUlp * (abs(px) + abs(m * py)));
  };
  const CWithoutTraps onPurpose; // those of steep and flat lines may be infinite
  see(d.x, d.y, p.x, p.y, line.GetInverseGradient(), line.GetXIntercept());
  see(d.y, d.x, p.y, p.x, line.GetGradient(), line.GetYIntercept());
}

TEST(LineBounds, GradientsAndIntercepts) {
  CKept gradients("Gradients", g_nLineBoundsTrials), intercepts("Intercepts", g_nLineBoundsTrials / 2);
  CBroken naive("Gradient by the angle");
  ForEachCase(1103, g_nLineBoundsTrials, [&](CRandom& random, int i) {
    if (i % 2) {
      const Vector2 p = AnyPlace(random, AnySize(random));
      const float m = i % 4 == 1 ? AnyGradient(random) : random.SignedScale(-120, 119);
      SeeGradients(CLine(p, m), Exact(p), Along(m), gradients, intercepts);
      if (!std::isinf(m)) naive.See(abs(std::tan(std::atan(m)) - CFifty(m)), 3 * g_fUlp * abs(CFifty(m)));
    } else {
      const CLineSegDesc desc = AnySegment(random);
      const CVec p = Exact(desc.GetEndPt0()), d = Exact(desc.GetEndPt1()) - p;
      SeeGradients(CLineSeg(desc), p, d, gradients, intercepts);
      EXPECT_EQ(desc.GetGradient(), CLineSeg(desc).GetGradient());
    }
  });
}

TEST(LineBounds, NormalsTangentsAndMidpointsOfSegments) {
  CKept tangent("CLineSeg::GetTangents", g_nLineBoundsTrials - 2000),
      normal("CLineSeg::GetNormal", g_nLineBoundsTrials - 2000),
      middle("Midpoint of a segment", g_nLineBoundsTrials - 2000),
      unit("Length of CLineSeg::GetNormal", g_nLineBoundsTrials - 2000);
  CBroken naive("Normal by the gradient");
  ForEachCase(1104, g_nLineBoundsTrials, [&](CRandom& random, int) {
    const CLineSegDesc desc = AnySegment(random);
    const CVec p0 = Exact(desc.GetEndPt0()), p1 = Exact(desc.GetEndPt1());
    const CFifty length = Gap(p0, p1);
    if (length == 0) return;
    const CVec t = Unit(p1 - p0);
    const CLineSeg seg(desc);
    // The left end first, of an upright one the lower one, however they are given.
    ASSERT_TRUE(p0.x < p1.x || (p0.x == p1.x && p0.y < p1.y));
    CLineSegDesc swapped;
    swapped.SetEndPts(desc.GetEndPt1(), desc.GetEndPt0());
    Vector2 d0, d1, s0, s1, t0, t1;
    swapped.GetEndPts(d0, d1);
    seg.GetEndPts(s0, s1);
    ASSERT_TRUE(d0 == desc.GetEndPt0() && d1 == desc.GetEndPt1() && swapped.m_vPos == desc.m_vPos);
    ASSERT_TRUE(s0 == d0 && s1 == d1 && seg.GetPos() == desc.m_vPos);
    seg.GetTangents(t0, t1);
    tangent.See(Exact(t0), t, 2 * g_fUlp);
    tangent.See(CFifty(-1) * Exact(t1), t, 2 * g_fUlp);
    ASSERT_TRUE(t0 == -t1 && seg.GetNormal() == perp(t0));
    normal.See(Exact(seg.GetNormal()), Left(t), 2 * g_fUlp);
    normal.See(Exact(desc.GetNormal()), Left(t), 2 * g_fUlp);
    unit.See(abs(Norm(Exact(seg.GetNormal())) - 1), g_fUlp);
    middle.See(Exact(seg.GetPos()), CFifty(0.5) * (p0 + p1), g_fUlp * (Norm(p0) + length));
    const float m =
        (desc.GetEndPt1().y() - desc.GetEndPt0().y()) / (desc.GetEndPt1().x() - desc.GetEndPt0().x());
    naive.See(Exact(Vector2(Vector2(-m, 1.0f) / std::sqrt(1.0f + m * m))), Left(t), 2 * g_fUlp);
  });
}

TEST(LineBounds, ClosestPtOfASegment) {
  CKept worst("CLineSeg::ClosestPt", g_nLineBoundsTrials);
  CBroken naive("CLineSeg::ClosestPt by gradients");
  ForEachCase(1105, g_nLineBoundsTrials, [&](CRandom& random, int i) {
    const CLineSegDesc desc = AnySegment(random);
    const Vector2 &p0 = desc.GetEndPt0(), &p1 = desc.GetEndPt1();
    // Around the segment, at its ends, and far beyond them.
    const Vector2 on = i % 3 == 0   ? p0
                       : i % 3 == 1 ? p1
                                    : Vector2(p0 + random.Uniform(-0.5f, 1.5f) * (p1 - p0));
    const Vector2 away = i % 2 ? Vector2(perp(p1 - p0)) : AnyWay(random, Length(p1 - p0));
    const Vector2 q = on + random.SignedScale(-23, 8) * away;
    const CVec e0 = Exact(p0), e1 = Exact(p1), exact = ClosestOnSegment(e0, e1, Exact(q));
    const CFifty bound = 8 * g_fUlp * (Norm(Exact(q)) + Norm(e0) + Gap(e0, e1));
    worst.See(Exact(CLineSeg(desc).ClosestPt(q)), exact, bound);
    naive.See(Exact(NaiveClosestPt(p0, (p1.y() - p0.y()) / (p1.x() - p0.x()), q)), exact, bound);
  });
}

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
    const float r1 = i % 4 == 0   ? r0
                     : i % 4 == 1 ? r0 * NearOne(random)
                     : i % 8 == 2 ? 0.0f
                                  : r0 * random.Scale(-12, 12);
    const Vector2 c0 = AnyPlace(random, r0);
    const float nested = std::abs(r0 - r1);
    const float away = i % 2 && nested > 0.0f ? nested * NearOne(random) : (r0 + r1) * random.Scale(-8, 8);
    const Vector2 c1 = c0 + AnyWay(random, away);
    const CVec e0 = Exact(c0), e1 = Exact(c1);
    const CFifty f0 = r0, f1 = r1, d = Gap(e0, e1);
    const CCircle a = Circle(c0, r0), b = Circle(c1, r1);
    CLineSegDesc t[2], first;
    const bool got = a.Tangents(&b, t[0], t[1]);
    ASSERT_EQ(a.Tangent(&b, first), got);
    ASSERT_TRUE(first.GetEndPt0() == t[0].GetEndPt0() && first.GetEndPt1() == t[0].GetEndPt1());
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
    for (const float a : {desc.GetAngle0(), desc.GetAngle1()})
      ASSERT_TRUE(a >= 0.0f && CFifty(a) < 2 * Pi());
    Vector2 d0, d1, e0, e1;
    desc.GetEndPts(d0, d1);
    arc.GetEndPts(e0, e1);
    ASSERT_TRUE(d0 == e0 && d1 == e1 && e0 == arc.GetEndPt0() && e1 == arc.GetEndPt1());
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

// From -pi to pi.
bool InByAngles(const CArc& arc, const Vector2& q) {
  const Vector2 v = q - arc.GetPos();
  const float angle = std::atan2(v.y(), v.x());
  return arc.GetAngle0() <= angle && angle <= arc.GetAngle1();
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

    naive.SeeAnswer(InByAngles(arc, q), inside, bound / exact.m_fRadius);
    const Vector2 v = q - arc.GetPos();
    const float angle = std::atan2(v.y(), v.x());
    const float clamped = std::min(std::max(angle, arc.GetAngle0()), arc.GetAngle1());
    const CVec naiveIs = Exact(Vector2(arc.GetPos() + arc.GetRadius() * AngleToVector(clamped)));
    naiveClosest.See(abs(Gap(eq, naiveIs) - Gap(eq, best)), bound + far);
  });
}

// No error at all on this side: what is on an end ray is never outside. The float next to pi is larger than
// pi, and so may be the angle between the rounded ends of half a turn.
TEST(ArcBounds, EndRaysBelongToTheSector) {
  int lost = 0;
  ForEachCase(1303, g_nArcBoundsTrials, [&](CRandom& random, int i) {
    CArcDesc desc = AnyArc(random);
    const float a0 = desc.GetAngle0();
    const std::pair<float, float> halves[] = {{a0, a0 + g_fPi}, {0.0f, g_fPi}, {g_fPi, 0.0f}};
    if (i % 5 == 0) desc.SetAngles(halves[i % 3].first, halves[i % 3].second);
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

// Swapped angles give the complement: what is not in one sector is in the other, and their ends are the same.
TEST(ArcBounds, AnArcAndItsComplementLeaveNothingOut) {
  int lost = 0;
  ForEachCase(1304, 2 * g_nArcBoundsTrials, [&](CRandom& random, int) {
    const CArcDesc desc = AnyArc(random);
    const CArc arc(desc), other(CArcDesc(desc.m_vPos, desc.m_fRadius, desc.GetAngle1(), desc.GetAngle0()));
    if (!other.IsFullCircle()) { // which the complement of a slit may be
      Vector2 t0, t1, s0, s1;
      arc.GetTangents(t0, t1);
      other.GetTangents(s0, s1);
      ASSERT_TRUE(arc.GetEndPt0() == other.GetEndPt1() && arc.GetEndPt1() == other.GetEndPt0());
      ASSERT_TRUE(t0 == -s1 && t1 == -s0);
    }
    const Vector2 q = AnyPointFor(random, arc);
    ASSERT_TRUE(arc.PtInSector(q) || other.PtInSector(q));
    lost += !InByAngles(arc, q) && !InByAngles(other, q);
  });
  EXPECT_GT(lost, 0);
}

constexpr int g_nBoxBoundsTrials = 5000;

TEST(BoxBounds, TranslateWidthAndHeight) {
  CKept moved("CAabb2D::Translate", g_nBoxBoundsTrials),
      width("CAabb2D::GetWidth, GetHt", g_nBoxBoundsTrials);
  CBroken naive("Width of a box that was moved");
  ForEachCase(1401, g_nBoxBoundsTrials, [&](CRandom& random, int) {
    const auto [size, p, q] = AnyPlaces(random);
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
    const auto [size, p, q] = AnyPlaces(random);
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
  ForEachCase(1404, 2 * g_nBoxBoundsTrials, [&](CRandom& random, int) {
    const CArcDesc desc = AnyArc(random);
    const CArc arc(desc);
    const CAabb2D& box = arc.GetAABB();
    const CArcOracle exact = Exactly(desc);
    const bool isHalf = abs(exact.m_fSpan - Pi()) < 1e-5;
    const CFifty bound = 4 * g_fUlp * Size(desc);
    const CVec& c = exact.m_vCenter;
    const CFifty right = c.x + exact.Reach(0), top = c.y + exact.Reach(Pi() / 2),
                 left = c.x - exact.Reach(Pi()), bottom = c.y - exact.Reach(3 * Pi() / 2);
    const auto see = [&](const CFifty& beyond) {
      worst.See(abs(beyond), isHalf && beyond > 0 ? CFifty(3 * bound) : bound);
    };
    see(box.GetBottomRt().x() - right);
    see(box.GetTopLeft().y() - top);
    see(left - box.GetTopLeft().x());
    see(bottom - box.GetBottomRt().y());
    naive.See(abs(std::max(arc.GetEndPt0().x(), arc.GetEndPt1().x()) - right), bound);
  });
}

} // namespace
} // namespace Shapes::Bounds
