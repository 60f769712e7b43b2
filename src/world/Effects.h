// SPDX-License-Identifier: MIT
// Which effects a world calls for, and why.
#pragma once

#include <Shapes/Effects.h>

#include "WorldState.h"

#include <string>

namespace Shapes {

/// Counts of what calls for effects. They are kept up to date as shapes and balls come, change and go.
struct CContent {
  std::size_t m_nBalls = 0;
  std::size_t m_nSolidBalls = 0;
  std::size_t m_nSolidShapes = 0;
  std::size_t m_nMoving = 0;  ///< Shapes that move or rotate by themselves.
  std::size_t m_nSensors = 0; ///< Shapes and balls.
  std::size_t m_nWithStops = 0;

  /// The counts of one shape, and of one ball.
  static CContent Of(const CShapeEntry& entry);
  static CContent Of(const CBallArrays& balls, std::size_t i);
  /// Something that counted as `before` counts as `after` now.
  void Replace(const CContent& before, const CContent& after);
  friend bool operator==(const CContent&, const CContent&) = default;

  bool CanMeet() const { return m_nSolidBalls > 1 || (m_nSolidBalls > 0 && m_nSolidShapes > 0); }
};
CContent CountContent(const CWorldState& state);

/// The effects that are called for by the content, the gravity, and ends that sensors have still to report.
CEffects GetCalledFor(const CContent& content, const CWorldState& state);

/// A line for each effect: its name, whether it runs, and why.
/// @param engineNeeds  run in this engine wherever they are not forbidden
/// @param byHost       set by the host, the owner of the b2World
std::string Explain(CEffects running, const CEffectChoice& choice, CEffects engineNeeds, CEffects byHost,
                    const CContent& content, const CWorldState& state);

} // namespace Shapes
