// SPDX-License-Identifier: MIT
// A shape or a ball as it is, moved, mirrored or scaled.
#pragma once

#include "../Testing.h"

#include <type_traits>

namespace Shapes::Properties {

inline Vector2 MirrorY(const Vector2& v) { return {v.x(), -v.y()}; }
inline Vector2 Quarter(const Vector2& v) { return perp(v); }

/// A map of the plane: its points by one function, its directions by another, and lengths by a factor.
struct CMap {
  Vector2 (*m_pTurn)(const Vector2&) = [](const Vector2& v) { return v; };
  Vector2 m_vShift = Vector2::Zero();
  float m_fScale = 1.0f;

  Vector2 Way(const Vector2& v) const { return m_fScale * m_pTurn(v); }
  Vector2 Pt(const Vector2& p) const { return Way(p) + m_vShift; }
};

/// The shape after the map. Arcs can be moved and scaled only: their angles are not exact otherwise.
inline CAnyShapeDesc Moved(const CAnyShapeDesc& desc, const CMap& map) {
  return std::visit(
      [&](auto d) -> CAnyShapeDesc {
        using T = decltype(d);
        if constexpr (std::is_same_v<T, CLineSegDesc>) {
          d.SetEndPts(map.Pt(d.GetEndPt0()), map.Pt(d.GetEndPt1()));
        } else {
          d.m_vPos = map.Pt(d.m_vPos);
          if constexpr (!std::is_same_v<T, CPointDesc>) d.m_fRadius *= map.m_fScale;
        }
        d.m_vVel = map.Way(d.m_vVel);
        d.m_vRotCenter = map.Pt(d.m_vRotCenter);
        return d;
      },
      desc);
}

} // namespace Shapes::Properties
