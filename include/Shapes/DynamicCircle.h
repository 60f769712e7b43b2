// SPDX-License-Identifier: MIT
// Balls: the only shapes that move by themselves and respond to a collision.
#pragma once

#include <Shapes/Circle.h>

namespace Shapes {

class CContactDesc;

class CDynamicCircleDesc : public CCircleDesc {
public:
  CDynamicCircleDesc() { m_eMotionType = eMotion::Dynamic; }
  /// @param p  centre, user units
  /// @param r  radius, user units; of 0 only sensors that are disks notice it, and in the approximate mode
  ///           only balls
  /// @param v  velocity, units per second
  /// @param m  mass, above 0
  /// @param e  elasticity
  CDynamicCircleDesc(const Vector2& p, float r, const Vector2& v = Vector2::Zero(), float m = 1.0f,
                     float e = 1.0f);

  float m_fMass = 1.0f;
};

/// A ball. It is solid: other balls collide with it from outside only.
class CDynamicCircle : public CCircle {
public:
  /// @throws std::invalid_argument naming the field that is not finite, negative or too large, or a mass of 0
  explicit CDynamicCircle(const CDynamicCircleDesc& desc);
  std::unique_ptr<CShape> Clone() const override;

  float GetMass() const { return m_fMass; }
  /// The position before the last move; the present one if the ball was placed by SetPos since.
  const Vector2& GetPrevPos() const { return m_vPrevPos; }
  /// Whether a response had to cut the speed of the ball to g_fMaxSpeed since it was made.
  bool GetSpeedCapped() const { return m_bSpeedCapped; }

  /// One step: v += g dt, then p += v dt (semi-implicit Euler). A flight keeps v^2/2 - g.p + dt/2 g.v; a
  /// bounce within a step can change the energy (docs/effects.md).
  void move() override;

  /// Responds to a collision that CollisionDetected has found with c.m_pCircle == this.
  /// Static shape: v -= (1+e)(v.n)n if approaching; p += setback n. Kinematic shape: the same in the frame of
  /// its surface at the POI. Ball: impulse (1+e) m1 m2/(m1+m2) of the approach speed along n, the setback
  /// shared by m_other/(m1+m2). e is the product of both elasticities. Nothing happens if either is a sensor.
  /// @throws std::invalid_argument if c is of another ball
  void CollisionResponse(const CContactDesc& c);

private:
  void Translate(const Vector2& d) override;

  Vector2 m_vPrevPos;
  float m_fMass;
  bool m_bSpeedCapped = false;
};

} // namespace Shapes
