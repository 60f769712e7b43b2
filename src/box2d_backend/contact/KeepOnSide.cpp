// SPDX-License-Identifier: MIT
#include "KeepOnSide.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <optional>

namespace Shapes::Box2D {
namespace {

struct CCrossing {
  Vector2d m_vPos, m_vNorm; ///< on the shape; to the side of a
};

// Where the way from a to b goes through the shape, all in its frame.
std::optional<CCrossing> FindCrossing(const CContactGeometry& o, const Vector2d& a, const Vector2d& b,
                                      double r) {
  if (o.m_eKind == CContactGeometry::eKind::Disk || o.m_bIsOneSided) return {};
  const bool isArc = o.m_eKind == CContactGeometry::eKind::Arc;
  const Vector2d& t = o.m_cEnd1.m_vOut;
  const auto side = [&](const Vector2d& p) {
    return isArc ? (p - o.m_vCentre).norm() - o.m_fRadius : Geometry::Cross(t, p - o.m_cEnd0.m_vPos);
  };
  const double before = side(a), after = side(b);
  if (!(before > 0.0 ? after <= 0.0 : before < 0.0 && after >= 0.0)) return {};
  CCrossing crossing;
  crossing.m_vPos = a + before / (before - after) * (b - a);
  crossing.m_vNorm = Geometry::Perp(t);
  if (isArc) {
    crossing.m_vNorm = Geometry::Unit(crossing.m_vPos - o.m_vCentre, Vector2d(0, 1));
    crossing.m_vPos = o.m_vCentre + o.m_fRadius * crossing.m_vNorm;
  }
  if (before < 0.0) crossing.m_vNorm = -crossing.m_vNorm;
  const double past = FindExactContact(o, crossing.m_vPos, Vector2d::Zero(), 0.0).m_fGap;
  if (past > static_cast<double>(g_fLeastRest * b2_linearSlop)) return {}; // beyond an end
  for (const CContactGeometry::CEnd* pEnd : {&o.m_cEnd0, &o.m_cEnd1})
    if (!o.m_bFull && !pEnd->m_bIsShared && (crossing.m_vPos - pEnd->m_vPos).norm() < r) return {};
  return crossing;
}

void KeepOnSide(const CBody& shape, CBody& ball) {
  const b2Transform &now = shape.m_pBody->GetTransform(),
                    &then = shape.m_pBody->GetType() == b2_staticBody ? now : shape.m_cStart;
  const auto crossing =
      FindCrossing(shape.m_cGeometry, ToDouble(b2MulT(then, ball.m_cStart.p)),
                   ToDouble(b2MulT(now, ball.m_pBody->GetPosition())), static_cast<double>(ball.m_fRadius));
  if (!crossing) return;
  const b2Vec2 n = b2Mul(now.q, ToFloat(crossing->m_vNorm));
  const float off = std::max(ball.m_fRadius, g_fLeastRest * b2_linearSlop);
  const b2Vec2 p = b2Mul(now, ToFloat(crossing->m_vPos)) + off * n;
  const b2Vec2 v = ball.m_pBody->GetLinearVelocity();
  ball.m_pBody->SetTransform(p, 0.0f);
  const float speed = b2Dot(v - shape.m_pBody->GetLinearVelocityFromWorldPoint(p), n);
  ball.m_pBody->SetLinearVelocity(v - std::min(0.0f, speed) * n);
}

} // namespace

void KeepBallsOnTheirSide(CBodies& bodies) {
  for (CBody* pBall : bodies.GetBalls()) {
    if (!pBall->m_pBody->GetWorld()->GetContinuousPhysics()) return;
    for (const b2BodyType type : {b2_kinematicBody, b2_staticBody})
      for (const b2ContactEdge* p = pBall->m_pBody->GetContactList(); p != nullptr; p = p->next)
        if (const CBody* pShape = bodies.Find(*p->other); pShape != nullptr && p->other->GetType() == type &&
                                                          IsSolid(*p->contact) && !pBall->Passes(*pShape))
          KeepOnSide(*pShape, *pBall);
  }
}

} // namespace Shapes::Box2D
