// SPDX-License-Identifier: MIT
// Random values at the borders of what the interface takes, and of what Box2D bears.
#pragma once

#include "Box2DTesting.h"
#include "box2d_backend/world/Tuning.h"

#include <array>

namespace Shapes::Box2D {

class CBorders {
public:
  explicit CBorders(Tests::CRandom& random) : m_cRandom(random) {}

  CWorldDesc World(eProfile profile) {
    CWorldDesc desc;
    desc.m_cBox2D.m_eProfile = profile;
    desc.m_cBox2D.m_fLengthUnit =
        Often(1.0f, {1e-45f, 1e-38f, 1e-30f, 1e-18f, 1e-6f, 0.01f, 100.0f, 1e10f, g_fMaxLength});
    desc.m_fTimeStep =
        Often(1.0f / 60.0f, {g_fMinTimeStep, 1e-20f, 1e-6f, 1.0f, 1e3f, g_fMaxTimeStep, 1e-39f, 2e6f});
    desc.m_nSubsteps = m_cRandom.Below(4) > 0 ? 1 : 2;
    // Rarely tiny: thousands of chords for each arc, all at one place, take Box2D seconds.
    if (m_cRandom.Below(16) == 0)
      desc.m_cBox2D.m_fSagittaTolerance = Often(1e-5f, {1e-45f, 1e-38f});
    else
      desc.m_cBox2D.m_fSagittaTolerance = Often(g_fSagittaTolerance, {0.001f, 1.0f, 1e9f, g_fMaxLength});
    desc.m_cBox2D.m_nVelocityIterations = Count(8);
    desc.m_cBox2D.m_nPositionIterations = Count(3);
    Inside(desc);
    desc.m_vGravity = Gravity();
    return desc;
  }

  /// From now on values are for such a world.
  void Inside(const CWorldDesc& desc) {
    m_fUnit = desc.m_cBox2D.m_fLengthUnit / GetTuning(desc.m_cBox2D.m_eProfile).m_fScale;
    m_fTimeStep = desc.m_fTimeStep;
  }

  Vector2 Gravity() {
    if (m_cRandom.Below(8) == 0) return Wild(g_fMaxBox2DSpeed);
    return m_cRandom.Coin() ? Vector2(0.0f, 0.0f) : Vector2(0.0f, -10.0f * m_fUnit);
  }

  float Elasticity() {
    return Often(1.0f, {0.0f, 1e-45f, 0.5f, 2.0f, 1e3f, g_fMaxElasticity, 2e6f, -1.0f, g_fNan});
  }

  float RotSpeed() {
    const float f = Often(1.0f, {0.0f, 1e-45f, 1e-20f, 30.0f, 1e4f, g_fMaxRotSpeed, 2e9f, g_fNan});
    return m_cRandom.Coin() ? f : -f;
  }

  float Angle() {
    if (m_cRandom.Below(64) == 0) return m_cRandom.Coin() ? g_fNan : 1e38f;
    const float quarter = 0.5f * g_fPi * static_cast<float>(m_cRandom.Below(5));
    return quarter + (m_cRandom.Coin() ? 0.0f : m_cRandom.SignedScale(-40, 1));
  }

  /// A length in user units, mostly one that means something to Box2D.
  float Length() {
    const float metres = Often(1.0f, {0.0f, 1e-45f, 1e-38f, 1e-20f, 1e-6f, 0.0025f, 0.005f, 0.0075f, 0.01f,
                                      0.015f, 0.1f, 10.0f, 1e3f, 1e6f, g_fMaxBox2DLength});
    return Near(metres * m_fUnit);
  }

  /// Mostly near, or exactly at, what is there already.
  Vector2 Pos() {
    if (m_cRandom.Below(40) == 0) return Wild(g_fMaxBox2DLength);
    if (m_stdPoints.empty() || m_cRandom.Below(8) == 0) return Remember(m_cRandom.InSquare(m_fUnit));
    const Vector2 p = m_stdPoints[m_cRandom.Below(static_cast<std::uint32_t>(m_stdPoints.size()))];
    if (m_cRandom.Coin()) return p;
    return Remember(p + Step());
  }

  Vector2 Vel() {
    if (m_cRandom.Below(8) == 0) return Wild(g_fMaxBox2DSpeed);
    // Up to several of Box2D's longest moves a step.
    const Vector2 step = Step();
    return m_cRandom.Coin() ? step : Vector2(step / m_fTimeStep);
  }

  CDynamicCircleDesc Ball() {
    const Vector2 p = Pos(), v = Vel();
    float r = m_cRandom.Coin() ? 0.1f * m_fUnit : Length();
    // Rarely huge: where the digits of a float are used up Box2D looks long for a time of impact.
    if (r > 100.0f * m_fUnit && m_cRandom.Below(8) > 0) r = 0.0f;
    const float e = Elasticity();
    const float m = Often(1.0f, {g_fMinBox2DMass, 1e-6f, 1e6f, g_fMaxBox2DMass, 0.0f, 2e12f, g_fNan});
    CDynamicCircleDesc desc(p, r, v, m, e);
    desc.m_bIsSensor = m_cRandom.Below(12) == 0;
    return desc;
  }

