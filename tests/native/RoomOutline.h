// SPDX-License-Identifier: MIT
// Closed rooms, a polygon or a ring, of which balls get out or not.
#pragma once

#include "NativeTesting.h"

namespace Shapes {

struct CRoomOutline {
  std::vector<Vector2> m_stdCorners; ///< Counterclockwise; none of a ring.
  Vector2 m_vMiddle{0, 0};
  float m_fSize = 1; ///< Radius of the ring, distance of the corners.

  /// Gives `add` the description of each wall, and its sides where it is solid towards the room alone.
  template <class F>
  void ForEachWall(float e, const F& add) const {
    if (m_stdCorners.empty()) return add(CArcDesc(m_vMiddle, m_fSize, 0, 0, e), eSides::Back);
    for (std::size_t i = 0; i < m_stdCorners.size(); ++i) {
      const Vector2 &a = m_stdCorners[i], &b = m_stdCorners[(i + 1) % m_stdCorners.size()];
      // The front is where the normal points to, which is never down; the room is to the left of a wall.
      const bool isFrontInside = b.x() > a.x() || (b.x() == a.x() && b.y() > a.y());
      add(CLineSegDesc(a, b, e), isFrontInside ? eSides::Front : eSides::Back);
    }
  }

  /// Distance of a point from the nearest wall, negative outside.
  double GetDepthInside(const Vector2& p) const {
    if (m_stdCorners.empty()) return Wide(m_fSize - (p - m_vMiddle).norm());
    double depth = Wide(m_fSize);
    for (std::size_t i = 0; i < m_stdCorners.size(); ++i) {
      const Vector2d a = Wide(m_stdCorners[i]), d = Wide(p) - a;
      const Vector2d way = Wide(m_stdCorners[(i + 1) % m_stdCorners.size()]) - a;
      depth = std::min((way.x() * d.y() - way.y() * d.x()) / way.norm(), depth); // what is no number stays
    }
    return depth;
  }
};

} // namespace Shapes
