// SPDX-License-Identifier: MIT
#include <Shapes/LineSeg.h>

#include "../geometry/Vector.h"

#include "Validate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Shapes {
namespace {

Vector2 Midpoint(const Vector2& p0, const Vector2& p1) { return p0 + 0.5f * (p1 - p0); }

// Descriptors hold what they are given until a shape is made, and refuses it.
bool IsAllowed(const Vector2& p) {
  return std::islessequal(std::abs(p.x()), g_fMaxLength) && std::islessequal(std::abs(p.y()), g_fMaxLength);
}

// Whether p comes before q in the order of ends: left to right, then bottom to top.
bool Before(const Vector2& p, const Vector2& q) { return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y()); }

Vector2 Tangent(const Vector2& p0, const Vector2& p1) { return Normalize(p1 - p0, Vector2(1.0f, 0.0f)); }

// Before anything that follows from the ends, so that the message is about what was given.
const CLineSegDesc& Checked(const CLineSegDesc& desc) {
  RequireVector("m_vPt0", desc.GetEndPt0(), g_fMaxLength);
  RequireVector("m_vPt1", desc.GetEndPt1(), g_fMaxLength);
  RequireSides(desc.m_eSides);
  return desc;
}

} // namespace

CLineSegDesc::CLineSegDesc(const Vector2& p0, const Vector2& p1, float e) : CShapeDesc(eShape::LineSeg) {
  SetEndPts(p0, p1);
  m_fElasticity = e;
}

void CLineSegDesc::SetEndPts(const Vector2& p0, const Vector2& p1) {
  m_vPt0 = p0;
  m_vPt1 = p1;
  m_vPos = p0;
  if (!IsAllowed(p0) || !IsAllowed(p1)) return;
  if (Before(m_vPt1, m_vPt0)) std::swap(m_vPt0, m_vPt1);
  m_vPos = Midpoint(m_vPt0, m_vPt1);
}

Vector2 CLineSegDesc::GetNormal() const { return perp(Tangent(m_vPt0, m_vPt1)); }

float CLineSegDesc::GetGradient() const { return CLineSeg(*this).GetGradient(); }

CLineSeg::CLineSeg(const CLineSegDesc& desc, eMotion motion)
    : CShape(Checked(desc), eShape::LineSeg, motion),
      m_vPt0(desc.GetEndPt0()),
      m_vPt1(desc.GetEndPt1()),
      m_vNormal(desc.GetNormal()),
      m_eSides(desc.m_eSides),
      m_vStartPt0(m_vPt0),
      m_vStartPt1(m_vPt1) {
  m_vPos = m_vStartPos = Midpoint(m_vPt0, m_vPt1);
  CLineSeg::Update();
  m_vStartNormal = m_vNormal;
}

std::unique_ptr<CShape> CLineSeg::Clone() const { return std::make_unique<CLineSeg>(*this); }

Vector2 CLineSeg::ClosestPt(const Vector2& q) const {
  if (!((q - m_vPt0).dot(m_vDir) > 0.0f)) return m_vPt0;
  if (!((q - m_vPt1).dot(m_vDir) < 0.0f)) return m_vPt1;
  return CLine::ClosestPt(q);
}

void CLineSeg::Translate(const Vector2& d) {
  m_vPt0 += d;
  m_vPt1 += d;
  CLineSeg::Update();
}

Vector2 CLineSeg::TurnFromStart(const Vector2& center, float angle) {
  const Geometry::CTurn turn = Geometry::GetTurn(static_cast<double>(angle));
  m_vPt0 = Geometry::RotatePt(Moved(m_vStartPt0), center, turn);
  m_vPt1 = Geometry::RotatePt(Moved(m_vStartPt1), center, turn);
  if (Before(m_vPt1, m_vPt0)) std::swap(m_vPt0, m_vPt1);
  m_vNormal = Geometry::RotatePt(m_vStartNormal, Vector2::Zero(), turn);
  return Midpoint(m_vPt0, m_vPt1);
}

void CLineSeg::Update() {
  m_vPt = m_vPt0;
  m_vDir = Tangent(m_vPt0, m_vPt1);
  // From the ends as they were rounded: a normal that is not across the segment would see balls that are far
  // from it. The former m_vNormal selects one of the two.
  const Vector2 left = perp(m_vDir);
  m_vNormal = left.dot(m_vNormal) < 0.0f ? Vector2(-left) : left;
  m_cAabb = m_vPt0;
  m_cAabb += m_vPt1;
}

} // namespace Shapes
