// SPDX-License-Identifier: MIT
// The way of a ball's centre as the shape sees it, and when it crosses a circle or a line. A straight path is
// seen by a shape at rest; a turning path by a shape that rotates, in whose frame the shape rests and the
// ball moves on a curve. Both have the same functions, so each shape is written once (Sweep.h).
//
// The crossings are those that a ball makes from clear of the circle or line, after the time t that is passed
// in; what touches already at the start of the path is the business of Sweep.h.
#pragma once

#include "Vec2.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace Shapes::Compare {

/// A gap below this many roundings of the coordinates is touching, dimensionless. Larger than what some
/// hundred events add up to; at 1 unit from the origin it is 1.4e-14 units.
inline constexpr int g_nTouchRoundings = 64;

/// A ball whose way passes within this share of the contact distance from a tangent is ambiguous: which way
/// it goes is beyond what the float descriptors say, dimensionless.
inline constexpr double g_fGraze = 1e-9;

template <class T>
struct CPathDesc {
  CVec<T> m_vPos; ///< of the ball's centre at time 0
  CVec<T> m_vVel;
  T m_fTimeMax; ///< The path ends here.
  T m_fTouch;   ///< Gaps up to this are touching.
  T m_fSlow;    ///< A touching ball that approaches no faster than this is not approaching.
};

template <class T>
class CStraightPath {
public:
  using CScalar = T;
  static constexpr bool g_bTurns = false;

  explicit CStraightPath(const CPathDesc<T>& desc) : m_cDesc(desc) {}

  const CPathDesc<T>& GetDesc() const { return m_cDesc; }
  CVec<T> GetPos(const T& t) const { return m_cDesc.m_vPos + m_cDesc.m_vVel * t; }
  CVec<T> GetVel(const T&) const { return m_cDesc.m_vVel; }

  /// When the distance from c falls to R: t is the earlier root of |d + v t| = R, by the form without
  /// cancellation: with d the way from c, b = d.v and disc = (R|v| - |d x v|)(R|v| + |d x v|),
  /// t = (|d| - R)(|d| + R) / (sqrt(disc) - b). Error at most 16 eps (|d| + R) / approach speed + 4 eps t.
  /// @param t      in: search from here, out: when
  /// @param graze  set if the way is tangent to the circle within g_fGraze, whether it crosses or not; t is
  ///               the time of the closest approach then if it does not
  bool FallToCircle(const CVec<T>& c, const T& R, T& t, bool& graze) const {
    using std::abs;
    using std::sqrt;
    graze = false;
    if (t > T(0)) return false; // a straight line enters a circle once
    const CVec<T> d = m_cDesc.m_vPos - c;
    const CVec<T>& v = m_cDesc.m_vVel;
    const T dist = Norm(d), b = d.dot(v);
    if (dist - R <= m_cDesc.m_fTouch || !(b < T(0))) return false;

    const T speed = Norm(v), aside = abs(Cross(d, v)), spare = R * speed - aside;
    const bool tangent = abs(spare) < T(g_fGraze) * R * speed;
    if (spare < T(0) || (spare == T(0) && R > T(0))) {
      t = -b / (speed * speed);
      graze = tangent && t <= m_cDesc.m_fTimeMax;
      return false;
    }
    t = (dist - R) * (dist + R) / (sqrt(spare * (R * speed + aside)) - b);
    graze = tangent && t <= m_cDesc.m_fTimeMax;
    return t <= m_cDesc.m_fTimeMax;
  }

