// SPDX-License-Identifier: MIT
// What stands for a shape on Box2D.
#pragma once

#include <Shapes/Arc.h>

#include <box2d/box2d.h>

#include <vector>

#include "Convert.h"
#include "Joints.h"

namespace Shapes::Box2D {

/// A shape in Box2D's terms, in metres about a local origin: a circle (of radius 0 for a point), an edge, or
/// chains, one for each solid face of an arc. Exactly one of the three is there.
struct CPieces {
  std::vector<b2CircleShape> m_stdCircles;
  std::vector<b2EdgeShape> m_stdEdges;
  /// Vertices of a chain in the order that puts the solid side on the right; a closed one does not repeat the
  /// first. What comes before and after it says where its ends are not round.
  struct CChain {
    std::vector<b2Vec2> m_stdVertices;
    bool m_bClosed;
    b2Vec2 m_vBefore, m_vAfter;
  };
  std::vector<CChain> m_stdChains;
  int m_nArcPieces = 0; ///< Edges of one face of an arc, the larger number of both.

  /// Points, segments, circles and arcs.
  /// @param shape    as it is now; a shape too small for Box2D becomes a point, a full circle too small a
  /// circle
  /// @param origin   what becomes (0, 0), user units
  /// @param sagitta  height of an arc above its chords, metres
  /// @param joints   what goes on beyond its ends
  /// @param behind   no edge of an arc is before its arc as a ball sees it: those that are met from inside
  /// are tangents instead of chords
  static CPieces Make(const CShape& shape, const Vector2& origin, const CScale& scale, float sagitta,
                      const CJoints& joints = {}, bool behind = false);
};

/// Fills in an empty b2ChainShape.
void CreateChain(const CPieces::CChain& chain, b2ChainShape& shape);

/// Number of chords that keeps the sagitta R (1 - cos(piece / 2)) of an arc within the tolerance, at least
/// one for each quarter turn and at most g_nMaxArcPieces; fewer where chords would be shorter than
/// g_fShortestEdge. 0 if the whole arc is shorter than that. All lengths in metres.
int CountArcPieces(float radius, float span, bool closed, float sagitta);

} // namespace Shapes::Box2D
