// SPDX-License-Identifier: MIT
#include "Effects.h"

#include "ImpactTrials.h"
#include "Instructions.h"
#include "scene/ExactGame.h"

#include <algorithm>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

// Steps after which it is known which effects run in a scene.
constexpr std::size_t g_nLook = 2000;

// Shares of the time, for the progress.
constexpr double g_fImpactShare = 0.3, g_fCostShare = 0.3;

// "Kinematics: runs; 2 shapes move or rotate" is "2 shapes move or rotate".
std::string GetReason(const std::string& explanation, eEffect e) {
  const std::size_t line = explanation.find(std::string(GetName(e)) + ": "),
                    from = explanation.find("; ", line);
  if (line == explanation.npos || from == explanation.npos) throw std::logic_error(explanation);
  return explanation.substr(from + 2, explanation.find('\n', from) - from - 2);
}

// Plays a scene for a while, and notes which effects run where nothing is said of them, and why.
class CLook {
public:
  CLook(const CScene& scene, const CEngine& engine, std::uint64_t seed) {
    for (const eEffect e : g_stdEffects)
      m_stdCosts.push_back({engine.m_sName, e, 0.0, "", {}, {}});
    std::size_t steps = 0;
    for (std::uint64_t trial = 0; steps < g_nLook; ++trial) {
      CGame game(scene, engine, MakeStart(scene, seed, trial));
      if (trial == 0) Note(game.GetWorld(), [](const CEffectCost&) { return true; });
      auto ran = CWorldStats().m_stdSubstepsWith;
      for (std::size_t i = 0; i < GetStepsPerTrial(scene) && steps < g_nLook; ++i, ++steps) {
        game.Step();
        AddStep(game.GetWorld(), ran);
      }
    }
  }
  const std::vector<CEffectCost>& GetCosts() const { return m_stdCosts; }

private:
  // The reason of an effect that runs for the first time is in the world as it is now.
  void AddStep(const CWorld& world, decltype(CWorldStats::m_stdSubstepsWith)& ran) {
    const CWorldStats& stats = world.GetStats();
    const auto before = ran;
    const auto runsNow = [&](const CEffectCost& cost) {
      const auto e = static_cast<std::size_t>(cost.m_eEffect);
      return stats.m_stdSubstepsWith[e] > before[e];
    };
    Note(world, [&](const CEffectCost& cost) { return cost.m_fRuns == 0.0 && runsNow(cost); });
    for (CEffectCost& cost : m_stdCosts) {
      const auto e = static_cast<std::size_t>(cost.m_eEffect);
      cost.m_fRuns += static_cast<double>(stats.m_stdSubstepsWith[e] - before[e]) /
                      static_cast<double>(world.GetDesc().m_nSubsteps) / g_nLook;
    }
    ran = stats.m_stdSubstepsWith;
  }

  template <class T>
  void Note(const CWorld& world, const T& test) {
    std::string explanation; // made only where it is wanted
    for (CEffectCost& cost : m_stdCosts) {
      if (!test(cost)) continue;
      if (explanation.empty()) explanation = world.ExplainEffects();
      cost.m_sWhy = GetReason(explanation, cost.m_eEffect);
    }
  }

  std::vector<CEffectCost> m_stdCosts;
};

// How far the balls of each world are off when the exact game has its first impact.
class CFlights {
public:
  CFlights(const CScene& scene, const std::vector<CEngine>& worlds, const CEffectOptions& options)
      : m_cScene(scene), m_stdWorlds(worlds), m_stdErrors(worlds.size()) {
    const std::uint64_t trials = std::min<std::uint64_t>(options.m_nMostTrials, options.m_nContacts / 5);
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
      PlayTrial(MakeStart(scene, options.m_nSeed, trial));
      options.m_stdProgress(0.0);
    }
  }
  CSummary Summarised(std::size_t world) { return Summarise(std::move(m_stdErrors[world])); }

private:
  void PlayTrial(const CStart& start) {
    CExactGame exact(m_cScene, start);
    std::size_t steps = 0;
    do
      if (!exact.TryStep()) return;
    while (exact.GetEvents().empty() && exact.IsInBounds() && ++steps < GetStepsPerTrial(m_cScene));
    if (exact.GetEvents().empty()) return;
    for (std::size_t i = 0; i < m_stdWorlds.size(); ++i) {
      CGame game(m_cScene, m_stdWorlds[i], start);
      game.SetPutBack(false);
      for (std::size_t step = 0; step < steps; ++step)
        game.Step();
      m_stdErrors[i].push_back(GetError(game.GetWorld(), exact.GetBalls()));
    }
  }

  static double GetError(const CWorld& world, const std::vector<CDynamicCircleDesc>& balls) {
    double error = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i)
      error = std::max(error, static_cast<double>((world.GetBallPositions()[i] - balls[i].m_vPos).norm() /
                                                  balls[i].m_fRadius));
    return error;
  }

  const CScene& m_cScene;
  const std::vector<CEngine>& m_stdWorlds;
  std::vector<std::vector<double>> m_stdErrors;
};

// Whether the world reports that a ball has touched a shape that is a sensor.
bool HasBegun(const CTrialWorld& world, const CExactEvent<double>& event) {
  const auto events = world.m_pWorld->GetSensorEvents();
  const CShapeId shape = world.m_stdShapes[event.m_nShape], ball = world.m_stdBalls[event.m_nBall];
  return std::any_of(events.begin(), events.end(), [&](const CSensorEvent& e) {
    return e.m_bBegin && e.m_cShape == shape && e.m_cBall == ball;
  });
}

