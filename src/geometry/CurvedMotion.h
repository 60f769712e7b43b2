// SPDX-License-Identifier: MIT
// A motion on a curve, as a turning shape sees it or as a ball falls, and when it reaches a feature: by steps
// that are never too long.
#pragma once

#include "LinearMotion.h"

namespace Shapes::Geometry {

/// The motion in the frame of the shape, which is the world's at time 0. A function f of it with f'' >= -K
/// cannot reach 0 before the smallest root h of f + f' h - K h^2/2, and that is the step. Close to the impact
/// it converges as Newton's method does.
///
/// K is the least that is known, A being the acceleration of the ball in the world: the centre of what is
/// round moves on a circle, so the distance from it, which is convex, has K = its acceleration + A. Where the
/// shape does not turn and the gap is small it is half of the square of the distance that is followed: with
/// the distance a ball that gravity moves along a surface which it touches would take thousands of steps. In
/// the frame the ball is accelerated by at most M = 2|w||v| + w^2 |x - c| + A, so the distance from a segment
/// with its ends, which is convex too, has K = M. From inside a circle it is (rho^2 - |x|^2)/2 that is
/// followed, where rho = R - r.
class CCurvedMotion {
public:
  CCurvedMotion(const CShapeGeometry& shape, const CMotion& motion, const CRoundings& roundings)
      : m_cMotion(motion),
        m_cRoundings(roundings),
        m_vRotCenter(shape.m_vRotCenter),
        m_fTurn(shape.m_fTurnSpeed),
        m_fFall(Norm(motion.m_vAcc)),
        m_fSpeed(Norm(motion.m_vVel) + m_fFall * motion.m_fDuration) {
    m_fReach = std::max(Norm(FromCenter(0.0)), Norm(FromCenter(motion.m_fDuration))) + motion.GetSagitta();
  }

  const CMotion& GetMotion() const { return m_cMotion; }
  double GetTouch() const { return m_cRoundings.m_fTouch; }
  double GetSlow() const { return m_cRoundings.m_fSlow; }
  CBallAt At(double t) const {
    const Vector2d d = FromCenter(t), v = m_cMotion.VelAt(t);
    if (m_fTurn == 0.0) return {m_vRotCenter + d, v, m_cMotion.m_fRadius};
    const CTurn turn = GetTurn(m_fTurn * t);
    const auto inFrame = [&turn](const Vector2d& x) -> Vector2d {
      return {turn.m_fCos * x.x() + turn.m_fSin * x.y(), turn.m_fCos * x.y() - turn.m_fSin * x.x()};
    };
    return {m_vRotCenter + inFrame(d), inFrame(v - m_fTurn * Perp(d)), m_cMotion.m_fRadius};
  }

  /// As of CLinearMotion, and OutOfIterations if the advancement did not come to an end: nothing is met
  /// before t then.
  template <class TFeature, class F>
  eSweep TimeOfImpact(const TFeature& feature, double deepest, const F& counts, double& t) const {
    const double touch = m_cRoundings.m_fTouch, slow = m_cRoundings.m_fSlow, end = t;
    // A step in which the gap bends by no more than this.
    const double root = std::sqrt(GetCurve(feature));
    const auto bendStep = [&](double bend) { return Quotient(std::sqrt(2.0 * bend), root, end); };
    const double least = bendStep(touch);
    bool armed = true;              // not while the ball is let through
    double now = 0.0, give = touch; // overlap that may be missed
    int touching = 0;               // steps
    for (int i = 0; i < g_nMaxAdvancementSteps; ++i) {
      const CBallAt ball = At(now);
      const CSpot spot = feature.At(ball);
      const double gap = spot.m_fGap, rate = spot.Rate(ball), tick = 4.0 * g_fEps * now;
      if (i == 0) armed = gap >= -std::max(deepest, touch);
      armed = armed || gap > touch;

      // An end about which a segment turns touches all the time: it is not looked at in each rounding.
      if (gap > touch)
        give = touch, touching = 0;
      else if (armed && ++touching > g_nTouchingSteps)
        give *= g_fTouchingGrowth;
      double step;
      if (gap > touch)
        step = SafeStep(Nearing(feature, gap, rate), end);
      else if (armed) // ignored until it begins to approach
        step =
            std::max(SlowStep(Nearing(feature, gap, rate), end), bendStep(std::max(give, -g_fDeeper * gap)));
      else
        step = std::max(SafeStep(Leaving(feature, gap, rate), end), least);

      if (armed && rate < -slow && (gap <= touch || step <= tick)) {
        if (counts(ball.m_vPos)) {
          // The time that the rest of the gap takes.
          t = std::min(now + std::min(Quotient(std::max(gap, 0.0), -rate, end), least), end);
          return eSweep::Impact;
        }
        armed = false;
        step = least;
      }
      now += std::max({step, tick, g_fTiny});
      if (now > end) return eSweep::None;
    }
    t = now;
    return eSweep::OutOfIterations;
  }

  template <class TFeature>
  double GetCurve(const TFeature& feature, const CSpot&) const {
    return GetCurve(feature);
  }
  /// Of a ball that falls; 0 otherwise.
  double GetClosing(const CSpot& spot, double t) const {
    if (m_fFall == 0.0) return 0.0;
    const CBallAt ball = At(t);
    const Vector2d fall = Turned(m_cMotion.m_vAcc, -m_fTurn * t);
    const Vector2d inFrame = m_fTurn * (m_fTurn * (ball.m_vPos - m_vRotCenter) - 2.0 * Perp(ball.m_vVel));
    return spot.Closing(ball, fall + inFrame);
  }

private:
  static constexpr double g_fEps = std::numeric_limits<double>::epsilon();
  static constexpr double g_fTiny = std::numeric_limits<double>::min();
  // Where the gap is larger than a part of the radii, to follow the square would be slower; deep in a disc it
  // says little of the gap.
  static constexpr double g_fSquareGap = 8.0;
  static constexpr double g_fSquareRounding = 16.0 * g_fEps;

