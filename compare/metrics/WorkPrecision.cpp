// SPDX-License-Identifier: MIT
#include "WorkPrecision.h"

#include "Cost.h"
#include "Restart.h"
#include "Totals.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace Shapes::Compare {

std::vector<CEngine> GetLadder() {
  const std::vector<CEngine> engines = GetEngines();
  const auto settings = [&](std::size_t e) {
    return [engine = engines.at(e)](unsigned substeps, unsigned velocityIterations = 8,
                                    unsigned positionIterations = 3, float scale = 1.0f,
                                    float sagittaFactor = 1.0f) mutable {
      engine.m_nSubsteps = substeps;
      engine.m_nVelocityIterations = velocityIterations;
      engine.m_nPositionIterations = positionIterations;
      engine.m_fScale = scale;
      engine.m_fSagittaFactor = sagittaFactor;
      return engine;
    };
  };
  auto native = settings(0), continuous = settings(1), box2d = settings(2), tuned = settings(3);
  // A substep of Box2D is a whole step of it at a higher rate. Iterations matter where contacts act on each
  // other; the scale shrinks its skin and slop, the sagitta the error of arcs.
  return {
      native(1),
      native(2),
      native(4),
      native(8),
      native(16),
      native(32),
      native(64),
      continuous(1),
      continuous(2),
      continuous(4),
      continuous(8),
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
}

namespace {

// Shares of the time of a ladder, for the progress.
constexpr double g_fRestartShare = 0.5, g_fTimingShare = 0.3;

void MeasureErrors(const CScene& scene, const std::vector<CEngine>& ladder, const CLadderOptions& options,
                   std::vector<CRung>& rungs) {
  CRestartOptions restart;
  restart.m_nSeed = options.m_nSeed;
  restart.m_nContacts = options.m_nContacts;
  restart.m_nMostTrials = options.m_nMostTrials;
  restart.m_bAsk = restart.m_bGhosts = false;
  restart.m_stdProgress = [&](double done) { options.m_stdProgress(g_fRestartShare * done); };
  const CRestartResult result = RunRestarts(scene, ladder, restart);
  for (std::size_t i = 0; i < ladder.size(); ++i) {
    CRung& rung = rungs[i];
    rung.m_cEngine = ladder[i];
    rung.m_nContacts = result.m_stdContacts.size();
    std::vector<double> errors;
    for (const CContact& contact : result.m_stdContacts) {
      const CEngineContact& c = contact.m_stdEngines[i];
      rung.m_nMissed += c.m_eOutcome == eOutcome::Missed;
      rung.m_nTunneled += !c.HasTurnedBack();
      if (c.m_bCompared || !c.HasTurnedBack())
        errors.push_back(c.HasTurnedBack() ? static_cast<double>(c.m_fDirectionError) : std::numbers::pi);
    }
    if (const CSummary summary = Summarise(std::move(errors)); summary.m_nCount > 0)
      rung.m_fDirectionErrorP95 = summary.m_fP95;
  }
}

void MeasureCosts(const CScene& scene, const CLadderOptions& options, std::vector<CRung>& rungs) {
  std::vector<CEngine> engines;
  for (const CRung& rung : rungs)
    engines.push_back(rung.m_cEngine);
  const std::vector<CCost> costs =
      MeasureCost(scene, engines, options.m_nSeed, options.m_nRepeats, options.m_nBallSteps,
                  [&](double done) { options.m_stdProgress(g_fRestartShare + g_fTimingShare * done); });
  const double steps = 1.0 / static_cast<double>(scene.m_cWorld.m_fTimeStep);
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    const CMedian& ns = costs[i].m_cNsPerBallStep;
    rungs[i].m_cNsPerBallSecond = {ns.m_fMedian * steps,
                                   {ns.m_cInterval.m_fLow * steps, ns.m_cInterval.m_fHigh * steps}};
  }
}

// Goes on with a rung until it has had `proof` impacts or a loss.
void Prove(const CScene& scene, const CLadderOptions& options, CRung& rung) {
  CRestartOptions restart;
  restart.m_nContacts = std::max<std::size_t>(options.m_nContacts, 1);
  restart.m_nMostTrials = options.m_nMostTrials;
  restart.m_bAsk = restart.m_bGhosts = false;
  restart.m_stdProgress = [&](double) { options.m_stdProgress(g_fRestartShare + g_fTimingShare); };
  for (restart.m_nSeed = options.m_nSeed + 1;
       rung.GetAllContacts() < options.m_nProof && rung.GetAllTunneled() == 0; ++restart.m_nSeed) {
    const CRestartResult result = RunRestarts(scene, {rung.m_cEngine}, restart);
    if (result.m_stdContacts.empty()) return;
    rung.m_nProofContacts += result.m_stdContacts.size();
    rung.m_nProofTunneled += MakeTotals(result.m_stdContacts, 0).GetTunneled();
  }
}

std::vector<CRung*> ByCost(std::vector<CRung>& rungs) {
  std::vector<CRung*> sorted;
  for (CRung& rung : rungs)
    sorted.push_back(&rung);
  std::sort(sorted.begin(), sorted.end(), [](const CRung* a, const CRung* b) {
    return a->m_cNsPerBallSecond.m_fMedian < b->m_cNsPerBallSecond.m_fMedian;
  });
  return sorted;
}

} // namespace

