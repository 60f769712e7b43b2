// SPDX-License-Identifier: MIT
#include "metrics/HeatMap.h"
#include "MadeScenes.h"

#include "metrics/Statistics.h"

namespace Shapes::Compare {
namespace {

using Tests::Holds;
using Tests::LoadBundled;

void Ignore(double) {}

TEST(HeatMap, HeadOnEachCellHoldsTheFormula) { // tunneled max(0, 1 - r / (v dt))
  const CHeatMap map = MeasureHeatMap(LoadBundled("head_on_wall"), GetEngines(), 3, 400, Ignore);
  EXPECT_NEAR(map.m_fTravel, 2.0, 1e-6);
  ASSERT_EQ(map.m_stdCells.size(), map.m_stdSpeeds.size() * map.m_stdSizes.size());
  std::size_t told = 0;
  for (std::size_t i = 0; i < map.m_stdCells.size(); ++i) {
    const double speed = map.m_stdSpeeds[i % map.m_stdSpeeds.size()];
    const double size = map.m_stdSizes[i / map.m_stdSpeeds.size()];
    SCOPED_TRACE("speed " + std::to_string(speed) + ", size " + std::to_string(size));
    const CHeatCell& cell = map.m_stdCells[i];
    ASSERT_EQ(cell.m_nContacts, 400u);
    const double rate = std::max(0.0, 1.0 - size / (map.m_fTravel * speed));
    EXPECT_TRUE(Holds(cell.m_stdTunneled[Tests::g_nApproximate], 400, rate))
        << cell.m_stdTunneled[Tests::g_nApproximate] << " not " << 400 * rate;
    // The control: with the size of another row the formula does not hold.
    if (rate > 0.2 && rate < 0.8)
      told += !Holds(cell.m_stdTunneled[Tests::g_nApproximate], 400, std::max(0.0, 2 * rate - 1));
  }
  EXPECT_GT(told, 3u);
}

TEST(HeatMap, OnlyScenesWithOneBallThatMovesHaveOne) {
  EXPECT_TRUE(MeasureHeatMap(LoadBundled("ball_on_ball"), GetEngines(), 3, 10, Ignore).m_stdCells.empty());
  EXPECT_TRUE(MeasureHeatMap(LoadBundled("elastic_drop"), GetEngines(), 3, 10, Ignore).m_stdCells.empty());
}

} // namespace
} // namespace Shapes::Compare
