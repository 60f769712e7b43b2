// SPDX-License-Identifier: MIT
// The exact way of a ball among static shapes, without gravity, in double: what tuned worlds are held
// against. Everything is met at the distance r; ends of segments and arcs are round.
#pragma once

#include "Box2DTesting.h"

#include <span>
#include <variant>

namespace Shapes::Tests {

inline double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
inline Vector2d Perp(const Vector2d& a) { return {-a.y(), a.x()}; }
inline Vector2d UnitVector(double angle) { return {std::cos(angle), std::sin(angle)}; }
/// Radians between two directions, 0 .. pi.
inline double AngleBetween(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(Cross(a, b), a.dot(b)));
}
inline Vector2d Mirror(const Vector2d& v, const Vector2d& n, double e = 1) {
  return v - (1 + e) * v.dot(n) * n;
}

/// A ball on its way: exactly what the floats that an engine is given say.
struct CBallState {
  Vector2d m_vPos, m_vVel;
  double m_fRadius;
};

struct CHit {
  double m_fTime = std::numeric_limits<double>::infinity(); // never
  Vector2d m_vNorm = Vector2d::Zero();                      // from the shape to the ball
};

/// When the ball meets the outside of a circle; a point is one of radius 0.
inline CHit MeetOutside(const CBallState& b, const Vector2d& c, double R) {
  const Vector2d d = b.m_vPos - c;
  const double rho = R + b.m_fRadius, k = d.squaredNorm() - rho * rho;
  const double a = b.m_vVel.squaredNorm(), h = d.dot(b.m_vVel), disc = h * h - a * k;
  if (h >= 0 || disc <= 0 || d.norm() < R) return {};
  const double t = std::max(0.0, k / (-h + std::sqrt(disc)));
  return {t, (d + t * b.m_vVel).normalized()};
}

/// When a ball meets the inside of a ring. One that is outside flies through where there may be a gap: what
/// is in its way there is met before.
inline CHit MeetInside(const CBallState& b, const Vector2d& c, double R) {
  const Vector2d d = b.m_vPos - c;
  const double rho = R - b.m_fRadius, k = d.squaredNorm() - rho * rho;
  const double a = b.m_vVel.squaredNorm(), h = d.dot(b.m_vVel), disc = h * h - a * k;
  if (rho <= 0 || disc <= 0) return {};
  const double t = (-h + std::sqrt(disc)) / a;
  if (t < 0) return {};
  return {t, -(d + t * b.m_vVel).normalized()};
}

/// When the ball meets a face of a segment between its ends.
inline CHit MeetFace(const CBallState& b, const Vector2d& p0, const Vector2d& p1) {
  const Vector2d t0 = (p1 - p0).normalized();
  Vector2d n = Perp(t0);
  if (n.dot(b.m_vPos - p0) < 0) n = -n;
  const double gap = n.dot(b.m_vPos - p0) - b.m_fRadius, vn = n.dot(b.m_vVel);
  if (vn >= 0 || gap < -1e-9) return {};
  const double t = std::max(0.0, gap) / -vn;
  const double foot = t0.dot(b.m_vPos + t * b.m_vVel - p0);
  if (foot < 0 || foot > (p1 - p0).norm()) return {};
  return {t, n};
}

/// Shapes that do not move.
class CExactTable {
public:
  explicit CExactTable(std::span<const CAnyShapeDesc> descs) {
    for (const CAnyShapeDesc& desc : descs)
      std::visit([&](const auto& d) { Add(d); }, desc);
  }

