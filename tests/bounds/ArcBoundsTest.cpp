// SPDX-License-Identifier: MIT
// The bounds of Arc.h.
#include "Inputs.h"
#include "Worst.h"

#include <Shapes/Arc.h>

#include <cmath>

namespace Shapes::Bounds {
namespace {

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
  CRandom random(1301);
  CWorst ends("CArc::GetEndPts"), tangents("CArcDesc::GetTangents"), atEnds("CArc::GetTangents"),
      span("CArc::GetSpan"), angle1("CArc::GetAngle1"), naive("Ends of an arc by a root");
  for (int i = 0; i < g_nArcBoundsTrials; ++i) {
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
    if (arc.IsFullCircle()) continue;
    span.See(abs(arc.GetSpan() - exact.m_fSpan), 6 * g_fUlp);
    const CFifty off = Turn(CFifty(arc.GetAngle1()) - end1);
    angle1.See(off < 3 ? off : CFifty(2 * Pi() - off), 12 * g_fUlp);
  }
  for (const CWorst* pWorst : {&ends, &tangents, &atEnds, &span, &angle1})
    pWorst->ExpectKept(4000);
  naive.ExpectBroken();
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
  CRandom random(1302);
  CWorst sector("CArc::PtInSector"), distance("Distance of CArc::ClosestPt"),
      on("CArc::ClosestPt off the arc"), naive("PtInSector by angles from -pi to pi"),
      naiveClosest("Closest point by those angles");
  for (int i = 0; i < 3 * g_nArcBoundsTrials; ++i) {
    const CArcDesc desc = AnyArc(random);
    const CArc arc(desc);
    const CArcOracle exact = Exactly(desc);
    const Vector2 q = AnyPointFor(random, arc);
    if (q == arc.GetPos() || arc.IsFullCircle()) continue;
    const CVec eq = Exact(q);
    const CFifty inside = exact.Inside(eq), bound = 10 * g_fUlp * Size(desc);
    const auto see = [&](CWorst& worst, bool is) {
      worst.See(is == (inside >= 0) ? CFifty(0) : CFifty(abs(inside)), bound / exact.m_fRadius);
    };
    see(sector, arc.PtInSector(q));

    const CVec best = exact.Closest(eq), is = Exact(arc.ClosestPt(q));
    const CFifty far = 2 * g_fUlp * Gap(eq, exact.m_vCenter);
    distance.See(abs(Gap(eq, is) - Gap(eq, best)), bound + far);
    on.See(is, exact.Closest(is), bound);

    const Vector2 v = q - arc.GetPos();
    const float angle = std::atan2(v.y(), v.x());
    const bool naiveIn = arc.GetAngle0() <= angle && angle <= arc.GetAngle1();
    see(naive, naiveIn);
    const float clamped = std::min(std::max(angle, arc.GetAngle0()), arc.GetAngle1());
    const CVec naiveIs = Exact(Vector2(arc.GetPos() + arc.GetRadius() * AngleToVector(clamped)));
    naiveClosest.See(abs(Gap(eq, naiveIs) - Gap(eq, best)), bound + far);
  }
  for (const CWorst* pWorst : {&sector, &distance, &on})
    pWorst->ExpectKept(10000);
  naive.ExpectBroken();
  naiveClosest.ExpectBroken();
}

// No error at all on this side: what is on an end ray is never outside.
TEST(ArcBounds, EndRaysBelongToTheSector) {
  CRandom random(1303);
  int lost = 0;
  for (int i = 0; i < g_nArcBoundsTrials; ++i) {
    CArcDesc desc = AnyArc(random);
    const CArc anywhere(desc);
    ASSERT_TRUE(anywhere.PtInSector(anywhere.GetEndPt0()) && anywhere.PtInSector(anywhere.GetEndPt1()));
    desc.m_vPos = Vector2::Zero(); // there the ray can be followed without rounding
    const CArc arc(desc);
    const float far = std::ldexp(1.0f, static_cast<int>(random.Below(40)) - 20);
    for (const Vector2& end : {arc.GetEndPt0(), arc.GetEndPt1()}) {
      if (Vector2(far * end) / far != end) continue; // a denormal would be rounded
      ASSERT_TRUE(arc.PtInSector(far * end)) << "seed " << random.GetSeed() << " trial " << i;
      const float angle = NormalizeAngle(std::atan2(end.y(), end.x()));
      const float past = NormalizeAngle(angle - arc.GetAngle0()),
                  span = NormalizeAngle(desc.GetAngle1() - desc.GetAngle0());
      lost += !arc.IsFullCircle() && past > span;
    }
  }
  EXPECT_GT(lost, 0); // by angles in [0, 2 pi)
}

} // namespace
} // namespace Shapes::Bounds
