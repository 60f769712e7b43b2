// SPDX-License-Identifier: MIT
// The way of balls of the reference that are held by what they touch, and where it ends. Included by
// Reference.cpp, and for 50 digits by the tests.
//
// Each contact keeps N.(p - c) constant, with the normal N: of a circle about c it is (p - c) / |p - c|, so
// that the distance is kept; that of a segment turns with it, and c is its centre of rotation. Twice
// differentiated, N.(p - c)'' = -(k N'.(p - c)' + N''.(p - c)) with k = 2 for a segment, and k = 1 without
// the last term for a circle. The forces F along the normals are what makes p'' = g + sum F N / m do so. All
// of it is solved as Taylor series in time: each coefficient of the forces solves the same linear system.
#pragma once

#include "Reference.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Shapes::Compare {

// Accelerations below this many roundings of those that they add up from are none.
inline constexpr int g_nStill = 64;

// The first time up to tMax at which f, with |f''| <= K, falls through 0 from above, or from -tol, where
// `counts` says so. It never oversteps (see CTurningPath).
template <class T, class F, class C>
bool FallsThrough(const F& eval, const C& counts, const T& K, const T& tol, const T& tMax, T& t) {
  using std::abs;
  using std::sqrt;
  const T least = T(1e-4) * tMax;
  T f, df;
  t = T(0);
  eval(t, f, df);
  bool armed = f > T(0) || (f >= -tol && counts(t));
  for (int i = 0; i < 100000; ++i) {
    if (armed && f <= T(0) && df < T(0)) {
      if (counts(t)) return true;
      armed = false;
    }
    armed = armed || f > T(0);
    const bool leaves = f > T(0) ? df >= T(0) : df <= T(0);
    const T gap = abs(f), slope = f > T(0) ? df : T(-df), root = sqrt(slope * slope + T(2) * K * gap);
    T h = leaves ? (K > T(0) ? T((slope + root) / K) : T(tMax + tMax)) : T(T(2) * gap / (root - slope));
    const bool guessed = !(h > T(0)) || (armed && !(f > T(0)));
    if (guessed) h = std::max(least, K > T(0) ? T(abs(df) / K) : T(tMax + tMax));
    if (t + h == t) {
      if (armed && df < T(0) && counts(t)) return true;
      h = least;
    }
    const T from = t;
    t += h;
    if (t > tMax) return false;
    eval(t, f, df);
    if (guessed && armed && f < T(0) && df < T(0) && counts(t)) {
      t = from;
      return true;
    }
  }
  return false;
}

