// SPDX-License-Identifier: MIT
#include "Cost.h"

#include "Stopwatch.h"
#include "scene/ExactGame.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

// One trial, or the beginning of it.
struct CPlay {
  std::chrono::nanoseconds m_cElapsed{};
  std::size_t m_nSteps = 0;
  std::size_t m_nContacts = 0, m_nEscaped = 0, m_nNotFinite = 0;
};

CPlay PlayEngine(const CScene& scene, const CEngine& engine, const CStart& start, std::size_t steps) {
  CGame game(scene, engine, start);
  const CStopwatch stopwatch;
  for (std::size_t i = 0; i < steps; ++i)
    game.Step();
  return {stopwatch.GetElapsed(), steps, static_cast<std::size_t>(game.GetWorld().GetStats().m_nContacts),
          game.GetEscaped(), game.GetNotFinite()};
}

CPlay PlayExact(const CScene& scene, const CStart& start, std::size_t steps) {
  CPlay play;
  CExactGame game(scene, start);
  const CStopwatch stopwatch;
  while (play.m_nSteps < steps && game.IsInBounds()) {
    ++play.m_nSteps; // one that cannot be decided has taken its time too
    if (!game.TryStep()) break;
    play.m_nContacts += static_cast<std::size_t>(
        std::count_if(game.GetEvents().begin(), game.GetEvents().end(),
                      [](const CExactEvent<double>& event) { return !event.m_bIsSensor; }));
  }
  play.m_cElapsed = stopwatch.GetElapsed();
  return play;
}

} // namespace

std::optional<double> CCost::GetNsPerContact() const {
  if (m_nContacts == 0) return std::nullopt;
  return m_cNsPerBallStep.m_fMedian * static_cast<double>(m_nBallSteps) / static_cast<double>(m_nContacts);
}

std::vector<double> GetRatios(const CCost& a, const CCost& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(a.m_stdRepeats.size(), b.m_stdRepeats.size()); ++i)
    ratios.push_back(a.m_stdRepeats[i] / b.m_stdRepeats[i]);
  return ratios;
}

CMedian CompareCosts(const CCost& a, const CCost& b) { return MedianWithInterval(GetRatios(a, b)); }

std::vector<CCost> MeasureCost(const CScene& scene, const std::vector<CEngine>& engines, std::uint64_t seed,
                               int repeats, std::size_t ballSteps,
                               const std::function<void(double)>& progress) {
  const double dt = scene.m_cWorld.m_fTimeStep;
  const std::size_t stepsPerTrial = GetStepsPerTrial(scene);
  const std::size_t balls = scene.m_stdBalls.size();
  std::vector<CCost> costs(engines.size());
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (std::size_t turn = 0; turn < engines.size(); ++turn) {
      // Another one begins each time: the first of a kind finds nothing in the caches.
      const std::size_t e = (turn + static_cast<std::size_t>(repeat)) % engines.size();
      // The same starts for every engine in this repeat, others in the next.
      std::chrono::nanoseconds elapsed{};
      std::size_t done = 0;
      for (std::uint64_t trial = 0; done < ballSteps; ++trial) {
        const CStart start = MakeStart(scene, seed, static_cast<std::uint64_t>(repeat) * 1000003u + trial);
        const std::size_t steps = std::min(stepsPerTrial, (ballSteps - done) / balls + 1);
        const CPlay play = engines[e].m_pBackend == nullptr ? PlayExact(scene, start, steps)
                                                            : PlayEngine(scene, engines[e], start, steps);
        elapsed += play.m_cElapsed;
        done += std::max<std::size_t>(play.m_nSteps, 1) * balls;
        costs[e].m_fSimulatedSeconds += static_cast<double>(play.m_nSteps) * dt;
        costs[e].m_nContacts += play.m_nContacts;
        costs[e].m_nEscaped += play.m_nEscaped;
        costs[e].m_nNotFinite += play.m_nNotFinite;
      }
      costs[e].m_nBallSteps += done;
      costs[e].m_stdRepeats.push_back(static_cast<double>(elapsed.count()) / static_cast<double>(done));
      if (progress)
        progress((repeat + static_cast<double>(turn + 1) / static_cast<double>(engines.size())) / repeats);
    }
  for (CCost& cost : costs)
    cost.m_cNsPerBallStep = MedianWithInterval(cost.m_stdRepeats);
  return costs;
}

} // namespace Shapes::Compare
