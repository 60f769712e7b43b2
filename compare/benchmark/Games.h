// SPDX-License-Identifier: MIT
// The peg field on each engine: through this library, and as a user of the other ones would write it by hand.
#pragma once

#include "PegField.h"

#include <memory>

namespace Shapes::Compare::Benchmark {

/// A world of some engine that holds the field.
class CGame {
public:
  virtual ~CGame() = default;
  /// By g_fStep seconds.
  virtual void Step() = 0;
};

/// Through this library: with these effects, and with or without pairs of balls.
std::unique_ptr<CGame> MakeShapesGame(const CPegField& field, eBackend backend, CEffectChoice effects,
                                      bool pairs);
/// Straight on Box2D, arcs as chains of 8 edges, balls as bullets where `continuous`, which is of the world.
std::unique_ptr<CGame> MakeBox2DGame(const CPegField& field, bool continuous, bool pairs);
/// Straight on Chipmunk, on its spatial hash with these cells where `cells` is above 0, else on its tree.
std::unique_ptr<CGame> MakeChipmunkGame(const CPegField& field, float cells, bool pairs);

} // namespace Shapes::Compare::Benchmark
