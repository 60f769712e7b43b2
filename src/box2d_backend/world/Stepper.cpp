// SPDX-License-Identifier: MIT
#include "Stepper.h"

#include "../../shapes/Response.h"
#include "../contact/KeepOnSide.h"
#include "../contact/LastingContact.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace Shapes::Box2D {
namespace {

// Of a metre of Box2D in such a world, in user units.
float UnitOf(const CWorldDesc& desc, const CTuning& tuning) {
  return desc.m_cBox2D.m_fLengthUnit / tuning.m_fScale;
}

// Whether the shared ends are those with which the fixtures of a body were made, which has turned since then.
bool AreSame(const CSharedEnds& then, const CSharedEnds& now, float turn) {
  const auto count = [](const CSharedEnds& sharedEnds) {
    return sharedEnds[0].has_value() + sharedEnds[1].has_value();
  };
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

CWorldLimits CStepper::GetLimits(const CWorldDesc& desc, const CTuning& tuning) {
  const float unit = UnitOf(desc, tuning);
  return {std::min(g_fMaxLength, g_fMaxBox2DLength * unit), std::min(g_fMaxSpeed, g_fMaxBox2DSpeed * unit),
          g_fMinBox2DMass, g_fMaxBox2DMass};
}

CStepper::CStepper(b2World& b2, CWorldCore& world, const CTuning& tuning, CDestructionWatch* pWatch)
    : m_cWorld(world),
      m_cState(world.GetState()),
      m_cStats(world.Stats()),
      m_cTuning(tuning),
      m_cScale(UnitOf(world.GetDesc(), tuning)),
      m_cBodies(b2, m_cScale, m_cTuning, world.GetDesc().m_cBox2D.m_fSagittaTolerance * m_cTuning.m_fScale,
                pWatch, !world.GetDesc().m_cEffects.m_cForbidden.Has(eEffect::BallPairs)),
      m_cGatherer(m_cBodies, m_cScale, m_cTuning) {
  std::map<CShapeId, CSharedEnds> sharedEnds;
  if (m_cTuning.m_bGhostVertices) sharedEnds = FindSharedEnds(m_cState, m_cScale.FromMetres(b2_linearSlop));
  // In the order of ids, balls and other shapes alike.
  std::vector<CShapeId> ids = m_cState.m_cBalls.m_stdId;
  for (const CShapeEntry& entry : m_cState.m_stdShapes)
    ids.push_back(entry.m_cId);
  std::sort(ids.begin(), ids.end());
  for (const CShapeId id : ids)
    m_cBodies.Create(m_cState, id, sharedEnds[id]);
  m_cStats.m_nArcPieces = m_cBodies.GetArcPieces();
}

void CStepper::Added(CShapeId id) {
  m_cBodies.Create(m_cState, id);
  m_cStats.m_nArcPieces = m_cBodies.GetArcPieces();
  NoteSharedEnds(id);
}

void CStepper::Removed(CShapeId id) {
  NoteSharedEnds(id);
  m_cBodies.Remove(id);
  m_cStats.m_nArcPieces = m_cBodies.GetArcPieces();
}

void CStepper::Changed(CShapeId id, eChange what) {
  if (what >= eChange::Sensor) {
    m_cBodies.SetProperties(m_cState, id);
    NoteSharedEnds(id);
  } else if (const std::size_t i = m_cState.FindBall(id); i != CWorldState::npos) {
    b2Body& body = *m_cBodies.Get(id).m_pBody;
    if (what == eChange::Pose) {
      body.SetTransform(m_cScale.ToMetres(m_cState.m_cBalls.m_stdPos[i]), 0.0f);
      body.SetAwake(true); // a game may have let it sleep
    } else {
      body.SetLinearVelocity(m_cScale.ToMetres(m_cState.m_cBalls.m_stdVel[i]));
    }
  } else if (what == eChange::Pose && m_cBodies.SetPose(m_cState, id)) {
    NoteSharedEnds(id);
  } else if (what != eChange::Motion) {
    Removed(id);
    Added(id);
  } else {
    m_cBodies.SetMoving(m_cState, id);
    NoteSharedEnds(id);
  }
}

bool CStepper::OnLost(CShapeId id) {
  FailIf(!m_cBodies.Contains(id));
  NoteSharedEnds(id);
  m_cBodies.Forget(id);
  m_cStats.m_nArcPieces = m_cBodies.GetArcPieces();
  return true;
}

void CStepper::NoteSharedEnds(CShapeId id) {
  m_bSharedEndsChanged |= m_cTuning.m_bGhostVertices && !m_cBodies.Get(id).m_bIsBall;
}

void CStepper::UpdateSharedEnds() {
  m_bSharedEndsChanged = false;
  auto sharedEnds = FindSharedEnds(m_cState, m_cScale.FromMetres(b2_linearSlop));
  for (const CShapeEntry& entry : m_cState.m_stdShapes) {
    if (!m_cBodies.Contains(entry.m_cId)) continue; // a listener has just destroyed it
    const CBody& body = m_cBodies.Get(entry.m_cId);
    const float turn = entry.m_pShape->GetOrientation() - body.m_fBaseOrientation;
    if (AreSame(body.m_cSharedEnds, sharedEnds[entry.m_cId], turn)) continue;
    m_cBodies.Remove(entry.m_cId);
    m_cBodies.Create(m_cState, entry.m_cId, sharedEnds[entry.m_cId]);
  }
}

void CStepper::Plan(CEffects running) {
  m_cRunning = running;
  m_cGatherer.Collect(running);
  // Without continuous physics Box2D asks for no bullets.
  m_cBodies.SetBullets(m_cTuning.m_bBullets && running.Has(eEffect::BallPairs));
}

bool CStepper::NeedsNoListener() {
  FailIf(m_cTuning.m_bExactContacts || m_cTuning.m_bParabolas || m_cGatherer.Collects());
  const auto mixing = FindMixing(m_cState, m_cRunning.Has(eEffect::BallPairs));
  FailIf(!mixing);
  m_cBodies.SetRestitutions(*mixing);
  return true;
}

void CStepper::BeginSubstep() {
  if (m_bSharedEndsChanged) UpdateSharedEnds();
  for (const CBody* pBody : m_cBodies.GetMoving()) { // Box2D may have cut it
    pBody->m_pBody->SetLinearVelocity(pBody->m_vVel);
    pBody->m_pBody->SetAngularVelocity(pBody->m_fTurnSpeed);
  }
  m_cState.m_cBalls.m_stdPrevPos = m_cState.m_cBalls.m_stdPos;
  if (m_cRunning.Has(eEffect::Gravity)) m_cStats.m_nBallsAccelerated += m_cState.m_cBalls.Size();
}

unsigned CStepper::CountSubsteps(float dt) {
  const CBallArrays& b = m_cState.m_cBalls;
  float fastest = 0.0f, bounciest = 0.0f, lightest = g_fMaxMass, heaviest = 0.0f, parts = 1.0f;
  for (std::size_t i = 0; i < b.Size(); ++i) {
    lightest = std::min(lightest, b.m_stdMass[i]);
    heaviest = std::max(heaviest, b.m_stdMass[i]);
    fastest =
        std::max(fastest, Length(m_cScale.FromMetres(m_cBodies.GetBalls()[i]->m_pBody->GetLinearVelocity())));
    bounciest = std::max(bounciest, b.m_stdElasticity[i]);
  }
  float most = 1.0f, surfaceTravel = 0.0f;
  for (const CShapeEntry& entry : m_cState.m_stdShapes) {
    const CShape& shape = *entry.m_pShape;
    most = std::max(most, bounciest * shape.GetElasticity());
    if (!shape.GetMoving()) continue;
    const float turn = g_fTwoPi * std::abs(shape.GetRotSpeed()) * dt;
    const CAabb2D& box = shape.GetAABB();
    const Vector2 c = shape.GetRotCenter();
    const float reach =
        Length((box.GetTopLeft() - c).cwiseAbs().cwiseMax((box.GetBottomRt() - c).cwiseAbs()));
    surfaceTravel = std::max(surfaceTravel, reach * turn + Length(shape.GetVel()) * dt);
    // The boxes of Box2D know where a shape is before and after the step. In between it bulges out of them,
    // by reach turn^2 / 8, which has to be within their margin.
    parts = std::max({parts, turn / g_fLargestTurn,
                      turn * std::sqrt(m_cScale.ToMetres(reach) / (8.0f * b2_aabbExtension))});
  }
  // Two balls have the energy of both: that is the most that one of them can leave with.
  if (b.Size() > 1) most *= std::min(std::sqrt(1.0f + heaviest / lightest), 3.0f);
  const float way =
      (fastest + Length(m_cScale.FromMetres(GetGravity())) * dt) * dt * most + 2.0f * surfaceTravel;
  parts = std::max(parts, m_cScale.ToMetres(way) / (g_fSafeMove * b2_maxTranslation));
  if (m_cTuning.m_bLastingContact) parts = std::max(parts, CountLastingSubsteps(m_cBodies, dt));
  return static_cast<unsigned>(std::min(std::ceil(parts), static_cast<float>(g_nMaxAdaptiveSubsteps)));
}

bool CStepper::HasParabolas() const { return m_cTuning.m_bParabolas && GetGravity() != b2Vec2_zero; }

void CStepper::BeforeStep(float h) {
  const b2Vec2 g = HasParabolas() ? GetGravity() : b2Vec2_zero;
  const float weight = m_cTuning.m_bLastingContact ? FindLastingContacts(m_cBodies, g, h) : 0.0f;
  if (HasParabolas())
    for (CBody* pBall : m_cBodies.GetBalls()) {
      const bool liesOnOther = std::exchange(pBall->m_bLiesOnOther, false),
                 liesOnOwn = std::exchange(pBall->m_bLiesOnOwn, false);
      pBall->m_bHasWeight = pBall->m_bIsLasting || (liesOnOther && !liesOnOwn);
      if (!pBall->IsFree()) continue;
      const float part = pBall->m_bHasWeight ? 1.0f : 0.5f;
      pBall->m_pBody->SetLinearVelocity(pBall->m_pBody->GetLinearVelocity() + part * h * g);
    }
  CountClamped(h);
  m_cGatherer.BeginStep(g, h, weight);
}

void CStepper::AfterStep() {
  ++m_cStats.m_nEngineSteps;
  m_cStats.m_nEngineContacts += m_cGatherer.TakeAsked();
  if (!HasParabolas() && !m_cTuning.m_bExactContacts) return;
  for (CBody* pBall : m_cBodies.GetBalls())
    CPreSolveOverride::Land(*pBall);
  if (m_cTuning.m_bLastingContact) PushOutOfShapes(m_cBodies, HasParabolas() ? GetGravity() : b2Vec2_zero);
  if (m_cTuning.m_bExactContacts) KeepBallsOnTheirSide(m_cBodies);
}

void CStepper::EndSubstep(float dt) {
  TakeBalls();
  MoveShapes(dt);
  for (const CContactEvent& event : m_cGatherer.TakeContacts()) {
    m_cWorld.Report(event);
    ++m_cStats.m_nContacts;
  }
}

void CStepper::CountClamped(float h) {
  const b2Vec2 gravityStep = m_cTuning.m_bParabolas ? b2Vec2_zero : h * GetGravity();
  for (const CBody* pBall : m_cBodies.GetBalls())
    if (h * (pBall->m_pBody->GetLinearVelocity() + gravityStep).Length() > b2_maxTranslation)
      ++m_cStats.m_nMovesClamped;
  for (const CBody* pBody : m_cBodies.GetMoving()) {
    if (h * pBody->m_vVel.Length() > b2_maxTranslation) ++m_cStats.m_nMovesClamped;
    if (std::abs(pBody->m_fTurnSpeed * h) > b2_maxRotation) ++m_cStats.m_nTurnsClamped;
  }
}

void CStepper::TakeBalls() {
  CBallArrays& b = m_cState.m_cBalls;
  b.m_cDisturbed.m_bIsEverywhere = true;
  for (std::size_t i = 0; i < b.Size(); ++i) {
    b2Body& body = *m_cBodies.GetBalls()[i]->m_pBody;
    b.m_stdPos[i] = m_cScale.FromMetres(body.GetPosition());
    b.m_stdVel[i] = m_cScale.FromMetres(body.GetLinearVelocity());
    if (!CapSpeed(b.m_stdVel[i], m_cState.m_cLimits.m_fMaxSpeed)) continue;
    ++m_cStats.m_nSpeedsCapped;
    body.SetLinearVelocity(m_cScale.ToMetres(b.m_stdVel[i]));
  }
}

void CStepper::MoveShapes(float dt) {
  std::vector<CShapeId> elsewhere;
  for (const CBody* pBody : m_cBodies.GetMoving()) {
    CShape& shape = *m_cState.m_stdShapes[m_cState.FindShape(pBody->m_cId)].m_pShape;
    shape.Advance(dt, m_cState.m_cLimits.m_fMaxLength);
    // Box2D adds up places and angles in its own way; from here on both have the same ones, the angle reduced
    // to one turn.
    if (!m_cBodies.Follow(shape, *pBody)) elsewhere.push_back(pBody->m_cId);
  }
  for (const CShapeId id : elsewhere) {
    Removed(id);
    Added(id);
  }
  m_cStats.m_nShapesTurned += m_cBodies.GetMoving().size();
}

} // namespace Shapes::Box2D