// The ways of all balls in m_stdHeld, up to where the terms that are left out count.
template <class T>
void CReference<T>::Slide() {
  constexpr std::size_t order = static_cast<std::size_t>(std::numeric_limits<T>::digits) / 3 + 8;
  using CSeries = std::vector<CVec<T>>;
  struct CTerms {
    std::size_t m_nBall, m_nOther;          // in `balls`
    CSeries m_stdBase, m_stdNorm, m_stdWay; // the way is from the base
  };
  const T eps = std::numeric_limits<T>::epsilon();
  std::vector<std::size_t> balls;
  const auto place = [&](std::size_t ball) {
    const auto it = std::find(balls.begin(), balls.end(), ball);
    const auto at = static_cast<std::size_t>(it - balls.begin());
    if (it == balls.end()) balls.push_back(ball);
    return at;
  };
  std::vector<CTerms> contacts;
  for (const CHeld& held : m_stdHeld) {
    const CPair& pair = *held.m_pPair;
    const std::size_t ball = place(pair.m_nBall);
    CTerms c{ball, pair.m_bIsBall ? place(pair.m_nOther) : ball, CSeries(order + 1, CVec<T>::Zero()),
             CSeries(order + 1, CVec<T>::Zero()), CSeries(order + 1, CVec<T>::Zero())};
    const CTurning<T>& turning = held.m_cTurning;
    const T w = turning.m_fSpeed;
    c.m_stdBase[0] = held.m_vBase;
    c.m_stdNorm[0] = held.m_vNorm;
    CVec<T> arm = held.m_vBase - turning.m_vCenter, norm = held.m_vNorm;
    for (std::size_t k = 1; k <= order && !pair.m_bIsBall; ++k) {
      arm = (w / T(k)) * Perp(arm);
      norm = (w / T(k)) * Perp(norm);
      c.m_stdBase[k] = k == 1 ? CVec<T>(arm + turning.m_vVel) : arm;
      if (held.m_bLine) c.m_stdNorm[k] = norm;
    }
    contacts.push_back(std::move(c));
  }

  std::vector<CSeries> p(balls.size(), CSeries(order + 1, CVec<T>::Zero()));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    p[i][0] = m_stdBalls[balls[i]].m_vPos;
    p[i][1] = m_stdBalls[balls[i]].m_vVel;
  }
  const auto follow = [&](std::size_t k) { // the coefficients k of what hangs on the balls
    for (std::size_t n = 0; n < contacts.size(); ++n) {
      CTerms& c = contacts[n];
      const CHeld& held = m_stdHeld[n];
      if (held.m_pPair->m_bIsBall) c.m_stdBase[k] = p[c.m_nOther][k];
      c.m_stdWay[k] = p[c.m_nBall][k] - c.m_stdBase[k];
      if (!held.m_bLine) c.m_stdNorm[k] = (held.m_fSide / held.m_pPair->m_fReach) * c.m_stdWay[k];
      if (k == 0) held.m_pPair->m_stdForce.clear();
    }
  };
  follow(0);
  follow(1);
  const CMatrix<T> masses = GetMasses();
  const Eigen::LDLT<CMatrix<T>> solver(masses);
  CColumn<T> missing(static_cast<Eigen::Index>(contacts.size()));
  for (std::size_t k = 0; k + 2 <= order; ++k) {
    const T twice = T(k + 1) * T(k + 2);
    std::vector<CVec<T>> acc(balls.size(), k == 0 ? m_vGravity : CVec<T>(CVec<T>::Zero()));
    const auto add = [&](std::size_t n, const CVec<T>& force) {
      const CTerms& c = contacts[n];
      acc[c.m_nBall] += force / m_stdBalls[balls[c.m_nBall]].m_fMass;
      if (m_stdHeld[n].m_pPair->m_bIsBall) acc[c.m_nOther] -= force / m_stdBalls[balls[c.m_nOther]].m_fMass;
    };
    for (std::size_t n = 0; n < contacts.size(); ++n) {
      CVec<T> force = CVec<T>::Zero();
      for (std::size_t j = 0; j < k; ++j)
        force += m_stdHeld[n].m_pPair->m_stdForce[j] * contacts[n].m_stdNorm[k - j];
      add(n, force);
    }
    for (std::size_t n = 0; n < contacts.size(); ++n) {
      const CTerms& c = contacts[n];
      const bool line = m_stdHeld[n].m_bLine;
      CVec<T> rel = acc[c.m_nBall];
      if (m_stdHeld[n].m_pPair->m_bIsBall)
        rel -= acc[c.m_nOther];
      else
        rel -= twice * c.m_stdBase[k + 2];
      T sum = c.m_stdNorm[0].dot(rel);
      for (std::size_t j = 0; j <= k; ++j) {
        const std::size_t m = k - j;
        if (m > 0) sum += T(j + 1) * T(j + 2) * c.m_stdNorm[m].dot(c.m_stdWay[j + 2]);
        sum += (line ? T(2) : T(1)) * T(m + 1) * T(j + 1) * c.m_stdNorm[m + 1].dot(c.m_stdWay[j + 1]);
        if (line) sum += T(m + 1) * T(m + 2) * c.m_stdNorm[m + 2].dot(c.m_stdWay[j]);
      }
      missing[static_cast<Eigen::Index>(n)] = -sum;
    }
    CColumn<T> forces = solver.solve(missing);
    forces += solver.solve(missing - masses * forces);
    std::vector<T> most(balls.size(), Norm(m_vGravity)); // among the accelerations that add up
    for (std::size_t n = 0; n < contacts.size(); ++n) {
      const T& force = forces[static_cast<Eigen::Index>(n)];
      m_stdHeld[n].m_pPair->m_stdForce.push_back(force);
      add(n, CVec<T>(force * contacts[n].m_stdNorm[0]));
      for (const std::size_t i : {contacts[n].m_nBall, contacts[n].m_nOther})
        most[i] = std::max(most[i], T(force / m_stdBalls[balls[i]].m_fMass));
    }
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (k == 0 && Norm(acc[i]) <= T(g_nStill) * eps * most[i]) acc[i].setZero();
      p[i][k + 2] = acc[i] / twice;
    }
    follow(k + 2);
  }

  using std::exp;
  using std::log;
  T until = m_fStep;
  for (std::size_t n = 0; n < contacts.size(); ++n) {
    const T size = Norm(contacts[n].m_stdWay[0]) + m_stdBalls[balls[contacts[n].m_nBall]].m_fRadius;
    for (const std::size_t i : {contacts[n].m_nBall, contacts[n].m_nOther})
      for (std::size_t k = order - 2; k <= order; ++k)
        if (const T last = Norm(p[i][k]); last > T(0))
          until = std::min(until, T(m_fNow + exp(log(eps / T(64) * size / last) / T(k))));
  }
  for (std::size_t i = 0; i < balls.size(); ++i) {
    CSeries& c = p[i];
    while (c.size() > 3 && c.back().x() == T(0) && c.back().y() == T(0))
      c.pop_back();
    m_stdAcc[balls[i]] = T(2) * c[2];
    m_stdMore[balls[i]].assign(c.begin() + 3, c.end());
    m_stdUntil[balls[i]] = until;
  }
}

