// SPDX-License-Identifier: MIT
// Trajectories for the replay in the report: all engines and the exact reference side by side.
#pragma once

#include "metrics/ImpactTrials.h"

#include <cstddef>
#include <string>
#include <vector>

namespace Shapes::Compare {

/// All balls on each engine and on the reference, step by step from the same start.
struct CClip {
  std::string m_sName;        ///< "start", or "worst <engine>"
  std::size_t m_nContact = 0; ///< the step in which the worst contact happens; 0 for "start"
  std::size_t m_nBall = 0;    ///< whose contact it is
  std::string m_sWhat;        ///< what goes wrong, in words; empty for "start"
  double m_fTime = 0.0;       ///< scene time at the first frame, for shapes that move
  /// [track][frame * balls + ball]; tracks are the engines in their order, then the reference. A frame is
  /// the end of a step; frame 0 is the start.
  std::vector<std::vector<Vector2>> m_stdTracks;
  std::size_t GetFrames(std::size_t balls) const { return m_stdTracks.front().size() / balls; }
};

/// The first `frames` steps of the first trial, and for each engine the surroundings of its worst contact:
/// all tracks start together from the exact state after the ball's last impact before it.
std::vector<CClip> MakeClips(const CScene& scene, const std::vector<CEngine>& engines,
                             const CImpactTrialResult& restarts, std::uint64_t seed, std::size_t frames);

} // namespace Shapes::Compare
