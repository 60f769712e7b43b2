// SPDX-License-Identifier: MIT
// The path of a ball seen by a shape that rotates, in whose frame the shape rests and the ball moves on a
// curve.
#pragma once

#include "Path.h"

#include <algorithm>
#include <stdexcept>

namespace Shapes::Compare {

/// The path seen from a frame that turns at w rad/s about `center` and coincides with the world's at time 0.
/// There |x''| <= M = |a| + 2|w||v| + w^2 |p - center|. A function f of it with |f''| <= K cannot reach 0
/// before the smallest root h of |f| - |f|' h - K h^2/2, and that is the step: it never oversteps, and close
/// to the root it converges as Newton's method does.
template <class T>
class CTurningPath {
public:
  using CScalar = T;
  static constexpr bool g_bCurves = true;

  CTurningPath(const CPathDesc<T>& desc, const CVec<T>& center, const T& w)
      : m_cDesc(desc), m_vCenter(center), m_fTurn(w) {
    using std::abs;
    using std::max;
    // The whole way is this close to its chord, and the speed is largest at one of its ends.
    const T acc = Norm(desc.m_vAcc), sag = acc * desc.m_fTimeMax * desc.m_fTimeMax / T(8);
    const T speed = max(Norm(desc.m_vVel), Norm(CVec<T>(desc.m_vVel + desc.m_vAcc * desc.m_fTimeMax)));
    m_fReach = max(Norm(FromCenter(T(0))), Norm(FromCenter(desc.m_fTimeMax))) + sag;
    m_fSpeed = speed + abs(w) * m_fReach;
    m_fAccel = acc + T(2) * abs(w) * speed + w * w * m_fReach;
  }

  const CPathDesc<T>& GetDesc() const { return m_cDesc; }
  CVec<T> GetPos(const T& t) const { return m_vCenter + InFrame(FromCenter(t), t); }
  CVec<T> GetVel(const T& t) const {
    return InFrame(CVec<T>(m_cDesc.m_vVel + m_cDesc.m_vAcc * t - m_fTurn * Perp(FromCenter(t))), t);
  }

  /// As of CParabolicPath. Error at most (g_nTouchRoundings + 16) eps (size of the coordinates) / approach
  /// speed + 4 eps t. Whether a near miss is within g_fGraze is known to a factor of 2.
  bool FallToCircle(const CVec<T>& c, const T& R, const T& deepest, CCrossing<T>& x) const {
    // f is (d - R)(d + R): this at a gap of -deepest.
    const T deep = deepest * std::max(T(T(2) * R - deepest), T(0));
    return March(
        [&](const T& s, T& f, T& df) {
          const CVec<T> p = GetPos(s) - c;
          const T d = Norm(p);
          f = (d - R) * (d + R);
          df = T(2) * p.dot(GetVel(s));
        },
        CircleBound(c), T(2) * R, R, deep, x);
  }

  bool RiseToCircle(const CVec<T>& c, const T& R, const T& deepest, CCrossing<T>& x) const {
    const bool met = March(
        [&](const T& s, T& f, T& df) {
          const CVec<T> p = GetPos(s) - c;
          const T d = Norm(p);
          f = (R - d) * (R + d);
          df = T(-2) * p.dot(GetVel(s));
        },
        CircleBound(c), T(2) * R, T(0), T(deepest * (T(2) * R + deepest)), x);
    x.m_bGraze = false;
    return met;
  }

  bool FallToLine(const CVec<T>& a, const CVec<T>& n, const T& r, const T& deepest, CCrossing<T>& x) const {
    return March(
        [&](const T& s, T& f, T& df) {
          f = n.dot(CVec<T>(GetPos(s) - a)) - r;
          df = n.dot(GetVel(s));
        },
        m_fAccel, T(1), r, deepest, x);
  }

private:
  CVec<T> FromCenter(const T& t) const {
    return m_cDesc.m_vPos - m_vCenter + (m_cDesc.m_vVel + m_cDesc.m_vAcc * (t / T(2))) * t;
  }
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

  // Next time after x.m_fTime at which f falls to 0 having been above it, or, after touching or overlapping
  // by less than `deep` without approaching, begins to approach. `scale` is f per unit of gap near the
  // crossing, `R` the contact distance.
  template <class F>
  bool March(const F& eval, const T& K, const T& scale, const T& R, const T& deep, CCrossing<T>& x) const {
    using std::abs;
    using std::max;
    const T touch = m_cDesc.m_fTouch * (scale + m_cDesc.m_fTouch), slow = m_cDesc.m_fSlow * scale;
    const T near = T(g_fGraze) * R * scale, tMax = m_cDesc.m_fTimeMax;
    // Passing a tangent in steps of this size oversteps by K/2 of its square, far below any rounding.
    const T least = T(1e-9) * tMax;
    x.m_bGraze = x.m_bBegins = false;
    if (!(K > T(0)) || !(tMax > T(0))) return false;

    T t = max(x.m_fTime, T(0)), grazed = t, f, df;
    eval(t, f, df);
    // After a crossing that was let through, which may lie a rounding of t above 0.
    bool passing = x.m_fTime >= T(0) && df < T(0);
    bool armed = !passing && (f > touch || (f > -max(deep, touch) && df >= -slow));
    // Ends after 9 steps in the mean, 391 at most in 500,000 random trials; the limit turns an error into a
    // message.
    for (int i = 0; i < 1000000; ++i) {
      const bool meets = armed && f <= touch && df < -slow;
      if (meets) return Found(t, f < -touch, df, scale, x);
      T h;
      if (f > touch)
        h = SafeStep(f, df, K);
      else if (f < -touch && !armed)
        h = SafeStep(-f, -df, K);
      else
        h = max(T(abs(df) / K), least);
      if (t + h == t) {
        if (armed && df < -slow) return Found(t, false, df, scale, x);
        h = max(least, T(t * std::numeric_limits<T>::epsilon() * T(4)));
      }
      t += h;
      if (t > tMax) {
        x.m_fTime = x.m_bGraze ? grazed : x.m_fTime;
        return false;
      }
      const T before = f;
      const bool fell = df < T(0);
      eval(t, f, df);
      passing = passing && f >= -touch && df < T(0);
      armed = armed || (!passing && f > touch);
      if (armed && fell && df >= T(0) && (f < near || before < near)) {
        x.m_bGraze = true;
        grazed = t;
      }
    }
    throw std::runtime_error("the search for a time of impact with a turning shape did not end");
  }

  // For a circle the share of g_fGraze in the depth is its square root in the direction.
  bool Found(const T& t, bool begins, const T& df, const T& scale, CCrossing<T>& x) const {
    using std::abs;
    using std::sqrt;
    const CVec<T> v = GetVel(t);
    x.m_fTime = t;
    x.m_bBegins = begins;
    x.m_bGraze = !begins && abs(df) < scale * Norm(v) * sqrt(T(2 * g_fGraze));
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