  /// When the distance from c rises to R: the later root. Error as above. A centre that is on the circle and
  /// moves along it crosses at once, at t = 0.
  bool RiseToCircle(const CVec<T>& c, const T& R, T& t) const {
    using std::abs;
    using std::sqrt;
    if (t > T(0)) return false;
    const CVec<T> d = m_cDesc.m_vPos - c;
    const CVec<T>& v = m_cDesc.m_vVel;
    const T dist = Norm(d), b = d.dot(v), speed = Norm(v), a = speed * speed;
    const bool within = R - dist > m_cDesc.m_fTouch;
    if (!(a > T(0)) || (!within && b > m_cDesc.m_fSlow * dist)) return false;

    const T aside = abs(Cross(d, v));
    T spare = R * speed - aside;
    if (spare < T(0)) {
      // Past the circle. If it touches, this is rounding: the centre is on the circle and moves along it.
      if (dist - R > m_cDesc.m_fTouch) return false;
      spare = T(0);
    }
    const T root = sqrt(spare * (R * speed + aside));
    t = b > T(0) ? std::max(R - dist, T(0)) * (R + dist) / (b + root) : (root - b) / a;
    return t <= m_cDesc.m_fTimeMax;
  }

  /// When the distance n.(x - a) from the line through a falls to r. Error as above.
  bool FallToLine(const CVec<T>& a, const CVec<T>& n, const T& r, T& t, bool& graze) const {
    graze = false;
    if (t > T(0)) return false;
    const CVec<T> d = m_cDesc.m_vPos - a;
    const T gap = n.dot(d) - r, vn = n.dot(m_cDesc.m_vVel);
    if (gap <= m_cDesc.m_fTouch || !(vn < T(0))) return false;
    t = gap / -vn;
    return t <= m_cDesc.m_fTimeMax;
  }

private:
  CPathDesc<T> m_cDesc;
};

/// The path seen from a frame that turns at w rad/s about `center` and coincides with the world's at time 0.
/// There |x''| <= M = 2|w||v| + w^2 |p - center|. A function f of it with |f''| <= K cannot reach 0 before
/// the smallest root h of |f| - |f|' h - K h^2/2, and that is the step: it never oversteps, and close to the
/// root it converges as Newton's method does.
template <class T>
class CTurningPath {
public:
  using CScalar = T;
  static constexpr bool g_bTurns = true;

  CTurningPath(const CPathDesc<T>& desc, const CVec<T>& center, const T& w)
      : m_cDesc(desc), m_vCenter(center), m_fTurn(w) {
    using std::abs;
    using std::max;
    const CVec<T> q0 = desc.m_vPos - center, q1 = q0 + desc.m_vVel * desc.m_fTimeMax;
    m_fReach = max(Norm(q0), Norm(q1));
    m_fSpeed = Norm(desc.m_vVel) + abs(w) * m_fReach;
    m_fAccel = T(2) * abs(w) * Norm(desc.m_vVel) + w * w * m_fReach;
  }

  const CPathDesc<T>& GetDesc() const { return m_cDesc; }
  CVec<T> GetPos(const T& t) const { return m_vCenter + InFrame(FromCenter(t), t); }
  CVec<T> GetVel(const T& t) const { return InFrame(m_cDesc.m_vVel - m_fTurn * Perp(FromCenter(t)), t); }

  /// As of CStraightPath. Error at most (g_nTouchRoundings + 16) eps (size of the coordinates) / approach
  /// speed + 4 eps t. Whether a near miss is within g_fGraze is known to a factor of 2.
  bool FallToCircle(const CVec<T>& c, const T& R, T& t, bool& graze) const {
    const T scale = T(2) * R;
    return March(
        [&](const T& s, T& f, T& df) {
          const CVec<T> x = GetPos(s) - c;
          const T d = Norm(x);
          f = (d - R) * (d + R);
          df = T(2) * x.dot(GetVel(s));
        },
        CircleBound(c), scale, R, t, graze);
  }

  bool RiseToCircle(const CVec<T>& c, const T& R, T& t) const {
    bool graze;
    return March(
        [&](const T& s, T& f, T& df) {
          const CVec<T> x = GetPos(s) - c;
          const T d = Norm(x);
          f = (R - d) * (R + d);
          df = T(-2) * x.dot(GetVel(s));
        },
        CircleBound(c), T(2) * R, T(0), t, graze);
  }

