// SPDX-License-Identifier: MIT
// Arcs and segments whose angles or ends are swapped. How exact the answers are, bounds/ holds against 50
// digits.
#include "Generators.h"
#include "Properties.h"

namespace Shapes::Properties {
namespace {

// A point around a circle: beside its rim, near the centre, or far away.
Vector2 Beside(const CCircleDesc& desc) {
  const float away = *rc::gen::oneOf(NearOne(), Scale(8));
  return desc.m_vPos + *Way(away * desc.m_fRadius);
}

// Swapping the angles gives the complement: what is not in one sector is in the other, and their ends are the
// same.
TEST(ArcProperties, AnArcAndItsComplementLeaveNothingOut) {
  const auto holds = [](bool (*inSector)(const CArc&, const Vector2&)) {
    return [=] {
      const CArcDesc desc = *AnyArc();
      const CArc arc(desc), other(CArcDesc(desc.m_vPos, desc.m_fRadius, desc.GetAngle1(), desc.GetAngle0()));
      if (!other.IsFullCircle()) { // which the complement of a slit may be
        Vector2 t0, t1, s0, s1;
        arc.GetTangents(t0, t1);
        other.GetTangents(s0, s1);
        RC_ASSERT(arc.GetEndPt0() == other.GetEndPt1() && arc.GetEndPt1() == other.GetEndPt0());
        RC_ASSERT(t0 == -s1 && t1 == -s0);
      }
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
// A point around a segment: beside it, beside an end, or far away.
Vector2 Beside(const CLineSegDesc& seg) {
  const Vector2 v = seg.GetEndPt1() - seg.GetEndPt0();
  const float share = *rc::gen::oneOf(Between(-0.5f, 1.5f), rc::gen::element(0.0f, 1.0f));
  const float away = *Small(23, -6);
  const bool across = *rc::gen::arbitrary<bool>();
  const Vector2 way = across ? perp(v) : *Way(Length(v));
  return seg.GetEndPt0() + share * v + away * way;
}

TEST(SegmentProperties, SwappedEndsGiveTheSameBitsAndTheLeftOneIsFirst) {
  ExpectHolds(true, false, 5000, [](bool ordered) {
    const CLineSegDesc seg = *Segment();
    const CLineSegDesc swapped(seg.GetEndPt1(), seg.GetEndPt0());
    RC_ASSERT(swapped.GetEndPt0() == seg.GetEndPt0() && swapped.GetEndPt1() == seg.GetEndPt1());
    RC_ASSERT(swapped.m_vPos == seg.m_vPos);
    RC_ASSERT(seg.GetEndPt0().x() <= seg.GetEndPt1().x() && seg.GetNormal().y() >= 0.0f);
    const Vector2 q = Beside(seg);
    RC_ASSERT(Closest(swapped, q) == Closest(seg, q));
    // The control does not put the ends in order.
    const auto normal = [&](const Vector2& p0, const Vector2& p1) {
      return ordered ? CLineSegDesc(p0, p1).GetNormal() : perp(Normalize(p1 - p0));
    };
    RC_ASSERT(normal(seg.GetEndPt1(), seg.GetEndPt0()) == normal(seg.GetEndPt0(), seg.GetEndPt1()));
  });
}

} // namespace
} // namespace Shapes::Properties
