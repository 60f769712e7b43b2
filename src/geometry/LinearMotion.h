// SPDX-License-Identifier: MIT
// A motion as a shape at rest sees it, and when it reaches a feature: closed forms without cancellation.
#pragma once

#include "Features.h"
#include "TimeOfImpact.h"

#include "../Tolerances.h"

#include <limits>

namespace Shapes::Geometry {

/// The gap that counts as touching, and the speed that counts as none.
struct CRoundings {
  double m_fTouch, m_fSlow;

  CRoundings(double size, double speed) : m_fTouch(g_fShare * size), m_fSlow(g_fShare * speed) {}

  static constexpr double g_fShare = g_nSweepRoundings * std::numeric_limits<double>::epsilon();
};

/// The end of a closed form: an impact of the motion at the time above / below, neither negative, if that is
/// a number up to t, and the place counts.
template <class TMotion, class F>
eSweep MeetAt(const TMotion& motion, double above, double below, const F& counts, double& t) {
  const double quotient = Quotient(above, below, t), time = std::min(quotient, t);
  if (!std::isfinite(quotient) || !counts(motion.At(time).m_vPos)) return eSweep::None;
  t = time;
  return eSweep::Impact;
}

/// TimeOfImpact(feature, deepest, counts, t): whether the ball touches and approaches the feature at some
/// time up to t, and the first such time in t. Then `counts` says of the place of the centre whether the
/// feature is solid there. A ball that overlaps by more than `deepest` is ignored.
class CLinearMotion {
public:
  CLinearMotion(const CMotion& motion, const CRoundings& roundings)
      : m_cMotion(motion), m_cRoundings(roundings) {}

  const CMotion& GetMotion() const { return m_cMotion; }
  double GetTouch() const { return m_cRoundings.m_fTouch; }
  CBallAt At(double t) const {
    return {m_cMotion.m_vPos + m_cMotion.m_vVel * t, m_cMotion.m_vVel, m_cMotion.m_fRadius};
  }

  /// The earlier root of |d + v t| = R, where d is from the centre of the disc, R the sum of both radii and
  /// b = d.v: with disc = (R|v| - |d x v|)(R|v| + |d x v|) it is (|d| - R)(|d| + R) / (sqrt(disc) - b).
  /// Error at most 16 eps (|d| + R) / approach speed + 4 eps t.
  template <class F>
  eSweep TimeOfImpact(const CDisk& feature, double deepest, const F& counts, double& t) const {
    const CSpot spot = feature.At(At(0.0));
    if (spot.m_fGap <= GetTouch()) return AtOnce(spot, deepest, counts, t);
    const Vector2d d = m_cMotion.m_vPos - feature.m_vCenter;
    const double R = feature.m_fRadius + m_cMotion.m_fRadius, b = d.dot(m_cMotion.m_vVel);
    if (!(b < 0.0)) return eSweep::None;
    const double reach = R * Norm(m_cMotion.m_vVel), aside = std::abs(Cross(d, m_cMotion.m_vVel));
    // A tangent does not approach; a point meets a point only head on.
    if (reach < aside || (reach == aside && R > 0.0)) return eSweep::None;
    // One by one, because the product of four lengths may underflow.
    const double root = std::sqrt(reach - aside) * std::sqrt(reach + aside);
    return MeetAt(*this, spot.m_fGap * (Norm(d) + R), root - b, counts, t);
  }

