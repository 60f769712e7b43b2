// SPDX-License-Identifier: MIT
// Statistics; and totals, bins and histograms against sums that are written out plainly.
#include "metrics/Statistics.h"
#include "Testing.h"
#include "metrics/Totals.h"

#include <numeric>

namespace Shapes::Compare::Tests {
namespace {

TEST(StatisticsTest, SummariesAreByNearestRankOfWhatIsFinite) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values(100);
  std::iota(values.rbegin(), values.rend(), 1.0); // 100 .. 1
  values.insert(values.begin() + 50, {inf, nan});
  const CSummary s = Summarise(values);
  EXPECT_EQ(s.m_nCount, 100u);
  EXPECT_EQ(s.m_fMedian, 50.0);
  EXPECT_EQ(s.m_fP95, 95.0);
  EXPECT_EQ(s.m_fMax, 100.0);
  EXPECT_EQ(Summarise({3.0}).m_fP95, 3.0);
  EXPECT_EQ(SummariseSigned({nan, -2.0}).m_nCount, 1u);
  EXPECT_EQ(Summarise({}).m_fMedian + SummariseSigned({}).m_fMedian, 0.0);
}

TEST(StatisticsTest, WilsonHasThePublishedValues) {
  // R. G. Newcombe, Two-sided confidence intervals for the single proportion, Statist. Med. 17 (1998), table
  // I, method 3.
  const auto expect = [](std::size_t hits, std::size_t n, double low, double high) {
    EXPECT_NEAR(Wilson(hits, n).m_fLow, low, 5e-5);
    EXPECT_NEAR(Wilson(hits, n).m_fHigh, high, 5e-5);
  };
  expect(81, 263, 0.2553, 0.3662);
  expect(15, 148, 0.0624, 0.1605);
  expect(0, 20, 0.0, 0.1611);
  expect(1, 29, 0.0061, 0.1718);
  EXPECT_EQ(Wilson(0, 0).m_fHigh, 1.0);
}

TEST(StatisticsTest, TheIntervalOfTheMedianIsBetweenOrderStatistics) {
  std::vector<double> values(11);
  std::iota(values.begin(), values.end(), 1.0);
  const CMedian m = MedianWithInterval(values);
  EXPECT_EQ(m.m_fMedian, 6.0);
  // 11 values: the 2nd and the 10th hold the median with 98.8%, the 3rd and the 9th with 93.5% only.
  EXPECT_EQ(m.m_cInterval.m_fLow, 2.0);
  EXPECT_EQ(m.m_cInterval.m_fHigh, 10.0);
  EXPECT_EQ(MedianWithInterval({5.0, 1.0, 3.0}).m_cInterval.m_fLow, 1.0);
  EXPECT_EQ(MedianWithInterval({5.0, 1.0, 3.0}).m_cInterval.m_fHigh, 5.0);
}

// Of 1 .. 10,000 the 95th percentile is the 9,500th; its standard error is 21.8 ranks.
TEST(StatisticsTest, TheIntervalOfAQuantileIsBetweenOrderStatistics) {
  std::vector<double> values(10000);
  std::iota(values.begin(), values.end(), 1.0);
  const CQuantile q = QuantileWithInterval(values, 0.95);
  EXPECT_EQ(q.m_fValue, 9500.0);
  EXPECT_EQ(q.m_cInterval.m_fLow, 9457.0);
  EXPECT_EQ(q.m_cInterval.m_fHigh, 9544.0);
  const CQuantile few = QuantileWithInterval({3.0, 1.0, 2.0}, 0.95);
  EXPECT_EQ(few.m_fValue, 3.0);
  EXPECT_EQ(few.m_cInterval.m_fHigh, 3.0);
  EXPECT_EQ(QuantileWithInterval({}, 0.5).m_fValue, 0.0);
}

TEST(StatisticsTest, GeometricMeansAreOfRatios) { EXPECT_NEAR(GeometricMean({1.0, 100.0}), 10.0, 1e-12); }

// As by the sign test: with even odds all of 5 come out alike once in 16 times, all of 6 once in 32.
TEST(StatisticsTest, SixOfSixAreToldApartAndFiveOfFiveAreNot) {
  EXPECT_FALSE(CanBeToldApart(5, 0));
  EXPECT_TRUE(CanBeToldApart(6, 0));
  EXPECT_TRUE(CanBeToldApart(0, 6));
  EXPECT_FALSE(CanBeToldApart(120, 91));
  EXPECT_TRUE(CanBeToldApart(120, 90));
}

CEngineContact RandomEngineContact(CRandom& random) {
  CEngineContact c;
  c.m_eOutcome = static_cast<eOutcome>(random.Below(4));
  c.m_bDetected = random.Coin();
  c.m_bCompared = c.HasTurnedBack() && random.Coin();
  for (const CFigure& figure : GetImpactFigures())
    c.*figure.m_pOfImpact = figure.m_bIsSigned ? random.SignedScale(-20, 2) : random.Scale(-24, 6);
  if (random.Below(8) == 0) c.m_fPenetration = 0;
  return c;
}

std::vector<CContact> RandomContacts(CRandom& random, std::size_t n) {
  std::vector<CContact> contacts(n);
  for (CContact& c : contacts) {
    c.m_ePair = static_cast<ePair>(random.Below(g_nPairs));
    c.m_fTravel = random.Scale(-4, 4);
    c.m_fIncidence = random.Uniform(0, 1.57f);
    const float elasticities[] = {0, 0.25f, 0.5f, 0.7f, 0.9f, 1, 1.5f};
    c.m_fElasticity = elasticities[random.Below(7)];
    c.m_bHasDifference = random.Coin();
    c.m_fDifference = random.Scale(-10, 2);
    for (int e = 0; e < 2; ++e)
      c.m_stdEngines.push_back(RandomEngineContact(random));
  }
  return contacts;
}

bool Tunneled(const CEngineContact& c) {
  return c.m_eOutcome == eOutcome::Missed || c.m_eOutcome == eOutcome::WrongSide;
}

// The element of rank ceil(q n), counted from 1.
double Rank(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::ceil(q * static_cast<double>(values.size()))) - 1];
}

