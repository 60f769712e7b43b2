// SPDX-License-Identifier: MIT
#include "ContactGatherer.h"

#include "../../Tolerances.h"
#include "../../shapes/Response.h"

#include <algorithm>
#include <utility>

namespace Shapes::Box2D {

namespace {

// Whether a is the ball of the two that responds: of two balls the one that was added first.
bool IsBallOf(const CBody* pA, const CBody* pB) {
  FailIf(pA == nullptr || !pA->m_bIsBall);
  return pB == nullptr || !pB->m_bIsBall || pA->m_cId < pB->m_cId;
}

} // namespace

void CContactGatherer::BeginStep(const b2Vec2& g, float h, float weight) {
  m_cOverride.BeginStep(g, h, weight);
  m_stdPathVertices.clear();
  if (!Follows()) return;
  for (CBody* pBall : m_cBodies.GetBalls()) {
    pBall->m_cStart = pBall->m_pBody->GetTransform();
    pBall->m_pBouncedOff = nullptr;
    pBall->m_stdPassed.clear();
    const bool isFollowed = pBall->IsFree() && !pBall->m_bHasWeight;
    pBall->m_cCorrection.Begin(isFollowed ? ToDouble(g) : Vector2d(Vector2d::Zero()), static_cast<double>(h));
    pBall->m_bWasSupported = std::exchange(pBall->m_bIsSupported, false);
  }
  for (CBody* pBody : m_cBodies.GetMoving())
    pBody->m_cStart = pBody->m_pBody->GetTransform();
}

void CContactGatherer::PreSolve(b2Contact* pContact, const b2Manifold*) {
  CBody* pA = m_cBodies.Find(*pContact->GetFixtureA()->GetBody());
  CBody* pB = m_cBodies.Find(*pContact->GetFixtureB()->GetBody());
  if (pA == nullptr || pB == nullptr) return;
  ++m_nAsked;
  if (IsBallOf(pA, pB)) std::swap(pA, pB);
  pContact->SetRestitution(RestitutionOf(*pA, *pB));
  if (!m_cTuning.m_bExactContacts)
    ReportAsIs(*pContact, *pA, *pB);
  else if (const auto resolution = m_cOverride.Override(*pContact, *pA, *pB, CanWait(*pA, *pB)))
    Report(*pA, *pB, *resolution);
}

void CContactGatherer::Remember(const b2Contact& contact) {
  if (!m_cTuning.m_bExactContacts) return;
  const b2Fixture* fixtures[2] = {contact.GetFixtureA(), contact.GetFixtureB()};
  for (int i = 0; i < 2; ++i) {
    CBefore& before = m_cBefore[i];
    before.m_pBody = m_cBodies.Find(*fixtures[i]->GetBody());
    if (before.m_pBody == nullptr) continue;
    before.m_cCorrection = before.m_pBody->m_cCorrection;
    before.m_pBouncedOff = before.m_pBody->m_pBouncedOff;
    before.m_bIsSupported = before.m_pBody->m_bIsSupported;
    before.m_bLiesOnOwn = before.m_pBody->m_bLiesOnOwn;
  }
  m_cMark = m_cOverride.GetMark();
}

void CContactGatherer::Pass() {
  CBody *const pA = m_cBefore[0].m_pBody, *const pB = m_cBefore[1].m_pBody;
  if (pA == nullptr || pB == nullptr) return;
  for (const CBefore& before : m_cBefore) {
    before.m_pBody->m_cCorrection = before.m_cCorrection;
    before.m_pBody->m_pBouncedOff = before.m_pBouncedOff;
    before.m_pBody->m_bIsSupported = before.m_bIsSupported;
    before.m_pBody->m_bLiesOnOwn = before.m_bLiesOnOwn;
  }
  m_cOverride.GoBack(m_cMark);
  if (pA->m_bIsBall) pA->m_stdPassed.push_back(pB);
  if (pB->m_bIsBall) pB->m_stdPassed.push_back(pA);
}

bool CContactGatherer::CanWait(const CBody& shape, const CBody& ball) {
  return !m_cBodies.IsNearOthers(ball) && !(shape.m_bIsBall && m_cBodies.IsNearOthers(shape));
}

float CContactGatherer::RestitutionOf(const CBody& shape, const CBody& ball) const {
  // Box2D takes the larger restitution; here it is the product of both elasticities. Above 1, beyond what any
  // ball may leave with it is cut, because masses times speeds and squares of speeds would be infinite in
  // Box2D.
  const float e = shape.m_fElasticity * ball.m_fElasticity;
  if (e <= 1.0f) return e;
  const b2Body &a = *shape.m_pBody, &b = *ball.m_pBody;
  const b2Vec2 v = b.GetLinearVelocity() - a.GetLinearVelocityFromWorldPoint(b.GetPosition());
  const float fall =
      m_cOverride.GetStep() * (m_cOverride.GetGravity().Length() + b.GetWorld()->GetGravity().Length());
  const float speed = v.Length() + fall;
  return e * speed > g_fMaxBox2DSpeedGain ? g_fMaxBox2DSpeedGain / speed : e;
}

void CContactGatherer::PostSolve(b2Contact* pContact, const b2ContactImpulse* pImpulse) {
  if (!m_bContacts && !Follows()) return;
  CBody* pA = m_cBodies.Find(*pContact->GetFixtureA()->GetBody());
  CBody* pB = m_cBodies.Find(*pContact->GetFixtureB()->GetBody());
  if (m_bContacts) AddImpulse(pA, pB, *pImpulse);
  if (!Follows()) return;
  for (CBody* pBody : {pA, pB})
    if (pBody != nullptr && pBody->m_bIsBall) pBody->m_cCorrection.MotionEnds(*pBody->m_pBody);
  m_cOverride.AfterSolve();
}

void CContactGatherer::AddImpulse(const CBody* pA, const CBody* pB, const b2ContactImpulse& impulse) {
  if (!IsBallOf(pA, pB)) std::swap(pA, pB);
  if (!IsBallOf(pA, pB)) return; // a shape and a body of the game
  const CShapeId other = pB != nullptr ? pB->m_cId : CShapeId();
  for (int i = 0; i < impulse.count; ++i)
    m_stdSolved.push_back({{pA->m_cId, other}, impulse.normalImpulses[i]});
}

void CContactGatherer::CollideWithOther(b2Contact& contact) {
  CBody* pA = m_cBodies.Find(*contact.GetFixtureA()->GetBody());
  CBody* pB = m_cBodies.Find(*contact.GetFixtureB()->GetBody());
  if ((pA == nullptr) == (pB == nullptr)) return;
  CBody& ball = pA != nullptr ? *pA : *pB;
  if (!ball.m_bIsBall) return;
  CBody other;
  other.m_pBody = (pA != nullptr ? contact.GetFixtureB() : contact.GetFixtureA())->GetBody();
  other.m_cStart = other.m_pBody->GetTransform();
  ReportAsIs(contact, other, ball);
  if (m_cTuning.m_bParabolas) m_cOverride.FollowOther(contact, other, ball);
}

void CContactGatherer::ReportAsIs(b2Contact& contact, const CBody& shape, const CBody& ball) {
  if (!m_bContacts) return;
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  const bool ballIsB = contact.GetFixtureB()->GetBody() == ball.m_pBody;
  const b2Vec2 n = ballIsB ? manifold.normal : -manifold.normal;
  const b2Vec2 centre = ball.m_pBody->GetPosition();
  const b2Vec2 poi = centre - ball.m_fRadius * n;
  const b2Vec2 v = ball.m_pBody->GetLinearVelocity() - shape.m_pBody->GetLinearVelocityFromWorldPoint(poi);
  Report(shape, ball, {poi, n, -b2Dot(v, n), 0.0f});
}

void CContactGatherer::Report(const CBody& shape, const CBody& ball,
                              const CPreSolveOverride::CResolution& resolution) {
  if (!m_bContacts) return;
  const b2Vec2 &poi = resolution.m_vPOI, &n = resolution.m_vNorm;
  // The impulse is in metres until TakeContacts.
  m_stdEvents.push_back({shape.m_cId, ball.m_cId, m_cScale.FromMetres(poi), Vector2(n.x, n.y), 0.0f,
                         m_cScale.FromMetres(std::max(0.0f, resolution.m_fSpeed)), false,
                         resolution.m_fUnsolved});
  if (!m_bPathVertices) return;
  const double part = m_cOverride.PartAt(shape, ball);
  m_stdPathVertices.push_back({ball.m_cId, poi + ball.m_fRadius * n, part});
  if (shape.m_bIsBall) m_stdPathVertices.push_back({shape.m_cId, poi - shape.m_fRadius * n, part});
}

std::vector<CContactEvent> CContactGatherer::TakeContacts() {
  const auto pair = [](const CContactEvent& e) { return CTouchingPair{e.m_cBall, e.m_cShape}; };
  std::stable_sort(m_stdEvents.begin(), m_stdEvents.end(),
                   [&](const CContactEvent& a, const CContactEvent& b) {
                     return pair(a) != pair(b) ? pair(a) < pair(b) : a.m_fSpeed > b.m_fSpeed;
                   });
  m_stdEvents.erase(
      std::unique(m_stdEvents.begin(), m_stdEvents.end(),
                  [&](const CContactEvent& a, const CContactEvent& b) { return pair(a) == pair(b); }),
      m_stdEvents.end());
  for (const CSolved& solved : m_stdSolved) {
    const auto it = std::lower_bound(
        m_stdEvents.begin(), m_stdEvents.end(), solved.m_cPair,
        [&](const CContactEvent& e, const CTouchingPair& wanted) { return pair(e) < wanted; });
    if (it != m_stdEvents.end() && pair(*it) == solved.m_cPair) it->m_fImpulse += solved.m_fImpulse;
  }
  m_stdSolved.clear();
  for (CContactEvent& event : m_stdEvents)
    event.m_fImpulse = ImpulseOf(static_cast<double>(m_cScale.FromMetres(1.0f)), 0.0,
                                 std::max(0.0, static_cast<double>(event.m_fImpulse)));
  return std::exchange(m_stdEvents, {});
}

} // namespace Shapes::Box2D
