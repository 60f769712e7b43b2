// SPDX-License-Identifier: MIT
// Inputs that seek the hard region: sizes of 1e-6 to 1e6, steep and flat directions, far from the origin, and
// floats that are neighbours. They are made of the numbers of a CRandom, or of those that RapidCheck draws.
#pragma once

#include "../Testing.h"

namespace Shapes::Bounds {

/// 1e-6 to 1e6.
inline float AnySize(auto& random) { return random.Scale(-20, 19); }

/// A vector of that length: of any direction, along an axis, or next to one.
inline Vector2 AnyWay(auto& random, float length) {
  switch (random.Below(4)) {
  case 0: {
    const Vector2 axes[] = {{length, 0.0f}, {-length, 0.0f}, {0.0f, length}, {0.0f, -length}};
    return axes[random.Below(4)];
  }
  case 1: {
    const float aside = length * random.SignedScale(-40, -3);
    const float along = random.Coin() ? length : -length;
    return random.Coin() ? Vector2(aside, along) : Vector2(along, aside);
  }
  default: return length * random.Direction();
  }
}

/// A place for something of that size: around the origin, or up to 2^16 sizes from it, 1e6 at most.
inline Vector2 AnyPlace(auto& random, float size) {
  switch (random.Below(4)) {
  case 0: return Vector2::Zero();
  case 1: return random.InSquare(4.0f * size);
  default: {
    const float away = std::min(1e6f, size * random.Scale(0, 15));
    return AnyWay(random, away);
  }
  }
}

/// A size, a place for something of it, and one as far from that.
struct CPlaces {
  float m_fSize;
  Vector2 m_vPos, m_vOther;
};
inline CPlaces AnyPlaces(auto& random) {
  const float size = AnySize(random);
  const Vector2 p = AnyPlace(random, size);
  return {size, p, p + AnyWay(random, size)};
}

/// A number close to 1: within a few ulps up to a few percent.
inline float NearOne(auto& random) { return 1.0f + random.SignedScale(-23, -5); }

/// Up to n floats further.
inline float Neighbour(auto& random, float f, int n) {
  const float toward =
      random.Coin() ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
  for (std::uint32_t k = random.Below(static_cast<std::uint32_t>(n) + 1); k > 0; --k)
    f = std::nextafter(f, toward);
  return f;
}
inline Vector2 Neighbour(auto& random, const Vector2& v, int n) {
  const float x = Neighbour(random, v.x(), n); // named, because the order of arguments is not fixed
  const float y = Neighbour(random, v.y(), n);
  return {x, y};
}

/// An angle: any, next to a multiple of a quarter turn, tiny, or some turns away.
inline float AnyAngle(auto& random) {
  switch (random.Below(4)) {
  case 0: return random.SignedScale(-30, -5);
  case 1: {
    const float quarters = static_cast<float>(random.Below(9)) - 2.0f;
    return Neighbour(random, quarters * (g_fPi / 2.0f), 4);
  }
  case 2: return random.SignedScale(3, 10);
  default: return random.Uniform(0.0f, g_fTwoPi);
  }
}

inline CLineSegDesc AnySegment(auto& random) {
  const auto [size, p0, p1] = AnyPlaces(random);
  return CLineSegDesc(p0, p1);
}

/// Of any span, short ones, about half a turn, and all but a full one.
inline CArcDesc AnyArc(auto& random) {
  const float r = AnySize(random);
  const Vector2 c = AnyPlace(random, r);
  const float a0 = AnyAngle(random), half = g_fPi * NearOne(random);
  const float spans[] = {AnyAngle(random), random.SignedScale(-20, -2), half, -half};
  return CArcDesc(c, r, a0, a0 + spans[random.Below(4)]);
}

} // namespace Shapes::Bounds
