// SPDX-License-Identifier: MIT
#include "PreSolveOverride.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Box2D {
namespace {

Vector2d MulT(const b2Rot& q, const Vector2d& v) {
  const double c = static_cast<double>(q.c), s = static_cast<double>(q.s);
  return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()};
}

float Radii(const b2Contact& contact) {
  return contact.GetFixtureA()->GetShape()->m_radius + contact.GetFixtureB()->GetShape()->m_radius;
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
  const b2Body &a = *contact.GetFixtureA()->GetBody(), &b = *contact.GetFixtureB()->GetBody();
  const b2Vec2 clip = b2Mul(b.GetTransform(), manifold.points[0].localPoint);
  manifold.type = b2Manifold::e_faceA;
  manifold.localNormal = b2MulT(a.GetTransform().q, n);
  manifold.localPoint = b2MulT(a.GetTransform(), clip - (separation + Radii(contact)) * n);
}

// The wrong way round, Box2D sees two shapes part, and does nothing.
void Ignore(b2Contact& contact, const b2Vec2& n) {
  SetManifold(contact, -n, 0.0f);
  contact.GetManifold()->points[0].normalImpulse = 0.0f;
}

// The response changes nothing across the normal of the resolved contact.
void IgnoreAcross(b2Contact& contact, const b2Vec2& answered, const CBody& ball) {
  b2Vec2 across = b2Cross(1.0f, answered);
  const b2Vec2 p = ball.m_pBody->GetPosition(); // what turns has another velocity everywhere
  const b2Vec2 v = contact.GetFixtureB()->GetBody()->GetLinearVelocityFromWorldPoint(p) -
                   contact.GetFixtureA()->GetBody()->GetLinearVelocityFromWorldPoint(p);
  if (b2Dot(v, across) < 0.0f) across = -across;
  Ignore(contact, -across);
}

// The ball's part of an impact: the share of the other's mass in that of both.
double ShareOf(const CBody& shape, const CBody& ball) {
  // A game may hold a ball.
  if (ball.m_pBody->GetType() != b2_dynamicBody) return 0.0;
  if (shape.m_pBody->GetType() != b2_dynamicBody) return 1.0;
  const double m = static_cast<double>(ball.m_pBody->GetMass()),
               m1 = static_cast<double>(shape.m_pBody->GetMass());
  return m1 / (m + m1);
}

// Of a ball so small that rounding decides on which side of a shape it lies: how far off it is kept.
float MarginOf(const CBody& ball) { return std::max(0.0f, g_fLeastRest * b2_linearSlop - ball.m_fRadius); }

// A ball that is around a ring, and too large for it, has no way out of it.
bool IsAround(const CBody& shape, const CBody& ball) {
  const CContactGeometry& o = shape.m_cGeometry;
  FailIf(!o.m_bFull || static_cast<double>(ball.m_fRadius) < o.m_fRadius);
  const b2Vec2 q = b2MulT(shape.m_pBody->GetTransform(), ball.m_pBody->GetPosition());
  return (ToDouble(q) - o.m_vCentre).norm() < o.m_fRadius;
}

// Whether a body is on its way through the step.
bool HasMoved(const CBody& body) {
  const b2Transform &now = body.m_pBody->GetTransform(), &then = body.m_cStart;
  return body.m_pBody->GetType() != b2_staticBody &&
         !(now.p == then.p && now.q.s == then.q.s && now.q.c == then.q.c);
}

} // namespace

// A contact as it really is.
struct CPreSolveOverride::CInspected {
  b2Contact& m_cContact;
  float m_fSkins;   // separation of the skins
  b2Vec2 m_vNorm;   // to the ball
  b2Vec2 m_vNormAB; // from fixture A to fixture B
  float m_fGap;     // between the shapes themselves
  double m_fSpeed;  // of approach on the parabolas
  double m_fTime;   // seconds until they meet on these
  bool m_bMisses;
  b2Vec2 m_vPOI; // where they do
  CParabolicCorrection::CImpact m_cImpact;
};

