// SPDX-License-Identifier: MIT
// The path of a ball seen by a shape that rotates, in whose frame the shape rests and the ball moves on a
// curve; and of one that slides, which is a curve for a shape at rest.
#pragma once

#include "ParabolicPath.h"

#include <algorithm>
#include <stdexcept>

namespace Shapes::Compare {

/// The path seen from a frame that turns at w rad/s (or 0) about `center` and coincides with the world's at
/// time 0. There |x''| <= M = |a| + 2|w||v| + w^2 |p - center|. A function f of it with |f''| <= K cannot
/// reach 0 before the smallest root h of |f| - |f|' h - K h^2/2, and that is the step: it never oversteps,
/// and close to the root it converges as Newton's method does.
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
    const T more = BeyondBound(desc.m_stdMore, desc.m_fTimeMax), acc = Norm(desc.m_vAcc) + more;
    const T sag = acc * desc.m_fTimeMax * desc.m_fTimeMax / T(8);
    const T speed = max(Norm(desc.m_vVel), Norm(CVec<T>(desc.m_vVel + desc.m_vAcc * desc.m_fTimeMax))) +
                    more * desc.m_fTimeMax;
    m_fReach = max(Norm(FromCenter(T(0))), Norm(FromCenter(desc.m_fTimeMax))) + sag;
    m_fSpeed = speed + abs(w) * m_fReach;
    m_fAccel = acc + T(2) * abs(w) * speed + w * w * m_fReach;
  }

  const CPathDesc<T>& GetDesc() const { return m_cDesc; }
  CVec<T> GetPos(const T& t) const { return m_vCenter + InFrame(FromCenter(t), t); }
  CVec<T> GetVel(const T& t) const {
    return InFrame(CVec<T>(WorldVel(t) - m_fTurn * Perp(FromCenter(t))), t);
  }
  CVec<T> GetAcc(const T& t) const {
    const CVec<T> a = m_cDesc.m_vAcc + Beyond(m_cDesc.m_stdMore, t, 2);
    return InFrame(CVec<T>(a - T(2) * m_fTurn * Perp(WorldVel(t)) - m_fTurn * m_fTurn * FromCenter(t)), t);
  }
  /// Of |x''|.
  const T& GetAccBound() const { return m_fAccel; }
  /// Of the second derivative of |x - c|^2, which is 2|x'|^2 + 2(x - c).x''.
  T GetCircleBound(const CVec<T>& c) const {
    const CVec<T> q = c - m_vCenter;
    return T(2) * m_fSpeed * m_fSpeed + T(2) * (m_fReach + Norm(q)) * m_fAccel;
  }

  /// As of CParabolicPath. Error at most (g_nTouchRoundings + 16) eps (size of the coordinates) / approach
  /// speed + 4 eps t. Whether a near miss is within g_fGraze is known to a factor of 2.
  bool FallToCircle(const CVec<T>& c, const T& R, const T& deepest, CCrossing<T>& x) const {
    if (IsAtRest(c)) return CParabolicPath<T>(m_cDesc).FallToCircle(c, R, deepest, x);
    // f is (d - R)(d + R): this at a gap of -deepest.
    const T deep = deepest * std::max(T(T(2) * R - deepest), T(0));
    return March(
        [&](const T& s, T& f, T& df) {
          const CVec<T> p = GetPos(s) - c;
          const T d = Norm(p);
          f = (d - R) * (d + R);
          df = T(2) * p.dot(GetVel(s));
        },
        CircleBend(c), GetCircleBound(c), T(2) * R, R, deep, x);
  }

  bool RiseToCircle(const CVec<T>& c, const T& R, const T& deepest, CCrossing<T>& x) const {
    if (IsAtRest(c)) return CParabolicPath<T>(m_cDesc).RiseToCircle(c, R, deepest, x);
    const bool met = March(
        [&](const T& s, T& f, T& df) {
          const CVec<T> p = GetPos(s) - c;
          const T d = Norm(p);
          f = (R - d) * (R + d);
          df = T(-2) * p.dot(GetVel(s));
        },
        T(-CircleBend(c)), GetCircleBound(c), T(2) * R, T(0), T(deepest * (T(2) * R + deepest)), x);
    x.m_bGraze = false;
    return met;
  }

  bool FallToLine(const CVec<T>& a, const CVec<T>& n, const T& r, const T& deepest, CCrossing<T>& x) const {
    return March(
        [&](const T& s, T& f, T& df) {
          f = n.dot(CVec<T>(GetPos(s) - a)) - r;
          df = n.dot(GetVel(s));
        },
        n.dot(GetAcc(T(0))), m_fAccel, T(1), r, deepest, x);
  }

