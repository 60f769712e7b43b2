// SPDX-License-Identifier: MIT
#include "LastingContact.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Shapes::Box2D {
namespace {

float GapOf(const CBody& a, const CBody& b) {
  return b2Distance(a.m_pBody->GetPosition(), b.m_pBody->GetPosition()) - a.m_fRadius - b.m_fRadius;
}

bool AreTouching(const CBody& a, const CBody& b) { return GapOf(a, b) <= g_fLastingReach * b2_linearSlop; }

bool AreNear(const CBody& a, const CBody& b) {
  const float reach =
      std::max(g_fLastingReach * b2_linearSlop, g_fNearInRadii * std::min(a.m_fRadius, b.m_fRadius));
  return GapOf(a, b) <= reach;
}

template <class F>
void ForNeighbours(CBodies& bodies, const CBody& ball, F f) {
  for (const b2ContactEdge* p = ball.m_pBody->GetContactList(); p != nullptr; p = p->next)
    if (p->other->GetType() == b2_dynamicBody && IsSolid(*p->contact))
      if (CBody* pOther = bodies.Find(*p->other); pOther != nullptr) f(*pOther);
}

float ApproachSpeed(const CBody& a, const CBody& b) {
  b2Vec2 n = b.m_pBody->GetPosition() - a.m_pBody->GetPosition();
  n.Normalize();
  return b2Dot(a.m_pBody->GetLinearVelocity() - b.m_pBody->GetLinearVelocity(), n);
}

// Whether gravity keeps two balls that touch together.
bool ArePressed(const CBody& a, const CBody& b, float gravityStep) {
  FailIf(!(a.m_fElasticity * b.m_fElasticity < 1.0f));
  return std::abs(ApproachSpeed(a, b)) < static_cast<float>(g_fRestingSpeed) * gravityStep;
}

} // namespace

float FindLastingContacts(CBodies& bodies, const b2Vec2& g, float h) {
  bodies.FindContacts();
  const float gravityStep = h * g.Length();
  float mass = 0.0f;
  std::vector<CBody*> lasting;
  const auto mark = [&](CBody& ball) {
    if (ball.m_bIsLasting) return;
    ball.m_bIsLasting = true;
    mass += ball.m_pBody->GetMass();
    lasting.push_back(&ball);
  };
  for (CBody* pBall : bodies.GetBalls())
    pBall->m_bIsLasting = false;
  for (CBody* pBall : bodies.GetBalls()) {
    int near = 0;
    bool touches = false;
    ForNeighbours(bodies, *pBall, [&](const CBody& other) {
      near += AreNear(*pBall, other);
      if (!AreTouching(*pBall, other)) return;
      touches = true;
      if (!pBall->m_bIsLasting && ArePressed(*pBall, other, gravityStep)) mark(*pBall);
    });
    if (near >= g_nCrowd && touches) mark(*pBall);
  }
  while (!lasting.empty()) {
    const CBody& ball = *lasting.back();
    lasting.pop_back();
    ForNeighbours(bodies, ball, [&](CBody& other) {
      if (!other.m_bIsLasting && AreTouching(ball, other)) mark(other);
    });
  }
  bodies.SetBullets();
  return mass * g.Length();
}

float CountLastingSubsteps(CBodies& bodies, float dt) {
  float parts = 1.0f;
  for (const CBody* pBall : bodies.GetBalls())
    if (pBall->m_bIsLasting)
      ForNeighbours(bodies, *pBall, [&](const CBody& other) {
        if (!other.m_bIsLasting) return;
        const float depth = dt * ApproachSpeed(*pBall, other) - std::max(0.0f, GapOf(*pBall, other));
        const float most = g_fLastingMove * std::min(pBall->m_fRadius, other.m_fRadius);
        if (depth > parts * most) parts = most > 0.0f ? depth / most : g_fMostLastingSubsteps; // a point
      });
  return std::min(parts, g_fMostLastingSubsteps);
}

void PushOutOfShapes(CBodies& bodies, const b2Vec2& g) {
  for (CBody* pBall : bodies.GetBalls()) {
    if (!pBall->m_bIsLasting) continue;
    const b2Vec2 start = pBall->m_pBody->GetPosition();
    b2Vec2 p = start;
    for (int round = 0, pushed = 2; round < g_nPushRounds && pushed > 1; ++round) {
      pushed = 0;
      for (const b2ContactEdge* pEdge = pBall->m_pBody->GetContactList(); pEdge != nullptr;
           pEdge = pEdge->next) {
        if (pEdge->other->GetType() == b2_dynamicBody || !pEdge->contact->IsTouching() ||
            !IsSolid(*pEdge->contact))
          continue;
        const CBody* pShape = bodies.Find(*pEdge->other);
        if (pShape == nullptr || pBall->Passes(*pShape)) continue;
        const b2Transform& xf = pShape->m_pBody->GetTransform();
        const CExactContact contact =
            FindExactContact(pShape->m_cGeometry, ToDouble(b2MulT(xf, p)), Vector2d::Zero(),
                             static_cast<double>(pBall->m_fRadius));
        if (contact.m_fGap >= 0.0) continue;
        p -= static_cast<float>(contact.m_fGap) * b2Mul(xf.q, ToFloat(contact.m_vNorm));
        ++pushed;
      }
    }
    if (p == start) continue;
    pBall->m_pBody->SetTransform(p, 0.0f);
    // Pushed upwards, the ball loses the energy that it gained by its fall into the shape.
    const b2Vec2 v = pBall->m_pBody->GetLinearVelocity();
    const float gained = 2.0f * b2Dot(g, start - p), square = v.LengthSquared();
    if (gained > 0.0f && square > 0.0f)
      pBall->m_pBody->SetLinearVelocity(std::sqrt(std::max(0.0f, 1.0f - gained / square)) * v);
  }
}

} // namespace Shapes::Box2D
