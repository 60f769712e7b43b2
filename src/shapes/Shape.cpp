// SPDX-License-Identifier: MIT
#include <Shapes/Shape.h>

#include "../geometry/Turn.h"
#include "../geometry/Vector.h"

#include "Validate.h"

namespace Shapes {

float CShapeCommon::m_fGravity = 0.0f;
float CShapeCommon::m_fTimeStep = 1.0f / 60.0f;

CShape::CShape(const CShapeDesc& desc, eShape type, eMotion motion)
    : m_eShapeType(type),
      m_eMotionType(motion),
      m_bIsSensor(desc.m_bIsSensor),
      m_cFilter(desc.m_cFilter),
      m_fElasticity(desc.m_fElasticity),
      m_fRotSpeed(desc.m_fRotSpeed),
      m_vVel(motion == eMotion::Static ? Vector2(Vector2::Zero()) : desc.m_vVel),
      m_vPos(desc.m_vPos),
      m_vStartPos(desc.m_vPos),
      m_vRotCenter(desc.m_vRotCenter),
      m_vStartRotCenter(desc.m_vRotCenter.cast<double>()) {
  RequireVector("m_vPos", m_vPos, g_fMaxLength);
  RequireRange("m_fElasticity", m_fElasticity, 0.0f, g_fMaxElasticity);
  RequireRange("m_fRotSpeed", m_fRotSpeed, -g_fMaxRotSpeed, g_fMaxRotSpeed);
  RequireVector("m_vRotCenter", m_vRotCenter, g_fMaxLength);
  RequireVector("m_vVel", desc.m_vVel, g_fMaxSpeed);
}

void CShape::SetPos(const Vector2& p) {
  RequireVector("m_vPos", p, g_fMaxLength);
  const Vector2 d = p - m_vPos;
  m_vPos = p;
  ForgetMove();
  Translate(d);
}

void CShape::Relocate(const Vector2& p) {
  if (m_eMotionType == eMotion::Dynamic) return SetPos(p);
  RequireVector("m_vPos", p, g_fMaxLength);
  // From the pose at construction, and not by adding the way to each point: far away points are rounded, and
  // would come back as others.
  const Vector2d start = m_vStartPos.cast<double>(), arm = start - m_vStartRotCenter;
  const Vector2d moved =
      p.cast<double>() - start - (Geometry::Turned(arm, static_cast<double>(m_fOrientation)) - arm);
  const Vector2 center = (m_vStartRotCenter + moved).cast<float>();
  if (m_eMotionType == eMotion::Kinematic) { // others do not turn
    RequireVector("m_vRotCenter", center, g_fMaxLength);
    m_vRotCenter = center;
  }
  m_vMoved = moved;
  ForgetMove();
  TurnFromStart(center, m_fOrientation);
  m_vPos = p;
  Update();
}

Vector2 CShape::TurnFromStart(const Vector2& center, float angle) {
  return RotatePt(Moved(m_vStartPos), center, angle);
}

void CShape::SetElasticity(float e) {
  RequireRange("m_fElasticity", e, 0.0f, g_fMaxElasticity);
  m_fElasticity = e;
}

void CShape::SetVel(const Vector2& v) {
  RequireVector("m_vVel", v, g_fMaxSpeed);
  if (m_eMotionType == eMotion::Static && v != Vector2::Zero())
    Refuse("m_vVel", ToText(v), "(0, 0): a static shape does not move");
  m_vVel = v;
}

void CShape::SetRotSpeed(float revsPerSecond) {
  RequireRange("m_fRotSpeed", revsPerSecond, -g_fMaxRotSpeed, g_fMaxRotSpeed);
  if (m_eMotionType == eMotion::Static && revsPerSecond != 0.0f)
    Refuse("m_fRotSpeed", ToText(revsPerSecond), "0: a static shape does not turn");
  m_fRotSpeed = revsPerSecond;
}

void CShape::SetRotCenter(const Vector2& center) {
  RequireVector("m_vRotCenter", center, g_fMaxLength);
  m_vRotCenter = center;
  m_vStartRotCenter = center.cast<double>() - m_vMoved;
}

void CShape::Rotate(const Vector2& center, float angle) {
  if (m_eMotionType != eMotion::Kinematic) return;
  RequireVector("center", center, g_fMaxLength);
  RequireFinite("angle", angle);
  m_fAngle = m_fOrientation = NormalizeAngle(angle);
  ForgetMove();
  m_vPos = TurnFromStart(center, m_fOrientation);
  Update();
}

void CShape::SetPose(const Vector2& center, float angle) {
  if (m_eMotionType != eMotion::Kinematic) return;
  RequireVector("center", center, g_fMaxLength);
  m_vMoved = center.cast<double>() - m_vStartRotCenter;
  m_vRotCenter = center;
  Rotate(center, angle);
}

void CShape::Reset() {
  if (m_eMotionType != eMotion::Kinematic) return;
  m_fAngle = m_fOrientation = 0.0f;
  ForgetMove();
  m_vMoved.setZero();
  m_vRotCenter = m_vStartRotCenter.cast<float>();
  m_vPos = TurnFromStart(m_vRotCenter, 0.0f);
  Update();
}

bool CShape::GetMoving() const {
  return GetRotating() || (m_eMotionType == eMotion::Kinematic && m_vVel != Vector2::Zero());
}

void CShape::Advance(float dt, float maxLength) {
  if (!GetMoving()) return ForgetMove();
  const Vector2d way = m_vVel.cast<double>() * static_cast<double>(dt);
  const Vector2d far =
      m_cAabb.GetTopLeft().cwiseAbs().cwiseMax(m_cAabb.GetBottomRt().cwiseAbs()).cast<double>();
  const Vector2d center = m_vStartRotCenter + m_vMoved + way;
  const bool stays =
      (far + way.cwiseAbs()).cwiseMax(center.cwiseAbs()).maxCoeff() > static_cast<double>(maxLength);
  if (!stays) {
    m_vMoved += way;
    m_vRotCenter = center.cast<float>();
  }
  const double angle = Geometry::TurnOn(m_fAngle, m_fRotSpeed, dt);
  Rotate(m_vRotCenter, static_cast<float>(angle));
  m_fAngle = angle; // that Rotate has rounded
  m_fLastTurn = g_fTwoPi * m_fRotSpeed * dt;
  if (!stays) m_vLastMove = way.cast<float>();
}

Vector2 CShape::GetSurfaceVelocity(const Vector2& p) const {
  if (!GetMoving()) return Vector2::Zero();
  return m_vVel + g_fTwoPi * m_fRotSpeed * perp(p - m_vRotCenter);
}

} // namespace Shapes
