// SPDX-License-Identifier: MIT
#include <Shapes/Aabb2D.h>

#include <algorithm>
#include <limits>

namespace Shapes {
namespace {

// The edges of an empty box, turned inside out: after adding a point it contains that alone.
constexpr float g_fEmptyEdge = std::numeric_limits<float>::infinity();

} // namespace

CAabb2D::CAabb2D() : m_vTopLeft(g_fEmptyEdge, -g_fEmptyEdge), m_vBottomRt(-g_fEmptyEdge, g_fEmptyEdge) {}

void CAabb2D::Translate(const Vector2& v) {
  m_vTopLeft += v;
  m_vBottomRt += v;
}

float CAabb2D::GetWidth() const { return std::max(0.0f, m_vBottomRt.x() - m_vTopLeft.x()); }
float CAabb2D::GetHt() const { return std::max(0.0f, m_vTopLeft.y() - m_vBottomRt.y()); }

} // namespace Shapes
