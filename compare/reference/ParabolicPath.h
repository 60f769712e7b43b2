// SPDX-License-Identifier: MIT
// The path of a ball under constant acceleration, seen by a shape at rest.
//
// A ball that touches when it leaves, and is accelerated back, is met again when it is back at the gap that
// it left from, which is 0 but for rounding. So the hops of a bouncing ball keep their relative precision
// down to any height, and an elastic bounce keeps its energy.
#pragma once

#include "Path.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>

namespace Shapes::Compare {

template <class T>
class CParabolicPath {
public:
  using CScalar = T;
  static constexpr bool g_bCurves = true;

  explicit CParabolicPath(const CPathDesc<T>& desc) : m_cDesc(desc) {
    // No point of a parabola is farther than this from its chord.
    m_fSag = Norm(desc.m_vAcc) * desc.m_fTimeMax * desc.m_fTimeMax / T(8);
  }

  const CPathDesc<T>& GetDesc() const { return m_cDesc; }
  CVec<T> GetPos(const T& t) const {
    return m_cDesc.m_vPos + (m_cDesc.m_vVel + m_cDesc.m_vAcc * (t / T(2))) * t;
  }
  CVec<T> GetVel(const T& t) const { return m_cDesc.m_vVel + m_cDesc.m_vAcc * t; }

  /// When the distance from c falls to R, or the ball begins to approach with an overlap below `deepest`.
  /// The time axis is split where the distance has its extremes, and each piece has one crossing at most.
  /// Error at most (g_nTouchRoundings + 16) eps (size of the coordinates and of the way) / approach speed +
  /// 4 eps t; 16 instead of the first factor unless the ball touches at time 0.
  bool FallToCircle(const CVec<T>& c, const T& R, const T& deepest, CCrossing<T>& x) const {
    return MeetCircle(c, R, T(1), deepest, x);
  }
  /// When the distance from c rises to R. Error as above.
  bool RiseToCircle(const CVec<T>& c, const T& R, const T& deepest, CCrossing<T>& x) const {
    return MeetCircle(c, R, T(-1), deepest, x);
  }

  /// When the distance n.(x - a) from the line through a falls to r: the root of a quadratic by the form
  /// without cancellation. It falls through once at most. Error as above.
  bool FallToLine(const CVec<T>& a, const CVec<T>& n, const T& r, const T& deepest, CCrossing<T>& x) const {
    using std::abs;
    using std::sqrt;
    const bool again = x.m_fTime >= T(0);
    x.m_bGraze = x.m_bBegins = false;
    if (again) return false;
    const T touch = m_cDesc.m_fTouch, slow = m_cDesc.m_fSlow, tMax = m_cDesc.m_fTimeMax;
    const T gap = n.dot(CVec<T>(m_cDesc.m_vPos - a)) - r, vn = n.dot(m_cDesc.m_vVel);
    const T an = n.dot(m_cDesc.m_vAcc), disc = vn * vn - T(2) * an * gap;
    if (an < -m_cDesc.m_fPush && gap <= touch) {
      if (vn < -slow) return false;
      const T apex = gap - vn * vn / (T(2) * an);
      if (vn <= slow || (gap < -touch && apex <= touch)) {
        if (gap <= -deepest) return false;
        x.m_fTime = std::max(vn, T(0)) / -an;
        x.m_bBegins = true;
      } else {
        x.m_fTime = gap >= -touch ? T(T(2) * vn / -an) : T((vn + sqrt(disc)) / -an);
      }
      return x.m_fTime <= tMax;
    }
    if (gap <= touch || (!(vn < T(0)) && !(an < T(0)))) return false;
    if (an > T(0)) {
      const T lowest = -vn / an;
      x.m_bGraze = lowest <= tMax && abs(gap + vn * lowest / T(2)) < T(g_fGraze) * r;
      if (disc <= T(0)) {
        x.m_fTime = lowest;
        return false;
      }
    }
    x.m_fTime = vn > T(0) ? T((vn + sqrt(disc)) / -an) : T(T(2) * gap / (sqrt(disc) - vn));
    return x.m_fTime <= tMax;
  }

private:
  // All that is asked about one circle; `side` is 1 from outside and -1 from inside.
  struct CRound {
    CVec<T> m_vCenter;
    T m_fRadius;
    T m_fSide;
  };

