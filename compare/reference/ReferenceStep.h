// SPDX-License-Identifier: MIT
// Shapes, balls and the step of the reference. Included by Reference.cpp, and for 50 digits by the tests.
#pragma once

#include "Reference.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace Shapes::Compare {
template <class T>
T Tau() {
  return boost::math::constants::two_pi<T>();
}

template <class T>
bool IsFinite(const T& x) {
  return x - x == T(0);
}

template <class T>
T CReference<T>::CSolid::GetSpeed() const {
  return Turns() ? T(Tau<T>() * m_fRevs) : T(0);
}

template <class T>
CShapeGeometry<T> CReference<T>::CSolid::GetGeometry(const T& t) const {
  const T angle = m_fAngle + GetSpeed() * t;
  const CVec<T> way = m_vMoved + t * m_vVel;
  CShapeGeometry<T> f = m_cGeometry;
  for (CVec<T>* p : {&f.m_vCenter, &f.m_vPt0, &f.m_vPt1}) {
    if (angle != T(0)) *p = m_vRotCenter + Turned(CVec<T>(*p - m_vRotCenter), angle);
    *p += way;
  }
  return f;
}

template <class T>
CTurning<T> CReference<T>::CSolid::GetTurning(const T& t) const {
  return {m_vRotCenter + m_vMoved + t * m_vVel, GetSpeed(), m_vVel};
}

template <class T>
void CReference<T>::CSolid::SetBox() {
  const CShapeGeometry<T> f = GetGeometry(T(0));
  const T padded = f.m_fRadius * T(1.0 + 4.0 * g_fGraze);
  const CVec<T> r(padded, padded);
  switch (f.m_eShapeType) {
  case eShape::LineSeg:
    m_vLow = f.m_vPt0.cwiseMin(f.m_vPt1);
    m_vHigh = f.m_vPt0.cwiseMax(f.m_vPt1);
    break;
  case eShape::Point:
  case eShape::Circle:
  case eShape::Arc: // as the whole circle
    m_vLow = f.m_vCenter - r;
    m_vHigh = f.m_vCenter + r;
  }
  if (!m_bKinematic) return;
  const T reach = std::max({Norm(CVec<T>(f.m_vPt0 - m_vRotCenter)), Norm(CVec<T>(f.m_vPt1 - m_vRotCenter)),
                            T(Norm(CVec<T>(f.m_vCenter - m_vRotCenter)) + padded)});
  const T eps = std::numeric_limits<T>::epsilon();
  const T all = reach + T(16) * eps * (reach + m_vRotCenter.cwiseAbs().maxCoeff());
  m_vLow = m_vRotCenter - CVec<T>(all, all);
  m_vHigh = m_vRotCenter + CVec<T>(all, all);
}

template <class T>
CReference<T>::CReference(std::span<const CAnyShapeDesc> shapes, std::span<const CDynamicCircleDesc> balls,
                          const Vector2& gravity)
    : m_vGravity(gravity.cast<T>()) {
  if (!gravity.allFinite()) throw std::invalid_argument("gravity is not finite");
  for (const CAnyShapeDesc& any : shapes) {
    CSolid solid{};
    solid.m_cGeometry = MakeShapeGeometry(any).Cast<T>();
    std::visit(
        [&](const CShapeDesc& desc) {
          solid.m_vRotCenter = desc.m_vRotCenter.template cast<T>();
          solid.m_vVel = desc.m_vVel.template cast<T>();
          solid.m_vMoved = CVec<T>::Zero();
          solid.m_bKinematic = desc.m_eMotionType == eMotion::Kinematic;
          solid.m_fRevs = T(desc.m_fRotSpeed);
          solid.m_fElasticity = T(desc.m_fElasticity);
          solid.m_bIsSensor = desc.m_bIsSensor;
          solid.m_cFilter = desc.m_cFilter;
          if (desc.m_bIsSensor) solid.m_cGeometry.m_eSides = eSides::Both; // sensors are seen from anywhere
        },
        any);
    solid.m_fAngle = T(0);
    solid.m_bCanCollide = true;
    solid.SetBox();
    m_stdShapes.push_back(solid);
  }
  for (const CDynamicCircleDesc& desc : balls) {
    const CDynamicCircle ball(desc);
    m_stdBalls.push_back({ball.GetPos().cast<T>(), ball.GetVel().cast<T>(), T(ball.GetRadius()),
                          T(ball.GetMass()), T(ball.GetElasticity()), ball.GetSensor(), ball.GetFilter()});
  }
}