void MarkFronts(std::vector<CRung>& rungs) {
  const auto mark = [&](auto value, bool CRung::*pFront) {
    // The reference is no engine that one could choose.
    const auto figure = [&](const CRung& rung) {
      return rung.m_cEngine.m_sName == g_sExact ? std::optional<double>() : value(rung);
    };
    for (CRung& rung : rungs)
      rung.*pFront = figure(rung) && std::none_of(rungs.begin(), rungs.end(), [&](const CRung& other) {
                       if (!figure(other)) return false;
                       const double dc =
                           other.m_cNsPerBallSecond.m_fMedian - rung.m_cNsPerBallSecond.m_fMedian;
                       const double df = *figure(other) - *figure(rung);
                       return dc <= 0 && df <= 0 && (dc < 0 || df < 0);
                     });
  };
  mark([](const CRung& r) { return r.m_fDirectionErrorP95; }, &CRung::m_bFrontByError);
  mark(
      [](const CRung& r) {
        return r.m_nContacts == 0 ? std::optional<double>()
                                  : static_cast<double>(r.m_nTunneled) / static_cast<double>(r.m_nContacts);
      },
      &CRung::m_bFrontByMisses);
}

CWorkPrecision MeasureWorkPrecision(const CScene& scene, const std::vector<CEngine>& ladder,
                                    const CLadderOptions& options) {
  CWorkPrecision work;
  work.m_stdRungs.resize(ladder.size() + 1);
  CRung& exact = work.m_stdRungs.back();
  exact.m_cEngine = {g_sExact, nullptr};
  exact.m_fDirectionErrorP95 = 0.0;

  MeasureErrors(scene, ladder, options, work.m_stdRungs);
  exact.m_nContacts = work.m_stdRungs.front().m_nContacts;
  MeasureCosts(scene, options, work.m_stdRungs);

  std::map<std::string, bool> proven;
  for (CRung* pRung : ByCost(work.m_stdRungs)) {
    bool& done = proven[pRung->m_cEngine.m_sName];
    if (done || pRung == &exact || pRung->m_nTunneled > 0 || pRung->m_nContacts == 0) continue;
    Prove(scene, options, *pRung);
    done = pRung->GetAllTunneled() == 0 && pRung->GetAllContacts() >= options.m_nProof;
  }
  MarkFronts(work.m_stdRungs);
  work.m_stdAnswers = MakeAnswers(work.m_stdRungs, options.m_nProof);
  options.m_stdProgress(1.0);
  return work;
}

} // namespace Shapes::Compare