  template <class TFeature>
  double GetCurve(const TFeature& feature) const {
    const CFollowed f = Nearing(feature, 0.0, 1.0);
    return f.m_fBend / f.m_fRate;
  }
  // Of the distance, also where its square is followed: the gap bends by no more at any depth.
  double GetCurve(const CDisk& feature) const { return Acceleration(feature.m_vCenter); }

  // A function f that has the sign of the gap, or the other one, and a K with f'' >= -K where f > 0.
  struct CFollowed {
    double m_fValue, m_fRate, m_fBend;
  };
  // f falls to 0 where the ball touches.
  CFollowed Nearing(const CDisk& feature, double gap, double rate) const {
    const double R = feature.m_fRadius + m_cMotion.m_fRadius;
    if (m_fTurn != 0.0 || g_fSquareGap * std::abs(gap) > R)
      return {gap, rate, Acceleration(feature.m_vCenter)};
    return {gap * (R + 0.5 * gap), rate * (R + gap), SquareBend(feature.m_vCenter)};
  }
  // The bound holds as long as the centre of the ball is within the circle.
  CFollowed Nearing(const CRing& feature, double gap, double rate) const {
    const double rho = feature.m_fRadius - m_cMotion.m_fRadius, s = Speed(feature.m_vCenter);
    return {gap * (rho - 0.5 * gap), rate * (rho - gap),
            s * s + feature.m_fRadius * Acceleration(feature.m_vCenter)};
  }
  template <class TFeature>
  CFollowed Nearing(const TFeature&, double gap, double rate) const {
    const double w = std::abs(m_fTurn);
    return {gap, rate, 2.0 * w * m_fSpeed + w * w * m_fReach + m_fFall};
  }
  // f falls to 0 where a ball that is let through is clear again. (No ball goes through a whole segment.)
  CFollowed Leaving(const CDisk& feature, double gap, double rate) const {
    const double R = feature.m_fRadius + m_cMotion.m_fRadius, s = Speed(feature.m_vCenter);
    return {-gap * (R + 0.5 * gap), -rate * (R + gap), s * s + R * Acceleration(feature.m_vCenter)};
  }
  CFollowed Leaving(const CRing& feature, double gap, double rate) const {
    const CFollowed f = Nearing(feature, gap, rate);
    const double reach = m_fReach + Norm(feature.m_vCenter - m_vRotCenter);
    return {-f.m_fValue, -f.m_fRate, reach * Acceleration(feature.m_vCenter)};
  }
  template <class TFeature>
  CFollowed Leaving(const TFeature& feature, double gap, double rate) const {
    return Nearing(feature, -gap, -rate);
  }

  // K of half the square of the distance from a point at rest. With x from that point and v at the beginning
  // its second derivative is v^2 + x a + 3 (v a) t + 3/2 a^2 t^2: above 0 as long as gravity goes along a
  // surface that is touched, and not into it.
  double SquareBend(const Vector2d& p) const {
    const Vector2d x = m_cMotion.m_vPos - p, &v = m_cMotion.m_vVel, &a = m_cMotion.m_vAcc;
    const double xa = x.dot(a), va = v.dot(a), T = m_cMotion.m_fDuration, aa = m_fFall * m_fFall;
    const double t = va < 0.0 ? std::min(Quotient(-va, aa, T), T) : 0.0;
    const double square = v.squaredNorm(), least = square + xa + (3.0 * va + 1.5 * aa * t) * t;
    return std::max(0.0, g_fSquareRounding * (square + std::abs(xa)) - least);
  }

  Vector2d FromCenter(double t) const {
    return m_cMotion.m_vPos - m_vRotCenter + (m_cMotion.m_vVel + 0.5 * t * m_cMotion.m_vAcc) * t;
  }
  // Of the ball relative to a point of the shape, at most.
  double Acceleration(const Vector2d& p) const {
    return m_fTurn * m_fTurn * Norm(p - m_vRotCenter) + m_fFall;
  }
  double Speed(const Vector2d& p) const { return m_fSpeed + std::abs(m_fTurn) * Norm(p - m_vRotCenter); }

  // Smallest h > 0 with f + f' h - K h^2/2 = 0, for f > 0.
  static double SafeStep(const CFollowed& f, double end) {
    const double value = std::max(f.m_fValue, 0.0), slope = f.m_fRate, K = f.m_fBend;
    const double root = std::sqrt(slope * slope + 2.0 * K * value);
    return slope > 0.0 ? Quotient(slope + root, K, end) : Quotient(2.0 * value, root - slope, end);
  }
  // The h with f' - K h = 0.
  static double SlowStep(const CFollowed& f, double end) {
    return Quotient(std::max(f.m_fRate, 0.0), f.m_fBend, end);
  }

  CMotion m_cMotion;
  CRoundings m_cRoundings;
  Vector2d m_vRotCenter;
  double m_fTurn;
  double m_fFall;  // acceleration of the ball in the world
  double m_fSpeed; // likewise, at most
  double m_fReach; // how far from the centre of rotation it gets
};

} // namespace Shapes::Geometry
