// SPDX-License-Identifier: MIT
#include "PairSweep.h"

#include "../../Tolerances.h"
#include <Shapes/DynamicCircle.h>

#include <box2d/b2_time_of_impact.h>

#include "../world/FixtureShapes.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Box2D {
namespace {

// Both shapes on their way through the step, in metres about the frame's origin. A is the shape, B the ball.
struct CMotion {
  b2Sweep m_cSweepA;
  b2Sweep m_cSweepB;
  b2CircleShape m_cBall;
};

struct CImpact {
  bool m_bFound = false;
  float m_fTime = 1.0f;     // fraction of the step; 1 if found at its end only
  float m_fSetback = -1.0f; // metres
  b2Vec2 m_vCentre;         // of the ball where it only touches
  b2Vec2 m_vNorm;
};

b2Sweep MakeSweep(const b2Vec2& from, const b2Vec2& to, float turn = 0.0f) {
  b2Sweep sweep;
  sweep.localCenter.SetZero();
  sweep.c0 = from;
  sweep.c = to;
  sweep.a0 = -turn;
  sweep.a = 0.0f;
  sweep.alpha0 = 0.0f;
  return sweep;
}

void Collide(const b2EdgeShape& a, const b2Transform& xfA, const b2CircleShape& b, const b2Transform& xfB,
             b2Manifold& manifold) {
  b2CollideEdgeAndCircle(&manifold, &a, xfA, &b, xfB);
}

void Collide(const b2CircleShape& a, const b2Transform& xfA, const b2CircleShape& b, const b2Transform& xfB,
             b2Manifold& manifold) {
  b2CollideCircles(&manifold, &a, xfA, &b, xfB);
}

// Normal from A to B at time t, and how far apart their skins are; false if Box2D sees no contact there (too
// far, or the open side of a one-sided edge).
template <class TShape>
bool Touch(const TShape& shape, const CMotion& motion, float t, b2Vec2& normal, float& separation) {
  b2Transform xfA, xfB;
  motion.m_cSweepA.GetTransform(&xfA, t);
  motion.m_cSweepB.GetTransform(&xfB, t);
  b2Manifold manifold;
  Collide(shape, xfA, motion.m_cBall, xfB, manifold);
  FailIf(manifold.pointCount == 0);
  b2WorldManifold world;
  world.Initialize(&manifold, xfA, shape.m_radius, xfB, motion.m_cBall.m_radius);
  normal = world.normal;
  separation = world.separations[0];
  return true;
}

// The part of a sweep from t0 to t1.
b2Sweep Part(const b2Sweep& sweep, float t0, float t1) {
  b2Sweep part = sweep;
  part.c0 = (1.0f - t0) * sweep.c0 + t0 * sweep.c;
  part.a0 = (1.0f - t0) * sweep.a0 + t0 * sweep.a;
  part.c = (1.0f - t1) * sweep.c0 + t1 * sweep.c;
  part.a = (1.0f - t1) * sweep.a0 + t1 * sweep.a;
  return part;
}

// The piece's contact, if it is earlier than the best so far, or deeper at the end of the step.
template <class TShape>
void SweepPiece(const TShape& shape, const CMotion& motion, CImpact& best) {
  b2TOIInput input;
  input.proxyA.Set(&shape, 0);
  input.proxyB.Set(&motion.m_cBall, 0);
  input.tMax = 1.0f;
  const b2Sweep &a = motion.m_cSweepA, &b = motion.m_cSweepB;

  // b2TimeOfImpact takes shapes that are apart at the end, along the axis that parts them at the beginning,
  // for shapes that never met. Seen from a shape that turns, the path of a ball is bent, and it may have
  // been there and gone: a turn is asked for in parts.
  const int parts = 1 + static_cast<int>(std::min(std::abs(a.a - a.a0) / g_fLargestTurn, 64.0f));
  b2Vec2 normal;
  float separation;
  for (int i = 0; i < parts; ++i) {
    const float t0 = static_cast<float>(i) / static_cast<float>(parts);
    const float t1 = static_cast<float>(i + 1) / static_cast<float>(parts);
    input.sweepA = Part(a, t0, t1);
    input.sweepB = Part(b, t0, t1);
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    const float t = t0 + (t1 - t0) * output.t;
    if (t >= best.m_fTime) break;
    if (output.state != b2TOIOutput::e_touching || !Touch(shape, motion, t, normal, separation)) continue;

    // Approaching is relative to the point of A that is touched, at the impact: over the rest of the step
    // that point's way is a chord, shorter than its arc, and a ball that is overtaken would be missed.
    b2Transform xfA, xfB;
    a.GetTransform(&xfA, t);
    b.GetTransform(&xfB, t);
    const b2Vec2 poi = xfB.p - motion.m_cBall.m_radius * normal;
    const b2Vec2 surface = a.c - a.c0 + b2Cross(a.a - a.a0, poi - xfA.p);
    if (!(b2Dot(b.c - b.c0 - surface, normal) < 0.0f)) continue;
    // The setback undoes what both have moved into each other since.
    b2Transform endA;
    a.GetTransform(&endA, 1.0f);
    const b2Vec2 way = b.c - xfB.p - (b2Mul(endA, b2MulT(xfA, poi)) - poi);
    best = {true, t, std::max(0.0f, -b2Dot(way, normal)), xfB.p, normal};
    return;
  }
  if (best.m_fTime == 1.0f && Touch(shape, motion, 1.0f, normal, separation) &&
      std::max(0.0f, -separation) > best.m_fSetback) {
    const float setback = std::max(0.0f, -separation);
    best = {true, 1.0f, setback, motion.m_cSweepB.c + setback * normal, normal};
  }
}

// Whether a ball is on the open side of an edge for the whole of its straight way: none touches there.
// Box2D's own test comes after the sweep, which costs more than all the rest.
bool StaysBehind(const b2EdgeShape& edge, const b2Sweep& ball) {
  FailIf(!edge.m_oneSided);
  const b2Vec2 way = edge.m_vertex2 - edge.m_vertex1, n(way.y, -way.x); // to the solid side
  const float margin = b2_linearSlop * (std::abs(way.x) + std::abs(way.y));
  return std::max(b2Dot(n, ball.c0 - edge.m_vertex1), b2Dot(n, ball.c - edge.m_vertex1)) < -margin;
}

// The swept box of B (of A, if it rests) decides in a few comparisons which edges of a chain are worth a
// sweep.
bool MayMeet(const b2EdgeShape& edge, const CMotion& motion) {
  if (motion.m_cSweepA.a0 != 0.0f || !(motion.m_cSweepA.c0 == b2Vec2_zero)) return true;
  const float reach = motion.m_cBall.m_radius + 2.0f * edge.m_radius;
  const b2Vec2 r(reach, reach);
  const b2Vec2 lower = b2Min(motion.m_cSweepB.c0, motion.m_cSweepB.c) - r;
  const b2Vec2 upper = b2Max(motion.m_cSweepB.c0, motion.m_cSweepB.c) + r;
  const b2Vec2 edgeLower = b2Min(edge.m_vertex1, edge.m_vertex2),
               edgeUpper = b2Max(edge.m_vertex1, edge.m_vertex2);
  return edgeLower.x <= upper.x && edgeLower.y <= upper.y && edgeUpper.x >= lower.x &&
         edgeUpper.y >= lower.y && !StaysBehind(edge, motion.m_cSweepB);
}

// Whether the swept box of the ball comes near that of the shape, wherever the shape was meanwhile. Making
// the edges of an arc for a ball that is far from it would cost more than all that follows.
bool MayMeet(const CShape& shape, const CDynamicCircle& ball) {
  if (shape.GetLastTurn() != 0.0f || shape.GetLastMove() != Vector2::Zero()) return true;
  const CAabb2D path(ball.GetPrevPos(), ball.GetPos());
  const float size = std::max(ball.GetPos().cwiseAbs().maxCoeff(), ball.GetPrevPos().cwiseAbs().maxCoeff());
  const float reach = ball.GetRadius() + 4.0f * b2_polygonRadius + g_fBoxPadding * (size + ball.GetRadius());
  const Vector2 up(-reach, reach);
  return CAabb2D(path.GetTopLeft() + up, path.GetBottomRt() - up) && shape.GetAABB();
}

b2CircleShape MakeBall(const CDynamicCircle& ball) {
  b2CircleShape circle;
  circle.m_radius = ball.GetRadius();
  return circle;
}

void Report(const CImpact& best, const Vector2& origin, CContactDesc& c) {
  const Vector2 centre(best.m_vCentre.x, best.m_vCentre.y);
  c.m_vNorm = Vector2(best.m_vNorm.x, best.m_vNorm.y);
  c.m_vPOI = origin + centre - c.m_pCircle->GetRadius() * c.m_vNorm;
  c.m_fSetback = best.m_fSetback;
}

} // namespace