void CPreSolveOverride::BeginStep(const b2Vec2& g, float h, float weight) {
  m_vGravity = g;
  m_fStep = h;
  m_fLastingWeight = weight;
  m_bIsContinuous = m_bIsIslandOpen = false;
  m_stdEarly.clear();
}

void CPreSolveOverride::AfterSolve() {
  m_bIsContinuous = true; // what was seen in the first look has been solved
  m_bIsIslandOpen = false;
}

void CPreSolveOverride::OpenIsland(const b2Vec2& n) {
  m_bIsIslandOpen = m_bIsContinuous;
  m_vIslandNormal = n;
}

std::optional<CPreSolveOverride::CResolution> CPreSolveOverride::Override(b2Contact& contact, CBody& shape,
                                                                          CBody& ball, bool canWait) {
  m_bIsContinuous = m_bIsContinuous || HasMoved(shape) || HasMoved(ball);
  if (IsAround(shape, ball)) {
    contact.SetEnabled(false);
    return {};
  }
  if (ball.m_bIsLasting && (shape.m_bIsLasting || !shape.m_bIsBall))
    return LeaveToSolver(contact, shape, ball);
  if (m_bIsIslandOpen) {
    IgnoreAcross(contact, m_vIslandNormal, ball); // it gets its own impact, after this one
    return {};
  }
  for (const CEarly& early : m_stdEarly)
    if (early.m_pShape == &shape && early.m_pBall == &ball) {
      IgnoreAcross(contact, early.m_vNorm, ball); // another edge of the same shape
      return {};
    }

  CInspected inspected = Inspect(contact, shape, ball);
  CParabolicCorrection::CImpact& impact = inspected.m_cImpact;
  CResolution resolution{inspected.m_vPOI, inspected.m_vNorm, static_cast<float>(inspected.m_fSpeed), 0.0f};
  if (ResolvePress(inspected, shape, ball, resolution)) return resolution;

  const bool approaches = impact.m_fSpeed < 0.0;
  const double left = (1.0 - impact.m_fPart) * static_cast<double>(m_fStep);
  if (inspected.m_bMisses || (approaches && inspected.m_fTime > left)) {
    // Only their skins meet in this step. In the second pass Box2D would stop the ball here again and again.
    if (m_bIsContinuous || !canWait)
      contact.SetEnabled(false);
    else
      Ignore(contact, inspected.m_vNormAB);
    return {};
  }
  if (!m_bIsContinuous && approaches) {
    // b2TimeOfImpact knows no pairs of balls without a bullet, and nothing that is on another without its
    // skin.
    const bool isSwept = ball.m_pBody->GetWorld()->GetContinuousPhysics() &&
                         (!shape.m_bIsBall || shape.m_pBody->IsBullet() || ball.m_pBody->IsBullet());
    if (isSwept && canWait && inspected.m_fSkins + Radii(contact) > b2_linearSlop) {
      Ignore(contact, inspected.m_vNormAB); // Box2D will stop the ball where it arrives
      return {};
    }
    m_stdEarly.push_back({&shape, &ball, inspected.m_vNorm});
  }
  if (approaches) {
    contact.GetManifold()->points[0].normalImpulse = 0.0f;
    resolution.m_fSpeed = static_cast<float>(CParabolicCorrection::Bounce(
        impact, ball.m_cCorrection, ShareOf(shape, ball), shape.m_bIsBall ? &shape.m_cCorrection : nullptr));
    // Box2D knows the mean speed of the parabola.
    resolution.m_fUnsolved = static_cast<float>((1.0 + impact.m_fElasticity) * ShareOf(shape, ball)) *
                             ball.m_pBody->GetMass() *
                             (resolution.m_fSpeed + static_cast<float>(impact.m_fSpeed));
    if (!shape.m_bIsBall && m_vGravity != b2Vec2_zero) ball.m_pBouncedOff = &shape;
  }
  if (m_bIsContinuous)
    SeparateShapes(inspected, shape, ball);
  else
    SetManifold(contact, inspected.m_vNormAB,
                impact.m_fSpeed == 0.0 ? inspected.m_fGap - b2_linearSlop : 0.0f);
  return approaches ? std::optional(resolution) : std::nullopt;
}

