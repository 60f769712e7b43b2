// SPDX-License-Identifier: MIT
#include "Mixing.h"

#include <algorithm>

namespace Shapes::Box2D {
namespace {

// Of the elasticities of all that is solid.
struct CRange {
  float m_fLeast = g_fMaxElasticity;
  float m_fMost = 0.0f;
  void Add(float e) {
    m_fLeast = std::min(m_fLeast, e);
    m_fMost = std::max(m_fMost, e);
  }
  // Also of nothing at all.
  bool IsOne() const { return m_fLeast >= m_fMost; }
};

} // namespace

std::optional<CMixing> FindMixing(const CWorldState& state, bool pairs) {
  CRange balls, shapes;
  const CBallArrays& b = state.m_cBalls;
  for (std::size_t i = 0; i < b.Size(); ++i)
    if (b.IsSolid(i)) balls.Add(b.m_stdElasticity[i]);
  for (const CShapeEntry& entry : state.m_stdShapes)
    if (IsSolid(*entry.m_pShape)) shapes.Add(entry.m_pShape->GetElasticity());

  if (!balls.IsOne() && (pairs || !shapes.IsOne())) return {};
  if (pairs && balls.m_fMost > shapes.m_fLeast) return {};
  if (balls.m_fMost * std::max(shapes.m_fMost, pairs ? balls.m_fMost : 0.0f) > 1.0f) return {};
  // Each as large as the least of what it meets allows: then one of two is as large as it has to be.
  return CMixing{pairs ? balls.m_fMost : shapes.m_fLeast, balls.m_fLeast};
}

} // namespace Shapes::Box2D
