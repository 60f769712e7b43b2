// SPDX-License-Identifier: MIT
// Circles and arcs: closest points, sectors, boxes and tangents.
#include "Generators.h"
#include "Properties.h"

#include <cmath>

namespace Shapes::Properties {
namespace {

double Size(const CCircleDesc& desc) {
  return Wide(desc.m_vPos).norm() + static_cast<double>(desc.m_fRadius);
}

// A point around a circle: beside its rim, near the centre, or far away.
Vector2 Beside(const CCircleDesc& desc) {
  const float away = *rc::gen::oneOf(NearOne(), Scale(8));
  return desc.m_vPos + *Way(away * desc.m_fRadius);
}

using CClosest = Vector2 (*)(const CCircleDesc& desc, const Vector2& q);
Vector2 OnCircle(const CCircleDesc& desc, const Vector2& q) { return CCircle(desc).ClosestPt(q); }
// From the centre along the gradient.
Vector2 ByGradient(const CCircleDesc& desc, const Vector2& q) {
  const Vector2 v = q - desc.m_vPos;
  const float m = v.y() / v.x(), x = std::copysign(desc.m_fRadius / std::sqrt(1.0f + m * m), v.x());
  return desc.m_vPos + Vector2(x, m * x);
}
// What is closer to the centre than a millimetre is in it.
Vector2 WithAnEpsilon(const CCircleDesc& desc, const Vector2& q) {
  return (q - desc.m_vPos).norm() < 1e-3f ? Vector2(desc.m_vPos + desc.m_fRadius * Vector2(0.0f, 1.0f))
                                          : OnCircle(desc, q);
}

TEST(CircleProperties, AQuarterTurnAndAMirrorKeepTheBits) {
  const auto holds = [](CClosest closest) {
    return [=] {
      const CCircleDesc desc = *Ring();
      const Vector2 q = Beside(desc);
      RC_PRE(q != desc.m_vPos); // the centre has a fallback, which is up
      const Vector2 is = closest(desc, q);
      RC_ASSERT(closest(CCircleDesc(perp(desc.m_vPos), desc.m_fRadius), perp(q)) == perp(is));
      const auto mirror = [](const Vector2& v) { return Vector2(-v.x(), v.y()); };
      RC_ASSERT(closest(CCircleDesc(mirror(desc.m_vPos), desc.m_fRadius), mirror(q)) == mirror(is));
    };
  };
  ExpectHolds(holds(OnCircle));
  ExpectBroken(holds(ByGradient));
}

TEST(CircleProperties, APowerOfTwoScalesTheBits) {
  const auto holds = [](CClosest closest) {
    return [=] {
      const CCircleDesc desc = *Ring();
      const Vector2 q = Beside(desc);
      const float s = std::ldexp(1.0f, *Whole(20));
      const CCircleDesc other(s * desc.m_vPos, s * desc.m_fRadius);
      RC_ASSERT(closest(other, s * q) == Vector2(s * closest(desc, q)));
      Vector2 a0, a1, b0, b1;
      const bool got = CCircle(desc).Tangents(q, a0, a1);
      RC_ASSERT(CCircle(other).Tangents(s * q, b0, b1) == got);
      if (got) RC_ASSERT(b0 == Vector2(s * a0) && b1 == Vector2(s * a1));
    };
  };
  ExpectHolds(holds(OnCircle));
  ExpectBroken(holds(WithAnEpsilon));
}

// What needs no more than differences of coordinates does not change where these are exact.
TEST(CircleProperties, AMoveAmongRepresentablePlacesKeepsTheBits) {
  const auto holds = [](bool bySquares) {
    return [=] {
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
    };
  };
  ExpectHolds(holds(false));
  ExpectBroken(holds(true));
}

TEST(CircleProperties, NoPointOfItIsCloserThanTheClosest) {
  const auto holds = [](CClosest closest) {
    return [=] {
      const CCircleDesc desc = *Ring();
      const Vector2 q = Beside(desc);
      RC_PRE(q != desc.m_vPos);
      const double bound = 3 * g_fUlp * Size(desc), r = desc.m_fRadius;
      const Vector2d c = Wide(desc.m_vPos), is = Wide(closest(desc, q));
      double best = std::numeric_limits<double>::infinity();
      for (int k = 0; k < 1000; ++k) {
        const double a = k * (2.0 * 3.14159265358979324 / 1000);
        best = std::min(best, (c + r * Vector2d(std::cos(a), std::sin(a)) - Wide(q)).norm());
      }
      RC_ASSERT((is - Wide(q)).norm() <= best + bound);
      RC_ASSERT(std::abs((is - c).norm() - r) <= bound);
    };
  };
  ExpectHolds(holds(OnCircle), 2000);
  // The control: the far side, by the direction from the point to the centre.
  ExpectBroken(holds([](const CCircleDesc& desc, const Vector2& q) {
    return Vector2(desc.m_vPos + desc.m_fRadius * Normalize(desc.m_vPos - q));
  }));
}

// By angles in [0, 2 pi).
bool InSectorByAngles(const CArc& arc, const Vector2& q) {
  const Vector2 v = q - arc.GetPos();
  return NormalizeAngle(std::atan2(v.y(), v.x()) - arc.GetAngle0()) <= arc.GetSpan();
}

TEST(ArcProperties, TheEndsBelongToTheSector) {
  const auto holds = [](bool (*inSector)(const CArc&, const Vector2&)) {
    return [=] {
      const CArc arc(*AnyArc());
      RC_ASSERT(inSector(arc, arc.GetEndPt0()));
      RC_ASSERT(inSector(arc, arc.GetEndPt1()));
      RC_ASSERT(arc.ClosestPt(arc.GetPos()) == arc.GetEndPt0());
    };
  };
  ExpectHolds(holds([](const CArc& arc, const Vector2& q) { return arc.PtInSector(q); }), 10000);
  ExpectBroken(holds(InSectorByAngles));
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

TEST(ArcProperties, AMirrorAndATurnKeepTheSector) {
  const auto holds = [](bool (*inSector)(const CArc&, const Vector2&)) {
    return [=] {
      const CArcDesc desc = *AnyArc();
      const CArc arc(desc);
      // Else the turned angles may round to the same one, which is a full circle.
      RC_PRE(arc.GetSpan() > 1e-4f && arc.GetSpan() < g_fTwoPi - 1e-4f);
      const Vector2 q = Beside(desc);
      const auto mirror = [](const Vector2& v) { return Vector2(v.x(), -v.y()); };
      const float turn = *Angle();
      const CArc mirrored(
          CArcDesc(mirror(desc.m_vPos), desc.m_fRadius, -desc.GetAngle1(), -desc.GetAngle0()));
      const CArc turned(
          CArcDesc(desc.m_vPos, desc.m_fRadius, desc.GetAngle0() + turn, desc.GetAngle1() + turn));
      // Right for all directions that are farther than that from the ends; the angles are rounded once more
      // each, by up to half an ulp of 2 pi, those that were turned by the ulps of up to 2 pi + 100.
      const double bound = 10 * g_fUlp * Size(desc) / static_cast<double>(desc.m_fRadius);
      const Vector2d v = Wide(q) - Wide(desc.m_vPos);
      RC_PRE(v != Vector2d(Vector2d::Zero()));
      const double twoPi = 6.283185307179586, a = std::atan2(v.y(), v.x()), a0 = desc.GetAngle0(),
                   a1 = desc.GetAngle1();
      const auto off = [=](double end) { return std::abs(std::remainder(a - end, twoPi)); };
      const double margin = std::min(off(a0), off(a1));
      const bool in = arc.PtInSector(q);
      if (margin > bound + 4 * g_fUlp) RC_ASSERT(inSector(mirrored, mirror(q)) == in);
      const Vector2 p = RotatePt(q, desc.m_vPos, turn);
      const double rounding = g_fUlp * (Size(desc) / v.norm() + 1);
      if (margin > bound + rounding + 128 * g_fUlp) RC_ASSERT(inSector(turned, p) == in);
    };
  };
  ExpectHolds(holds([](const CArc& arc, const Vector2& q) { return arc.PtInSector(q); }), 5000);
  ExpectBroken(holds([](const CArc& arc, const Vector2& q) {
    const Vector2 v = q - arc.GetPos();
    const float angle = std::atan2(v.y(), v.x());
    return arc.GetAngle0() <= angle && angle <= arc.GetAngle1();
  }));
}

// In double, from the angles; the samples include both ends.
Vector2d Sample(const CArcDesc& desc, double share) {
  const double a0 = desc.GetAngle0(), a1 = desc.GetAngle1(),
               span = a1 > a0 ? a1 - a0 : a1 - a0 + 6.283185307179586;
  const double a = a0 + share * span;
  return Wide(desc.m_vPos) + static_cast<double>(desc.m_fRadius) * Vector2d(std::cos(a), std::sin(a));
}

TEST(ArcProperties, NoPointOfItIsCloserThanTheClosest) {
  const auto holds = [](bool (*inSector)(const CArc&, const Vector2&)) {
    return [=] {
      const CArcDesc desc = *AnyArc();
      const CArc arc(desc);
      const Vector2 q = Beside(desc);
      RC_PRE(q != desc.m_vPos);
      const Vector2 is = inSector(arc, q) ? arc.CCircle::ClosestPt(q)
                         : Length(q - arc.GetEndPt0()) <= Length(q - arc.GetEndPt1()) ? arc.GetEndPt0()
                                                                                      : arc.GetEndPt1();
      if (arc.PtInSector(q) == inSector(arc, q)) RC_ASSERT(is == arc.ClosestPt(q));
      double best = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= 1000; ++k)
        best = std::min(best, (Sample(desc, k / 1000.0) - Wide(q)).norm());
      const double far = 2 * g_fUlp * (Wide(q) - Wide(desc.m_vPos)).norm();
      RC_ASSERT((Wide(is) - Wide(q)).norm() <= best + 10 * g_fUlp * Size(desc) + far);
    };
  };
  ExpectHolds(holds([](const CArc& arc, const Vector2& q) { return arc.PtInSector(q); }), 2000);
  ExpectBroken(holds([](const CArc& arc, const Vector2& q) {
    const Vector2 v = q - arc.GetPos();
    const float angle = std::atan2(v.y(), v.x());
    return arc.GetAngle0() <= angle && angle <= arc.GetAngle1();
  }));
}

TEST(ArcProperties, TheBoxContainsTenThousandOfItsPoints) {
  const auto holds = [](bool whole) {
    return [=] {
      const CArcDesc desc = *AnyArc();
      const CArc arc(desc);
      const CAabb2D box = whole ? arc.GetAABB() : CAabb2D(arc.GetEndPt0(), arc.GetEndPt1());
      const Vector2d least(box.GetTopLeft().x(), box.GetBottomRt().y()),
          most(box.GetBottomRt().x(), box.GetTopLeft().y());
      double out = -std::numeric_limits<double>::infinity();
      for (int k = 0; k <= 10000; ++k) {
        const Vector2d p = Sample(desc, k / 10000.0);
        out = std::max({out, (least - p).maxCoeff(), (p - most).maxCoeff()});
      }
      RC_ASSERT(out <= 4 * g_fUlp * Size(desc));
    };
  };
  ExpectHolds(holds(true), 2000);
  ExpectBroken(holds(false));
}

TEST(CircleProperties, TangentsTouchAtRightAnglesToTheRadii) {
  const auto holds = [](bool root) {
    return [=] {
      const CCircleDesc desc = *Ring();
      const Vector2 p = Beside(desc);
      const Vector2d c = Wide(desc.m_vPos);
      Vector2 q0, q1;
      RC_PRE(CCircle(desc).Tangents(p, q0, q1));
      if (!root) { // the control: d^2 - r^2 as the length
        const Vector2 v = desc.m_vPos - p;
        const float delta = v.squaredNorm() - desc.m_fRadius * desc.m_fRadius;
        const float a = std::atan2(v.y(), v.x()) + std::atan2(desc.m_fRadius, delta);
        q0 = p + delta * AngleToVector(a);
      }
      const double bound = 10 * g_fUlp * (Wide(p).norm() + (Wide(p) - c).norm());
      for (const Vector2& q : {q0, q1}) {
        const Vector2d radius = Wide(q) - c, way = Wide(q) - Wide(p);
        RC_ASSERT(std::abs(radius.norm() - static_cast<double>(desc.m_fRadius)) <= bound);
        RC_ASSERT(std::abs(radius.dot(way)) <= bound * (radius.norm() + way.norm()));
      }
    };
  };
  ExpectHolds(holds(true));
  ExpectBroken(holds(false));
}

TEST(CircleProperties, CommonTangentsTouchBothAtRightAnglesToTheRadii) {
  const auto holds = [](bool shrunk) {
    return [=] {
      const CCircleDesc a = *Ring();
      const float share = *rc::gen::oneOf(NearOne(), Scale(10), rc::gen::just(1.0f));
      const float r1 = share * a.m_fRadius, nested = std::abs(r1 - a.m_fRadius);
      const float away =
          *rc::gen::oneOf(rc::gen::map(NearOne(), [=](float one) { return one * nested; }),
                          rc::gen::map(Scale(8), [=](float s) { return s * (r1 + a.m_fRadius); }));
      const CCircleDesc b(a.m_vPos + *Way(away), r1);
      const CCircle other(b);
      CLineSegDesc t[2];
      RC_PRE(CCircle(a).Tangents(&other, t[0], t[1]));
      const double bound = 8 * g_fUlp * (Size(a) + Size(b));
      const auto off = [](const CCircleDesc& c, const Vector2d& q) {
        return std::abs((q - Wide(c.m_vPos)).norm() - static_cast<double>(c.m_fRadius));
      };
      for (CLineSegDesc& seg : t) {
        Vector2d qa = Wide(seg.GetEndPt0()), qb = Wide(seg.GetEndPt1());
        if (!shrunk) { // the control: straight across from both centres, which is right for equal radii
          const Vector2 left = perp(Normalize(b.m_vPos - a.m_vPos));
          qa = Wide(a.m_vPos + a.m_fRadius * left);
          qb = Wide(b.m_vPos + b.m_fRadius * left);
        }
        if (std::max(off(a, qa), off(b, qb)) > std::max(off(a, qb), off(b, qa))) std::swap(qa, qb);
        const Vector2d way = qb - qa, ra = qa - Wide(a.m_vPos), rb = qb - Wide(b.m_vPos);
        RC_ASSERT(std::max(off(a, qa), off(b, qb)) <= bound);
        RC_ASSERT(std::abs(way.dot(ra)) <= bound * (way.norm() + ra.norm()));
        RC_ASSERT(std::abs(way.dot(rb)) <= bound * (way.norm() + rb.norm()));
      }
    };
  };
  ExpectHolds(holds(true));
  ExpectBroken(holds(false));
}

} // namespace
} // namespace Shapes::Properties
