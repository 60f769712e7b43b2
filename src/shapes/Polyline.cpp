// SPDX-License-Identifier: MIT
#include <Shapes/Polyline.h>

#include "../Tolerances.h"

#include "Validate.h"

#include <cmath>

namespace Shapes {
namespace {

// From a to b, with the front to the left of this way.
CLineSegDesc MakeSegment(const Vector2& a, const Vector2& b, const CLineSegDesc& like) {
  CLineSegDesc seg = like;
  seg.SetEndPts(a, b);
  const bool isTurned = seg.GetEndPt0() != a;
  if (isTurned && like.m_eSides != eSides::Both)
    seg.m_eSides = like.m_eSides == eSides::Front ? eSides::Back : eSides::Front;
  return seg;
}

CPointDesc MakeGuard(const Vector2& p, const CLineSegDesc& like) {
  CPointDesc guard;
  static_cast<CShapeDesc&>(guard) = like;
  guard.m_eShapeType = eShape::Point;
  guard.m_vPos = p;
  return guard;
}

// Whether the way goes on so straight at b that a guard would be a bump.
bool IsSmooth(const Vector2& a, const Vector2& b, const Vector2& c) {
  return Normalize(b - a).dot(Normalize(c - b)) > std::cos(g_fSmoothTurn);
}

} // namespace

std::vector<CAnyShapeDesc> MakePolyline(std::span<const Vector2> vertices, bool closed,
                                        const CLineSegDesc& like) {
  std::vector<Vector2> way;
  for (const Vector2& p : vertices) {
    RequireVector("vertices", p, g_fMaxLength);
    if (way.empty() || p != way.back()) way.push_back(p);
  }
  if (closed && way.size() > 1 && way.front() == way.back()) way.pop_back();
  if (way.size() < 2) Refuse("vertices", std::to_string(way.size()), "two different ones at least");

  const std::size_t n = way.size();
  std::vector<CAnyShapeDesc> descs;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i)
    descs.emplace_back(MakeSegment(way[i], way[(i + 1) % n], like));
  if (like.m_bIsSensor) return descs;
  for (std::size_t i = 0; i < n; ++i) {
    const bool isEnd = !closed && (i == 0 || i + 1 == n);
    if (isEnd || !IsSmooth(way[(i + n - 1) % n], way[i], way[(i + 1) % n]))
      descs.emplace_back(MakeGuard(way[i], like));
  }
  return descs;
}

std::vector<CAnyShapeDesc> MakeBox(const Vector2& center, const Vector2& size, float angle,
                                   const CLineSegDesc& like) {
  RequireVector("center", center, g_fMaxLength);
  RequirePositive("size", size.x(), g_fMaxLength);
  RequirePositive("size", size.y(), g_fMaxLength);
  RequireFinite("angle", angle);
  const Vector2 x = 0.5f * size.x() * AngleToVector(angle), y = 0.5f * size.y() * perp(AngleToVector(angle));
  const Vector2 corners[] = {center - x - y, center + x - y, center + x + y, center - x + y};
  return MakePolyline(corners, true, like);
}

} // namespace Shapes
