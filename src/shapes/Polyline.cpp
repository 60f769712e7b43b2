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

// A descriptor with the properties of another one, at its own place and of its own type.
template <class Desc>
Desc Alike(const Desc& desc, const CShapeDesc& like) {
  Desc made = desc;
  static_cast<CShapeDesc&>(made) = like;
  made.m_eShapeType = desc.m_eShapeType;
  made.m_vPos = desc.m_vPos;
  return made;
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
      descs.emplace_back(Alike(CPointDesc(way[i]), like));
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

std::vector<CAnyShapeDesc> MakeCapsule(const Vector2& p0, float r0, const Vector2& p1, float r1,
                                       const CLineSegDesc& like) {
  RequireVector("p0", p0, g_fMaxLength);
  RequireVector("p1", p1, g_fMaxLength);
  RequirePositive("r0", r0, g_fMaxLength);
  RequirePositive("r1", r1, g_fMaxLength);
  const CCircleDesc end0(p0, r0), end1(p1, r1);
  const CCircle circle1(end1);
  CLineSegDesc right, left; // of the way from p0 to p1
  if (!CCircle(end0).Tangents(&circle1, right, left))
    Refuse("p1", ToText(p1), "a point farther from p0 than the radii differ");
  return {Alike(end0, like), Alike(end1, like), Alike(right, like), Alike(left, like)};
}

} // namespace Shapes