private:
  CVec<T> FromCenter(const T& t) const {
    const CVec<T> p = m_cDesc.m_vPos - m_vCenter + (m_cDesc.m_vVel + m_cDesc.m_vAcc * (t / T(2))) * t;
    return m_cDesc.m_stdMore.empty() ? p : CVec<T>(p + Beyond(m_cDesc.m_stdMore, t, 0));
  }
  CVec<T> WorldVel(const T& t) const {
    const CVec<T> v = m_cDesc.m_vVel + m_cDesc.m_vAcc * t;
    return m_cDesc.m_stdMore.empty() ? v : CVec<T>(v + Beyond(m_cDesc.m_stdMore, t, 1));
  }
  CVec<T> InFrame(const CVec<T>& v, const T& t) const {
    return m_fTurn == T(0) ? v : Turned(v, T(-m_fTurn * t));
  }

  // A circle about the centre of rotation does not move: the distance from there is that of a parabola.
  bool IsAtRest(const CVec<T>& c) const { return c == m_vCenter && m_cDesc.m_stdMore.empty(); }

  // The second derivative of |x - c|^2 at the start.
  T CircleBend(const CVec<T>& c) const {
    const CVec<T> v = GetVel(T(0));
    return T(2) * (v.dot(v) + CVec<T>(GetPos(T(0)) - c).dot(GetAcc(T(0))));
  }

  // Smallest h > 0 with f + df h - K h^2/2 = 0, for f > 0.
  static T SafeStep(const T& f, const T& df, const T& K) {
    using std::sqrt;
    const T root = sqrt(df * df + T(2) * K * f);
    return df > T(0) ? (df + root) / K : T(2) * f / (root - df);
  }

  // Next time after x.m_fTime at which f falls to 0 having been above it, or, after touching or overlapping
  // by less than `deep` without approaching, begins to approach. `bend` is the second derivative of f at the
  // start, `scale` is f per unit of gap near the crossing, `R` the contact distance.
  template <class F>
  bool March(const F& eval, const T& bend, const T& K, const T& scale, const T& R, const T& deep,
             CCrossing<T>& x) const {
    using std::abs;
    using std::max;
    const T touch = m_cDesc.m_fTouch * (scale + m_cDesc.m_fTouch), slow = m_cDesc.m_fSlow * scale;
    const T near = T(g_fGraze) * R * scale, tMax = m_cDesc.m_fTimeMax;
    x.m_bGraze = x.m_bBegins = false;
    if (!(K > T(0)) || !(tMax > T(0))) return false;
    // Where nothing says how far it is to the next approach, the step is this, in which nothing goes in and
    // out by more than 1e-11 of the coordinates, and finer where it is seen to have been too far.
    const T eps = std::numeric_limits<T>::epsilon(), finest = eps * tMax;
    using std::sqrt;
    T least = std::min(T(1e-4) * tMax, T(sqrt(T(1e-11) * touch / (T(g_nTouchRoundings) * eps * K))));

    T t = max(x.m_fTime, T(0)), grazed = t, f, df;
    eval(t, f, df);
    // After a crossing that was let through, which may lie a rounding of t above 0.
    bool passing = x.m_fTime >= T(0) && df < T(0);
    bool armed = !passing && (f > touch || (f > -max(deep, touch) && df >= -slow));
    bool clear = f > touch; // since it was armed
    const T push = T(g_nTouchRoundings) * eps * K;
    if (armed && !clear && x.m_fTime < T(0) && abs(df) <= slow && bend < -push)
      return Found(T(0), true, df, scale, x);
    // Ends after 9 steps in the mean, 391 at most in 500,000 random trials; the limit turns an error into a
    // message.
    for (int i = 0; i < 1000000; ++i) {
      // From clear of it the ball is followed down to 0: on a tangent touching is far from there.
      const T level = clear ? T(0) : touch;
      const bool meets = armed && f <= level && df < -slow;
      if (meets) return Found(t, !clear || f < -touch, df, scale, x);
      const T from = t, before = f, slope = df;
      T h;
      bool guessed = false;
      if (f > (armed ? level : touch)) {
        h = SafeStep(f, df, K);
      } else if (f < -touch && !armed) {
        h = SafeStep(-f, -df, K);
      } else {
        h = max(T(abs(df) / K), least);
        guessed = h == least;
      }
      if (t + h == t) {
        if (armed && df < -slow) return Found(t, !clear, df, scale, x);
        h = max(finest, T(t * eps * T(4)));
      }
      t += h;
      if (t > tMax) {
        x.m_fTime = x.m_bGraze ? grazed : x.m_fTime;
        return false;
      }
      eval(t, f, df);
      if (guessed && armed && f <= level && df < -slow && least > finest) {
        least = max(finest, T(least / T(16)));
        t = from;
        f = before;
        df = slope;
        continue;
      }
      passing = passing && f >= -touch && df < T(0);
      armed = armed || (!passing && f > touch);
      clear = clear || (armed && f > touch);
      if (armed && slope < T(0) && df >= T(0) && (f < near || before < near)) {
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
