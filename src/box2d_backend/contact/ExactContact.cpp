// SPDX-License-Identifier: MIT
#include "ExactContact.h"

#include "../../geometry/Vector.h"

#include <cmath>

namespace Shapes::Box2D {
namespace {

// From outside onto a circle about c of radius D > 0, on which the centre of the ball is when they touch.
CExactContact ContactOnDisk(const Vector2d& c, double D, const Vector2d& q, const Vector2d& w) {
  const Vector2d d = q - c;
  CExactContact contact;
  contact.m_fGap = d.norm() - D;
  contact.m_vNorm = Geometry::Unit(d, Geometry::Unit(-w, Vector2d(0, 1)));
  const double a = w.squaredNorm(), b = d.dot(w), e = contact.m_fGap * (d.norm() + D);
  if (!(b < 0.0)) return contact;
  const double discriminant = D * D * a - Geometry::Cross(d, w) * Geometry::Cross(d, w);
  if (discriminant <= 0.0) {
    contact.m_bMisses = true;
    contact.m_vNorm = Geometry::Unit(d - (b / a) * w, contact.m_vNorm);
    return contact;
  }
  contact.m_fTime = e / (-b + std::sqrt(discriminant));
  contact.m_vNorm = Geometry::Unit(d + contact.m_fTime * w, contact.m_vNorm);
  return contact;
}

// From inside onto such a circle.
CExactContact ContactOnRing(const Vector2d& c, double D, const Vector2d& q, const Vector2d& w) {
  const Vector2d d = q - c;
  CExactContact contact;
  contact.m_fGap = D - d.norm();
  contact.m_vNorm = Geometry::Unit(-d, Geometry::Unit(-w, Vector2d(0, 1)));
  const double a = w.squaredNorm(), b = d.dot(w), e = contact.m_fGap * (d.norm() + D);
  const double discriminant = D * D * a - Geometry::Cross(d, w) * Geometry::Cross(d, w);
  if (!(a > 0.0) || discriminant <= 0.0) return contact;
  const double time = b > 0.0 ? e / (b + std::sqrt(discriminant)) : (-b + std::sqrt(discriminant)) / a;
  // One that moves inward may still meet it soon, if it goes along it.
  if (!(b > 0.0) && time * std::sqrt(a) > 0.5 * D) return contact;
  contact.m_fTime = time;
  contact.m_vNorm = Geometry::Unit(-(d + contact.m_fTime * w), contact.m_vNorm);
  return contact;
}

// Onto a circle of radius R, on the side where the ball is.
CExactContact ContactOnCircle(const Vector2d& c, double R, const Vector2d& q, const Vector2d& w, double r) {
  const bool fitsInside = (q - c).norm() < R && r < R;
  return fitsInside ? ContactOnRing(c, R - r, q, w) : ContactOnDisk(c, R + r, q, w);
}

// Onto the line through p with the unit normal n, which points to the ball.
CExactContact ContactOnLine(const Vector2d& p, const Vector2d& n, const Vector2d& q, const Vector2d& w,
                            double r) {
  CExactContact contact;
  contact.m_vNorm = n;
  contact.m_fGap = (q - p).dot(n) - r;
  const double wn = w.dot(n);
  if (wn < 0.0) contact.m_fTime = contact.m_fGap / -wn;
  return contact;
}

// Whether the ball goes there, by its way.
bool IsAhead(const CExactContact& contact, const Vector2d& w) {
  return w.dot(contact.m_vNorm) < 0.0 && !contact.m_bMisses;
}

// Past an end.
CExactContact ContactOnEnd(const CContactGeometry::CEnd& end, const Vector2d& q, const Vector2d& w,
                           double r) {
  CExactContact round = ContactOnDisk(end.m_vPos, r, q, w);
  if (end.m_bIsShared) {
    // Beyond the end is the neighbour: what meets it beyond the end does not meet the end.
    const Vector2d left = Geometry::Perp(end.m_vNext);
    CExactContact beyond =
        end.m_fBend == 0.0
            ? ContactOnLine(end.m_vPos, (q - end.m_vPos).dot(left) < 0.0 ? Vector2d(-left) : left, q, w, r)
            : ContactOnCircle(end.m_vPos + left / end.m_fBend, 1.0 / std::abs(end.m_fBend), q, w, r);
    const bool isBeyond = (q + beyond.m_fTime * w - r * beyond.m_vNorm - end.m_vPos).dot(end.m_vNext) > 0.0;
    // Round a corner the end may come first.
    const bool endIsFirst = IsAhead(round, w) && round.m_fTime < beyond.m_fTime;
    if (isBeyond && !endIsFirst) return beyond;
  }
  return round;
}

CExactContact ContactOnLineSeg(const CContactGeometry& o, const Vector2d& q, const Vector2d& w, double r) {
  const Vector2d& t = o.m_cEnd1.m_vOut;
  const Vector2d n =
      Geometry::Cross(t, q - o.m_cEnd0.m_vPos) < 0.0 ? Vector2d(-Geometry::Perp(t)) : Geometry::Perp(t);
  CExactContact face = ContactOnLine(o.m_cEnd0.m_vPos, n, q, w, r);
  const Vector2d foot = q + face.m_fTime * w;
  if ((foot - o.m_cEnd0.m_vPos).dot(t) < 0.0) return ContactOnEnd(o.m_cEnd0, q, w, r);
  if ((foot - o.m_cEnd1.m_vPos).dot(t) > 0.0) return ContactOnEnd(o.m_cEnd1, q, w, r);
  return face;
}

bool IsInSector(const CContactGeometry& o, const Vector2d& d) {
  const bool after0 = Geometry::Cross(o.m_cEnd0.m_vPos - o.m_vCentre, d) >= 0.0,
             before1 = Geometry::Cross(d, o.m_cEnd1.m_vPos - o.m_vCentre) >= 0.0;
  return o.m_bFull || (o.m_bLong ? after0 || before1 : after0 && before1);
}

CExactContact ContactOnArcEnd(const CContactGeometry& o, const Vector2d& q, const Vector2d& w, double r) {
  // By where the ball is now: its way to the circle may be long where there is no arc.
  const bool isNear0 = (q - o.m_cEnd0.m_vPos).squaredNorm() < (q - o.m_cEnd1.m_vPos).squaredNorm();
  CExactContact nearer = ContactOnEnd(isNear0 ? o.m_cEnd0 : o.m_cEnd1, q, w, r);
  // Between two ends that are close it may leave the nearer one for the other.
  const CContactGeometry::CEnd& other = isNear0 ? o.m_cEnd1 : o.m_cEnd0;
  if (other.m_bIsShared || nearer.m_fGap < 0.0) return nearer;
  const CExactContact farther = ContactOnEnd(other, q, w, r);
  const bool isNear = IsAhead(farther, w) && farther.m_fTime * w.norm() < r;
  return isNear && (!IsAhead(nearer, w) || farther.m_fTime < nearer.m_fTime) ? farther : nearer;
}

CExactContact ContactOnArc(const CContactGeometry& o, const Vector2d& q, const Vector2d& w, double r) {
  CExactContact curve = ContactOnCircle(o.m_vCentre, o.m_fRadius, q, w, r);
  const bool onCurve = IsInSector(o, q + curve.m_fTime * w - o.m_vCentre);
  if (onCurve && IsInSector(o, q - o.m_vCentre)) return curve;
  const CExactContact end = ContactOnArcEnd(o, q, w, r);
  // From beyond an end, the end may be in the way of the curve, and a clear ball has not met the curve.
  const bool curveIsFirst =
      curve.m_fTime > 0.0 ? !IsAhead(end, w) || end.m_fTime > curve.m_fTime : end.m_fGap < 0.0;
  return onCurve && curveIsFirst ? curve : end;
}

CExactContact FindContact(const CContactGeometry& o, const Vector2d& q, const Vector2d& w, double r) {
  switch (o.m_eKind) {
  case CContactGeometry::eKind::LineSeg: return ContactOnLineSeg(o, q, w, r);
  case CContactGeometry::eKind::Arc: return ContactOnArc(o, q, w, r);
  default: return ContactOnDisk(o.m_vCentre, o.m_fRadius + r, q, w);
  }
}

} // namespace

CExactContact FindExactContact(const CContactGeometry& geometry, const Vector2d& q, const Vector2d& w,
                               double r) {
  CExactContact now = FindContact(geometry, q, Vector2d::Zero(), r);
  if (w == Vector2d::Zero()) return now;
  CExactContact contact = FindContact(geometry, q, w, r);
  // A contact that the ball has passed through and left is over.
  if (contact.m_fTime < 0.0 && now.m_fGap > 0.0) return now;
  // A parting contact is not traced; but a ball that came past an end may approach a face by now.
  const bool parts = !IsAhead(contact, w), partsNow = !(w.dot(now.m_vNorm) < 0.0);
  if (parts && (now.m_fGap < 0.0 || (partsNow && !contact.m_bMisses))) return now;
  contact.m_fGap = now.m_fGap;
  return contact;
}

} // namespace Shapes::Box2D
