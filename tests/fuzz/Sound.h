// SPDX-License-Identifier: MIT
// What holds for every world after every step.
#pragma once

#include "Fuzz.h"

#include <Shapes/World.h>

#include <cmath>

namespace Shapes::Fuzz {

/// Within some roundings: what a unit vector in float has to be.
inline bool IsUnit(const Vector2& n) { return std::abs(n.cast<double>().norm() - 1.0) <= 1e-6; }

inline void RequireSound(const CWorld& world) {
  for (const Vector2& p : world.GetBallPositions())
    Require(p.allFinite(), "a ball has a finite place", p.transpose());
  for (const Vector2& v : world.GetBallVelocities())
    Require(v.allFinite(), "a ball has a finite velocity", v.transpose());
  for (const CContactEvent& event : world.GetContacts()) {
    Require(event.m_vPOI.allFinite(), "a contact has a finite POI", event.m_vPOI.transpose());
    Require(IsUnit(event.m_vNorm), "the normal of a contact is a unit vector", event.m_vNorm.transpose());
    Require(std::isfinite(event.m_fSetback) && event.m_fSetback >= 0.0f, "a setback is at least 0",
            event.m_fSetback);
    Require(std::isfinite(event.m_fSpeed) && event.m_fSpeed >= 0.0f, "an approach speed is at least 0",
            event.m_fSpeed);
    Require(world.Contains(event.m_cBall) && world.Contains(event.m_cShape),
            "a contact is of what is in the world", event.m_cBall.m_nValue, event.m_cShape.m_nValue);
  }
}

} // namespace Shapes::Fuzz
