// SPDX-License-Identifier: MIT
// How gravity bends the path of a ball within a step. Box2D moves a ball along a straight line, at one
// speed, which is that of the parabola in the middle of the step when the world has no gravity of its own and
// each ball gets half of its gravity step before the step and half after it. At a bounce the parabola is
// elsewhere and has another speed: that deviation is followed through the bounces, each of which mirrors it
// as it mirrors the ball.
#pragma once

#include <box2d/box2d.h>

#include "../../geometry/Vector.h"

#include <vector>

namespace Shapes::Box2D {

/// Of one ball during one step; metres and seconds.
class CParabolicCorrection {
public:
  /// @param g  gravity
  /// @param h  length of the step
  void Begin(const Vector2d& g, double h);

  /// The part of the step that is over when the ball is at p on its way, in [0, 1].
  /// @param start  where it was at the beginning of the step
  double PartAt(const b2Body& ball, const b2Vec2& start) const;
  /// An impact that Box2D resolves at this part of the step.
  struct CImpact {
    double m_fPart; ///< of the step that is over
    double m_fTime =
        0.0;          ///< seconds from there until the straight ways meet; negative if they have met before
    Vector2d m_vNorm; ///< to the ball
    double m_fSpeed;  ///< relative velocity of the straight ways along the normal, below 0
    double m_fElasticity;
  };
  /// The difference of position and velocity on the parabola to those of Box2D at this part of the step.
  void GetDeviation(double part, Vector2d& p, Vector2d& v) const;
  /// A ball and, if there is one, the other ball respond to an impact.
  /// @param share  of the other's mass in that of both; 1 against a shape
  /// @return the approach speed of the parabolas
  static double Bounce(const CImpact& impact, CParabolicCorrection& ball, double share,
                       CParabolicCorrection* pOther);
  /// Box2D has put the ball somewhere else.
  void Shift(const Vector2d& back) {
    m_vPos += back;
    m_bHasBounced = true;
  }
  /// The ball lies on a surface of normal n: the part of the gravity step that would press it into the
  /// surface is not given.
  void Rest(const Vector2d& n) { m_stdRests.push_back(n); }
  /// The last bounce of the ball is resolved.
  void MotionEnds(const b2Body& ball);
  const b2Vec2& GetMotionEnd() const { return m_vMotionEnd; }

  /// Puts the ball on its parabola at the end of the step.
  void Land(b2Body& ball) const;

private:
  void SetDeviation(double part, const Vector2d& p, const Vector2d& v);

  Vector2d m_vGravity = Vector2d::Zero();
  double m_fStep = 0.0;
  double m_fPart = 0.0;               // of the step at the last bounce
  Vector2d m_vPos = Vector2d::Zero(); // deviations just after it
  Vector2d m_vVel = Vector2d::Zero();
  bool m_bHasBounced = false;
  bool m_bHasMotion = false;
  b2Vec2 m_vMotionEnd{0.0f, 0.0f}; // where the ball will be at the end of the step
  std::vector<Vector2d> m_stdRests;
};

} // namespace Shapes::Box2D
