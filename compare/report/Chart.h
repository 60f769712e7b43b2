// SPDX-License-Identifier: MIT
// Time against error as a picture: a large mark for each engine, as SVG. The page shows it, and `--svg`
// writes it into a file.
#pragma once

#include "metrics/Overall.h"

#include <string>
#include <vector>

namespace Shapes::Compare {

/// An engine in the picture.
struct CChartPoint {
  const CEngineRow* m_pRow;
  double m_fNs;       ///< for a ball-step
  CInterval m_cNs;    ///< the bar across
  double m_fError;    ///< radians
  CInterval m_cError; ///< the bar upwards
  std::size_t m_nLost, m_nOf;
  bool m_bFront; ///< on the Pareto line
};

struct CChart {
  std::string m_sTitle; ///< for those who cannot see it
  std::string m_sBars;  ///< what the bars are
  std::vector<CChartPoint> m_stdPoints;
};

/// Engines over all scenes; those without a direction are left out.
CChart MakeOverallChart(const CRunReport& report, const COverall& overall);
/// Engines in one scene.
CChart MakeSceneChart(const CRunReport& report, const CSceneReport& scene);

/// Pixels, at which its letters have 12 and 14.
struct CChartSize {
  double m_fWidth, m_fHeight;
};
inline constexpr CChartSize g_cWideChart{720, 490}, g_cNarrowChart{350, 400};

/// @param isAlone  for a file of its own: with colours for light and dark; else the page has them
std::string DrawChart(const CChart& chart, const CChartSize& size, bool isAlone);

} // namespace Shapes::Compare
