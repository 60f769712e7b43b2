// SPDX-License-Identifier: MIT
// The run itself: every measurement on every scene.
#pragma once

#include "Progress.h"
#include "report/Report.h"

#include <functional>
#include <vector>

namespace Shapes::Compare {

/// How much of everything is done in each scene.
struct CRunSizes {
  std::size_t m_nContacts;        ///< impacts at which the engines are restarted
  int m_nRepeats;                 ///< of each timing
  std::size_t m_nBallSteps;       ///< least length of one timing
  std::size_t m_nSweepContacts;   ///< impacts for each setting of the sweep
  std::size_t m_nConfirmation;    ///< impacts without a miss that are called none
  int m_nSweepRepeats;            ///< of each timing of a setting
  std::size_t m_nSweepBallSteps;  ///< least length of one timing of a setting
  std::size_t m_nHeatContacts;    ///< impacts in each cell of the heat map
  std::size_t m_nBounces;         ///< of the long run
  std::size_t m_nLongSteps;       ///< most steps of the long run
  int m_nLastingTrials;           ///< of contact that lasts, where the scene asks for it
  std::size_t m_nFrames;          ///< of the replay from the start
  std::size_t m_nEffectContacts;  ///< impacts for each effect
  int m_nEffectRepeats;           ///< of each timing with an effect, and without
  std::size_t m_nEffectBallSteps; ///< least length of one of them
  std::size_t m_nCountedSteps;    ///< whose instructions are counted with each effect, and without; 0: none

  /// The same with another number of contacts. Fewer make everything else smaller in proportion, but not so
  /// small that nothing comes out; more leave it as it is.
  CRunSizes ForContacts(std::size_t contacts) const;
};

/// The sizes of a usual run, and of a full one, whose figures go into documents.
inline constexpr CRunSizes g_cFullSizes{20000, 11,      50000, 2500, 50000, 7,  3000, 500,
                                        10000, 1000000, 11,    300,  500,   15, 7000, 300};
inline constexpr CRunSizes g_cQuickSizes{2000, 11,    2500, 250, 2000, 5, 500, 30,
                                         1000, 50000, 3,    200, 60,   7, 400, 0};

/// Seconds that a scene takes, measured over those that come with the tool on one core.
inline constexpr double g_fQuickSceneSeconds = 1.3, g_fFullSceneSeconds = 28.0;

/// Trials that are played for each impact that is wanted, before a scene in which little happens is given up.
inline constexpr std::uint64_t g_nTrialsPerContact = 20;

/// Everything that is measured on one scene.
/// @param progress called again and again with the share of a part that is done; what it throws ends it
/// @throws the exception of an engine that cannot hold the scene
CSceneReport RunScene(const CScene& scene, const std::vector<CEngine>& engines, const CRunSizes& sizes,
                      std::uint64_t seed, const std::function<void(eStage, double)>& progress);

/// All scenes, one after the other. CInterrupted, thrown by `check`, ends the run with those that are
/// finished.
/// @param check called often, between pieces of work
/// @param finished called with each scene as it is finished; may be empty
/// @throws std::runtime_error naming the scene that an engine cannot hold
CRunReport RunScenes(const std::vector<CScene>& scenes, const std::vector<CEngine>& engines,
                     const CRunSizes& sizes, std::uint64_t seed, CProgress& progress,
                     const std::function<void()>& check,
                     const std::function<void(const CSceneReport&)>& finished = {});

} // namespace Shapes::Compare
