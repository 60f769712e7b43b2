// SPDX-License-Identifier: MIT
// The path of a ball without acceleration, seen by a shape at rest.
#pragma once

#include "Path.h"

#include <algorithm>

namespace Shapes::Compare {

template <class T>
class CStraightPath {
public:
  using CScalar = T;
  static constexpr bool g_bCurves = false;

  explicit CStraightPath(const CPathDesc<T>& desc) : m_cDesc(desc) {}

  const CPathDesc<T>& GetDesc() const { return m_cDesc; }
  CVec<T> GetPos(const T& t) const { return m_cDesc.m_vPos + m_cDesc.m_vVel * t; }
  CVec<T> GetVel(const T&) const { return m_cDesc.m_vVel; }

  /// When the distance from c falls to R: t is the earlier root of |d + v t| = R, by the form without
  /// cancellation: with d the way from c, b = d.v and disc = (R|v| - |d x v|)(R|v| + |d x v|),
  /// t = (|d| - R)(|d| + R) / (sqrt(disc) - b). Error at most 16 eps (|d| + R) / approach speed + 4 eps t.
  bool FallToCircle(const CVec<T>& c, const T& R, const T&, CCrossing<T>& x) const {
    using std::abs;
    using std::sqrt;
    x.m_bGraze = false;
    if (x.m_fTime >= T(0)) return false; // a straight line enters a circle once
    const CVec<T> d = m_cDesc.m_vPos - c;
    const CVec<T>& v = m_cDesc.m_vVel;
    const T dist = Norm(d), b = d.dot(v);
    if (dist - R <= m_cDesc.m_fTouch || !(b < T(0))) return false;

    const T speed = Norm(v), aside = abs(Cross(d, v)), spare = R * speed - aside;
    const bool tangent = abs(spare) < T(g_fGraze) * R * speed;
    const bool misses = spare < T(0) || (spare == T(0) && R > T(0));
    x.m_fTime = misses ? T(-b / (speed * speed))
                       : T((dist - R) * (dist + R) / (sqrt(spare * (R * speed + aside)) - b));
    x.m_bGraze = tangent && x.m_fTime <= m_cDesc.m_fTimeMax;
    return !misses && x.m_fTime <= m_cDesc.m_fTimeMax;
  }

  /// When the distance from c rises to R: the later root. Error as above. A centre that is on the circle and
  /// moves along it crosses at once, at t = 0.
  bool RiseToCircle(const CVec<T>& c, const T& R, const T&, CCrossing<T>& x) const {
    using std::abs;
    using std::sqrt;
    x.m_bGraze = false;
    if (x.m_fTime >= T(0)) return false;
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
    x.m_fTime = b > T(0) ? std::max(R - dist, T(0)) * (R + dist) / (b + root) : (root - b) / a;
    return x.m_fTime <= m_cDesc.m_fTimeMax;
  }

  /// When the distance n.(x - a) from the line through a falls to r. Error as above.
  bool FallToLine(const CVec<T>& a, const CVec<T>& n, const T& r, const T&, CCrossing<T>& x) const {
    x.m_bGraze = false;
    if (x.m_fTime >= T(0)) return false;
    const CVec<T> d = m_cDesc.m_vPos - a;
    const T gap = n.dot(d) - r, vn = n.dot(m_cDesc.m_vVel);
    if (gap <= m_cDesc.m_fTouch || !(vn < T(0))) return false;
    x.m_fTime = gap / -vn;
    return x.m_fTime <= m_cDesc.m_fTimeMax;
  }

private:
  CPathDesc<T> m_cDesc;
};

} // namespace Shapes::Compare
