// SPDX-License-Identifier: MIT
#include "BallPath.h"

#include "../Tolerances.h"
#include "../geometry/VisitShape.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace Shapes {
namespace {

using Geometry::ClosestShare, Geometry::Perp, Geometry::Unit;

// A straight part of a path, and the smallest of the distances that it was offered.
struct CPart {
  Vector2d m_vP0, m_vP1, m_vD; // from, to, and the difference
  double m_fDistance = std::numeric_limits<double>::infinity();
  double m_fShare = 0.0;

  CPart(const Vector2d& p0, const Vector2d& p1) : m_vP0(p0), m_vP1(p1), m_vD(p1 - p0) {}

  Vector2d At(double share) const { return share == 1.0 ? m_vP1 : Vector2d(m_vP0 + share * m_vD); }
  void Keep(double distance, double share) {
    if (distance < m_fDistance) m_fDistance = distance, m_fShare = share;
  }
  void KeepPt(const Vector2d& q, double radius = 0.0) {
    const double share = ClosestShare(m_vP0, m_vD, q);
    Keep((At(share) - q).norm() - radius, share);
  }

  void KeepLineSeg(const Vector2d& p0, const Vector2d& p1) {
    const Vector2d u = p1 - p0;
    // Two segments that do not cross are closest at an end of one of them.
    KeepPt(p0);
    KeepPt(p1);
    for (const double share : {0.0, 1.0})
      Keep((At(share) - p0 - ClosestShare(p0, u, At(share)) * u).norm(), share);
    const double sa = Geometry::Cross(u, m_vP0 - p0), sb = Geometry::Cross(u, m_vP1 - p0);
    const double s0 = Geometry::Cross(m_vD, p0 - m_vP0), s1 = Geometry::Cross(m_vD, p1 - m_vP0);
    if (sa * sb < 0.0 && s0 * s1 < 0.0) Keep(0.0, sa / (sa - sb));
  }

  // The arc of radius R about c, without its ends.
  template <class F>
  void KeepArc(const Vector2d& c, double R, const F& ptInSector) {
    // The distance from the circle is least where the part begins, ends, or is closest to the centre, ...
    for (const double share : {0.0, ClosestShare(m_vP0, m_vD, c), 1.0})
      if (ptInSector(At(share))) Keep(std::abs((At(share) - c).norm() - R), share);
    // ... unless it crosses it.
    const double length = m_vD.norm();
    if (!(length > 0.0)) return;
    const double h = std::abs(Geometry::Cross(m_vD, m_vP0 - c)) / length;
    if (!(h < R)) return;
    const double middle = m_vD.dot(c - m_vP0) / length, half = std::sqrt((R - h) * (R + h));
    for (const double share : {(middle - half) / length, (middle + half) / length})
      if (share >= 0.0 && share <= 1.0 && ptInSector(At(share))) Keep(0.0, share);
  }
};

} // namespace

CBox2d GetBox(CBallPath path) {
  CBox2d box;
  for (const CPathVertex& point : path)
    box.extend(point.m_vPos);
  return box;
}

Vector2d GetPos(CBallPath path, double t) {
  if (t <= path[0].m_fTime) return path[0].m_vPos;
  std::size_t i = 1;
  while (i + 1 < path.size() && path[i].m_fTime < t)
    ++i;
  const CPathVertex &p0 = path[i - 1], &p1 = path[i];
  if (p1.m_fTime <= t) return p1.m_vPos;
  return p0.m_vPos + (t - p0.m_fTime) / (p1.m_fTime - p0.m_fTime) * (p1.m_vPos - p0.m_vPos);
}

Vector2d GetVelocity(CBallPath path, double t) {
  for (std::size_t i = 1; i < path.size(); ++i)
    if (path[i].m_fTime >= t && path[i].m_fTime > path[i - 1].m_fTime)
      return (path[i].m_vPos - path[i - 1].m_vPos) / (path[i].m_fTime - path[i - 1].m_fTime);
  return Vector2d::Zero();
}

