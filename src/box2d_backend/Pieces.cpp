// SPDX-License-Identifier: MIT
#include "Pieces.h"

#include <Shapes/Tolerances.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Shapes::Box2D {
namespace {

b2CircleShape Circle(const b2Vec2& p, float r) {
  b2CircleShape circle;
  circle.m_p = p;
  circle.m_radius = r;
  return circle;
}

// A point beyond an end at p: into the neighbour, or, where there is none, back to q, which leaves the end
// round.
b2Vec2 Beyond(const std::optional<CJoint>& joint, const b2Vec2& p, const b2Vec2& q) {
  return joint ? p + b2Vec2(joint->m_vTangent.x(), joint->m_vTangent.y()) : q;
}

void MakeLineSeg(const CLineSeg& seg, const Vector2& origin, const CScale& scale, const CJoints& joints,
                 CPieces& pieces) {
  const b2Vec2 p0 = scale.ToMetres(seg.GetEndPt0() - origin), p1 = scale.ToMetres(seg.GetEndPt1() - origin);
  if (!(b2Distance(p0, p1) >= g_fShortestEdge)) {
    pieces.m_stdCircles.push_back(Circle(0.5f * (p0 + p1), 0.0f));
    return;
  }
  if (seg.GetSides() == eSides::Both && !joints[0] && !joints[1]) {
    pieces.m_stdEdges.emplace_back().SetTwoSided(p0, p1);
    return;
  }
  // The solid side of an edge is on the right of its way.
  const b2Vec2 before = Beyond(joints[0], p0, p1), after = Beyond(joints[1], p1, p0);
  const bool frontIsLeft = Cross(seg.GetEndPt1() - seg.GetEndPt0(), seg.GetNormal()) > 0.0f;
  if (seg.GetSides() != (frontIsLeft ? eSides::Back : eSides::Front))
    pieces.m_stdEdges.emplace_back().SetOneSided(after, p1, p0, before);
  if (seg.GetSides() != (frontIsLeft ? eSides::Front : eSides::Back))
    pieces.m_stdEdges.emplace_back().SetOneSided(before, p0, p1, after);
}

// Whether no two neighbours are so close that Box2D would stop the program.
bool AreApart(const CPieces::CChain& chain) {
  const auto& v = chain.m_stdVertices;
  for (std::size_t i = chain.m_bClosed ? 0 : 1; i < v.size(); ++i)
    FailIf(!(b2Distance(v[i], i == 0 ? v.back() : v[i - 1]) >= 0.75f * g_fShortestEdge));
  return true;
}

// An arc about the local origin of its vertices.
struct CCurve {
  const CArc& m_cArc;
  b2Vec2 m_vCentre, m_vEnd1;
  float m_fRadius;

