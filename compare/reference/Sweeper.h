// SPDX-License-Identifier: MIT
// Finds the first hit on the path of a ball: the first time at which the ball touches a shape AND approaches
// it. The normal n is a unit vector from the shape to the ball.
//
// Solid are points; both faces and the round ends of segments; the ring of a circle, met from outside,
// and from inside by a ball that fits in (r < R; one that does not is always outside); arcs like rings in
// their sector (one that does not fit meets only the ends from inside), and their round ends. A one-sided
// segment or arc is met only by a centre on its solid side; one that comes from the open side passes, ends
// included.
//
// A ball that overlaps at time 0 is hit at once if it approaches (m_bOverlapped). Otherwise it is ignored,
// and hit when it begins to approach, if its centre is on the solid side. The ends of one-sided shapes ignore
// a ball that overlaps in any case. Overlap is tested at the beginning only.
#pragma once

#include "ParabolicPath.h"
#include "ShapeGeometry.h"
#include "StraightPath.h"
#include "TurningPath.h"

#include <utility>

namespace Shapes::Compare {

/// The part of a shape that is met. Front and Back are the faces of a segment; its ends keep their names when
/// it turns.
enum class ePart { Point, Front, Back, Outside, Inside, End0, End1, Ball };

/// Whether a ball that overlaps and does not approach counts: Touching is for sensors, to which a circle is a
/// disk.
enum class eMeet { Approaching, Touching };

template <class T>
struct CSweptBall {
  CVec<T> m_vPos;
  CVec<T> m_vVel;
  T m_fRadius;
  CVec<T> m_vAcc = CVec<T>::Zero(); ///< at time 0; constant unless there is more
  CMore<T> m_stdMore;

  CSweptBall() = default;
  CSweptBall(const CVec<T>& p, const CVec<T>& v, const T& r, const CVec<T>& acc = CVec<T>::Zero(),
             CMore<T> more = CMore<T>())
      : m_vPos(p), m_vVel(v), m_fRadius(r), m_vAcc(acc), m_stdMore(std::move(more)) {}

  CVec<T> GetPos(const T& t) const {
    const CVec<T> p = m_vPos + (m_vVel + m_vAcc * (t / T(2))) * t;
    return m_stdMore.empty() ? p : CVec<T>(p + Beyond(m_stdMore, t, 0));
  }
  CVec<T> GetVel(const T& t) const {
    const CVec<T> v = m_vVel + m_vAcc * t;
    return m_stdMore.empty() ? v : CVec<T>(v + Beyond(m_stdMore, t, 1));
  }
  CVec<T> GetAcc(const T& t) const { return m_vAcc + Beyond(m_stdMore, t, 2); }
};

/// Rotation of a figure about a centre; w in radians per second, counterclockwise.
template <class T>
struct CTurning {
  CVec<T> m_vCenter = CVec<T>::Zero();
  T m_fSpeed = T(0);
  CVec<T> m_vVel = CVec<T>::Zero(); ///< of the figure and the centre
};

template <class T>
struct CHit {
  T m_fTime = T(0);
  CVec<T> m_vCenter = CVec<T>::Zero();  ///< of the ball at the impact
  CVec<T> m_vPOI = CVec<T>::Zero();     ///< point of the shape
  CVec<T> m_vNorm = CVec<T>::Zero();    ///< unit, from the shape to the ball
  CVec<T> m_vSurface = CVec<T>::Zero(); ///< velocity of the shape at the POI
  T m_fDepth = T(0);                    ///< overlap along the normal, 0 unless m_bOverlapped
  ePart m_ePart = ePart::Point;
  bool m_bOverlapped = false; ///< It overlapped already, by more than rounding.
  bool m_bBegins = false;     ///< It touched or overlapped without approaching, and begins to approach.
  /// Ambiguous: within g_fGraze of a tangent. Set for misses too, with the time of the closest approach
  /// where the figure rests.
  bool m_bGraze = false;
};

/// One ball against one figure along one path; keeps the earliest hit.
template <class TPath>
class CSweeper {
public:
  using T = typename TPath::CScalar;
  using V = CVec<T>;

  CSweeper(const TPath& path, const T& r, eMeet meet, CHit<T>& hit)
      : m_cPath(path), m_cHit(hit), m_fRadius(r), m_eMeet(meet) {
    hit = CHit<T>();
  }

  bool Run(const CShapeGeometry<T>& f) {
    switch (f.m_eShapeType) {
    case eShape::Point: Round(f.m_vCenter, T(0), ePart::Point); break;
    case eShape::LineSeg: LineSeg(f); break;
    case eShape::Circle: Ring(f); break;
    case eShape::Arc: Arc(f); break;
    }
    return Finish();
  }

  /// Against a disc of radius R about the origin, always from outside.
  bool RunDisc(const T& R) {
    Round(V(V::Zero()), R, ePart::Ball);
    return Finish();
  }

private:
  bool Finish() {
    if (!m_bFound) m_cHit.m_bGraze = m_bNearMiss;
    return m_bFound;
  }

