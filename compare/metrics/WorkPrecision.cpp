// SPDX-License-Identifier: MIT
#include "WorkPrecision.h"

#include "Cost.h"
#include "ImpactTrials.h"
#include "Totals.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <numbers>

namespace Shapes::Compare {

std::vector<CEngine> GetParameterSweep() {
  const std::vector<CEngine> engines = GetEngines();
  const auto settings = [&](std::string_view name) {
    return [engine = engines.at(FindEngine(engines, name).value())](
               unsigned substeps, unsigned velocityIterations = 8, unsigned positionIterations = 3,
               float scale = 1.0f, float sagittaFactor = 1.0f) mutable {
      engine.m_nSubsteps = substeps;
      engine.m_nVelocityIterations = velocityIterations;
      engine.m_nPositionIterations = positionIterations;
      engine.m_fScale = scale;
      engine.m_fSagittaFactor = sagittaFactor;
      return engine;
    };
  };
  auto native = settings(g_sNative), approximate = settings(g_sNativeApproximate), box2d = settings(g_sBox2D),
       tuned = settings("box2d-tuned");
  // A substep of Box2D is a whole step of it at a higher rate. Iterations matter where contacts act on each
  // other; the scale shrinks its skin and slop, the sagitta the error of arcs.
  std::vector<CEngine> sweep{
      native(1),
      native(2),
      native(4),
      native(8),
      approximate(1),
      approximate(2),
      approximate(4),
      approximate(8),
      approximate(16),
      approximate(32),
      approximate(64),
      box2d(1),
      box2d(1, 1, 1),
      box2d(1, 30, 10),
      box2d(1, 8, 3, 4),
      box2d(1, 8, 3, 10),
      box2d(1, 8, 3, 1, 0.25f),
      box2d(1, 8, 3, 1, 0.0625f),
      box2d(1, 8, 3, 10, 0.25f),
      box2d(2, 1, 1),
      box2d(2),
      box2d(2, 8, 3, 4),
      box2d(2, 8, 3, 10, 0.25f),
      box2d(4, 1, 1),
      box2d(4),
      box2d(4, 1, 1, 10),
      box2d(4, 1, 1, 10, 0.25f),
      box2d(8, 1, 1),
      box2d(8, 1, 1, 10),
      box2d(8, 1, 1, 10, 0.25f),
      box2d(16, 1, 1),
      box2d(16, 1, 1, 10, 0.25f),
      box2d(32, 1, 1, 10, 0.25f),
      box2d(32, 1, 1, 10, 0.0625f),
      tuned(1),
      tuned(1, 1, 1),
      tuned(1, 8, 3, 1, 0.25f),
      tuned(2),
      tuned(4),
      tuned(8),
  };
  for (const CEngine& engine : engines)
    if (FindEngine(sweep, engine.m_sName) == std::nullopt)
      for (const unsigned substeps : {1u, 2u, 4u, 8u})
        sweep.push_back(settings(engine.m_sName)(substeps));
  return sweep;
}

namespace {

// Shares of the time of a sweep, for the progress.
constexpr double g_fRestartShare = 0.5, g_fTimingShare = 0.3,
                 g_fProofShare = 1.0 - g_fRestartShare - g_fTimingShare;

void MeasureErrors(const CScene& scene, const std::vector<CEngine>& sweep,
                   const CParameterSweepOptions& options, std::vector<CSetting>& settings) {
  CImpactTrialOptions restart{options, false, false};
  restart.m_stdProgress = [&](double done) { options.m_stdProgress(g_fRestartShare * done); };
  const CImpactTrialResult result = RunImpactTrials(scene, sweep, restart);
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    CSetting& setting = settings[i];
    setting.m_cEngine = sweep[i];
    setting.m_nContacts = result.m_stdContacts.size();
    std::vector<double> errors;
    for (const CContact& contact : result.m_stdContacts) {
      const CEngineContact& c = contact.m_stdEngines[i];
      setting.m_nMissed += c.m_eOutcome == eOutcome::Missed;
      setting.m_nTunneled += !c.HasTurnedBack();
      if (c.m_bCompared || !c.HasTurnedBack())
        errors.push_back(c.HasTurnedBack() ? static_cast<double>(c.m_fDirectionError) : std::numbers::pi);
    }
    if (const CSummary summary = Summarise(std::move(errors)); summary.m_nCount > 0)
      setting.m_fDirectionErrorP95 = summary.m_fP95;
  }
}

void MeasureCosts(const CScene& scene, const CParameterSweepOptions& options,
                  std::vector<CSetting>& settings) {
  std::vector<CEngine> engines;
  for (const CSetting& setting : settings)
    engines.push_back(setting.m_cEngine);
  const std::vector<CCost> costs =
      MeasureCost(scene, engines, options.m_nSeed, options.m_nRepeats, options.m_nBallSteps,
                  [&](double done) { options.m_stdProgress(g_fRestartShare + g_fTimingShare * done); });
  const double steps = 1.0 / static_cast<double>(scene.m_cWorld.m_fTimeStep);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const CMedian& ns = costs[i].m_cNsPerBallStep;
    settings[i].m_cNsPerBallSecond = {ns.m_fMedian * steps,
                                      {ns.m_cInterval.m_fLow * steps, ns.m_cInterval.m_fHigh * steps}};
  }
}

