// SPDX-License-Identifier: MIT
// The bounds of Circle.h.
#include "Inputs.h"
#include "Worst.h"

#include <Shapes/Circle.h>

#include <cmath>

namespace Shapes::Bounds {
namespace {

constexpr int g_nCircleBoundsTrials = 10000;

CCircle Circle(const Vector2& p, float r) { return CCircle(CCircleDesc(p, r)); }

TEST(CircleBounds, ClosestPtAndPtInCircle) {
  CRandom random(1201);
  CWorst closest("CCircle::ClosestPt"), inside("CCircle::PtInCircle"),
      naive("CCircle::ClosestPt by the gradient"), naiveInside("PtInCircle by squares");
  for (int i = 0; i < g_nCircleBoundsTrials; ++i) {
    const float r = AnySize(random);
    const Vector2 c = AnyPlace(random, r);
    const float away = i % 2 ? r * NearOne(random) : r * random.Scale(-30, 10);
    const Vector2 q = c + AnyWay(random, away);
    if (q == c) continue;
    const CCircle circle = Circle(c, r);
    const CVec ec = Exact(c), eq = Exact(q), exact = ClosestOnCircle(ec, r, eq);
    const CFifty d = Gap(ec, eq), bound = 3 * g_fUlp * (Norm(ec) + r);
    closest.See(Exact(circle.ClosestPt(q)), exact, bound);
    const Vector2 v = q - c;
    const float m = v.y() / v.x(), x = std::copysign(r / std::sqrt(1.0f + m * m), v.x());
    naive.See(Exact(Vector2(c + Vector2(x, m * x))), exact, bound);
    // A wrong answer is an error of as much as the point is off the circle.
    const auto see = [&](CWorst& worst, bool is) {
      worst.See(is == (d < r) ? CFifty(0) : CFifty(abs(d - r)), g_fUlp * d);
    };
    see(inside, circle.PtInCircle(q));
    see(naiveInside, q.dot(q) - 2.0f * q.dot(c) + c.dot(c) < r * r);
  }
  closest.ExpectKept(9000);
  inside.ExpectKept(9000);
  naive.ExpectBroken();
  naiveInside.ExpectBroken();
}

// How well q is where a tangent through p touches: on the circle, and at a right angle to its radius.
void SeeTouch(CWorst& worst, const CVec& c, const CFifty& r, const CVec& p, const CVec& q,
              const CFifty& bound) {
  const CVec radius = q - c, way = q - p;
  worst.See(abs(Norm(radius) - r), bound);
  worst.See(abs(Dot(radius, way)), bound * (Norm(radius) + Norm(way)));
}

TEST(CircleBounds, TangentsThroughAPoint) {
  CRandom random(1202);
  CWorst touch("CCircle::Tangents through a point"), where("where they touch"),
      exists("that there are tangents through a point"), naive("Tangent length d^2 - r^2");
  for (int i = 0; i < g_nCircleBoundsTrials; ++i) {
    const float r = AnySize(random);
    const Vector2 c = AnyPlace(random, r);
    const float away = i % 2 ? r * NearOne(random) : r * (1.0f + random.Scale(-20, 8));
    const Vector2 p = c + AnyWay(random, away);
    const CVec ec = Exact(c), ep = Exact(p);
    const CFifty d = Gap(ec, ep);
    Vector2 q[2];
    const bool got = Circle(c, r).Tangents(p, q[0], q[1]);
    if (d == 0) continue;
    exists.See(got == (d >= r) ? CFifty(0) : CFifty(abs(d - r)), g_fUlp * d);
    if (!got) continue;
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
  }
  touch.ExpectKept(10000);
  where.ExpectKept(10000);
  exists.ExpectKept(9000);
  naive.ExpectBroken();
}

TEST(CircleBounds, CommonTangents) {
  CRandom random(1203);
  CWorst touch("CCircle::Tangents of two circles"), where("where they touch both"),
      exists("that two circles have tangents"), naive("Common tangents by the tangent length");
  for (int i = 0; i < g_nCircleBoundsTrials; ++i) {
    const float r0 = AnySize(random);
    const float r1 = i % 4 == 0 ? r0 : i % 4 == 1 ? r0 * NearOne(random) : r0 * random.Scale(-12, 12);
    const Vector2 c0 = AnyPlace(random, r0);
    const float nested = std::abs(r0 - r1);
    const float away = i % 2 && nested > 0.0f ? nested * NearOne(random) : (r0 + r1) * random.Scale(-8, 8);
    const Vector2 c1 = c0 + AnyWay(random, away);
    const CVec e0 = Exact(c0), e1 = Exact(c1);
    const CFifty f0 = r0, f1 = r1, d = Gap(e0, e1);
    const CCircle a = Circle(c0, r0), b = Circle(c1, r1);
    CLineSegDesc t[2];
    const bool got = a.Tangents(&b, t[0], t[1]);
    exists.See(got == (d > abs(f0 - f1)) ? CFifty(0) : CFifty(abs(d - abs(f0 - f1))), 2 * g_fUlp * d);
    if (!got || d - abs(f0 - f1) <= 16 * g_fUlp * d) continue;
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
  }
  touch.ExpectKept(10000);
  where.ExpectKept(10000);
  exists.ExpectKept(g_nCircleBoundsTrials);
  naive.ExpectBroken();
}

} // namespace
} // namespace Shapes::Bounds
