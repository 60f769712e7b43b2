// SPDX-License-Identifier: MIT
// Box2D gives a pair the larger of two restitutions, this library the product of two elasticities. Finds
// elasticities for the same bounces.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace Shapes::Box2D {

/// Balls of one restitution that meet the same others, or shapes.
struct CBounceKind {
  bool m_bIsBall = false;
  float m_fRestitution = 0.0f; ///< At least 0.
};

/// Two kinds of which members meet; the same one twice for balls of one kind that meet each other. At least
/// one is of balls.
struct CBouncePair {
  std::size_t m_nFirst = 0;
  std::size_t m_nSecond = 0;
};

/// The restitution of the pair on Box2D: the larger one.
float GetTarget(std::span<const CBounceKind> kinds, const CBouncePair& pair);

/// Whether the product of the two elasticities is what Box2D gives the pair, within 4 ulp: two roundings to
/// float and that of the product are 3.
bool Reproduces(std::span<const CBounceKind> kinds, std::span<const float> elasticities,
                const CBouncePair& pair);

/// An elasticity for each kind, such that every pair is reproduced if that is possible. Else as many pairs of
/// balls and shapes as a least-squares fit of their logarithms gives, which is all if they can be all; then
/// pairs of balls likewise with what is free still. Then pairs that should not bounce, but whose partners
/// bounce elsewhere, come near 0 (2^-10), and then the elasticities of balls near 1, as far as they are free.
/// A kind without pairs keeps its restitution. None is above g_fMaxElasticity.
std::vector<float> FitElasticities(std::span<const CBounceKind> kinds, std::span<const CBouncePair> pairs);

} // namespace Shapes::Box2D