// Goes on with settings, at the same impacts, until each has had m_nConfirmation or a loss.
void Prove(const CScene& scene, const CParameterSweepOptions& options, std::vector<CSetting*> settings) {
  CImpactTrialOptions restart{options, false, false};
  restart.m_nContacts = std::max<std::size_t>(options.m_nContacts, 1);
  restart.m_stdProgress = [&](double share) {
    std::size_t fewest = options.m_nConfirmation;
    for (const CSetting* pSetting : settings)
      fewest = std::min(fewest, pSetting->GetAllContacts());
    const double had = static_cast<double>(fewest) + share * static_cast<double>(restart.m_nContacts);
    const double proven = std::min(1.0, had / static_cast<double>(options.m_nConfirmation));
    options.m_stdProgress(1.0 - g_fProofShare * (1.0 - proven));
  };
  for (restart.m_nSeed = options.m_nSeed + 1;; ++restart.m_nSeed) {
    std::erase_if(settings, [&](const CSetting* pSetting) {
      return pSetting->GetAllContacts() >= options.m_nConfirmation || pSetting->GetAllTunneled() > 0;
    });
    if (settings.empty()) return;
    std::vector<CEngine> engines;
    for (const CSetting* pSetting : settings)
      engines.push_back(pSetting->m_cEngine);
    const CImpactTrialResult result = RunImpactTrials(scene, engines, restart);
    if (result.m_stdContacts.empty()) return;
    for (std::size_t i = 0; i < settings.size(); ++i) {
      settings[i]->m_nConfirmationContacts += result.m_stdContacts.size();
      settings[i]->m_nConfirmationTunneled += MakeTotals(result.m_stdContacts, i).GetTunneled();
    }
  }
}

std::vector<CSetting*> ByCost(std::vector<CSetting>& settings) {
  std::vector<CSetting*> sorted;
  for (CSetting& setting : settings)
    sorted.push_back(&setting);
  std::sort(sorted.begin(), sorted.end(), [](const CSetting* a, const CSetting* b) {
    return a->m_cNsPerBallSecond.m_fMedian < b->m_cNsPerBallSecond.m_fMedian;
  });
  return sorted;
}

// The cheapest setting of each engine that has lost nothing; where it does in the proof, the next one.
void ProveCheapest(const CScene& scene, const CParameterSweepOptions& options,
                   std::vector<CSetting>& settings) {
  std::map<std::string, std::deque<CSetting*>> candidates;
  for (CSetting* pSetting : ByCost(settings))
    if (pSetting->m_cEngine.m_pBackend != nullptr && pSetting->m_nTunneled == 0 && pSetting->m_nContacts > 0)
      candidates[pSetting->m_cEngine.m_sName].push_back(pSetting);
  while (!candidates.empty()) {
    std::vector<CSetting*> cheapest;
    for (const auto& [name, left] : candidates)
      cheapest.push_back(left.front());
    Prove(scene, options, cheapest);
    for (auto it = candidates.begin(); it != candidates.end();) {
      auto& left = it->second;
      const bool hasLost = left.front()->GetAllTunneled() > 0;
      left.pop_front();
      it = hasLost && !left.empty() ? std::next(it) : candidates.erase(it);
    }
  }
}

} // namespace

void MarkFronts(std::vector<CSetting>& settings) {
  const auto mark = [&](auto value, bool CSetting::*pFront) {
    // The reference is no engine that one could choose.
    const auto figure = [&](const CSetting& setting) {
      return setting.m_cEngine.m_sName == g_sExact ? std::optional<double>() : value(setting);
    };
    for (CSetting& setting : settings)
      setting.*pFront =
          figure(setting) && std::none_of(settings.begin(), settings.end(), [&](const CSetting& other) {
            if (!figure(other)) return false;
            const double dc = other.m_cNsPerBallSecond.m_fMedian - setting.m_cNsPerBallSecond.m_fMedian;
            const double df = *figure(other) - *figure(setting);
            return dc <= 0 && df <= 0 && (dc < 0 || df < 0);
          });
  };
  mark([](const CSetting& r) { return r.m_fDirectionErrorP95; }, &CSetting::m_bFrontByError);
  mark(
      [](const CSetting& r) {
        return r.m_nContacts == 0 ? std::optional<double>()
                                  : static_cast<double>(r.m_nTunneled) / static_cast<double>(r.m_nContacts);
      },
      &CSetting::m_bFrontByMisses);
}

CWorkPrecision MeasureWorkPrecision(const CScene& scene, const std::vector<CEngine>& sweep,
                                    const CParameterSweepOptions& options) {
  CWorkPrecision work;
  work.m_stdSettings.resize(sweep.size() + 1);
  CSetting& exact = work.m_stdSettings.back();
  exact.m_cEngine = {g_sExact, nullptr};
  exact.m_fDirectionErrorP95 = 0.0;

  MeasureErrors(scene, sweep, options, work.m_stdSettings);
  exact.m_nContacts = work.m_stdSettings.front().m_nContacts;
  MeasureCosts(scene, options, work.m_stdSettings);

  ProveCheapest(scene, options, work.m_stdSettings);
  MarkFronts(work.m_stdSettings);
  work.m_stdRecommendations = MakeRecommendations(work.m_stdSettings, options.m_nConfirmation);
  options.m_stdProgress(1.0);
  return work;
}

} // namespace Shapes::Compare
