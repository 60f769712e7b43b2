// SPDX-License-Identifier: MIT
// Documents as a run would give them to the page, made up.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace Shapes::Compare {

struct CPageDocuments {
  nlohmann::json m_cRun, m_cReplay, m_cCharts;
};

/// One full scene of two engines for each name: work precision, heat map, bins, clips.
CPageDocuments MakePageDocuments(const std::vector<std::string>& scenes);

/// What a run may leave out, scene by scene: no contacts, one engine, nulls for all that may be null, no
/// clips.
CPageDocuments MakeSparsePageDocuments();

/// The frame of the worst contact of the clips of full scenes, and the ball whose it is.
inline constexpr int g_nWorstContact = 14, g_nWorstBall = 1;

} // namespace Shapes::Compare
