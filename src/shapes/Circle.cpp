// SPDX-License-Identifier: MIT
#include <Shapes/Circle.h>

#include "Validate.h"

#include <cmath>

namespace Shapes {

CCircleDesc::CCircleDesc(const Vector2& p, float r, float e) : CCircleDesc() {
  m_vPos = p;
  m_fRadius = r;
  m_fElasticity = e;
}

CCircle::CCircle(const CCircleDesc& desc, eMotion motion, eShape type)
    : CShape(desc, type, motion), m_fRadius(desc.m_fRadius) {
  RequireRange("m_fRadius", m_fRadius, 0.0f, g_fMaxLength);
  CCircle::Update();
}

std::unique_ptr<CShape> CCircle::Clone() const { return std::make_unique<CCircle>(*this); }

bool CCircle::PtInCircle(const Vector2& p) const { return Length(p - m_vPos) < m_fRadius; }

Vector2 CCircle::ClosestPt(const Vector2& p) const { return m_vPos + m_fRadius * Normalize(p - m_vPos); }

bool CCircle::Tangents(const Vector2& p, Vector2& p0, Vector2& p1) const {
  const Vector2 v = m_vPos - p;
  const float d = Length(v);
  FailIf(!(d > 0.0f && d >= m_fRadius));

  // The tangent, the radius and the way to the centre are a right triangle of hypotenuse d. As a product its
  // third side loses nothing close to the circle, and its angle at p is used by sine and cosine alone.
  // In double it neither overflows nor depends on the unit of length: a power of two changes no digits.
  const double square = static_cast<double>(d - m_fRadius) * static_cast<double>(d + m_fRadius);
  const float delta = static_cast<float>(std::sqrt(square));
  const Vector2 along = (delta / d) * (delta / d) * v;
  const Vector2 aside = (delta / d) * (m_fRadius / d) * perp(v);
  p0 = p + along + aside;
  p1 = p + along - aside;
  return true;
}

bool CCircle::Tangents(const CCircle* pCircle, CLineSegDesc& t0, CLineSegDesc& t1) const {
  if (pCircle == nullptr) Refuse("pCircle", "null", "another circle");
  const Vector2 v = pCircle->m_vPos - m_vPos;
  const float d = Length(v);
  const float shrunk = m_fRadius - pCircle->m_fRadius;
  FailIf(!(d > std::abs(shrunk)));

  // Shrunk by the smaller radius, one circle is a point and the other has radius |shrunk|; the radius that
  // touches a tangent makes the angle with the way between the centres whose cosine is shrunk / d, in both
  // circles.
  const Vector2 ahead = (shrunk / d) * (v / d);
  const Vector2 left = std::sqrt((1.0f - shrunk / d) * (1.0f + shrunk / d)) * perp(v / d);
  const Vector2 n0 = ahead - left, n1 = ahead + left;
  t0.SetEndPts(m_vPos + m_fRadius * n0, pCircle->m_vPos + pCircle->m_fRadius * n0);
  t1.SetEndPts(m_vPos + m_fRadius * n1, pCircle->m_vPos + pCircle->m_fRadius * n1);
  return true;
}

bool CCircle::Tangent(const CCircle* pCircle, CLineSegDesc& t) const {
  CLineSegDesc other;
  return Tangents(pCircle, t, other);
}

void CCircle::Update() {
  const Vector2 r(-m_fRadius, m_fRadius); // to the top left
  m_cAabb = CAabb2D(m_vPos + r, m_vPos - r);
}

} // namespace Shapes