void CPreSolveOverride::Land(CBody& ball) {
  if (ball.m_pBody->GetType() != b2_dynamicBody) return;
  const b2Vec2 from = ball.m_pBody->GetPosition();
  ball.m_cCorrection.Land(*ball.m_pBody);
  if (ball.m_pBouncedOff == nullptr) return;
  // Gravity after a bounce may move the ball by more than the bounce: half a radius at most.
  const CBody& shape = *ball.m_pBouncedOff;
  const b2Transform& xf = shape.m_pBody->GetTransform();
  const CExactContact exact = FindExactContact(shape.m_cGeometry, ToDouble(b2MulT(xf, from)),
                                               Vector2d::Zero(), static_cast<double>(ball.m_fRadius));
  const b2Vec2 n = b2Mul(xf.q, ToFloat(exact.m_vNorm)), to = ball.m_pBody->GetPosition();
  const float gap = static_cast<float>(exact.m_fGap) + b2Dot(to - from, n);
  if (gap < -0.5f * ball.m_fRadius && exact.m_fGap > -0.5 * static_cast<double>(ball.m_fRadius))
    ball.m_pBody->SetTransform(to + (MarginOf(ball) - gap) * n, 0.0f);
}

void CPreSolveOverride::FollowOther(b2Contact& contact, CBody& other, CBody& ball) {
  m_bIsContinuous = m_bIsContinuous || HasMoved(ball);
  if (m_vGravity == b2Vec2_zero) return;
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  CInspected inspected{
      contact, manifold.separations[0], {}, manifold.normal, manifold.separations[0], 0.0, 0.0, false, {},
      {}};
  inspected.m_vNorm = contact.GetFixtureB()->GetBody() == ball.m_pBody ? manifold.normal : -manifold.normal;
  inspected.m_vPOI = ball.m_pBody->GetPosition() - ball.m_fRadius * inspected.m_vNorm;
  CParabolicCorrection::CImpact& impact = inspected.m_cImpact;
  impact.m_fPart = m_bIsContinuous ? PartAt(other, ball) : 0.0;
  impact.m_vNorm = ToDouble(inspected.m_vNorm);
  impact.m_fSpeed = ToDouble(ball.m_pBody->GetLinearVelocity() -
                             other.m_pBody->GetLinearVelocityFromWorldPoint(inspected.m_vPOI))
                        .dot(impact.m_vNorm);
  impact.m_fElasticity = static_cast<double>(contact.GetRestitution());
  if (!(impact.m_fSpeed < 0.0)) return;
  Vector2d dp, dv;
  ball.m_cCorrection.GetDeviation(impact.m_fPart, dp, dv);
  // Of a ball that has been given all of the gravity step, as it was before that.
  if (ball.m_bHasWeight) dv = -static_cast<double>(m_fStep) * ToDouble(m_vGravity);
  inspected.m_fSpeed = -impact.m_fSpeed - dv.dot(impact.m_vNorm);
  if (IsSupport(inspected, other, ball)) {
    contact.SetRestitution(0.0f);
    ball.m_bLiesOnOther = true;
  } else if (other.m_pBody->GetType() != b2_dynamicBody) {
    CParabolicCorrection::Bounce(impact, ball.m_cCorrection, 1.0, nullptr);
    if (m_bIsContinuous) SeparateShapes(inspected, other, ball); // that does not lift it
  }
}

