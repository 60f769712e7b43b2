// SPDX-License-Identifier: MIT
// One moment judged: what every engine makes of the impacts in the last step of an exact game.
#pragma once

#include "ImpactTrials.h"
#include "scene/ExactGame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace Shapes::Compare {

/// Product of the elasticities of those who meet in an event of the last step of `game`.
float GetElasticity(const CScene& scene, const CExactGame& game, const CExactEvent<double>& event);

class CAhead;

class CImpactEvaluator {
public:
  /// Scene and engines must live as long.
  /// @param ask also put each pair to CollisionDetected
  CImpactEvaluator(const CScene& scene, const std::vector<CEngine>& engines, bool ask)
      : m_cScene(scene), m_stdEngines(engines), m_bAsk(ask) {}

  /// Appends a contact for each of these events of the last step of `game`, no two of which share a ball.
  /// @throws std::invalid_argument if an engine refuses the state; nothing is appended then
  void Judge(std::uint64_t trial, const CExactGame& game, std::span<const CExactEvent<double>> events,
             std::vector<CContact>& contacts) const;

private:
  CContact Describe(std::uint64_t trial, const CExactGame& game, const CExactEvent<double>& event) const;
  void Run(std::size_t engine, const CExactGame& game, std::span<const CExactEvent<double>> events,
           CAhead& ahead, std::span<CContact> contacts) const;
  void Ask(const CExactGame& game, const CExactEvent<double>& event, CContact& contact) const;

  const CScene& m_cScene;
  const std::vector<CEngine>& m_stdEngines;
  bool m_bAsk;
};

} // namespace Shapes::Compare
