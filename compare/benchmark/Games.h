// SPDX-License-Identifier: MIT
// A field on each engine: through this library, and as a user of the other ones would write it by hand.
#pragma once

#include "Field.h"

#include <memory>

namespace Shapes::Compare::Benchmark {

/// A world of some engine that holds a field.
class CGame {
public:
  virtual ~CGame() = default;
  /// By the step of the field.
  virtual void Step() = 0;
  /// Turns all flippers at their speeds up, times this.
  virtual void Turn(float factor) = 0;
  virtual std::vector<Vector2> GetBallPositions() const = 0;
};

/// How Box2D is used by hand.
enum class eByHand {
  Continuous, ///< Its continuous physics, and balls that meet each other are bullets where the field has
              ///< them.
  Discrete,   ///< Without it.
  LikeShapes  ///< The settings of the world that this library makes: continuous, but no bullets; balls bounce
              ///< at any speed and do not sleep.
};

/// Through this library: with these effects, and with or without pairs of balls.
std::unique_ptr<CGame> MakeShapesGame(const CField& field, eBackend backend, CEffectChoice effects,
                                      bool pairs);
/// Straight on Box2D, arcs as edges: a chain has one side.
std::unique_ptr<CGame> MakeBox2DGame(const CField& field, eByHand byHand, bool pairs);
/// Straight on Chipmunk, arcs as segments, on its spatial hash where `hash`, else on its tree.
std::unique_ptr<CGame> MakeChipmunkGame(const CField& field, bool hash, bool pairs);

} // namespace Shapes::Compare::Benchmark
