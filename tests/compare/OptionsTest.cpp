// SPDX-License-Identifier: MIT
// The arguments of a command line: engines, scenes, limits, and names that are nearly right.
#include "app/Options.h"

#include "SampleReport.h"
#include "app/FailAbove.h"
#include "app/NearMatches.h"

namespace Shapes::Compare {
namespace {

TEST(OptionsTest, CommandsAreQuotedForAShell) {
  EXPECT_EQ(JoinCommand(std::vector<std::string>{"a", "--out=b/c", "x,y"}), "a --out=b/c x,y");
  EXPECT_EQ(JoinCommand(std::vector<std::string>{"a b", "", "it's", "$x"}), "'a b' '' 'it'\\''s' '$x'");
}

// Against the definition, without the table.
std::size_t Slow(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::string_view a1 = a.substr(1), b1 = b.substr(1);
  std::size_t least = std::min({Slow(a1, b) + 1, Slow(a, b1) + 1, Slow(a1, b1) + (a[0] == b[0] ? 0 : 1)});
  if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0])
    least = std::min(least, Slow(a.substr(2), b.substr(2)) + 1);
  return least;
}

TEST(NearMatchesTest, DistancesAreThoseOfTheDefinition) {
  ForEachCase(3, 500, [](CRandom& random, int) {
    const auto word = [&] {
      std::string text(random.Below(6), ' ');
      for (char& c : text)
        c = static_cast<char>('a' + random.Below(3));
      return text;
    };
    const std::string a = word(), b = word();
    EXPECT_EQ(EditDistance(a, b), Slow(a, b)) << a << " " << b;
    EXPECT_EQ(EditDistance(a, b), EditDistance(b, a)) << a << " " << b;
  });
}

TEST(NearMatchesTest, NearestFirstAndNoStrangers) {
  const std::vector<std::string> known{"open_arc_outside", "open_arc_inside", "pinball", "bowl"};
  EXPECT_EQ(NearMatches("open_arc_insid", known),
            (std::vector<std::string>{"open_arc_inside", "open_arc_outside"}));
  EXPECT_EQ(NearMatches("PINBALL", known), (std::vector<std::string>{"pinball"}));
  EXPECT_EQ(NearMatches("bow", known), (std::vector<std::string>{"bowl"}));
  EXPECT_TRUE(NearMatches("spinner", known).empty());
  EXPECT_TRUE(NearMatches("", known).empty());
}

std::vector<std::string> Find(const CRunReport& report, const std::string& limit) {
  const CLimit limits[] = {ParseLimit(limit)};
  return FindAbove(report, limits);
}

TEST(FailAboveTest, LimitsAreParsedAndWhatIsNoneIsRefused) {
  EXPECT_EQ(ParseLimit("missed=0.25").m_sMetric, "missed");
  for (const auto& [pText, most] :
       {std::pair("missed=.25", 0.25), {"energy_drift=1e-3", 1e-3}, {"ghost=0", 0.0}})
    EXPECT_EQ(ParseLimit(pText).m_fMost, most);
  for (const char* pText :
       {"missed", "missed=", "missed=x", "missed=1x", "missed=-1", "missed=nan", "missed=inf", "missed=1e999",
        "missed= 1", "missed==1", "", "=1", "Missed=1", "misses=1"})
    EXPECT_THROW(ParseLimit(pText), std::invalid_argument) << pText;
}

// Each metric with what native-approximate and box2d have of it in the sample. At a value that one of them
// has it is not above, just below it is: so the value is this one.
TEST(FailAboveTest, EveryMetricIsTheRightOne) {
  CRunReport report = MakeSampleReport({Tests::g_nApproximate, Tests::g_nBox2D});
  for (CEngineReport& engine : report.m_stdScenes[0].m_stdEngines) {
    engine.m_cLongRun.m_fFreePathError = 0.01;
    engine.m_cLongRun.m_fAngularMomentumDrift = -0.02;
    engine.m_cCost.m_nEscaped = 3;
    engine.m_cCost.m_nNotFinite = 1;
  }
  const auto expect = [&](std::size_t above, std::size_t belowIt, const std::string& limits) {
    std::istringstream in(limits);
    for (std::string text; in >> text;) {
      CLimit limit[] = {ParseLimit(text)};
      EXPECT_EQ(FindAbove(report, limit).size(), above) << text;
      limit[0].m_fMost *= 1 - 1e-12;
      EXPECT_EQ(FindAbove(report, limit).size(), belowIt) << text;
    }
  };
  expect(0, 2,
         "overlapped=0.02 ghost=0.0025 late=0.005 setback=0.9 setback_error=0.75 setback_error_normal=0.5 "
         "poi_error=0.12 time_error=0.04 normal_error=0.15 speed_error=0.08 energy_error=0.22 "
         "position_error=0.26 penetration=0.005 energy_drift=0.03 free_path_error=0.01 "
         "angular_momentum_drift=0.02 escaped=3 not_finite=1 lasting_lost=0.015 lasting_overlap=0.06 "
         "lasting_speed=0.7 lasting_energy_gained=0.05 rest_time=1.8 flow=2.5 lasting_ns_per_ball_step=654");
  expect(0, 1,
         "missed=0.101 wrong_side=0.102 tunneled=0.203 direction_error=0.04 "
         "ns_per_ball_step=500 ns_per_contact=50000");
  expect(1, 2,
         "missed=0.003 wrong_side=0.003 tunneled=0.006 direction_error=0.02 ns_per_ball_step=50 "
         "ns_per_contact=5000");
  // All figures, also those that are not named above.
  const CSceneReport& scene = report.m_stdScenes[0];
  for (const CFigure& figure : GetFigures()) {
    double most = 0.0;
    for (const CEngineReport& engine : scene.m_stdEngines)
      most = std::max(most, GetLimited(figure, scene, engine).value_or(-1.0));
    const CLimit at[] = {{figure.m_sKey, most}}, below[] = {{figure.m_sKey, most * (1 - 1e-12)}};
    ASSERT_GT(most, 0.0) << figure.m_sKey << ": tests/compare/SampleReport.h has no value of it";
    EXPECT_TRUE(FindAbove(report, at).empty()) << figure.m_sKey;
    EXPECT_FALSE(FindAbove(report, below).empty()) << figure.m_sKey;
  }
}

