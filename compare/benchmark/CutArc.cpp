// SPDX-License-Identifier: MIT
#include "Field.h"

#include <cmath>

namespace Shapes::Compare::Benchmark {

std::vector<Vector2> CutArc(const CArcDesc& arc) {
  float span = arc.GetAngle1() - arc.GetAngle0();
  if (span <= 0.0f) span += 2.0f * g_fPi; // both angles are within one turn
  const float most = 2.0f * std::acos(1.0f - g_fSagitta / arc.m_fRadius);
  const int pieces = static_cast<int>(std::ceil(span / most));
  std::vector<Vector2> ends;
  for (int i = 0; i <= pieces; ++i) {
    const float angle = arc.GetAngle0() + span * static_cast<float>(i) / static_cast<float>(pieces);
    ends.emplace_back(arc.m_vPos + arc.m_fRadius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return ends;
}

} // namespace Shapes::Compare::Benchmark
