// SPDX-License-Identifier: MIT
#include "Overall.h"

#include <algorithm>
#include <functional>
#include <numbers>

namespace Shapes::Compare {
namespace {

std::optional<double> GetDirection(const CTotals& totals) { return totals["direction_error"].GetP95(); }

// The least and the most of some values.
CInterval Extremes(const std::vector<double>& values) {
  if (values.empty()) return {0.0, 0.0};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, *most};
}

// An engine as it is held against the others.
struct CCandidate {
  std::size_t m_nLost;
  double m_fDirection; // radians; pi where none was compared
  double m_fNs;
  eGrade m_eGrade;
};

bool IsNoWorse(const CCandidate& a, const CCandidate& b) {
  const bool losesMore = a.m_nLost > b.m_nLost && CanBeToldApart(a.m_nLost, b.m_nLost);
  return !losesMore && (a.m_fDirection <= b.m_fDirection || a.m_fDirection <= g_fSameDirection);
}

std::optional<std::size_t> Choose(const std::vector<CEngine>& engines,
                                  const std::vector<CCandidate>& candidates,
                                  const std::function<bool(std::size_t, std::size_t)>& areTimesApart) {
  if (candidates.empty()) return std::nullopt;
  const auto isBetter = [&](const CCandidate& a, const CCandidate& b) {
    return a.m_nLost != b.m_nLost ? a.m_nLost < b.m_nLost : a.m_fDirection < b.m_fDirection;
  };
  const std::size_t measure =
      FindEngine(engines, g_sBox2D)
          .value_or(static_cast<std::size_t>(
              std::min_element(candidates.begin(), candidates.end(), isBetter) - candidates.begin()));
  std::size_t best = measure;
  for (std::size_t e = 0; e < candidates.size(); ++e) {
    const CCandidate &c = candidates[e], &b = candidates[best];
    if (IsNoWorse(c, candidates[measure]) &&
        (c.m_eGrade < b.m_eGrade || (c.m_eGrade == b.m_eGrade && c.m_fNs < b.m_fNs)))
      best = e;
  }
  const auto native = FindEngine(engines, g_sNative);
  if (native && IsNoWorse(candidates[*native], candidates[measure]) &&
      candidates[*native].m_eGrade == candidates[best].m_eGrade && !areTimesApart(*native, best))
    return native;
  return best;
}

// Of each repeat the geometric mean over the scenes; its median and interval over the repeats.
CMedian OverScenes(const std::vector<std::vector<double>>& repeatsOfScenes) {
  std::size_t repeats = repeatsOfScenes.empty() ? 0 : repeatsOfScenes.front().size();
  for (const auto& scene : repeatsOfScenes)
    repeats = std::min(repeats, scene.size());
  std::vector<double> means;
  for (std::size_t r = 0; r < repeats; ++r) {
    std::vector<double> values;
    for (const auto& scene : repeatsOfScenes)
      values.push_back(scene[r]);
    means.push_back(GeometricMean(values));
  }
  return MedianWithInterval(std::move(means));
}

bool IsJudged(const CSceneReport& scene) {
  return !scene.m_stdEngines.empty() && scene.m_stdEngines.front().m_cTotals.m_nContacts > 0;
}

CEngineOverall MakeEngineOverall(const CRunReport& report, std::size_t e) {
  CEngineOverall overall;
  std::vector<double> directions, speeds, ofScenes, ns, times;
  std::vector<std::vector<double>> repeats, ratios;
  const auto box2d = FindEngine(report.m_stdEngines, g_sBox2D);
  for (const CSceneReport& scene : report.m_stdScenes) {
    if (!IsJudged(scene)) continue;
    const CEngineReport& engine = scene.m_stdEngines[e];
    overall.m_nLost += engine.m_cTotals.GetTunneled();
    repeats.push_back(engine.m_cCost.m_stdRepeats);
    ns.push_back(engine.m_cCost.m_cNsPerBallStep.m_fMedian);
    if (box2d) {
      ratios.push_back(GetRatios(scene.m_stdEngines[*box2d].m_cCost, engine.m_cCost));
      times.push_back(MedianWithInterval(ratios.back()).m_fMedian);
    }
    for (const CContact& contact : scene.m_cImpactTrials.m_stdContacts)
      if (const CEngineContact& c = contact.m_stdEngines[e]; c.m_bCompared) {
        directions.push_back(static_cast<double>(c.m_fDirectionError));
        speeds.push_back(static_cast<double>(c.m_fSpeedError));
      }
    if (const auto direction = GetDirection(engine.m_cTotals)) ofScenes.push_back(*direction);
  }
  overall.m_nCompared = directions.size();
  overall.m_cDirection = QuantileWithInterval(std::move(directions), 0.95);
  overall.m_fSpeed = SummariseSigned(std::move(speeds)).m_fP95;
  overall.m_cDirectionScenes = Extremes(ofScenes);
  overall.m_cNs = OverScenes(repeats);
  overall.m_cNsScenes = Extremes(ns);
  if (box2d && !times.empty()) {
    overall.m_cTimes = OverScenes(ratios);
    overall.m_cTimesScenes = Extremes(times);
  }
  return overall;
}

} // namespace

