// SPDX-License-Identifier: MIT
// The chart as SVG. What it looks like in a browser is tested in ReportPageTest.cpp.
#include "report/Chart.h"

#include "SampleReport.h"

#include <regex>

namespace Shapes::Compare {
namespace {

std::size_t CountMatches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator()));
}

CChart Sample(std::size_t lost) {
  CChart chart{"a < b & c", "bars", {}};
  double ns = 50.0;
  for (const CEngineRow& row : GetEngineRows())
    chart.m_stdPoints.push_back(
        {&row, ns *= 2.0, {0.8 * ns, 1.3 * ns}, 0.01, {0.001, 0.1}, lost, 1000, true});
  return chart;
}

TEST(ChartTest, EveryEngineHasAMarkAndALabel) {
  const CChart chart = MakeOverallChart(MakeSampleReport(), MakeOverall(MakeSampleReport()));
  EXPECT_EQ(chart.m_stdPoints.size(), 3u); // Box2D has no direction in the sample
  for (const CChartSize& size : {g_cWideChart, g_cNarrowChart}) {
    const std::string svg = DrawChart(Sample(0), size, false);
    for (const CEngineRow& row : GetEngineRows()) {
      EXPECT_EQ(CountMatches(svg, std::string("data-engine=\"") + row.m_sName + "\""), 1u);
      EXPECT_EQ(CountMatches(svg, std::string("data-of=\"") + row.m_sName + "\""), 1u);
    }
  }
}

// Full where at most 1 in 1,000 is lost, with a dot up to 1 in 100, then hollow; the legend has one of each.
TEST(ChartTest, TheFillSaysWhatIsLost) {
  const auto full = [](std::size_t lost) {
    return CountMatches(DrawChart(Sample(lost), g_cWideChart, false),
                        "fill=\"var\\(--(native|box2d)[a-z-]*\\)\" stroke=[^>]*data-engine");
  };
  const auto dots = [](std::size_t lost) {
    return CountMatches(DrawChart(Sample(lost), g_cWideChart, false), "r=\"3.8\"");
  };
  EXPECT_EQ(full(1), 4u);
  EXPECT_EQ(full(2), 0u);
  EXPECT_EQ(dots(1), 0u);
  EXPECT_EQ(dots(10), 4u);
  EXPECT_EQ(dots(11), 0u);
}

// None lost is at no other place than few lost: what is lost does not move a mark.
TEST(ChartTest, LossesMoveNoMark) {
  const auto places = [](std::size_t lost) {
    std::string svg = DrawChart(Sample(lost), g_cWideChart, false);
    std::string all;
    const std::regex mark("<(circle cx|rect x|path d)=[^>]*data-engine");
    for (auto it = std::sregex_iterator(svg.begin(), svg.end(), mark); it != std::sregex_iterator(); ++it)
      all += std::regex_replace(it->str(), std::regex("fill=\"[^\"]*\""), "");
    return all;
  };
  EXPECT_EQ(places(0), places(300));
  EXPECT_GT(places(0).size(), 300u);
}

TEST(ChartTest, AFileOfItsOwnHasItsColoursAndSafeText) {
  const std::string alone = DrawChart(Sample(0), g_cWideChart, true);
  EXPECT_TRUE(alone.find("a &lt; b &amp; c") != alone.npos);
  EXPECT_EQ(CountMatches(alone, "<[a-z]"), CountMatches(alone, "/>|</[a-z]")); // every element ends
  for (const CEngineRow& row : GetEngineRows())
    EXPECT_TRUE(alone.find(std::string("--") + row.m_sName + ":" + row.m_sDark) != alone.npos);
  EXPECT_EQ(DrawChart(Sample(0), g_cWideChart, false).find("<style>"), std::string::npos); // the control
}

TEST(ChartTest, NothingMeasuredIsStillAPicture) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes = {MakeUndecidedScene()};
  const CChart chart = MakeSceneChart(report, report.m_stdScenes[0]);
  EXPECT_TRUE(chart.m_stdPoints.empty());
  EXPECT_EQ(DrawChart(chart, g_cNarrowChart, false).find("nan"), std::string::npos);
}

} // namespace
} // namespace Shapes::Compare