using CFilter = std::function<bool(const CEngineContact&)>;

void ExpectSummary(const CSummary& s, const std::vector<CContact>& contacts, std::size_t engine,
                   float CEngineContact::*pFigure, const CFilter& counts, bool isSigned = false) {
  std::vector<double> values, sizes;
  for (const CContact& contact : contacts) {
    const CEngineContact& c = contact.m_stdEngines[engine];
    if (!counts(c)) continue;
    values.push_back(static_cast<double>(c.*pFigure));
    sizes.push_back(std::abs(values.back()));
  }
  ASSERT_EQ(s.m_nCount, values.size());
  if (values.empty()) return;
  EXPECT_EQ(s.m_fMedian, Rank(values, 0.5));
  EXPECT_EQ(s.m_fP95, Rank(isSigned ? sizes : values, 0.95));
  EXPECT_EQ(s.m_fMax, Rank(isSigned ? sizes : values, 1.0));
}

void ExpectTotals(const CTotals& t, const std::vector<CContact>& contacts, std::size_t engine) {
  const auto count = [&](const CFilter& filter) {
    return static_cast<std::size_t>(std::count_if(
        contacts.begin(), contacts.end(), [&](const CContact& c) { return filter(c.m_stdEngines[engine]); }));
  };
  using C = CEngineContact;
  EXPECT_EQ(t.m_nContacts, contacts.size());
  EXPECT_EQ(t.m_nMissed, count([](const C& c) { return c.m_eOutcome == eOutcome::Missed; }));
  EXPECT_EQ(t.m_nWrongSide, count([](const C& c) { return c.m_eOutcome == eOutcome::WrongSide; }));
  EXPECT_EQ(t.m_nLate, count([](const C& c) { return c.m_eOutcome == eOutcome::Late; }));
  EXPECT_EQ(t.GetTunneled(), count(Tunneled));
  EXPECT_EQ(t.m_nOverlapped, count([](const C& c) { return !Tunneled(c) && c.m_fPenetration > 0.01f; }));
  const CFilter detected = [](const C& c) { return c.m_bDetected; };
  ExpectSummary(t["setback"], contacts, engine, &C::m_fSetback, detected);
  ExpectSummary(t["setback_error"], contacts, engine, &C::m_fSetbackError, detected);
  ExpectSummary(t["setback_error_normal"], contacts, engine, &C::m_fSetbackErrorNormal, detected, true);
  ExpectSummary(t["time_error"], contacts, engine, &C::m_fTimeError, detected, true);
  const CFilter back = [](const C& c) { return !Tunneled(c); };
  ExpectSummary(t["poi_error"], contacts, engine, &C::m_fPOIError, back);
  ExpectSummary(t["normal_error"], contacts, engine, &C::m_fNormalError, back);
  const CFilter compared = [](const C& c) { return c.m_bCompared; };
  ExpectSummary(t["direction_error"], contacts, engine, &C::m_fDirectionError, compared);
  ExpectSummary(t["speed_error"], contacts, engine, &C::m_fSpeedError, compared, true);
  ExpectSummary(t["energy_error"], contacts, engine, &C::m_fEnergyError, compared, true);
  ExpectSummary(t["position_error"], contacts, engine, &C::m_fPositionError, compared);
  ExpectSummary(t["penetration"], contacts, engine, &C::m_fPenetration, back);
  for (const CFigure& figure : GetImpactFigures()) { // also those that are not named above
    SCOPED_TRACE(figure.m_sKey);
    const CFilter counts = [&](const C& c) {
      return figure.m_pIsMeasured(c) && (figure.m_pIsSummarised == nullptr || figure.m_pIsSummarised(c));
    };
    ExpectSummary(t[figure.m_sKey], contacts, engine, figure.m_pOfImpact, counts, figure.m_bIsSigned);
  }
}