  CAnyShapeDesc Shape() {
    const Vector2 p = Pos();
    const float e = Elasticity();
    switch (m_cRandom.Below(4)) {
    case 0: return Moving(CPointDesc(p, e));
    case 1: return Moving(LineSeg(p, Pos(), e));
    case 2: return Moving(CCircleDesc(p, Length(), e));
    default: return Moving(Arc(p, e));
    }
  }

  /// Segments and arcs that share ends, or nearly so.
  std::vector<CAnyShapeDesc> Chain() {
    std::vector<CAnyShapeDesc> chain;
    Vector2 p = Pos();
    const float e = Elasticity();
    for (std::uint32_t n = 1 + m_cRandom.Below(4); n > 0; --n) {
      if (m_cRandom.Below(3) == 0) {
        const CArcDesc arc = Arc(p, e);
        Vector2 p0, p1;
        arc.GetEndPts(p0, p1);
        chain.emplace_back(arc);
        p = p1;
      } else {
        const Vector2 next = p + Step();
        chain.emplace_back(LineSeg(p, next, e));
        p = next;
      }
      if (m_cRandom.Below(4) == 0) p += Step();
    }
    return chain;
  }

private:
  template <std::size_t N>
  float Often(float usual, const float (&borders)[N]) {
    if (m_cRandom.Coin()) return usual;
    return borders[m_cRandom.Below(static_cast<std::uint32_t>(N))];
  }

  unsigned Count(unsigned usual) {
    if (m_cRandom.Below(4) > 0) return usual;
    return m_cRandom.Coin() ? 1 : 20;
  }

  // The value itself, or a float beside it.
  float Near(float f) {
    const std::uint32_t i = m_cRandom.Below(4);
    if (i == 0) return std::nextafter(f, g_fInf);
    return i == 1 ? std::nextafter(f, 0.0f) : f;
  }

  // Along an axis or not, and hardly ever a unit vector of neither.
  Vector2 Unit() {
    if (m_cRandom.Coin()) return m_cRandom.Direction();
    const float sign = m_cRandom.Coin() ? 1.0f : -1.0f;
    return m_cRandom.Coin() ? Vector2(sign, 0.0f) : Vector2(0.0f, sign);
  }

  Vector2 Step() {
    const float d = Length();
    return d * Unit();
  }

  // Up to a limit of Box2D, in metres, and one float beyond; or no number at all.
  Vector2 Wild(float most) {
    const float f = Near(most * m_fUnit), share = m_cRandom.Coin() ? 1.0f : 0.5f;
    Vector2 v = share * f * Unit();
    if (m_cRandom.Below(4) == 0) v.x() = m_cRandom.Coin() ? g_fNan : -g_fInf;
    return v;
  }

  const Vector2& Remember(const Vector2& p) {
    m_stdPoints.push_back(p);
    return m_stdPoints.back();
  }

  CLineSegDesc LineSeg(const Vector2& p0, const Vector2& p1, float e) {
    CLineSegDesc desc(p0, p1, e);
    desc.m_eSides = Sides();
    Remember(p0), Remember(p1), Remember(desc.m_vPos);
    return desc;
  }

  /// With end 0 at p or with its centre there.
  CArcDesc Arc(const Vector2& p, float e) {
    const float r = Length(), a0 = Angle(), a1 = m_cRandom.Coin() ? Angle() : a0 + Near(g_fTwoPi);
    CArcDesc desc(p, r, a0, a1, e);
    Vector2 p0, p1;
    desc.GetEndPts(p0, p1);
    if (m_cRandom.Coin()) {
      desc.m_vPos += p - p0;
      desc.GetEndPts(p0, p1);
    }
    desc.m_eSides = Sides();
    Remember(desc.m_vPos), Remember(p0), Remember(p1);
    return desc;
  }

  eSides Sides() {
    return std::array{eSides::Both, eSides::Both, eSides::Front, eSides::Back}[m_cRandom.Below(4)];
  }

  template <class TDesc>
  TDesc Moving(TDesc desc) {
    desc.m_bIsSensor = m_cRandom.Below(12) == 0;
    if (m_cRandom.Coin()) return desc;
    desc.m_eMotionType = eMotion::Kinematic;
    desc.m_fRotSpeed = RotSpeed();
    desc.m_vRotCenter = Pos();
    return desc;
  }

  Tests::CRandom& m_cRandom;
  float m_fUnit = 1.0f, m_fTimeStep = 1.0f;
  std::vector<Vector2> m_stdPoints;
};

} // namespace Shapes::Box2D
