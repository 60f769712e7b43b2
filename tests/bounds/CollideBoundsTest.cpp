// SPDX-License-Identifier: MIT
// The bounds of the kernels of src/native/narrowphase/Collide.h, and of the approach speed.
#include "Pairs.h"
#include "Worst.h"

namespace Shapes::Bounds {
namespace {

constexpr int g_nDetectBoundsTrials = 10000;

using Native::CBall;
using Native::CHit;

// The errors of one kernel.
struct CHitErrors {
  CHitErrors(const std::string& name, int least)
      : m_cAnswer(name + ", answer", least),
        m_cPOI(name + ", POI", least),
        m_cNorm(name + ", normal", least),
        m_cUnit(name + ", length of the normal", least),
        m_cSetback(name + ", setback", least),
        m_cBack(name + ", overlap where the setback puts a ball", least) {}

  /// @param bound  of the setback  @param sound  whether that may not put the ball into the shape
  void SeeSetback(CPair pair, const CHit& hit, const CFifty& overlap, const CFifty& bound,
                  bool sound = true) {
    EXPECT_GE(hit.m_fSetback, 0.0f);
    m_cUnit.See(abs(Norm(Exact(hit.m_vNorm)) - 1), g_fUlp);
    m_cSetback.See(abs(hit.m_fSetback - overlap), bound);
    CBall& ball = pair.m_cBall;
    ball.m_vPos += hit.m_fSetback * hit.m_vNorm;
    CHit again;
    const CFifty rounding = g_fUlp * (Norm(Exact(ball.m_vPos)) + 3 * CFifty(ball.m_fRadius));
    m_cBack.See(sound && Meets(pair, again) ? again.m_fSetback : 0, bound + rounding);
  }

