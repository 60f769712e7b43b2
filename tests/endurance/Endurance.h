// SPDX-License-Identifier: MIT
// A scene that is played for long, and what must not change by that. docs/testing.md derives the bounds.
#pragma once

#include "Played.h"

#include <cstddef>
#include <functional>

namespace Shapes::Tests {

/// The memory that the program holds: its operator new and delete count. Blocks that are allocated now (a
/// vector that grows stays one block, a leak does not), bytes in them, and blocks that were ever allocated.
std::size_t CountLiveBlocks();
std::size_t CountLiveBytes();
std::size_t CountAllocations();

struct CFigures {
  std::size_t m_nSteps = 0;
  std::size_t m_nContacts = 0;
  std::size_t m_nPairContacts = 0; ///< of two balls
  std::size_t m_nDrained = 0;
  std::size_t m_nEscaped = 0;
  float m_fFastest = 0.0f; ///< the highest speed of a ball after a step
  double m_fSeconds = 0.0; ///< that it took

  /// Of the kinetic energy of all balls, relative; and the most that hits of balls can make it by rounding.
  double m_fEnergyDrift = 0.0, m_fEnergyBound = 0.0;
  /// Sum of what steps without a contact changed of the energy that they keep, for mass 1; and the most that
  /// is rounding.
  double m_fFlightDrift = 0.0, m_fFlightBound = 0.0;
  /// How far apart the mean kinetic energies of the first and the second half are, in standard deviations.
  double m_fHalvesApart = 0.0;

  /// More than after the first tenth, at most.
  std::ptrdiff_t m_nBlocksMore = 0, m_nBytesMore = 0;
  std::size_t m_nBlocks = 0, m_nBytes = 0; ///< after the first tenth

  /// Whether a game that was loaded from what was saved in the middle went on with the same bits.
  bool m_bSameAfterLoad = false;
};

/// What controls do to a run.
struct CMeddling {
  std::function<void(CPlayed&, std::size_t step)> m_Before; ///< each step
  std::function<void(CPlayed&)> m_Loaded;                   ///< the game that was loaded
};

/// @param steps  200 at least
CFigures Endure(const Compare::CScene& scene, const CEffectChoice& effects, std::size_t steps,
                const CMeddling& meddling = {});

} // namespace Shapes::Tests
