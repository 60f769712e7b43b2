// SPDX-License-Identifier: MIT
#include "ContactGatherer.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace Shapes::Box2D {
namespace {

// Of the two fixtures of a contact the ball that responds: of two balls the one that was added first.
std::pair<b2Fixture*, b2Fixture*> ShapeAndBall(b2Contact& contact) {
  b2Fixture *pA = contact.GetFixtureA(), *pB = contact.GetFixtureB();
  const bool ballIsA = IsBall(*pA) && (!IsBall(*pB) || GetId(*pA) < GetId(*pB));
  return ballIsA ? std::pair(pB, pA) : std::pair(pA, pB);
}

CContactGatherer::CSensorPair SensorPair(b2Contact& contact) {
  const auto [pShape, pBall] = ShapeAndBall(contact);
  return {GetId(*pBall), GetId(*pShape)};
}

bool IsSensor(b2Contact& contact) {
  return contact.GetFixtureA()->IsSensor() || contact.GetFixtureB()->IsSensor();
}

} // namespace

void CContactGatherer::BeginContact(b2Contact* pContact) {
  if (!IsSensor(*pContact)) return;
  m_stdTouching.insert(SensorPair(*pContact));
  m_stdBegun.push_back(SensorPair(*pContact));
}

void CContactGatherer::EndContact(b2Contact* pContact) {
  // Not asked whether it is a sensor: that may have been switched off since it began.
  const auto it = m_stdTouching.find(SensorPair(*pContact));
  if (it != m_stdTouching.end()) m_stdTouching.erase(it);
}

void CContactGatherer::PreSolve(b2Contact* pContact, const b2Manifold*) {
  // Box2D takes the larger restitution; here it is the product of both elasticities.
  pContact->SetRestitution(pContact->GetFixtureA()->GetRestitution() *
                           pContact->GetFixtureB()->GetRestitution());

  const auto [pShape, pBall] = ShapeAndBall(*pContact);
  b2WorldManifold manifold;
  pContact->GetWorldManifold(&manifold);
  const b2Vec2 n = pBall == pContact->GetFixtureB() ? manifold.normal : -manifold.normal;
  const b2Vec2 centre = pBall->GetBody()->GetPosition();
  const b2Vec2 poi = centre - pBall->GetShape()->m_radius * n;
  const b2Vec2 v =
      pBall->GetBody()->GetLinearVelocity() - pShape->GetBody()->GetLinearVelocityFromWorldPoint(poi);

  CContactEvent event;
  event.m_cShape = GetId(*pShape);
  event.m_cBall = GetId(*pBall);
  event.m_vPOI = m_cScale.FromMetres(poi);
  event.m_vNorm = Vector2(n.x, n.y);
  event.m_fSpeed = m_cScale.FromMetres(std::max(0.0f, -b2Dot(v, n)));
  m_stdEvents.push_back(event);
}

std::vector<CContactEvent> CContactGatherer::TakeContacts() {
  const auto pair = [](const CContactEvent& e) { return std::tie(e.m_cBall, e.m_cShape); };
  std::stable_sort(m_stdEvents.begin(), m_stdEvents.end(),
                   [&](const CContactEvent& a, const CContactEvent& b) {
                     return pair(a) != pair(b) ? pair(a) < pair(b) : a.m_fSpeed > b.m_fSpeed;
                   });
  m_stdEvents.erase(
      std::unique(m_stdEvents.begin(), m_stdEvents.end(),
                  [&](const CContactEvent& a, const CContactEvent& b) { return pair(a) == pair(b); }),
      m_stdEvents.end());
  return std::exchange(m_stdEvents, {});
}

std::vector<CContactGatherer::CSensorPair> CContactGatherer::TakeSensorPairs() {
  std::vector<CSensorPair> pairs = std::exchange(m_stdBegun, {});
  pairs.insert(pairs.end(), m_stdTouching.begin(), m_stdTouching.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void CContactGatherer::Clear() {
  m_stdEvents.clear();
  m_stdTouching.clear();
  m_stdBegun.clear();
}

} // namespace Shapes::Box2D
