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
      : m_cGeometry(f.Cast<real>()),
        m_vCenter(turning.m_vCenter.cast<real>()),
        m_fTurn(turning.m_fSpeed),
        m_vPos(ball.m_vPos.cast<real>()),
        m_vVel(ball.m_vVel.cast<real>()),
        m_vAcc(ball.m_vAcc.cast<real>()),
        m_fRadius(ball.m_fRadius),
        m_fTimeMax(tMax) {
    // The distance is searched relative to the shape: the ball's speed plus that of the frame at the ball.
    const real speed = m_vVel.norm() + m_vAcc.norm() * m_fTimeMax;
    m_fSpeed = speed + std::abs(m_fTurn) * ((m_vPos - m_vCenter).norm() + speed * m_fTimeMax);
  }

  /// Gap between ball and shape at time t; negative if they overlap.
  real Gap(real t) const { return Distance(Place(t)) - m_fRadius; }

  /// How far the point p of the world is from the shape at time t.
  real DistanceOf(const CVec<double>& p, real t) const { return Distance(IntoFrame(t, p.cast<real>())); }

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
  using CPoint = CVec<real>;

  CPoint IntoFrame(real t, const CPoint& p) const {
    const CPoint d = p - m_vCenter;
    const real a = -m_fTurn * t, c = std::cos(a), s = std::sin(a);
    return m_vCenter + CPoint(c * d.x() - s * d.y(), s * d.x() + c * d.y());
  }

  CPoint Place(real t) const { return IntoFrame(t, m_vPos + m_vVel * t + m_vAcc * (t * t / 2)); }

  real Distance(const CPoint& p) const {
    const CShapeGeometry<real>& f = m_cGeometry;
    const real d = (p - f.m_vCenter).norm(), R = f.m_fRadius;
    switch (f.m_eShapeType) {
    case eShape::LineSeg: {
      const CPoint all = f.m_vPt1 - f.m_vPt0, from0 = p - f.m_vPt0;
      return (from0 - std::clamp(from0.dot(all) / all.dot(all), real(0), real(1)) * all).norm();
    }
    case eShape::Circle: return m_fRadius < R ? std::abs(d - R) : d - R;
    case eShape::Arc: {
      const real a0 = Angle(f.m_vPt0);
      if (f.m_bFull || Ahead(a0, Angle(p)) <= Ahead(a0, Angle(f.m_vPt1))) return std::abs(d - R);
      return std::min((p - f.m_vPt0).norm(), (p - f.m_vPt1).norm());
    }
    default: return d;
    }
  }

  real Angle(const CPoint& p) const {
    return std::atan2(p.y() - m_cGeometry.m_vCenter.y(), p.x() - m_cGeometry.m_vCenter.x());
  }
  static real Ahead(real from, real to) {
    return to >= from ? to - from : to - from + 2 * std::numbers::pi_v<real>;
  }

  bool OnSolidSide(real t) const {
    const CShapeGeometry<real>& f = m_cGeometry;
    if (f.m_eSides == eSides::Both) return true;
    const CPoint p = Place(t), all = f.m_vPt1 - f.m_vPt0, from0 = p - f.m_vPt0;
    const real front = f.m_eShapeType == eShape::LineSeg ? all.x() * from0.y() - all.y() * from0.x()
                                                         : (p - f.m_vCenter).norm() - f.m_fRadius;
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

  CShapeGeometry<real> m_cGeometry;
  CPoint m_vCenter; // of the turn
  real m_fTurn;     // radians per second
  CPoint m_vPos, m_vVel, m_vAcc;
  real m_fRadius;
  real m_fTimeMax;
  real m_fSpeed;
};

/// The textbook's quadratic: when a ball of radius r that goes with v is at the point from which it is at d.
inline double TextbookTime(const CVec<double>& d, const CVec<double>& v, double r) {
  const double a = v.squaredNorm(), b = d.dot(v), disc = b * b - a * (d.squaredNorm() - r * r);
  return disc < 0.0 ? 0.0 : (-b - std::sqrt(disc)) / a;
}

} // namespace Shapes::Compare::Tests