CPreSolveOverride::CInspected CPreSolveOverride::Inspect(b2Contact& contact, const CBody& shape,
                                                         const CBody& ball) const {
  const double h = static_cast<double>(m_fStep), part = m_bIsContinuous ? PartAt(shape, ball) : 0.0;
  Vector2d dp, dv;
  ball.m_cCorrection.GetDeviation(part, dp, dv);
  if (shape.m_bIsBall) {
    Vector2d dp1, dv1;
    shape.m_cCorrection.GetDeviation(part, dp1, dv1);
    dp -= dp1, dv -= dv1;
  }
  // In the frame of the shape. Its surface moves there as the frame does at the centre of the ball: across
  // the normal it may differ, but that does not count.
  const b2Transform& xf = shape.m_pBody->GetTransform();
  const b2Vec2 p = ball.m_pBody->GetPosition();
  const b2Vec2 v = ball.m_pBody->GetLinearVelocity() - shape.m_pBody->GetLinearVelocityFromWorldPoint(p);
  const Vector2d q = ToDouble(b2MulT(xf, p)) + MulT(xf.q, dp), w = MulT(xf.q, ToDouble(v) + dv);
  const double r = static_cast<double>(ball.m_fRadius);
  CExactContact exact = FindExactContact(shape.m_cGeometry, q, w, r);
  // Longer ago than a step was no impact: they have been put into each other.
  if (exact.m_fTime < -h) exact = FindExactContact(shape.m_cGeometry, q, Vector2d::Zero(), r);

  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  CInspected inspected{contact, manifold.separations[0], {}, {}, static_cast<float>(exact.m_fGap), 0.0,
                       0.0,     exact.m_bMisses,         {}, {}};
  inspected.m_vNorm = b2Mul(xf.q, ToFloat(exact.m_vNorm));
  inspected.m_vNormAB =
      contact.GetFixtureB()->GetBody() == ball.m_pBody ? inspected.m_vNorm : -inspected.m_vNorm;
  inspected.m_fSpeed = -w.dot(exact.m_vNorm);
  inspected.m_fTime = exact.m_fTime;
  inspected.m_vPOI = b2Mul(xf, ToFloat(q + exact.m_fTime * w - r * exact.m_vNorm));

  CParabolicCorrection::CImpact& impact = inspected.m_cImpact;
  impact.m_fPart = part;
  impact.m_vNorm = ToDouble(inspected.m_vNorm);
  impact.m_fSpeed = ToDouble(v).dot(impact.m_vNorm);
  impact.m_fElasticity = static_cast<double>(contact.GetRestitution());
  if (impact.m_fSpeed < 0.0) {
    const double time = (dp.dot(impact.m_vNorm) - inspected.m_fSpeed * exact.m_fTime) / impact.m_fSpeed;
    if (std::abs(time) <= h) impact.m_fTime = time;
  }
  return inspected;
}

