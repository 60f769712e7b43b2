// SPDX-License-Identifier: MIT
// A leg as a shape at rest sees it, and when it reaches a part: closed forms without cancellation.
#pragma once

#include "Sweep.h"
#include "SweepParts.h"

#include <Shapes/Tolerances.h>

#include <limits>

namespace Shapes::Native {

/// What counts as touching, and as no speed.
struct CRoundings {
  double m_fTouch, m_fSlow;

  CRoundings(double size, double speed) : m_fTouch(g_fShare * size), m_fSlow(g_fShare * speed) {}

private:
  static constexpr double g_fShare = g_nSweepRoundings * std::numeric_limits<double>::epsilon();
};

/// When(part, deepest, counts, t): whether the ball touches and approaches the part at some time up to t, and
/// the first such time in t. Then `counts` says of the place of the centre whether the part is solid there.
/// A ball that overlaps by more than `deepest` is let go.
class CStraightLeg {
public:
  CStraightLeg(const CLeg& leg, const CRoundings& roundings) : m_cLeg(leg), m_cRoundings(roundings) {}

  const CLeg& GetLeg() const { return m_cLeg; }
  double GetTouch() const { return m_cRoundings.m_fTouch; }
  CSeenBall At(double t) const {
    return {m_cLeg.m_vPos + m_cLeg.m_vVel * t, m_cLeg.m_vVel, m_cLeg.m_fRadius};
  }

  /// The earlier root of |d + v t| = R, where d is from the centre of the disc, R the sum of both radii and
  /// b = d.v: with disc = (R|v| - |d x v|)(R|v| + |d x v|) it is (|d| - R)(|d| + R) / (sqrt(disc) - b).
  /// Error at most 16 eps (|d| + R) / approach speed + 4 eps t.
  template <class F>
  eSweep When(const CRoundPart& part, double deepest, const F& counts, double& t) const {
    const CSpot spot = part.At(At(0.0));
    if (spot.m_fGap <= GetTouch()) return AtOnce(spot, deepest, counts, t);
    const Vector2d d = m_cLeg.m_vPos - part.m_vCenter;
    const double R = part.m_fRadius + m_cLeg.m_fRadius, b = d.dot(m_cLeg.m_vVel);
    if (!(b < 0.0)) return eSweep::None;
    const double reach = R * Norm(m_cLeg.m_vVel), aside = std::abs(Cross(d, m_cLeg.m_vVel));
    // A tangent does not approach; a point meets a point only head on.
    if (reach < aside || (reach == aside && R > 0.0)) return eSweep::None;
    // One by one, because the product of four lengths may underflow.
    const double root = std::sqrt(reach - aside) * std::sqrt(reach + aside);
    return Then(spot.m_fGap * (Norm(d) + R), root - b, counts, t);
  }

  /// The later root, R being the difference of the radii. The approach may be as slow as nothing, where the
  /// ball rolls along the circle.
  template <class F>
  eSweep When(const CInsidePart& part, double deepest, const F& counts, double& t) const {
    const CSpot spot = part.At(At(0.0));
    const double gap = spot.m_fGap;
    if (gap <= GetTouch() && Approaches(spot)) return AtOnce(spot, deepest, counts, t);
    const Vector2d d = m_cLeg.m_vPos - part.m_vCenter;
    const double R = part.m_fRadius - m_cLeg.m_fRadius, b = d.dot(m_cLeg.m_vVel), dist = Norm(d);
    const double speed = Norm(m_cLeg.m_vVel), reach = R * speed;
    double aside = std::abs(Cross(d, m_cLeg.m_vVel));
    if (reach < aside) {
      // The way does not enter the circle in which the centre is clear. A ball that overlaps from the start
      // begins to approach where it is closest to the centre.
      if (gap < -std::max(deepest, GetTouch()) || !counts(m_cLeg.m_vPos)) return eSweep::None;
      aside = reach;
    }
    const double root = std::sqrt(reach - aside) * std::sqrt(reach + aside);
    // What touches and rolls along it is there already: how fast it comes closer is rounding.
    if (b > 0.0) return Then(gap > GetTouch() ? gap * (R + dist) : 0.0, b + root, counts, t);
    return Then(root - b, speed * speed, counts, t);
  }

  /// Error as for a disc.
  template <class F>
  eSweep When(const CFacePart& part, double deepest, const F& counts, double& t) const {
    const CSpot spot = part.At(At(0.0));
    if (spot.m_fGap <= GetTouch()) return AtOnce(spot, deepest, counts, t);
    return Then(spot.m_fGap, -Rate(spot), counts, t);
  }

  /// Where it does not meet the face that it sees, it meets the ends if anything: it is clear of the segment,
  /// or leaves it for good.
  template <class F>
  eSweep When(const CLineSegPart& part, double deepest, const F& counts, double& t) const {
    const CSpot spot = part.At(At(0.0));
    if (spot.m_fGap <= GetTouch()) return AtOnce(spot, deepest, counts, t);
    const Vector2d from0 = m_cLeg.m_vPos - part.m_vPt0;
    const CFacePart face{part.m_vPt0,
                         part.m_vFront.dot(from0) < 0.0 ? Vector2d(-part.m_vFront) : part.m_vFront};
    const Vector2d along = part.Along();
    const auto between = [&](const Vector2d& p) {
      return along.dot(p - part.m_vPt0) >= -GetTouch() && along.dot(p - part.m_vPt1) <= GetTouch();
    };
    if (When(face, deepest, between, t) == eSweep::Impact) return eSweep::Impact;
    const bool met0 = When(CRoundPart{part.m_vPt0, 0.0}, deepest, counts, t) == eSweep::Impact;
    const bool met1 = When(CRoundPart{part.m_vPt1, 0.0}, deepest, counts, t) == eSweep::Impact;
    return met0 || met1 ? eSweep::Impact : eSweep::None;
  }

  /// CImpact::m_fCurve, for an impact on the part.
  double GetCurve(const CInsidePart& part, const CSpot& spot) const {
    const double along = Cross(spot.m_vNorm, m_cLeg.m_vVel);
    return along * along / (part.m_fRadius - m_cLeg.m_fRadius);
  }
  template <class TPart>
  double GetCurve(const TPart&, const CSpot&) const {
    return 0.0;
  }

private:
  double Rate(const CSpot& spot) const { return spot.Rate(At(0.0)); }
  bool Approaches(const CSpot& spot) const { return Rate(spot) < -m_cRoundings.m_fSlow; }

  template <class F>
  eSweep AtOnce(const CSpot& spot, double deepest, const F& counts, double& t) const {
    const bool letGo = spot.m_fGap < -std::max(deepest, GetTouch());
    if (letGo || !Approaches(spot) || !counts(m_cLeg.m_vPos)) return eSweep::None;
    t = 0.0;
    return eSweep::Impact;
  }

  // At the time above / below, if that is a number up to t.
  template <class F>
  eSweep Then(double above, double below, const F& counts, double& t) const {
    const double quotient = Quotient(above, below, t), time = std::min(quotient, t);
    if (!std::isfinite(quotient) || !counts(At(time).m_vPos)) return eSweep::None;
    t = time;
    return eSweep::Impact;
  }

  CLeg m_cLeg;
  CRoundings m_cRoundings;
};

} // namespace Shapes::Native
