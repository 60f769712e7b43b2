// SPDX-License-Identifier: MIT
// A scene made ready to run: where its balls start in one of many random trials, and what a game does in it.
#pragma once

#include "Engines.h"

#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <vector>

namespace Shapes::Compare {

/// All effects that a scene can call for, in their order.
inline constexpr eEffect g_stdEffects[] = {eEffect::Gravity, eEffect::Kinematics, eEffect::BallPairs,
                                           eEffect::Sensors, eEffect::Events,     eEffect::Continuous};
static_assert(std::size(g_stdEffects) + 1 == static_cast<std::size_t>(eEffect::Size)); // without Touches

/// Where a trial begins.
struct CStart {
  std::vector<CDynamicCircleDesc> m_stdBalls;
  double m_fTime = 0.0; ///< Seconds that shapes have moved and turned.
};

/// Start number `trial` of a scene: each ball varied by its spread, all balls moved along their velocities by
/// the same random part of a step, so that impacts fall anywhere within a step, and turning shapes at a
/// random angle; but where a shape moves by its velocity all shapes begin as they are described. The same
/// arguments give the same start on every machine.
CStart MakeStart(const CScene& scene, std::uint64_t seed, std::uint64_t trial);

/// Steps that this many seconds above 0 take, at least one; and those of a trial.
std::size_t CountSteps(const CScene& scene, float seconds);
std::size_t GetStepsPerTrial(const CScene& scene);

/// Revolutions per second of a shape in the step that begins at `time`, and its orientation then: its own
/// speed, or that which brings a flipper to where it belongs at the end of the step.
float RotSpeedAt(const CSceneShape& shape, double time, double dt);
float OrientationAt(const CSceneShape& shape, double time);
/// How far it has moved by its velocity or its shuttle, and its velocity in the step that begins then.
Eigen::Vector2d OffsetAt(const CSceneShape& shape, double time);
Vector2 VelAt(const CSceneShape& shape, double time, double dt);

/// A world with the shapes and these balls. Ids are consecutive: shapes in their order, then balls in theirs.
struct CTrialWorld {
  std::unique_ptr<CWorld> m_pWorld;
  std::vector<CShapeId> m_stdShapes;
  std::vector<CShapeId> m_stdBalls;

  CTrialWorld(const CScene& scene, const CEngine& engine, std::span<const CDynamicCircleDesc> balls,
              double time);

  /// Gives what flips or shuttles the speed that it has in the step that begins at `time`.
  void Flip(const CScene& scene, double time);
};

/// A scene that is played on: flippers flip, drained balls start again, and balls that left the bounds or
/// became NaN are counted and start again.
class CGame {
public:
  CGame(const CScene& scene, const CEngine& engine, const CStart& start);
  /// The same in the middle of it: the balls are at `balls` now, `time` is the scene time. Drained balls go
  /// back to where they are in `start`.
  CGame(const CScene& scene, const CEngine& engine, const CStart& start,
        std::span<const CDynamicCircleDesc> balls, double time);

  void Step();
  /// Whether balls that left the bounds start again (they do by default) or fly on.
  void SetPutBack(bool b) { m_bPutBack = b; }

  const CWorld& GetWorld() const { return *m_cWorld.m_pWorld; }
  std::size_t GetEscaped() const { return m_nEscaped; }
  std::size_t GetNotFinite() const { return m_nNotFinite; }
  std::size_t GetDrained() const { return m_nDrained; }

private:
  void StartAgain(std::size_t ball);

  const CScene& m_cScene;
  CStart m_cStart;
  CTrialWorld m_cWorld;
  double m_fTime;
  bool m_bHasDrain = false;
  bool m_bPutBack = true;
  std::size_t m_nEscaped = 0, m_nNotFinite = 0, m_nDrained = 0;
};

} // namespace Shapes::Compare
