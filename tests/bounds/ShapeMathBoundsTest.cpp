// SPDX-License-Identifier: MIT
// The bounds of ShapeMath.h, CShape::Rotate and GetSurfaceVelocity.
#include "Inputs.h"
#include "Worst.h"

namespace Shapes::Bounds {
namespace {

constexpr int g_nShapeMathBoundsTrials = 10000;

// Every finite float alike, denormals included; a component may be 0.
Vector2 AnyVector(CRandom& random, int leastExp, int mostExp) {
  const float x = random.Below(16) ? random.SignedScale(leastExp, mostExp) : 0.0f;
  const float y = random.Below(2) ? random.SignedScale(leastExp, mostExp) : x * NearOne(random);
  return {x, y};
}

TEST(ShapeMathBounds, Cross) {
  CKept worst("Cross", g_nShapeMathBoundsTrials);
  CBroken single("Cross from a sum of products that were not rounded apart");
  ForEachCase(1001, g_nShapeMathBoundsTrials, [&](CRandom& random, int i) {
    const Vector2 a = AnyVector(random, -80, 60);
    const Vector2 b = i % 2 ? Vector2(NearOne(random) * a) : AnyVector(random, -80, 60);
    const CVec ea = Exact(a), eb = Exact(b);
    const CFifty bound = g_fUlp * (abs(ea.x * eb.y) + abs(ea.y * eb.x)) + CFifty(0x1p-149);
    worst.See(abs(Shapes::Cross(a, b) - Cross(ea, eb)), bound);
    // By the angle between them.
    const float angle = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
    single.See(abs(a.norm() * b.norm() * std::sin(angle) - Cross(ea, eb)), bound);
    ASSERT_EQ(Shapes::Cross(a, a), 0.0f);
  });
}

TEST(ShapeMathBounds, LengthAndNormalize) {
  CKept length("Length", 9000), unit("Normalize", 9000), one("Length of Normalize", 9000);
  CBroken squares("Length by float squares"), quotient("Normalize by float squares");
  ForEachCase(1002, g_nShapeMathBoundsTrials, [&](CRandom& random, int i) {
    const Vector2 v = i % 2 ? AnyVector(random, -149, 126) : AnyWay(random, AnySize(random));
    if (v == Vector2::Zero()) return;
    const CVec e = Exact(v);
    const CFifty d = Norm(e);
    const CFifty bound = g_fUlp * d + CFifty(0x1p-149);
    length.See(abs(Length(v) - d), bound);
    squares.See(abs(std::sqrt(v.x() * v.x() + v.y() * v.y()) - d), bound);
    const Vector2 u = Normalize(v);
    unit.SeeEach(u, Unit(e), 1, 0x1p-149);
    quotient.SeeEach(v / std::sqrt(v.x() * v.x() + v.y() * v.y()), Unit(e), 1, 0x1p-149);
    one.See(abs(Norm(Exact(u)) - 1), g_fUlp);
  });
}

TEST(ShapeMathBounds, ParallelComponent) {
  CKept worst("ParallelComponent", 9000);
  CBroken naive("ParallelComponent by w.w");
  ForEachCase(1003, g_nShapeMathBoundsTrials, [&](CRandom& random, int i) {
    const Vector2 v = AnyWay(random, AnySize(random));
    const Vector2 w = i % 2 ? AnyVector(random, -140, 120) : Vector2(NearOne(random) * perp(v));
    if (w == Vector2::Zero()) return;
    const CVec ev = Exact(v), ew = Exact(w), exact = (Dot(ev, ew) / Dot(ew, ew)) * ew;
    worst.See(Exact(ParallelComponent(v, w)), exact, 3 * g_fUlp * Norm(ev));
    naive.See(Exact(Vector2((v.dot(w) / w.dot(w)) * w)), exact, 3 * g_fUlp * Norm(ev));
  });
}

TEST(ShapeMathBounds, RotatePt) {
  CKept worst("RotatePt", g_nShapeMathBoundsTrials);
  CBroken naive("RotatePt in float");
  ForEachCase(1004, g_nShapeMathBoundsTrials, [&](CRandom& random, int i) {
    const auto [size, center, p] = AnyPlaces(random);
    const float angle = i % 50 ? AnyAngle(random) : random.SignedScale(10, 120);
    const CVec exact = Turned(Exact(p), Exact(center), angle);
    const CFifty bound = g_fUlp * (Norm(Exact(center)) + Gap(Exact(p), Exact(center)));
    worst.See(Exact(RotatePt(p, center, angle)), exact, bound);
    // About the origin, then to where the centre belongs.
    const float c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](const Vector2& v) {
      return Vector2(c * v.x() - s * v.y(), s * v.x() + c * v.y());
    };
    naive.See(Exact(Vector2(turned(p) + (center - turned(center)))), exact, bound);
  });
}

TEST(ShapeMathBounds, NormalizeAngle) {
  CKept worst("NormalizeAngle", g_nShapeMathBoundsTrials);
  CBroken naive("NormalizeAngle in float");
  ForEachCase(1005, g_nShapeMathBoundsTrials, [&](CRandom& random, int i) {
    float angle = i % 2 ? AnyAngle(random) : random.SignedScale(-20, 28);
    if (i % 4 == 0) {
      const int exponent = static_cast<int>(random.Below(28));
      const float turns = std::round(random.SignedScale(0, exponent));
      angle = Neighbour(random, static_cast<float>(static_cast<double>(turns) * 6.283185307179586), 2);
    }
    const CFifty exact = Turn(angle);
    const auto see = [&](CWorst& w, float is) {
      // An angle so close below a whole turn that it rounds to it becomes 0.
      if (is == 0.0f && exact > 6) return w.See(2 * Pi() - exact, g_fUlp);
      w.See(abs(is - exact), g_fUlp * exact);
    };
    const float got = NormalizeAngle(angle);
    ASSERT_TRUE(got >= 0.0f && CFifty(got) < 2 * Pi()) << angle;
    see(worst, got);
    const float rest = std::fmod(angle, g_fTwoPi);
    see(naive, rest < 0.0f ? rest + g_fTwoPi : rest);
  });
}

TEST(ShapeMathBounds, AngleToVector) {
  CKept worst("AngleToVector", g_nShapeMathBoundsTrials);
  CBroken naive("AngleToVector by a root");
  ForEachCase(1006, g_nShapeMathBoundsTrials, [&](CRandom& random, int i) {
    const float angle = i % 50 ? AnyAngle(random) : random.SignedScale(10, 120);
    const CVec exact = AtAngle(angle);
    worst.SeeEach(AngleToVector(angle), exact, 1);
    const float c = std::cos(angle);
    naive.SeeEach({c, std::copysign(std::sqrt(1.0f - c * c), std::sin(angle))}, exact, 1);
  });
}

constexpr int g_nRotationBoundsTrials = 5000;

// Each from its pose at construction, whatever it has turned before.
TEST(RotationBounds, Rotate) {
  const int n = g_nRotationBoundsTrials;
  CKept points("CKinematicPoint::Rotate", n), circles("CKinematicCircle::Rotate", n),
      segments("CKinematicLineSeg::Rotate", n), arcs("CKinematicArc::Rotate", n),
      normals("Normal and tangent of a turned segment", n), closest("Closest point of a turned segment", n),
      angles("Angle 0 of a turned arc", n), sectors("Sector of a turned arc", 4000),
      boxes("Box of a turned arc", n);
  CBroken naive("Rotate in eight parts");
  int reordered = 0;
  ForEachCase(1501, n, [&](CRandom& random, int i) {
    const CPlaces places = AnyPlaces(random);
    const Vector2 &center = places.m_vPos, &p = places.m_vOther;
    const float size = places.m_fSize;
    const Vector2 q = p + AnyWay(random, size), anywhere = p + AnyWay(random, size * random.Scale(-20, 8));
    const float angle = i % 2 ? AnyAngle(random) : random.SignedScale(0, 29);
    const auto turn = [&](CShape& shape) {
      shape.Rotate(q, 1.0f);
      shape.Rotate(center, angle);
    };
    const auto see = [&](CWorst& worst, const Vector2& is, const Vector2& was) {
      worst.See(Exact(is), Turned(Exact(was), Exact(center), angle),
                3 * g_fUlp * (Norm(Exact(center)) + Gap(Exact(was), Exact(center))));
    };
    CKinematicPoint point{CPointDesc(p)};
    turn(point);
    see(points, point.GetPos(), p);

    CKinematicCircle circle{CCircleDesc(p, size)};
    turn(circle);
    see(circles, circle.GetPos(), p);

    const CLineSegDesc desc(p, q);
    CKinematicLineSeg seg(desc);
    turn(seg);
    const Vector2 &end0 = seg.GetEndPt0(), &end1 = seg.GetEndPt1();
    EXPECT_LE(end0.x(), end1.x());
    const CVec t0 = Turned(Exact(desc.GetEndPt0()), Exact(center), angle);
    const bool swapped = Gap(Exact(end0), t0) > Gap(Exact(end1), t0);
    see(segments, swapped ? end1 : end0, desc.GetEndPt0());
    see(segments, swapped ? end0 : end1, desc.GetEndPt1());
    // The tangent leads from end to end. The normal turns along, whichever end comes first.
    Vector2 tangent, back;
    seg.GetTangents(tangent, back);
    const CVec e0 = Exact(end0), e1 = Exact(end1), along = Unit(e1 - e0);
    normals.See(Exact(tangent), along, 2 * g_fUlp);
    normals.See(Exact(seg.GetNormal()), swapped ? CFifty(-1) * Left(along) : Left(along), 2 * g_fUlp);
    closest.See(Exact(seg.ClosestPt(anywhere)), ClosestOnSegment(e0, e1, Exact(anywhere)),
                8 * g_fUlp * (Norm(Exact(anywhere)) + Norm(e0) + Gap(e0, e1)));
    reordered += swapped;

    CArcDesc arcDesc = AnyArc(random);
    arcDesc.m_vPos = p;
    arcDesc.m_fRadius = size;
    const CArc still(arcDesc);
    CKinematicArc arc(arcDesc);
    turn(arc);
    see(arcs, arc.GetPos(), p);
    see(arcs, arc.GetEndPt0(), still.GetEndPt0());
    see(arcs, arc.GetEndPt1(), still.GetEndPt1());
    ASSERT_TRUE(arc.GetSpan() == still.GetSpan() && arc.IsFullCircle() == still.IsFullCircle());
    ASSERT_TRUE(arc.PtInSector(arc.GetEndPt0()) && arc.PtInSector(arc.GetEndPt1()));
    const CFifty start = arcDesc.GetAngle0(), off = Turn(arc.GetAngle0() - (start + CFifty(angle)));
    angles.See(std::min(off, CFifty(2 * Pi() - off)), g_fUlp * (start + Turn(angle)));
    const CArcOracle exact{Exact(arc.GetPos()), size, start + CFifty(angle), still.GetSpan()};
    const CFifty reach = Norm(Exact(center)) + Norm(Exact(p)) + 2 * CFifty(size);
    const Vector2 inWorld = arc.GetPos() + (anywhere - p);
    if (!arc.IsFullCircle() && inWorld != arc.GetPos())
      sectors.SeeAnswer(arc.PtInSector(inWorld), exact.Inside(Exact(inWorld)), 16 * g_fUlp * reach / size);
    const CAabb2D& box = arc.GetAABB();
    boxes.See(abs(box.GetTopLeft().y() - (exact.m_vCenter.y + exact.Reach(Pi() / 2))), 4 * g_fUlp * reach);
    boxes.See(abs(box.GetBottomRt().x() - (exact.m_vCenter.x + exact.Reach(0))), 4 * g_fUlp * reach);
    boxes.See(abs(box.GetTopLeft().x() - (exact.m_vCenter.x - exact.Reach(Pi()))), 4 * g_fUlp * reach);
    boxes.See(abs(box.GetBottomRt().y() - (exact.m_vCenter.y - exact.Reach(3 * Pi() / 2))),
              4 * g_fUlp * reach);

    Vector2 turned = p;
    for (int k = 0; k < 8; ++k)
      turned = RotatePt(turned, center, angle / 8.0f);
    see(naive, turned, p);
  });
  EXPECT_GT(reordered, n / 4);
}

TEST(RotationBounds, GetSurfaceVelocity) {
  CKept worst("CShape::GetSurfaceVelocity", g_nRotationBoundsTrials);
  CBroken naive("Surface velocity by a short turn");
  ForEachCase(1502, g_nRotationBoundsTrials, [&](CRandom& random, int) {
    const float size = AnySize(random);
    CPointDesc desc(AnyPlace(random, size));
    desc.m_vRotCenter = AnyPlace(random, size);
    desc.m_fRotSpeed = random.SignedScale(-10, 10);
    const CKinematicPoint point(desc);
    const Vector2 q = desc.m_vRotCenter + AnyWay(random, size);
    const CVec exact = (2 * Pi() * CFifty(desc.m_fRotSpeed)) * Left(Exact(q) - Exact(desc.m_vRotCenter));
    worst.SeeEach(point.GetSurfaceVelocity(q), exact, 2);
    const float dt = 0x1p-10f / std::abs(desc.m_fRotSpeed);
    naive.SeeEach((RotatePt(q, desc.m_vRotCenter, g_fTwoPi * desc.m_fRotSpeed * dt) - q) / dt, exact, 2);
  });
}

} // namespace
} // namespace Shapes::Bounds
