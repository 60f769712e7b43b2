// SPDX-License-Identifier: MIT
// The result of a run: which engine to take in a scene and over all scenes, and what the others cost.
#pragma once

#include "report/Report.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace Shapes::Compare {

/// How good an engine is in a scene.
enum class eGrade { Good, Rough, Poor, Unknown };
/// "good", "rough", "poor", "unknown".
const char* GetName(eGrade grade);

/// The most that a grade allows: share of the balls that are lost, as the lower end of its interval (Wilson,
/// 95%), radians and share by which 95% of the directions and of the speeds after an impact are off. A degree
/// is two centimetres aside for each metre that the ball flies on.
struct CGradeBound {
  double m_fLost, m_fDirection, m_fSpeed;
};
inline constexpr CGradeBound g_cGood{0.001, 1.0 * g_fDegree, 0.1}, g_cRough{0.01, 10.0 * g_fDegree, 0.3};
/// A figure that is not known is not held against an engine.
eGrade GradeOf(std::size_t lost, std::size_t impacts, std::optional<double> direction,
               std::optional<double> speed);
eGrade GradeOf(const CTotals& totals);

/// Whether the times of two engines differ by more than their scatter.
bool AreTimesApart(const CCost& a, const CCost& b);

/// Directions within it are as good as any others, radians: a millimetre aside for each metre.
inline constexpr double g_fSameDirection = 0.001;

/// The engine to take in a scene: of those that lose no more than Box2D and whose directions are no worse,
/// the fastest that has the best grade; the world by default where another one is not measurably faster.
/// Without Box2D, none may be worse than the engine that loses least. None where nothing was judged.
std::optional<std::size_t> FindTake(const CRunReport& report, const CSceneReport& scene);

/// One engine over all scenes with impacts.
struct CEngineOverall {
  std::size_t m_nLost = 0;
  CQuantile m_cDirection;          ///< 95th percentile over all impacts that were compared, radians.
  std::size_t m_nCompared = 0;     ///< how many these are
  double m_fSpeed = 0.0;           ///< The same of the sizes of the relative errors of the speed.
  CInterval m_cDirectionScenes;    ///< The least and the most of the scenes.
  CMedian m_cNs;                   ///< Nanoseconds for a ball-step: geometric mean of the scenes.
  CInterval m_cNsScenes;           ///< The least and the most of the scenes.
  std::optional<CMedian> m_cTimes; ///< The time of Box2D in times of this one: geometric mean of the scenes.
  CInterval m_cTimesScenes;        ///< The least and the most of the scenes.
  bool m_bFront = false;           ///< No other engine is both faster and no less exact.
};

struct COverall {
  std::size_t m_nImpacts = 0, m_nScenes = 0;
  std::vector<CEngineOverall> m_stdEngines;
  std::optional<std::size_t> m_nTake; ///< as FindTake, over all scenes

  eGrade GetGrade(std::size_t e) const;
};

COverall MakeOverall(const CRunReport& report);

} // namespace Shapes::Compare
