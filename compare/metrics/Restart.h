// SPDX-License-Identifier: MIT
// Restart per contact: the exact reference plays a scene; at each of its impacts every engine is started anew
// from the exact state at the beginning of that step, and what it does is held against the exact impact.
// Whole trajectories would measure chaos. docs/accuracy.md defines every figure.
#pragma once

#include "../Trial.h"
#include "Statistics.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace Shapes::Compare {

enum class eOutcome {
  Correct,   ///< responded in the step of the impact, to the right side
  Late,      ///< responded to the same shape and to the right side, but one or two steps later
  WrongSide, ///< responded, but pushed to the far side
  Missed     ///< no response
};

/// What one engine made of one impact.
struct CEngineContact {
  eOutcome m_eOutcome = eOutcome::Missed;
  bool m_bDetected = false; ///< its CollisionDetected saw the pair at the end of the step
  double m_fSetback = 0.0;  ///< its setback, in radii; only if detected
  double m_fSetbackError =
      0.0; ///< claimed centre at the impact against the exact one, in radii; only if detected
};

/// One impact of the exact reference.
struct CContact {
  std::uint64_t m_nTrial;
  std::size_t m_nStep;
  std::size_t m_nBall;
  std::string m_sPair; ///< "segment", "point", "circle", "arc", "ball" and the part that was met
  double m_fTime;      ///< of the impact, as a share of the step
  double m_fTravel;    ///< way of the ball in the step, in radii
  double m_fApproach;  ///< approach speed, user units per second
  double m_fIncidence; ///< radians between the velocity and the normal
  std::vector<CEngineContact> m_stdEngines;
  double m_fDifference =
      0.0; ///< between the centres that the first two engines claim, in radii; if both detected
  bool m_bHasDifference = false;
};

/// Totals of an engine over all contacts of a scene.
struct CEngineTotals {
  std::size_t m_nMissed = 0, m_nWrongSide = 0, m_nLate = 0;
  CSummary m_cSetback, m_cSetbackError;
  /// The exact ball was turned back and this one went on: missed or wrong side.
  std::size_t GetTunneled() const { return m_nMissed + m_nWrongSide; }
};

struct CRestartResult {
  std::vector<CContact> m_stdContacts;
  std::vector<CEngineTotals> m_stdEngines;
  CSummary m_cDifference;
  std::uint64_t m_nTrials = 0;
  std::size_t m_nResting = 0;   ///< impacts too slow to be called one: not counted
  std::size_t m_nAmbiguous = 0; ///< grazes that are decided by rounding, and overlaps: not counted
};

/// Plays random trials of the scene until there are `contacts` impacts, or until `mostTrials` have been
/// played.
CRestartResult RunRestarts(const CScene& scene, const std::vector<CEngine>& engines, std::uint64_t seed,
                           std::size_t contacts, std::uint64_t mostTrials);

} // namespace Shapes::Compare
