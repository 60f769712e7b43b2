// SPDX-License-Identifier: MIT
#include "Field.h"
#include "Random.h"

#include <cmath>

namespace Shapes::Compare::Benchmark {

CField MakePegField(std::size_t balls) {
  constexpr int side = 45;
  constexpr float spacing = 1.2f, size = side * spacing;
  CRandom between;
  CField field;
  field.m_vSize = {size, size};
  auto& shapes = field.m_stdShapes;
  for (const float at : {0.0f, size}) {
    shapes.push_back(CLineSegDesc({0, at}, {size, at}));
    shapes.push_back(CLineSegDesc({at, 0}, {at, size}));
  }
  for (int i = 0; i < side * side; ++i) {
    const Vector2 cell(static_cast<float>(i % side), static_cast<float>(i / side));
    const Vector2 jitter(between(-0.2f, 0.2f), between(-0.2f, 0.2f));
    const Vector2 p = spacing * (cell + Vector2(0.5f, 0.5f)) + jitter;
    const float angle = between(0.0f, 6.28f), kind = between(0.0f, 1.0f);
    if (kind < 0.5f)
      shapes.push_back(CCircleDesc(p, 0.15f));
    else if (kind < 0.8f) {
      const Vector2 half = 0.3f * Vector2(std::cos(angle), std::sin(angle));
      shapes.push_back(CLineSegDesc(p - half, p + half));
    } else
      shapes.push_back(CArcDesc(p, 0.3f, angle, angle + 3.0f));
  }
  for (std::size_t i = 0; i < balls; ++i) {
    const Vector2 p(between(0.3f, size - 0.3f), between(0.3f, size - 0.3f));
    CDynamicCircleDesc ball(p, 0.1f, {between(-1, 1), between(-1, 1)});
    ball.m_fElasticity = 0.5f;
    field.m_stdBalls.push_back(ball);
  }
  return field;
}

} // namespace Shapes::Compare::Benchmark
