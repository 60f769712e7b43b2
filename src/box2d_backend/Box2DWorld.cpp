// SPDX-License-Identifier: MIT
#include "Box2DWorld.h"

#include "../shapes/Response.h"
#include "../shapes/WorldState.h"

#include "Joints.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Box2D {
namespace {

// Of a metre of Box2D in such a world, in user units.
float UnitOf(const CWorldDesc& desc, const CTuning& tuning) { return desc.m_fLengthUnit / tuning.m_fScale; }

CWorldLimits LimitsOf(float unit) {
  return {std::min(g_fMaxLength, g_fMaxBox2DLength * unit), std::min(g_fMaxSpeed, g_fMaxBox2DSpeed * unit),
          g_fMinBox2DMass, g_fMaxBox2DMass};
}

// Whether the joints are those with which the fixtures of a body were made, which has turned since then.
bool AreSame(const CJoints& then, const CJoints& now, float turn) {
  const auto count = [](const CJoints& joints) { return joints[0].has_value() + joints[1].has_value(); };
  FailIf(count(then) != count(now));
  // The ends of a segment may have changed places as it turned.
  for (const auto& a : now)
    FailIf(a && std::none_of(then.begin(), then.end(), [&](const auto& b) {
             return b && b->m_cNeighbour == a->m_cNeighbour &&
                    Length(RotatePt(b->m_vTangent, Vector2::Zero(), turn) - a->m_vTangent) < g_fSameTangent;
           }));
  return true;
}

} // namespace

CBox2DWorld::CBox2DWorld(const CWorldDesc& desc, const CTuning& tuning)
    : CWorld(desc, LimitsOf(UnitOf(desc, tuning))), m_cTuning(tuning), m_cScale(UnitOf(desc, tuning)) {
  Rebuild();
}

void CBox2DWorld::Rebuild() {
  m_pGatherer.reset();
  m_pBodies.reset();
  m_pWorld = std::make_unique<b2World>(b2Vec2_zero);
  m_pBodies = std::make_unique<CBodies>(*m_pWorld, m_cScale, m_cTuning,
                                        GetDesc().m_fSagittaTolerance * m_cTuning.m_fScale);
  m_pGatherer = std::make_unique<CContactGatherer>(*m_pBodies, m_cScale, m_cTuning);
  m_pWorld->SetAllowSleeping(false);
  m_pWorld->SetContactListener(m_pGatherer.get());

  // In the order of ids, balls and other shapes alike.
  std::map<CShapeId, CJoints> joints;
  if (m_cTuning.m_bJoints) joints = FindJoints(State(), m_cScale.FromMetres(b2_linearSlop));
  m_bJointsChanged = false;
  const CWorldState& state = State();
  std::size_t i = 0, j = 0;
  while (i < state.m_stdShapes.size() || j < state.m_cBalls.Size()) {
    const bool ballIsNext =
        i == state.m_stdShapes.size() ||
        (j < state.m_cBalls.Size() && state.m_cBalls.m_stdId[j] < state.m_stdShapes[i].m_cId);
    const CShapeId id = ballIsNext ? state.m_cBalls.m_stdId[j++] : state.m_stdShapes[i++].m_cId;
    m_pBodies->Create(state, id, joints[id]);
  }
  Stats().m_nArcPieces = m_pBodies->GetArcPieces();
}

void CBox2DWorld::OnAdded(CShapeId id) {
  m_pBodies->Create(State(), id);
  Stats().m_nArcPieces = m_pBodies->GetArcPieces();
  m_bJointsChanged |= m_cTuning.m_bJoints && !m_pBodies->Get(id).m_bIsBall;
}

void CBox2DWorld::OnRemoved(CShapeId id) {
  m_bJointsChanged |= m_cTuning.m_bJoints && !m_pBodies->Get(id).m_bIsBall;
  m_pBodies->Remove(id);
  Stats().m_nArcPieces = m_pBodies->GetArcPieces();
}

