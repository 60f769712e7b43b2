// SPDX-License-Identifier: MIT
// Trials with any bytes at all. Each throws CBroken where something does not hold that has to hold for
// every input; sanitizers and Box2D's asserts end the process.
#pragma once

#include <Shapes/World.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <sstream>
#include <stdexcept>

namespace Shapes::Fuzz {

class CBroken : public std::logic_error {
public:
  using std::logic_error::logic_error;
};

/// @throws CBroken with what was expected, and the values, unless it holds
template <class... T>
void Require(bool holds, const char* what, const T&... values) {
  if (holds) return;
  std::ostringstream text;
  text.precision(9);
  text << what;
  ((text << ' ' << values), ...);
  throw CBroken(text.str());
}

/// The text of a scene file: the loader refuses it by CSceneError, or both engines can play it.
void FuzzScene(std::span<const std::uint8_t> bytes);
/// A shape and a ball, asked of the native kernels and of Box2D.
void FuzzPairs(std::span<const std::uint8_t> bytes);
/// A world of either engine, and what is done to it.
void FuzzWorld(std::span<const std::uint8_t> bytes);

/// Within some roundings: what a unit vector in float has to be.
inline bool IsUnit(const Vector2& n) { return std::abs(n.cast<double>().norm() - 1.0) <= 1e-6; }

/// Checks that hold for every contact of an engine.
template <class TContact>
void RequireSoundContact(const TContact& c) {
  Require(c.m_vPOI.allFinite(), "a contact has a finite POI", c.m_vPOI.transpose());
  Require(IsUnit(c.m_vNorm), "the normal of a contact is a unit vector", c.m_vNorm.transpose());
  Require(std::isfinite(c.m_fSetback) && c.m_fSetback >= 0.0f, "a setback is at least 0", c.m_fSetback);
  Require(std::isfinite(c.m_fSpeed) && c.m_fSpeed >= 0.0f, "an approach speed is at least 0", c.m_fSpeed);
}

/// Checks that hold for every world after every step.
inline void RequireSound(const CWorld& world) {
  for (const Vector2& p : world.GetBallPositions())
    Require(p.allFinite(), "a ball has a finite place", p.transpose());
  for (const Vector2& v : world.GetBallVelocities())
    Require(v.allFinite(), "a ball has a finite velocity", v.transpose());
  for (const CContactEvent& event : world.GetContacts()) {
    RequireSoundContact(event);
    Require(world.Contains(event.m_cBall) && world.Contains(event.m_cShape),
            "a contact is of what is in the world", event.m_cBall.m_nValue, event.m_cShape.m_nValue);
  }
}

} // namespace Shapes::Fuzz
