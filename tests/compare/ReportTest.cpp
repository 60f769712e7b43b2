// SPDX-License-Identifier: MIT
// Terminal and chart of a report whose figures are known.
#include "SampleReport.h"

#include "report/Chart.h"
#include "report/Numbers.h"

#include <regex>

namespace Shapes::Compare {
namespace {

// As it was before it was broken into lines.
std::string Unwrapped(const std::string& text) {
  std::string plain;
  for (const char c : text)
    if (c != '\n' && !(c == ' ' && plain.ends_with(' ')))
      plain += c;
    else if (!plain.ends_with(' '))
      plain += ' ';
  return plain;
}

TEST(NumbersTest, AreWhatPeopleRead) {
  using CTexts = std::vector<std::string>;
  EXPECT_EQ((CTexts{SizeText(0.0), SizeText(0.0004), SizeText(2.3e-7), SizeText(9e-8), SizeText(0.0005),
                    SizeText(1.23456), SizeText(12.34), SizeText(1e30)}),
            (CTexts{"0", "4e-4", "2e-7", "<1e-7", "0.001", "1.235", "12.3", "1e+30"}));
  EXPECT_EQ((CTexts{CountText(999), CountText(1000), CountText(1234567)}),
            (CTexts{"999", "1,000", "1,234,567"}));
  EXPECT_EQ((CTexts{RateText(0, 0), RateText(0, 20000), RateText(0, 2), RateText(203, 1000),
                    RateText(6, 1000), RateText(7, 7), RateText(1, 20000)}),
            (CTexts{"-", "<0.015%", "<100%", "20.3%", "0.60%", "100%", "0.0050%"}));
  EXPECT_EQ(
      (CTexts{RateTextWithError(1, 100000000), RateTextWithError(203, 1000), RateTextWithError(0, 1000)}),
      (CTexts{"<0.0001%", "20.3% +-2.5", "<0.3%"})); // Wilson: 17.9% to 22.9%
  EXPECT_EQ((CTexts{TwoDigits(12.3456), TwoDigits(1234.5), TwoDigits(0.0123), TwoDigits(0.0)}),
            (CTexts{"12", "1234", "0.012", "0"})); // to even
  EXPECT_EQ((CTexts{DegreesText(0.0), DegreesText(0.01), DegreesText(1.0)}),
            (CTexts{"0.001 degrees", "0.57 degrees", "57 degrees"}));
  EXPECT_EQ((CTexts{LossText(0, 2000), LossText(1, 40), LossText(7, 30000), LossText(203, 1000),
                    LossText(450, 1000), LossText(0, 0)}),
            (CTexts{"none of 2,000", "1 in 40", "1 in 4,300", "1 in 4.9", "45%", "-"}));
  EXPECT_EQ((CTexts{FasterText(7.14), FasterText(0.5), FasterText(1.04), FasterText(16.2)}),
            (CTexts{"7.1 times as fast", "0.50 times as fast", "as fast", "16 times as fast"}));
  EXPECT_TRUE(Overlap({0.1, 0.3}, {0.3, 0.4}));
  EXPECT_FALSE(Overlap({0.1, 0.3}, {0.31, 0.4}));
}

TEST(TableTest, ShowsTheEnginesBelowEachOther) {
  const std::string table = MakeTable(MakeSampleReport());
  EXPECT_TRUE(Says(table, R"(
spinner, 1,000 impacts
native               0.60%       1.2% +-0.7   0.50%   0.750   2e-4   0.25%    70
native-approximate   10.1%      20.3% +-2.5   0.50%   0.750  0.040   0.25%    50
box2d                0.30%     0.60% +-0.51   0.50%   0.750  0.020   0.25%   500
box2d-tuned          <0.3%            <0.3%   0.50%   0.750   2e-6   0.25%   800
)"));
  EXPECT_TRUE(Says(Unwrapped(table),
                   "Engines: native (what a game gets by default), native-approximate (no ball is swept), "
                   "box2d (Box2D as it ships), box2d-tuned (Box2D "
                   "set for accuracy)."));
  // The verdict comes after the table.
  EXPECT_TRUE(Says(table, "\n  " + MakeVerdict(MakeSampleReport(), MakeSampleScene())[0].substr(0, 40)));
}

void ExpectFits(const std::string& table) {
  for (const std::string& line : Lines(table)) {
    EXPECT_LE(line.size(), 80u) << line;
    EXPECT_FALSE(line.ends_with(' ')) << line;
    EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; })) << line;
  }
}

