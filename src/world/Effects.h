// SPDX-License-Identifier: MIT
// Which effects a world calls for, and why.
#pragma once

#include <Shapes/Effects.h>

#include "WorldState.h"

#include <limits>
#include <string>
#include <vector>

namespace Shapes {

/// Counts of what calls for effects. They are kept up to date as shapes and balls come, change and go.
struct CContent {
  std::size_t m_nBalls = 0;
  std::size_t m_nSolidBalls = 0;
  std::size_t m_nSolidShapes = 0;
  std::size_t m_nMoving = 0;  ///< Shapes that move or rotate by themselves.
  std::size_t m_nSensors = 0; ///< Shapes and balls.

  /// The counts of one shape, and of one ball.
  static CContent Of(const CShapeEntry& entry);
  static CContent Of(const CBallArrays& balls, std::size_t i);
  CContent& operator+=(const CContent& other);
  CContent& operator-=(const CContent& other);
  friend bool operator==(const CContent&, const CContent&) = default;

  bool CanMeet() const { return m_nSolidBalls > 1 || (m_nSolidBalls > 0 && m_nSolidShapes > 0); }
};
CContent CountContent(const CWorldState& state);

/// The effects that are called for by the content, the gravity, and ends that sensors have still to report;
/// all but Continuous, which follows from the speeds.
CEffects GetCalledFor(const CContent& content, const CWorldState& state);

/// Decides before a substep whether anything in it is fast: a solid ball that moves by more than g_fFastMove
/// of its radius, or a solid shape whose surface does so of the smallest one's.
class CFastMoves {
public:
  /// To be called before IsAny when a ball was added, removed, or is solid or not any more; and when that has
  /// happened to a kinematic shape, or its speed or reach has changed.
  /// @param dt  seconds of a substep
  void SetBalls(const CBallArrays& balls, float dt);
  void SetSurfaces(const CWorldState& state, float dt);
  /// @param gravityStep  is still to be added to the velocities
  bool IsAny(const std::vector<Vector2>& velocities, const Vector2& gravityStep) const {
    if (m_fSurface > m_fSmallest) return true;
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      const Vector2 v = velocities[i] + gravityStep;
      if (v.x() * v.x() + v.y() * v.y() > m_stdLimits[i]) return true;
    }
    return false;
  }

private:
  // Square of the speed of each ball. In float, because nothing else is looked at for each ball in each
  // substep; balls so small that it would underflow are fast whenever they move.
  std::vector<float> m_stdLimits;
  double m_fSmallest = std::numeric_limits<double>::infinity(); // longest slow move of a surface, units
  double m_fSurface = 0.0;                                      // longest move of a surface
};

/// The longest path, in user units, of a point of a solid shape in dt seconds.
double FindLongestSurfaceMove(const CWorldState& state, float dt);

/// The longest moves in dt seconds: that of a ball in its radii, that of a surface in those of the smallest
/// ball. Balls and shapes that cannot collide do not count.
struct CLongestMoves {
  double m_fBall = 0.0;
  double m_fSurface = 0.0;
};
CLongestMoves FindLongestMoves(const CWorldState& state, const Vector2& gravityStep, float dt);

/// A line for each effect: its name, whether it runs, and why.
/// @param engineNeeds  run in this engine wherever they are not forbidden
/// @param given        set by the host, the owner of the b2World
std::string Explain(CEffects running, const CEffectChoice& choice, CEffects engineNeeds, CEffects given,
                    const CContent& content, const CWorldState& state, const CLongestMoves& moves);

} // namespace Shapes
