// SPDX-License-Identifier: MIT
// Shapes of every kind: random ones, and how far a place is from one.
#pragma once

#include "Descs.h"
#include "Random.h"

#include <Shapes/Shapes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace Shapes {

/// Gives f the description of a point, a segment, a circle or an arc at p, of a random extent up to `size`.
/// One arc in eight is a full circle.
template <class F>
auto WithAnyShape(Tests::CRandom& random, std::uint32_t kind, const Vector2& p, float size, F f) {
  const float r = random.Uniform(0.05f * size, size), a0 = random.Uniform(0, 6.28f);
  const float a1 = random.Below(8) == 0 ? a0 : random.Uniform(0, 6.28f);
  switch (kind % 4) {
  case 0: return f(CPointDesc(p));
  case 1: return f(CLineSegDesc(p, p + r * random.Direction()));
  case 2: return f(CCircleDesc(p, r));
  default: return f(CArcDesc(p, r, a0, a1));
  }
}

/// Shapes of all kinds in a square about the origin: some turn about their places, some are sensors, some
/// one-sided.
inline std::vector<CAnyShapeDesc> MakeCrowd(Tests::CRandom& random, std::uint32_t n, float half, float size) {
  std::vector<CAnyShapeDesc> crowd;
  for (std::uint32_t kind = 0; kind < n; ++kind) {
    const Vector2 p = random.InSquare(half);
    WithAnyShape(random, kind, p, size, [&](auto desc) {
      desc.m_fElasticity = random.Uniform(0.5f, 1.1f);
      desc.m_bIsSensor = random.Below(10) == 0;
      if (random.Below(5) == 0) desc = Turning(desc, random.Uniform(-2, 2), p);
      if constexpr (requires { desc.m_eSides; })
        desc.m_eSides = std::array{eSides::Front, eSides::Back, eSides::Both}[std::min(random.Below(6), 2u)];
      crowd.emplace_back(desc);
    });
  }
  return crowd;
}

/// Such a shape, static.
inline std::unique_ptr<CShape> MakeAnyShape(Tests::CRandom& random, std::uint32_t kind, const Vector2& p,
                                            float size) {
  return WithAnyShape(random, kind, p, size, [](const auto& desc) { return MakeShape(desc); });
}

/// How far p is from the curve of a shape, by the shape's own closest point: within some ulp.
inline float DistanceFrom(const CShape& shape, const Vector2& p) {
  switch (shape.GetShapeType()) {
  case eShape::LineSeg: return Length(p - static_cast<const CLineSeg&>(shape).ClosestPt(p));
  case eShape::Arc: return Length(p - static_cast<const CArc&>(shape).ClosestPt(p));
  case eShape::Circle: return Length(p - static_cast<const CCircle&>(shape).ClosestPt(p));
  default: return Length(p - shape.GetPos());
  }
}

/// The same to a sensor, as which a circle is a disk: negative in it.
inline float SensedDistanceFrom(const CShape& shape, const Vector2& p) {
  if (shape.GetShapeType() != eShape::Circle) return DistanceFrom(shape, p);
  return Length(p - shape.GetPos()) - static_cast<const CCircle&>(shape).GetRadius();
}

} // namespace Shapes