  CKept m_cAnswer, m_cPOI, m_cNorm, m_cUnit, m_cSetback, m_cBack;
};

// As the square of a difference.
float NaiveDistance(const Vector2& p, const Vector2& q) {
  return std::sqrt(std::max(0.0f, p.squaredNorm() - 2.0f * p.dot(q) + q.squaredNorm()));
}

TEST(DetectBounds, PointCircle) {
  CHitErrors errors("CollidePointCircle", 5000);
  CBroken naive("Setback from a point by squares");
  ForEachCase(1701, g_nDetectBoundsTrials, [&](CRandom& random, int) {
    const CPair pair = AnyPair(random, eKind::Point);
    const Vector2& point = std::get<CPointDesc>(pair.m_cShape).m_vPos;
    const Vector2& p = pair.m_cBall.m_vPos;
    const float r = pair.m_cBall.m_fRadius;
    const CVec e = Exact(p) - Exact(point);
    const CFifty d = Norm(e);
    CHit hit;
    const bool got = Meets(pair, hit);
    errors.m_cAnswer.SeeAnswer(!got, -(r - d), g_fUlp * r);
    if (!got || d == 0) return;
    errors.m_cPOI.See(Exact(hit.m_vPOI), Exact(point), 0);
    errors.m_cNorm.See(Exact(hit.m_vNorm), Unit(e), 2 * g_fUlp);
    errors.SeeSetback(pair, hit, r - d, 2 * g_fUlp * r);
    naive.See(abs(r - NaiveDistance(p, point) - (r - d)), 2 * g_fUlp * r);
  });
}

// The ball and the other ball, each in the place of the other.
CPair Swapped(const CPair& pair) {
  const auto& other = std::get<CDynamicCircleDesc>(pair.m_cShape);
  const CBall& ball = pair.m_cBall;
  return {CDynamicCircleDesc(ball.m_vPos, ball.m_fRadius, ball.m_vVel),
          {other.m_vPos, other.m_vPos, other.m_vVel, other.m_fRadius}};
}

TEST(DetectBounds, BallBall) {
  CHitErrors errors("CollideBallBall", 5000);
  CBroken naive("Setback of two balls by squares");
  ForEachCase(1702, g_nDetectBoundsTrials, [&](CRandom& random, int) {
    const CPair pair = AnyPair(random, eKind::Ball);
    const auto& other = std::get<CDynamicCircleDesc>(pair.m_cShape);
    const Vector2& p = pair.m_cBall.m_vPos;
    const float r0 = other.m_fRadius, r1 = pair.m_cBall.m_fRadius;
    const CVec e = Exact(p) - Exact(other.m_vPos);
    const CFifty d = Norm(e), r = CFifty(r0) + CFifty(r1);
    CHit hit, swapped;
    const bool got = Meets(pair, hit);
    ASSERT_EQ(Meets(Swapped(pair), swapped), got);
    errors.m_cAnswer.SeeAnswer(!got, -(r - d), 2 * g_fUlp * r);
    if (!got) return;
    ASSERT_TRUE(swapped.m_vNorm == -hit.m_vNorm && swapped.m_fSetback == hit.m_fSetback);
    if (d == 0) return;
    const CVec n = Unit(e);
    errors.m_cPOI.See(Exact(hit.m_vPOI), Exact(other.m_vPos) + CFifty(r0) * n,
                      3 * g_fUlp * (Norm(Exact(other.m_vPos)) + r0));
    errors.m_cNorm.See(Exact(hit.m_vNorm), n, 2 * g_fUlp);
    errors.SeeSetback(pair, hit, r - d, 2 * g_fUlp * r);
    naive.See(abs(r0 + r1 - NaiveDistance(p, other.m_vPos) - (r - d)), 2 * g_fUlp * r);
  });
}

TEST(DetectBounds, LineSegCircle) {
  CHitErrors errors("CollideLineSegCircle", 5000);
  CBroken naive("Setback from a segment by gradients");
  ForEachCase(1703, 2 * g_nDetectBoundsTrials, [&](CRandom& random, int) {
    const CPair pair = AnyPair(random, eKind::LineSeg);
    const auto& seg = std::get<CLineSegDesc>(pair.m_cShape);
    const Vector2 &p0 = seg.GetEndPt0(), &p1 = seg.GetEndPt1(), &p = pair.m_cBall.m_vPos;
    const float r = pair.m_cBall.m_fRadius;
    if (p0 == p1) return;
    const CVec e0 = Exact(p0), e1 = Exact(p1), e = Exact(p), t = Unit(e1 - e0);
    const CFifty s = Dot(e - e0, Left(t)), d0 = Gap(e, e0), d1 = Gap(e, e1);
    CHit hit;
    const bool got = Meets(pair, hit);
    // A ball that meets the segment overlaps it between both ends.
    const CFifty overlap = std::min({CFifty(r - abs(s)), Dot(e - e0, t), CFifty(-Dot(e - e1, t))});
    errors.m_cAnswer.SeeAnswer(!got, -overlap, 3 * g_fUlp * (d0 + d1));
    if (!got || abs(s) <= 3 * g_fUlp * d0) return; // on the segment: either side
    errors.m_cPOI.See(Exact(hit.m_vPOI), ClosestOnSegment(e0, e1, e),
                      8 * g_fUlp * (Norm(e) + Norm(e0) + Gap(e0, e1)));
    errors.m_cNorm.See(Exact(hit.m_vNorm), s > 0 ? Left(t) : CFifty(-1) * Left(t), 2 * g_fUlp);
    const CFifty bound = 3 * g_fUlp * d0 + g_fUlp * r / 2;
    errors.SeeSetback(pair, hit, r - abs(s), bound);
    const float m = (p1.y() - p0.y()) / (p1.x() - p0.x()), b = p0.y() - m * p0.x();
    naive.See(abs(r - std::abs(p.y() - m * p.x() - b) / std::sqrt(1.0f + m * m) - (r - abs(s))), bound);
  });
}

TEST(DetectBounds, ApproachSpeed) {
  CKept worst("CContactDesc::m_fSpeed", 5000);
  CBroken naive("Approach speed as the loss of distance");
  const CBackend& native = *GetBackend(eBackend::Native);
  ForEachCase(1704, g_nDetectBoundsTrials, [&](CRandom& random, int i) {
    const auto [size, from, to] = AnyPlaces(random);
    const float r = size * random.Scale(-10, 2);
    CLineSegDesc desc(from, to);
    desc.m_fRotSpeed = random.SignedScale(-8, 6);
    desc.m_vRotCenter = from + AnyWay(random, size);
    CKinematicLineSeg seg(desc);
    if (from == to) return;
    const Vector2 p = from + random.Uniform(0.1f, 0.9f) * (to - from) + 0.5f * r * seg.GetNormal();
    const Vector2 v =
        i % 2 ? AnyWay(random, AnySize(random)) : Vector2(NearOne(random) * seg.GetSurfaceVelocity(p));
    if (v.norm() > 1e12f) return;
    CDynamicCircle ball(CDynamicCircleDesc(p, r, v));
    CContactDesc c(&seg, &ball);
    if (!native.CollisionDetected(c)) return;
    const CVec e0 = Exact(seg.GetEndPt0()), e1 = Exact(seg.GetEndPt1()), e = Exact(p),
               n = Left(Unit(e1 - e0));
    const CFifty side = Dot(e - e0, n);
    if (abs(side) <= 3 * g_fUlp * Gap(e, e0)) return;
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
  });
}

TEST(DetectBounds, CircleCircle) {
  CHitErrors errors("CollideCircleCircle", 5000);
  CBroken naive("Setback from a ring by d^2 - R^2");
  ForEachCase(1801, g_nDetectBoundsTrials, [&](CRandom& random, int) {
    const CPair pair = AnyPair(random, eKind::Circle);
    const auto& circle = std::get<CCircleDesc>(pair.m_cShape);
    const Vector2 v = pair.m_cBall.m_vPos - circle.m_vPos;
    const float R = circle.m_fRadius, r = pair.m_cBall.m_fRadius;
    const CVec c = Exact(circle.m_vPos), e = Exact(pair.m_cBall.m_vPos) - c;
    const CFifty d = Norm(e), size = CFifty(R) + CFifty(r);
    const bool fits = r < R;
    const CFifty exactGap = fits && d < R ? CFifty(R - d) : CFifty(d - R);
    CHit hit;
    const bool got = Meets(pair, hit);
    errors.m_cAnswer.SeeAnswer(!got, -(r - exactGap), 2 * g_fUlp * size);
    if (!got || d == 0) return;
    const CVec n = Unit(e);
    errors.m_cPOI.See(Exact(hit.m_vPOI), c + CFifty(R) * n, 3 * g_fUlp * (Norm(c) + R));
    errors.SeeSetback(pair, hit, r - exactGap, 2 * g_fUlp * size);
    if (fits && abs(d - R) <= g_fUlp * d) return; // on the ring: either side
    errors.m_cNorm.See(Exact(hit.m_vNorm), fits && d < R ? CFifty(-1) * n : n, 2 * g_fUlp);
    const float naiveGap = std::abs(v.squaredNorm() - R * R) / (2.0f * R);
    naive.See(abs(r - naiveGap - (r - exactGap)), 2 * g_fUlp * size);
  });
}

// The ball is let go past the end of an arc: more than 0 if all of what docs/conventions.md asks for that
// holds, by at least so much. In radians, or in shares of the lengths and speeds that are compared.
CFifty LetsGo(const CArcOracle& arc, const CVec& p, const CFifty& r, const CVec& v) {
  const CVec end0 = arc.At(arc.m_fAngle0), end1 = arc.At(arc.m_fAngle0 + arc.m_fSpan);
  const CFifty d0 = Gap(p, end0), d1 = Gap(p, end1), speed = Norm(v);
  const auto past = [&](const CVec& end, const CFifty& d, int turn) {
    const CVec out = Unit(end - arc.m_vCenter), t = CFifty(turn) * Left(out);
    const CFifty off = -Dot(v, t);
    return std::min({CFifty((r - d) / r), CFifty(off / speed), CFifty((off - Dot(v, out)) / speed)});
  };
  const CFifty past0 = past(end0, d0, 1), past1 = past(end1, d1, -1);
  // Where the ends are about as near as each other, either may be asked.
  const CFifty nearer = (d0 - d1) / (arc.m_fRadius + r);
  if (abs(nearer) < CFifty(1e-4)) return std::min(past0, past1) > 0 ? std::min(past0, past1) : CFifty(0);
  return nearer < 0 ? past0 : past1;
}

TEST(DetectBounds, CircleArc) {
  CHitErrors errors("CollideCircleArc", 2000);
  CBroken naive("Answer of an arc by angles from -pi to pi");
  int letGo = 0, full = 0;
  ForEachCase(1802, 2 * g_nDetectBoundsTrials, [&](CRandom& random, int) {
    const CPair pair = AnyPair(random, eKind::Arc);
    const auto& desc = std::get<CArcDesc>(pair.m_cShape);
    const Vector2 &c = desc.m_vPos, &p = pair.m_cBall.m_vPos;
    const float R = desc.m_fRadius, r = pair.m_cBall.m_fRadius;
    const bool isFull = desc.GetAngle0() == desc.GetAngle1(); // without ends
    full += isFull;
    if (p == c) return;
    const CArcOracle exact{Exact(c), R, desc.GetAngle0(),
                           Turn(CFifty(desc.GetAngle1()) - CFifty(desc.GetAngle0()))};
    const CVec e = Exact(p);
    const CFifty d = Gap(e, exact.m_vCenter), s = d - R, size = Norm(exact.m_vCenter) + R;
    const CFifty bound = 2 * g_fUlp * (CFifty(R) + r), angleBound = 10 * g_fUlp * size / R;
    CHit hit;
    const bool got = Meets(pair, hit);
    const CFifty inside = isFull ? Pi() : exact.Inside(e);
    if (!isFull && s < g_fUlp * d && r < R && abs(s) < r) { // on the arc: it may count as inside
      const CFifty lets = LetsGo(exact, e, r, Exact(pair.m_cBall.m_vVel));
      if (lets > -angleBound * (1 + CFifty(R) / r)) {
        if (lets > angleBound * (1 + CFifty(R) / r) && s < -g_fUlp * d) {
          ++letGo;
          EXPECT_FALSE(got);
        }
        return;
      }
    }
    // Both in shares of their bounds: how far in the sector, and how deep.
    const CFifty overlap = s < 0 && r >= R ? std::min(CFifty(s), CFifty(r - abs(s))) : CFifty(r - abs(s));
    const CFifty met = std::min(CFifty(inside / angleBound), CFifty(overlap / bound));
    errors.m_cAnswer.SeeAnswer(!got, -met, 1);
    const Vector2 v = p - c;
    const float angle = std::atan2(v.y(), v.x());
    const bool naiveGot =
        std::abs(v.norm() - R) < r && desc.GetAngle0() <= angle && angle <= desc.GetAngle1();
    if (!isFull) naive.SeeAnswer(!naiveGot, -met, 1);
    if (!got) return;
    const CVec n = Unit(e - exact.m_vCenter);
    errors.m_cPOI.See(Exact(hit.m_vPOI), exact.m_vCenter + CFifty(R) * n,
                      3 * g_fUlp * (Norm(exact.m_vCenter) + R));
    const bool isOn = abs(s) <= g_fUlp * d; // on the arc: either side
    // A ball exactly on an arc into which it does not fit may be set back into it.
    errors.SeeSetback(pair, hit, r - abs(s), bound, r < R || !isOn);
    if (isOn) return;
    errors.m_cNorm.See(Exact(hit.m_vNorm), s < 0 ? CFifty(-1) * n : n, 2 * g_fUlp);
  });
  EXPECT_GT(letGo, 50);
  EXPECT_GT(full, 1000);
}

} // namespace
} // namespace Shapes::Bounds
