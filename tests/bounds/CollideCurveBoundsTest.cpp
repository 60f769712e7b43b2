// SPDX-License-Identifier: MIT
// The bounds of the kernels of src/native/narrowphase/Collide.h for rings and arcs.
#include "CollideTesting.h"

#include <cmath>

namespace Shapes::Bounds {
namespace {

constexpr int g_nDetectCurveBoundsTrials = 10000;

TEST(DetectBounds, CircleCircle) {
  CRandom random(1801);
  CHitErrors errors("CollideCircleCircle");
  CWorst naive("Setback from a ring by d^2 - R^2");
  for (int i = 0; i < g_nDetectCurveBoundsTrials; ++i) {
    const float R = AnySize(random), r = R * (i % 3 ? random.Scale(-10, 4) : NearOne(random));
    const CCircle circle(CCircleDesc(AnyPlace(random, R), R));
    const float gap = AnyGap(random, r);
    const Vector2 p = circle.GetPos() + AnyWay(random, random.Coin() ? R + gap : std::abs(R - gap));
    const CBall ball = Resting(random, p, r);
    const CVec c = Exact(circle.GetPos()), e = Exact(p) - c;
    const CFifty d = Norm(e), size = CFifty(R) + CFifty(r);
    const bool fits = r < R;
    const CFifty exactGap = fits && d < R ? CFifty(R - d) : CFifty(d - R);
    CHit hit;
    const bool got = CollideCircleCircle(circle, ball, hit);
    errors.SeeAnswer(got, r - exactGap, 2 * g_fUlp * size);
    if (!got || d == 0) continue;
    const CVec n = Unit(e);
    errors.m_cPOI.See(Exact(hit.m_vPOI), c + CFifty(R) * n, 3 * g_fUlp * (Norm(c) + R));
    errors.m_cSetback.See(abs(hit.m_fSetback - (r - exactGap)), 2 * g_fUlp * size);
    if (fits && abs(d - R) <= g_fUlp * d) continue; // on the ring: either side
    errors.m_cNorm.See(Exact(hit.m_vNorm), fits && d < R ? CFifty(-1) * n : n, 2 * g_fUlp);
    const Vector2 v = p - circle.GetPos();
    const float naiveGap = std::abs(v.squaredNorm() - R * R) / (2.0f * R);
    naive.See(abs(r - naiveGap - (r - exactGap)), 2 * g_fUlp * size);
  }
  errors.ExpectKept(5000);
  naive.ExpectBroken();
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
  CRandom random(1802);
  CHitErrors errors("CollideCircleArc");
  CWorst naive("Answer of an arc by angles from -pi to pi");
  int letGo = 0;
  for (int i = 0; i < g_nDetectCurveBoundsTrials; ++i) {
    const float R = AnySize(random), r = R * (i % 3 ? random.Scale(-10, 1) : NearOne(random));
    const Vector2 c = AnyPlace(random, R);
    const float a0 = AnyAngle(random);
    const CArcDesc desc(c, R, a0, AnyAngle(random));
    const CArc arc(desc);
    if (arc.IsFullCircle()) continue;
    const float gap = AnyGap(random, r);
    const float away = random.Coin() ? R + gap : std::abs(R - gap);
    const float share = i % 2 ? random.Uniform(-0.1f, 1.1f) : random.SignedScale(-24, -10);
    const Vector2 p = c + away * AngleToVector(desc.GetAngle0() + share * arc.GetSpan());
    const CBall ball = Resting(random, p, r);
    if (p == c) continue;
    const CArcOracle exact{Exact(c), R, desc.GetAngle0(),
                           Turn(CFifty(desc.GetAngle1()) - CFifty(desc.GetAngle0()))};
    const CVec e = Exact(p);
    const CFifty d = Gap(e, exact.m_vCenter), s = d - R, size = Norm(exact.m_vCenter) + R;
    const CFifty bound = 2 * g_fUlp * (CFifty(R) + r), angleBound = 10 * g_fUlp * size / R;
    CHit hit;
    const bool got = CollideCircleArc(arc, ball, hit);
    const CFifty inside = exact.Inside(e);
    if (s < g_fUlp * d && r < R && abs(s) < r) { // on the arc: it may count as inside
      const CFifty lets = LetsGo(exact, e, r, Exact(ball.m_vVel));
      if (lets > -angleBound * (1 + CFifty(R) / r)) {
        if (lets > angleBound * (1 + CFifty(R) / r) && s < -g_fUlp * d) {
          ++letGo;
          EXPECT_FALSE(got) << "seed " << random.GetSeed() << " trial " << i;
        }
        continue;
      }
    }
    // Both in shares of their bounds: how far in the sector, and how deep.
    const CFifty overlap = s < 0 && r >= R ? std::min(CFifty(s), CFifty(r - abs(s))) : CFifty(r - abs(s));
    const CFifty met = std::min(CFifty(inside / angleBound), CFifty(overlap / bound));
    errors.SeeAnswer(got, met, 1);
    const Vector2 v = p - c;
    const float angle = std::atan2(v.y(), v.x());
    const bool naiveGot = std::abs(v.norm() - R) < r && arc.GetAngle0() <= angle && angle <= arc.GetAngle1();
    naive.See(naiveGot == (met > 0) ? CFifty(0) : CFifty(abs(met)), 1);
    if (!got) continue;
    const CVec n = Unit(e - exact.m_vCenter);
    errors.m_cPOI.See(Exact(hit.m_vPOI), exact.m_vCenter + CFifty(R) * n,
                      3 * g_fUlp * (Norm(exact.m_vCenter) + R));
    errors.m_cSetback.See(abs(hit.m_fSetback - (r - abs(s))), bound);
    if (abs(s) <= g_fUlp * d) continue; // on the arc: either side
    errors.m_cNorm.See(Exact(hit.m_vNorm), s < 0 ? CFifty(-1) * n : n, 2 * g_fUlp);
  }
  errors.ExpectKept(2000);
  naive.ExpectBroken();
  EXPECT_GT(letGo, 50);
}

} // namespace
} // namespace Shapes::Bounds
