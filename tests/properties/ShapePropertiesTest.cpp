// SPDX-License-Identifier: MIT
// Circles, arcs and segments: what changes nothing, or turns the answer with the question. How exact the
// answers are, bounds/ holds against 50 digits.
#include "Generators.h"
#include "Moved.h"
#include "Properties.h"

namespace Shapes::Properties {
namespace {

// The closest point of a shape; the naive ones are the controls.
template <class TDesc>
using CClosest = Vector2 (*)(const TDesc& desc, const Vector2& q);

// A point around a circle: beside its rim, near the centre, or far away.
Vector2 Beside(const CCircleDesc& desc) {
  const float away = *rc::gen::oneOf(NearOne(), Scale(8));
  return desc.m_vPos + *Way(away * desc.m_fRadius);
}

Vector2 Closest(const CCircleDesc& desc, const Vector2& q) { return CCircle(desc).ClosestPt(q); }
// From the centre along the gradient.
Vector2 ByGradient(const CCircleDesc& desc, const Vector2& q) {
  const Vector2 v = q - desc.m_vPos;
  const float m = v.y() / v.x(), x = std::copysign(desc.m_fRadius / std::sqrt(1.0f + m * m), v.x());
  return desc.m_vPos + Vector2(x, m * x);
}
// A place closer to the centre than a millimetre is in it.
Vector2 WithAnEpsilon(const CCircleDesc& desc, const Vector2& q) {
  return (q - desc.m_vPos).norm() < 1e-3f ? Vector2(desc.m_vPos + desc.m_fRadius * Vector2(0.0f, 1.0f))
                                          : Closest(desc, q);
}

TEST(CircleProperties, AQuarterTurnAndAMirrorKeepTheBits) {
  ExpectHolds<CClosest<CCircleDesc>>(Closest, ByGradient, 5000, [](CClosest<CCircleDesc> closest) {
    const CCircleDesc desc = *Ring();
    const Vector2 q = Beside(desc);
    RC_PRE(q != desc.m_vPos); // the centre has a fallback, which is up
    const Vector2 is = closest(desc, q);
    RC_ASSERT(closest(CCircleDesc(perp(desc.m_vPos), desc.m_fRadius), perp(q)) == perp(is));
    RC_ASSERT(closest(CCircleDesc(MirrorY(desc.m_vPos), desc.m_fRadius), MirrorY(q)) == MirrorY(is));
  });
}

TEST(CircleProperties, APowerOfTwoScalesTheBits) {
  ExpectHolds<CClosest<CCircleDesc>>(Closest, WithAnEpsilon, 5000, [](CClosest<CCircleDesc> closest) {
    const CCircleDesc desc = *Ring();
    const Vector2 q = Beside(desc);
    const float s = std::ldexp(1.0f, *Whole(20));
    const CCircleDesc other(s * desc.m_vPos, s * desc.m_fRadius);
    RC_ASSERT(closest(other, s * q) == Vector2(s * closest(desc, q)));
    Vector2 a0, a1, b0, b1;
    const bool got = CCircle(desc).Tangents(q, a0, a1);
    RC_ASSERT(CCircle(other).Tangents(s * q, b0, b1) == got);
    if (got) RC_ASSERT(b0 == Vector2(s * a0) && b1 == Vector2(s * a1));
  });
}

// Results of differences of coordinates do not change where these are exact.
TEST(CircleProperties, AMoveAmongRepresentablePlacesKeepsTheBits) {
  ExpectHolds(false, true, 5000, [](bool bySquares) {
    const auto place = [] {
      const int x = *Whole(1 << 12), y = *Whole(1 << 12);
      return Vector2(Vector2(static_cast<float>(x), static_cast<float>(y)) / 64.0f);
    };
    const Vector2 c = place(), q = place(), shift = 16.0f * place();
    const float r = Length(q - c) * *rc::gen::oneOf(rc::gen::just(1.0f), NearOne());
    const auto inside = [&](const Vector2& at) {
      const Vector2 center = c + at, p = q + at;
      return bySquares ? p.squaredNorm() - 2.0f * p.dot(center) + center.squaredNorm() < r * r
                       : CCircle(CCircleDesc(center, r)).PtInCircle(p);
    };
    RC_ASSERT(inside(shift) == inside(Vector2::Zero()));
  });
}

// Swapping the angles gives the complement: what is not in one sector is in the other.
TEST(ArcProperties, AnArcAndItsComplementLeaveNothingOut) {
  const auto holds = [](bool (*inSector)(const CArc&, const Vector2&)) {
    return [=] {
      const CArcDesc desc = *AnyArc();
      const CArc arc(desc), other(CArcDesc(desc.m_vPos, desc.m_fRadius, desc.GetAngle1(), desc.GetAngle0()));
      const Vector2 end = *rc::gen::arbitrary<bool>() ? arc.GetEndPt0() : arc.GetEndPt1();
      const Vector2 q =
          *rc::gen::arbitrary<bool>() ? Beside(desc) : Vector2(desc.m_vPos + *Scale(4) * (end - desc.m_vPos));
      RC_ASSERT(inSector(arc, q) || inSector(other, q));
    };
  };
  ExpectHolds(holds([](const CArc& arc, const Vector2& q) { return arc.PtInSector(q); }), 10000);
  ExpectBroken(holds([](const CArc& arc, const Vector2& q) {
    const Vector2 v = q - arc.GetPos();
    const float angle = std::atan2(v.y(), v.x());
    return arc.GetAngle0() <= angle && angle <= arc.GetAngle1();
  }));
}

Vector2 Closest(const CLineSegDesc& seg, const Vector2& q) { return CLineSeg(seg).ClosestPt(q); }
// From the gradient of the segment and the one across it.
Vector2 ByGradient(const CLineSegDesc& seg, const Vector2& q) {
  const Vector2 &p0 = seg.GetEndPt0(), &p1 = seg.GetEndPt1();
  const float m = (p1.y() - p0.y()) / (p1.x() - p0.x()), b = p0.y() - m * p0.x();
  const float m1 = -1.0f / m, x = (q.y() - m1 * q.x() - b) / (m - m1);
  if (x < p0.x()) return p0;
  if (x > p1.x()) return p1;
  return {x, m * x + b};
}
// A segment that is shorter than a millimetre is a point.
Vector2 WithAnEpsilon(const CLineSegDesc& seg, const Vector2& q) {
  return (seg.GetEndPt1() - seg.GetEndPt0()).norm() < 1e-3f ? seg.GetEndPt0() : Closest(seg, q);
}

// A point around a segment: beside it, beside an end, or far away.
Vector2 Beside(const CLineSegDesc& seg) {
  const Vector2 v = seg.GetEndPt1() - seg.GetEndPt0();
  const float share = *rc::gen::oneOf(Between(-0.5f, 1.5f), rc::gen::element(0.0f, 1.0f));
  const float away = *Small(23, -6);
  const bool across = *rc::gen::arbitrary<bool>();
  const Vector2 way = across ? perp(v) : *Way(Length(v));
  return seg.GetEndPt0() + share * v + away * way;
}

TEST(SegmentProperties, SwappedEndsGiveTheSameBits) {
  ExpectHolds(true, false, 5000, [](bool ordered) {
    const CLineSegDesc seg = *Segment();
    const CLineSegDesc swapped(seg.GetEndPt1(), seg.GetEndPt0());
    RC_ASSERT(Closest(swapped, seg.GetEndPt0()) == Closest(seg, seg.GetEndPt0()));
    const Vector2 q = Beside(seg);
    RC_ASSERT(Closest(swapped, q) == Closest(seg, q));
    // The control does not put the ends in order.
    const auto normal = [&](const Vector2& p0, const Vector2& p1) {
      return ordered ? CLineSegDesc(p0, p1).GetNormal() : perp(Normalize(p1 - p0));
    };
    RC_ASSERT(normal(seg.GetEndPt1(), seg.GetEndPt0()) == normal(seg.GetEndPt0(), seg.GetEndPt1()));
  });
}

TEST(SegmentProperties, AMirrorThatKeepsTheOrderOfEndsKeepsTheBits) {
  ExpectHolds(false, true, 5000, [=](bool halfOpen) {
    const CLineSegDesc seg = *Segment();
    RC_PRE(seg.GetEndPt0().x() != seg.GetEndPt1().x());
    const CLineSegDesc mirrored(MirrorY(seg.GetEndPt0()), MirrorY(seg.GetEndPt1()));
    const Vector2 q = Beside(seg);
    RC_ASSERT(Closest(mirrored, MirrorY(q)) == MirrorY(Closest(seg, q)));
    // The front is up on either side of the mirror; the control has it to the right of a falling segment.
    const auto normal = [&](const CLineSegDesc& s) {
      const Vector2 n = s.GetNormal();
      return halfOpen && n.x() > 0.0f ? Vector2(-n) : n;
    };
    RC_ASSERT(normal(mirrored) == Vector2(-MirrorY(normal(seg))));
  });
}

TEST(SegmentProperties, AQuarterTurnThatKeepsTheOrderOfEndsKeepsTheBits) {
  ExpectHolds<CClosest<CLineSegDesc>>(Closest, ByGradient, 5000, [](CClosest<CLineSegDesc> closest) {
    const CLineSegDesc seg = *Segment();
    // Falling segments keep it counterclockwise, rising ones clockwise.
    RC_PRE(seg.GetEndPt0() != seg.GetEndPt1());
    const bool falls = seg.GetEndPt0().y() >= seg.GetEndPt1().y();
    const auto turned = [=](const Vector2& v) { return falls ? perp(v) : Vector2(-perp(v)); };
    const CLineSegDesc other(turned(seg.GetEndPt0()), turned(seg.GetEndPt1()));
    const Vector2 q = Beside(seg);
    RC_ASSERT(closest(other, turned(q)) == turned(closest(seg, q)));
    RC_ASSERT(other.GetNormal() == turned(seg.GetNormal()));
  });
}

TEST(SegmentProperties, APowerOfTwoScalesTheBits) {
  ExpectHolds<CClosest<CLineSegDesc>>(Closest, WithAnEpsilon, 5000, [](CClosest<CLineSegDesc> closest) {
    const CLineSegDesc seg = *Segment();
    const Vector2 q = Beside(seg);
    const float s = std::ldexp(1.0f, *Whole(20));
    const CLineSegDesc other(s * seg.GetEndPt0(), s * seg.GetEndPt1());
    RC_ASSERT(closest(other, s * q) == Vector2(s * closest(seg, q)));
    RC_ASSERT(other.GetNormal() == seg.GetNormal());
    RC_ASSERT(Vector2(other.m_vPos) == Vector2(s * seg.m_vPos));
  });
}

} // namespace
} // namespace Shapes::Properties