  T Gap(const CRound& o, const T& t) const {
    return o.m_fSide * (Norm(CVec<T>(GetPos(t) - o.m_vCenter)) - o.m_fRadius);
  }
  // Half of the slope of |x - c|^2.
  T Slope(const CRound& o, const T& t) const { return CVec<T>(GetPos(t) - o.m_vCenter).dot(GetVel(t)); }

  // Second derivative of the gap, for a centre that is not on c.
  T Bend(const CRound& o, const T& t) const {
    const CVec<T> d = GetPos(t) - o.m_vCenter, v = GetVel(t);
    const T dist = Norm(d), across = Cross(d, v) / dist;
    return o.m_fSide * (across * across / dist + d.dot(m_cDesc.m_vAcc) / dist);
  }

  // A root of f between a and b, where it has the values fa and fb of opposite signs.
  template <class F>
  static T Solve(const F& f, const T& a, const T& b, const T& fa, const T& fb) {
    using std::abs;
    if (fa == T(0)) return a;
    if (fb == T(0)) return b;
    const auto done = [](const T& lo, const T& hi) {
      return hi - lo <= T(2) * std::numeric_limits<T>::epsilon() * std::max(T(abs(lo)), T(abs(hi)));
    };
    std::uintmax_t most = 1000;
    return boost::math::tools::toms748_solve(f, a, b, fa, fb, done, most).first;
  }

  bool IsFar(const CVec<T>& d0, const T& R, const T& side) const {
    const T pad = m_fSag + m_cDesc.m_fTouch + T(2 * g_fGraze) * R;
    const CVec<T> d1 = GetPos(m_cDesc.m_fTimeMax) - m_cDesc.m_vPos + d0, way = d1 - d0;
    if (side < T(0)) return std::max(Norm(d0), Norm(d1)) < R - pad;
    const T along = -d0.dot(way), all = way.dot(way);
    if (!(along > T(0))) return Norm(d0) > R + pad;
    if (along >= all) return Norm(d1) > R + pad;
    using std::abs;
    using std::sqrt;
    return abs(Cross(d0, way)) > (R + pad) * sqrt(all);
  }

  // The extremes of the distance from c, with both ends of the path: its square has the slope 2 x.v, a cubic,
  // whose own extremes are the roots of a quadratic. Returns how many.
  std::size_t Split(const CRound& o, std::array<T, 5>& times) const {
    using std::sqrt;
    const CVec<T> d = m_cDesc.m_vPos - o.m_vCenter;
    const CVec<T>&v = m_cDesc.m_vVel, &acc = m_cDesc.m_vAcc;
    const T A = T(1.5) * acc.dot(acc), B = T(3) * v.dot(acc), C = v.dot(v) + d.dot(acc);
    const T disc = B * B - T(4) * A * C;
    std::array<T, 4> bends{T(0)};
    std::size_t count = 1;
    if (disc > T(0)) {
      const T q = T(-0.5) * (B + (B < T(0) ? T(-sqrt(disc)) : T(sqrt(disc))));
      T t0 = q / A, t1 = q == T(0) ? t0 : T(C / q);
      if (t1 < t0) std::swap(t0, t1);
      for (const T& t : {t0, t1})
        if (t > bends[count - 1] && t < m_cDesc.m_fTimeMax) bends[count++] = t;
    }
    bends[count++] = m_cDesc.m_fTimeMax;

    std::size_t n = 0;
    times[n++] = T(0);
    T s0 = Slope(o, T(0));
    for (std::size_t k = 1; k < count; ++k) {
      const T s1 = Slope(o, bends[k]);
      if ((s0 < T(0)) != (s1 < T(0))) {
        const T t = Solve([&](const T& s) { return Slope(o, s); }, bends[k - 1], bends[k], s0, s1);
        if (t > times[n - 1] && t < m_cDesc.m_fTimeMax) times[n++] = t;
      }
      s0 = s1;
    }
    times[n++] = m_cDesc.m_fTimeMax;
    return n;
  }

  // When the ball, having left at time 0, is back at the same distance, if it is between a and b. With the
  // root at 0 divided out nothing cancels.
  bool Return(const CRound& o, const T& a, const T& b, T& t) const {
    const CVec<T> d = m_cDesc.m_vPos - o.m_vCenter;
    const CVec<T>&v = m_cDesc.m_vVel, &acc = m_cDesc.m_vAcc;
    const T c0 = T(2) * d.dot(v), c1 = v.dot(v) + d.dot(acc), c2 = v.dot(acc), c3 = acc.dot(acc) / T(4);
    const auto rise = [&](const T& s) { return T(o.m_fSide * (c0 + s * (c1 + s * (c2 + s * c3)))); };
    const T fa = rise(a), fb = rise(b);
    if (!(fb <= T(0))) return false;
    t = fa > T(0) ? Solve(rise, a, b, fa, fb) : a;
    return true;
  }

