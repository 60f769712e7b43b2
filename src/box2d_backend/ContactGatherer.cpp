// SPDX-License-Identifier: MIT
#include "ContactGatherer.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Shapes::Box2D {
namespace {

Vector2d ToDouble(const b2Vec2& v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }
b2Vec2 ToFloat(const Vector2d& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

// How far apart the skins are when b2TimeOfImpact says that they touch.
float StopSeparation(float radii) { return std::max(-3.0f * b2_linearSlop, b2_linearSlop - radii); }

// The separation that makes Box2D push both apart by `push` at a time of impact. It takes .75 of what is
// beyond the slop in each round, and stops after the round that began within another half of a slop.
float SeparationFor(float push) {
  const float slop = b2_linearSlop;
  if (push <= 0.75f * 0.5f * slop) return -slop - push / 0.75f;
  float left = 0.25f * 0.25f;
  while (push / (1.0f - left) * left > 0.25f * 0.5f * slop)
    left *= 0.25f;
  return -slop - push / (1.0f - left);
}

// Makes the contact a face with normal n, from fixture A to fixture B, and this separation.
void SetManifold(b2Contact& contact, const b2Vec2& n, float separation) {
  b2Manifold& manifold = *contact.GetManifold();
  const b2Fixture &a = *contact.GetFixtureA(), &b = *contact.GetFixtureB();
  const b2Transform &xfA = a.GetBody()->GetTransform(), &xfB = b.GetBody()->GetTransform();
  const b2Vec2 clip = b2Mul(xfB, manifold.points[0].localPoint);
  const float reach = separation + a.GetShape()->m_radius + b.GetShape()->m_radius;
  manifold.type = b2Manifold::e_faceA;
  manifold.localNormal = b2MulT(xfA.q, n);
  manifold.localPoint = b2MulT(xfA, clip - reach * n);
}

// Whether a body is on its way through the step.
bool HasMoved(const CBody& body) {
  const b2Transform &now = body.m_pBody->GetTransform(), &then = body.m_cStart;
  return body.m_pBody->GetType() != b2_staticBody &&
         !(now.p == then.p && now.q.s == then.q.s && now.q.c == then.q.c);
}

} // namespace

void CContactGatherer::BeginStep(const b2Vec2& g, float h) {
  m_vGravity = g;
  m_fStep = h;
  m_bIsContinuous = m_bIsIslandOpen = false;
  m_stdWaiting.clear();
  m_stdAnswered.clear();
  m_stdBends.clear();
  for (CBody* pBall : m_cBodies.GetBalls()) {
    pBall->m_cStart = pBall->m_pBody->GetTransform();
    pBall->m_cFlight.Begin(ToDouble(g), static_cast<double>(h));
    pBall->m_bWasSupported = std::exchange(pBall->m_bIsSupported, false);
  }
  for (CBody* pBody : m_cBodies.GetKinematics())
    pBody->m_cStart = pBody->m_pBody->GetTransform();
}

void CContactGatherer::PreSolve(b2Contact* pContact, const b2Manifold*) {
  CBody* pA = m_cBodies.Find(*pContact->GetFixtureA()->GetBody());
  CBody* pB = m_cBodies.Find(*pContact->GetFixtureB()->GetBody());
  if (pA == nullptr || pB == nullptr) return;
  // Box2D takes the larger restitution; here it is the product of both elasticities.
  pContact->SetRestitution(pA->m_fElasticity * pB->m_fElasticity);
  // Of two balls the one that responds is the one that was added first.
  if (pA->m_bIsBall && (!pB->m_bIsBall || pA->m_cId < pB->m_cId)) std::swap(pA, pB);
  if (m_cTuning.m_bTrueContacts)
    MeetTruly(*pContact, *pA, *pB);
  else
    MeetAsIs(*pContact, *pA, *pB);
}

void CContactGatherer::PostSolve(b2Contact* pContact, const b2ContactImpulse*) {
  for (const b2Fixture* pFixture : {pContact->GetFixtureA(), pContact->GetFixtureB()})
    if (CBody* pBody = m_cBodies.Find(*pFixture->GetBody()); pBody != nullptr && pBody->m_bIsBall)
      pBody->m_cFlight.LegEnds(*pBody->m_pBody);
  m_bIsContinuous = true; // what was seen in the first look has been solved
  m_bIsIslandOpen = false;
}

void CContactGatherer::MeetAsIs(b2Contact& contact, const CBody& shape, const CBody& ball) {
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  const bool ballIsB = contact.GetFixtureB()->GetBody() == ball.m_pBody;
  const b2Vec2 n = ballIsB ? manifold.normal : -manifold.normal;
  const b2Vec2 centre = ball.m_pBody->GetPosition();
  const b2Vec2 poi = centre - ball.m_pBody->GetFixtureList()->GetShape()->m_radius * n;
  const b2Vec2 v = ball.m_pBody->GetLinearVelocity() - shape.m_pBody->GetLinearVelocityFromWorldPoint(poi);
  Report(shape, ball, poi, n, -b2Dot(v, n));
}

void CContactGatherer::MeetTruly(b2Contact& contact, CBody& shape, CBody& ball) {
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  const bool ballIsB = contact.GetFixtureB()->GetBody() == ball.m_pBody;
  const float radii =
      contact.GetFixtureA()->GetShape()->m_radius + contact.GetFixtureB()->GetShape()->m_radius;
  const double r = static_cast<double>(ball.m_pBody->GetFixtureList()->GetShape()->m_radius);

  // In the frame of the shape. Its surface moves there as the frame does at the centre of the ball: across
  // the normal it may differ, but that does not count.
  const b2Transform& xf = shape.m_pBody->GetTransform();
  const b2Vec2 p = ball.m_pBody->GetPosition();
  const Vector2d q = ToDouble(b2MulT(xf, p));
  const Vector2d w = ToDouble(
      b2MulT(xf.q, ball.m_pBody->GetLinearVelocity() - shape.m_pBody->GetLinearVelocityFromWorldPoint(p)));
  COutline disk;
  if (shape.m_bIsBall)
    disk.m_fRadius = static_cast<double>(shape.m_pBody->GetFixtureList()->GetShape()->m_radius);
  const COutline& outline = shape.m_bIsBall ? disk : shape.m_cOutline;
  CTrueContact met = FindTrueContact(outline, q, w, r);
  // What is farther away than the ball is large is another matter than skins and chords.
  if (std::abs(met.m_fTime) * w.norm() > std::max(r, static_cast<double>(4.0f * b2_polygonRadius)))
    met = FindTrueContact(outline, q, Vector2d::Zero(), r);

  const float e = contact.GetRestitution(), slop = b2_linearSlop;
  const b2Vec2 n = b2Mul(xf.q, ToFloat(met.m_vNorm));
  const b2Vec2 nAB = ballIsB ? n : -n;
  const float wn = static_cast<float>(w.dot(met.m_vNorm)), time = static_cast<float>(met.m_fTime);
  const float kick = m_fStep * std::abs(b2Dot(m_vGravity, n));
  const bool isImpact = -wn > std::max(2.0f * slop / m_fStep, 2.0f * kick);
  const bool isWithinSkins = manifold.separations[0] > StopSeparation(radii) + 0.5f * slop;
  b2ManifoldPoint& point = contact.GetManifold()->points[0];

  m_bIsContinuous = m_bIsContinuous || HasMoved(shape) || HasMoved(ball);
  if (m_bIsContinuous && std::exchange(m_bIsIslandOpen, true)) {
    if (!isImpact && isWithinSkins) {
      // It touches, but it is not what was hit: it gets its own impact, after this one. Across the normal of
      // this one neither of them is changed by it.
      b2Vec2 across = b2Cross(1.0f, m_vIslandNormal);
      const b2Vec2 v = contact.GetFixtureB()->GetBody()->GetLinearVelocity() -
                       contact.GetFixtureA()->GetBody()->GetLinearVelocity();
      if (b2Dot(v, across) < 0.0f) across = -across;
      SetManifold(contact, across, 0.0f);
      return;
    }
  } else if (m_bIsContinuous) {
    m_vIslandNormal = n;
  } else if (isImpact) {
    const bool isSwept = !shape.m_bIsBall || shape.m_pBody->IsBullet() || ball.m_pBody->IsBullet();
    // As deep as Box2D lets a ball go, and a bit more.
    const bool willBeStopped = isSwept && manifold.separations[0] > StopSeparation(radii) - 2.0f * slop;
    if (willBeStopped && Waits(contact, shape, ball, nAB)) return;
    Answers(shape, ball);
  }

  if (isImpact) {
    // Too late, it has to be as far on its way back as it has gone too far.
    SetManifold(contact, nAB, time < 0.0f ? SeparationFor((1.0f + e) * wn * time) : 0.0f);
    point.normalImpulse = 0.0f;
  } else {
    SetManifold(contact, nAB, static_cast<float>(met.m_fGap) - slop);
  }

  const Vector2d nd = ToDouble(n);
  float speed = -wn;
  if (wn < 0.0f && m_cTuning.m_bParabolas && isImpact && !shape.m_bIsBall) {
    // The straight way met the shape at `time`, and there the parabola had another speed.
    const double part =
        ball.m_cFlight.PartAt(*ball.m_pBody, ball.m_cStart.p) + met.m_fTime / static_cast<double>(m_fStep);
    speed -= static_cast<float>(
        ball.m_cFlight.Bounce(part, nd, w.dot(met.m_vNorm), static_cast<double>(e)).dot(nd));
  } else if (!isImpact && kick > 0.0f && std::abs(wn) <= 2.0f * kick) {
    Support(contact, shape, ball, n);
  }
  Report(shape, ball, b2Mul(xf, ToFloat(q + met.m_fTime * w - r * met.m_vNorm)), n, speed);
}

bool CContactGatherer::Waits(b2Contact& contact, const CBody& shape, const CBody& ball, const b2Vec2& nAB) {
  const auto isAnswered = [&](const CBody& body) {
    return std::find(m_stdAnswered.begin(), m_stdAnswered.end(), &body) != m_stdAnswered.end();
  };
  FailIf(isAnswered(ball) || (shape.m_bIsBall && isAnswered(shape)));
  // The wrong way round, Box2D sees them part and does nothing; it will stop the ball where it arrives,
  // within this step.
  SetManifold(contact, -nAB, 0.0f);
  contact.GetManifold()->points[0].normalImpulse = 0.0f;
  m_stdWaiting.push_back({&contact, &shape, &ball, nAB});
  return true;
}

void CContactGatherer::Answers(const CBody& shape, const CBody& ball) {
  // A ball that is answered goes another way: what it waits for the wrong way round would hold it back.
  for (const CBody* pBall : {&ball, &shape}) {
    if (!pBall->m_bIsBall) continue;
    m_stdAnswered.push_back(pBall);
    std::erase_if(m_stdWaiting, [&](const CWaiting& waiting) {
      FailIf(waiting.m_pBall != pBall && waiting.m_pShape != pBall);
      SetManifold(*waiting.m_pContact, waiting.m_vNorm, 0.0f);
      return true;
    });
  }
}

void CContactGatherer::Support(b2Contact& contact, CBody& shape, CBody& ball, const b2Vec2& n) {
  // What lies on a shape, or on a ball that lies, is not pressed into it by gravity, and does not bounce off
  // it.
  const bool ballIsUpper = b2Dot(m_vGravity, n) < 0.0f;
  const CBody& below = ballIsUpper ? shape : ball;
  if (below.m_bIsBall ? !below.m_bIsSupported && !below.m_bWasSupported : !ballIsUpper) return;
  CBody& upper = ballIsUpper ? ball : shape;
  upper.m_bIsSupported = true;
  upper.m_cFlight.Rest(ToDouble(ballIsUpper ? n : -n));
  if (contact.GetRestitution() < 1.0f) contact.SetRestitution(0.0f);
}

void CContactGatherer::Report(const CBody& shape, const CBody& ball, const b2Vec2& poi, const b2Vec2& n,
                              float speed) {
  CContactEvent event;
  event.m_cShape = shape.m_cId;
  event.m_cBall = ball.m_cId;
  event.m_vPOI = m_cScale.FromMetres(poi);
  event.m_vNorm = Vector2(n.x, n.y);
  event.m_fSpeed = m_cScale.FromMetres(std::max(0.0f, speed));
  m_stdEvents.push_back(event);
  m_stdBends.push_back(
      {ball.m_cId, ball.m_pBody->GetPosition(), ball.m_cFlight.PartAt(*ball.m_pBody, ball.m_cStart.p)});
  if (shape.m_bIsBall)
    m_stdBends.push_back({shape.m_cId, shape.m_pBody->GetPosition(),
                          shape.m_cFlight.PartAt(*shape.m_pBody, shape.m_cStart.p)});
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

} // namespace Shapes::Box2D