const char* GetName(eGrade grade) {
  switch (grade) {
  case eGrade::Good: return "good";
  case eGrade::Rough: return "rough";
  case eGrade::Poor: return "poor";
  case eGrade::Unknown: break;
  }
  return "unknown";
}

eGrade GradeOf(std::size_t lost, std::size_t impacts, std::optional<double> direction,
               std::optional<double> speed) {
  if (impacts == 0) return eGrade::Unknown;
  // One that is lost of 300 does not show that more than 1 of 1,000 are.
  const double rate = Wilson(lost, impacts).m_fLow, error = direction.value_or(0.0);
  const auto isWithin = [&](const CGradeBound& bound) {
    return rate <= bound.m_fLost && error <= bound.m_fDirection && speed.value_or(0.0) <= bound.m_fSpeed;
  };
  return isWithin(g_cGood) ? eGrade::Good : isWithin(g_cRough) ? eGrade::Rough : eGrade::Poor;
}

eGrade GradeOf(const CTotals& totals) {
  return GradeOf(totals.GetTunneled(), totals.m_nContacts, GetDirection(totals),
                 totals["speed_error"].GetP95());
}

bool AreTimesApart(const CCost& a, const CCost& b) {
  const CInterval i = CompareCosts(a, b).m_cInterval;
  return i.m_fLow > 1.0 || i.m_fHigh < 1.0;
}

std::optional<std::size_t> FindTake(const CRunReport& report, const CSceneReport& scene) {
  if (!IsJudged(scene)) return std::nullopt;
  std::vector<CCandidate> candidates;
  for (const CEngineReport& engine : scene.m_stdEngines)
    candidates.push_back({engine.m_cTotals.GetTunneled(), GetDirection(engine.m_cTotals).value_or(0.0),
                          engine.m_cCost.m_cNsPerBallStep.m_fMedian, GradeOf(engine.m_cTotals)});
  return Choose(report.m_stdEngines, candidates, [&](std::size_t a, std::size_t b) {
    return a != b && AreTimesApart(scene.m_stdEngines[a].m_cCost, scene.m_stdEngines[b].m_cCost);
  });
}

eGrade COverall::GetGrade(std::size_t e) const {
  const CEngineOverall& engine = m_stdEngines[e];
  return GradeOf(engine.m_nLost, m_nImpacts,
                 engine.m_nCompared == 0 ? std::nullopt : std::optional(engine.m_cDirection.m_fValue),
                 engine.m_fSpeed);
}

COverall MakeOverall(const CRunReport& report) {
  COverall overall;
  for (const CSceneReport& scene : report.m_stdScenes)
    if (IsJudged(scene)) {
      ++overall.m_nScenes;
      overall.m_nImpacts += scene.m_stdEngines.front().m_cTotals.m_nContacts;
    }
  if (overall.m_nScenes == 0) return overall;
  std::vector<CCandidate> candidates;
  for (std::size_t e = 0; e < report.m_stdEngines.size(); ++e) {
    overall.m_stdEngines.push_back(MakeEngineOverall(report, e));
    const CEngineOverall& engine = overall.m_stdEngines.back();
    const double direction = engine.m_nCompared > 0 ? engine.m_cDirection.m_fValue : std::numbers::pi;
    candidates.push_back({engine.m_nLost, direction, engine.m_cNs.m_fMedian, overall.GetGrade(e)});
  }
  for (std::size_t e = 0; e < candidates.size(); ++e)
    overall.m_stdEngines[e].m_bFront =
        std::none_of(candidates.begin(), candidates.end(), [&](const CCandidate& other) {
          return other.m_fNs < candidates[e].m_fNs && other.m_fDirection <= candidates[e].m_fDirection;
        });
  overall.m_nTake = Choose(report.m_stdEngines, candidates, [&](std::size_t a, std::size_t b) {
    std::vector<std::vector<double>> ratios;
    for (const CSceneReport& scene : report.m_stdScenes)
      if (IsJudged(scene))
        ratios.push_back(GetRatios(scene.m_stdEngines[a].m_cCost, scene.m_stdEngines[b].m_cCost));
    const CInterval i = OverScenes(ratios).m_cInterval;
    return a != b && (i.m_fLow > 1.0 || i.m_fHigh < 1.0);
  });
  return overall;
}

} // namespace Shapes::Compare
