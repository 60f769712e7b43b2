// SPDX-License-Identifier: MIT
#include <Shapes/Point.h>

namespace Shapes {

CPointDesc::CPointDesc(const Vector2& p, float e) : CPointDesc() {
  m_vPos = p;
  m_fElasticity = e;
}

CPoint::CPoint(const CPointDesc& desc, eMotion motion) : CShape(desc, eShape::Point, motion) {
  CPoint::Update();
}

std::unique_ptr<CShape> CPoint::Clone() const { return std::make_unique<CPoint>(*this); }

void CPoint::Update() { m_cAabb = m_vPos; }

} // namespace Shapes