// Where the contacts of the ball end or go over into others, and where its series does.
template <class T>
void CReference<T>::MeetLimits(std::size_t i, CNext& next) const {
  const T now = m_stdTime[i], left = m_stdUntil[i] - now;
  for (const CPair& pair : m_stdPairs) {
    if (!pair.m_bHolds || pair.m_nBall != i) continue;
    if (!pair.m_bIsBall) MeetBorders(pair, next);
    const std::vector<T>& force = pair.m_stdForce;
    using std::abs;
    T bound = T(0), t;
    for (std::size_t k = force.size(); k-- > 2;)
      bound = bound * left + abs(force[k]) * T(k) * T(k - 1);
    const auto eval = [&](const T& s, T& f, T& df) {
      f = df = T(0);
      for (std::size_t k = force.size(); k-- > 0;) {
        df = df * s + f;
        f = f * s + force[k];
      }
    };
    if (!FallsThrough(
            eval, [](const T&) { return true; }, bound, T(0), left, t))
      continue;
    if (next.m_bFound && !(now + t < next.m_cHit.m_fTime)) continue;
    next = CNext{true, pair.m_bIsBall, pair.m_nOther, {}, false, eNext::Release};
    next.m_cHit.m_fTime = now + t;
  }
  if (!(m_stdUntil[i] < m_fStep) || (next.m_bFound && next.m_cHit.m_fTime <= m_stdUntil[i])) return;
  next = CNext{true, false, 0, {}, false, eNext::Piece};
  next.m_cHit.m_fTime = m_stdUntil[i];
}

template <class T>
std::vector<typename CReference<T>::CBorder> CReference<T>::GetBorders(const CPair& pair,
                                                                       const CShapeGeometry<T>& f) const {
  const ePart part = pair.m_ePart;
  const CVec<T> all = CVec<T>::Zero();
  const bool isEnd = part == ePart::End0 || part == ePart::End1, first = part == ePart::End0;
  const CVec<T>& end = first ? f.m_vPt0 : f.m_vPt1;
  const T side = f.m_eSides == eSides::Back ? T(-1) : T(1);
  std::vector<CBorder> borders;
  if (f.m_eShapeType == eShape::LineSeg && part != ePart::Point) {
    const CVec<T> along = Unit(CVec<T>(f.m_vPt1 - f.m_vPt0), all), n = Perp(along);
    if (!isEnd)
      return {{f.m_vPt0, -along, all, ePart::End0, false}, {f.m_vPt1, along, all, ePart::End1, false}};
    const CVec<T> in = first ? along : CVec<T>(-along);
    if (f.m_eSides == eSides::Both)
      return {{end, in, n, ePart::Front, false}, {end, in, -n, ePart::Back, false}};
    return {{end, in, all, side > T(0) ? ePart::Front : ePart::Back, false},
            {end, -side * n, all, part, true}};
  }
  if (f.m_eShapeType != eShape::Arc || f.m_bFull) return {};
  const CVec<T>& c = f.m_vCenter;
  const CVec<T> u0 = (f.m_vPt0 - c) / f.m_fRadius, u1 = (f.m_vPt1 - c) / f.m_fRadius;
  if (!isEnd) return {{c, -Perp(u0), u0, ePart::End0, false}, {c, Perp(u1), u1, ePart::End1, false}};
  const CVec<T> u = first ? u0 : u1, in = first ? Perp(u0) : CVec<T>(-Perp(u1));
  const bool fits = m_stdBalls[pair.m_nBall].m_fRadius < f.m_fRadius;
  borders = {{end, in, u, ePart::Outside, f.m_eSides == eSides::Back},
             {end, in, -u, ePart::Inside, f.m_eSides == eSides::Front || !fits}};
  if (f.m_eSides != eSides::Both) borders.push_back({c, all, all, part, true, f.m_fRadius, side});
  return borders;
}

