// SPDX-License-Identifier: MIT
#include <Shapes/Compound.h>

#include "../geometry/Turn.h"
#include "Validate.h"

namespace Shapes {

void CCompoundShape::AddShape(CShape* pShape) {
  if (pShape == nullptr) Refuse("pShape", "null", "a shape");
  pShape->SetVel(m_vVel);
  pShape->SetRotSpeed(m_fRotSpeed);
  pShape->SetRotCenter(m_vRotCenter);
  if (m_fOrientation != 0.0f || pShape->GetOrientation() != 0.0f) pShape->SetOrientation(m_fOrientation);
  m_stdShapes.push_back(pShape);
}

void CCompoundShape::Rotate(const Vector2& center, float angle) {
  RequireVector("center", center, g_fMaxLength);
  RequireFinite("angle", angle);
  m_fAngle = m_fOrientation = NormalizeAngle(angle);
  for (CShape* pShape : m_stdShapes)
    pShape->Rotate(center, angle);
}

void CCompoundShape::Reset() {
  m_fAngle = m_fOrientation = 0.0f;
  m_vMoved.setZero();
  m_vRotCenter = m_vStartRotCenter.cast<float>();
  for (CShape* pShape : m_stdShapes)
    pShape->Reset();
}

void CCompoundShape::move() {
  for (CShape* pShape : m_stdShapes)
    pShape->move();
  m_fAngle = Geometry::TurnOn(m_fAngle, m_fRotSpeed, m_fTimeStep);
  m_fOrientation = NormalizeAngle(static_cast<float>(m_fAngle));
  m_vMoved += m_vVel.cast<double>() * static_cast<double>(m_fTimeStep);
  m_vRotCenter = (m_vStartRotCenter + m_vMoved).cast<float>();
}

void CCompoundShape::SetVel(const Vector2& v) {
  RequireVector("m_vVel", v, g_fMaxSpeed);
  m_vVel = v;
  for (CShape* pShape : m_stdShapes)
    pShape->SetVel(v);
}

void CCompoundShape::SetRotSpeed(float revsPerSecond) {
  RequireRange("m_fRotSpeed", revsPerSecond, -g_fMaxRotSpeed, g_fMaxRotSpeed);
  m_fRotSpeed = revsPerSecond;
  for (CShape* pShape : m_stdShapes)
    pShape->SetRotSpeed(revsPerSecond);
}

void CCompoundShape::SetRotCenter(const Vector2& center) {
  RequireVector("m_vRotCenter", center, g_fMaxLength);
  m_vRotCenter = center;
  m_vStartRotCenter = center.cast<double>() - m_vMoved;
  for (CShape* pShape : m_stdShapes)
    pShape->SetRotCenter(center);
}

} // namespace Shapes