void MakeRelativePath(CBallPath a, CBallPath b, std::vector<CPathVertex>& relative) {
  relative = {{0.0, a[0].m_vPos - b[0].m_vPos}};
  // At the vertices of both; the last points are those of time 1.
  for (std::size_t i = 1, j = 1; i + 1 < a.size() || j + 1 < b.size();) {
    const bool takeA = j + 1 == b.size() || (i + 1 < a.size() && a[i].m_fTime <= b[j].m_fTime);
    if (takeA)
      relative.push_back({a[i].m_fTime, a[i].m_vPos - GetPos(b, a[i].m_fTime)}), ++i;
    else
      relative.push_back({b[j].m_fTime, GetPos(a, b[j].m_fTime) - b[j].m_vPos}), ++j;
  }
  relative.push_back({1.0, a.back().m_vPos - b.back().m_vPos});
}

void MakeRotatedPath(CBallPath path, const Vector2d& center, double turn, const Vector2d& move, double r,
                     std::vector<CPathVertex>& turned) {
  // At time t the shape has still to move by (1 - t) move, which leaves what is straight so, and to turn by
  // (1 - t) turn; the ball goes and is turned with it.
  const auto moved = [&](const CPathVertex& p) {
    return CPathVertex{p.m_fTime, p.m_vPos + (1.0 - p.m_fTime) * move};
  };
  const auto add = [&](double t, const Vector2d& p) {
    turned.push_back({t, Turn(p, center, (1.0 - t) * turn)});
  };
  turned.clear();
  add(path[0].m_fTime, moved(path[0]).m_vPos);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const CPathVertex p0 = moved(path[i - 1]), p1 = moved(path[i]);
    // A chord of a curve q(s), 0 <= s <= 1, errs by at most max|q''| / 8; here |q''| <= angle^2 D + 2 angle
    // L.
    const double angle = std::abs(turn) * (p1.m_fTime - p0.m_fTime);
    const double D = std::max((p0.m_vPos - center).norm(), (p1.m_vPos - center).norm());
    const double L = (p1.m_vPos - p0.m_vPos).norm();
    const double bend = angle * (angle * D + 2.0 * L), allowed = 8.0 * g_fRotatedPathError * r;
    int n = 1;
    if (bend > 0.0) {
      // Not so for a ball without a radius, of which nothing would be near enough.
      const bool isFew = bend < static_cast<double>(g_nMaxTurnParts) * g_nMaxTurnParts * allowed;
      n = isFew ? static_cast<int>(std::ceil(std::sqrt(bend / allowed))) : g_nMaxTurnParts;
    }
    for (int k = 1; k <= n; ++k) {
      const double share = static_cast<double>(k) / n;
      add(k == n ? p1.m_fTime : p0.m_fTime + share * (p1.m_fTime - p0.m_fTime),
          k == n ? p1.m_vPos : Vector2d(p0.m_vPos + share * (p1.m_vPos - p0.m_vPos)));
    }
  }
}

Vector2d Turn(const Vector2d& p, const Vector2d& center, double angle) {
  if (angle == 0.0) return p;
  const auto [c, s] = Geometry::GetTurn(angle);
  const Vector2d d = p - center;
  return center + c * d + s * Perp(d);
}

CZone::CZone(const CShape& shape) : m_eType(shape.GetShapeType()), m_vPos(shape.GetPos().cast<double>()) {
  VisitShape(shape, CPerShape{[](const CPoint&) {},
                              [this](const CLineSeg& seg) {
                                m_vPt0 = seg.GetEndPt0().cast<double>();
                                m_vPt1 = seg.GetEndPt1().cast<double>();
                                // The normal in double; the shape's says which of the two.
                                m_vFront = Unit(Perp(Vector2d(m_vPt1 - m_vPt0)), Vector2d::UnitY());
                                if (m_vFront.dot(seg.GetNormal().cast<double>()) < 0.0) m_vFront = -m_vFront;
                              },
                              [this](const CCircle& circle) { m_fRadius = circle.GetRadius(); },
                              [this](const CArc& arc) {
                                m_fRadius = arc.GetRadius();
                                m_vPt0 = arc.GetEndPt0().cast<double>();
                                m_vPt1 = arc.GetEndPt1().cast<double>();
                                m_fSpan = arc.GetSpan();
                                m_bFull = arc.IsFullCircle();
                              }});
}