template <class T>
void CReference<T>::SetBall(std::size_t ball, const CVec<T>& p, const CVec<T>& v) {
  for (const T& x : {p.x(), p.y(), v.x(), v.y()})
    if (!IsFinite(x)) throw std::invalid_argument("p or v is not finite");
  m_stdBalls.at(ball).m_vPos = p;
  m_stdBalls.at(ball).m_vVel = v;
}

template <class T>
void CReference<T>::SetOrientation(std::size_t shape, const T& angle) {
  CSolid& solid = m_stdShapes.at(shape);
  if (!solid.m_bKinematic || !IsFinite(angle))
    throw std::invalid_argument("SetOrientation: expected a kinematic shape and a finite angle");
  const T tau = Tau<T>();
  solid.m_fAngle = TakeTurnsOff(angle);
  if (solid.m_fAngle < T(0)) solid.m_fAngle += tau;
  if (solid.m_fAngle >= tau) solid.m_fAngle = T(0);
}

template <class T>
void CReference<T>::SetOffset(std::size_t shape, const CVec<T>& way) {
  if (!IsFinite(T(way.x() + way.y()))) throw std::invalid_argument("way is not finite");
  m_stdShapes.at(shape).m_vMoved = way;
}

template <class T>
void CReference<T>::SetVel(std::size_t shape, const CVec<T>& v) {
  if (!IsFinite(T(v.x() + v.y()))) throw std::invalid_argument("v is not finite");
  m_stdShapes.at(shape).m_vVel = v;
}

template <class T>
void CReference<T>::SetRotSpeed(std::size_t shape, const T& revsPerSecond) {
  CSolid& solid = m_stdShapes.at(shape);
  if (!solid.m_bKinematic || !IsFinite(revsPerSecond))
    throw std::invalid_argument("SetRotSpeed: expected a kinematic shape and a finite speed");
  solid.m_fRevs = revsPerSecond;
}

template <class T>
void CReference<T>::Step(const T& dt, std::vector<CExactEvent<T>>& events) {
  if (!(IsFinite(dt) && dt >= T(0)))
    throw std::invalid_argument("dt: expected a finite number of at least 0");
  const std::size_t balls = m_stdBalls.size(), events0 = events.size();
  m_fStep = dt;
  m_fNow = T(0);
  m_stdTime.assign(balls, T(0));
  m_stdAcc.assign(balls, m_vGravity);
  m_stdMore.assign(balls, {});
  m_stdUntil.assign(balls, dt);
  m_stdNext.resize(balls);
  m_stdNear.clear();
  m_fSpeeds = T(0);
  Continue();
  for (std::size_t i = 0; i < balls; ++i)
    FindNext(i);

  for (std::size_t count = 0;; ++count) {
    std::size_t first = balls;
    for (std::size_t i = 0; i < balls; ++i)
      if (m_stdNext[i].m_bFound &&
          (first == balls || m_stdNext[i].m_cHit.m_fTime < m_stdNext[first].m_cHit.m_fTime))
        first = i;
    if (first == balls) break;
    if ((events.size() - events0) * balls >= g_nMaxEvents || count * balls >= g_nMaxTurns) Jammed(first);
    const CNext next = m_stdNext[first];
    m_fNow = next.m_cHit.m_fTime;
    CountNearMisses(m_fNow);
    m_stdChanged.clear();
    if (next.m_eNext != eNext::Impact)
      PassLimit(first, next);
    else
      Answer(first, next, events, events0);
    for (const std::size_t ball : m_stdChanged)
      if (!IsFinite(m_stdBalls[ball].m_vVel.x() + m_stdBalls[ball].m_vVel.y())) TooFast(ball);
    FindAfter();
  }

  CountNearMisses(dt);
  for (CPair& pair : m_stdPairs) {
    T force = T(0);
    for (std::size_t k = pair.m_stdForce.size(); k-- > 0;)
      force = force * (dt - m_stdTime[pair.m_nBall]) + pair.m_stdForce[k];
    pair.m_stdForce = {force};
  }
  for (std::size_t i = 0; i < balls; ++i)
    Advance(i, dt);
  for (std::size_t i = 0; i < m_stdShapes.size(); ++i) {
    CSolid& solid = m_stdShapes[i];
    solid.m_vMoved += dt * solid.m_vVel;
    if (solid.Turns()) SetOrientation(i, solid.m_fAngle + solid.GetSpeed() * dt);
  }
}

