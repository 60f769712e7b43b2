// SPDX-License-Identifier: MIT
#include "Bodies.h"

#include "../../Tolerances.h"
#include "../../geometry/VisitShape.h"
#include "FixtureShapes.h"

#include <algorithm>

namespace Shapes::Box2D {
namespace {

// Metres of Box2D; two balls share what both reach beyond themselves.
constexpr float g_fBothSkins = g_fSkinSlops * b2_linearSlop;
constexpr float g_fBallSkin = 0.5f * g_fBothSkins;

template <class TShape>
void SetEnds(const TShape& shape, const Vector2& origin, const CScale& scale, const CSharedEnds& sharedEnds,
             CContactGeometry& geometry) {
  Vector2 p[2], t[2];
  shape.GetEndPts(p[0], p[1]);
  shape.GetTangents(t[0], t[1]);
  CContactGeometry::CEnd* pEnds[2] = {&geometry.m_cEnd0, &geometry.m_cEnd1};
  for (std::size_t i = 0; i < 2; ++i) {
    pEnds[i]->m_vPos = ToDouble(scale.ToMetres(p[i] - origin));
    pEnds[i]->m_vOut = -t[i].cast<double>();
    if (!sharedEnds[i]) continue;
    pEnds[i]->m_bIsShared = true;
    pEnds[i]->m_vNext = sharedEnds[i]->m_vTangent.cast<double>();
    pEnds[i]->m_fBend = static_cast<double>(scale.FromMetres(sharedEnds[i]->m_fBend));
  }
}

CContactGeometry MakeContactGeometry(const CShape& shape, const Vector2& origin, const CScale& scale,
                                     const CSharedEnds& sharedEnds) {
  CContactGeometry geometry;
  geometry.m_vCentre = ToDouble(scale.ToMetres(shape.GetPos() - origin));
  const auto setRadius = [&](float r) { geometry.m_fRadius = static_cast<double>(scale.ToMetres(r)); };
  VisitShape(shape, CPerShape{[](const CPoint&) {},
                              [&](const CLineSeg& seg) {
                                if (seg.GetEndPt0() == seg.GetEndPt1()) return;
                                geometry.m_eKind = CContactGeometry::eKind::LineSeg;
                                geometry.m_bIsOneSided = seg.GetSides() != eSides::Both;
                                SetEnds(seg, origin, scale, sharedEnds, geometry);
                              },
                              [&](const CCircle& circle) { setRadius(circle.GetRadius()); },
                              [&](const CArc& arc) {
                                geometry.m_eKind = CContactGeometry::eKind::Arc;
                                geometry.m_bIsOneSided = arc.GetSides() != eSides::Both;
                                setRadius(arc.GetRadius());
                                geometry.m_bFull = arc.IsFullCircle();
                                geometry.m_bLong = arc.GetSpan() > g_fPi;
                                SetEnds(arc, origin, scale, sharedEnds, geometry);
                              }});
  return geometry;
}

// Directly, not by density: a ball of radius 0 has a mass too, and it must be in place after the fixture.
void SetMass(b2Body& body, float mass) {
  b2MassData data;
  data.mass = mass;
  data.center.SetZero();
  data.I = 0.0f;
  body.SetMassData(&data);
}

// Where the body is, or would be.
std::vector<CBody*>::iterator FindIn(std::vector<CBody*>& bodies, CShapeId id) {
  return std::lower_bound(bodies.begin(), bodies.end(), id,
                          [](const CBody* pBody, CShapeId i) { return pBody->m_cId < i; });
}

// All that touch the body.
void WakeAll(const b2Body& body) {
  for (const b2ContactEdge* p = body.GetContactList(); p != nullptr; p = p->next)
    p->other->SetAwake(true);
}

// Where its body is.
Vector2 GetOrigin(const CShape& shape) {
  return shape.GetMotionType() == eMotion::Kinematic ? shape.GetRotCenter() : shape.GetPos();
}

} // namespace

void CBodies::Create(const CWorldState& state, CShapeId id, const CSharedEnds& sharedEnds) {
  CBody& body = m_stdBodies[id];
  body = CBody();
  body.m_cId = id;
  if (const std::size_t i = state.FindBall(id); i != CWorldState::npos)
    CreateBall(state.m_cBalls, i, body);
  else
    CreateShape(*state.m_stdShapes[state.FindShape(id)].m_pShape, sharedEnds, body);
  m_stdByBody[body.m_pBody] = &body;
  if (body.m_bIsBall) m_stdBalls.insert(FindIn(m_stdBalls, id), &body);
  SetProperties(state, id);
  if (body.m_pBody->GetType() == b2_kinematicBody) SetMoving(state, id);
}

template <class TShape, class F>
void CBodies::AddFixture(CBody& body, F fill) {
  const auto add = [&](auto shape) {
    fill(shape);
    b2FixtureDef def;
    def.shape = &shape;
    def.friction = 0.0f;
    def.restitutionThreshold = 0.0f;
    if (body.m_bIsBall && !m_bPairs) def.filter.groupIndex = g_nApart;
    return body.m_stdFixtures.emplace_back(body.m_pBody->CreateFixture(&def))->GetShape();
  };
  if (m_pWatch == nullptr)
    add(TShape());
  else
    m_pWatch->Watch(*add(CWatched<TShape>()), body.m_cId);
}

void CBodies::CreateBall(const CBallArrays& b, std::size_t i, CBody& body) {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = m_cScale.ToMetres(b.m_stdPos[i]);
  def.linearVelocity = m_cScale.ToMetres(b.m_stdVel[i]);
  def.fixedRotation = true;
  def.allowSleep = false;
  def.bullet = m_bBullets;
  if (m_cTuning.m_bParabolas) def.gravityScale = 0.0f; // CParabolicCorrection bends the path of a ball then
  body.m_pBody = m_pWorld->CreateBody(&def);
  body.m_bIsBall = true;

  body.m_fRadius = m_cScale.ToMetres(b.m_stdRadius[i]);
  body.m_cGeometry.m_fRadius = static_cast<double>(body.m_fRadius);
  AddFixture<b2CircleShape>(body, [&](b2CircleShape& circle) {
    circle.m_radius = body.m_fRadius + (m_cTuning.m_bExactContacts ? g_fBallSkin : 0.0f);
  });

  SetMass(*body.m_pBody, b.m_stdMass[i]);
}

void CBodies::KeepMasses(const CBallArrays& b) {
  for (std::size_t i = 0; i < b.Size(); ++i) {
    b2Body& body = *m_stdBalls[i]->m_pBody;
    if (body.GetType() == b2_dynamicBody && body.GetMass() != b.m_stdMass[i]) SetMass(body, b.m_stdMass[i]);
  }
}

void CBodies::CreateShape(const CShape& shape, const CSharedEnds& sharedEnds, CBody& body) {
  const Vector2 origin = GetOrigin(shape);
  b2BodyDef def;
  def.type = shape.GetMotionType() == eMotion::Kinematic ? b2_kinematicBody : b2_staticBody;
  def.position = m_cScale.ToMetres(origin);
  body.m_pBody = m_pWorld->CreateBody(&def);

  const std::optional<float> skin =
      m_cTuning.m_bExactContacts ? std::optional(g_fBothSkins - g_fBallSkin) : std::nullopt;
  const CFixtureShapes fixtures = CFixtureShapes::Make(shape, origin, m_cScale, m_fSagitta, skin);
  for (const b2CircleShape& circle : fixtures.m_stdCircles)
    AddFixture<b2CircleShape>(body, [&](b2CircleShape& one) { one = circle; });
  for (const b2EdgeShape& edge : fixtures.m_stdEdges)
    AddFixture<b2EdgeShape>(body, [&](b2EdgeShape& one) { one = edge; });
  for (const CFixtureShapes::CChain& vertices : fixtures.m_stdChains)
    AddFixture<b2ChainShape>(body, [&](b2ChainShape& chain) { CreateChain(vertices, chain); });
  body.m_fBaseOrientation = shape.GetOrientation();
  body.m_nArcPieces = fixtures.m_nArcPieces;
  body.m_cSharedEnds = sharedEnds;
  body.m_cGeometry = MakeContactGeometry(shape, origin, m_cScale, sharedEnds);
  m_nArcPieces += static_cast<std::uint64_t>(body.m_nArcPieces);
}

void CBodies::Remove(CShapeId id) {
  b2Body* pBody = Get(id).m_pBody;
  Forget(id); // before it goes, so that it does not count as lost
  m_pWorld->DestroyBody(pBody);
}

void CBodies::RemoveAll() {
  while (!m_stdBodies.empty())
    Remove(m_stdBodies.begin()->first);
}

void CBodies::Forget(CShapeId id) {
  const auto it = m_stdBodies.find(id);
  m_nArcPieces -= static_cast<std::uint64_t>(it->second.m_nArcPieces);
  m_stdByBody.erase(it->second.m_pBody);
  for (CBody* pBall : m_stdBalls)
    if (pBall->m_pBouncedOff == &it->second) pBall->m_pBouncedOff = nullptr;
  for (auto* pBodies : {&m_stdBalls, &m_stdMoving})
    if (const auto at = FindIn(*pBodies, id); at != pBodies->end() && *at == &it->second) pBodies->erase(at);
  m_stdBodies.erase(it);
}

bool CBodies::IsNearOthers(const CBody& ball) {
  FailIf(m_pWatch == nullptr); // no bodies of a game
  for (const b2ContactEdge* p = ball.m_pBody->GetContactList(); p != nullptr; p = p->next)
    if (IsSolid(*p->contact) && Find(*p->other) == nullptr) return true;
  return false;
}

CBody* CBodies::Find(const b2Body& body) {
  const auto it = m_stdByBody.find(&body);
  return it == m_stdByBody.end() ? nullptr : it->second;
}

void CBodies::SetProperties(const CWorldState& state, CShapeId id) {
  CBody& body = Get(id);
  bool isSolid;
  CFilter given;
  void* pUser;
  if (const std::size_t i = state.FindBall(id); i != CWorldState::npos) {
    const CBallArrays& b = state.m_cBalls;
    body.m_fElasticity = b.m_stdElasticity[i];
    isSolid = b.m_stdCanCollide[i] && !b.m_stdSensor[i];
    given = b.m_stdFilter[i];
    pUser = b.m_stdUser[i];
  } else {
    const CShape& shape = *state.m_stdShapes[state.FindShape(id)].m_pShape;
    body.m_fElasticity = shape.GetElasticity();
    isSolid = IsSolid(shape);
    given = shape.GetFilter();
    pUser = shape.GetUserPtr();
  }
  b2Filter filter; // sensors are not Box2D's: its own do not see a ball that flies through within a step
  filter.categoryBits = isSolid ? given.m_nCategory : uint16(0);
  filter.maskBits = isSolid ? given.m_nMask : uint16(0);
  const b2Filter before = body.m_stdFixtures.front()->GetFilterData();
  filter.groupIndex = before.groupIndex;
  const bool changed = before.maskBits != filter.maskBits || before.categoryBits != filter.categoryBits ||
                       body.m_stdFixtures.front()->IsSensor() == isSolid;
  if (changed) WakeAll(*body.m_pBody);
  // Shapes respond by the product of both elasticities; Box2D's own rule, the larger of both, remains for
  // bodies of the game, and there a shape adds nothing.
  const float restitution = body.m_bIsBall ? body.m_fElasticity : 0.0f;
  const bool bounces = body.m_stdFixtures.front()->GetRestitution() != restitution;
  for (b2Fixture* p : body.m_stdFixtures) {
    p->GetUserData().pointer = reinterpret_cast<uintptr_t>(pUser);
    p->SetRestitution(restitution);
    if (!changed) continue;
    p->SetFilterData(filter);
    p->SetSensor(!isSolid); // a game's contact filter may not ask for the bits
  }
  // A contact has that of the time when they came near each other.
  for (b2ContactEdge* p = body.m_pBody->GetContactList(); p != nullptr && bounces; p = p->next)
    p->contact->ResetRestitution();
  if (!changed || !body.m_pBody->IsEnabled()) return;
  // Box2D would look for what touches already at the end of the next step only; this makes it look before.
  body.m_pBody->SetEnabled(false);
  body.m_pBody->SetEnabled(true);
}

bool CBodies::Follow(const CShape& shape, const CBody& body) const {
  const b2Vec2 origin = m_cScale.ToMetres(GetOrigin(shape)), wanted = m_cScale.ToMetres(shape.GetPos());
  body.m_pBody->SetTransform(origin, shape.GetOrientation() - body.m_fBaseOrientation);
  const b2Vec2 arm = ToFloat(body.m_cGeometry.m_vCentre), place = b2Mul(body.m_pBody->GetTransform(), arm);
  return (place - wanted).Length() <= g_fBodyRounding * (origin.Length() + arm.Length());
}

bool CBodies::SetPose(const CWorldState& state, CShapeId id) {
  CBody& body = Get(id);
  WakeAll(*body.m_pBody); // what lies there may lie on nothing
  body.m_pBody->SetAwake(true);
  const bool follows = Follow(*state.m_stdShapes[state.FindShape(id)].m_pShape, body);
  body.m_cStart = body.m_pBody->GetTransform();
  return follows;
}

void CBodies::SetMoving(const CWorldState& state, CShapeId id) {
  CBody& body = Get(id);
  const CShape& shape = *state.m_stdShapes[state.FindShape(id)].m_pShape;
  body.m_vVel = m_cScale.ToMetres(shape.GetVel());
  body.m_fTurnSpeed = shape.GetRotating() ? g_fTwoPi * shape.GetRotSpeed() : 0.0f;
  body.m_pBody->SetLinearVelocity(body.m_vVel);
  body.m_pBody->SetAngularVelocity(body.m_fTurnSpeed);
  body.m_cStart = body.m_pBody->GetTransform(); // not updated again as long as it does not move
  const auto at = FindIn(m_stdMoving, id);
  const bool isIn = at != m_stdMoving.end() && *at == &body;
  if (shape.GetMoving() && !isIn)
    m_stdMoving.insert(at, &body);
  else if (!shape.GetMoving() && isIn)
    m_stdMoving.erase(at);
}

void CBodies::FindContacts() {
  // The manager is const only because b2World has no other function that returns it.
  const_cast<b2ContactManager&>(m_pWorld->GetContactManager()).FindNewContacts();
}

void CBodies::SetBullets(bool b) {
  if (b == m_bBullets) return;
  m_bBullets = b;
  SetBullets();
}

void CBodies::SetBullets() {
  for (CBody* pBall : m_stdBalls)
    pBall->m_pBody->SetBullet(m_bBullets && !pBall->m_bIsLasting);
}

void CBodies::SetRestitutions(const CMixing& mixing) {
  for (auto& [id, body] : m_stdBodies)
    for (b2Fixture* p = body.m_pBody->GetFixtureList(); p != nullptr; p = p->GetNext())
      p->SetRestitution(body.m_fElasticity * (body.m_bIsBall ? mixing.m_fOfBalls : mixing.m_fOfShapes));
  for (b2Contact* p = m_pWorld->GetContactList(); p != nullptr; p = p->GetNext())
    p->ResetRestitution(); // it has that of the time when they came near each other, or what a listener set
}

} // namespace Shapes::Box2D