  // A point, or a disc of radius R from outside.
  void Round(const V& c, const T& R, ePart part) {
    if (StartRound(c, R, part)) return;
    CCrossing<T> x;
    if (m_cPath.FallToCircle(c, R + m_fRadius, R + m_fRadius, x))
      TakeOutward(x, c, R, part);
    else
      NearMiss(x);
  }

  const T& Touch() const { return m_cPath.GetDesc().m_fTouch; }

  // Direction of d; for a ball exactly on the spot, back where it came from.
  V Away(const V& d, const T& t) const { return Unit(d, Unit(V(-m_cPath.GetVel(t)), V(T(0), T(1)))); }

  // At time 0, a part at this gap along n: whether it is met at once.
  bool Start(const T& gap, const V& n, const V& poi, ePart part, eSides sides = eSides::Both) {
    if (gap > Touch()) return false;
    const bool deep = gap < -Touch();
    const bool approaches = m_cPath.GetVel(T(0)).dot(n) < -m_cPath.GetDesc().m_fSlow;
    if (!approaches && !(deep && m_eMeet == eMeet::Touching && sides == eSides::Both)) return false;
    CCrossing<T> x;
    x.m_fTime = T(0);
    Take(x, n, poi, part);
    Overlap(gap);
    return true;
  }

  bool StartRound(const V& c, const T& R, ePart part) {
    const V d = m_cPath.GetPos(T(0)) - c;
    const V n = Away(d, T(0));
    return Start(Norm(d) - (R + m_fRadius), n, c + R * n, part);
  }

  void Overlap(const T& gap) {
    m_cHit.m_bOverlapped = gap < -Touch();
    m_cHit.m_fDepth = m_cHit.m_bOverlapped ? T(-gap) : T(0);
  }

  void Take(const CCrossing<T>& x, const V& n, const V& poi, ePart part) {
    if (m_bFound && !(x.m_fTime < m_cHit.m_fTime)) return;
    m_bFound = true;
    m_cHit.m_fTime = x.m_fTime;
    m_cHit.m_vNorm = n;
    m_cHit.m_vPOI = poi;
    m_cHit.m_ePart = part;
    m_cHit.m_bGraze = x.m_bGraze;
    m_cHit.m_bBegins = x.m_bBegins;
    // One that comes from clear of the shape does not overlap, also after rounding.
    Overlap(x.m_bBegins ? T((m_cPath.GetPos(x.m_fTime) - poi).dot(n) - m_fRadius) : T(0));
  }

  void TakeOutward(const CCrossing<T>& x, const V& c, const T& R, ePart part) {
    const V n = Away(m_cPath.GetPos(x.m_fTime) - c, x.m_fTime);
    Take(x, n, c + R * n, part);
  }

  void TakeInward(const CCrossing<T>& x, const V& c, const T& R) {
    const V n = -Away(m_cPath.GetPos(x.m_fTime) - c, x.m_fTime);
    Take(x, n, c - R * n, ePart::Inside);
  }

  void NearMiss(const CCrossing<T>& x) {
    if (!x.m_bGraze) return;
    m_bNearMiss = true;
    if (!m_bFound) m_cHit.m_fTime = x.m_fTime;
  }

  // The end at c of a segment or an arc, where `counts` says whether an end touched at this place of the
  // centre is the closest part, and on the solid side.
  template <class F>
  void End(const V& c, ePart part, eSides sides, const F& counts) {
    const V u = m_cPath.GetPos(T(0));
    const bool deep = Norm(V(u - c)) - m_fRadius < -Touch();
    if (counts(u) && !(deep && sides != eSides::Both) && StartRound(c, T(0), part)) return;
    const T deepest = sides == eSides::Both ? m_fRadius : std::min(m_fRadius, Touch());
    for (CCrossing<T> x;;) {
      if (!m_cPath.FallToCircle(c, m_fRadius, deepest, x)) {
        if (x.m_bGraze && counts(m_cPath.GetPos(x.m_fTime))) NearMiss(x);
        return;
      }
      if (counts(m_cPath.GetPos(x.m_fTime))) return TakeOutward(x, c, T(0), part);
      if (!TPath::g_bCurves) return;
    }
  }

