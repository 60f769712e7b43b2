// SPDX-License-Identifier: MIT
#include "Box2DWorld.h"

#include "../shapes/Response.h"
#include "../shapes/WorldState.h"

#include "Pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace Shapes::Box2D {
namespace {

b2FixtureDef MakeFixtureDef(CShapeId id, const b2Shape& shape) {
  b2FixtureDef def;
  def.shape = &shape;
  def.userData.pointer = static_cast<std::uintptr_t>(id.m_nValue);
  def.friction = 0.0f;
  def.restitutionThreshold = 0.0f;
  return def;
}

float MaxSpeed(const CWorldDesc& desc) {
  return std::min(g_fMaxSpeed, g_fMaxBox2DSpeed * desc.m_fLengthUnit);
}

// Where the point of the shape closest to a ball is, for sensors: Box2D gives them no manifold.
Vector2 ClosestPt(const CShape& shape, const Vector2& p) {
  switch (shape.GetShapeType()) {
  case eShape::LineSeg: return static_cast<const CLineSeg&>(shape).ClosestPt(p);
  case eShape::Circle: return static_cast<const CCircle&>(shape).ClosestPt(p);
  case eShape::Arc: return static_cast<const CArc&>(shape).ClosestPt(p);
  default: return shape.GetPos();
  }
}

} // namespace

CBox2DWorld::CBox2DWorld(const CWorldDesc& desc)
    : CWorld(desc, {std::min(g_fMaxLength, g_fMaxBox2DLength * desc.m_fLengthUnit), MaxSpeed(desc),
                    g_fMinBox2DMass, g_fMaxBox2DMass}),
      m_cScale(desc.m_fLengthUnit),
      m_cGatherer(m_cScale) {
  Rebuild();
}

void CBox2DWorld::Rebuild() {
  m_cGatherer.Clear();
  m_stdBodies.clear();
  m_pWorld = std::make_unique<b2World>(b2Vec2_zero);
  m_pWorld->SetAllowSleeping(false);
  m_pWorld->SetContactListener(&m_cGatherer);
  Stats().m_nArcPieces = 0;

  // In the order of ids, balls and other shapes alike.
  const CWorldState& state = State();
  std::size_t i = 0, j = 0;
  while (i < state.m_stdShapes.size() || j < state.m_cBalls.Size()) {
    const bool ballIsNext =
        i == state.m_stdShapes.size() ||
        (j < state.m_cBalls.Size() && state.m_cBalls.m_stdId[j] < state.m_stdShapes[i].m_cId);
    if (ballIsNext)
      CreateBall(j++);
    else
      CreateShape(*state.m_stdShapes[i].m_pShape, state.m_stdShapes[i].m_cId), ++i;
  }
}

void CBox2DWorld::CreateBall(std::size_t i) {
  const CBallArrays& b = State().m_cBalls;
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = m_cScale.ToMetres(b.m_stdPos[i]);
  def.linearVelocity = m_cScale.ToMetres(b.m_stdVel[i]);
  def.fixedRotation = true;
  b2Body* pBody = m_pWorld->CreateBody(&def);

  b2CircleShape circle;
  circle.m_radius = m_cScale.ToMetres(b.m_stdRadius[i]);
  const b2FixtureDef fixture = MakeFixtureDef(b.m_stdId[i], circle);
  pBody->CreateFixture(&fixture);

  // Directly, not by density: a ball of radius 0 has a mass too, and it must be in place after the fixture.
  b2MassData mass;
  mass.mass = b.m_stdMass[i];
  mass.center.SetZero();
  mass.I = 0.0f;
  pBody->SetMassData(&mass);
  m_stdBodies[b.m_stdId[i]] = {pBody, 0.0f, 0};
  SetProperties(b.m_stdId[i]);
}

void CBox2DWorld::CreateShape(const CShape& shape, CShapeId id) {
  const bool kinematic = shape.GetMotionType() == eMotion::Kinematic;
  const Vector2 origin = kinematic ? shape.GetRotCenter() : shape.GetPos();
  b2BodyDef def;
  def.type = kinematic ? b2_kinematicBody : b2_staticBody;
  def.position = m_cScale.ToMetres(origin);
  b2Body* pBody = m_pWorld->CreateBody(&def);

  const CPieces pieces = CPieces::Make(shape, origin, m_cScale, GetDesc().m_fSagittaTolerance);
  const auto create = [&](const b2Shape& b2shape) {
    const b2FixtureDef fixture = MakeFixtureDef(id, b2shape);
    pBody->CreateFixture(&fixture);
  };
  for (const b2CircleShape& circle : pieces.m_stdCircles)
    create(circle);
  for (const b2EdgeShape& edge : pieces.m_stdEdges)
    create(edge);
  for (const CPieces::CChain& vertices : pieces.m_stdChains) {
    b2ChainShape chain;
    CreateChain(vertices, chain);
    create(chain);
  }
  Stats().m_nArcPieces += static_cast<std::uint64_t>(pieces.m_nArcPieces);
  m_stdBodies[id] = {pBody, shape.GetOrientation(), pieces.m_nArcPieces};
  SetProperties(id);
}

void CBox2DWorld::SetProperties(CShapeId id) {
  const bool canCollide = GetCanCollide(id);
  b2Body& body = *m_stdBodies.at(id).m_pBody;
  if (body.GetFixtureList()->IsSensor() != GetSensor(id)) {
    // What touches already would not begin to touch again: this ends the contacts of the body, and they begin
    // anew as what they are then.
    body.SetEnabled(false);
    body.SetEnabled(true);
  }
  for (b2Fixture* p = body.GetFixtureList(); p != nullptr; p = p->GetNext()) {
    p->SetRestitution(GetElasticity(id));
    p->SetSensor(GetSensor(id));
    b2Filter filter;
    if (!canCollide) filter.categoryBits = filter.maskBits = 0;
    if (filter.maskBits != p->GetFilterData().maskBits) p->SetFilterData(filter);
  }
}

