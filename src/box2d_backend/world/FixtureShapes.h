// SPDX-License-Identifier: MIT
// Box2D's fixture shapes for a shape.
#pragma once

#include <Shapes/Arc.h>

#include <box2d/box2d.h>

#include <optional>
#include <vector>

#include "../Convert.h"

namespace Shapes::Box2D {

/// A shape in Box2D's terms, in metres about a local origin: a circle (of radius 0 for a point), an edge, or
/// chains, one for each solid face of an arc; arcs with skins are edges instead. Exactly one of the three is
/// there.
struct CFixtureShapes {
  std::vector<b2CircleShape> m_stdCircles;
  std::vector<b2EdgeShape> m_stdEdges;
  /// Vertices of a chain in the order that puts the solid side on the right; a closed one does not repeat the
  /// first.
  struct CChain {
    std::vector<b2Vec2> m_stdVertices;
    bool m_bClosed;
  };
  std::vector<CChain> m_stdChains;
  int m_nArcPieces = 0; ///< Chords of an arc, of one face if each has its own.

  /// Points, segments, circles and arcs.
  /// @param shape    as it is now; a shape too small for Box2D becomes a point, a full circle too small a
  /// circle
  /// @param origin   what becomes (0, 0), user units
  /// @param sagitta  height of an arc above its chords, metres
  /// @param skin     if it is given, the fixtures reach as far beyond the shape everywhere, metres: the skin
  /// of edges and what is added to the radius of circles. Those of arcs reach farther where their edges do
  /// not, by at most two heights of their chords.
  static CFixtureShapes Make(const CShape& shape, const Vector2& origin, const CScale& scale, float sagitta,
                             std::optional<float> skin = {});
};

/// Fills in an empty b2ChainShape.
void CreateChain(const CFixtureShapes::CChain& chain, b2ChainShape& shape);

/// Number of chords that keeps the sagitta R (1 - cos(piece / 2)) of an arc within the tolerance, at least
/// one for each quarter turn and at most g_nMaxArcPieces; fewer where chords would be shorter than
/// g_fShortestEdge. 0 if the whole arc is shorter than that. All lengths in metres.
int CountArcPieces(float radius, float span, bool closed, float sagitta);

} // namespace Shapes::Box2D
