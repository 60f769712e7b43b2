// SPDX-License-Identifier: MIT
#include "Flight.h"

#include <algorithm>

namespace Shapes::Box2D {

void CFlight::Begin(const Vector2d& g, double h) {
  m_vGravity = g;
  m_fStep = h;
  m_fPart = 0.0;
  m_vPos.setZero();
  m_vVel = -0.5 * h * g;
  m_bHasBounced = m_bHasLeg = false;
  m_stdRests.clear();
}

double CFlight::PartAt(const b2Body& ball, const b2Vec2& start) const {
  const b2Vec2 v = ball.GetLinearVelocity(), p = ball.GetPosition();
  const double vv = static_cast<double>(b2Dot(v, v)) * m_fStep;
  if (!(vv > 0.0)) return m_fPart;
  const double part = m_bHasLeg ? 1.0 - static_cast<double>(b2Dot(m_vLegEnd - p, v)) / vv
                                : static_cast<double>(b2Dot(p - start, v)) / vv;
  return std::clamp(part, m_fPart, 1.0);
}

void CFlight::At(double part, Vector2d& p, Vector2d& v) const {
  const double t = (part - m_fPart) * m_fStep;
  p = m_vPos + t * m_vVel + 0.5 * t * t * m_vGravity;
  v = m_vVel + t * m_vGravity;
}

Vector2d CFlight::Bounce(double part, const Vector2d& n, double wn, double e) {
  // The parabola meets the surface a little later than the straight way, t after it: two rounds of Newton's
  // method.
  Vector2d p, v;
  double t = 0.0;
  for (int i = 0; i < 3; ++i) {
    At(part + t / m_fStep, p, v);
    if (i == 2 || !(wn + v.dot(n) < 0.0)) break;
    t -= (p.dot(n) + wn * t) / (wn + v.dot(n));
  }
  m_vPos = p + (1.0 + e) * wn * t * n;
  m_vVel = v - (1.0 + e) * v.dot(n) * n;
  m_fPart = part + t / m_fStep;
  m_bHasBounced = true;
  return v;
}

void CFlight::LegEnds(const b2Body& ball) {
  m_bHasLeg = true;
  m_vLegEnd = ball.GetPosition();
}

void CFlight::Land(b2Body& ball) const {
  Vector2d p, v;
  At(1.0, p, v);
  for (const Vector2d& n : m_stdRests) {
    v -= std::min(0.0, v.dot(n)) * n;
    p -= std::min(0.0, p.dot(n)) * n;
  }
  const b2Vec2 dv(static_cast<float>(v.x()), static_cast<float>(v.y()));
  ball.SetLinearVelocity(ball.GetLinearVelocity() + dv);
  if (!m_bHasBounced) return; // the way of a ball in free flight ends on its parabola
  const b2Vec2 dp(static_cast<float>(p.x()), static_cast<float>(p.y()));
  ball.SetTransform(ball.GetPosition() + dp, ball.GetAngle());
}

} // namespace Shapes::Box2D
