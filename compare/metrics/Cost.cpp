// SPDX-License-Identifier: MIT
#include "Cost.h"

#include <chrono>
#include <cmath>

namespace Shapes::Compare {

std::vector<CCost> MeasureCost(const CScene& scene, const std::vector<CEngine>& engines, std::uint64_t seed,
                               int repeats, std::size_t ballSteps) {
  const double dt = scene.m_cWorld.m_fTimeStep;
  const auto stepsPerTrial = static_cast<std::size_t>(std::ceil(static_cast<double>(scene.m_fDuration) / dt));
  const std::size_t balls = scene.m_stdBalls.size();
  std::vector<CCost> costs(engines.size());
  std::vector<std::vector<double>> ns(engines.size());
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (std::size_t e = 0; e < engines.size(); ++e) {
      // The same starts for every engine in this repeat, others in the next.
      std::chrono::steady_clock::duration elapsed{};
      std::size_t done = 0;
      for (std::uint64_t trial = 0; done < ballSteps; ++trial) {
        CGame game(scene, engines[e],
                   MakeStart(scene, seed, static_cast<std::uint64_t>(repeat) * 1000003u + trial));
        const std::size_t steps = std::min(stepsPerTrial, (ballSteps - done) / balls + 1);
        const auto begin = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < steps; ++i)
          game.Step();
        elapsed += std::chrono::steady_clock::now() - begin;
        done += steps * balls;
        costs[e].m_fSimulatedSeconds += static_cast<double>(steps) * dt;
        costs[e].m_nEscaped += game.GetEscaped();
        costs[e].m_nNotFinite += game.GetNotFinite();
      }
      ns[e].push_back(std::chrono::duration<double, std::nano>(elapsed).count() / static_cast<double>(done));
    }
  for (std::size_t e = 0; e < engines.size(); ++e)
    costs[e].m_cNsPerBallStep = MedianWithInterval(ns[e]);
  return costs;
}

} // namespace Shapes::Compare
