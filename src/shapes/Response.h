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
template <class TVector>
typename TVector::Scalar ApproachSpeed(const TVector& v, const TVector& surface, const TVector& n) {
  return std::max(typename TVector::Scalar(0), -(v - surface).dot(n));
}

// For Vector2, and for double, in which the sweeps compute.

/// Cuts v to the speed `most`; returns whether it had to.
template <class TVector>
bool CapSpeed(TVector& v, float most = g_fMaxSpeed);

/// Ball (p, v) against a static shape.
void RespondStatic(const Vector2& n, float setback, float e, Vector2& p, Vector2& v);

/// Ball (p, v) against a shape whose surface moves at `surface` at the POI: the static response in its frame.
template <class TVector, class T = typename TVector::Scalar>
void RespondKinematic(const TVector& n, T setback, T e, const TVector& surface, TVector& p, TVector& v);

/// Ball 1 (the one that n points to, mass m1) against ball 0.
template <class TVector, class T = typename TVector::Scalar>
void RespondDynamic(const TVector& n, T setback, T e, T m0, T m1, TVector& p0, TVector& v0, TVector& p1,
                    TVector& v1);

} // namespace Shapes