void CBox2DWorld::OnChanged(CShapeId id, eChange what) {
  if (what == eChange::Properties || what == eChange::Sensor) {
    m_pBodies->SetProperties(State(), id);
    m_bJointsChanged |= m_cTuning.m_bJoints && !m_pBodies->Get(id).m_bIsBall;
    return;
  }
  if (const std::size_t i = State().FindBall(id); i != CWorldState::npos) {
    b2Body& body = *m_pBodies->Get(id).m_pBody;
    if (what == eChange::Pose) body.SetTransform(m_cScale.ToMetres(State().m_cBalls.m_stdPos[i]), 0.0f);
    if (what == eChange::Motion) body.SetLinearVelocity(m_cScale.ToMetres(State().m_cBalls.m_stdVel[i]));
  } else if (what == eChange::Pose) {
    OnRemoved(id);
    OnAdded(id);
  } else { // the rotation speed is handed over at the next substep
    m_bJointsChanged |= m_cTuning.m_bJoints;
  }
}

void CBox2DWorld::JoinShapes() {
  auto joints = FindJoints(State(), m_cScale.FromMetres(b2_linearSlop));
  for (const CShapeEntry& entry : State().m_stdShapes) {
    const CBody& body = m_pBodies->Get(entry.m_cId);
    const float turn = entry.m_pShape->GetOrientation() - body.m_fBaseOrientation;
    if (AreSame(body.m_cJoints, joints[entry.m_cId], turn)) continue;
    m_pBodies->Remove(entry.m_cId);
    m_pBodies->Create(State(), entry.m_cId, joints[entry.m_cId]);
  }
  m_bJointsChanged = false;
}

void CBox2DWorld::Substep(float dt) {
  if (m_bJointsChanged) JoinShapes();
  for (const CShapeEntry& entry : State().m_stdShapes)
    if (entry.m_pShape->GetMotionType() == eMotion::Kinematic)
      m_pBodies->Get(entry.m_cId).m_pBody->SetAngularVelocity(g_fTwoPi * entry.m_pShape->GetRotSpeed());
  State().m_cBalls.m_stdPrevPos = State().m_cBalls.m_stdPos;
  // Counted anew for what is left, because a kick makes a ball faster.
  float left = dt;
  for (unsigned cuts = 2; cuts > 1;) {
    cuts = m_cTuning.m_bCuts ? CountCuts(left) : 1;
    const float h = left / static_cast<float>(cuts);
    StepBox2D(h);
    for (const CContactGatherer::CBend& bend : m_pGatherer->GetBends())
      Bend(State().FindBall(bend.m_cBall), m_cScale.FromMetres(bend.m_vPos),
           (dt - left + static_cast<float>(bend.m_fPart) * h) / dt);
    left -= h;
  }
  TakeBalls();
  TurnShapes(dt);
  for (const CContactEvent& event : m_pGatherer->TakeContacts())
    Report(event);
}

unsigned CBox2DWorld::CountCuts(float dt) const {
  const CBallArrays& b = State().m_cBalls;
  float fastest = 0.0f, bounciest = 0.0f, lightest = g_fMaxMass, heaviest = 0.0f, parts = 1.0f;
  for (std::size_t i = 0; i < b.Size(); ++i) {
    lightest = std::min(lightest, b.m_stdMass[i]);
    heaviest = std::max(heaviest, b.m_stdMass[i]);
    fastest = std::max(fastest,
                       Length(m_cScale.FromMetres(m_pBodies->GetBalls()[i]->m_pBody->GetLinearVelocity())));
    bounciest = std::max(bounciest, b.m_stdElasticity[i]);
  }
  float most = 1.0f, kick = 0.0f;
  for (const CShapeEntry& entry : State().m_stdShapes) {
    const CShape& shape = *entry.m_pShape;
    most = std::max(most, bounciest * shape.GetElasticity());
    if (!shape.GetRotating()) continue;
    const float turn = g_fTwoPi * std::abs(shape.GetRotSpeed()) * dt;
    const CAabb2D& box = shape.GetAABB();
    const Vector2 c = shape.GetRotCenter();
    const float reach =
        Length((box.GetTopLeft() - c).cwiseAbs().cwiseMax((box.GetBottomRt() - c).cwiseAbs()));
    kick = std::max(kick, reach * turn);
    // The boxes of Box2D know where a shape is before and after the step. In between it bulges out of them,
    // by reach turn^2 / 8, which has to be within their margin.
    parts = std::max({parts, turn / g_fLargestTurn,
                      turn * std::sqrt(m_cScale.ToMetres(reach) / (8.0f * b2_aabbExtension))});
  }
  // Two balls have the energy of both: that is the most that one of them can leave with.
  if (b.Size() > 1) most *= std::min(std::sqrt(1.0f + heaviest / lightest), 3.0f);
  const float way = (fastest + Length(State().m_vGravity) * dt) * dt * most + 2.0f * kick;
  parts = std::max(parts, m_cScale.ToMetres(way) / (g_fSafeMove * b2_maxTranslation));
  return static_cast<unsigned>(std::min(std::ceil(parts), static_cast<float>(g_nMaxCuts)));
}

