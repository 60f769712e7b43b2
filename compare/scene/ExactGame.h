// SPDX-License-Identifier: MIT
// A scene that the exact reference plays, step by step: flippers flip and drained balls start again, as in
// CGame.
#pragma once

#include "Trial.h"
#include "reference/Reference.h"

#include <cstddef>
#include <vector>

namespace Shapes::Compare {

class CExactGame {
public:
  /// @throws std::invalid_argument if the scene is not valid
  CExactGame(const CScene& scene, const CStart& start);

  /// One step, from the state that the balls have then: rounded to float, because that is what engines can be
  /// given.
  /// @throws std::runtime_error naming the place, if the reference cannot decide what happens
  void Step();
  /// The same. @returns false, and no more can be played, if it cannot decide
  bool TryStep();

  /// The number of steps so far.
  std::size_t GetSteps() const { return m_nSteps; }
  /// The balls at the beginning of the last step, and the scene time then.
  const std::vector<CDynamicCircleDesc>& GetBalls() const { return m_stdBalls; }
  double GetTime() const { return m_fTime; }
  /// The events of the last step.
  const std::vector<CExactEvent<double>>& GetEvents() const { return m_stdEvents; }
  /// The state at the end of the last step.
  const CReference<double>& GetReference() const { return m_cReference; }
  /// Whether all balls are within the bounds of the scene.
  bool IsInBounds() const;

private:
  const CScene& m_cScene;
  CStart m_cStart;
  CReference<double> m_cReference;
  std::vector<CDynamicCircleDesc> m_stdBalls;
  std::vector<CExactEvent<double>> m_stdEvents;
  std::size_t m_nSteps = 0;
  double m_fTime, m_fNextTime;
};

} // namespace Shapes::Compare