  bool MeetCircle(const CVec<T>& c, const T& R, const T& side, const T& deepest, CCrossing<T>& x) const {
    const T from = x.m_fTime, touch = m_cDesc.m_fTouch, slow = m_cDesc.m_fSlow, tMax = m_cDesc.m_fTimeMax;
    x.m_bGraze = x.m_bBegins = false;
    const CRound o{c, R, side};
    const CVec<T> d0 = m_cDesc.m_vPos - c;
    if (!(tMax > T(0)) || IsFar(d0, R, side)) return false;

    const T gap0 = Gap(o, T(0)), dist0 = Norm(d0);
    const T vn0 = dist0 > T(0) ? T(side * d0.dot(m_cDesc.m_vVel) / dist0) : T(0);
    const bool waits = gap0 <= touch && gap0 > -deepest && vn0 >= -slow; // to begin to approach
    if (waits && from < T(0) && vn0 <= slow && dist0 > T(0)) {
      const T curve = m_cDesc.m_vVel.dot(m_cDesc.m_vVel) / dist0;
      if (Bend(o, T(0)) <
          -m_cDesc.m_fPush - T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon() * curve) {
        x.m_fTime = T(0);
        x.m_bBegins = true;
        return true;
      }
    }

    std::array<T, 5> times;
    const std::size_t n = Split(o, times);
    bool nearMiss = false, armed = waits || gap0 > touch;
    T missed = T(0);
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const T &s = times[k], &e = times[k + 1];
      if (!(side * Slope(o, T((s + e) / T(2))) < T(0))) continue; // it rises
      const bool last = k + 2 == n, leaves = k == 1 && gap0 >= -touch && gap0 <= touch;
      const T gap = Gap(o, s), low = Gap(o, e), near = T(g_fGraze) * R;
      T t;
      bool begins = false, graze = false;
      armed = armed || gap > touch;
      if (k == 0 && gap0 <= touch) {
        // It neither approaches nor is accelerated into the circle, but the way curves in later.
        if (!waits || low > gap0 - touch) continue;
        const auto f = [&](const T& u) { return T(Gap(o, u) - gap0 + touch); };
        t = Solve(f, s, e, f(s), f(e));
        begins = true;
      } else if (leaves) {
        if (!Return(o, s, e, t)) continue;
      } else if (gap > touch) {
        if (!last && low > T(0) && low < near && e > from) {
          nearMiss = true;
          missed = e;
        }
        if (low > T(0)) continue;
        const auto f = [&](const T& u) {
          const T d = Norm(CVec<T>(GetPos(u) - c));
          return T(side * (d - R) * (d + R));
        };
        const T fs = f(s), fe = f(e);
        t = fs > T(0) ? (fe < T(0) ? Solve(f, s, e, fs, fe) : e) : s;
        graze = last ? IsTangent(o, t) : -low < near;
      } else if (!armed) {
        continue; // it comes from the other side
      } else {
        t = s;
        begins = true;
      }
      // One that was let through here is not waited for on the other side.
      armed = false;
      if (!(t > from)) continue;
      x.m_fTime = t;
      x.m_bGraze = graze || nearMiss;
      x.m_bBegins = begins;
      return true;
    }
    x.m_bGraze = nearMiss;
    if (nearMiss) x.m_fTime = missed;
    return false;
  }

  // Whether a path that ends below the circle enters it along a tangent. The share of g_fGraze in the depth
  // is its square root in the direction.
  bool IsTangent(const CRound& o, const T& t) const {
    using std::abs;
    using std::sqrt;
    const CVec<T> d = GetPos(t) - o.m_vCenter, v = GetVel(t);
    return abs(d.dot(v)) < Norm(d) * Norm(v) * sqrt(T(2 * g_fGraze)) && Norm(d) > T(0) && Bend(o, t) >= T(0);
  }

  CPathDesc<T> m_cDesc;
  T m_fSag;
};

} // namespace Shapes::Compare
