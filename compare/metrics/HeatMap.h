// SPDX-License-Identifier: MIT
// How often each engine tunnels, by how fast the ball is and how large.
#pragma once

#include "scene/Trial.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace Shapes::Compare {

struct CHeatCell {
  std::size_t m_nContacts = 0;
  std::vector<std::size_t> m_stdTunneled; ///< of each engine
};

/// Rows are sizes, columns speeds, both as factors on what the scene says.
struct CHeatMap {
  std::vector<double> m_stdSpeeds, m_stdSizes;
  double m_fTravel = 0.0;            ///< way of the ball per step in radii, at factors of 1
  std::vector<CHeatCell> m_stdCells; ///< row by row; without contacts where the ball does not fit or meets
                                     ///< nothing
};

/// `contacts` impacts in each cell. The map is empty unless the scene has one ball, which moves at the start.
/// @param progress as in CImpactTrialOptions
CHeatMap MeasureHeatMap(const CScene& scene, const std::vector<CEngine>& engines, std::uint64_t seed,
                        std::size_t contacts, const std::function<void(double)>& progress);

} // namespace Shapes::Compare
