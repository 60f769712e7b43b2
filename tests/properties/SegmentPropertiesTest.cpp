// SPDX-License-Identifier: MIT
// Lines and segments: what changes nothing, or turns the answer with the question.
#include "Generators.h"
#include "Properties.h"

#include <cmath>

namespace Shapes::Properties {
namespace {

// The closest point of a segment; the naive ones are the controls.
using CClosestOfSegment = Vector2 (*)(const CLineSegDesc& seg, const Vector2& q);

Vector2 Closest(const CLineSegDesc& seg, const Vector2& q) { return CLineSeg(seg).ClosestPt(q); }
// From the gradient of the segment and the one across it.
Vector2 ByGradients(const CLineSegDesc& seg, const Vector2& q) {
  const Vector2 &p0 = seg.GetEndPt0(), &p1 = seg.GetEndPt1();
  const float m = (p1.y() - p0.y()) / (p1.x() - p0.x()), b = p0.y() - m * p0.x();
  const float m1 = -1.0f / m, x = (q.y() - m1 * q.x() - b) / (m - m1);
  if (x < p0.x()) return p0;
  if (x > p1.x()) return p1;
  return {x, m * x + b};
}
// As if the line went on for ever.
Vector2 OfTheLine(const CLineSegDesc& seg, const Vector2& q) { return CLineSeg(seg).CLine::ClosestPt(q); }
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

// The documented error of CLineSeg::ClosestPt.
double Bound(const CLineSegDesc& seg, const Vector2& q) {
  const Vector2d p0 = Wide(seg.GetEndPt0());
  return 8 * g_fUlp * (Wide(q).norm() + p0.norm() + (Wide(seg.GetEndPt1()) - p0).norm());
}

TEST(SegmentProperties, SwappedEndsGiveTheSameBits) {
  const auto holds = [](bool ordered) {
    return [=] {
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
    };
  };
  ExpectHolds(holds(true));
  ExpectBroken(holds(false));
}

TEST(SegmentProperties, AMirrorThatKeepsTheOrderOfEndsKeepsTheBits) {
  const auto mirror = [](const Vector2& v) { return Vector2(v.x(), -v.y()); };
  const auto holds = [=](bool halfOpen) {
    return [=] {
      const CLineSegDesc seg = *Segment();
      RC_PRE(seg.GetEndPt0().x() != seg.GetEndPt1().x());
      const CLineSegDesc mirrored(mirror(seg.GetEndPt0()), mirror(seg.GetEndPt1()));
      const Vector2 q = Beside(seg);
      RC_ASSERT(Closest(mirrored, mirror(q)) == mirror(Closest(seg, q)));
      // The front is up on either side of the mirror; the control has it to the right of a falling segment.
      const auto normal = [&](const CLineSegDesc& s) {
        const Vector2 n = s.GetNormal();
        return halfOpen && n.x() > 0.0f ? Vector2(-n) : n;
      };
      RC_ASSERT(normal(mirrored) == Vector2(-mirror(normal(seg))));
    };
  };
  ExpectHolds(holds(false));
  ExpectBroken(holds(true));
}

TEST(SegmentProperties, AQuarterTurnThatKeepsTheOrderOfEndsKeepsTheBits) {
  const auto holds = [](CClosestOfSegment closest) {
    return [=] {
      const CLineSegDesc seg = *Segment();
      // Falling segments keep it counterclockwise, rising ones clockwise.
      RC_PRE(seg.GetEndPt0() != seg.GetEndPt1());
      const bool falls = seg.GetEndPt0().y() >= seg.GetEndPt1().y();
      const auto turned = [=](const Vector2& v) { return falls ? perp(v) : Vector2(-perp(v)); };
      const CLineSegDesc other(turned(seg.GetEndPt0()), turned(seg.GetEndPt1()));
      const Vector2 q = Beside(seg);
      RC_ASSERT(closest(other, turned(q)) == turned(closest(seg, q)));
      RC_ASSERT(other.GetNormal() == turned(seg.GetNormal()));
    };
  };
  ExpectHolds(holds(Closest));
  ExpectBroken(holds(ByGradients));
}

TEST(SegmentProperties, AnyTurnAndAnyMoveTurnsAndMovesTheClosestPoint) {
  const auto holds = [](CClosestOfSegment closest) {
    return [=] {
      const CLineSegDesc seg = *Segment();
      const Vector2 q = Beside(seg);
      const float angle = *Angle();
      const Vector2 center = *Place(Length(seg.GetEndPt1() - seg.GetEndPt0())), shift = *Place(center.norm());
      const auto moved = [&](const Vector2& v) { return Vector2(RotatePt(v, center, angle) + shift); };
      const CLineSegDesc other(moved(seg.GetEndPt0()), moved(seg.GetEndPt1()));
      const Vector2 is = closest(other, moved(q)), should = moved(closest(seg, q));
      // Both closest points have their errors, and every point that was moved has been rounded twice: a
      // distance to the segment changes by the errors of its ends and of q.
      const double size =
          Wide(center).norm() + Wide(shift).norm() +
          std::max({(Wide(q) - Wide(center)).norm(), (Wide(seg.GetEndPt0()) - Wide(center)).norm(),
                    (Wide(seg.GetEndPt1()) - Wide(center)).norm()});
      const double rounding = 2 * g_fUlp * size,
                   bound = Bound(seg, q) + Bound(other, moved(q)) + 4 * rounding;
      const double before = (Wide(should) - Wide(moved(q))).norm(),
                   after = (Wide(is) - Wide(moved(q))).norm();
      RC_ASSERT(std::abs(after - before) <= bound);
    };
  };
  ExpectHolds(holds(Closest));
  ExpectBroken(holds(ByGradients));
}

TEST(SegmentProperties, APowerOfTwoScalesTheBits) {
  const auto holds = [](CClosestOfSegment closest) {
    return [=] {
      const CLineSegDesc seg = *Segment();
      const Vector2 q = Beside(seg);
      const float s = std::ldexp(1.0f, *Whole(20));
      const CLineSegDesc other(s * seg.GetEndPt0(), s * seg.GetEndPt1());
      RC_ASSERT(closest(other, s * q) == Vector2(s * closest(seg, q)));
      RC_ASSERT(other.GetNormal() == seg.GetNormal());
      RC_ASSERT(Vector2(other.m_vPos) == Vector2(s * seg.m_vPos));
    };
  };
  ExpectHolds(holds(Closest));
  ExpectBroken(holds(WithAnEpsilon));
}

TEST(SegmentProperties, NoPointOfItIsCloserThanTheClosest) {
  const auto holds = [](CClosestOfSegment closest) {
    return [=] {
      const CLineSegDesc seg = *Segment();
      const Vector2 q = Beside(seg);
      const Vector2d p0 = Wide(seg.GetEndPt0()), v = Wide(seg.GetEndPt1()) - p0;
      const Vector2d is = Wide(closest(seg, q));
      double best = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= 1000; ++k)
        best = std::min(best, (p0 + (k / 1000.0) * v - Wide(q)).norm());
      const double bound = Bound(seg, q);
      RC_ASSERT((is - Wide(q)).norm() <= best + bound);
      // And it is one of its points.
      const double share =
          v.squaredNorm() > 0.0 ? std::clamp((is - p0).dot(v) / v.squaredNorm(), 0.0, 1.0) : 0.0;
      RC_ASSERT((p0 + share * v - is).norm() <= bound);
    };
  };
  ExpectHolds(holds(Closest));
  ExpectBroken(holds(OfTheLine));
}

TEST(SegmentProperties, NormalsAreUnitVectors) {
  const auto holds = [](Vector2 (*unit)(const Vector2&)) {
    return [=] {
      const Vector2 v = *AnyFinite();
      RC_ASSERT(std::abs(Wide(unit(v)).norm() - 1.0) <= g_fUlp);
      const CLineSegDesc seg = *Segment();
      RC_ASSERT(std::abs(Wide(seg.GetNormal()).norm() - 1.0) <= g_fUlp);
    };
  };
  ExpectHolds(holds([](const Vector2& v) { return Normalize(v); }));
  ExpectBroken(holds([](const Vector2& v) { return Vector2(v / std::sqrt(v.x() * v.x() + v.y() * v.y())); }));
}

} // namespace
} // namespace Shapes::Properties