// Touches of sensors before which nothing else happened to the ball in this step, and how many of them each
// world, started anew at the beginning of the step, does not report.
class CTouches {
public:
  CTouches(const CScene& scene, const std::vector<CEngine>& worlds, const CEffectOptions& options)
      : m_cScene(scene), m_stdWorlds(worlds), m_cOptions(options), m_stdMissed(worlds.size()) {
    const bool any = std::any_of(scene.m_stdShapes.begin(), scene.m_stdShapes.end(),
                                 [](const CSceneShape& s) { return GetBase(s.m_cDesc).m_bIsSensor; });
    for (std::uint64_t trial = 0; any && trial < options.m_nMostTrials && !HasEnough(); ++trial)
      PlayTrial(trial);
  }
  std::size_t GetTouches() const { return m_nTouches; }
  std::size_t GetMissed(std::size_t world) const { return m_stdMissed[world]; }

private:
  bool HasEnough() const { return m_nTouches >= m_cOptions.m_nContacts; }

  void PlayTrial(std::uint64_t trial) {
    CExactGame game(m_cScene, MakeStart(m_cScene, m_cOptions.m_nSeed, trial));
    for (std::size_t i = 0; i < GetStepsPerTrial(m_cScene) && game.IsInBounds() && !HasEnough(); ++i) {
      if (!game.TryStep()) break;
      if (!game.GetEvents().empty() && game.GetEvents().front().m_bIsSensor) Judge(game);
    }
    m_cOptions.m_stdProgress(0.0);
  }

  void Judge(const CExactGame& game) {
    ++m_nTouches;
    for (std::size_t i = 0; i < m_stdWorlds.size(); ++i) {
      CTrialWorld world(m_cScene, m_stdWorlds[i], game.GetBalls(), game.GetTime());
      world.m_pWorld->Step();
      m_stdMissed[i] += !HasBegun(world, game.GetEvents().front());
    }
  }

  const CScene& m_cScene;
  const std::vector<CEngine>& m_stdWorlds;
  const CEffectOptions& m_cOptions;
  std::size_t m_nTouches = 0;
  std::vector<std::size_t> m_stdMissed;
};

// All worlds at the same impacts, touches and starts.
std::vector<CEffectWorld> MeasureWorlds(const CScene& scene, const std::vector<CEngine>& worlds,
                                        const CEffectOptions& options, CEffectCosts& report) {
  std::vector<CEffectWorld> measured(worlds.size());
  CImpactTrialOptions restart{options, false, false};
  restart.m_stdProgress = [&](double done) { options.m_stdProgress(g_fImpactShare * done); };
  const CTouches touches(scene, worlds, options);
  CFlights flights(scene, worlds, options);
  const CImpactTrialResult result = RunImpactTrials(scene, worlds, restart);
  report.m_nTouches = touches.GetTouches();
  const std::vector<CCost> costs =
      MeasureCost(scene, worlds, options.m_nSeed, options.m_nRepeats, options.m_nBallSteps,
                  [&](double done) { options.m_stdProgress(g_fImpactShare + g_fCostShare * done); });
  const CInstructions counted =
      options.m_nCountedSteps == 0
          ? CInstructions{{}, "only a full run does"}
          : CountInstructions(scene, worlds, options.m_sProgram, options.m_nSeed, options.m_nCountedSteps,
                              [&] { options.m_stdProgress(g_fImpactShare + g_fCostShare); });
  report.m_sNotCounted = counted.m_sWhyNot;
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    measured[i].m_cCost = costs[i];
    measured[i].m_cFlightError = flights.Summarised(i);
    measured[i].m_nTouchesMissed = touches.GetMissed(i);
    if (!worlds[i].m_cEffects.m_cForbidden.Has(eEffect::Events))
      measured[i].m_cTotals = MakeTotals(result.m_stdContacts, i);
    if (counted.m_sWhyNot.empty()) measured[i].m_fInstructions = counted.m_stdPerBallStep.at(i);
  }
  return measured;
}

} // namespace

CEngine WithEffect(CEngine engine, eEffect e, bool forced) {
  engine.m_cEffects = forced ? CEffectChoice{{e}, {}} : CEffectChoice{{}, {e}};
  return engine;
}

CEffectCosts MeasureEffects(const CScene& scene, const std::vector<CEngine>& engines,
                            const CEffectOptions& options) {
  CEffectCosts report;
  std::vector<CEngine> worlds; // of each engine first the one that the scene calls for, then one per effect
  for (const CEngine& engine : engines) {
    const auto isOfIt = [&](const CEngine& world) { return world.m_pBackend == engine.m_pBackend; };
    if (engine.m_cEffects != g_cAutomatic || std::any_of(worlds.begin(), worlds.end(), isOfIt)) continue;
    worlds.push_back(engine);
    const CLook look(scene, engine, options.m_nSeed);
    for (const CEffectCost& cost : look.GetCosts()) {
      worlds.push_back(WithEffect(engine, cost.m_eEffect, !cost.IsCalledFor()));
      report.m_stdCosts.push_back(cost);
    }
  }
  if (worlds.empty()) return report;
  const std::vector<CEffectWorld> measured = MeasureWorlds(scene, worlds, options, report);
  constexpr std::size_t n = std::size(g_stdEffects);
  for (std::size_t i = 0; i < report.m_stdCosts.size(); ++i) {
    CEffectCost& cost = report.m_stdCosts[i];
    const std::size_t called = i / n * (n + 1);
    const CEffectWorld &asCalled = measured[called], &other = measured[called + 1 + i % n];
    cost.m_cWith = cost.IsCalledFor() ? asCalled : other;
    cost.m_cWithout = cost.IsCalledFor() ? other : asCalled;
  }
  return report;
}

} // namespace Shapes::Compare
