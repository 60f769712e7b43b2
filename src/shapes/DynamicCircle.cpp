// SPDX-License-Identifier: MIT
#include <Shapes/DynamicCircle.h>

#include <Shapes/Contact.h>

#include "Response.h"
#include "Validate.h"

namespace Shapes {

CDynamicCircleDesc::CDynamicCircleDesc(const Vector2& p, float r, const Vector2& v, float m, float e)
    : CCircleDesc(p, r, e), m_fMass(m) {
  m_vVel = v;
  m_eMotionType = eMotion::Dynamic;
}

CDynamicCircle::CDynamicCircle(const CDynamicCircleDesc& desc)
    : CCircle(desc, eMotion::Dynamic), m_vPrevPos(desc.m_vPos), m_fMass(desc.m_fMass) {
  RequireRange("m_fMass", m_fMass, g_fMinMass, g_fMaxMass);
  if (desc.m_eMotionType != eMotion::Dynamic)
    Refuse("m_eMotionType", "not Dynamic", "Dynamic; a circle that is no ball is made from CCircleDesc");
}

std::unique_ptr<CShape> CDynamicCircle::Clone() const { return std::make_unique<CDynamicCircle>(*this); }

void CDynamicCircle::Translate(const Vector2&) {
  m_vPrevPos = m_vPos;
  CCircle::Update();
}

void CDynamicCircle::move() {
  m_vPrevPos = m_vPos;
  Accelerate(m_vVel, Vector2(0.0f, m_fGravity), m_fTimeStep);
  Move(m_vPos, m_vVel, m_fTimeStep);
  CCircle::Update();
}

void CDynamicCircle::CollisionResponse(const CContactDesc& c) {
  if (c.m_pCircle != this || c.m_pShape == nullptr)
    Refuse("c.m_pCircle", "not this ball",
           "the contact descriptor that CollisionDetected filled in for this ball");
  CShape& shape = *c.m_pShape;
  if (m_bIsSensor || shape.GetSensor()) return;

  const float e = m_fElasticity * shape.GetElasticity();
  if (shape.GetMotionType() == eMotion::Dynamic) {
    auto& other = static_cast<CDynamicCircle&>(shape);
    RespondDynamic(c.m_vNorm, c.m_fSetback, e, other.m_fMass, m_fMass, other.m_vPos, other.m_vVel, m_vPos,
                   m_vVel);
    other.m_bSpeedCapped |= CapSpeed(other.m_vVel);
    other.CCircle::Update();
  } else {
    RespondKinematic(c.m_vNorm, c.m_fSetback, e, shape.GetSurfaceVelocity(c.m_vPOI), m_vPos, m_vVel);
  }
  m_bSpeedCapped |= CapSpeed(m_vVel);
  CCircle::Update();
}

} // namespace Shapes
