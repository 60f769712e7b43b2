// SPDX-License-Identifier: MIT
#include "ContactGatherer.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Shapes::Box2D {
namespace {

Vector2d ToDouble(const b2Vec2& v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }
Vector2d MulT(const b2Rot& q, const Vector2d& v) {
  const double c = static_cast<double>(q.c), s = static_cast<double>(q.s);
  return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()};
}
b2Vec2 ToFloat(const Vector2d& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

// How far apart the skins are when b2TimeOfImpact says that they touch.
float StopSeparation(const b2Contact& contact) {
  const float radii =
      contact.GetFixtureA()->GetShape()->m_radius + contact.GetFixtureB()->GetShape()->m_radius;
  return std::max(-3.0f * b2_linearSlop, b2_linearSlop - radii);
}

// The separation that makes Box2D push two shapes apart by at least `push` at a time of impact, and by how
// much it does then. It takes .75 of what is beyond the slop in each round, and stops after the round that
// began within another half of a slop.
float SeparationFor(float push, float& pushed) {
  float left = 1.0f, beyond = push / 0.75f;
  do {
    left *= 0.25f;
  } while (beyond * left * 4.0f > 0.5f * b2_linearSlop);
  pushed = beyond * (1.0f - left);
  return -b2_linearSlop - beyond;
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

// The wrong way round, Box2D sees two shapes part, and does nothing.
void Ignore(b2Contact& contact, const b2Vec2& n) {
  SetManifold(contact, -n, 0.0f);
  contact.GetManifold()->points[0].normalImpulse = 0.0f;
}

// Across the normal of what is answered, nothing is changed by the answer.
void IgnoreAcross(b2Contact& contact, const b2Vec2& answered) {
  b2Vec2 across = b2Cross(1.0f, answered);
  const b2Vec2 v = contact.GetFixtureB()->GetBody()->GetLinearVelocity() -
                   contact.GetFixtureA()->GetBody()->GetLinearVelocity();
  if (b2Dot(v, across) < 0.0f) across = -across;
  SetManifold(contact, across, 0.0f);
  contact.GetManifold()->points[0].normalImpulse = 0.0f;
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
  const b2Vec2 poi = centre - ball.m_fRadius * n;
  const b2Vec2 v = ball.m_pBody->GetLinearVelocity() - shape.m_pBody->GetLinearVelocityFromWorldPoint(poi);
  Report(shape, ball, poi, n, -b2Dot(v, n));
}

void CContactGatherer::MeetTruly(b2Contact& contact, CBody& shape, CBody& ball) {
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  m_bIsContinuous = m_bIsContinuous || HasMoved(shape) || HasMoved(ball);
  const double part = m_bIsContinuous ? PartAt(shape, ball) : 0.0;
  Vector2d dp, dv;
  ball.m_cFlight.GetDeviation(part, dp, dv);
  if (shape.m_bIsBall) {
    Vector2d dp1, dv1;
    shape.m_cFlight.GetDeviation(part, dp1, dv1);
    dp -= dp1, dv -= dv1;
  }
  // In the frame of the shape. Its surface moves there as the frame does at the centre of the ball: across
  // the normal it may differ, but that does not count.
  const b2Transform& xf = shape.m_pBody->GetTransform();
  const b2Vec2 p = ball.m_pBody->GetPosition();
  const b2Vec2 v = ball.m_pBody->GetLinearVelocity() - shape.m_pBody->GetLinearVelocityFromWorldPoint(p);
  const Vector2d q = ToDouble(b2MulT(xf, p)) + MulT(xf.q, dp), w = MulT(xf.q, ToDouble(v) + dv);
  const double r = static_cast<double>(ball.m_fRadius);
  CTrueContact met = FindTrueContact(shape.m_cOutline, q, w, r);
  // Longer ago than a step was no impact: they have been put into each other.
  if (met.m_fTime < static_cast<double>(-m_fStep))
    met = FindTrueContact(shape.m_cOutline, q, Vector2d::Zero(), r);
  const b2Vec2 n = b2Mul(xf.q, ToFloat(met.m_vNorm));
  const b2Vec2 nAB = contact.GetFixtureB()->GetBody() == ball.m_pBody ? n : -n;
  const float gap = static_cast<float>(met.m_fGap);

  if (m_bIsIslandOpen) {
    IgnoreAcross(contact, m_vIslandNormal); // it gets its own impact, after this one
    return;
  }
  for (const CAnswer& answer : m_stdAnswered)
    if (answer.m_pShape == &shape && answer.m_pBall == &ball) {
      IgnoreAcross(contact, answer.m_vNorm); // another edge of the same shape
      return;
    }

  CFlight::CImpact impact;
  impact.m_fPart = part;
  impact.m_vNorm = ToDouble(n);
  impact.m_fSpeed = ToDouble(v).dot(impact.m_vNorm);
  impact.m_fElasticity = static_cast<double>(contact.GetRestitution());
  const float wn = static_cast<float>(impact.m_fSpeed);
  const double time = (w.dot(met.m_vNorm) * met.m_fTime + dp.dot(impact.m_vNorm)) / impact.m_fSpeed;
  if (wn < 0.0f && std::abs(time) <= static_cast<double>(m_fStep)) impact.m_fTime = time;
  const double m = static_cast<double>(ball.m_pBody->GetMass()),
               m1 = static_cast<double>(shape.m_pBody->GetMass());
  const double share = shape.m_bIsBall ? m1 / (m + m1) : 1.0;
  CFlight* pOther = shape.m_bIsBall ? &shape.m_cFlight : nullptr;
  // Where they are when they are stopped they would be stopped again at once.
  const auto pushApart = [&] {
    m_bIsIslandOpen = true;
    m_vIslandNormal = n;
    const float depth = StopSeparation(contact) - manifold.separations[0];
    float pushed = 0.0f;
    SetManifold(contact, nAB, SeparationFor(std::max(0.0f, depth) + b2_linearSlop, pushed));
    const Vector2d way = static_cast<double>(pushed) * impact.m_vNorm;
    ball.m_cFlight.Shift(-share * way);
    if (pOther != nullptr) pOther->Shift((1.0 - share) * way);
  };
  float speed = static_cast<float>(-w.dot(met.m_vNorm));
  // So slow that it is pressed rather than hit: that is what Box2D's own solver is good at.
  const bool isPress =
      std::abs(speed) * m_fStep <= std::max(b2_linearSlop, m_fStep * m_fStep * m_vGravity.Length());
  if (IsSupport(contact, shape, ball, impact, met.m_fGap, static_cast<double>(speed)) ||
      (isPress && gap <= speed * m_fStep)) {
    // What lies is pressed into what is beside it too, and does not bounce off that.
    const bool lies = ball.m_bWasSupported || shape.m_bWasSupported;
    if (lies && impact.m_fElasticity < 1.0) contact.SetRestitution(0.0f);
    if (m_bIsContinuous && gap > 0.0f)
      pushApart();
    else
      SetManifold(contact, nAB, gap - b2_linearSlop);
    m_bIsIslandOpen = m_bIsContinuous;
    m_vIslandNormal = n;
  } else if (!(wn < 0.0f)) {
    if (m_bIsContinuous && met.m_bMisses)
      contact.SetEnabled(false); // or Box2D would stop the ball here again and again
    else if (m_bIsContinuous)
      pushApart();
    else
      SetManifold(contact, nAB, wn > 0.0f ? 0.0f : gap - b2_linearSlop);
    return;
  } else if (met.m_fTime > (1.0 - impact.m_fPart) * static_cast<double>(m_fStep)) {
    // Only their skins meet in this step.
    if (m_bIsContinuous)
      contact.SetEnabled(false);
    else
      Ignore(contact, nAB);
    return;
  } else {
    const bool isSwept = !shape.m_bIsBall || shape.m_pBody->IsBullet() || ball.m_pBody->IsBullet();
    // b2TimeOfImpact knows no shapes that are on each other without their skins.
    const float radii =
        contact.GetFixtureA()->GetShape()->m_radius + contact.GetFixtureB()->GetShape()->m_radius;
    if (!m_bIsContinuous && isSwept && manifold.separations[0] + radii > b2_linearSlop) {
      Ignore(contact, nAB); // Box2D will stop the ball where it arrives, within this step
      return;
    }
    contact.GetManifold()->points[0].normalImpulse = 0.0f;
    if (!m_bIsContinuous) m_stdAnswered.push_back({&shape, &ball, n});
    speed = static_cast<float>(CFlight::Bounce(impact, ball.m_cFlight, share, pOther));
    if (m_bIsContinuous)
      pushApart();
    else
      SetManifold(contact, nAB, 0.0f);
  }
  Report(shape, ball, b2Mul(xf, ToFloat(q + met.m_fTime * w - r * met.m_vNorm)), n, speed);
}

double CContactGatherer::PartAt(const CBody& shape, const CBody& ball) const {
  // By that which goes farther.
  const float way = ball.m_pBody->GetLinearVelocity().LengthSquared();
  if (shape.m_bIsBall && shape.m_pBody->GetLinearVelocity().LengthSquared() > way)
    return shape.m_cFlight.PartAt(*shape.m_pBody, shape.m_cStart.p);
  const double turn = static_cast<double>(shape.m_pBody->GetAngularVelocity() * m_fStep);
  if (shape.m_bIsBall || way > 0.0f || turn == 0.0)
    return ball.m_cFlight.PartAt(*ball.m_pBody, ball.m_cStart.p);
  const b2Rot turned = b2MulT(shape.m_cStart.q, shape.m_pBody->GetTransform().q);
  return std::clamp(static_cast<double>(turned.GetAngle()) / turn, 0.0, 1.0);
}

bool CContactGatherer::IsSupport(b2Contact& contact, CBody& shape, CBody& ball,
                                 const CFlight::CImpact& impact, double gap, double speed) {
  // What lies on a shape, or on a ball that lies, is not pressed into it by gravity, and does not bounce off
  // it.
  const Vector2d& n = impact.m_vNorm;
  const double pull = ToDouble(m_vGravity).dot(n), kick = static_cast<double>(m_fStep) * std::abs(pull);
  FailIf(kick == 0.0);
  // A perfect ball lies where it would bounce more than once in a step, any other a bit before that.
  const double most = impact.m_fElasticity < 1.0 ? 1.5 : 0.5;
  FailIf(speed > most * kick || speed < -0.25 * kick || gap > static_cast<double>(b2_linearSlop));
  const bool ballIsUpper = pull < 0.0;
  const CBody& below = ballIsUpper ? shape : ball;
  FailIf(below.m_bIsBall ? !below.m_bIsSupported && !below.m_bWasSupported : !ballIsUpper);
  CBody& upper = ballIsUpper ? ball : shape;
  upper.m_bIsSupported = true;
  upper.m_cFlight.Rest(ballIsUpper ? n : Vector2d(-n));
  contact.SetRestitution(0.0f);
  return true;
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
  for (const CBody* pBall : {&ball, &shape})
    if (pBall->m_bIsBall)
      m_stdBends.push_back({pBall->m_cId,
                            pBall == &ball ? poi + ball.m_fRadius * n : poi - shape.m_fRadius * n,
                            PartAt(shape, ball)});
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
