// SPDX-License-Identifier: MIT
// The questions of the public world: checks what is asked; Questions.h answers it.
#include <Shapes/World.h>

#include "../shapes/Validate.h"
#include "WorldCore.h"

#include <limits>

namespace Shapes {
namespace {

void RequireWay(const Vector2& from, const Vector2& to, float radius) {
  RequireVector("from", from, g_fMaxLength);
  RequireVector("to", to, g_fMaxLength);
  RequireRange("radius", radius, 0.0f, g_fMaxLength);
}

} // namespace

std::optional<CCastHit> CWorld::Cast(const Vector2& from, const Vector2& to, float radius,
                                     const CFilter& filter) const {
  RequireWay(from, to, radius);
  return m_pImpl->Ask().Cast(from, to, radius, filter);
}

std::vector<CCastHit> CWorld::CastAll(const Vector2& from, const Vector2& to, float radius,
                                      const CFilter& filter) const {
  RequireWay(from, to, radius);
  return m_pImpl->Ask().CastAll(from, to, radius, filter);
}

std::optional<CClosestHit> CWorld::FindClosest(const Vector2& p, float reach, const CFilter& filter) const {
  RequireVector("p", p, g_fMaxLength);
  RequireRange("reach", reach, 0.0f, std::numeric_limits<float>::infinity());
  return m_pImpl->Ask().FindClosest(p, reach, filter);
}

std::vector<CShapeId> CWorld::FindInCircle(const Vector2& center, float radius, const CFilter& filter) const {
  RequireVector("center", center, g_fMaxLength);
  RequireRange("radius", radius, 0.0f, g_fMaxLength);
  return m_pImpl->Ask().FindInCircle(center, radius, filter);
}

std::vector<CShapeId> CWorld::FindInBox(const CAabb2D& box, const CFilter& filter) const {
  RequireVector("box", box.GetTopLeft(), g_fMaxLength);
  RequireVector("box", box.GetBottomRt(), g_fMaxLength);
  return m_pImpl->Ask().FindInBox(box, filter);
}

} // namespace Shapes