TEST(TotalsTest, TotalsAreTheSumsOverTheContacts) {
  CRandom random(41);
  const std::vector<CContact> contacts = RandomContacts(random, 3000);
  SCOPED_TRACE("seed " + std::to_string(random.GetSeed()));
  ExpectTotals(MakeTotals(contacts, 0), contacts, 0);
  ExpectTotals(MakeTotals(contacts, 1), contacts, 1);
  EXPECT_NE(MakeTotals(contacts, 0).m_nMissed, MakeTotals(contacts, 1).m_nMissed); // the engines differ
  const CTotals none = MakeTotals({}, 0);
  EXPECT_EQ(none.m_nContacts + none.GetTunneled() + none["setback"].m_nCount, 0u);
}

TEST(TotalsTest, DifferencesAreOfThoseThatBothDetected) {
  CRandom random(42);
  const std::vector<CContact> contacts = RandomContacts(random, 999);
  std::vector<double> values;
  for (const CContact& c : contacts)
    if (c.m_bHasDifference) values.push_back(static_cast<double>(c.m_fDifference));
  const CSummary s = SummariseDifference(contacts);
  EXPECT_EQ(s.m_nCount, values.size());
  EXPECT_EQ(s.m_fMedian, Rank(values, 0.5));
  EXPECT_EQ(s.m_fMax, Rank(values, 1.0));
}

// Whether a contact belongs to a bin, as its label says.
bool IsIn(const CBin& bin, const CContact& c) {
  if (bin.m_sBy == "pair") return bin.m_sLabel == GetName(c.m_ePair);
  const double value = bin.m_sBy == "travel"      ? Wide(c.m_fTravel)
                       : bin.m_sBy == "incidence" ? Wide(c.m_fIncidence) * 180 / std::numbers::pi
                                                  : Wide(c.m_fElasticity);
  const char* pLabel = bin.m_sLabel.c_str();
  double low, high;
  if (std::sscanf(pLabel, "%lf - %lf", &low, &high) == 2) return low <= value && value < high;
  if (std::sscanf(pLabel, "< %lf", &high) == 1) return value < high;
  if (std::sscanf(pLabel, ">= %lf", &low) == 1) return value >= low;
  if (std::sscanf(pLabel, "> %lf", &low) == 1) return value > low;
  return value == std::stod(bin.m_sLabel);
}

