// SPDX-License-Identifier: MIT
// Outlines for the tests of true contacts, and what they are held against: the distance of a point from an
// geometry, and the way of a ball found by that distance alone, by conservative steps, without any root.
#pragma once

#include "box2d_backend/contact/ExactContact.h"

#include "DoubleVectors.h"

namespace Shapes::Tests {

using Box2D::CContactGeometry;
using Box2D::CExactContact;
using Box2D::FindExactContact;

inline CContactGeometry MakeDisk(const Vector2d& c, double R) {
  CContactGeometry o;
  o.m_vCentre = c;
  o.m_fRadius = R;
  return o;
}

inline CContactGeometry MakeSegment(const Vector2d& p0, const Vector2d& p1) {
  CContactGeometry o;
  o.m_eKind = CContactGeometry::eKind::LineSeg;
  o.m_vCentre = 0.5 * (p0 + p1);
  o.m_cEnd0.m_vPos = p0;
  o.m_cEnd1.m_vPos = p1;
  o.m_cEnd1.m_vOut = (p1 - p0).normalized();
  o.m_cEnd0.m_vOut = -o.m_cEnd1.m_vOut;
  return o;
}

/// @param span  counterclockwise from the angle a0, radians; 2 pi is the full circle
inline CContactGeometry MakeArcOutline(const Vector2d& c, double R, double a0, double span) {
  CContactGeometry o = MakeDisk(c, R);
  o.m_eKind = CContactGeometry::eKind::Arc;
  o.m_bFull = span >= 2 * std::numbers::pi;
  o.m_bLong = span > std::numbers::pi;
  const Vector2d u0 = UnitVector(a0), u1 = UnitVector(a0 + span);
  o.m_cEnd0.m_vPos = c + R * u0;
  o.m_cEnd1.m_vPos = c + R * u1;
  o.m_cEnd0.m_vOut = -Perp(u0);
  o.m_cEnd1.m_vOut = Perp(u1);
  return o;
}

/// The point of an geometry that is nearest to p. By angles, not by cross products. Disks are solid; the
/// nearest point of one is on its rim.
inline Vector2d NearestPt(const CContactGeometry& o, const Vector2d& p) {
  const Vector2d &p0 = o.m_cEnd0.m_vPos, &p1 = o.m_cEnd1.m_vPos;
  if (o.m_eKind == CContactGeometry::eKind::LineSeg) {
    const Vector2d way = p1 - p0;
    return p0 + std::clamp((p - p0).dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }
  const Vector2d d = p - o.m_vCentre;
  if (o.m_eKind == CContactGeometry::eKind::Arc && !o.m_bFull) {
    const auto angle = [&](const Vector2d& v) { // counterclockwise from end 0
      const Vector2d u0 = p0 - o.m_vCentre;
      const double a = std::atan2(Cross(u0, v), u0.dot(v));
      return a < 0 ? a + 2 * std::numbers::pi : a;
    };
    if (angle(d) > angle(p1 - o.m_vCentre)) return (p - p0).norm() < (p - p1).norm() ? p0 : p1;
  }
  return o.m_vCentre + o.m_fRadius * (d.norm() > 0 ? Vector2d(d.normalized()) : Vector2d(0, 1));
}

/// Below 0 within a disk.
inline double DistanceFrom(const CContactGeometry& o, const Vector2d& p) {
  if (o.m_eKind == CContactGeometry::eKind::Disk) return (p - o.m_vCentre).norm() - o.m_fRadius;
  return (p - NearestPt(o, p)).norm();
}

/// When a ball that is clear of all outlines first touches one of them, or when one that overlaps one began
/// to do so: on its way no distance changes faster than the ball moves. Never later than it is, and earlier
/// by what the tolerance is on the way there. Where the ball only grazes, and does so for long, steps get a
/// least length, which may pass over an overlap of 1e-10 of the radius of the smaller circle.
/// @param most  longest way that is looked at, metres
/// @return none if there is nothing within that
template <class TDistance>
std::optional<double> MarchToContact(TDistance distance, const Vector2d& q, const Vector2d& w, double r,
                                     double most, double tolerance) {
  const double sign = distance(q) < r ? -1 : 1;
  const Vector2d u = sign * w.normalized();
  double s = 0;
  for (int i = 0; s <= most; ++i) {
    const double free = sign * (distance(q + s * u) - r);
    if (free <= tolerance) return sign * s / w.norm();
    s += i < 4000 ? free : std::max(free, 1e-5 * r);
  }
  return {};
}

/// The unit vector from the nearest point of an geometry to p. @param p not the centre of a disk
inline Vector2d GradientAt(const CContactGeometry& o, const Vector2d& p) {
  const Vector2d& from = o.m_eKind == CContactGeometry::eKind::Disk ? o.m_vCentre : NearestPt(o, p);
  return (p - from).normalized();
}

/// What errors are relative to: see FindExactContact.
inline double SizeOf(const CContactGeometry& o, const Vector2d& q, double r) {
  const Vector2d &p0 = o.m_cEnd0.m_vPos, &p1 = o.m_cEnd1.m_vPos;
  return q.norm() + o.m_vCentre.norm() + o.m_fRadius + r + p0.norm() + p1.norm();
}

/// A ball near an geometry that goes there, or not.
struct CApproach {
  CContactGeometry m_cGeometry;
  Vector2d m_vPos, m_vVel;
  double m_fRadius;
  double m_fSmallest; // what near is measured by

  double Distance(const Vector2d& p) const { return DistanceFrom(m_cGeometry, p); }
  double Gap() const { return Distance(m_vPos) - m_fRadius; }
  Vector2d At(double t) const { return m_vPos + t * m_vVel; }
  double Size() const { return SizeOf(m_cGeometry, m_vPos, m_fRadius); }
  CExactContact Find() const { return FindExactContact(m_cGeometry, m_vPos, m_vVel, m_fRadius); }
  std::optional<double> March(double most) const {
    return MarchToContact([this](const Vector2d& p) { return Distance(p); }, m_vPos, m_vVel, m_fRadius, most,
                          1e-13 * Size());
  }
};

enum class eOutline { Point, Disk, LineSeg, Arc, Ring };

/// Sizes from 1/16 to 32, anywhere on the geometry and a little past its ends, in any direction, from an
/// overlap of a tenth up to half of the smallest size away. Some graze it, some pass beside it.
inline CApproach MakeApproach(CRandom& random, eOutline kind) {
  CApproach a;
  const double r = random.Scale(-4, 1), R = kind == eOutline::Point ? 0 : random.Scale(-4, 4);
  const Vector2d c = random.InSquare(10).cast<double>();
  const double along = 1.3 * random.Unit() - 0.15; // of the length; beyond 0 and 1 around the ends
  const Vector2d u = random.Direction().cast<double>();
  const double turn = 2 * std::numbers::pi, a0 = turn * random.Unit(), span = turn * random.Unit();
  Vector2d at = c + R * u, n = u;
  a.m_fSmallest = r;
  if (kind == eOutline::LineSeg) {
    const Vector2d way = random.Vector(-3, 4).cast<double>();
    a.m_cGeometry = MakeSegment(c, c + way);
    a.m_fSmallest = std::min(r, way.norm());
    at = c + std::clamp(along, 0.0, 1.0) * way;
    if (along >= 0 && along <= 1) n = (random.Coin() ? 1 : -1) * Perp(way.normalized());
  } else if (kind == eOutline::Arc || kind == eOutline::Ring) {
    a.m_cGeometry = MakeArcOutline(c, R, a0, kind == eOutline::Ring ? turn : span);
    a.m_fSmallest = std::min({r, R, std::abs(R - r)});
    const double angle = a0 + std::clamp(along, 0.0, 1.0) * (kind == eOutline::Ring ? turn : span);
    at = c + R * UnitVector(angle);
    if (kind == eOutline::Ring || (along >= 0 && along <= 1))
      n = (random.Coin() ? 1 : -1) * UnitVector(angle);
  } else {
    a.m_cGeometry = MakeDisk(c, R);
  }
  a.m_fRadius = r;
  a.m_vVel = random.Vector(-3, 6).cast<double>();
  const bool grazes = random.Below(8) == 0, passes = random.Below(4) == 0;
  if (grazes) a.m_vVel = a.m_vVel.norm() * (Perp(n) + random.SignedScale(-30, -6) * n);
  a.m_vPos = at + r * n - a.m_fSmallest * (0.6 * random.Unit() - 0.1) * a.m_vVel.normalized();
  if (passes) a.m_vPos += 0.3 * a.m_fSmallest * random.Unit() * n;
  return a;
}

} // namespace Shapes::Tests