bool CollidePair(CContactDesc& c) {
  const CScale scale(1.0f);
  const CShape& shape = *c.m_pShape;
  const CDynamicCircle& ball = *c.m_pCircle;

  // About the shape, or the centre about which it turns, so that large coordinates do not eat the digits.
  const Vector2 origin = shape.GetMotionType() == eMotion::Kinematic ? shape.GetRotCenter() : shape.GetPos();
  CMotion motion;
  motion.m_cBall = MakeBall(ball);
  motion.m_cSweepB =
      MakeSweep(scale.ToMetres(ball.GetPrevPos() - origin), scale.ToMetres(ball.GetPos() - origin));
  CImpact best;

  if (shape.GetMotionType() == eMotion::Dynamic) {
    const auto& other = static_cast<const CDynamicCircle&>(shape);
    motion.m_cSweepA = MakeSweep(scale.ToMetres(other.GetPrevPos() - origin), b2Vec2_zero);
    SweepPiece(MakeBall(other), motion, best);
    if (best.m_bFound) Report(best, origin, c);
    return best.m_bFound;
  }

  motion.m_cSweepA = MakeSweep(scale.ToMetres(-shape.GetLastMove()), b2Vec2_zero, shape.GetLastTurn());
  FailIf(!MayMeet(shape, ball));
  const CFixtureShapes fixtures = CFixtureShapes::Make(shape, origin, scale, g_fSagittaTolerance);
  for (const b2CircleShape& circle : fixtures.m_stdCircles)
    SweepPiece(circle, motion, best);
  for (const b2EdgeShape& edge : fixtures.m_stdEdges)
    SweepPiece(edge, motion, best);
  for (const CFixtureShapes::CChain& vertices : fixtures.m_stdChains) {
    b2ChainShape chain;
    CreateChain(vertices, chain);
    for (int32 i = 0; i < chain.GetChildCount(); ++i) {
      b2EdgeShape edge;
      chain.GetChildEdge(&edge, i);
      if (MayMeet(edge, motion)) SweepPiece(edge, motion, best);
    }
  }
  if (best.m_bFound) Report(best, origin, c);
  return best.m_bFound;
}

} // namespace Shapes::Box2D
