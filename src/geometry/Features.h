// SPDX-License-Identifier: MIT
// The features that shapes are made of, and where a ball is closest to each. Both are in the frame of the
// shape.
#pragma once

#include "ShapeGeometry.h"

#include <algorithm>
#include <limits>

namespace Shapes::Geometry {

/// A ball as the shape sees it at some time.
struct CBallAt {
  Vector2d m_vPos; ///< centre
  Vector2d m_vVel;
  double m_fRadius;
};

/// Where a ball and a feature are closest.
struct CSpot {
  double m_fGap; ///< negative if they overlap
  Vector2d m_vNorm, m_vPOI;
  /// Of curvature of the feature there: positive where it bulges towards the ball, infinite where it is flat.
  double m_fRadius = std::numeric_limits<double>::infinity();

  double Rate(const CBallAt& ball) const { return m_vNorm.dot(ball.m_vVel); } ///< of the gap
  /// Minus the second derivative of the gap, for this acceleration of the ball relative to the feature.
  double Closing(const CBallAt& ball, const Vector2d& acceleration) const {
    const double along = Cross(m_vNorm, ball.m_vVel), R = m_fRadius + ball.m_fRadius;
    return -m_vNorm.dot(acceleration) - (R == 0.0 ? 0.0 : along * along / R);
  }
};

/// Direction of d, which is from a feature to the ball. From exactly on the spot it is back where it came
/// from.
inline Vector2d Away(const Vector2d& d, const CBallAt& ball) {
  if (!(Norm(d) > 0.0)) return Unit(-ball.m_vVel, Vector2d::UnitY());
  return Unit(d, Vector2d::UnitY());
}

/// A disc from outside; a point if it has no radius.
struct CDisk {
  Vector2d m_vCenter;
  double m_fRadius;

  double GetGap(const CBallAt& ball) const {
    return Norm(ball.m_vPos - m_vCenter) - (m_fRadius + ball.m_fRadius);
  }
  CSpot At(const CBallAt& ball) const {
    const Vector2d n = Away(ball.m_vPos - m_vCenter, ball);
    return {GetGap(ball), n, m_vCenter + m_fRadius * n, m_fRadius};
  }
};

/// A circle from inside.
struct CRing {
  Vector2d m_vCenter;
  double m_fRadius;

  double GetGap(const CBallAt& ball) const {
    return m_fRadius - ball.m_fRadius - Norm(ball.m_vPos - m_vCenter);
  }
  CSpot At(const CBallAt& ball) const {
    const Vector2d d = ball.m_vPos - m_vCenter, out = Away(d, ball);
    // Right in the middle it is met where it goes.
    const Vector2d n = d.isZero(0.0) ? out : Vector2d(-out);
    return {GetGap(ball), n, m_vCenter - m_fRadius * n, -m_fRadius};
  }
};

/// A line from the side of its normal.
struct CHalfPlane {
  Vector2d m_vPt, m_vNorm;

  double GetGap(const CBallAt& ball) const { return m_vNorm.dot(ball.m_vPos - m_vPt) - ball.m_fRadius; }
  CSpot At(const CBallAt& ball) const {
    const double s = m_vNorm.dot(ball.m_vPos - m_vPt);
    return {GetGap(ball), m_vNorm, ball.m_vPos - s * m_vNorm};
  }
};

/// A segment with both faces and its ends, of a length above 0.
struct CSegment {
  Vector2d m_vPt0, m_vPt1, m_vFront;

  Vector2d Along() const { return -Perp(m_vFront); }
  /// Whether p is not beyond an end by more than `touch`.
  bool IsBetween(const Vector2d& p, double touch) const {
    return Along().dot(p - m_vPt0) >= -touch && Along().dot(p - m_vPt1) <= touch;
  }
  /// Whether the ball is on the side of the front; exactly on the line, whether it came from there.
  bool IsInFront(const CBallAt& ball) const {
    const double s = m_vFront.dot(ball.m_vPos - m_vPt0);
    return s > 0.0 || (s == 0.0 && !(m_vFront.dot(ball.m_vVel) > 0.0));
  }

  // The end that the ball is closest to; none where it is closest to a face.
  const Vector2d* GetEnd(const CBallAt& ball) const {
    if (!(Along().dot(ball.m_vPos - m_vPt0) > 0.0)) return &m_vPt0;
    if (!(Along().dot(ball.m_vPos - m_vPt1) < 0.0)) return &m_vPt1;
    return nullptr;
  }

  double GetGap(const CBallAt& ball) const {
    if (const Vector2d* pEnd = GetEnd(ball)) return CDisk{*pEnd, 0.0}.GetGap(ball);
    return std::abs(m_vFront.dot(ball.m_vPos - m_vPt0)) - ball.m_fRadius;
  }
  CSpot At(const CBallAt& ball) const {
    if (const Vector2d* pEnd = GetEnd(ball)) return CDisk{*pEnd, 0.0}.At(ball);
    const double s = m_vFront.dot(ball.m_vPos - m_vPt0);
    const Vector2d n = IsInFront(ball) ? m_vFront : Vector2d(-m_vFront);
    return {std::abs(s) - ball.m_fRadius, n, ball.m_vPos - s * m_vFront};
  }
};

} // namespace Shapes::Geometry
