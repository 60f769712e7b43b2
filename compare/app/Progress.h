// SPDX-License-Identifier: MIT
// How far a run is: one line on a terminal that is written over and over.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace Shapes::Compare {

/// The parts of the work on one scene, in their order.
enum class eStage { ImpactTrials, ParameterSweep, Timing, HeatMap, Effects, LongRuns, Lasting, Replay };

/// The share of a scene's time that is over when `share` of a part is, in [0, 1]. By rough experience.
double ShareOfScene(eStage part, double share);

/// "3/15 pinball  impacts 42%  about 2 min left".
/// @param scene from 0  @param seconds since the start of the run; the rest is guessed from it after the
/// first few
std::string ProgressText(std::size_t scene, std::size_t scenes, const std::string& name, eStage part,
                         double share, double seconds);

class CProgress {
public:
  /// @param shown whether anything is written: where the standard error is a terminal
  CProgress(std::size_t scenes, bool shown);
  ~CProgress() { Clear(); }
  CProgress(const CProgress&) = delete;
  CProgress& operator=(const CProgress&) = delete;

  void BeginScene(std::size_t scene, const std::string& name);
  void Report(eStage part, double share);
  /// Takes the line away.
  void Clear();

private:
  std::size_t m_nScenes;
  bool m_bShown;
  std::size_t m_nScene = 0;
  std::string m_sName;
  std::chrono::steady_clock::time_point m_cStart;
  std::chrono::steady_clock::time_point m_cLast;
  bool m_bIsOnScreen = false;
};

} // namespace Shapes::Compare