  void LineSeg(const CShapeGeometry<T>& f) {
    const V &a = f.m_vPt0, along = f.m_vPt1 - f.m_vPt0;
    const T L = Norm(along);
    if (!(L > T(0))) return Round(a, T(0), ePart::Point);
    const V that = along / L, nhat = Perp(that);

    // The solid side: of both, the one where the centre is; exactly on the line, where it came from.
    const V u0 = m_cPath.GetPos(T(0)) - a;
    const T s0 = u0.dot(nhat), l0 = u0.dot(that);
    T side = f.m_eSides == eSides::Back ? T(-1) : T(1);
    if (f.m_eSides == eSides::Both && (s0 < T(0) || (s0 == T(0) && m_cPath.GetVel(T(0)).dot(nhat) > T(0))))
      side = T(-1);
    const auto face = [](const T& s) { return s > T(0) ? ePart::Front : ePart::Back; };
    if (l0 >= T(0) && l0 <= L && side * s0 >= T(0)) {
      const T gap = side * s0 - m_fRadius;
      if (Start(gap, side * nhat, a + l0 * that, face(side), f.m_eSides)) return;
      // A ball that leaves on a straight line never comes closer again, as the segment is convex.
      if (gap <= Touch() && !TPath::g_bCurves) return;
    }

    for (const T& s : {T(1), T(-1)}) {
      if (f.m_eSides != eSides::Both && s != side) continue;
      CCrossing<T> x;
      bool met = false, inRange = false;
      while (!inRange && (met = m_cPath.FallToLine(a, V(s * nhat), m_fRadius, m_fRadius, x))) {
        const T l = (m_cPath.GetPos(x.m_fTime) - a).dot(that);
        inRange = l >= -Touch() && l <= L + Touch();
        if (inRange) Take(x, s * nhat, a + std::clamp(l, T(0), L) * that, face(s));
        if (!TPath::g_bCurves) break;
      }
      if (met || !x.m_bGraze) continue;
      const T l = (m_cPath.GetPos(x.m_fTime) - a).dot(that);
      if (l >= T(0) && l <= L) NearMiss(x);
    }
    for (const bool first : {true, false})
      End(first ? f.m_vPt0 : f.m_vPt1, first ? ePart::End0 : ePart::End1, f.m_eSides, [&](const V& u) {
        const T l = (u - a).dot(that), s = (u - a).dot(nhat);
        return (first ? l <= Touch() : l >= L - Touch()) &&
               (f.m_eSides == eSides::Both || side * s >= -Touch());
      });
  }

  // Whether a ball with its centre at x from the centre of a circle begins inside; on it, where it came from.
  bool BeginsInside(const V& x, const T& R) const {
    const T d = Norm(x);
    return d < R || (d == R && x.dot(m_cPath.GetVel(T(0))) > T(0));
  }

  bool StartInside(const V& c, const T& R, const V& x, eSides sides) {
    const V n = -Away(x, T(0));
    return Start(R - m_fRadius - Norm(x), n, c - R * n, ePart::Inside, sides);
  }

  void Ring(const CShapeGeometry<T>& f) {
    const V &c = f.m_vCenter, x = m_cPath.GetPos(T(0)) - c;
    const T& R = f.m_fRadius;
    if (m_eMeet == eMeet::Touching || !(m_fRadius < R && BeginsInside(x, R)))
      return Round(c, R, ePart::Outside);
    if (StartInside(c, R, x, eSides::Both)) return;
    CCrossing<T> cross;
    if (m_cPath.RiseToCircle(c, R - m_fRadius, m_fRadius, cross))
      TakeInward(cross, c, R);
    else
      NearMiss(cross);
  }

  void Arc(const CShapeGeometry<T>& f) {
    const V& c = f.m_vCenter;
    const T &R = f.m_fRadius, slack = Touch() / std::max(R, Touch());
    const bool outside = f.m_eSides != eSides::Back, inside = f.m_eSides != eSides::Front && m_fRadius < R;
    const auto inSector = [&](const T& t) { return InSector(f, V(m_cPath.GetPos(t) - c), slack); };

    const V x = m_cPath.GetPos(T(0)) - c;
    if (InSector(f, x, slack)) {
      const bool within = BeginsInside(x, R);
      const V n = Away(x, T(0));
      if (!within && outside && Start(Norm(x) - R - m_fRadius, n, c + R * n, ePart::Outside, f.m_eSides))
        return;
      if (within && inside && StartInside(c, R, x, f.m_eSides)) return;
    }
    for (const bool inward : {false, true}) {
      if (!(inward ? inside : outside)) continue;
      for (CCrossing<T> cross;;) {
        const bool met = inward ? m_cPath.RiseToCircle(c, R - m_fRadius, m_fRadius, cross)
                                : m_cPath.FallToCircle(c, R + m_fRadius, m_fRadius, cross);
        const bool solid = (met || cross.m_bGraze) && inSector(cross.m_fTime);
        if (!met && solid) NearMiss(cross);
        if (met && solid && inward) TakeInward(cross, c, R);
        if (met && solid && !inward) TakeOutward(cross, c, R, ePart::Outside);
        if (!met || solid || !TPath::g_bCurves) break;
      }
    }
    if (f.m_bFull) return;
    // On its way through a one-sided arc a ball may reach the second end while it still overlaps the first.
    const T side = f.m_eSides == eSides::Front ? T(1) : T(-1);
    for (const bool first : {true, false})
      End(first ? f.m_vPt0 : f.m_vPt1, first ? ePart::End0 : ePart::End1, f.m_eSides, [&](const V& u) {
        if (InSector(f, V(u - c), T(-slack))) return false;
        if (f.m_eSides == eSides::Both) return true;
        return side * (Norm(V(u - c)) - R) >= -Touch() &&
               Norm(V(u - (first ? f.m_vPt1 : f.m_vPt0))) >= m_fRadius - Touch();
      });
  }

  const TPath& m_cPath;
  CHit<T>& m_cHit;
  T m_fRadius;
  eMeet m_eMeet;
  bool m_bFound = false;
  bool m_bNearMiss = false;
};

} // namespace Shapes::Compare