  bool FallToLine(const CVec<T>& a, const CVec<T>& n, const T& r, T& t, bool& graze) const {
    return March(
        [&](const T& s, T& f, T& df) {
          const CVec<T> x = GetPos(s) - a;
          f = n.dot(x) - r;
          df = n.dot(GetVel(s));
        },
        m_fAccel, T(1), r, t, graze);
  }

private:
  CVec<T> FromCenter(const T& t) const { return m_cDesc.m_vPos - m_vCenter + m_cDesc.m_vVel * t; }
  CVec<T> InFrame(const CVec<T>& v, const T& t) const { return Turned(v, T(-m_fTurn * t)); }

  // Of |x - c|^2, whose second derivative is 2|x'|^2 + 2(x - c).x''.
  T CircleBound(const CVec<T>& c) const {
    const CVec<T> q = c - m_vCenter;
    return T(2) * m_fSpeed * m_fSpeed + T(2) * (m_fReach + Norm(q)) * m_fAccel;
  }

  // Smallest h > 0 with f + df h - K h^2/2 = 0, for f > 0.
  static T SafeStep(const T& f, const T& df, const T& K) {
    using std::sqrt;
    const T root = sqrt(df * df + T(2) * K * f);
    return df > T(0) ? (df + root) / K : T(2) * f / (root - df);
  }

  // Next time after t at which f falls to 0 having been above it, or, after touching without approaching,
  // begins to approach. `scale` is f per unit of gap near the crossing, `R` the contact distance.
  template <class F>
  bool March(const F& eval, const T& K, const T& scale, const T& R, T& t, bool& graze) const {
    using std::abs;
    using std::max;
    const T touch = m_cDesc.m_fTouch * (scale + m_cDesc.m_fTouch), slow = m_cDesc.m_fSlow * scale;
    const T near = T(g_fGraze) * R * scale, tMax = m_cDesc.m_fTimeMax;
    // Passing a tangent in steps of this size oversteps by K/2 of its square, far below any rounding.
    const T least = T(1e-9) * tMax;
    graze = false;
    if (!(K > T(0)) || !(tMax > T(0))) return false;

    T f, df;
    eval(t, f, df);
    bool armed = f > touch || (f >= -touch && df >= -slow);
    // Ends after 9 steps in the mean, 391 at most in 500,000 random trials; the limit turns an error into a
    // message.
    for (int i = 0; i < 1000000; ++i) {
      if (armed && f <= touch && df < -slow) return Found(t, df, scale, graze);
      T h;
      if (f > touch)
        h = SafeStep(f, df, K);
      else if (f < -touch)
        h = SafeStep(-f, -df, K);
      else
        h = max(T(abs(df) / K), least);
      if (t + h == t) {
        if (armed && df < -slow) return Found(t, df, scale, graze);
        h = max(least, T(t * std::numeric_limits<T>::epsilon() * T(4)));
      }
      t += h;
      if (t > tMax) return false;
      const T before = f;
      const bool fell = df < T(0);
      eval(t, f, df);
      armed = armed || f > touch;
      if (armed && fell && df >= T(0) && (f < near || before < near)) graze = true;
    }
    throw std::runtime_error("the search for a time of impact with a turning shape did not end");
  }

  // For a circle the share of g_fGraze in the depth is its square root in the direction.
  bool Found(const T& t, const T& df, const T& scale, bool& graze) const {
    using std::abs;
    using std::sqrt;
    const CVec<T> v = GetVel(t);
    graze = abs(df) < scale * Norm(v) * sqrt(T(2 * g_fGraze));
    return true;
  }

  CPathDesc<T> m_cDesc;
  CVec<T> m_vCenter;
  T m_fTurn;
  T m_fReach; // farthest from the centre of rotation
  T m_fSpeed; // bounds of |x'| and |x''|
  T m_fAccel;
};

} // namespace Shapes::Compare