void CBox2DWorld::StepBox2D(float h) {
  const b2Vec2 g = m_cScale.ToMetres(State().m_vGravity);
  const bool bends = m_cTuning.m_bParabolas && g != b2Vec2_zero;
  m_pWorld->SetGravity(m_cTuning.m_bParabolas ? b2Vec2_zero : g);
  for (CBody* pBall : m_pBodies->GetBalls()) {
    b2Body& body = *pBall->m_pBody;
    if (bends) body.SetLinearVelocity(body.GetLinearVelocity() + 0.5f * h * g);
    if (m_cTuning.m_bBullets) body.SetBullet(true);
  }
  CountClamped(h);
  m_pGatherer->BeginStep(bends ? g : b2Vec2_zero, h);
  m_pWorld->Step(h, static_cast<int32>(GetDesc().m_nVelocityIterations),
                 static_cast<int32>(GetDesc().m_nPositionIterations));
  ++Stats().m_nEngineSteps;
  if (bends || m_cTuning.m_bTrueContacts)
    for (CBody* pBall : m_pBodies->GetBalls())
      pBall->m_cFlight.Land(*pBall->m_pBody);
}

void CBox2DWorld::CountClamped(float h) {
  const b2Vec2 kick = m_cTuning.m_bParabolas ? b2Vec2_zero : h * m_cScale.ToMetres(State().m_vGravity);
  for (const CBody* pBall : m_pBodies->GetBalls())
    if (h * (pBall->m_pBody->GetLinearVelocity() + kick).Length() > b2_maxTranslation)
      ++Stats().m_nMovesClamped;
  for (const CShapeEntry& entry : State().m_stdShapes)
    if (entry.m_pShape->GetRotating() &&
        std::abs(g_fTwoPi * entry.m_pShape->GetRotSpeed() * h) > b2_maxRotation)
      ++Stats().m_nTurnsClamped;
}

void CBox2DWorld::TakeBalls() {
  CBallArrays& b = State().m_cBalls;
  const float most = LimitsOf(m_cScale.FromMetres(1.0f)).m_fMaxSpeed;
  for (std::size_t i = 0; i < b.Size(); ++i) {
    b2Body& body = *m_pBodies->GetBalls()[i]->m_pBody;
    b.m_stdPos[i] = m_cScale.FromMetres(body.GetPosition());
    b.m_stdVel[i] = m_cScale.FromMetres(body.GetLinearVelocity());
    if (!CapSpeed(b.m_stdVel[i], most)) continue;
    ++Stats().m_nSpeedsCapped;
    body.SetLinearVelocity(m_cScale.ToMetres(b.m_stdVel[i]));
  }
}

void CBox2DWorld::TurnShapes(float dt) {
  for (CShapeEntry& entry : State().m_stdShapes) {
    if (!entry.m_pShape->GetRotating()) continue;
    entry.m_pShape->Advance(dt);
    // Box2D adds up the angle in its own way; from here on both have the same one, reduced to one turn.
    const CBody& body = m_pBodies->Get(entry.m_cId);
    body.m_pBody->SetTransform(body.m_pBody->GetPosition(),
                               entry.m_pShape->GetOrientation() - body.m_fBaseOrientation);
  }
}

} // namespace Shapes::Box2D
