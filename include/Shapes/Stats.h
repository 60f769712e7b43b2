// SPDX-License-Identifier: MIT
// Counters of a world: steps, effects that ran, and the work in them.
#pragma once

#include <Shapes/Effects.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace Shapes {

/// Counters since the world was made.
struct CWorldStats {
  std::uint64_t m_nSteps = 0;
  std::uint64_t m_nSubsteps = 0;
  /// Substeps in which an effect ran, by eEffect.
  std::array<std::uint64_t, static_cast<std::size_t>(eEffect::Size)> m_stdSubstepsWith{};
  std::uint64_t GetSubstepsWith(eEffect e) const { return m_stdSubstepsWith[static_cast<std::size_t>(e)]; }
  std::uint64_t m_nBallsAccelerated = 0; ///< Times that gravity was added to the velocity of a ball.
  std::uint64_t m_nShapesTurned = 0;     ///< Times that a shape was moved or turned by its speeds.
  std::uint64_t m_nShapeTests = 0; ///< Native: pair kernels called for a ball and a shape that is not a ball.
  std::uint64_t m_nBallTests = 0;  ///< Native: pair kernels called for two balls.
  std::uint64_t m_nSweeps = 0;     ///< Native: times of impact looked for, of a ball with a shape or a ball.
  std::uint64_t m_nBallsSwept = 0; ///< Native: balls with an obstacle on their path, once for each substep.
  /// Native: balls that had too many impacts in a substep (g_nMaxImpacts, among others fewer), or met a shape
  /// that turns too often in it: they stayed there for the rest of it, or went along with a moving shape. And
  /// those that a kinematic shape leaves no room and goes over, also one that a game has put or stopped
  /// there.
  std::uint64_t m_nBallsHalted = 0;
  /// Native, where Continuous does not run: times that a ball with a velocity stayed where it was, because
  /// its move was below half an ulp of its place.
  std::uint64_t m_nMovesLost = 0;
  std::uint64_t m_nSensorTests = 0; ///< Paths of balls that were tested against a sensor.
  /// Contacts that were responded to. Box2D: only where Events or Sensors runs; else they are not counted.
  std::uint64_t m_nContacts = 0;
  std::uint64_t m_nSensorHits = 0; ///< Contacts of sensors.
  std::uint64_t m_nReported = 0;   ///< Contacts of both kinds in GetContacts.
  std::uint64_t m_nSpeedsCapped =
      0; ///< Responses and gravity steps after which a ball had to be cut to g_fMaxSpeed.
  /// Box2D: steps of a ball or a kinematic shape longer than its 2 metres; it slows such a body down.
  std::uint64_t m_nMovesClamped = 0;
  std::uint64_t m_nTurnsClamped =
      0; ///< Box2D: shape steps of more than its pi/2 radians; Box2D turns it by less.
  std::uint64_t m_nEngineSteps =
      0; ///< Box2D: calls of b2World::Step; tuned worlds cut substeps of fast ones.
  /// Box2D: times that it was about to solve a contact, where it asks; again for each time of impact.
  std::uint64_t m_nEngineContacts = 0;
  std::uint64_t m_nArcPieces = 0; ///< Box2D: chords that stand for the arcs that are in the world now.
  /// In a game's b2World: shapes whose bodies the game has destroyed.
  std::uint64_t m_nBodiesLost = 0;
  /// In a game's b2World: how often the game had put another contact listener in the place of ours.
  std::uint64_t m_nListenersReplaced = 0;
};

} // namespace Shapes