TEST(SummaryTest, ShowsEachSceneInALineAndTheResultOverAll) {
  CRunReport report = MakeSampleReport();
  const std::vector<std::string> heading = Lines(MakeHeading(report));
  EXPECT_EQ(heading.back(),
            "scene              take                          lost   degrees      ns  x box2d");
  EXPECT_EQ(MakeSceneLine(report, report.m_stdScenes[0]),
            "spinner            box2d-tuned          none of 1,000    <0.001     800     0.62\n");
  EXPECT_TRUE(Says(MakeSceneLine(report, MakeUndecidedScene()), "nothing to judge"));

  // The columns: lost, 95% of the directions in degrees (2 rad, and 0 on two engines), ns, times as fast.
  const std::string summary = MakeSummary(report);
  for (const char* pLine :
       {"all scenes         native                   1 in 83 ~    <0.001      70      7.1\n",
        "                   native-approximate      1 in 4.9 !       115      50       10\n",
        "                   box2d                   1 in 170 ~         -     500        1\n",
        "                   box2d-tuned          none of 1,000    <0.001     800     0.62\n"})
    EXPECT_TRUE(Says(summary, pLine));
  EXPECT_TRUE(Says(Unwrapped(summary), "Result: Take tuned Box2D: "));
  EXPECT_FALSE(Says(summary, "Interrupted"));
  report.m_bInterrupted = true;
  EXPECT_TRUE(Says(MakeSummary(report), "Interrupted: only the scenes that were finished (1) are here."));
  report.m_stdScenes.clear();
  EXPECT_TRUE(Says(MakeSummary(report), "Nothing was judged."));
}

TEST(SummaryTest, OneEngineAloneIsHeldAgainstNone) {
  const CRunReport report = MakeSampleReport({Tests::g_nNative});
  EXPECT_TRUE(Says(MakeSummary(report), "Result: native: it loses 12 of 1,000 impacts"));
  EXPECT_FALSE(Says(MakeSummary(report), "ox2"));
}

TEST(TableTest, FitsATerminalWhateverTheFiguresAndNames) {
  CRunReport report = MakeSampleReport();
  CSceneReport wild = MakeSampleScene();
  wild.m_cScene.m_sName =
      "a name \x1b[31m with \xc3\xa4 that is far longer than its column, and goes on and on until no "
      "line of any terminal can hold it any more, not even this one";
  for (CEngineReport& engine : wild.m_stdEngines) {
    engine.m_cTotals.m_nContacts = 100000000;
    engine.m_cTotals.m_nMissed = engine.m_cTotals.m_nWrongSide = 33333333;
    engine.m_cTotals["setback_error"] = {1, 1e30, 1e38, 1e38};
    engine.m_cTotals["direction_error"].m_fP95 = 3.14159;
    engine.m_cCost.m_cNsPerBallStep.m_fMedian = 12345678.0;
    engine.m_nGhosts = 800;
  }
  wild.m_cEffects = MakeSampleEffects({g_sNative, g_sBox2D});
  for (CEffectCost& cost : wild.m_cEffects.m_stdCosts)
    SetSampleTimes(cost.m_cWithout.m_cCost, 0.02, 1);
  report.m_stdScenes.push_back(wild);
  wild.m_cScene.m_sName = std::string(300, 'x');
  for (CEngineReport& engine : wild.m_stdEngines) // the longest rates
    engine.m_cTotals.m_nMissed = engine.m_cTotals.m_nWrongSide = 1000;
  report.m_stdScenes.push_back(wild);
  report.m_stdScenes.push_back(MakeUndecidedScene());
  report.m_bInterrupted = true;
  ExpectFits(MakeTable(report));
  ExpectFits(MakeHeading(report) + MakeSummary(report));
  for (const CSceneReport& scene : report.m_stdScenes)
    ExpectFits(MakeSceneLine(report, scene));
  EXPECT_GT(Lines(MakeEffectTable(report)).size(), 10u);
  EXPECT_TRUE(Says(MakeTable(report), "Interrupted: only the scenes that were finished (4) are here."));
  EXPECT_FALSE(Says(MakeTable(MakeSampleReport()), "Interrupted"));
  report.m_stdScenes.clear();
  EXPECT_TRUE(Says(MakeTable(report), "Interrupted before any scene was finished."));
  EXPECT_EQ(MakeEffectTable(report), "");
}

