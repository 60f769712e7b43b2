// SPDX-License-Identifier: MIT
#include "HeatMap.h"

#include "ImpactTrials.h"
#include "Totals.h"

#include <algorithm>

namespace Shapes::Compare {
namespace {

// The scene with a ball that is `speed` times as fast and `size` times as large. It lasts longer where it is
// slower, so that the ball gets as far.
CScene Vary(CScene scene, double speed, double size) {
  CDynamicCircleDesc& ball = scene.m_stdBalls.front().m_cDesc;
  ball.m_vVel *= static_cast<float>(speed);
  ball.m_fRadius *= static_cast<float>(size);
  scene.m_fDuration = std::max(scene.m_fDuration / static_cast<float>(speed), 2 * scene.m_cWorld.m_fTimeStep);
  return scene;
}

} // namespace

CHeatMap MeasureHeatMap(const CScene& scene, const std::vector<CEngine>& engines, std::uint64_t seed,
                        std::size_t contacts, const std::function<void(double)>& progress) {
  CHeatMap map;
  if (scene.m_stdBalls.size() != 1 || scene.m_stdBalls.front().m_cDesc.m_vVel.isZero()) return map;
  const CDynamicCircleDesc& ball = scene.m_stdBalls.front().m_cDesc;
  map.m_fTravel = static_cast<double>(ball.m_vVel.norm()) * static_cast<double>(scene.m_cWorld.m_fTimeStep) /
                  static_cast<double>(ball.m_fRadius);
  map.m_stdSpeeds = {0.125, 0.25, 0.5, 1, 2, 4};
  map.m_stdSizes = {0.25, 0.5, 1, 2};

  CImpactTrialOptions options;
  options.m_nSeed = seed;
  options.m_nContacts = contacts;
  options.m_nMostTrials = 4 * contacts;
  options.m_bAsk = options.m_bGhosts = false;
  for (const double size : map.m_stdSizes)
    for (const double speed : map.m_stdSpeeds) {
      const double done = static_cast<double>(map.m_stdCells.size());
      const double all = static_cast<double>(map.m_stdSpeeds.size() * map.m_stdSizes.size());
      options.m_stdProgress = [&](double part) { progress((done + part) / all); };
      const CImpactTrialResult result = RunImpactTrials(Vary(scene, speed, size), engines, options);
      CHeatCell cell;
      cell.m_nContacts = result.m_stdContacts.size();
      for (std::size_t e = 0; e < engines.size(); ++e)
        cell.m_stdTunneled.push_back(MakeTotals(result.m_stdContacts, e).GetTunneled());
      map.m_stdCells.push_back(std::move(cell));
    }
  return map;
}

} // namespace Shapes::Compare
