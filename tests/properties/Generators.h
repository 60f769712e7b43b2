// SPDX-License-Identifier: MIT
// Inputs for the properties. They seek the hard region: steep and flat directions, neighbours, wrap-around
// angles, denormals, sizes of 1e-6 to 1e6, and places far from the origin. Each shrinks to a simpler one:
// toward sizes of 1, the origin, and the first of several kinds.
#pragma once

#include "../Testing.h"

#include <rapidcheck.h>

namespace Shapes {

// How RapidCheck prints a counterexample: with all digits, in hexadecimal.
inline void showValue(const CLineSegDesc& d, std::ostream& out) {
  out << std::hexfloat << "segment (" << d.GetEndPt0().x() << ", " << d.GetEndPt0().y() << ") - ("
      << d.GetEndPt1().x() << ", " << d.GetEndPt1().y() << ")";
}
inline void showValue(const CCircleDesc& d, std::ostream& out) {
  out << std::hexfloat << "circle (" << d.m_vPos.x() << ", " << d.m_vPos.y() << "), radius " << d.m_fRadius;
}
inline void showValue(const CArcDesc& d, std::ostream& out) {
  showValue(static_cast<const CCircleDesc&>(d), out);
  out << ", arc from " << d.GetAngle0() << " to " << d.GetAngle1();
}

} // namespace Shapes

namespace Shapes::Properties {

/// An integer of either sign, toward 0.
inline rc::Gen<int> Whole(int most) {
  return rc::gen::map(rc::gen::inRange(0, 2 * most + 1), [](int k) { return k % 2 ? (k + 1) / 2 : -k / 2; });
}
/// In [0, 1), a multiple of 2^-20.
inline rc::Gen<float> Unit() {
  return rc::gen::map(rc::gen::inRange(0, 1 << 20),
                      [](int k) { return std::ldexp(static_cast<float>(k), -20); });
}
inline rc::Gen<float> Between(float least, float most) {
  return rc::gen::map(Unit(), [=](float share) { return least + share * (most - least); });
}
/// A positive number whose binary exponent is up to `most` in size.
inline rc::Gen<float> Scale(int most) {
  return rc::gen::apply([](int exponent, float more) { return std::ldexp(1.0f + more, exponent); },
                        Whole(most), Unit());
}
/// 1e-6 to 1e6.
inline rc::Gen<float> AnySize() { return Scale(19); }
/// Of either sign, and as small as 2^-least.
inline rc::Gen<float> Small(int least, int most) {
  return rc::gen::apply(
      [](int exponent, float more, bool negative) {
        const float f = std::ldexp(1.0f + more, -exponent);
        return negative ? -f : f;
      },
      rc::gen::inRange(most, least + 1), Unit(), rc::gen::arbitrary<bool>());
}
/// Close to 1: by an ulp up to a few percent.
inline rc::Gen<float> NearOne() {
  return rc::gen::map(Small(23, 5), [](float off) { return 1.0f + off; });
}

/// A vector of that length: along an axis, of any direction, or next to an axis.
inline rc::Gen<Vector2> Way(float length) {
  const rc::Gen<Vector2> axis = rc::gen::map(rc::gen::inRange(0, 4), [=](int quarter) {
    const Vector2 axes[] = {{length, 0.0f}, {0.0f, length}, {-length, 0.0f}, {0.0f, -length}};
    return axes[quarter];
  });
  const rc::Gen<Vector2> any =
      rc::gen::map(Between(0.0f, g_fTwoPi), [=](float a) { return Vector2(length * AngleToVector(a)); });
  const rc::Gen<Vector2> beside = rc::gen::apply(
      [=](float off, bool steep, bool back) {
        const float along = back ? -length : length;
        return steep ? Vector2(off * length, along) : Vector2(along, off * length);
      },
      Small(40, 3), rc::gen::arbitrary<bool>(), rc::gen::arbitrary<bool>());
  return rc::gen::oneOf(axis, any, any, beside);
}

/// Around the origin, or up to 2^16 sizes from it, 1e6 at most.
inline rc::Gen<Vector2> Place(float size) {
  const rc::Gen<Vector2> near = rc::gen::apply(
      [=](float x, float y) { return Vector2(4.0f * size * Vector2(x - 0.5f, y - 0.5f)); }, Unit(), Unit());
  const rc::Gen<Vector2> far = rc::gen::mapcat(
      rc::gen::inRange(1, 16), [=](int exponent) { return Way(std::min(1e6f, std::ldexp(size, exponent))); });
  return rc::gen::oneOf(rc::gen::just(Vector2(Vector2::Zero())), near, far);
}

/// Any, next to a multiple of a quarter turn, tiny, or some turns away.
inline rc::Gen<float> Angle() {
  const rc::Gen<float> quarter = rc::gen::apply(
      [](int quarters, int ulps) {
        float a = static_cast<float>(quarters) * (g_fPi / 2.0f);
        for (; ulps != 0; ulps += ulps < 0 ? 1 : -1)
          a = std::nextafter(a, ulps < 0 ? -10.0f : 10.0f);
        return a;
      },
      Whole(5), Whole(4));
  return rc::gen::oneOf(Between(0.0f, g_fTwoPi), Small(30, 5), quarter, Between(-100.0f, 100.0f));
}

inline rc::Gen<CLineSegDesc> Segment() {
  return rc::gen::mapcat(AnySize(), [](float size) {
    return rc::gen::apply([](const Vector2& p, const Vector2& v) { return CLineSegDesc(p, p + v); },
                          Place(size), Way(size));
  });
}
inline rc::Gen<CCircleDesc> Ring() {
  return rc::gen::mapcat(AnySize(), [](float r) {
    return rc::gen::map(Place(r), [=](const Vector2& p) { return CCircleDesc(p, r); });
  });
}
/// Of any span, and with spans next to none, to half a turn and to a whole one.
inline rc::Gen<CArcDesc> AnyArc() {
  const rc::Gen<float> half = rc::gen::map(NearOne(), [](float one) { return one * g_fPi; });
  return rc::gen::apply([](const CCircleDesc& ring, float a0,
                           float span) { return CArcDesc(ring.m_vPos, ring.m_fRadius, a0, a0 + span); },
                        Ring(), Angle(), rc::gen::oneOf(Angle(), half, Small(20, 2)));
}

} // namespace Shapes::Properties
