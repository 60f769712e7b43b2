// SPDX-License-Identifier: MIT
// Long runs: what adds up over many bounces. Single trajectories mean nothing after a few, but what physics
// keeps has to be kept. docs/accuracy.md defines every figure.
#pragma once

#include "scene/Trial.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace Shapes::Compare {

/// Drift of conserved quantities on an engine. Absent where the scene does not conserve them, or after too
/// few bounces.
struct CLongRun {
  std::size_t m_nBounces = 0; ///< responses in the long trial
  double m_fSeconds = 0.0;    ///< simulated in it
  /// Relative change of the total energy over the run, signed: where every elasticity product is 1,
  /// nothing turns, drains or senses. Heights are from the lowest corner of the scene's bounds.
  std::optional<double> m_fEnergyDrift;
  /// Mean way between bounces against that of the exact reference on the same starts, minus 1: one ball,
  /// no gravity, energy kept. Over as many bounces again, shared by several trials.
  std::optional<double> m_fFreePathError;
  /// Relative change of the angular momentum about the common centre over the run, signed: where all
  /// shapes are circles and full arcs about one centre, nothing turns, and there is no gravity.
  std::optional<double> m_fAngularMomentumDrift;
};

/// Conserved quantities of a scene.
struct CKept {
  bool m_bEnergy = false;
  bool m_bFreePath = false;         ///< one ball at a constant speed
  std::optional<Vector2> m_cCentre; ///< Angular momentum about it.
  bool IsAnything() const { return m_bEnergy || m_cCentre; }
};
CKept FindKept(const CScene& scene);

/// Plays trial 0 on each engine until there are `bounces`, or `mostSteps` are over, or a ball has escaped or
/// all have stopped for good (the figures are those until then). Not at all where nothing is kept.
std::vector<CLongRun> MeasureLongRuns(const CScene& scene, const std::vector<CEngine>& engines,
                                      std::uint64_t seed, std::size_t bounces, std::size_t mostSteps);

} // namespace Shapes::Compare
