// SPDX-License-Identifier: MIT
// Totals, bins and histograms against sums that are written out plainly.
#include "metrics/Totals.h"

#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>

namespace Shapes::Compare::Tests {
namespace {

using Shapes::Tests::CRandom;

CEngineContact RandomEngineContact(CRandom& random) {
  CEngineContact c;
  c.m_eOutcome = static_cast<eOutcome>(random.Below(4));
  c.m_bDetected = random.Coin();
  c.m_bCompared = c.HasTurnedBack() && random.Coin();
  for (float* p : {&c.m_fSetback, &c.m_fSetbackError, &c.m_fPOIError, &c.m_fNormalError, &c.m_fDirectionError,
                   &c.m_fPositionError, &c.m_fPenetration})
    *p = random.Scale(-24, 6);
  if (random.Below(8) == 0) c.m_fPenetration = 0;
  for (float* p : {&c.m_fSetbackErrorNormal, &c.m_fTimeError, &c.m_fSpeedError, &c.m_fEnergyError})
    *p = random.SignedScale(-20, 2);
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
  ExpectSummary(t["penetration"], contacts, engine, &C::m_fPenetration,
                [](const C& c) { return !Tunneled(c); });
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

// Which bin each contact belongs to, said once more.
std::string LabelOf(const std::string& by, const CContact& c) {
  if (by == "pair") return GetName(c.m_ePair);
  const double degrees = static_cast<double>(c.m_fIncidence) * 180 / 3.14159265358979323846;
  const float r = c.m_fTravel, e = c.m_fElasticity;
  if (by == "travel")
    return r < 0.25f  ? "< 0.25 r"
           : r < 0.5f ? "0.25 - 0.5 r"
           : r < 1    ? "0.5 - 1 r"
           : r < 2    ? "1 - 2 r"
           : r < 4    ? "2 - 4 r"
                      : ">= 4 r";
  if (by == "incidence") {
    const int low = static_cast<int>(degrees / 15) * 15;
    return std::to_string(low) + " - " + std::to_string(low + 15) + " deg";
  }
  return e < 0.25f   ? "< 0.25"
         : e < 0.5f  ? "0.25 - 0.5"
         : e < 0.75f ? "0.5 - 0.75"
         : e < 1     ? "0.75 - 1"
         : e == 1    ? "1"
                     : "> 1";
}

TEST(TotalsTest, EveryContactIsInOneBinOfEachKind) {
  CRandom random(43);
  const std::vector<CContact> contacts = RandomContacts(random, 4000);
  std::map<std::string, std::size_t> counts;
  std::set<std::pair<std::string, std::string>> seen;
  for (const CBin& bin : MakeBins(contacts, 1)) {
    SCOPED_TRACE(bin.m_sBy + " " + bin.m_sLabel);
    EXPECT_TRUE(seen.insert({bin.m_sBy, bin.m_sLabel}).second);
    counts[bin.m_sBy] += bin.m_cTotals.m_nContacts;
    std::vector<CContact> own;
    for (const CContact& c : contacts)
      if (LabelOf(bin.m_sBy, c) == bin.m_sLabel) own.push_back(c);
    ASSERT_FALSE(own.empty());
    ExpectTotals(bin.m_cTotals, own, 1);
  }
  EXPECT_EQ(counts, (std::map<std::string, std::size_t>{
                        {"travel", 4000}, {"incidence", 4000}, {"pair", 4000}, {"elasticity", 4000}}));
  EXPECT_EQ(seen.size(), 6u + 6 + 7 + 6);
}

TEST(TotalsTest, BinsWithoutContactsAreLeftOut) {
  CRandom random(44);
  std::vector<CContact> contacts = RandomContacts(random, 50);
  for (CContact& c : contacts) {
    c.m_ePair = ePair::Arc;
    c.m_fTravel = 1; // an edge belongs to the bin above it
    c.m_fElasticity = 1;
    c.m_fIncidence = 0;
  }
  const std::vector<CBin> bins = MakeBins(contacts, 0);
  ASSERT_EQ(bins.size(), 4u);
  EXPECT_EQ(bins[0].m_sLabel, "1 - 2 r");
  EXPECT_EQ(bins[1].m_sLabel, "0 - 15 deg");
  EXPECT_EQ(bins[2].m_sLabel, "arc");
  EXPECT_EQ(bins[3].m_sLabel, "1");
  EXPECT_TRUE(MakeBins({}, 0).empty());
}

TEST(TotalsTest, HistogramsCountBetweenTheirEdges) {
  for (std::size_t i = 0; i <= g_nHistogramBins; ++i)
    EXPECT_NEAR(std::log10(GetHistogramEdge(i)), static_cast<double>(i) / 4 - 6, 1e-12);
  CRandom random(45);
  std::vector<CContact> contacts = RandomContacts(random, 3000);
  contacts[0].m_stdEngines[0].m_fSetbackError = 1e9f; // larger than all edges
  contacts[0].m_stdEngines[0].m_bDetected = true;
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

TEST(TotalsTest, AnEdgeOfTheHistogramBelongsToTheBinAboveIt) {
  ASSERT_EQ(GetHistogramEdge(24), 1.0);
  const auto binOf = [](float penetration) {
    CContact contact;
    contact.m_stdEngines.resize(1);
    contact.m_stdEngines[0].m_eOutcome = eOutcome::Correct;
    contact.m_stdEngines[0].m_fPenetration = penetration;
    const auto bins = MakeHistogram(std::span(&contact, 1), 0).m_stdPenetration;
    return std::find(bins.begin(), bins.end(), 1u) - bins.begin();
  };
  EXPECT_EQ(binOf(1.0f), 24);
  EXPECT_EQ(binOf(std::nextafter(1.0f, 0.0f)), 23);
}

} // namespace
} // namespace Shapes::Compare::Tests
