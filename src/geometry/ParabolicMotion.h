// SPDX-License-Identifier: MIT
// A ball that falls, as a shape at rest sees it, and when it reaches a feature: lines by closed forms, what
// is round by the steps of CCurvedMotion.
#pragma once

#include "CurvedMotion.h"

namespace Shapes::Geometry {

/// TimeOfImpact as of CLinearMotion, and OutOfIterations as of CCurvedMotion.
class CParabolicMotion : public CCurvedMotion {
public:
  using CCurvedMotion::CCurvedMotion;
  using CCurvedMotion::TimeOfImpact; // discs, and rings from inside

  CBallAt At(double t) const { return {GetMotion().PosAt(t), GetMotion().VelAt(t), GetMotion().m_fRadius}; }

  /// The root of gap + rate t + a t^2/2 at which the gap falls: with s = sqrt(rate^2 - 2 a gap) it is 2 gap /
  /// (s - rate), and (s + rate) / -a where the rate is above 0. Error as of CLinearMotion.
  template <class F>
  eSweep TimeOfImpact(const CHalfPlane& feature, double deepest, const F& counts, double& t) const {
    const CBallAt ball = At(0.0);
    const CSpot spot = feature.At(ball);
    const double touch = GetTouch(), a = feature.m_vNorm.dot(GetMotion().m_vAcc), rate = spot.Rate(ball);
    const double gap = spot.m_fGap;
    // One that touches is there at once, or when gravity has turned it round. One that began deeper is
    // ignored until it is clear, or begins to approach.
    const bool isTouching = gap <= touch, isLetGo = gap < -std::max(deepest, touch);
    if (isTouching && !isLetGo) {
      if (rate < -GetSlow()) return MeetAt(*this, 0.0, 1.0, counts, t);
      if (!(a < 0.0)) return eSweep::None;
      const double up = std::max(rate, 0.0), slow = GetSlow();
      if (gap >= -touch) return MeetAt(*this, 2.0 * up + slow, -a, counts, t);
      if (up * up <= -2.0 * a * (touch - gap)) return MeetAt(*this, up + slow, -a, counts, t);
      // It is clear before it begins to approach.
    }
    const double discriminant = rate * rate - 2.0 * a * gap;
    if (!(discriminant > 0.0)) return eSweep::None;
    const double s = std::sqrt(discriminant);
    if (rate > 0.0) return MeetAt(*this, s + rate, -a, counts, t);
    return gap < 0.0 ? eSweep::None : MeetAt(*this, 2.0 * gap, s - rate, counts, t);
  }

  /// Either face, and the ends.
  template <class F>
  eSweep TimeOfImpact(const CSegment& feature, double deepest, const F& counts, double& t) const {
    const auto between = [&](const Vector2d& p) { return feature.IsBetween(p, GetTouch()); };
    // The face that is seen may be overlapped; the other one is behind it until the ball is round an end.
    const bool isInFront = feature.IsInFront(At(0.0));
    bool isMet = false;
    for (const bool seen : {true, false}) {
      const CHalfPlane face{feature.m_vPt0,
                            isInFront == seen ? feature.m_vFront : Vector2d(-feature.m_vFront)};
      isMet |= TimeOfImpact(face, seen ? deepest : 0.0, between, t) == eSweep::Impact;
    }
    bool isOut = false;
    for (const Vector2d& end : {feature.m_vPt0, feature.m_vPt1}) {
      double until = t;
      const eSweep found = TimeOfImpact(CDisk{end, 0.0}, deepest, counts, until);
      if (found == eSweep::None) continue;
      t = until;
      isMet |= found == eSweep::Impact;
      isOut = found == eSweep::OutOfIterations;
    }
    return isOut ? eSweep::OutOfIterations : isMet ? eSweep::Impact : eSweep::None;
  }

  double GetClosing(const CSpot& spot, double t) const { return spot.Closing(At(t), GetMotion().m_vAcc); }
};

} // namespace Shapes::Geometry