  b2Vec2 At(double part, float radius) const {
    const Vector2 u = AngleToVector(m_cArc.GetAngle0() + m_cArc.GetSpan() * static_cast<float>(part));
    return m_vCentre + radius * b2Vec2(u.x(), u.y());
  }
};

// n chords.
CPieces::CChain MakeChords(const CCurve& curve, int n) {
  CPieces::CChain chain{{}, curve.m_cArc.IsFullCircle(), {}, {}};
  for (int i = 0; i < n; ++i)
    chain.m_stdVertices.push_back(curve.At(static_cast<double>(i) / n, curve.m_fRadius));
  if (!chain.m_bClosed) chain.m_stdVertices.push_back(curve.m_vEnd1);
  return chain;
}

// n tangents: of a full circle all alike, else the first and the last are half as long and touch the ends.
CPieces::CChain MakeTangents(const CCurve& curve, int n) {
  const bool closed = curve.m_cArc.IsFullCircle();
  CPieces::CChain chain{{}, closed, {}, {}};
  const int parts = closed ? n : n - 1;
  const float radius = curve.m_fRadius / std::cos(0.5f * curve.m_cArc.GetSpan() / static_cast<float>(parts));
  if (!closed) chain.m_stdVertices.push_back(curve.At(0.0, curve.m_fRadius));
  for (int i = 0; i < parts; ++i)
    chain.m_stdVertices.push_back(curve.At((i + 0.5) / parts, radius));
  if (!closed) chain.m_stdVertices.push_back(curve.m_vEnd1);
  return chain;
}

void MakeArc(const CArc& arc, const Vector2& origin, const CScale& scale, float sagitta,
             const CJoints& joints, bool behind, CPieces& pieces) {
  const CCurve curve{arc, scale.ToMetres(arc.GetPos() - origin), scale.ToMetres(arc.GetEndPt1() - origin),
                     scale.ToMetres(arc.GetRadius())};
  const int n = CountArcPieces(curve.m_fRadius, arc.GetSpan(), arc.IsFullCircle(), sagitta);
  if (n == 0) {
    const Vector2 middle =
        arc.GetPos() + arc.GetRadius() * AngleToVector(arc.GetAngle0() + 0.5f * arc.GetSpan());
    pieces.m_stdCircles.push_back(arc.IsFullCircle() ? Circle(curve.m_vCentre, curve.m_fRadius)
                                                     : Circle(scale.ToMetres(middle - origin), 0.0f));
    return;
  }
  CPieces::CChain outside = MakeChords(curve, n);
  if (!AreApart(outside)) { // rounded together, far from the origin
    pieces.m_stdCircles.push_back(Circle(curve.m_vCentre, arc.IsFullCircle() ? curve.m_fRadius : 0.0f));
    return;
  }
  CPieces::CChain inside = outside;
  // Fewer than four would stick out far.
  if (behind && n >= 4)
    if (CPieces::CChain tangents = MakeTangents(curve, n); AreApart(tangents)) inside = std::move(tangents);
  for (CPieces::CChain* pChain : {&outside, &inside}) {
    const auto& v = pChain->m_stdVertices;
    pChain->m_vBefore = Beyond(joints[0], v.front(), v[1]);
    pChain->m_vAfter = Beyond(joints[1], v.back(), v[v.size() - 2]);
  }

  pieces.m_nArcPieces = n;
  // Counterclockwise, the right side is the outside.
  std::reverse(inside.m_stdVertices.begin(), inside.m_stdVertices.end());
  std::swap(inside.m_vBefore, inside.m_vAfter);
  if (arc.GetSides() != eSides::Back) pieces.m_stdChains.push_back(std::move(outside));
  if (arc.GetSides() != eSides::Front) pieces.m_stdChains.push_back(std::move(inside));
}

} // namespace

int CountArcPieces(float radius, float span, bool closed, float sagitta) {
  const double R = radius, s = span;
  const double byTolerance = s / (2.0 * std::acos(std::max(0.0, 1.0 - static_cast<double>(sagitta) / R)));
  const double byQuarters = s / (0.5 * static_cast<double>(g_fPi));
  // A chord is shorter than its arc by at most a tenth up to a quarter turn.
  const double mostByLength = 0.9 * R * s / static_cast<double>(g_fShortestEdge);
  double n = std::ceil(std::max({byTolerance, byQuarters, closed ? 3.0 : 1.0}));
  n = std::min({n, std::floor(mostByLength), static_cast<double>(g_nMaxArcPieces)});
  return n >= (closed ? 3.0 : 1.0) ? static_cast<int>(n) : 0;
}

CPieces CPieces::Make(const CShape& shape, const Vector2& origin, const CScale& scale, float sagitta,
                      const CJoints& joints, bool behind) {
  CPieces pieces;
  switch (shape.GetShapeType()) {
  case eShape::LineSeg:
    MakeLineSeg(static_cast<const CLineSeg&>(shape), origin, scale, joints, pieces);
    break;
  case eShape::Arc:
    MakeArc(static_cast<const CArc&>(shape), origin, scale, sagitta, joints, behind, pieces);
    break;
  case eShape::Circle: {
    const float r = static_cast<const CCircle&>(shape).GetRadius();
    pieces.m_stdCircles.push_back(Circle(scale.ToMetres(shape.GetPos() - origin), scale.ToMetres(r)));
    break;
  }
  default: pieces.m_stdCircles.push_back(Circle(scale.ToMetres(shape.GetPos() - origin), 0.0f)); break;
  }
  return pieces;
}

void CreateChain(const CPieces::CChain& chain, b2ChainShape& shape) {
  const auto& v = chain.m_stdVertices;
  const auto n = static_cast<int32>(v.size());
  if (chain.m_bClosed)
    shape.CreateLoop(v.data(), n);
  else
    shape.CreateChain(v.data(), n, chain.m_vBefore, chain.m_vAfter);
}

} // namespace Shapes::Box2D
