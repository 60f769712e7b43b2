// SPDX-License-Identifier: MIT
// Exact time of impact of a ball that moves on a straight line, against every kind of shape. A hit is the
// first time at which the ball touches the shape AND approaches it. The normal n is a unit vector from the
// shape to the ball; all results are in the world. Templates on the scalar, so that double is checked by 50
// digits.
//
// What is solid: points; both faces and the round ends of segments; the ring of a circle, met from outside,
// and from inside by a ball that fits in (r < R; one that does not is always outside); arcs like rings in
// their sector (one that does not fit meets only the ends from inside), and their round ends. A one-sided
// segment or arc is met only by a centre on its solid side; one that comes from the open side passes, ends
// included.
//
// A ball that overlaps at time 0 is hit at once if it approaches (m_bOverlapped) and let go otherwise; the
// ends of one-sided shapes let it go in any case. Overlap is looked at in the beginning only.
#pragma once

#include "Figure.h"
#include "Path.h"

namespace Shapes::Compare {

/// The part of a shape that is met. Front and Back are the faces of a segment; its ends keep their names when
/// it turns.
enum class ePart { Point, Front, Back, Outside, Inside, End0, End1, Ball };

/// Whether a ball that overlaps and does not approach counts: Touching is for sensors.
enum class eMeet { Approaching, Touching };

template <class T>
struct CSweptBall {
  CVec<T> m_vPos;
  CVec<T> m_vVel;
  T m_fRadius;
};

/// Rotation of a figure about a centre; w in radians per second, counterclockwise.
template <class T>
struct CTurning {
  CVec<T> m_vCenter = CVec<T>::Zero();
  T m_fSpeed = T(0);
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
  bool m_bOverlapped = false; ///< It overlapped already at time 0, by more than rounding.
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

