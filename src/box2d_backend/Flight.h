// SPDX-License-Identifier: MIT
// How gravity bends the way of a ball within a step. Box2D moves a ball along a straight line, at one speed,
// which is that of the parabola in the middle of the step when the world has no gravity of its own and each
// ball gets half of its kick before the step and half after it. At a bounce the parabola is elsewhere and has
// another speed: that deviation is followed through the bounces, each of which mirrors it as it mirrors the
// ball.
#pragma once

#include <box2d/box2d.h>

#include <Eigen/Core>

#include <vector>

namespace Shapes::Box2D {

using Vector2d = Eigen::Vector2d;

/// Of one ball during one step; metres and seconds.
class CFlight {
public:
  /// @param g  gravity
  /// @param h  length of the step
  void Begin(const Vector2d& g, double h);

  /// The part of the step that is over when the ball is at p on its way, in [0, 1].
  /// @param start  where it was at the beginning of the step
  double PartAt(const b2Body& ball, const b2Vec2& start) const;
  /// The ball bounces off a surface of normal n; what approaches leaves with the share e of its speed.
  /// @param part  of the step that is over when its straight way meets the surface
  /// @param wn    its velocity on that way along n, relative to the surface
  /// @return what the velocity on the parabola has more than that of Box2D just before it
  Vector2d Bounce(double part, const Vector2d& n, double wn, double e);
  /// The ball lies on a surface of normal n: what the kick would press it into that is not given.
  void Rest(const Vector2d& n) { m_stdRests.push_back(n); }
  /// The last bounce of the ball has been answered.
  void LegEnds(const b2Body& ball);

  /// Puts the ball on its parabola at the end of the step.
  void Land(b2Body& ball) const;

private:
  void At(double part, Vector2d& p, Vector2d& v) const;

  Vector2d m_vGravity = Vector2d::Zero();
  double m_fStep = 0.0;
  double m_fPart = 0.0;               // of the step at the last bounce
  Vector2d m_vPos = Vector2d::Zero(); // deviations just after it
  Vector2d m_vVel = Vector2d::Zero();
  bool m_bHasBounced = false;
  bool m_bHasLeg = false;
  b2Vec2 m_vLegEnd{0.0f, 0.0f}; // where the ball will be at the end of the step
  std::vector<Vector2d> m_stdRests;
};

} // namespace Shapes::Box2D
