// SPDX-License-Identifier: MIT
#include <Shapes/Shape.h>

#include "../Tolerances.h"

#include "Validate.h"

namespace Shapes {

float CShapeCommon::m_fGravity = 0.0f;
float CShapeCommon::m_fTimeStep = 1.0f / 60.0f;

CShape::CShape(const CShapeDesc& desc, eShape type, eMotion motion)
    : m_eShapeType(type),
      m_eMotionType(motion),
      m_bIsSensor(desc.m_bIsSensor),
      m_fElasticity(desc.m_fElasticity),
      m_fRotSpeed(desc.m_fRotSpeed),
      m_vPos(desc.m_vPos),
      m_vStartPos(desc.m_vPos),
      m_vRotCenter(desc.m_vRotCenter),
      m_vStartRotCenter(desc.m_vRotCenter) {
  RequireVector("m_vPos", m_vPos, g_fMaxLength);
  RequireRange("m_fElasticity", m_fElasticity, 0.0f, g_fMaxElasticity);
  RequireRange("m_fRotSpeed", m_fRotSpeed, -g_fMaxRotSpeed, g_fMaxRotSpeed);
  RequireVector("m_vRotCenter", m_vRotCenter, g_fMaxLength);
}

void CShape::SetPos(const Vector2& p) {
  RequireVector("m_vPos", p, g_fMaxLength);
  const Vector2 d = p - m_vPos;
  m_vPos = p;
  m_fLastTurn = 0.0f;
  Translate(d);
  Update();
}

void CShape::Relocate(const Vector2& p) {
  if (m_eMotionType != eMotion::Kinematic) return SetPos(p);
  const Vector2 d = p - m_vPos, center = m_vRotCenter + d;
  RequireVector("m_vPos", p, g_fMaxLength);
  RequireVector("m_vRotCenter", center, g_fMaxLength);
  SetPos(p);
  m_vRotCenter = center;
  m_vMoved += d;
}

Vector2 CShape::TurnFromStart(const Vector2& center, float angle) {
  return RotatePt(m_vStartPos + m_vMoved, center, angle);
}

void CShape::BackToStart() { m_vPos = m_vStartPos; }

void CShape::SetElasticity(float e) {
  RequireRange("m_fElasticity", e, 0.0f, g_fMaxElasticity);
  m_fElasticity = e;
}

void CShape::SetRotSpeed(float revsPerSecond) {
  RequireRange("m_fRotSpeed", revsPerSecond, -g_fMaxRotSpeed, g_fMaxRotSpeed);
  m_fRotSpeed = revsPerSecond;
}

void CShape::SetRotCenter(const Vector2& center) {
  RequireVector("m_vRotCenter", center, g_fMaxLength);
  m_vRotCenter = center;
  m_vStartRotCenter = center - m_vMoved;
}

void CShape::Rotate(const Vector2& center, float angle) {
  if (m_eMotionType != eMotion::Kinematic) return;
  RequireVector("center", center, g_fMaxLength);
  RequireFinite("angle", angle);
  m_fOrientation = NormalizeAngle(angle);
  m_fLastTurn = 0.0f;
  m_vPos = TurnFromStart(center, m_fOrientation);
  Update();
}

void CShape::Reset() {
  if (m_eMotionType != eMotion::Kinematic) return;
  m_fOrientation = m_fLastTurn = 0.0f;
  m_vRotCenter = m_vStartRotCenter;
  m_vMoved.setZero();
  BackToStart();
  Update();
}

void CShape::Advance(float dt) {
  if (!GetRotating()) {
    m_fLastTurn = 0.0f;
    return;
  }
  const float turn = g_fTwoPi * m_fRotSpeed * dt;
  Rotate(m_vRotCenter, m_fOrientation + turn);
  m_fLastTurn = turn;
}

Vector2 CShape::GetSurfaceVelocity(const Vector2& p) const {
  if (!GetRotating()) return Vector2::Zero();
  return g_fTwoPi * m_fRotSpeed * perp(p - m_vRotCenter);
}

} // namespace Shapes
