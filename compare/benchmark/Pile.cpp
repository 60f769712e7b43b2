// SPDX-License-Identifier: MIT
#include "Field.h"
#include "Random.h"

#include <cmath>

namespace Shapes::Compare::Benchmark {

CField MakePile(std::size_t balls) {
  constexpr float radius = 0.2f, spacing = 0.47f;
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<float>(balls))));
  const float size = spacing * (static_cast<float>(columns) + 1.0f);
  CRandom between;
  CField field;
  field.m_vSize = {size, 2 * size};
  field.m_fCell = 0.5f;
  field.m_bBullets = false;
  field.m_bMaySleep = true;
  for (const float at : {0.0f, size}) {
    field.m_stdShapes.push_back(CLineSegDesc({0, 2 * at}, {size, 2 * at}));
    field.m_stdShapes.push_back(CLineSegDesc({at, 0}, {at, 2 * size}));
  }
  for (std::size_t i = 0; i < balls; ++i) {
    const Vector2 cell(static_cast<float>(i % columns), static_cast<float>(i / columns));
    const Vector2 jitter(between(-0.03f, 0.03f), between(-0.03f, 0.03f));
    const Vector2 p = spacing * (cell + Vector2(1, 1)) + jitter,
                  v(between(-0.5f, 0.5f), between(-0.5f, 0.5f));
    field.m_stdBalls.emplace_back(p, radius, v, 1.0f, 0.5f);
  }
  return field;
}

} // namespace Shapes::Compare::Benchmark