TEST(FailAboveTest, SaysWhichSceneEngineAndValueAndANaNIsAboveEveryLimit) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes[0].m_stdEngines[Tests::g_nBox2D].m_cLongRun.m_fEnergyDrift = std::nan("");
  using CTexts = std::vector<std::string>;
  EXPECT_EQ(Find(report, "tunneled=0.1"),
            CTexts{"tunneled is 0.203 on spinner with native-approximate: above 0.1"});
  EXPECT_EQ(Find(report, "energy_drift=1e9"),
            CTexts{"energy_drift is nan on spinner with box2d: above 1e+09"});
}

TEST(FailAboveTest, WhatWasMeasuredNowhereIsNoPass) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes = {MakeUndecidedScene()};
  const auto above = Find(report, "missed=1");
  ASSERT_EQ(above.size(), 1u);
  EXPECT_TRUE(Says(above[0], "missed was not measured"));
  report.m_stdScenes.push_back(MakeSampleScene());
  EXPECT_TRUE(Find(report, "missed=1").empty());
}

TEST(FailAboveTest, FewImpactsShowNoSmallRate) {
  EXPECT_EQ(WarnOfFew({"tunneled", 0.001}, 3000), "");
  EXPECT_EQ(WarnOfFew({"tunneled", 0.001}, 100), "tunneled=0.001: even with none, 100 impacts show only "
                                                 "that the rate is below 0.03; 3,000 are needed "
                                                 "(--contacts)");
  EXPECT_EQ(WarnOfFew({"tunneled", 0.0}, 100), "");          // no number of impacts would
  EXPECT_EQ(WarnOfFew({"direction_error", 0.001}, 100), ""); // no rate
}

// The sample has one contact, and says 1,000 of each engine; of quiet steps there are 800.
TEST(FailAboveTest, ASceneWithFewerImpactsThanAskedForIsNamed) {
  CRunReport report = MakeSampleReport();
  CImpactTrialResult& trials = report.m_stdScenes[0].m_cImpactTrials;
  trials.m_nTrials = 20000;
  const auto warn = [&](const std::string& limit) {
    const CLimit limits[] = {ParseLimit(limit)};
    return WarnOfFewFound(report, limits);
  };
  const std::string found = "spinner: 1 of 1,000 impacts were found in 20,000 trials";
  EXPECT_EQ(warn("tunneled=0.003"), std::vector{found});
  for (CEngineReport& engine : report.m_stdScenes[0].m_stdEngines)
    engine.m_cTotals.m_nContacts = 22;
  EXPECT_EQ(
      warn("tunneled=0.003"),
      (std::vector<std::string>{found, "spinner: tunneled=0.003: even with none, 22 impacts show only that "
                                       "the rate is below 0.14; 1,000 are needed"}));
  EXPECT_EQ(warn("tunneled=0.001"), std::vector{found}); // said before the run
  EXPECT_EQ(warn("direction_error=0.001"), std::vector{found});
  trials.m_stdContacts.resize(1000, trials.m_stdContacts[0]);
  EXPECT_TRUE(warn("direction_error=0.001").empty()); // the control
}

TEST(FailAboveTest, AnEngineWithoutAFigureThatAnotherOneHasIsNoPass) {
  using CTexts = std::vector<std::string>;
  CRunReport report = MakeSampleReport({Tests::g_nNative, Tests::g_nBox2D});
  report.m_stdScenes.push_back(report.m_stdScenes[0]);
  CSceneReport& scene = report.m_stdScenes[1];
  scene.m_cScene.m_sName = "slope";
  scene.m_stdEngines[1].m_cTotals["direction_error"] = {};
  scene.m_stdEngines[1].m_cLasting.m_fRestTime = {};
  EXPECT_EQ(Find(report, "direction_error=3"),
            CTexts{"direction_error was not measured on slope with box2d: it cannot be held against 3"});
  EXPECT_EQ(
      Find(report, "rest_time=60"),
      CTexts{"rest_time: not all balls come to rest on slope with box2d: it cannot be held against 60"});
  // Where none has it there was nothing to measure, unless all impacts were lost.
  CEngineReport& native = scene.m_stdEngines[0];
  native.m_cTotals["direction_error"] = {};
  native.m_cLasting.m_fRestTime = {};
  EXPECT_TRUE(Find(report, "direction_error=3").empty());
  EXPECT_TRUE(Find(report, "rest_time=60").empty());
  native.m_cTotals.m_nMissed = native.m_cTotals.m_nContacts;
  native.m_cTotals.m_nWrongSide = 0;
  EXPECT_EQ(Find(report, "direction_error=3"),
            CTexts{"direction_error was not measured on slope with native: it cannot be held against 3"});
}

} // namespace
} // namespace Shapes::Compare