CBox2d CZone::GetBox() const {
  const Vector2d r(m_fRadius, m_fRadius);
  CBox2d box(m_vPos - r, m_vPos + r);
  switch (m_eType) {
  case eShape::LineSeg: box = CBox2d(m_vPt0).extend(m_vPt1); break;
  case eShape::Arc: box.extend(m_vPt0).extend(m_vPt1); break; // rounded off the circle
  case eShape::Point:
  case eShape::Circle: break;
  }
  return box;
}

std::optional<CZone::CTouch> CZone::Touch(CBallPath path, double r) const {
  const CPathVertex end[] = {path.back(), path.back()};
  CApproach at = Approach(end);
  const bool atEnd = at.m_fDistance < r;
  if (!atEnd) at = Approach(path);
  if (!(at.m_fDistance < r)) return std::nullopt;
  return TouchAt(at, GetVelocity(path, at.m_fTime), atEnd);
}

CZone::CApproach CZone::Approach(CBallPath path) const {
  CApproach best{std::numeric_limits<double>::infinity(), 0.0, {}};
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    CPart part(path[i].m_vPos, path[i + 1].m_vPos);
    switch (m_eType) {
    case eShape::LineSeg: part.KeepLineSeg(m_vPt0, m_vPt1); break;
    case eShape::Arc:
      part.KeepPt(m_vPt0);
      part.KeepPt(m_vPt1);
      part.KeepArc(m_vPos, m_fRadius, [this](const Vector2d& p) { return PtInSector(p); });
      break;
    case eShape::Point:
    case eShape::Circle: part.KeepPt(m_vPos, m_fRadius); break;
    }
    if (!(part.m_fDistance < best.m_fDistance)) continue;
    const double t0 = path[i].m_fTime, t1 = path[i + 1].m_fTime, share = part.m_fShare;
    best = {part.m_fDistance, share == 1.0 ? t1 : t0 + share * (t1 - t0), part.At(share)};
  }
  return best;
}

CZone::CTouch CZone::TouchAt(const CApproach& at, const Vector2d& velocity, bool atEnd) const {
  const Vector2d& p = at.m_vPos;
  const Vector2d against = Unit(-velocity, Vector2d::UnitY());
  const auto fromPt = [&](const Vector2d& q) { return CTouch{atEnd, at.m_fTime, q, Unit(p - q, against)}; };
  // s is how far the centre is in front along n, a unit vector. On the curve it is noise: what counts is
  // where the ball came from.
  const auto fromCurve = [&](const Vector2d& q, const Vector2d& n, double s) {
    if (at.m_fDistance == 0.0) s = -n.dot(velocity);
    return CTouch{atEnd, at.m_fTime, q, s < 0.0 ? Vector2d(-n) : n};
  };
  switch (m_eType) {
  case eShape::LineSeg: {
    const double share = ClosestShare(m_vPt0, m_vPt1 - m_vPt0, p);
    if (share == 0.0) return fromPt(m_vPt0);
    if (share == 1.0) return fromPt(m_vPt1);
    return fromCurve(m_vPt0 + share * (m_vPt1 - m_vPt0), m_vFront, m_vFront.dot(p - m_vPt0));
  }
  case eShape::Arc: {
    if (!PtInSector(p)) return fromPt((p - m_vPt0).norm() <= (p - m_vPt1).norm() ? m_vPt0 : m_vPt1);
    const Vector2d out = Unit(p - m_vPos, Unit(m_vPt0 - m_vPos, Vector2d::UnitY()));
    return fromCurve(m_vPos + m_fRadius * out, out, (p - m_vPos).norm() - m_fRadius);
  }
  case eShape::Point:
  case eShape::Circle: break;
  }
  CTouch touch = fromPt(m_vPos);
  touch.m_vPOI += m_fRadius * touch.m_vNorm;
  return touch;
}

bool CZone::PtInSector(const Vector2d& p) const {
  if (m_bFull) return true;
  const Vector2d e0 = m_vPt0 - m_vPos, e1 = m_vPt1 - m_vPos, u = p - m_vPos;
  // On a short arc what is opposite to it may pass for both sides of it.
  if (m_fSpan < 1.0 && u.dot(e0) < 0.0) return false;
  const bool after0 = Geometry::Cross(e0, u) >= 0.0, before1 = Geometry::Cross(u, e1) >= 0.0;
  return m_fSpan <= static_cast<double>(g_fPi) ? after0 && before1 : after0 || before1;
}

} // namespace Shapes
