// SPDX-License-Identifier: MIT
#include "metrics/HeatMap.h"

#include "metrics/Statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace Shapes::Compare {
namespace {

CScene Load(const std::string& name) {
  return LoadScene(std::string(SHAPES_SCENES_DIR) + "/" + name + ".json");
}
void Ignore(double) {}

// 3.3 standard errors: one in a thousand.
bool Holds(std::size_t hits, std::size_t n, double rate) {
  const CInterval i = Wilson(hits, n, 3.3);
  return i.m_fLow <= rate && rate <= i.m_fHigh;
}

TEST(HeatMap, HeadOnEachCellHoldsTheFormula) { // tunneled max(0, 1 - r / (v dt))
  const CHeatMap map = MeasureHeatMap(Load("head_on_wall"), GetEngines(), 3, 400, Ignore);
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
    EXPECT_TRUE(Holds(cell.m_stdTunneled[0], 400, rate)) << cell.m_stdTunneled[0] << " not " << 400 * rate;
    // The control: with the size of another row the formula does not hold.
    if (rate > 0.2 && rate < 0.8) told += !Holds(cell.m_stdTunneled[0], 400, std::max(0.0, 2 * rate - 1));
  }
  EXPECT_GT(told, 3u);
}

TEST(HeatMap, OnlyScenesWithOneBallThatMovesHaveOne) {
  EXPECT_TRUE(MeasureHeatMap(Load("ball_on_ball"), GetEngines(), 3, 10, Ignore).m_stdCells.empty());
  EXPECT_TRUE(MeasureHeatMap(Load("elastic_drop"), GetEngines(), 3, 10, Ignore).m_stdCells.empty());
}

} // namespace
} // namespace Shapes::Compare
