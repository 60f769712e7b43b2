// SPDX-License-Identifier: MIT
// The energy of piles.
#pragma once

#include <vector>

#include "Groups.h"
#include "Moving.h"

namespace Shapes::Native {

/// A pile and all balls that it meets within a substep have no more energy at the end of it than at the
/// beginning: they get slower by what they have gained. Solved at the beginning for the way straight on, a
/// pile that follows a curve through a good part of a radian would gain a few percent.
///
/// A group that anything drives (CMoving::m_bIsDriven) may gain energy.
class CPileEnergy {
public:
  /// Begins a substep.
  void Begin() {
    m_stdBegin.clear();
    m_cGroups.Reset(0);
  }
  bool IsEmpty() const { return m_stdBegin.empty(); }
  /// The next ball, with the place and the velocity that it has at the beginning.
  void Add(const CMoving& ball);
  /// Two balls have met: their energies count together. Without effect if there are no balls.
  void Join(std::uint32_t ball, std::uint32_t other) {
    if (!IsEmpty()) m_cGroups.Join(ball, other);
  }
  /// At the end of the substep. All balls of `balls` were added.
  void Keep(std::vector<CMoving>& balls, const Vector2d& gravity);

private:
  struct CBegin {
    Vector2d m_vPos;
    double m_fKinetic;
  };
  struct CGroup {
    double m_fKinetic = 0.0;
    double m_fMost = 0.0; // that it may have
    bool m_bHasPile = false, m_bIsDriven = false;
  };

  std::vector<CBegin> m_stdBegin;
  CGroups m_cGroups;
  std::vector<CGroup> m_stdGroups; // by the lowest of each
};

} // namespace Shapes::Native