  CHit FirstHit(const CBallState& b) const {
    CHit first;
    const auto take = [&](const CHit& hit) {
      if (hit.m_fTime < first.m_fTime) first = hit;
    };
    for (const CSegment& s : m_stdSegments)
      take(MeetFace(b, s.m_vPt0, s.m_vPt1));
    for (const CRing& ring : m_stdRings) {
      const auto inSector = [&](const CHit& hit, double side) { // hit.m_vNorm is +-radial
        const Vector2d u = side * hit.m_vNorm;
        const double turn = 2 * std::numbers::pi;
        const double angle = std::atan2(u.y(), u.x()) - ring.m_fAngle0;
        return hit.m_fTime < 1e300 && angle - turn * std::floor(angle / turn) <= ring.m_fSpan;
      };
      if (const CHit hit = MeetOutside(b, ring.m_vPos, ring.m_fRadius); inSector(hit, 1)) take(hit);
      if (ring.m_bIsSolid) continue;
      if (const CHit hit = MeetInside(b, ring.m_vPos, ring.m_fRadius); inSector(hit, -1)) take(hit);
    }
    for (const Vector2d& p : m_stdPoints)
      take(MeetOutside(b, p, 0));
    return first;
  }

  /// Every hit up to time t, and the ball at that time.
  std::vector<CHit> Fly(CBallState& b, double t, double e = 1) const {
    std::vector<CHit> hits;
    double now = 0;
    while (hits.size() < 1000) {
      const CHit hit = FirstHit(b);
      if (now + hit.m_fTime > t) break;
      b.m_vPos += hit.m_fTime * b.m_vVel;
      b.m_vVel = Mirror(b.m_vVel, hit.m_vNorm, e);
      now += hit.m_fTime;
      hits.push_back({now, hit.m_vNorm});
    }
    b.m_vPos += (t - now) * b.m_vVel;
    return hits;
  }

  /// Distance of p from the nearest surface (a solid circle has no inside).
  double Distance(const Vector2d& p) const {
    double d = std::numeric_limits<double>::infinity();
    for (const Vector2d& q : m_stdPoints)
      d = std::min(d, (p - q).norm());
    for (const CSegment& s : m_stdSegments) {
      const Vector2d w = s.m_vPt1 - s.m_vPt0;
      const double foot = std::clamp((p - s.m_vPt0).dot(w) / w.squaredNorm(), 0.0, 1.0);
      d = std::min(d, (p - s.m_vPt0 - foot * w).norm());
    }
    for (const CRing& ring : m_stdRings) {
      const Vector2d u = p - ring.m_vPos;
      const double turn = 2 * std::numbers::pi, angle = std::atan2(u.y(), u.x()) - ring.m_fAngle0;
      if (angle - turn * std::floor(angle / turn) > ring.m_fSpan) continue;
      const double above = u.norm() - ring.m_fRadius;
      d = std::min(d, ring.m_bIsSolid ? above : std::abs(above));
    }
    return d;
  }

private:
  struct CSegment {
    Vector2d m_vPt0, m_vPt1;
  };
  struct CRing {
    Vector2d m_vPos;
    double m_fRadius, m_fAngle0, m_fSpan;
    bool m_bIsSolid;
  };

  void Add(const CPointDesc& d) { m_stdPoints.push_back(d.m_vPos.cast<double>()); }
  void Add(const CLineSegDesc& d) {
    const Vector2d p0 = d.GetEndPt0().cast<double>(), p1 = d.GetEndPt1().cast<double>();
    m_stdSegments.push_back({p0, p1});
    m_stdPoints.insert(m_stdPoints.end(), {p0, p1});
  }
  void Add(const CCircleDesc& d) {
    m_stdRings.push_back({d.m_vPos.cast<double>(), d.m_fRadius, 0, 2 * std::numbers::pi, true});
  }
  void Add(const CArcDesc& d) {
    const double a0 = d.GetAngle0(), a1 = d.GetAngle1(), turn = 2 * std::numbers::pi;
    const double span = a1 > a0 ? a1 - a0 : a1 - a0 + turn;
    m_stdRings.push_back({d.m_vPos.cast<double>(), d.m_fRadius, a0, span, false});
    if (a0 == a1) return; // no ends
    for (const double a : {a0, a1})
      m_stdPoints.push_back(d.m_vPos.cast<double>() + double(d.m_fRadius) * UnitVector(a));
  }
  void Add(const CDynamicCircleDesc&) {} // a ball is no shape of the table

  std::vector<Vector2d> m_stdPoints;
  std::vector<CSegment> m_stdSegments;
  std::vector<CRing> m_stdRings;
};

} // namespace Shapes::Tests