TEST(TableTest, SaysWhereNothingCouldBeJudged) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes = {MakeUndecidedScene()};
  const std::string table = MakeTable(report);
  EXPECT_TRUE(Says(Unwrapped(table),
                   "gave up 40 of 40 trials, the first at trial 0, step 2: ball 0 is jammed at (1, 2)"));
  // There is no rate, not even of zero.
  EXPECT_TRUE(Says(table, R"(
hopeless, 0 impacts
native                   -                -       -       -      -       -    70
native-approximate       -                -       -       -      -       -    50
box2d                    -                -       -       -      -       -   500
box2d-tuned              -                -       -       -      -       -   800
)"));
  // Where only some trials are given up, that is said beside the figures.
  report.m_stdScenes = {MakeSampleScene()};
  EXPECT_FALSE(Says(MakeTable(report), "gave up"));
  report.m_stdScenes[0].m_cImpactTrials.m_cExcluded.m_nUndecided = 1;
  report.m_stdScenes[0].m_cImpactTrials.m_cExcluded.m_sUndecided = "trial 7, step 1: somewhere";
  EXPECT_TRUE(Says(Unwrapped(MakeTable(report)),
                   "gave up 1 of 1200 trials, the first at trial 7, step 1: somewhere."));
}

CEffectCost& Get(CRunReport& report, eEffect e) {
  return report.m_stdScenes[0].m_cEffects.m_stdCosts.at(static_cast<std::size_t>(e));
}

TEST(EffectTableTest, ShowsWhatEachEffectCosts) {
  CRunReport report = MakeSampleReport();
  EXPECT_TRUE(
      Says(MakeEffectTable(report),
           "spinner\n native               +15%       +450%      (+40%)    (+1%)    -10%        +30%\n"));
  EXPECT_TRUE(Says(MakeTable(report), MakeEffectTable(report))); // which FitsATerminal
  SetSampleTimes(Get(report, eEffect::Kinematics).m_cWithout.m_cCost, 10.0, 1);
  SetSampleTimes(Get(report, eEffect::Gravity).m_cWith.m_cCost, 99.8, 1);
  SetSampleTimes(Get(report, eEffect::Sensors).m_cWith.m_cCost, 98.0, 1);
  EXPECT_TRUE(
      Says(MakeEffectTable(report),
           "spinner\n native                 ~0         x55      (+40%)    (-2%)    -10%        +30%\n"));
}

