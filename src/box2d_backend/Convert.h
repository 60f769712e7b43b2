// SPDX-License-Identifier: MIT
// Between the user's units and the metres of Box2D.
#pragma once

// The one header that is in 2.4.1 and later 2.4 only: the version itself is in no header.
#if !__has_include(<box2d/b2_common.h>)
#error "Shapes needs Box2D 2.4, from 2.4.1 on: -DSHAPES_WITH_BOX2D=OFF builds without it."
#endif

#include <Shapes/ShapeMath.h>

#include <box2d/box2d.h>

namespace Shapes::Box2D {

/// Box2D's tolerances are lengths in metres; the length unit (user units per metre) puts the user's scene at
/// the scale for which they were chosen.
class CScale {
public:
  explicit CScale(float unitsPerMetre) : m_fUnit(unitsPerMetre) {}
  float ToMetres(float f) const { return f / m_fUnit; }
  b2Vec2 ToMetres(const Vector2& v) const { return {v.x() / m_fUnit, v.y() / m_fUnit}; }
  float FromMetres(float f) const { return f * m_fUnit; }
  Vector2 FromMetres(const b2Vec2& v) const { return {v.x * m_fUnit, v.y * m_fUnit}; }

private:
  float m_fUnit;
};

inline Eigen::Vector2d ToDouble(const b2Vec2& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}
inline b2Vec2 ToFloat(const Eigen::Vector2d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y())};
}

} // namespace Shapes::Box2D
