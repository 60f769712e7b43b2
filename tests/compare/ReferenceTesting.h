// SPDX-License-Identifier: MIT
// Parts that the tests of the exact reference share: short ways to describe shapes, to run a reference, and
// to sum up its balls.
#pragma once

#include "SweepOracle.h"
#include "Testing.h"
#include "reference/Reference.h"

namespace Shapes::Compare {

using CShapes = std::vector<CAnyShapeDesc>;
using CBalls = std::vector<CDynamicCircleDesc>;
template <class T>
using CEventsOf = std::vector<CExactEvent<T>>;
using CEvents = CEventsOf<double>;
using CExact = CReference<double>;

inline constexpr double g_fEps = std::numeric_limits<double>::epsilon();

/// Gravity, and its size as the reference knows it.
inline const Vector2 g_vPull(0, -9.81f);
inline const double g_fPull = static_cast<double>(9.81f);

inline CLineSegDesc Wall(const Vector2& a, const Vector2& b, float e = 1) { return CLineSegDesc(a, b, e); }

inline CShapes Box(const Vector2& low, const Vector2& high, float e = 1) {
  const auto walls = Walls(low, high, e);
  return {walls.begin(), walls.end()};
}
/// About the origin.
inline CShapes Box(float half, float e = 1) { return Box({-half, -half}, {half, half}, e); }

inline CExact Make(const CShapes& shapes, const CBalls& balls, const Vector2& g = Vector2::Zero()) {
  return CExact(shapes, balls, g);
}

/// With one ball of mass 1, at a place that need not be one of floats.
inline CExact MakeOne(const CShapes& shapes, float r, const CVec2d& p, const CVec2d& v,
                      const Vector2& g = Vector2::Zero()) {
  CExact reference = Make(shapes, {CDynamicCircleDesc({0, 0}, r)}, g);
  reference.SetBall(0, p, v);
  return reference;
}

/// The gap between a ball and what is next to it, a shape or another ball; negative if they overlap.
inline double GetGap(const CExact& reference, std::size_t ball) {
  const CExactBall<double>& b = reference.GetBall(ball);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < reference.GetShapeCount(); ++k) {
    const Tests::CSweepOracle oracle(reference.GetGeometry(k), {}, {b.m_vPos, {0, 0}, b.m_fRadius}, 0);
    least = std::min(least, static_cast<double>(oracle.Gap(0)));
  }
  for (std::size_t j = 0; j < reference.GetBallCount(); ++j)
    if (j != ball)
      least = std::min(least, (b.m_vPos - reference.GetBall(j).m_vPos).norm() - b.m_fRadius -
                                  reference.GetBall(j).m_fRadius);
  return least;
}

/// `steps` steps of dt. The time of an event is that since the first of them began.
template <class T>
inline CEventsOf<T> Carry(CReference<T>& reference, double dt, int steps = 1) {
  CEventsOf<T> events;
  for (int i = 0; i < steps; ++i) {
    const std::size_t before = events.size();
    reference.Step(T(dt), events);
    for (std::size_t k = before; k < events.size(); ++k)
      events[k].m_fTime += T(i) * T(dt);
  }
  return events;
}

/// Of motion, and under gravity g of the heights above y = `lowest`; all balls together.
inline double Energy(const CExact& reference, double g = 0, double lowest = 0) {
  double energy = 0;
  for (std::size_t i = 0; i < reference.GetBallCount(); ++i) {
    const CExactBall<double>& ball = reference.GetBall(i);
    energy += ball.m_fMass * (.5 * ball.m_vVel.squaredNorm() + g * (ball.m_vPos.y() - lowest));
  }
  return energy;
}

inline CVec2d Momentum(const CExact& reference) {
  CVec2d momentum(0, 0);
  for (std::size_t i = 0; i < reference.GetBallCount(); ++i)
    momentum += reference.GetBall(i).m_fMass * reference.GetBall(i).m_vVel;
  return momentum;
}

} // namespace Shapes::Compare