template <class T>
CSweptBall<T> CReference<T>::GetSwept(std::size_t i, const T& t) const {
  const CExactBall<T>& ball = m_stdBalls[i];
  const CSweptBall<T> at{ball.m_vPos, ball.m_vVel, ball.m_fRadius, m_stdAcc[i], m_stdMore[i]};
  const T since = t - m_stdTime[i];
  if (at.m_stdMore.empty()) return {at.GetPos(since), at.GetVel(since), at.m_fRadius, at.m_vAcc};
  if (since == T(0)) return at;
  // All coefficients of the same way from there, by Horner's rule.
  CMore<T> c{at.m_vPos, at.m_vVel, at.m_vAcc / T(2)};
  c.insert(c.end(), at.m_stdMore.begin(), at.m_stdMore.end());
  for (std::size_t k = 0; k + 1 < c.size(); ++k)
    for (std::size_t j = c.size() - 1; j-- > k;)
      c[j] += since * c[j + 1];
  return {c[0], c[1], at.m_fRadius, T(2) * c[2], CMore<T>(c.begin() + 3, c.end())};
}

template <class T>
void CReference<T>::Advance(std::size_t i, const T& t) {
  if (m_stdTime[i] == t) return;
  const CSweptBall<T> at = GetSwept(i, t);
  m_stdBalls[i].m_vPos = at.m_vPos;
  m_stdBalls[i].m_vVel = at.m_vVel;
  m_stdAcc[i] = at.m_vAcc;
  m_stdMore[i] = at.m_stdMore;
  m_stdTime[i] = t;
}

template <class T>
T CReference<T>::GetForce(std::size_t ball, std::size_t other, bool isBall) const {
  for (const CPair& pair : m_stdPairs)
    if (pair.m_bHolds && pair.m_nBall == ball && pair.m_nOther == other && pair.m_bIsBall == isBall)
      return pair.m_stdForce.at(0);
  return T(0);
}

template <class T>
typename CReference<T>::CPair* CReference<T>::FindPair(std::size_t ball, std::size_t other, bool isBall) {
  const auto it = std::find_if(m_stdPairs.begin(), m_stdPairs.end(), [&](const CPair& p) {
    return p.m_nBall == ball && p.m_nOther == other && p.m_bIsBall == isBall;
  });
  return it == m_stdPairs.end() ? nullptr : &*it;
}

template <class T>
typename CReference<T>::CPair& CReference<T>::GetPair(std::size_t ball, std::size_t other, bool isBall) {
  if (CPair* pPair = FindPair(ball, other, isBall)) return *pPair;
  return m_stdPairs.emplace_back(ball, other, isBall);
}

template <class T>
void CReference<T>::Jammed(std::size_t i) const {
  const CNext& next = m_stdNext[i];
  std::ostringstream out;
  out << "too many events in a step of " << m_fStep << " s: ball " << i << " at ("
      << next.m_cHit.m_vCenter.x() << ", " << next.m_cHit.m_vCenter.y() << ") is jammed against "
      << (next.m_bIsBall ? "ball " : "shape ") << next.m_nOther << ", " << m_fNow << " s into the step";
  throw std::runtime_error(out.str());
}

template <class T>
void CReference<T>::TooFast(std::size_t i) const {
  std::ostringstream out;
  out << "ball " << i << " is faster than the reference can tell, " << m_fNow << " s into a step of "
      << m_fStep << " s: expected elasticities with which speeds stay finite";
  throw std::runtime_error(out.str());
}

} // namespace Shapes::Compare
