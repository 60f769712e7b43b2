// SPDX-License-Identifier: MIT
// Sine and cosine that have the same bits on every machine, of all angles that a game has: C libraries round
// them differently, and a replay of a game in which something turns would go another way.
#pragma once

namespace Shapes::Geometry {

struct CTurn {
  double m_fCos, m_fSin;
};

/// Cosine and sine of an angle in radians, which has to be finite. Errors at most 1 ulp of each. Angles from
/// 2^20 on are left to the C library. The angle is reduced to a quarter turn by pi/2 in three parts (Cody and
/// Waite 1980), and what is left is summed as a Taylor series.
CTurn GetTurn(double angle);

/// An angle, radians, after dt seconds at this speed, whole turns left out: between -2 pi and 2 pi. What
/// turns for long keeps it in double, as a float loses a slow turn in each step.
double TurnOn(double angle, float revsPerSecond, float dt);

} // namespace Shapes::Geometry