  /// The later root, R being the difference of the radii. The approach may be as slow as nothing, where the
  /// ball rolls along the circle.
  template <class F>
  eSweep TimeOfImpact(const CRing& feature, double deepest, const F& counts, double& t) const {
    const CSpot spot = feature.At(At(0.0));
    const double gap = spot.m_fGap;
    if (gap <= GetTouch() && Approaches(spot)) return AtOnce(spot, deepest, counts, t);
    const Vector2d d = m_cMotion.m_vPos - feature.m_vCenter;
    const double R = feature.m_fRadius - m_cMotion.m_fRadius, b = d.dot(m_cMotion.m_vVel), dist = Norm(d);
    const double speed = Norm(m_cMotion.m_vVel), reach = R * speed;
    double aside = std::abs(Cross(d, m_cMotion.m_vVel));
    if (reach < aside) {
      // The way does not enter the circle in which the centre is clear. A ball that overlaps from the start
      // begins to approach where it is closest to the centre.
      if (gap < -std::max(deepest, GetTouch()) || !counts(m_cMotion.m_vPos)) return eSweep::None;
      aside = reach;
    }
    const double root = std::sqrt(reach - aside) * std::sqrt(reach + aside);
    // A ball that touches and rolls along it is there already; its approach speed is rounding.
    if (b > 0.0) return MeetAt(*this, gap > GetTouch() ? gap * (R + dist) : 0.0, b + root, counts, t);
    return MeetAt(*this, root - b, speed * speed, counts, t);
  }

  /// Error as for a disc.
  template <class F>
  eSweep TimeOfImpact(const CHalfPlane& feature, double deepest, const F& counts, double& t) const {
    const CSpot spot = feature.At(At(0.0));
    if (spot.m_fGap <= GetTouch()) return AtOnce(spot, deepest, counts, t);
    return MeetAt(*this, spot.m_fGap, -Rate(spot), counts, t);
  }

  /// Where it does not meet the face that it sees, it meets the ends if anything: it is clear of the segment,
  /// or leaves it for good.
  template <class F>
  eSweep TimeOfImpact(const CSegment& feature, double deepest, const F& counts, double& t) const {
    const CSpot spot = feature.At(At(0.0));
    if (spot.m_fGap <= GetTouch()) return AtOnce(spot, deepest, counts, t);
    const Vector2d from0 = m_cMotion.m_vPos - feature.m_vPt0;
    const CHalfPlane face{feature.m_vPt0,
                          feature.m_vFront.dot(from0) < 0.0 ? Vector2d(-feature.m_vFront) : feature.m_vFront};
    const auto between = [&](const Vector2d& p) { return feature.IsBetween(p, GetTouch()); };
    if (TimeOfImpact(face, deepest, between, t) == eSweep::Impact) return eSweep::Impact;
    const bool met0 = TimeOfImpact(CDisk{feature.m_vPt0, 0.0}, deepest, counts, t) == eSweep::Impact;
    const bool met1 = TimeOfImpact(CDisk{feature.m_vPt1, 0.0}, deepest, counts, t) == eSweep::Impact;
    return met0 || met1 ? eSweep::Impact : eSweep::None;
  }

  /// CImpact::m_fCurve, for an impact on the feature.
  double GetCurve(const CRing& feature, const CSpot& spot) const {
    const double along = Cross(spot.m_vNorm, m_cMotion.m_vVel);
    return along * along / (feature.m_fRadius - m_cMotion.m_fRadius);
  }
  template <class TFeature>
  double GetCurve(const TFeature&, const CSpot&) const {
    return 0.0;
  }
  /// CImpact::m_fClosing.
  double GetClosing(const CSpot& spot, double t) const { return spot.Closing(At(t), m_cMotion.m_vAcc); }

private:
  double Rate(const CSpot& spot) const { return spot.Rate(At(0.0)); }
  bool Approaches(const CSpot& spot) const { return Rate(spot) < -m_cRoundings.m_fSlow; }

  template <class F>
  eSweep AtOnce(const CSpot& spot, double deepest, const F& counts, double& t) const {
    const bool letGo = spot.m_fGap < -std::max(deepest, GetTouch());
    if (letGo || !Approaches(spot) || !counts(m_cMotion.m_vPos)) return eSweep::None;
    t = 0.0;
    return eSweep::Impact;
  }

  CMotion m_cMotion;
  CRoundings m_cRoundings;
};

} // namespace Shapes::Geometry
