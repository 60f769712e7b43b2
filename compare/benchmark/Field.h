// SPDX-License-Identifier: MIT
// The fields in which the engines are timed. The same for the same number of balls on every machine.
#pragma once

#include <Shapes/Shapes.h>

#include <cstddef>
#include <vector>

namespace Shapes::Compare::Benchmark {

inline constexpr float g_fGravity = -10.0f; ///< units per second squared
/// Height of an arc above its chords, units, where an engine has no arcs: 8 chords for those of the peg
/// field.
inline constexpr float g_fSagitta = 0.0054f;

/// Shapes that turn together: up, down by as much, and at rest until the next time.
struct CFlipper {
  std::vector<CAnyShapeDesc> m_stdParts;
  Vector2 m_vPivot;
  float m_fUpSpeed; ///< revolutions per second
};

struct CField {
  std::vector<CAnyShapeDesc>
      m_stdShapes; ///< static ones; all elastic, so that how engines mix does not count
  std::vector<CFlipper> m_stdFlippers;
  std::vector<CDynamicCircleDesc> m_stdBalls;
  Vector2 m_vSize; ///< of the box from the origin on: balls beyond it are lost
  float m_fStep = 1.0f / 60.0f;
  float m_fCell = 0.6f;     ///< of a spatial hash
  bool m_bBullets = true;   ///< As bullets of Box2D balls of a big pile press each other through the floor.
  bool m_bMaySleep = false; ///< Engines may put balls to sleep, if they would by default.
};

/// 2,025 static shapes on a lattice of spacing 1.2 that is jittered by up to .2, inside a box: a half are
/// circles of radius .15, 30% segments of length .6, 20% arcs of radius .3; and balls of radius .1 and
/// elasticity .5 anywhere between them.
CField MakePegField(std::size_t balls);

/// The table of compare/scenes/pinball.json at 120 Hz with its sensors and both flippers, which kick
/// together. The gate is closed from both sides, as Chipmunk has no one-sided segments, and the drain by the
/// floor; all is elastic. So as many balls stay in play, spread over the table at first.
CField MakePinball(std::size_t balls);

/// Balls of radius .2 and elasticity .5 that fall into a closed box as wide as about the square root of their
/// number, and come to rest.
CField MakePile(std::size_t balls);

/// The ends of chords no higher than g_fSagitta, from end 0 to end 1.
std::vector<Vector2> CutArc(const CArcDesc& arc);

} // namespace Shapes::Compare::Benchmark
