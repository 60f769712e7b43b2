// SPDX-License-Identifier: MIT
// How balls move and answer collisions: one home for the shapes' level and the worlds, so that both have the
// same bits. n is the unit normal from the shape to the ball, e the product of both elasticities.
#pragma once

#include <Shapes/ShapeMath.h>
#include <Shapes/Tolerances.h>

#include <algorithm>

namespace Shapes {

/// One step of a free ball, semi-implicit Euler: first its velocity, then its place.
inline void Accelerate(Vector2& v, const Vector2& gravity, float dt) { v += gravity * dt; }
inline void Move(Vector2& p, const Vector2& v, float dt) { p += v * dt; }

/// max(0, -(v - surface) . n)
inline float ApproachSpeed(const Vector2& v, const Vector2& surface, const Vector2& n) {
  return std::max(0.0f, -(v - surface).dot(n));
}

/// Cuts v to the speed `most`; returns whether it had to.
bool CapSpeed(Vector2& v, float most = g_fMaxSpeed);

/// Ball (p, v) against a static shape.
void RespondStatic(const Vector2& n, float setback, float e, Vector2& p, Vector2& v);

/// Ball (p, v) against a shape whose surface moves at `surface` at the POI: the static response in its frame.
void RespondKinematic(const Vector2& n, float setback, float e, const Vector2& surface, Vector2& p,
                      Vector2& v);

/// Ball 1 (the one that n points to, mass m1) against ball 0.
void RespondDynamic(const Vector2& n, float setback, float e, float m0, float m1, Vector2& p0, Vector2& v0,
                    Vector2& p1, Vector2& v1);

} // namespace Shapes
