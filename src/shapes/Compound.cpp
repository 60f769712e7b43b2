// SPDX-License-Identifier: MIT
#include <Shapes/Compound.h>

#include "Validate.h"

namespace Shapes {

void CCompoundShape::AddShape(CShape* pShape) {
  if (pShape == nullptr) Refuse("pShape", "null", "a shape");
  pShape->SetVel(GetVel());
  pShape->SetRotSpeed(GetRotSpeed());
  pShape->SetRotCenter(GetRotCenter());
  if (GetOrientation() != 0.0f || pShape->GetOrientation() != 0.0f) pShape->SetOrientation(GetOrientation());
  m_stdShapes.push_back(pShape);
}

void CCompoundShape::Rotate(const Vector2& center, float angle) {
  m_cPose.Rotate(center, angle);
  for (CShape* pShape : m_stdShapes)
    pShape->Rotate(center, angle);
}

void CCompoundShape::Reset() {
  m_cPose.Reset();
  for (CShape* pShape : m_stdShapes)
    pShape->Reset();
}

void CCompoundShape::move() {
  m_cPose.move();
  for (CShape* pShape : m_stdShapes)
    pShape->move();
}

void CCompoundShape::SetVel(const Vector2& v) {
  m_cPose.SetVel(v);
  for (CShape* pShape : m_stdShapes)
    pShape->SetVel(v);
}

void CCompoundShape::SetRotSpeed(float revsPerSecond) {
  m_cPose.SetRotSpeed(revsPerSecond);
  for (CShape* pShape : m_stdShapes)
    pShape->SetRotSpeed(revsPerSecond);
}

void CCompoundShape::SetRotCenter(const Vector2& center) {
  m_cPose.SetRotCenter(center);
  for (CShape* pShape : m_stdShapes)
    pShape->SetRotCenter(center);
}

} // namespace Shapes
