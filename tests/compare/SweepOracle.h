// SPDX-License-Identifier: MIT
// A second way to the time of impact, that shares nothing with the sweep: the distance of the ball from the
// shape by closest points and angles, in long double, searched by halving. An interval is given up only where
// the distance cannot reach 0 in it, because it changes no faster than the ball and the shape move.
#pragma once

#include "Testing.h"
#include "reference/Sweep.h"

namespace Shapes::Compare::Tests {

using real = long double;

class CSweepOracle {
public:
  CSweepOracle(const CShapeGeometry<double>& f, const CTurning<double>& turning,
               const CSweptBall<double>& ball, double tMax)
      : m_cGeometry(f), m_cTurning(turning), m_cBall(ball), m_fTimeMax(tMax) {
    // The distance is searched relative to the shape: the ball's speed plus that of the frame at the ball.
    const CVec<double> q = ball.m_vPos - turning.m_vCenter;
    const real speed = Len(ball.m_vVel.x(), ball.m_vVel.y()) + Len(ball.m_vAcc.x(), ball.m_vAcc.y()) * tMax;
    m_fSpeed = speed + std::abs(real(turning.m_fSpeed)) * (Len(q.x(), q.y()) + speed * tMax);
  }

  /// Gap between ball and shape at time t; negative if they overlap.
  real Gap(real t) const {
    real x, y;
    Place(t, x, y);
    return Distance(x, y) - real(m_cBall.m_fRadius);
  }

  /// How far the point p of the world is from the shape at time t.
  real DistanceOf(const CVec<double>& p, real t) const {
    real x = p.x(), y = p.y();
    IntoFrame(t, x, y);
    return Distance(x, y);
  }

  /// The first time at which the gap falls to 0 with the centre on a solid side. The time is off by no more
  /// than 1e-17 of tMax (a few roundings of long double).
  std::optional<real> FirstImpact() const {
    std::optional<real> found;
    Search(0, Gap(0), m_fTimeMax, Gap(m_fTimeMax), found);
    return found;
  }
  /// Whether Newton's method on the gap, from the start on, comes to this time.
  bool NewtonComesTo(double time) const {
    real t = 0, gap = Gap(t);
    for (int k = 0; k < 100 && gap > 1e-12L && t < m_fTimeMax; ++k) {
      const real slope = (Gap(t + 1e-9L) - gap) / 1e-9L;
      if (slope >= 0) break;
      t -= gap / slope;
      gap = Gap(t);
    }
    return !(std::abs(gap) > 1e-9L || std::abs(static_cast<double>(t) - time) > 1e-6);
  }

private:
  static real Len(real x, real y) { return std::sqrt(x * x + y * y); }

  void IntoFrame(real t, real& x, real& y) const {
    const real cx = m_cTurning.m_vCenter.x(), cy = m_cTurning.m_vCenter.y();
    const real a = -real(m_cTurning.m_fSpeed) * t, c = std::cos(a), s = std::sin(a);
    const real dx = x - cx, dy = y - cy;
    x = cx + c * dx - s * dy;
    y = cy + s * dx + c * dy;
  }

  void Place(real t, real& x, real& y) const {
    x = m_cBall.m_vPos.x() + real(m_cBall.m_vVel.x()) * t + real(m_cBall.m_vAcc.x()) * t * t / 2;
    y = m_cBall.m_vPos.y() + real(m_cBall.m_vVel.y()) * t + real(m_cBall.m_vAcc.y()) * t * t / 2;
    IntoFrame(t, x, y);
  }

  real Distance(real x, real y) const {
    const CShapeGeometry<double>& f = m_cGeometry;
    const real dx = x - f.m_vCenter.x(), dy = y - f.m_vCenter.y(), d = Len(dx, dy), R = f.m_fRadius;
    switch (f.m_eShapeType) {
    case eShape::LineSeg: {
      const real ax = f.m_vPt0.x(), ay = f.m_vPt0.y(), ex = f.m_vPt1.x() - ax, ey = f.m_vPt1.y() - ay;
      const real along = std::clamp(((x - ax) * ex + (y - ay) * ey) / (ex * ex + ey * ey), real(0), real(1));
      return Len(x - ax - along * ex, y - ay - along * ey);
    }
    case eShape::Circle: return m_cBall.m_fRadius < f.m_fRadius ? std::abs(d - R) : d - R;
    case eShape::Arc: {
      const real a0 = Angle(f.m_vPt0), a = std::atan2(dy, dx);
      if (f.m_bFull || Ahead(a0, a) <= Ahead(a0, Angle(f.m_vPt1))) return std::abs(d - R);
      return std::min(Len(x - f.m_vPt0.x(), y - f.m_vPt0.y()), Len(x - f.m_vPt1.x(), y - f.m_vPt1.y()));
    }
    default: return d;
    }
  }

  real Angle(const CVec<double>& p) const {
    return std::atan2(real(p.y()) - m_cGeometry.m_vCenter.y(), real(p.x()) - m_cGeometry.m_vCenter.x());
  }
  static real Ahead(real from, real to) {
    return to >= from ? to - from : to - from + 2 * std::numbers::pi_v<real>;
  }

  bool OnSolidSide(real t) const {
    const CShapeGeometry<double>& f = m_cGeometry;
    if (f.m_eSides == eSides::Both) return true;
    real x, y;
    Place(t, x, y);
    const real front = f.m_eShapeType == eShape::LineSeg
                           ? (real(f.m_vPt1.x()) - f.m_vPt0.x()) * (y - f.m_vPt0.y()) -
                                 (real(f.m_vPt1.y()) - f.m_vPt0.y()) * (x - f.m_vPt0.x())
                           : Len(x - f.m_vCenter.x(), y - f.m_vCenter.y()) - f.m_fRadius;
    return f.m_eSides == eSides::Front ? front > 0 : front < 0;
  }

  bool Search(real t0, real g0, real t1, real g1, std::optional<real>& found) const {
    // Above 0 throughout, or below it: no way down.
    if ((g0 > 0) == (g1 > 0) && std::abs(g0) + std::abs(g1) > m_fSpeed * (t1 - t0)) return false;
    const real t = (t0 + t1) / 2;
    if (t1 - t0 < real(1e-17) * m_fTimeMax || !(t > t0 && t < t1)) {
      if (!(g0 > 0 && g1 <= 0) || !OnSolidSide(t1)) return false;
      found = t1;
      return true;
    }
    const real g = Gap(t);
    return Search(t0, g0, t, g, found) || Search(t, g, t1, g1, found);
  }

  CShapeGeometry<double> m_cGeometry;
  CTurning<double> m_cTurning;
  CSweptBall<double> m_cBall;
  real m_fTimeMax;
  real m_fSpeed;
};

/// The textbook's quadratic: when a ball of radius r that goes with v is at the point from which it is at d.
inline double TextbookTime(const CVec<double>& d, const CVec<double>& v, double r) {
  const double a = v.squaredNorm(), b = d.dot(v), disc = b * b - a * (d.squaredNorm() - r * r);
  return disc < 0.0 ? 0.0 : (-b - std::sqrt(disc)) / a;
}

} // namespace Shapes::Compare::Tests
