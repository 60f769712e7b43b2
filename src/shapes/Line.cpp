// SPDX-License-Identifier: MIT
#include <Shapes/Line.h>

#include <cmath>
#include <limits>

namespace Shapes {
namespace {

constexpr float g_fInf = std::numeric_limits<float>::infinity();

} // namespace

CLine::CLine(const Vector2& p, float m)
    : m_vPt(p), m_vDir(std::isinf(m) ? Vector2(0.0f, 1.0f) : Normalize(Vector2(1.0f, m))) {}

Vector2 CLine::Intersect(const CLine& line) const {
  const float sine = Cross(m_vDir, line.m_vDir);
  if (sine == 0.0f) return {g_fInf, g_fInf};
  return m_vPt + (Cross(line.m_vPt - m_vPt, line.m_vDir) / sine) * m_vDir;
}

Vector2 CLine::ClosestPt(const Vector2& q) const { return m_vPt + (q - m_vPt).dot(m_vDir) * m_vDir; }

float CLine::GetGradient() const { return m_vDir.x() == 0.0f ? g_fInf : m_vDir.y() / m_vDir.x(); }

float CLine::GetInverseGradient() const { return m_vDir.y() == 0.0f ? g_fInf : m_vDir.x() / m_vDir.y(); }

float CLine::GetYIntercept() const {
  return m_vDir.x() == 0.0f ? g_fInf : m_vPt.y() - m_vPt.x() * GetGradient();
}

float CLine::GetXIntercept() const {
  return m_vDir.y() == 0.0f ? g_fInf : m_vPt.x() - m_vPt.y() * GetInverseGradient();
}

} // namespace Shapes
