// SPDX-License-Identifier: MIT
// The limits and defaults that a user meets: name, unit, reason, consequence.
#pragma once

namespace Shapes {

/// Largest coordinate and radius that is accepted, in the user's unit. The square of the distance of any two
/// such points (at most 8e36) stays finite in float. Anything larger is refused.
inline constexpr float g_fMaxLength = 1e18f;

/// Smallest length unit of Box2D, in user units per metre: a metre divided by it stays finite, and lengths in
/// Box2D do not become 0 in user units. Anything smaller is refused.
inline constexpr float g_fMinLengthUnit = 1e-18f;

/// Largest speed, in units per second. A response that would exceed it (elasticity above 1 between two walls
/// doubles the speed at each hit) is cut to it and flagged: CDynamicCircle::GetSpeedCapped, CWorldStats. So
/// is a speed from gravity in a world.
inline constexpr float g_fMaxSpeed = 1e18f;

/// Range of masses. The sum of two and the inverse of each stay finite.
inline constexpr float g_fMinMass = 1e-36f;
inline constexpr float g_fMaxMass = 1e36f;

/// Largest elasticity. The product of two times the largest speed stays finite.
inline constexpr float g_fMaxElasticity = 1e6f;

/// Longest time step, in seconds: a bound on v dt, far above any use.
inline constexpr float g_fMaxTimeStep = 1e6f;
/// Shortest substep, in seconds: its inverse stays finite (Box2D divides by it).
inline constexpr float g_fMinTimeStep = 1e-30f;

/// Fastest rotation, in revolutions per second.
inline constexpr float g_fMaxRotSpeed = 1e9f;

/// Most substeps in one step: 64 times the most that shapes-compare tries.
inline constexpr unsigned g_nMaxSubsteps = 4096;

/// Most threads that a world may use.
inline constexpr unsigned g_nMaxThreads = 256;

/// Most impacts of a ball in a substep where Continuous runs: bounds time. After as many a ball stays for the
/// rest of the substep, or goes along with the moving shape that it touched last, and
/// CWorldStats::m_nBallsHalted counts it. The limit is a quarter of this among other balls, and a sixteenth
/// for one that a moving shape presses straight on something; where hundreds lie in one place it is less.
inline constexpr unsigned g_nMaxImpacts = 256;

/// A ball and what it has touched touch on as long as they are no farther apart than this, in radii of the
/// ball: 100 times what balls in a pile move apart, and less than is seen.
inline constexpr float g_fTouchReach = 0.02f;

/// Error of the path of a ball in the frame of a turning sensor, in its radii: a ball that touches by less
/// than that may be missed, one that misses by less may be detected.
inline constexpr float g_fRotatedPathError = 0.01f;

/// Default height of an arc above the chords that stand for it on Box2D, in metres: Box2D's own linear slop,
/// so the polygon is as good as the engine's contact distance. Gives 16 pieces for a half circle of 1 metre
/// radius.
inline constexpr float g_fSagittaTolerance = 0.005f;

/// Largest coordinate (metres), speed (metres per second; Box2D moves nothing by more than 2 metres a step
/// anyway) and range of masses in a world on Box2D. Beyond, products inside Box2D overflow and it stops the
/// program. Refused.
inline constexpr float g_fMaxBox2DLength = 1e8f;
inline constexpr float g_fMaxBox2DSpeed = 1e9f;
inline constexpr float g_fMinBox2DMass = 1e-12f;
inline constexpr float g_fMaxBox2DMass = 1e12f;

} // namespace Shapes