TEST(EffectTableTest, TellsWhatASavingCosts) {
  CRunReport report = MakeSampleReport();
  const auto changes = [&] { return MakeEffectChanges(report.m_stdScenes[0]); };
  EXPECT_EQ(changes(), std::vector<std::string>{"native without Continuous: loses 50.0% instead of 1.7%."});
  EXPECT_TRUE(Says(MakeEffectTable(report), "What else changes, at up to 60 impacts (p95 of errors):\n"
                                            "  spinner, native without Continuous: loses 50.0%"));
  Get(report, eEffect::Continuous).m_cWithout.m_cTotals.m_nMissed = 3; // chance
  EXPECT_TRUE(changes().empty());
  EXPECT_FALSE(Says(MakeEffectTable(report), "What else"));

  CEffectCost& kinematics = Get(report, eEffect::Kinematics);
  kinematics.m_cWithout.m_cFlightError.m_fP95 = 3.0;
  kinematics.m_cWithout.m_cTotals["direction_error"].m_fP95 = 2.0;
  kinematics.m_cWithout.m_cTotals["speed_error"].m_fP95 = 0.1;
  EXPECT_EQ(changes(),
            std::vector<std::string>{
                "native without Kinematics: flies 3.000 radii off to the first impact instead of 0.500, "
                "directions within 2.000 rad instead of 0.020, speeds within 10.0% instead of 0.200%."});
  std::swap(kinematics.m_cWith, kinematics.m_cWithout); // better without it: that costs nothing
  EXPECT_TRUE(changes().empty());
  kinematics.m_fRuns = 0.0; // what becomes better with one that is forced is told
  std::swap(kinematics.m_cWith.m_cTotals, kinematics.m_cWithout.m_cTotals);
  kinematics.m_cWith.m_cFlightError = kinematics.m_cWithout.m_cFlightError;
  kinematics.m_cWith.m_cTotals["speed_error"] = kinematics.m_cWithout.m_cTotals["speed_error"];
  EXPECT_EQ(changes(), std::vector<std::string>{
                           "native with Kinematics: directions within 0.020 rad instead of 2.000."});
}

TEST(EffectTableTest, TellsOfTouchesThatAreMissed) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes[0].m_cEffects.m_nTouches = 50;
  Get(report, eEffect::Continuous).m_cWithout = Get(report, eEffect::Continuous).m_cWith;
  Get(report, eEffect::Kinematics).m_cWithout.m_nTouchesMissed = 50;
  EXPECT_EQ(MakeEffectChanges(report.m_stdScenes[0]),
            std::vector<std::string>{
                "native without Kinematics: misses 100% of the touches of sensors instead of none."});
}

// ---- The chart as SVG. In a browser it is looked at by ReportPageTest.cpp.

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

// Full where at most 1 in 1,000 is lost, but for chance, with a dot up to 1 in 100, then hollow; the legend
// has one of each.
TEST(ChartTest, TheFillSaysWhatIsLost) {
  const auto full = [](std::size_t lost) {
    return CountMatches(DrawChart(Sample(lost), g_cWideChart, false),
                        "fill=\"var\\(--(?!ink)([a-z0-9-]+)\\)\" stroke=[^>]*data-engine=\"\\1\"");
  };
  const auto dots = [](std::size_t lost) {
    return CountMatches(DrawChart(Sample(lost), g_cWideChart, false), "r=\"3.8\"");
  };
  EXPECT_EQ(full(1), GetEngineRows().size());
  EXPECT_EQ(full(5), 0u);
  EXPECT_EQ(dots(1), 0u);
  EXPECT_EQ(dots(10), GetEngineRows().size());
  EXPECT_EQ(dots(20), 0u);
}

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
  EXPECT_TRUE(Says(alone, "a &lt; b &amp; c"));
  EXPECT_EQ(CountMatches(alone, "<[a-z]"), CountMatches(alone, "/>|</[a-z]")); // every element ends
  for (const CEngineRow& row : GetEngineRows())
    EXPECT_TRUE(Says(alone, std::string("--") + row.m_sName + ":" + row.m_sDark));
  EXPECT_FALSE(Says(DrawChart(Sample(0), g_cWideChart, false), "<style>")); // the control
}

TEST(ChartTest, NothingMeasuredIsStillAPicture) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes = {MakeUndecidedScene()};
  const CChart chart = MakeSceneChart(report, report.m_stdScenes[0]);
  EXPECT_TRUE(chart.m_stdPoints.empty());
  EXPECT_FALSE(Says(DrawChart(chart, g_cNarrowChart, false), "nan"));
}

} // namespace
} // namespace Shapes::Compare
