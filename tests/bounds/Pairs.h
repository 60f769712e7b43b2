// SPDX-License-Identifier: MIT
// A ball, and a shape or another ball that it overlaps or almost touches: what a pair kernel is asked.
#pragma once

#include "Inputs.h"

#include "native/narrowphase/Collide.h"

namespace Shapes::Bounds {

enum class eKind { Point, LineSeg, Circle, Arc, Ball };

struct CPair {
  CAnyShapeDesc m_cShape; ///< Static, or a ball.
  Native::CBall m_cBall;
};

/// By the kernel of the pair.
inline bool Meets(const CPair& pair, Native::CHit& hit) {
  if (const auto* pBall = std::get_if<CDynamicCircleDesc>(&pair.m_cShape))
    return CollideBallBall({pBall->m_vPos, pBall->m_vPos, pBall->m_vVel, pBall->m_fRadius}, pair.m_cBall,
                           hit);
  return Collide(*MakeShape(pair.m_cShape), pair.m_cBall, hit);
}

/// A gap between a centre and a shape for a ball of radius r: any, almost touching, or almost none.
inline float AnyGap(auto& random, float r) {
  switch (random.Below(4)) {
  case 0: return r * NearOne(random);
  case 1: return r * random.Scale(-30, -1);
  default: return r * random.Uniform(0.0f, 1.3f);
  }
}

/// A part of a curve, and a bit more on either side: any, or next to an end.
inline float AnyShare(auto& random) {
  if (random.Below(3) > 0) return random.Uniform(-0.1f, 1.1f);
  const float off = random.SignedScale(-24, -10);
  return random.Coin() ? off : 1.0f - off;
}

/// The ball has not moved in this step, and has any velocity.
inline CPair AnyPair(auto& random, eKind kind) {
  const auto pair = [&](const CAnyShapeDesc& shape, const Vector2& p, float r) {
    return CPair{shape, {p, p, AnyWay(random, AnySize(random)), r}};
  };
  const float side = random.Coin() ? 1.0f : -1.0f;
  if (kind == eKind::LineSeg) {
    const CLineSegDesc seg = AnySegment(random);
    const Vector2 v = seg.GetEndPt1() - seg.GetEndPt0();
    const float r = random.Scale(-10, 6) * Length(v), gap = side * AnyGap(random, r);
    return pair(seg, seg.GetEndPt0() + AnyShare(random) * v + gap * seg.GetNormal(), r);
  }
  const float R = AnySize(random), r = R * (random.Below(3) > 0 ? random.Scale(-10, 8) : NearOne(random));
  const Vector2 c = AnyPlace(random, kind == eKind::Point ? r : R);
  const float gap = AnyGap(random, kind == eKind::Ball ? R + r : r), away = std::abs(R + side * gap);
  if (kind == eKind::Point) return pair(CPointDesc(c), c + AnyWay(random, gap), r);
  if (kind == eKind::Ball) {
    const CDynamicCircleDesc other(c, R, AnyWay(random, AnySize(random)));
    return pair(other, c + AnyWay(random, gap), r);
  }
  if (kind == eKind::Circle) return pair(CCircleDesc(c, R), c + AnyWay(random, away), r);
  const float a0 = AnyAngle(random), a1 = random.Below(8) == 0 ? a0 : AnyAngle(random);
  const CArcDesc arc(c, R, a0, a1);
  const float angle = arc.GetAngle0() + AnyShare(random) * CArc(arc).GetSpan();
  return pair(arc, c + away * AngleToVector(angle), r);
}

} // namespace Shapes::Bounds
