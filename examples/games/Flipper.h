// SPDX-License-Identifier: MIT
// A flipper: a capsule that turns between two stops.
#pragma once

#include "Mode.h"

#include <vector>

namespace Shapes::Games {

class CFlipper {
public:
  /// Adds the flipper at its lower stop.
  /// @param pivot  the rotation centre
  /// @param angle  from the pivot to the tip at the lower stop, radians
  /// @param swing  from there to the upper stop, radians; negative is clockwise
  CFlipper(CWorld& world, const Vector2& pivot, float angle, float swing);

  /// Turns towards a stop, where it rests.
  void Move(CWorld& world, bool up);
  const std::vector<CShapeId>& GetIds() const { return m_stdIds; }

private:
  std::vector<CShapeId> m_stdIds;
  float m_fUpwards; ///< 1 if up is counterclockwise, else -1.
};

} // namespace Shapes::Games
