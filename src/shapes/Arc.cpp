// SPDX-License-Identifier: MIT
#include <Shapes/Arc.h>

#include "../Tolerances.h"
#include "../geometry/Vector.h"

#include "Validate.h"

#include <cmath>
#include <limits>

namespace Shapes {

CArcDesc::CArcDesc(const Vector2& p, float r, float a0, float a1, float e) : CCircleDesc(p, r, e) {
  m_eShapeType = eShape::Arc;
  SetAngles(a0, a1);
}

void CArcDesc::SetAngles(float a0, float a1) {
  m_fAngle0 = NormalizeAngle(a0);
  m_fAngle1 = NormalizeAngle(a1);
  // Nobody's whole turn: not finite, or the difference may not be.
  constexpr float most = 0.25f * std::numeric_limits<float>::max();
  if (!std::islessequal(std::abs(a0), most) || !std::islessequal(std::abs(a1), most)) return;
  // A whole turn in float is not a whole turn: reduced one by one, the angles would leave an arc of a few
  // 1e-7 rad.
  const float turn = std::abs(a1 - a0), rounding = g_fFullTurnRounding * (std::abs(a0) + std::abs(a1));
  if (std::abs(turn - g_fTwoPi) <= rounding) m_fAngle1 = m_fAngle0;
}

void CArcDesc::GetEndPts(Vector2& p0, Vector2& p1) const {
  p0 = m_vPos + m_fRadius * AngleToVector(m_fAngle0);
  p1 = m_vPos + m_fRadius * AngleToVector(m_fAngle1);
}

void CArcDesc::GetTangents(Vector2& t0, Vector2& t1) const {
  t0 = perp(AngleToVector(m_fAngle0));
  t1 = -perp(AngleToVector(m_fAngle1));
}

CArc::CArc(const CArcDesc& desc, eMotion motion)
    : CCircle(desc, motion, eShape::Arc),
      m_fAngle0(desc.GetAngle0()),
      m_fSpan(g_fTwoPi),
      m_bFull(desc.GetAngle0() == desc.GetAngle1()),
      m_eSides(desc.m_eSides) {
  RequireFinite("m_fAngle0", desc.GetAngle0());
  RequireFinite("m_fAngle1", desc.GetAngle1());
  RequireSides(desc.m_eSides);
  m_fSpan = desc.GetAngle1() - desc.GetAngle0();
  if (m_fSpan <= 0.0f) m_fSpan += g_fTwoPi;
  desc.GetEndPts(m_vPt0, m_vPt1);
  m_vStartPt0 = m_vPt0;
  m_vStartPt1 = m_vPt1;
  m_fStartAngle0 = m_fAngle0;
  CArc::Update();
}

std::unique_ptr<CShape> CArc::Clone() const { return std::make_unique<CArc>(*this); }

float CArc::GetAngle1() const { return m_bFull ? m_fAngle0 : NormalizeAngle(m_fAngle0 + m_fSpan); }

void CArc::GetTangents(Vector2& t0, Vector2& t1) const {
  t0 = perp(Normalize(m_vPt0 - m_vPos));
  t1 = -perp(Normalize(m_vPt1 - m_vPos));
}

bool CArc::PtInSector(const Vector2& p) const {
  if (m_bFull || p == m_vPt0 || p == m_vPt1) return true;

  // Through the end points as they were rounded, not through the exact angles: a point on an end ray then
  // gives a cross product of 0 within its own rounding.
  const Vector2 e0 = m_vPt0 - m_vPos, e1 = m_vPt1 - m_vPos, u = p - m_vPos;
  const auto leftOf = [](const Vector2& a, const Vector2& b) { // b left of a, or on a's line within rounding
    return a.x() * b.y() - a.y() * b.x() >= -g_fSectorRounding * a.lpNorm<1>() * b.lpNorm<1>();
  };
  // On a short arc both hold for what is opposite to it as well, within rounding: ask which side it is on.
  if (m_fSpan < 1.0f && u.dot(e0) < 0.0f) return false;
  // More than half a turn? Where that is close, the ends as they were rounded know.
  const bool wide = e0.dot(e1) < 0.0f ? Cross(e0, e1) < 0.0f : m_fSpan > g_fPi;
  return wide ? leftOf(e0, u) || leftOf(u, e1) : leftOf(e0, u) && leftOf(u, e1);
}

Vector2 CArc::ClosestPt(const Vector2& p) const {
  if (PtInSector(p)) return p == m_vPos ? m_vPt0 : CCircle::ClosestPt(p);
  return Length(p - m_vPt0) <= Length(p - m_vPt1) ? m_vPt0 : m_vPt1;
}

void CArc::Translate(const Vector2& d) {
  m_vPt0 += d;
  m_vPt1 += d;
  CArc::Update();
}

Vector2 CArc::TurnFromStart(const Vector2& center, float angle) {
  // The ends are turned as points: adding the angle to both angles could round a short arc to a full circle.
  const Geometry::CTurn turn = Geometry::GetTurn(static_cast<double>(angle));
  m_vPt0 = Geometry::RotatePt(Moved(m_vStartPt0), center, turn);
  m_vPt1 = Geometry::RotatePt(Moved(m_vStartPt1), center, turn);
  m_fAngle0 = NormalizeAngle(m_fStartAngle0 + angle);
  return CCircle::TurnFromStart(center, angle);
}

void CArc::Update() {
  m_cAabb = m_vPt0;
  m_cAabb += m_vPt1;
  // The arc is met at its radius, where its rounded ends need not lie; and ends that were rounded past half a
  // turn from each other have the sector end opposite to one of them.
  for (const Vector2& end : {m_vPt0, m_vPt1}) {
    const Vector2 out = m_fRadius * Normalize(end - m_vPos);
    m_cAabb += m_vPos + out;
    if (PtInSector(m_vPos - out)) m_cAabb += m_vPos - out;
  }
  for (const Vector2& axis : {Vector2(1, 0), Vector2(0, 1), Vector2(-1, 0), Vector2(0, -1)}) {
    const Vector2 quadrant = m_vPos + m_fRadius * axis;
    if (PtInSector(quadrant)) m_cAabb += quadrant;
  }
}

} // namespace Shapes
