// SPDX-License-Identifier: MIT
// Which effects a world calls for, and why.
#pragma once

#include <Shapes/Effects.h>

#include "WorldState.h"

#include <string>
#include <vector>

namespace Shapes {

/// What of a world calls for effects and changes only when it is told to.
struct CContent {
  std::size_t m_nBalls = 0;
  std::size_t m_nSolidBalls = 0;
  std::size_t m_nSolidShapes = 0;
  std::size_t m_nRotating = 0;
  std::size_t m_nSensors = 0; ///< Shapes and balls.
  bool CanMeet() const { return m_nSolidBalls > 1 || (m_nSolidBalls > 0 && m_nSolidShapes > 0); }
};
CContent CountContent(const CWorldState& state);

/// What is called for by it, the gravity, and what sensors have still to tell; all but Continuous, which
/// follows from the speeds.
CEffects GetCalledFor(const CContent& content, const CWorldState& state);

/// Decides before a substep whether anything in it is fast: a solid ball that moves by more than g_fFastMove
/// of its radius, or a rotating solid shape that does so of the smallest one's.
class CFastMoves {
public:
  /// To be called when anything but velocities has changed.
  /// @param dt  seconds of a substep
  void Set(const CWorldState& state, float dt);
  /// @param kick  what is still to be added to the velocities
  bool IsAny(const std::vector<Vector2>& velocities, const Vector2& kick) const {
    return IsAny(velocities, [&](const Vector2& v) { return Vector2(v + kick); });
  }
  bool IsAny(const std::vector<Vector2>& velocities) const {
    return IsAny(velocities, [](const Vector2& v) -> const Vector2& { return v; });
  }

private:
  template <class F>
  bool IsAny(const std::vector<Vector2>& velocities, const F& kicked) const {
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      const Vector2& v = kicked(velocities[i]);
      if (v.x() * v.x() + v.y() * v.y() > m_stdLimits[i]) return true;
    }
    return m_bIsSurfaceFast;
  }

  // Square of the speed of each ball. In float, because nothing else is looked at for each ball in each
  // substep; balls so small that it would underflow are fast whenever they move.
  std::vector<float> m_stdLimits;
  bool m_bIsSurfaceFast = false;
};

/// The longest way, in user units, of a point of a rotating solid shape in dt seconds.
double FindLongestSurfaceMove(const CWorldState& state, float dt);

/// The longest moves in dt seconds: that of a ball in its radii, that of a surface in those of the smallest
/// ball. What cannot meet anything does not count.
struct CLongestMoves {
  double m_fBall = 0.0;
  double m_fSurface = 0.0;
};
CLongestMoves FindLongestMoves(const CWorldState& state, const Vector2& kick, float dt);

/// How far the farthest point of a shape is from the centre about which it turns. Error a few roundings.
double GetReach(const CShape& shape);

/// A line for each effect: its name, whether it runs, and why.
/// @param engineNeeds  run in this engine wherever they are not forbidden
/// @param given        are for somebody else to say
std::string Explain(CEffects running, const CEffectChoice& choice, CEffects engineNeeds, CEffects given,
                    const CContent& content, const CWorldState& state, const CLongestMoves& moves);

} // namespace Shapes
