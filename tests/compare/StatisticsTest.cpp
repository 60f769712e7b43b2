// SPDX-License-Identifier: MIT
#include "metrics/Statistics.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "Random.h"

namespace Shapes::Compare {
namespace {

TEST(StatisticsTest, SummariesAreByNearestRank) {
  std::vector<double> values(100);
  std::iota(values.rbegin(), values.rend(), 1.0); // 100 .. 1
  const CSummary s = Summarise(values);
  EXPECT_EQ(s.m_nCount, 100u);
  EXPECT_EQ(s.m_fMedian, 50.0);
  EXPECT_EQ(s.m_fP95, 95.0);
  EXPECT_EQ(s.m_fMax, 100.0);
  EXPECT_EQ(Summarise({3.0}).m_fMedian, 3.0);
  EXPECT_EQ(Summarise({3.0}).m_fP95, 3.0);
}

TEST(StatisticsTest, SummariesLeaveOutWhatIsNotFinite) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const CSummary s = Summarise({1.0, inf, nan, 2.0});
  EXPECT_EQ(s.m_nCount, 2u);
  EXPECT_EQ(s.m_fMax, 2.0);
  EXPECT_EQ(Summarise({nan}).m_nCount, 0u);
  EXPECT_EQ(Summarise({}).m_fMedian, 0.0);
}

TEST(StatisticsTest, SignedSummariesKeepTheSignOfTheMedianOnly) {
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), -80.0); // -80 .. 19
  const CSummary s = SummariseSigned(values);
  EXPECT_EQ(s.m_nCount, 100u);
  EXPECT_EQ(s.m_fMedian, -31.0);
  EXPECT_EQ(s.m_fP95, 75.0); // of 0, 1, 1, 2, 2 .. 19, 19, 20 .. 80
  EXPECT_EQ(s.m_fMax, 80.0);
  EXPECT_EQ(Summarise(values).m_fP95, 14.0); // the control: without that
  EXPECT_EQ(SummariseSigned({std::numeric_limits<double>::quiet_NaN(), -2.0}).m_nCount, 1u);
  EXPECT_EQ(SummariseSigned({}).m_nCount, 0u);
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

TEST(StatisticsTest, WilsonHoldsTheTrueRateAsOftenAsItSays) {
  Shapes::Tests::CRandom random(11);
  int held = 0;
  constexpr int runs = 2000;
  for (int run = 0; run < runs; ++run) {
    std::size_t hits = 0;
    for (int i = 0; i < 400; ++i)
      hits += random.Unit() < 0.3;
    const CInterval i = Wilson(hits, 400);
    held += i.m_fLow <= 0.3 && 0.3 <= i.m_fHigh;
  }
  // 95% of 2000, 4 standard errors of 9.7.
  EXPECT_NEAR(held, 1900, 39) << "seed " << random.GetSeed();
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

} // namespace
} // namespace Shapes::Compare