void CBox2DWorld::OnAdded(CShapeId id) {
  if (const std::size_t i = State().FindBall(id); i != CWorldState::npos)
    CreateBall(i);
  else
    CreateShape(GetShape(id), id);
}

void CBox2DWorld::OnRemoved(CShapeId id) {
  const auto it = m_stdBodies.find(id);
  Stats().m_nArcPieces -= static_cast<std::uint64_t>(it->second.m_nArcPieces);
  m_pWorld->DestroyBody(it->second.m_pBody);
  m_stdBodies.erase(it);
}

void CBox2DWorld::OnChanged(CShapeId id, eChange what) {
  if (what == eChange::Properties) {
    SetProperties(id);
    return;
  }
  if (const std::size_t i = State().FindBall(id); i != CWorldState::npos) {
    b2Body& body = *m_stdBodies.at(id).m_pBody;
    if (what == eChange::Pose) body.SetTransform(m_cScale.ToMetres(State().m_cBalls.m_stdPos[i]), 0.0f);
    if (what == eChange::Motion) body.SetLinearVelocity(m_cScale.ToMetres(State().m_cBalls.m_stdVel[i]));
  } else if (what == eChange::Pose) {
    OnRemoved(id);
    OnAdded(id);
  } // a rotation speed is handed over at the next substep
}

void CBox2DWorld::Substep(float dt) {
  m_pWorld->SetGravity(m_cScale.ToMetres(State().m_vGravity));
  for (const CShapeEntry& entry : State().m_stdShapes)
    if (entry.m_pShape->GetMotionType() == eMotion::Kinematic)
      m_stdBodies.at(entry.m_cId).m_pBody->SetAngularVelocity(g_fTwoPi * entry.m_pShape->GetRotSpeed());
  CountClamped(dt);
  m_pWorld->Step(dt, static_cast<int32>(GetDesc().m_nVelocityIterations),
                 static_cast<int32>(GetDesc().m_nPositionIterations));
  TakeBalls();
  TurnShapes(dt);
  ReportContacts();
  ReportSensors();
}

void CBox2DWorld::CountClamped(float dt) {
  const CBallArrays& b = State().m_cBalls;
  for (const Vector2& v : b.m_stdVel)
    if (m_cScale.ToMetres(Length(v + State().m_vGravity * dt)) * dt > b2_maxTranslation)
      ++Stats().m_nMovesClamped;
  for (const CShapeEntry& entry : State().m_stdShapes)
    if (entry.m_pShape->GetRotating() &&
        std::abs(g_fTwoPi * entry.m_pShape->GetRotSpeed() * dt) > b2_maxRotation)
      ++Stats().m_nTurnsClamped;
}

void CBox2DWorld::TakeBalls() {
  CBallArrays& b = State().m_cBalls;
  b.m_stdPrevPos = b.m_stdPos;
  for (std::size_t i = 0; i < b.Size(); ++i) {
    b2Body& body = *m_stdBodies.at(b.m_stdId[i]).m_pBody;
    b.m_stdPos[i] = m_cScale.FromMetres(body.GetPosition());
    b.m_stdVel[i] = m_cScale.FromMetres(body.GetLinearVelocity());
    if (!CapSpeed(b.m_stdVel[i], MaxSpeed(GetDesc()))) continue;
    ++Stats().m_nSpeedsCapped;
    body.SetLinearVelocity(m_cScale.ToMetres(b.m_stdVel[i]));
  }
}

void CBox2DWorld::TurnShapes(float dt) {
  for (CShapeEntry& entry : State().m_stdShapes) {
    if (!entry.m_pShape->GetRotating()) continue;
    entry.m_pShape->Advance(dt);
    // Box2D adds up the angle in its own way; from here on both have the same one, reduced to one turn.
    const CBody& body = m_stdBodies.at(entry.m_cId);
    body.m_pBody->SetTransform(body.m_pBody->GetPosition(),
                               entry.m_pShape->GetOrientation() - body.m_fBaseOrientation);
  }
}

void CBox2DWorld::ReportContacts() {
  for (const CContactEvent& event : m_cGatherer.TakeContacts())
    Report(event);
}

void CBox2DWorld::ReportSensors() {
  const CBallArrays& b = State().m_cBalls;
  for (const auto& pair : m_cGatherer.TakeSensorPairs()) {
    const std::size_t i = State().FindBall(pair.m_cBall), j = State().FindBall(pair.m_cShape);
    const bool isBall = j != CWorldState::npos;
    if (i == CWorldState::npos || (!isBall && !Contains(pair.m_cShape))) continue; // removed since it touched
    CContactEvent event;
    event.m_cShape = pair.m_cShape;
    event.m_cBall = pair.m_cBall;
    event.m_bIsSensor = true;
    const Vector2 p = b.m_stdPos[i];
    Vector2 surface;
    if (isBall) {
      event.m_vNorm = Normalize(p - b.m_stdPos[j]);
      event.m_vPOI = b.m_stdPos[j] + b.m_stdRadius[j] * event.m_vNorm;
      surface = b.m_stdVel[j];
    } else {
      const CShape& shape = GetShape(pair.m_cShape);
      event.m_vPOI = ClosestPt(shape, p);
      event.m_vNorm = Normalize(p - event.m_vPOI);
      surface = shape.GetSurfaceVelocity(event.m_vPOI);
    }
    event.m_fSpeed = ApproachSpeed(b.m_stdVel[i], surface, event.m_vNorm);
    Report(event);
  }
}

} // namespace Shapes::Box2D
