// SPDX-License-Identifier: MIT
// Descriptions of shapes in one expression, shapes of every kind, and how far a place is from one.
#pragma once

#include "Random.h"

#include <Shapes/Shapes.h>

#include <array>
#include <memory>

namespace Shapes {

/// Kinematic, turning so many times a second about a centre.
template <class TDesc>
TDesc Turning(TDesc desc, float revsPerSecond = 0, const Vector2& center = Vector2::Zero()) {
  desc.m_eMotionType = eMotion::Kinematic;
  desc.m_fRotSpeed = revsPerSecond;
  desc.m_vRotCenter = center;
  return desc;
}

/// Solid on these sides.
template <class TDesc>
TDesc Sided(TDesc desc, eSides sides) {
  desc.m_eSides = sides;
  return desc;
}

/// Kinematic, moving along.
template <class TDesc>
TDesc Moving(TDesc desc, const Vector2& vel) {
  desc.m_vVel = vel;
  return Turning(desc);
}

template <class TDesc>
TDesc Filtered(TDesc desc, const CFilter& filter) {
  desc.m_cFilter = filter;
  return desc;
}

/// Detects only.
template <class TDesc>
TDesc Sensor(TDesc desc) {
  desc.m_bIsSensor = true;
  return desc;
}

/// Four walls of a box: at the bottom, on the right, at the top, on the left.
inline std::array<CLineSegDesc, 4> Walls(const Vector2& low, const Vector2& high, float e = 1) {
  const Vector2 right(high.x(), low.y()), left(low.x(), high.y());
  return {CLineSegDesc(low, right, e), CLineSegDesc(right, high, e), CLineSegDesc(left, high, e),
          CLineSegDesc(low, left, e)};
}

inline CCircleDesc MakeZone(const Vector2& p = Vector2::Zero(), float r = 1) {
  return Sensor(CCircleDesc(p, r));
}

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

} // namespace Shapes
