// SPDX-License-Identifier: MIT
#include "ParabolicCorrection.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <cmath>

#include "../Convert.h"

namespace Shapes::Box2D {
namespace {

Vector2d Bounded(const Vector2d& v, double most) {
  const double length = v.norm();
  return length > most ? Vector2d(most / length * v) : v;
}

} // namespace

void CParabolicCorrection::Begin(const Vector2d& g, double h) {
  m_vGravity = g;
  m_fStep = h;
  m_fPart = 0.0;
  m_vPos.setZero();
  m_vVel = -0.5 * h * g;
  m_bHasBounced = m_bHasMotion = false;
  m_stdRests.clear();
}

double CParabolicCorrection::PartAt(const b2Body& ball, const b2Vec2& start) const {
  const b2Vec2 v = ball.GetLinearVelocity(), p = ball.GetPosition();
  const double vv = static_cast<double>(b2Dot(v, v)) * m_fStep;
  if (!(vv > 0.0)) return std::clamp(m_fPart, 0.0, 1.0);
  const double part = m_bHasMotion ? 1.0 - static_cast<double>(b2Dot(m_vMotionEnd - p, v)) / vv
                                   : static_cast<double>(b2Dot(p - start, v)) / vv;
  return std::clamp(part, 0.0, 1.0);
}

void CParabolicCorrection::GetDeviation(double part, Vector2d& p, Vector2d& v) const {
  const double t = (part - m_fPart) * m_fStep;
  // Box2D moves nothing farther than that, so the correction of a faster ball is bounded, too.
  p = Bounded(m_vPos + t * m_vVel + 0.5 * t * t * m_vGravity, static_cast<double>(b2_maxTranslation));
  v = m_vVel + t * m_vGravity;
}

double CParabolicCorrection::Bounce(const CImpact& impact, CParabolicCorrection& ball, double share,
                                    CParabolicCorrection* pOther) {
  const Vector2d& n = impact.m_vNorm;
  const double h = ball.m_fStep, wn = impact.m_fSpeed;
  // The ways on the parabolas meet a little later or earlier than the straight ones: Newton's method.
  Vector2d p, v, p1 = Vector2d::Zero(), v1 = Vector2d::Zero();
  double t = impact.m_fTime;
  for (int i = 0; i < 3; ++i) {
    ball.GetDeviation(impact.m_fPart + t / h, p, v);
    if (pOther != nullptr) pOther->GetDeviation(impact.m_fPart + t / h, p1, v1);
    const double speed = wn + (v - v1).dot(n);
    if (i == 2 || !(speed < 0.0)) break;
    const double next = t - ((p - p1).dot(n) + wn * (t - impact.m_fTime)) / speed;
    if (!(std::abs(next - impact.m_fTime) <= h)) break; // they do no more than touch
    t = next;
  }
  const double impulse = (1.0 + impact.m_fElasticity) * (v - v1).dot(n);
  const double back = (1.0 + impact.m_fElasticity) * wn * t;
  ball.SetDeviation(impact.m_fPart + t / h, p + share * back * n, v - share * impulse * n);
  if (pOther != nullptr)
    pOther->SetDeviation(impact.m_fPart + t / h, p1 - (1.0 - share) * back * n,
                         v1 + (1.0 - share) * impulse * n);
  return -wn - (v - v1).dot(n);
}

void CParabolicCorrection::SetDeviation(double part, const Vector2d& p, const Vector2d& v) {
  m_fPart = part;
  m_vPos = p;
  m_vVel = Bounded(v, static_cast<double>(g_fMaxBox2DSpeedGain)); // each bounce may multiply it
  m_bHasBounced = true;
}

void CParabolicCorrection::MotionEnds(const b2Body& ball) {
  m_bHasMotion = true;
  m_vMotionEnd = ball.GetPosition();
}

void CParabolicCorrection::Land(b2Body& ball) const {
  Vector2d p, v;
  GetDeviation(1.0, p, v);
  for (const Vector2d& n : m_stdRests) {
    v -= std::min(0.0, v.dot(n)) * n;
    p -= std::min(0.0, p.dot(n)) * n;
  }
  ball.SetLinearVelocity(ball.GetLinearVelocity() + ToFloat(v));
  if (!m_bHasBounced) return; // the way of a ball in free flight ends on its parabola
  ball.SetTransform(ball.GetPosition() + ToFloat(p), ball.GetAngle());
}

} // namespace Shapes::Box2D