// Bins without contacts are left out.
TEST(TotalsTest, EveryContactIsInOneBinOfEachKind) {
  CRandom random(43);
  std::vector<CContact> contacts = RandomContacts(random, 4000);
  for (CContact& c : contacts)
    if (c.m_ePair == ePair::Arc) c.m_ePair = ePair::Point;
  contacts[0].m_fTravel = 1; // an edge belongs to the bin above it
  contacts[0].m_fIncidence = 0;
  std::map<std::string, std::size_t> counts;
  std::map<std::string, std::string> labels;
  for (const CBin& bin : MakeBins(contacts, 1)) {
    SCOPED_TRACE(bin.m_sBy + " " + bin.m_sLabel);
    labels[bin.m_sBy] += bin.m_sLabel + ", ";
    counts[bin.m_sBy] += bin.m_cTotals.m_nContacts;
    std::vector<CContact> own;
    for (const CContact& c : contacts)
      if (IsIn(bin, c)) own.push_back(c);
    ASSERT_FALSE(own.empty());
    ExpectTotals(bin.m_cTotals, own, 1);
  }
  EXPECT_EQ(counts, (std::map<std::string, std::size_t>{
                        {"travel", 4000}, {"incidence", 4000}, {"pair", 4000}, {"elasticity", 4000}}));
  EXPECT_EQ(labels["travel"], "< 0.25 r, 0.25 - 0.5 r, 0.5 - 1 r, 1 - 2 r, 2 - 4 r, >= 4 r, ");
  EXPECT_EQ(labels["incidence"],
            "0 - 15 deg, 15 - 30 deg, 30 - 45 deg, 45 - 60 deg, 60 - 75 deg, 75 - 90 deg, ");
  EXPECT_EQ(labels["pair"], "point, segment, segment end, circle, arc end, ball, ");
  EXPECT_EQ(labels["elasticity"], "< 0.25, 0.25 - 0.5, 0.5 - 0.75, 0.75 - 1, 1, > 1, ");
  EXPECT_TRUE(MakeBins({}, 0).empty());
}

TEST(TotalsTest, HistogramsCountBetweenTheirEdges) {
  for (std::size_t i = 0; i <= g_nHistogramBins; ++i)
    EXPECT_NEAR(std::log10(GetHistogramEdge(i)), static_cast<double>(i) / 4 - 6, 1e-12);
  CRandom random(45);
  std::vector<CContact> contacts = RandomContacts(random, 3000);
  for (const std::size_t i : {0u, 1u, 2u}) {
    contacts[i].m_stdEngines[0].m_bDetected = true;
    contacts[i].m_stdEngines[0].m_eOutcome = eOutcome::Correct;
  }
  contacts[0].m_stdEngines[0].m_fSetbackError = 1e9f; // larger than all edges
  contacts[1].m_stdEngines[0].m_fPenetration = 1.0f;  // on an edge, and below it
  contacts[2].m_stdEngines[0].m_fPenetration = std::nextafter(1.0f, 0.0f);
  ASSERT_EQ(GetHistogramEdge(24), 1.0);
  std::vector<std::size_t> errors(g_nHistogramBins, 0), penetrations(g_nHistogramBins, 0);
  const auto count = [](double x, std::vector<std::size_t>& counts) {
    std::size_t i = 0;
    while (i + 1 < g_nHistogramBins && x >= GetHistogramEdge(i + 1))
      ++i;
    ++counts[i];
  };
  for (const CContact& contact : contacts) {
    const CEngineContact& c = contact.m_stdEngines[0];
    if (c.m_bDetected) count(static_cast<double>(c.m_fSetbackError), errors);
    if (!Tunneled(c)) count(static_cast<double>(c.m_fPenetration), penetrations);
  }
  const CHistogram h = MakeHistogram(contacts, 0);
  EXPECT_EQ(h.m_stdSetbackError, errors);
  EXPECT_EQ(h.m_stdPenetration, penetrations);
  EXPECT_GT(h.m_stdSetbackError.back(), 0u);
  EXPECT_GT(h.m_stdPenetration.front(), 100u); // zeros
}

} // namespace
} // namespace Shapes::Compare::Tests