  bool Run(const CFigure<T>& f) {
    switch (f.m_eShapeType) {
    case eShape::Point: Round(f.m_vCenter, T(0), ePart::Point); break;
    case eShape::LineSeg: LineSeg(f); break;
    case eShape::Circle: Ring(f); break;
    case eShape::Arc: Arc(f); break;
    case eShape::Unknown:
    case eShape::Line: throw std::invalid_argument("a figure has no type that a ball can hit");
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
    T t = T(0);
    bool graze;
    if (m_cPath.FallToCircle(c, R + m_fRadius, t, graze))
      TakeOutward(t, c, R, part, graze);
    else
      NearMiss(graze, t);
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
    Take(T(0), n, poi, part, false);
    m_cHit.m_bOverlapped = deep;
    m_cHit.m_fDepth = deep ? T(-gap) : T(0);
    return true;
  }

  bool StartRound(const V& c, const T& R, ePart part) {
    const V d = m_cPath.GetPos(T(0)) - c;
    const V n = Away(d, T(0));
    return Start(Norm(d) - (R + m_fRadius), n, c + R * n, part);
  }

  void Take(const T& t, const V& n, const V& poi, ePart part, bool graze) {
    if (m_bFound && !(t < m_cHit.m_fTime)) return;
    m_bFound = true;
    m_cHit.m_fTime = t;
    m_cHit.m_vNorm = n;
    m_cHit.m_vPOI = poi;
    m_cHit.m_ePart = part;
    m_cHit.m_bGraze = graze;
    m_cHit.m_bOverlapped = false;
    m_cHit.m_fDepth = T(0);
  }

  void TakeOutward(const T& t, const V& c, const T& R, ePart part, bool graze) {
    const V n = Away(m_cPath.GetPos(t) - c, t);
    Take(t, n, c + R * n, part, graze);
  }

  void TakeInward(const T& t, const V& c, const T& R) {
    const V n = -Away(m_cPath.GetPos(t) - c, t);
    Take(t, n, c - R * n, ePart::Inside, false);
  }

  void NearMiss(bool graze, const T& t) {
    if (!graze) return;
    m_bNearMiss = true;
    if (!m_bFound) m_cHit.m_fTime = t;
  }

  // The end at c of a segment or an arc, where `counts` says whether an end touched at this place of the
  // centre is the closest part, and on the solid side.
  template <class F>
  void End(const V& c, ePart part, eSides sides, const F& counts) {
    const V u = m_cPath.GetPos(T(0));
    const bool deep = Norm(V(u - c)) - m_fRadius < -Touch();
    if (counts(u) && !(deep && sides != eSides::Both) && StartRound(c, T(0), part)) return;
    bool graze;
    for (T t = T(0);;) {
      if (!m_cPath.FallToCircle(c, m_fRadius, t, graze)) {
        if (graze && counts(m_cPath.GetPos(t))) NearMiss(graze, t);
        return;
      }
      if (counts(m_cPath.GetPos(t))) return TakeOutward(t, c, T(0), part, graze);
      if (!TPath::g_bTurns) return;
    }
  }

  void LineSeg(const CFigure<T>& f) {
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
      // Whoever leaves on a straight line never comes closer again: the segment is convex.
      if (gap <= Touch() && !TPath::g_bTurns) return;
    }

    for (const T& s : {T(1), T(-1)}) {
      if (f.m_eSides != eSides::Both && s != side) continue;
      bool graze;
      for (T t = T(0); m_cPath.FallToLine(a, V(s * nhat), m_fRadius, t, graze);) {
        const T l = (m_cPath.GetPos(t) - a).dot(that);
        if (l < -Touch() || l > L + Touch()) {
          if (TPath::g_bTurns) continue;
          break;
        }
        Take(t, s * nhat, a + std::clamp(l, T(0), L) * that, face(s), graze);
        break;
      }
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

  void Ring(const CFigure<T>& f) {
    const V &c = f.m_vCenter, x = m_cPath.GetPos(T(0)) - c;
    const T& R = f.m_fRadius;
    if (!(m_fRadius < R && BeginsInside(x, R))) return Round(c, R, ePart::Outside);
    if (StartInside(c, R, x, eSides::Both)) return;
    T t = T(0);
    if (m_cPath.RiseToCircle(c, R - m_fRadius, t)) TakeInward(t, c, R);
  }

  void Arc(const CFigure<T>& f) {
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
    bool graze;
    if (outside)
      for (T t = T(0);;) {
        const bool met = m_cPath.FallToCircle(c, R + m_fRadius, t, graze);
        if (!met && graze && inSector(t)) NearMiss(graze, t);
        if (!met) break;
        const bool solid = inSector(t);
        if (solid) TakeOutward(t, c, R, ePart::Outside, graze);
        if (solid || !TPath::g_bTurns) break;
      }
    if (inside)
      for (T t = T(0); m_cPath.RiseToCircle(c, R - m_fRadius, t);) {
        const bool solid = inSector(t);
        if (solid) TakeInward(t, c, R);
        if (solid || !TPath::g_bTurns) break;
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

/// The size of the coordinates among which a ball meets a figure; g_nTouchRoundings of it are touching.
template <class T>
T GetExtent(const CFigure<T>& f, const CSweptBall<T>& ball, const CTurning<T>& turning) {
  T size = ball.m_vPos.cwiseAbs().maxCoeff();
  for (const CVec<T>* p : {&f.m_vCenter, &f.m_vPt0, &f.m_vPt1, &turning.m_vCenter})
    size = std::max(size, p->cwiseAbs().maxCoeff());
  return size + f.m_fRadius + ball.m_fRadius;
}

/// The first hit of the ball on the figure in [0, tMax], while the figure turns from the pose that is given.
/// Error of the time at most (g_nTouchRoundings + 16) eps (size of the coordinates) / approach speed +
/// 4 eps t; without rotation 16 instead of the first factor, unless the ball touches at time 0.
/// @return whether there is one; hit.m_bGraze is set in any case
template <class T>
bool Sweep(const CFigure<T>& f, const CTurning<T>& turning, const CSweptBall<T>& ball, const T& tMax,
           CHit<T>& hit, eMeet meet = eMeet::Approaching) {
  using std::abs;
  const T eps = T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon();
  const T size = GetExtent(f, ball, turning), w = turning.m_fSpeed;
  const CPathDesc<T> desc{ball.m_vPos, ball.m_vVel, tMax, T(eps * size),
                          T(eps * (Norm(ball.m_vVel) + abs(w) * size))};
  if (w == T(0)) {
    const CStraightPath<T> path(desc);
    if (!CSweeper<CStraightPath<T>>(path, ball.m_fRadius, meet, hit).Run(f)) return false;
  } else {
    const CTurningPath<T> path(desc, turning.m_vCenter, w);
    if (!CSweeper<CTurningPath<T>>(path, ball.m_fRadius, meet, hit).Run(f)) return false;
    const T angle = w * hit.m_fTime;
    hit.m_vNorm = Turned(hit.m_vNorm, angle);
    hit.m_vPOI = turning.m_vCenter + Turned(CVec<T>(hit.m_vPOI - turning.m_vCenter), angle);
  }
  hit.m_vSurface = w * Perp(CVec<T>(hit.m_vPOI - turning.m_vCenter));
  hit.m_vCenter = ball.m_vPos + ball.m_vVel * hit.m_fTime;
  return true;
}

/// The same for a figure at rest.
template <class T>
bool Sweep(const CFigure<T>& f, const CSweptBall<T>& ball, const T& tMax, CHit<T>& hit,
           eMeet meet = eMeet::Approaching) {
  return Sweep(f, CTurning<T>(), ball, tMax, hit, meet);
}

/// Ball against `other`, both moving; balls are solid. hit.m_vSurface is the velocity of the other.
template <class T>
bool SweepBalls(const CSweptBall<T>& other, const CSweptBall<T>& ball, const T& tMax, CHit<T>& hit,
                eMeet meet = eMeet::Approaching) {
  const T eps = T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon();
  const T size = std::max(other.m_vPos.cwiseAbs().maxCoeff(), ball.m_vPos.cwiseAbs().maxCoeff()) +
                 other.m_fRadius + ball.m_fRadius;
  const CStraightPath<T> path({ball.m_vPos - other.m_vPos, ball.m_vVel - other.m_vVel, tMax, T(eps * size),
                               T(eps * (Norm(ball.m_vVel) + Norm(other.m_vVel)))});
  CSweeper<CStraightPath<T>> sweeper(path, ball.m_fRadius, meet, hit);
  if (!sweeper.RunDisc(other.m_fRadius)) return false;
  hit.m_vPOI += other.m_vPos + other.m_vVel * hit.m_fTime;
  hit.m_vSurface = other.m_vVel;
  hit.m_vCenter = ball.m_vPos + ball.m_vVel * hit.m_fTime;
  return true;
}

} // namespace Shapes::Compare
