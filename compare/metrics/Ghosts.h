// SPDX-License-Identifier: MIT
// Ghosts: responses to what is not touched. They are looked for in quiet steps: the reference has no event,
// and a ball passes something closely.
#pragma once

#include "ImpactTrials.h"
#include "scene/ExactGame.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Shapes::Compare {

class CGhostHunter {
public:
  /// Scene and engines must live as long.
  CGhostHunter(const CScene& scene, const std::vector<CEngine>& engines);

  /// Looks at the last step of the game, once for each ball to which it was quiet. Draws some of them, as
  /// many as there are contacts in the result at most, and judges them: adds to m_nQuietSteps and
  /// m_stdGhosts.
  /// @throws std::invalid_argument if an engine refuses the state; nothing is added then
  void Judge(const CExactGame& game, CImpactTrialResult& result);

private:
  struct CResponse { // what an engine said about a quiet ball
    std::size_t m_nEngine, m_nBall, m_nOther;
    bool m_bIsBall;
  };

  bool IsDrawn(std::size_t contacts);
  bool IsQuiet(const CExactGame& game, std::size_t ball) const;
  void Ask(const CExactGame& game);
  void MarkTouched(const CExactGame& game);
  void CountGhosts(CImpactTrialResult& result);

  const CScene& m_cScene;
  const std::vector<CEngine>& m_stdEngines;
  std::uint64_t m_nSeen = 0;           // quiet steps
  std::vector<std::size_t> m_stdQuiet; // balls
  std::vector<CResponse> m_stdResponses;
};

} // namespace Shapes::Compare
