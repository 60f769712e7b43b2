// SPDX-License-Identifier: MIT
#include "FixtureShapes.h"

#include "../../Tolerances.h"
#include "../../geometry/Turn.h"
#include "../../geometry/VisitShape.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Box2D {
namespace {

b2CircleShape Circle(const b2Vec2& p, float r) {
  b2CircleShape circle;
  circle.m_p = p;
  circle.m_radius = r;
  return circle;
}

// The solid side of an edge is on the right of its way. Its neighbours fold back onto it, which leaves the
// ends round: at a time of impact Box2D would take a ball that touches an end for one of a neighbour that has
// not been reached yet, and forget the impact.
void SetEdge(b2EdgeShape& edge, const b2Vec2& p0, const b2Vec2& p1, eSides sides, bool frontIsLeft) {
  if (sides == eSides::Both)
    edge.SetTwoSided(p0, p1);
  else if (frontIsLeft == (sides == eSides::Front))
    edge.SetOneSided(p0, p1, p0, p1);
  else
    edge.SetOneSided(p1, p0, p1, p0);
}

void MakeLineSeg(const CLineSeg& seg, const Vector2& origin, const CScale& scale, CFixtureShapes& fixtures) {
  const b2Vec2 p0 = scale.ToMetres(seg.GetEndPt0() - origin), p1 = scale.ToMetres(seg.GetEndPt1() - origin);
  if (!(b2Distance(p0, p1) >= g_fShortestEdge)) {
    fixtures.m_stdCircles.push_back(Circle(0.5f * (p0 + p1), 0.0f));
    return;
  }
  const bool normalIsLeft = Cross(seg.GetEndPt1() - seg.GetEndPt0(), seg.GetNormal()) > 0.0f;
  SetEdge(fixtures.m_stdEdges.emplace_back(), p0, p1, seg.GetSides(), normalIsLeft);
}

// Whether no two neighbours are so close that Box2D would stop the program.
bool AreApart(const CFixtureShapes::CChain& chain) {
  const auto& v = chain.m_stdVertices;
  for (std::size_t i = chain.m_bClosed ? 0 : 1; i < v.size(); ++i)
    FailIf(!(b2Distance(v[i], i == 0 ? v.back() : v[i - 1]) >= 0.75f * g_fShortestEdge));
  return true;
}

// One edge for each chord.
void MakeArcEdges(const CArc& arc, const std::vector<b2Vec2>& vertices, float skin,
                  CFixtureShapes& fixtures) {
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    b2EdgeShape& edge = fixtures.m_stdEdges.emplace_back();
    // Counterclockwise, the right side is the outside, which is the front.
    SetEdge(edge, vertices[i - 1], vertices[i], arc.GetSides(), false);
    edge.m_radius = skin;
  }
}

