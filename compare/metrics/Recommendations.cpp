// SPDX-License-Identifier: MIT
// Recommendations from the parameter sweep of a scene.
#include "WorkPrecision.h"

#include "report/Numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace Shapes::Compare {
namespace {

using CTest = std::function<bool(const CSetting&)>;

double GetCost(const CSetting& setting) { return setting.m_cNsPerBallSecond.m_fMedian; }

double GetTunneledRate(const CSetting& setting) {
  return static_cast<double>(setting.GetAllTunneled()) / static_cast<double>(setting.GetAllContacts());
}

bool IsJudged(const CSetting& setting) {
  return setting.m_cEngine.m_sName != g_sExact && setting.m_nContacts > 0;
}

// How close one comes: the setting whose error, or share of lost balls, whichever is larger, is the smallest.
std::optional<std::size_t> FindClosest(const std::vector<CSetting>& settings) {
  const auto key = [](const CSetting& r) { return std::max(GetTunneledRate(r), *r.m_fDirectionErrorP95); };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < settings.size(); ++i)
    if (IsJudged(settings[i]) && settings[i].m_fDirectionErrorP95 &&
        (!best || key(settings[i]) < key(settings[*best])))
      best = i;
  return best;
}

CRecommendation Recommend(const std::vector<CSetting>& settings, std::string demand, const CTest& passes) {
  CRecommendation recommendation;
  recommendation.m_sDemand = std::move(demand);
  std::vector<std::size_t>& choices = recommendation.m_stdChoices;
  std::vector<std::string>& without = recommendation.m_stdWithout;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const std::string& engine = settings[i].m_cEngine.m_sName;
    if (!IsJudged(settings[i])) continue;
    const auto choice = std::find_if(choices.begin(), choices.end(),
                                     [&](std::size_t c) { return settings[c].m_cEngine.m_sName == engine; });
    if (!passes(settings[i])) {
      if (choice == choices.end() && std::find(without.begin(), without.end(), engine) == without.end())
        without.push_back(engine);
    } else if (choice == choices.end()) {
      choices.push_back(i);
      std::erase(without, engine);
    } else if (GetCost(settings[i]) < GetCost(settings[*choice])) {
      *choice = i;
    }
  }
  std::sort(choices.begin(), choices.end(),
            [&](std::size_t a, std::size_t b) { return GetCost(settings[a]) < GetCost(settings[b]); });
  // The world by default comes first where none is measurably faster.
  for (auto choice = choices.begin(); choice != choices.end(); ++choice)
    if (settings[*choice].m_cEngine.m_sName == g_sNative &&
        Overlap(settings[*choice].m_cNsPerBallSecond.m_cInterval,
                settings[choices.front()].m_cNsPerBallSecond.m_cInterval))
      std::rotate(choices.begin(), choice, choice + 1);
  if (choices.empty()) recommendation.m_nClosest = FindClosest(settings);
  return recommendation;
}

} // namespace

std::vector<CRecommendation> MakeRecommendations(const std::vector<CSetting>& settings, std::size_t proof) {
  const auto below = [](double bound) {
    return [bound](const CSetting& setting) {
      return setting.m_fDirectionErrorP95 && *setting.m_fDirectionErrorP95 < bound &&
             GetTunneledRate(setting) < bound;
    };
  };
  return {
      Recommend(settings, "Bounces within 0.6 degrees (.01 rad), fewer than 1 in 100 lost", below(0.01)),
      Recommend(settings, "Bounces within 0.06 degrees (.001 rad), fewer than 1 in 1,000 lost", below(0.001)),
      Recommend(settings, fmt::format("None lost in {} impacts", CountText(proof)),
                [&](const CSetting& setting) {
                  return setting.GetAllTunneled() == 0 && setting.GetAllContacts() >= proof;
                })};
}

} // namespace Shapes::Compare
