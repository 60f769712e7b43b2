// SPDX-License-Identifier: MIT
// The right results of the geometric functions, in 50 digits: from textbook formulas, by angles and squares,
// which the library avoids. At 50 digits they lose nothing that a float could show.
#pragma once

#include "reference/Scalar.h"

#include <Shapes/ShapeMath.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>

namespace Shapes::Bounds {

using Compare::CFifty;

struct CVec {
  CFifty x, y;
};
inline CVec operator+(const CVec& a, const CVec& b) { return {a.x + b.x, a.y + b.y}; }
inline CVec operator-(const CVec& a, const CVec& b) { return {a.x - b.x, a.y - b.y}; }
inline CVec operator*(const CFifty& k, const CVec& v) { return {k * v.x, k * v.y}; }
inline CFifty Dot(const CVec& a, const CVec& b) { return a.x * b.x + a.y * b.y; }
inline CFifty Cross(const CVec& a, const CVec& b) { return a.x * b.y - a.y * b.x; }
inline CFifty Norm(const CVec& v) { return sqrt(Dot(v, v)); }
inline CVec Unit(const CVec& v) { return (1 / Norm(v)) * v; }
inline CVec Left(const CVec& v) { return {-v.y, v.x}; }
inline CFifty Gap(const CVec& a, const CVec& b) { return Norm(a - b); }

/// The float or double vector as it is.
template <class TVector>
CVec Exact(const TVector& v) {
  return {CFifty(v.x()), CFifty(v.y())};
}

inline const CFifty& Pi() {
  static const CFifty pi = boost::math::constants::pi<CFifty>();
  return pi;
}
/// In [0, 2 pi).
inline CFifty Turn(CFifty angle) {
  angle -= 2 * Pi() * floor(angle / (2 * Pi()));
  return angle;
}
inline CFifty AngleOf(const CVec& v) { return Turn(atan2(v.y, v.x)); }
inline CVec AtAngle(const CFifty& a) { return {cos(a), sin(a)}; }
inline CVec Turned(const CVec& p, const CVec& center, const CFifty& angle) {
  const CVec d = p - center, u = AtAngle(angle);
  return center + CVec{u.x * d.x - u.y * d.y, u.y * d.x + u.x * d.y};
}

/// The foot of the perpendicular from q on the line through p along d.
inline CVec ClosestOnLine(const CVec& p, const CVec& d, const CVec& q) {
  return q - (Cross(d, q - p) / Dot(d, d)) * Left(d);
}
inline CVec ClosestOnSegment(const CVec& p0, const CVec& p1, const CVec& q) {
  const CVec d = p1 - p0;
  const CFifty share = Dot(q - p0, d);
  return share <= 0 ? p0 : share >= Dot(d, d) ? p1 : ClosestOnLine(p0, d, q);
}
/// By Cramer's rule.
inline CVec Crossing(const CVec& p, const CVec& d, const CVec& q, const CVec& e) {
  const CFifty cp = Cross(p, d), cq = Cross(q, e), det = Cross(d, e);
  return {(cq * d.x - cp * e.x) / det, (cq * d.y - cp * e.y) / det};
}

inline CVec ClosestOnCircle(const CVec& c, const CFifty& r, const CVec& q) { return c + r * Unit(q - c); }

/// An arc by its angles.
struct CArcOracle {
  CVec m_vCenter;
  CFifty m_fRadius, m_fAngle0, m_fSpan;

  CVec At(const CFifty& angle) const { return m_vCenter + m_fRadius * AtAngle(angle); }
  /// How far, in radians, the direction to q is inside of the end rays; negative outside of them.
  CFifty Inside(const CVec& q) const {
    const CFifty a = Turn(AngleOf(q - m_vCenter) - m_fAngle0);
    if (a <= m_fSpan) return std::min(a, CFifty(m_fSpan - a));
    return -std::min(CFifty(a - m_fSpan), CFifty(2 * Pi() - a));
  }
  CVec Closest(const CVec& q) const {
    if (Inside(q) >= 0) return ClosestOnCircle(m_vCenter, m_fRadius, q);
    const CVec p0 = At(m_fAngle0), p1 = At(m_fAngle0 + m_fSpan);
    return Gap(q, p0) <= Gap(q, p1) ? p0 : p1;
  }
  /// The farthest the arc gets along the direction of this angle, from its centre.
  CFifty Reach(const CFifty& direction) const {
    if (Turn(direction - m_fAngle0) <= m_fSpan) return m_fRadius;
    return m_fRadius * std::max(cos(m_fAngle0 - direction), cos(m_fAngle0 + m_fSpan - direction));
  }
};

/// Where the tangent through p touches a circle; side 1 is to the left of the centre as seen from p. By the
/// polar of p.
inline CVec TouchPoint(const CVec& c, const CFifty& r, const CVec& p, int side) {
  const CVec w = p - c;
  const CFifty square = Dot(w, w);
  return c + (r / square) * (r * w - (side * sqrt(square - r * r)) * Left(w));
}
/// The unit vector from both centres to where an outer tangent touches; side 1 is to the left of the way from
/// c0 to c1. By its angle.
inline CVec TouchDirection(const CVec& c0, const CFifty& r0, const CVec& c1, const CFifty& r1, int side) {
  const CVec v = c1 - c0;
  return AtAngle(AngleOf(v) + side * acos((r0 - r1) / Norm(v)));
}

} // namespace Shapes::Bounds