void MakeArc(const CArc& arc, const Vector2& origin, const CScale& scale, float sagitta,
             std::optional<float> skin, CFixtureShapes& fixtures) {
  const b2Vec2 centre = scale.ToMetres(arc.GetPos() - origin);
  const float R = scale.ToMetres(arc.GetRadius());
  const int n = CountArcPieces(R, arc.GetSpan(), arc.IsFullCircle(), sagitta);
  if (n == 0) {
    const Vector2 middle =
        arc.GetPos() + arc.GetRadius() * AngleToVector(arc.GetAngle0() + 0.5f * arc.GetSpan());
    fixtures.m_stdCircles.push_back(arc.IsFullCircle() ? Circle(centre, R)
                                                       : Circle(scale.ToMetres(middle - origin), 0.0f));
    return;
  }
  CFixtureShapes::CChain outside{{}, arc.IsFullCircle()};
  for (int i = 0; i < n; ++i) {
    const float angle = arc.GetAngle0() + arc.GetSpan() * static_cast<float>(i) / static_cast<float>(n);
    const Vector2 u = AngleToVector(angle);
    outside.m_stdVertices.push_back(centre + R * b2Vec2(u.x(), u.y()));
  }
  if (!arc.IsFullCircle()) outside.m_stdVertices.push_back(scale.ToMetres(arc.GetEndPt1() - origin));
  if (!AreApart(outside)) { // rounded together, far from the origin
    fixtures.m_stdCircles.push_back(Circle(centre, arc.IsFullCircle() ? R : 0.0f));
    return;
  }

  fixtures.m_nArcPieces = n;
  if (skin) {
    // The chords are as far outside of the arc as inside, but for its ends.
    const float half = 0.5f * arc.GetSpan() / static_cast<float>(n);
    const auto cosine = static_cast<float>(Geometry::GetTurn(static_cast<double>(half)).m_fCos);
    const float out = 2.0f / (1.0f + cosine);
    std::vector<b2Vec2> vertices = outside.m_stdVertices;
    const bool closed = arc.IsFullCircle();
    for (std::size_t i = closed ? 0 : 1; i < vertices.size() - (closed ? 0 : 1); ++i)
      vertices[i] = centre + out * (vertices[i] - centre);
    if (closed) vertices.push_back(vertices.front());
    MakeArcEdges(arc, vertices, *skin + R * (1.0f - cosine), fixtures);
    return;
  }
  // Counterclockwise, the right side is the outside.
  CFixtureShapes::CChain inside = outside;
  std::reverse(inside.m_stdVertices.begin(), inside.m_stdVertices.end());
  if (arc.GetSides() != eSides::Back) fixtures.m_stdChains.push_back(std::move(outside));
  if (arc.GetSides() != eSides::Front) fixtures.m_stdChains.push_back(std::move(inside));
}

} // namespace

int CountArcPieces(float radius, float span, bool closed, float sagitta) {
  if (!(radius > 0.0f)) return 0;
  const double R = radius, s = span;
  const double half = std::acos(std::max(0.0, 1.0 - static_cast<double>(sagitta) / R));
  // A tolerance that is lost beside the radius leaves nothing of it: as many as there may be.
  const double byTolerance = s / (2.0 * std::max(half, 1e-300));
  const double byQuarters = s / (0.5 * static_cast<double>(g_fPi));
  // A chord is shorter than its arc by at most a tenth up to a quarter turn.
  const double mostByLength = 0.9 * R * s / static_cast<double>(g_fShortestEdge);
  double n = std::ceil(std::max({byTolerance, byQuarters, closed ? 3.0 : 1.0}));
  n = std::min({n, std::floor(mostByLength), static_cast<double>(g_nMaxArcPieces)});
  return n >= (closed ? 3.0 : 1.0) ? static_cast<int>(n) : 0;
}

CFixtureShapes CFixtureShapes::Make(const CShape& shape, const Vector2& origin, const CScale& scale,
                                    float sagitta, std::optional<float> skin) {
  CFixtureShapes fixtures;
  const auto addCircle = [&](float r) {
    fixtures.m_stdCircles.push_back(Circle(scale.ToMetres(shape.GetPos() - origin), scale.ToMetres(r)));
  };
  VisitShape(shape,
             CPerShape{[&](const CPoint&) { addCircle(0.0f); },
                       [&](const CLineSeg& seg) { MakeLineSeg(seg, origin, scale, fixtures); },
                       [&](const CCircle& circle) { addCircle(circle.GetRadius()); },
                       [&](const CArc& arc) { MakeArc(arc, origin, scale, sagitta, skin, fixtures); }});
  if (!skin) return fixtures;
  for (b2CircleShape& circle : fixtures.m_stdCircles)
    circle.m_radius += *skin;
  if (fixtures.m_nArcPieces == 0)
    for (b2EdgeShape& edge : fixtures.m_stdEdges)
      edge.m_radius = *skin;
  return fixtures;
}

void CreateChain(const CFixtureShapes::CChain& chain, b2ChainShape& shape) {
  const auto& v = chain.m_stdVertices;
  const auto n = static_cast<int32>(v.size());
  if (chain.m_bClosed)
    shape.CreateLoop(v.data(), n);
  else // neighbours that fold back leave the ends round
    shape.CreateChain(v.data(), n, v[1], v[v.size() - 2]);
}

} // namespace Shapes::Box2D