template <class T>
void CReference<T>::MeetBorders(const CPair& pair, CNext& next) const {
  const std::size_t i = pair.m_nBall;
  const T now = m_stdTime[i], left = m_stdUntil[i] - now;
  const CSolid& solid = m_stdShapes[pair.m_nOther];
  const CShapeGeometry<T> f = solid.GetGeometry(now);
  const std::vector<CBorder> borders = GetBorders(pair, f);
  if (borders.empty()) return;
  const CTurning<T> turning = solid.GetTurning(now);
  CSweptBall<T> ball = GetSwept(i, now);
  const T tol = T(2 * g_nTouchRoundings) * std::numeric_limits<T>::epsilon() * GetExtent(f, ball, turning);
  ball.m_vVel -= turning.m_vVel;
  const CTurningPath<T> path(MakePathDesc(ball, left, T(0), T(0)), turning.m_vCenter, turning.m_fSpeed);
  for (const CBorder& border : borders) {
    const T R = border.m_fRadius;
    const auto eval = [&](const T& s, T& off, T& slope) {
      const CVec<T> x = path.GetPos(s) - border.m_vAt, v = path.GetVel(s);
      off = R > T(0) ? T(border.m_fSide * (x.dot(x) - R * R) / (T(2) * R)) : T(-border.m_vOut.dot(x));
      slope = R > T(0) ? T(border.m_fSide * x.dot(v) / R) : T(-border.m_vOut.dot(v));
    };
    const auto counts = [&](const T& s) {
      return border.m_vToward.dot(CVec<T>(path.GetPos(s) - border.m_vAt)) >= T(0);
    };
    const T bound = R > T(0) ? T(path.GetCircleBound(border.m_vAt) / (T(2) * R)) : path.GetAccBound();
    T t;
    if (!FallsThrough(eval, counts, bound, tol, left, t)) continue;
    if (next.m_bFound && !(now + t < next.m_cHit.m_fTime)) continue;
    CVec<T> at = border.m_vAt, out = border.m_vOut;
    if (R > T(0)) {
      const CVec<T> x = Unit(CVec<T>(path.GetPos(t) - at), out);
      at += R * x;
      out = -border.m_fSide * x;
    }
    const T angle = turning.m_fSpeed * t;
    next = CNext{true, false, pair.m_nOther, {}, false, eNext::Border};
    next.m_cHit.m_fTime = now + t;
    next.m_cHit.m_vPOI =
        turning.m_vCenter + t * turning.m_vVel + Turned(CVec<T>(at - turning.m_vCenter), angle);
    next.m_cHit.m_vNorm = Turned(out, angle);
    next.m_cHit.m_ePart = border.m_ePart;
    next.m_cHit.m_bBegins = !border.m_bOpen;
  }
}

template <class T>
void CReference<T>::PassLimit(std::size_t i, const CNext& next) {
  m_stdChanged = {i};
  GatherHeld();
  if (next.m_eNext != eNext::Piece) {
    CPair& pair = GetPair(i, next.m_nOther, next.m_bIsBall);
    const CHit<T>& hit = next.m_cHit;
    if (next.m_eNext == eNext::Border) {
      // The ball is put past the border by more than what counts as on it.
      const CSolid& solid = m_stdShapes[next.m_nOther];
      const T touch = T(g_nTouchRoundings) * std::numeric_limits<T>::epsilon() *
                      GetExtent(solid.GetGeometry(m_fNow), GetSwept(i, m_fNow), solid.GetTurning(m_fNow));
      CVec<T>& p = m_stdBalls[i].m_vPos;
      p += (T(2) * touch - hit.m_vNorm.dot(CVec<T>(p - hit.m_vPOI))) * hit.m_vNorm;
    }
    if (next.m_eNext == eNext::Border && hit.m_bBegins) {
      BeginHold(pair, hit.m_ePart);
    } else {
      pair.m_bHolds = pair.m_bSlides = false;
      pair.m_nClose = 0;
    }
  }
  Support();
}

} // namespace Shapes::Compare