// Box2D solves all contacts of what lasts at once, as they are now.
std::optional<CPreSolveOverride::CResolution>
CPreSolveOverride::LeaveToSolver(b2Contact& contact, const CBody& shape, const CBody& ball) {
  const b2Transform& xf = shape.m_pBody->GetTransform();
  const b2Vec2 p = ball.m_pBody->GetPosition(), surface = shape.m_pBody->GetLinearVelocityFromWorldPoint(p);
  const CExactContact exact = FindExactContact(shape.m_cGeometry, ToDouble(b2MulT(xf, p)), Vector2d::Zero(),
                                               static_cast<double>(ball.m_fRadius));
  b2Vec2 n = b2Mul(xf.q, ToFloat(exact.m_vNorm));
  const float gap = static_cast<float>(exact.m_fGap);
  // A row that walls press together would stay in line for ever, ball in ball.
  if (shape.m_bIsBall && gap < -g_fCrushed * std::min(ball.m_fRadius, shape.m_fRadius)) {
    b2Vec2 down = m_vGravity;
    down.Normalize();
    n += (ball.m_cId.m_nValue % 2 == 0 ? -g_fCrushedTilt : g_fCrushedTilt) * down;
    n.Normalize();
  }
  if (m_bIsContinuous && !m_bIsIslandOpen && !shape.m_bIsBall) {
    // Stopped here, it would lose the way by which the others have pushed it out of themselves.
    const float left = static_cast<float>(1.0 - PartAt(shape, ball)) * m_fStep;
    const b2Vec2 way = ball.m_cCorrection.GetMotionEnd() - p - left * surface;
    if (-gap - b2Dot(way, n) < g_fLastingDepth * ball.m_fRadius) {
      contact.SetEnabled(false);
      return {};
    }
  }
  OpenIsland(n);
  // At a time of impact Box2D would move a ball out of others at once and unswept, be it through a shape.
  const float kept = m_bIsContinuous && shape.m_bIsBall ? std::max(0.0f, gap) : gap;
  SetManifold(contact, contact.GetFixtureB()->GetBody() == ball.m_pBody ? n : -n, kept - b2_linearSlop);
  // Box2D begins with the impulse of the last step. A resting ball presses by its weight at most; a row
  // between walls keeps any impulse, as it is balanced, and would be shot out with it.
  float& impulse = contact.GetManifold()->points[0].normalImpulse;
  impulse = std::min(impulse, m_fStep * m_fLastingWeight);
  const float approach = -b2Dot(ball.m_pBody->GetLinearVelocity() - surface, n);
  if (!(approach > 0.0f)) return {};
  const float nearing = std::max(0.0f, gap) / m_fStep; // as fast as that they touch at the end of the step
  if (approach < nearing) {
    contact.SetRestitution(-1.0f); // no response
    return {};
  }
  // The ball bounces off as it would have before the gravity step, and then gets that. A contact that
  // gravity presses together does not bounce, and may close its gap: then the restitution is less than 0, the
  // share of the approach that is left.
  const float press = m_bIsContinuous || shape.m_bIsBall ? 0.0f : -m_fStep * b2Dot(m_vGravity, n);
  const float before = approach - press;
  float bounce = -nearing;
  if (before > static_cast<float>(g_fRestingSpeed) * m_fStep * m_vGravity.Length())
    bounce = std::max(bounce, contact.GetRestitution() * before - press);
  contact.SetRestitution(bounce / approach);
  return CResolution{p - ball.m_fRadius * n, n, before, 0.0f};
}

// Whether the two press on each other rather than collide; resolves the press then.
bool CPreSolveOverride::ResolvePress(const CInspected& inspected, CBody& shape, CBody& ball,
                                     CResolution& resolution) {
  // Box2D's own solver handles moves below its slop best.
  const float move = static_cast<float>(inspected.m_fSpeed) * m_fStep;
  const float fall = m_fStep * m_fStep * m_vGravity.Length();
  const bool isPress =
      std::abs(move) <= g_fPressMove * std::max(b2_linearSlop, fall) && inspected.m_fGap <= move;
  const bool isSupport = IsSupport(inspected, shape, ball);
  FailIf(!isPress && !isSupport);
  if (isSupport) { // the half of the gravity step that a resting ball is not given after the step
    CBody& upper = b2Dot(m_vGravity, inspected.m_vNorm) < 0.0f ? ball : shape;
    upper.m_bLiesOnOwn = true;
    resolution.m_fUnsolved =
        0.5f * m_fStep * std::abs(b2Dot(m_vGravity, inspected.m_vNorm)) * upper.m_pBody->GetMass();
  }
  // A resting ball does not bounce off its support, nor off its neighbours.
  if (isSupport ||
      (inspected.m_cImpact.m_fElasticity < 1.0 && (ball.m_bWasSupported || shape.m_bWasSupported)))
    inspected.m_cContact.SetRestitution(0.0f);
  if (m_bIsContinuous && inspected.m_fGap > 0.0f) {
    SeparateShapes(inspected, shape, ball);
  } else {
    SetManifold(inspected.m_cContact, inspected.m_vNormAB,
                inspected.m_fGap - b2_linearSlop - (isSupport && !shape.m_bIsBall ? MarginOf(ball) : 0.0f));
    OpenIsland(inspected.m_vNorm);
  }
  return true;
}

