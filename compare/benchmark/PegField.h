// SPDX-License-Identifier: MIT
// Balls that fall through pegs: the scene in which the engines are timed.
#pragma once

#include <Shapes/Shapes.h>

#include <cstddef>
#include <vector>

namespace Shapes::Compare::Benchmark {

inline constexpr float g_fGravity = -10.0f; ///< units per second squared
inline constexpr float g_fStep = 1.0f / 60.0f;
inline constexpr float g_fBallElasticity = 0.5f;

struct CPegField {
  std::vector<CAnyShapeDesc> m_stdShapes;
  std::vector<CDynamicCircleDesc> m_stdBalls;
};

/// 2,025 static shapes on a lattice of spacing 1.2 that is jittered by up to .2, inside a box: a half are
/// circles of radius .15, 30% segments of length .6, 20% arcs of radius .3; and balls of radius .1 and
/// elasticity .5 anywhere between them. The same for the same number on every machine.
CPegField MakePegField(std::size_t balls);

} // namespace Shapes::Compare::Benchmark
