// SPDX-License-Identifier: MIT
// Contact that lasts: scenes whose balls pile up, slide and come to rest are played on, and what an engine
// makes of them is held to what has to come out. Trajectories mean nothing there. docs/accuracy.md defines
// every figure.
#pragma once

#include "Statistics.h"
#include "scene/Trial.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace Shapes::Compare {

/// The end of a trial, over which overlaps and speeds are looked at, as a share of its steps.
inline constexpr double g_fLastingEnd = 0.1;
/// A ball below this speed is at rest, in speeds that gravity gives in a step.
inline constexpr double g_fAtRest = 2.0;

/// The figures of an engine over the trials of a scene, absent where the scene does not have them.
struct CLasting {
  std::size_t m_nBalls = 0; ///< of all trials together; 0 if the scene does not ask for it
  std::size_t m_nLost = 0;  ///< of them: outside of the bounds at the end, or not finite
  // The figures of lost balls are left out.
  std::optional<double>
      m_fOverlap;                 ///< Deepest of the end of a trial, radii of the smaller ball; worst trial.
  std::optional<double> m_fSpeed; ///< Fastest ball of the end, units per second; worst trial.
  /// Sum of the rises of the total energy from step to step, relative to the total energy at the start, whose
  /// heights are from the lowest corner of the bounds; worst trial. Where no shape moves, none adds energy
  /// (elasticity above 1), and gravity pulls.
  std::optional<double> m_fEnergyGained;
  /// Seconds after which no ball was faster than g_fAtRest until the end: median of the trials. Absent if a
  /// trial did not come to rest.
  std::optional<double> m_fRestTime;
  /// Balls per second that touched a sensor, each ball once, until the last one did; median of the trials.
  std::optional<double> m_fFlow;
  CMedian m_cNsPerBallStep; ///< over the trials, from their beginning to their end
};

/// Plays each trial for the time that the scene asks for, on every engine in turn. All are empty if it does
/// not ask.
/// @param progress called with the share that is done; what it throws ends the measurement
std::vector<CLasting> MeasureLasting(const CScene& scene, const std::vector<CEngine>& engines,
                                     std::uint64_t seed, int trials,
                                     const std::function<void(double)>& progress = {});

} // namespace Shapes::Compare
