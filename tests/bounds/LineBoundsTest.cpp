// SPDX-License-Identifier: MIT
// The bounds of Line.h and LineSeg.h. p is the point that defines the line: of a segment its end 0.
#include "../Numbers.h"
#include "Inputs.h"
#include "Worst.h"

#include <Shapes/LineSeg.h>

#include "traps/Traps.h"

namespace Shapes::Bounds {
namespace {

constexpr int g_nLineBoundsTrials = 20000;

// From the gradient of the line and the one across it.
Vector2 NaiveClosestPt(const Vector2& p, float m, const Vector2& q) {
  const float m1 = -1.0f / m, b0 = p.y() - p.x() * m, b1 = q.y() - q.x() * m1;
  const float x = (b1 - b0) / (m - m1);
  return {x, m * x + b0};
}

CVec Along(float m) { return std::isinf(m) ? CVec{0, 1} : Unit(CVec{1, m}); }

float AnyGradient(CRandom& random) { return random.Below(20) ? random.SignedScale(-60, 60) : g_fInf; }

CLineSegDesc AnySegment(CRandom& random) {
  const float size = AnySize(random);
  const Vector2 p0 = AnyPlace(random, size);
  const Vector2 p1 = p0 + AnyWay(random, size);
  return CLineSegDesc(p0, p1);
}

TEST(LineBounds, ClosestPtOfALine) {
  CKept worst("CLine::ClosestPt", g_nLineBoundsTrials);
  CBroken naive("CLine::ClosestPt by gradients");
  ForEachCase(1101, g_nLineBoundsTrials, [&](CRandom& random, int) {
    const float size = AnySize(random), m = AnyGradient(random);
    const Vector2 p = AnyPlace(random, size);
    const Vector2 q = p + AnyWay(random, size);
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
    const float size = AnySize(random), m0 = AnyGradient(random);
    const float m1 = i % 3 ? AnyGradient(random) : m0 * NearOne(random);
    const Vector2 p = AnyPlace(random, size);
    const Vector2 q = p + AnyWay(random, size);
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
    Vector2 t0, t1;
    seg.GetTangents(t0, t1);
    tangent.See(Exact(t0), t, 2 * g_fUlp);
    tangent.See(CFifty(-1) * Exact(t1), t, 2 * g_fUlp);
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

} // namespace
} // namespace Shapes::Bounds
