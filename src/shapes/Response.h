// SPDX-License-Identifier: MIT
// Motion and response of balls: one home for the shapes' level and the worlds, so that both have the
// same bits. n is the unit normal from the shape to the ball, e the product of both elasticities.
#pragma once

#include "../Tolerances.h"
#include <Shapes/ShapeMath.h>

#include <algorithm>
#include <limits>

namespace Shapes {

// Error bounds in roundings of the type that it is computed in: an ulp is 2^-23 of float, 2^-52 of double.

/// One step of a free ball, semi-implicit Euler: first its velocity, then its place. Error of each at most 1
/// ulp of |what was there| + |what is added|.
inline void Accelerate(Vector2& v, const Vector2& gravity, float dt) { v += gravity * dt; }
inline void Move(Vector2& p, const Vector2& v, float dt) { p += v * dt; }

/// Whether gravity can take a ball beyond g_fMaxSpeed in one step: what is below half an ulp of that is lost
/// beside it.
inline bool CanExceedMaxSpeed(const Vector2& gravityStep) {
  return gravityStep.cwiseAbs().maxCoeff() >= 0x1p-25f * g_fMaxSpeed;
}

/// max(0, -(v - surface) . n). Error at most 2 ulp of |v - surface|.
template <class TVector>
typename TVector::Scalar ApproachSpeed(const TVector& v, const TVector& surface, const TVector& n) {
  return std::max(typename TVector::Scalar(0), -(v - surface).dot(n));
}

/// The mass of two balls that hit each other.
inline double ReducedMass(double m0, double m1) { return m0 * m1 / (m0 + m1); }

/// The impulse of a response, mass times velocity, as it is reported: at most the largest float.
inline float ImpulseOf(double mass, double e, double approach) {
  return static_cast<float>(
      std::min((1.0 + e) * mass * approach, static_cast<double>(std::numeric_limits<float>::max())));
}

// For Vector2, and for double, in which the sweeps compute.

/// CapSpeed of what may be too fast.
template <class TVector>
bool CutSpeed(TVector& v, float most);

/// Cuts v to the speed `most`; returns whether it had to. Error of what was cut at most 4 ulp of `most`;
/// right unless the speed is within 2 ulp of it.
template <class TVector>
bool CapSpeed(TVector& v, float most = g_fMaxSpeed) {
  // Hardly any ball needs a root to tell.
  return !(v.cwiseAbs().maxCoeff() <= typename TVector::Scalar(0.5f * most)) && CutSpeed(v, most);
}

/// Ball (p, v) against a shape whose surface moves at `surface` at the POI: the static response in its frame.
/// Error of v at most 4 ulp of |v| + (1 + e) |v - surface|, of p 1 ulp of |p| + setback.
template <class TVector, class T = typename TVector::Scalar>
void RespondKinematic(const TVector& n, T setback, T e, const TVector& surface, TVector& p, TVector& v);

/// Ball 1 (the one that n points to, mass m1) against ball 0. With s the share of a ball, which is the
/// other's part of both masses, the error of its v is at most 5 ulp of |v| + s (1 + e) |v1 - v0|, of its p 3
/// ulp of |p| + s setback. So the sum of momenta changes by no more than the masses times these.
template <class TVector, class T = typename TVector::Scalar>
void RespondDynamic(const TVector& n, T setback, T e, T m0, T m1, TVector& p0, TVector& v0, TVector& p1,
                    TVector& v1);

} // namespace Shapes
