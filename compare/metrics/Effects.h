// SPDX-License-Identifier: MIT
// Cost and use of each effect in a scene: the world as the scene calls for it, against the same world with
// one effect forced or forbidden.
#pragma once

#include "Cost.h"
#include "ImpactTrials.h"
#include "Totals.h"

#include <optional>
#include <string>
#include <vector>

namespace Shapes::Compare {

/// A world with an effect, or without it.
struct CEffectWorld {
  CCost m_cCost;
  std::optional<double> m_fInstructions; ///< For a step of a ball; absent where they were not counted.
  /// Totals of the impacts. Empty where Events are forbidden, because none is reported then.
  CTotals m_cTotals;
  /// Distance of its balls from the exact ones at the beginning of the step in which the exact game has its
  /// first impact, in radii: the largest of each trial.
  CSummary m_cFlightError;
  std::size_t m_nTouchesMissed = 0; ///< Of CEffectCosts::m_nTouches: touches without a reported begin.
};

/// One effect on one engine. One of both worlds is the one that the scene calls for.
struct CEffectCost {
  std::string m_sEngine;
  eEffect m_eEffect;
  double m_fRuns = 0.0; ///< Share of the substeps in which it runs where nothing is forced or forbidden.
  std::string m_sWhy;   ///< CWorld::ExplainEffects, when it first runs, or at the start if it does not.
  CEffectWorld m_cWith, m_cWithout;

  bool IsCalledFor() const { return m_fRuns > 0.0; }
  /// How many times the time of a step without it a step with it takes.
  CMedian GetRatio() const { return CompareCosts(m_cWith.m_cCost, m_cWithout.m_cCost); }
};

struct CEffectCosts {
  std::vector<CEffectCost> m_stdCosts; ///< Engine by engine, each with all effects in their order.
  std::size_t m_nTouches = 0;          ///< Of sensors by balls of the reference.
  std::string m_sNotCounted;           ///< Why no instructions were counted; empty if they were.
};

/// As many touches of sensors as impacts.
struct CEffectOptions : CTrials {
  int m_nRepeats = 1;              ///< of each timing
  std::size_t m_nBallSteps = 0;    ///< least length of one timing
  std::size_t m_nCountedSteps = 0; ///< whose instructions are counted; 0: none
  std::string m_sProgram;          ///< what can be called as in Instructions.h
};

/// The engine with one effect forced, or forbidden, and nothing said of the others.
CEngine WithEffect(CEngine engine, eEffect e, bool forced);

/// Measures of each backend the first among `engines` that leaves the choice of effects to the scene: native,
/// and Box2D as it ships.
CEffectCosts MeasureEffects(const CScene& scene, const std::vector<CEngine>& engines,
                            const CEffectOptions& options);

} // namespace Shapes::Compare