// Whether gravity presses a ball onto a shape, or onto a ball at rest; it is not given that gravity step
// then.
bool CPreSolveOverride::IsSupport(const CInspected& inspected, CBody& shape, CBody& ball) const {
  const Vector2d& n = inspected.m_cImpact.m_vNorm;
  const double pull = ToDouble(m_vGravity).dot(n),
               gravityStep = static_cast<double>(m_fStep) * std::abs(pull);
  // Box2D stops a ball that is smaller than its slop a slop away.
  FailIf(gravityStep == 0.0 || inspected.m_fGap > b2_linearSlop + 2.0f * MarginOf(ball));
  // A perfect ball lies where it would bounce more than once in a step, any other a bit before that.
  const double most = inspected.m_cImpact.m_fElasticity < 1.0 ? g_fRestingSpeed : g_fElasticRestingSpeed;
  FailIf(inspected.m_fSpeed > most * gravityStep || inspected.m_fSpeed < -g_fLiftSpeed * gravityStep);
  const bool ballIsUpper = pull < 0.0;
  const CBody& below = ballIsUpper ? shape : ball;
  FailIf(below.m_bIsBall ? !below.m_bIsSupported && !below.m_bWasSupported : !ballIsUpper);
  CBody& upper = ballIsUpper ? ball : shape;
  upper.m_bIsSupported = true;
  upper.m_cCorrection.Rest(ballIsUpper ? n : Vector2d(-n));
  return true;
}

// At a time of impact: where they are stopped they would be stopped again at once.
void CPreSolveOverride::SeparateShapes(const CInspected& inspected, CBody& shape, CBody& ball) {
  OpenIsland(inspected.m_vNorm);
  const float stop = std::max(-3.0f * b2_linearSlop, b2_linearSlop - Radii(inspected.m_cContact));
  float pushed = 0.0f;
  const float push = std::max(0.0f, stop - inspected.m_fSkins) + b2_linearSlop;
  SetManifold(inspected.m_cContact, inspected.m_vNormAB, SeparationFor(push, pushed));
  const Vector2d way = static_cast<double>(pushed) * inspected.m_cImpact.m_vNorm;
  const double share = ShareOf(shape, ball);
  ball.m_cCorrection.Shift(-share * way);
  if (shape.m_bIsBall) shape.m_cCorrection.Shift((1.0 - share) * way);
}

double CPreSolveOverride::PartAt(const CBody& shape, const CBody& ball) const {
  const float way = ball.m_pBody->GetLinearVelocity().LengthSquared();
  if (shape.m_bIsBall && shape.m_pBody->GetLinearVelocity().LengthSquared() > way)
    return shape.m_cCorrection.PartAt(*shape.m_pBody, shape.m_cStart.p);
  const double turn = static_cast<double>(shape.m_pBody->GetAngularVelocity() * m_fStep);
  const b2Vec2 move = m_fStep * shape.m_pBody->GetLinearVelocity();
  if (shape.m_bIsBall || way > 0.0f || (turn == 0.0 && move == b2Vec2_zero))
    return ball.m_cCorrection.PartAt(*ball.m_pBody, ball.m_cStart.p);
  if (!(move == b2Vec2_zero))
    return std::clamp(static_cast<double>(b2Dot(shape.m_pBody->GetPosition() - shape.m_cStart.p, move) /
                                          move.LengthSquared()),
                      0.0, 1.0);
  const b2Rot turned = b2MulT(shape.m_cStart.q, shape.m_pBody->GetTransform().q);
  return std::clamp(static_cast<double>(turned.GetAngle()) / turn, 0.0, 1.0);
}

} // namespace Shapes::Box2D
