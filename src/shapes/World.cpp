// SPDX-License-Identifier: MIT
#include <Shapes/World.h>

#include "Effects.h"
#include "Sensors.h"
#include "Validate.h"
#include "WorldState.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

namespace Shapes {
namespace {

// Effects that are compiled in. All, but for builds that measure what an effect costs where it does not run.
#ifdef SHAPES_WITHOUT_EFFECTS
constexpr CEffects g_cBuilt = CEffects::All() - CEffects{SHAPES_WITHOUT_EFFECTS};
#else
constexpr CEffects g_cBuilt = CEffects::All();
#endif
constexpr bool IsBuilt(eEffect e) { return g_cBuilt.Has(e); }

void RequireCount(const char* field, unsigned value, unsigned most) {
  if (value < 1 || value > most)
    Refuse(field, std::to_string(value), "a whole number from 1 to " + std::to_string(most));
}

[[noreturn]] void RefuseId(CShapeId id, const char* expected) {
  Refuse("id", std::to_string(id.m_nValue), expected);
}

// A shape of the class that the motion in the descriptor asks for.
template <class TStatic, class TKinematic, class TDesc>
std::unique_ptr<CShape> MakeShape(const TDesc& desc) {
  if (desc.m_eMotionType == eMotion::Static) return std::make_unique<TStatic>(desc);
  if (desc.m_eMotionType == eMotion::Kinematic) return std::make_unique<TKinematic>(desc);
  Refuse("m_eMotionType", "neither static nor kinematic",
         "Static or Kinematic; balls are made from CDynamicCircleDesc");
}

std::unique_ptr<CShape> MakeShape(const CPointDesc& desc) { return MakeShape<CPoint, CKinematicPoint>(desc); }
std::unique_ptr<CShape> MakeShape(const CLineSegDesc& desc) {
  return MakeShape<CLineSeg, CKinematicLineSeg>(desc);
}
std::unique_ptr<CShape> MakeShape(const CCircleDesc& desc) {
  return MakeShape<CCircle, CKinematicCircle>(desc);
}
std::unique_ptr<CShape> MakeShape(const CArcDesc& desc) { return MakeShape<CArc, CKinematicArc>(desc); }
std::unique_ptr<CShape> MakeShape(const CDynamicCircleDesc&) {
  Refuse("m_eMotionType", "Dynamic", "Static or Kinematic: a compound has no balls");
}

// Seconds of one substep.
float GetSubstep(const CWorldDesc& desc) { return desc.m_fTimeStep / static_cast<float>(desc.m_nSubsteps); }

} // namespace

CWorld::CWorld(const CWorldDesc& desc, const CWorldLimits& limits, CEffects needs)
    : m_cDesc(desc),
      m_cLimits(limits),
      m_cNeeds(needs),
      m_pContent(std::make_unique<CContent>()),
      m_pFastMoves(std::make_unique<CFastMoves>()),
      m_pState(std::make_unique<CWorldState>()),
      m_pSensors(std::make_unique<CSensors>()) {
  RequireRange("m_fLengthUnit", desc.m_fLengthUnit, g_fMinLengthUnit,
               g_fMaxLength); // first: the limits follow from it
  RequireVector("m_vGravity", desc.m_vGravity, limits.m_fMaxSpeed);
  RequirePositive("m_fTimeStep", desc.m_fTimeStep, g_fMaxTimeStep);
  RequireCount("m_nSubsteps", desc.m_nSubsteps, g_nMaxSubsteps);
  RequireRange("m_fTimeStep / m_nSubsteps", GetSubstep(desc), g_fMinTimeStep, g_fMaxTimeStep);
  RequirePositive("m_fSagittaTolerance", desc.m_fSagittaTolerance, g_fMaxLength);
  RequireCount("m_nVelocityIterations", desc.m_nVelocityIterations, 1000);
  RequireCount("m_nPositionIterations", desc.m_nPositionIterations, 1000);
  for (int i = 0; i < static_cast<int>(eEffect::Size); ++i) {
    const auto e = static_cast<eEffect>(i);
    if (desc.m_cEffects.m_cForced.Has(e) && desc.m_cEffects.m_cForbidden.Has(e))
      Refuse("m_cEffects", std::string(GetName(e)) + " both forced and forbidden", "at most one of both");
  }
  m_pState->m_vGravity = desc.m_vGravity;
  m_pState->m_cLimits = limits;
}

CWorld::~CWorld() = default;

const CWorldState& CWorld::Look() const {
  // What the engine does then changes nothing that was true: it finds out what has happened already.
  const_cast<CWorld*>(this)->OnAccess(eAccess::Read);
  return *m_pState;
}

const CWorldStats& CWorld::GetStats() const {
  Look();
  const_cast<CWorld*>(this)->CountEffects();
  return m_cStats;
}

void CWorld::CountEffects() {
  const std::uint64_t substeps = m_cStats.m_nSubsteps - std::exchange(m_nCounted, m_cStats.m_nSubsteps);
  for (std::size_t i = 0; i < m_cStats.m_stdSubstepsWith.size(); ++i)
    if (m_cRunning.Has(static_cast<eEffect>(i))) m_cStats.m_stdSubstepsWith[i] += substeps;
  m_cStats.m_stdSubstepsWith[static_cast<std::size_t>(eEffect::Continuous)] +=
      std::exchange(m_nContinuous, 0);
}

CEffects CWorld::FindRunning() const {
  const CEffectChoice& choice = m_cDesc.m_cEffects;
  return ((GetCalledFor(*m_pContent, *m_pState) | choice.m_cForced | m_cNeeds) - choice.m_cForbidden) &
         g_cBuilt;
}

void CWorld::PlanSubsteps() {
  m_bContentChanged = false;
  CountEffects();
  *m_pContent = CountContent(*m_pState);
  m_cRunning = FindRunning();
  const eEffect e = eEffect::Continuous;
  const bool isOpen = !m_cRunning.Has(e) && !m_cDesc.m_cEffects.m_cForbidden.Has(e) && !m_cGiven.Has(e);
  m_bIsContinuousOpen = IsBuilt(e) && isOpen && m_pContent->CanMeet();
  if (m_bIsContinuousOpen) m_pFastMoves->Set(*m_pState, GetSubstep(m_cDesc));
  ++m_nContentVersion;
}

void CWorld::ContinuousIsGiven(bool runs) {
  if (m_cGiven.Has(eEffect::Continuous) && m_cNeeds.Has(eEffect::Continuous) == runs) return;
  m_cGiven.Set(eEffect::Continuous);
  m_cNeeds.Set(eEffect::Continuous, runs);
  ContentChanged();
}

bool CWorld::MovesFast(const Vector2& kick) const {
  return m_pFastMoves->IsAny(m_pState->m_cBalls.m_stdVel, kick);
}

CEffects CWorld::GetEffects() const {
  Look();
  // What is worked out now would be in the next step.
  if (m_bContentChanged) const_cast<CWorld*>(this)->PlanSubsteps();
  CEffects running = m_cRunning;
  if (m_bIsContinuousOpen && MovesFast(GetKick())) running.Set(eEffect::Continuous);
  return running;
}

std::string CWorld::ExplainEffects() const {
  const CEffects running = GetEffects();
  return Explain(running, m_cDesc.m_cEffects, m_cNeeds, m_cGiven, *m_pContent, *m_pState,
                 FindLongestMoves(*m_pState, GetKick(), GetSubstep(m_cDesc)));
}

Vector2 CWorld::GetKick() const {
  return m_cRunning.Has(eEffect::Gravity) ? Vector2(m_pState->m_vGravity * GetSubstep(m_cDesc))
                                          : Vector2(Vector2::Zero());
}

void CWorld::SetGravity(const Vector2& g) {
  OnAccess(eAccess::SetGravity);
  RequireVector("m_vGravity", g, m_cLimits.m_fMaxSpeed);
  m_pState->m_vGravity = m_cDesc.m_vGravity = g;
  ContentChanged();
}

void CWorld::RequireExtent(const CAabb2D& box) const {
  // Native takes what a shape takes, a box that reaches twice as far included.
  if (m_cLimits.m_fMaxLength == g_fMaxLength) return;
  RequireVector("m_vPos and extent (a corner of the box of the shape)", box.GetTopLeft(),
                m_cLimits.m_fMaxLength);
  RequireVector("m_vPos and extent (a corner of the box of the shape)", box.GetBottomRt(),
                m_cLimits.m_fMaxLength);
}

void CWorld::RequireHeld(const CWorldState& state) const {
  // What a world of the same limits has come to hold, it can go on with.
  if (state.m_cLimits == m_cLimits) return;
  RequireVector("m_vGravity", state.m_vGravity, m_cLimits.m_fMaxSpeed);
  for (const CShapeEntry& entry : state.m_stdShapes) {
    RequireExtent(entry.m_pShape->GetAABB());
    RequireVector("m_vRotCenter", entry.m_pShape->GetRotCenter(), m_cLimits.m_fMaxLength);
  }
  const CBallArrays& b = state.m_cBalls;
  for (std::size_t i = 0; i < b.Size(); ++i) {
    const Vector2 r(b.m_stdRadius[i], b.m_stdRadius[i]);
    RequireExtent(CAabb2D(b.m_stdPos[i] - r, b.m_stdPos[i] + r));
    RequireVector("m_vVel", b.m_stdVel[i], m_cLimits.m_fMaxSpeed);
    RequireRange("m_fMass", b.m_stdMass[i], m_cLimits.m_fMinMass, m_cLimits.m_fMaxMass);
  }
}

CShapeId CWorld::AddShape(std::unique_ptr<CShape> pShape) {
  OnAccess(eAccess::Change);
  RequireExtent(pShape->GetAABB());
  RequireVector("m_vRotCenter", pShape->GetRotCenter(), m_cLimits.m_fMaxLength);
  pShape->SetHeld(m_cDesc.m_cEffects.m_cForbidden.Has(eEffect::Kinematics));
  const CShapeId id{m_pState->m_nNextId++};
  m_pState->m_stdShapes.emplace_back(id, std::move(pShape));
  m_pSensors->Forget();
  ContentChanged();
  OnAdded(id);
  return id;
}

CShapeId CWorld::Add(const CPointDesc& desc) { return AddShape(MakeShape(desc)); }
CShapeId CWorld::Add(const CLineSegDesc& desc) { return AddShape(MakeShape(desc)); }
CShapeId CWorld::Add(const CCircleDesc& desc) { return AddShape(MakeShape(desc)); }
CShapeId CWorld::Add(const CArcDesc& desc) { return AddShape(MakeShape(desc)); }

CShapeId CWorld::Add(const CDynamicCircleDesc& desc) {
  OnAccess(eAccess::Change);
  const CDynamicCircle checked(desc);
  RequireExtent(checked.GetAABB());
  RequireVector("m_vVel", desc.m_vVel, m_cLimits.m_fMaxSpeed);
  RequireRange("m_fMass", desc.m_fMass, m_cLimits.m_fMinMass, m_cLimits.m_fMaxMass);
  const CShapeId id{m_pState->m_nNextId++};
  m_pState->m_cBalls.Add(id, desc);
  m_pSensors->Forget();
  ContentChanged();
  OnAdded(id);
  return id;
}

CShapeId CWorld::Add(const CAnyShapeDesc& desc) {
  return std::visit([this](const auto& d) { return Add(d); }, desc);
}

std::vector<CShapeId> CWorld::AddCompound(std::span<const CAnyShapeDesc> descs, const Vector2& rotCenter,
                                          float revsPerSecond) {
  OnAccess(eAccess::Change);
  std::vector<std::unique_ptr<CShape>> shapes;
  for (const CAnyShapeDesc& any : descs)
    shapes.push_back(std::visit(
        [&](auto desc) {
          desc.m_eMotionType = eMotion::Kinematic;
          desc.m_vRotCenter = rotCenter;
          desc.m_fRotSpeed = revsPerSecond;
          return MakeShape(desc);
        },
        any));
  RequireVector("m_vRotCenter", rotCenter, m_cLimits.m_fMaxLength);
  for (const auto& pShape : shapes)
    RequireExtent(pShape->GetAABB());
  std::vector<CShapeId> ids;
  for (auto& pShape : shapes)
    ids.push_back(AddShape(std::move(pShape)));
  return ids;
}

bool CWorld::Forget(CShapeId id) {
  if (const std::size_t i = m_pState->FindBall(id); i != CWorldState::npos)
    m_pState->m_cBalls.Remove(i);
  else if (const std::size_t j = m_pState->FindShape(id); j != CWorldState::npos)
    m_pState->m_stdShapes.erase(m_pState->m_stdShapes.begin() + static_cast<std::ptrdiff_t>(j));
  else
    return false;
  m_pSensors->Forget();
  ContentChanged();
  return true;
}

void CWorld::Remove(CShapeId id) {
  OnAccess(eAccess::Change);
  if (!Forget(id)) RefuseId(id, "the id of a shape in this world");
  OnRemoved(id);
}

bool CWorld::Contains(CShapeId id) const {
  const CWorldState& state = Look();
  return state.FindBall(id) != CWorldState::npos || state.FindShape(id) != CWorldState::npos;
}

void CWorld::BeginStep() {
  if (m_bContentChanged) PlanSubsteps();
  m_stdContacts.clear();
  m_stdSensorEvents.clear();
  if (IsBuilt(eEffect::Sensors) && Runs(eEffect::Sensors)) m_pSensors->Begin(*m_pState, m_stdSensorEvents);
}

void CWorld::EndSubstep(float dt) {
  ++m_cStats.m_nSubsteps;
  if (IsBuilt(eEffect::Sensors) && Runs(eEffect::Sensors)) Sense(dt);
}

void CWorld::Sense(float dt) {
  // Asked again: somebody else may have taken shapes out in the middle of the step.
  const bool any = m_pSensors->Begin(*m_pState, m_stdSensorEvents);
  // Ends of pairs were all that was left to tell.
  if (!any && !m_cDesc.m_cEffects.m_cForced.Has(eEffect::Sensors)) ContentChanged();
  if (!any) return;
  const bool reports = Runs(eEffect::Events);
  for (const CContactEvent& event : m_pSensors->Sense(*m_pState, dt, m_stdSensorEvents)) {
    if (reports) Report(event);
    ++m_cStats.m_nSensorHits;
  }
  m_cStats.m_nSensorTests = m_pSensors->GetTests();
}

void CWorld::EndStep() { ++m_cStats.m_nSteps; }

void CWorld::Step() {
  OnAccess(eAccess::Step);
  BeginStep();
  const float dt = GetSubstep(m_cDesc);
  for (unsigned i = 0; i < m_cDesc.m_nSubsteps; ++i) {
    Substep(dt);
    EndSubstep(dt);
  }
  EndStep();
}

void CWorld::Report(const CContactEvent& event) {
  m_stdContacts.push_back(event);
  ++m_cStats.m_nReported;
}

void CWorld::Bend(std::size_t ball, const Vector2& p, float t) {
  if (Runs(eEffect::Sensors)) m_pSensors->Bend(ball, p, t);
}

CShape& CWorld::FindShape(CShapeId id) const {
  const std::size_t i = Look().FindShape(id);
  if (i == CWorldState::npos) RefuseId(id, "the id of a shape in this world that is not a ball");
  return *m_pState->m_stdShapes[i].m_pShape;
}

CShape& CWorld::FindKinematic(CShapeId id, const char* what) const {
  CShape& shape = FindShape(id);
  if (shape.GetMotionType() != eMotion::Kinematic) RefuseId(id, what);
  return shape;
}

eShape CWorld::GetShapeType(CShapeId id) const {
  return Look().FindBall(id) != CWorldState::npos ? eShape::Circle : FindShape(id).GetShapeType();
}

eMotion CWorld::GetMotionType(CShapeId id) const {
  return Look().FindBall(id) != CWorldState::npos ? eMotion::Dynamic : FindShape(id).GetMotionType();
}

const Vector2& CWorld::GetPos(CShapeId id) const {
  const std::size_t i = Look().FindBall(id);
  return i != CWorldState::npos ? m_pState->m_cBalls.m_stdPos[i] : FindShape(id).GetPos();
}

template <class F>
void CWorld::ChangePose(CShape& shape, const F& change) {
  // Tried on a copy: what is refused has changed nothing. Limits of native are those of the shape itself.
  if (m_cLimits.m_fMaxLength != g_fMaxLength) {
    const auto pCopy = shape.Clone();
    change(*pCopy);
    RequireExtent(pCopy->GetAABB());
  }
  change(shape);
  ContentChanged();
}

void CWorld::SetPos(CShapeId id, const Vector2& p) {
  OnAccess(eAccess::Change);
  RequireVector("m_vPos", p, g_fMaxLength);
  CBallArrays& b = m_pState->m_cBalls;
  // Where a ball is changes nothing in what runs, nor in how a substep is planned.
  if (const std::size_t i = m_pState->FindBall(id); i != CWorldState::npos) {
    const Vector2 r(b.m_stdRadius[i], b.m_stdRadius[i]);
    RequireExtent(CAabb2D(p - r, p + r));
    b.m_stdPos[i] = b.m_stdPrevPos[i] = p;
  } else {
    ChangePose(FindShape(id), [&](CShape& shape) { shape.SetPos(p); });
  }
  OnChanged(id, eChange::Pose);
}

float CWorld::GetElasticity(CShapeId id) const {
  const std::size_t i = Look().FindBall(id);
  return i != CWorldState::npos ? m_pState->m_cBalls.m_stdElasticity[i] : FindShape(id).GetElasticity();
}

void CWorld::SetElasticity(CShapeId id, float e) {
  OnAccess(eAccess::Change);
  RequireRange("m_fElasticity", e, 0.0f, g_fMaxElasticity);
  if (const std::size_t i = m_pState->FindBall(id); i != CWorldState::npos)
    m_pState->m_cBalls.m_stdElasticity[i] = e;
  else
    FindShape(id).SetElasticity(e);
  OnChanged(id, eChange::Properties);
}

bool CWorld::GetSensor(CShapeId id) const {
  const std::size_t i = Look().FindBall(id);
  return i != CWorldState::npos ? m_pState->m_cBalls.m_stdSensor[i] != 0 : FindShape(id).GetSensor();
}

void CWorld::SetSensor(CShapeId id, bool b) {
  OnAccess(eAccess::Change);
  if (const std::size_t i = m_pState->FindBall(id); i != CWorldState::npos)
    m_pState->m_cBalls.m_stdSensor[i] = b;
  else
    FindShape(id).SetSensor(b);
  m_pSensors->Forget();
  ContentChanged();
  OnChanged(id, eChange::Sensor);
}

bool CWorld::GetCanCollide(CShapeId id) const {
  const std::size_t i = Look().FindBall(id);
  return i != CWorldState::npos ? m_pState->m_cBalls.m_stdCanCollide[i] != 0 : FindShape(id).GetCanCollide();
}

void CWorld::SetCanCollide(CShapeId id, bool b) {
  OnAccess(eAccess::Change);
  if (const std::size_t i = m_pState->FindBall(id); i != CWorldState::npos)
    m_pState->m_cBalls.m_stdCanCollide[i] = b;
  else
    FindShape(id).SetCanCollide(b);
  ContentChanged();
  OnChanged(id, eChange::Properties);
}

void* CWorld::GetUserPtr(CShapeId id) const {
  const std::size_t i = Look().FindBall(id);
  return i != CWorldState::npos ? m_pState->m_cBalls.m_stdUser[i] : FindShape(id).GetUserPtr();
}

void CWorld::SetUserPtr(CShapeId id, void* p) {
  OnAccess(eAccess::Change);
  if (const std::size_t i = m_pState->FindBall(id); i != CWorldState::npos)
    m_pState->m_cBalls.m_stdUser[i] = p;
  else
    FindShape(id).SetUserPtr(p);
  OnChanged(id, eChange::Properties);
}

const CShape& CWorld::GetShape(CShapeId id) const { return FindShape(id); }
float CWorld::GetOrientation(CShapeId id) const { return FindShape(id).GetOrientation(); }
float CWorld::GetRotSpeed(CShapeId id) const { return FindShape(id).GetRotSpeed(); }
const Vector2& CWorld::GetRotCenter(CShapeId id) const { return FindShape(id).GetRotCenter(); }

void CWorld::SetOrientation(CShapeId id, float angle) {
  OnAccess(eAccess::Change);
  ChangePose(FindKinematic(id, "a kinematic shape, to be turned"),
             [&](CShape& shape) { shape.SetOrientation(angle); });
  OnChanged(id, eChange::Pose);
}

void CWorld::SetRotSpeed(CShapeId id, float revsPerSecond) {
  OnAccess(eAccess::Change);
  FindKinematic(id, "a kinematic shape, to be turned").SetRotSpeed(revsPerSecond);
  ContentChanged();
  OnChanged(id, eChange::Motion);
}

void CWorld::SetRotCenter(CShapeId id, const Vector2& center) {
  OnAccess(eAccess::Change);
  RequireVector("m_vRotCenter", center, m_cLimits.m_fMaxLength);
  FindKinematic(id, "a kinematic shape, to be turned").SetRotCenter(center);
  ContentChanged();
  OnChanged(id, eChange::Pose);
}

void CWorld::Reset(CShapeId id) {
  OnAccess(eAccess::Change);
  FindKinematic(id, "a kinematic shape, to be put back").Reset();
  ContentChanged();
  OnChanged(id, eChange::Pose);
}

namespace {

std::size_t FindBall(const CWorldState& state, CShapeId id) {
  const std::size_t i = state.FindBall(id);
  if (i == CWorldState::npos) RefuseId(id, "the id of a ball in this world");
  return i;
}

} // namespace

const Vector2& CWorld::GetVel(CShapeId id) const { return m_pState->m_cBalls.m_stdVel[FindBall(Look(), id)]; }
float CWorld::GetRadius(CShapeId id) const { return m_pState->m_cBalls.m_stdRadius[FindBall(Look(), id)]; }
float CWorld::GetMass(CShapeId id) const { return m_pState->m_cBalls.m_stdMass[FindBall(Look(), id)]; }

void CWorld::SetVel(CShapeId id, const Vector2& v) {
  OnAccess(eAccess::Change);
  const std::size_t i = FindBall(*m_pState, id);
  RequireVector("m_vVel", v, m_cLimits.m_fMaxSpeed);
  m_pState->m_cBalls.m_stdVel[i] = v;
  OnChanged(id, eChange::Motion);
}

std::vector<CShapeId> CWorld::GetShapeIds() const {
  std::vector<CShapeId> ids;
  for (const CShapeEntry& entry : Look().m_stdShapes)
    ids.push_back(entry.m_cId);
  return ids;
}

std::span<const CShapeId> CWorld::GetBallIds() const { return Look().m_cBalls.m_stdId; }
std::span<const Vector2> CWorld::GetBallPositions() const { return Look().m_cBalls.m_stdPos; }
std::span<const Vector2> CWorld::GetBallVelocities() const { return Look().m_cBalls.m_stdVel; }

CSavedState CWorld::SaveState() {
  OnAccess(eAccess::SaveLoad);
  CSavedState saved;
  saved.m_pState = std::make_shared<const CWorldState>(*m_pState);
  OnSaved();
  return saved;
}

void CWorld::LoadState(const CSavedState& state) {
  OnAccess(eAccess::SaveLoad);
  if (!state.m_pState) Refuse("state", "empty", "what SaveState returned");
  RequireHeld(*state.m_pState);
  // Ids that were given since are not given again.
  const std::uint32_t nextId = std::max(m_pState->m_nNextId, state.m_pState->m_nNextId);
  m_pState = std::make_unique<CWorldState>(*state.m_pState);
  m_pState->m_nNextId = nextId;
  m_pState->m_cLimits = m_cLimits;
  for (const CShapeEntry& entry : m_pState->m_stdShapes)
    entry.m_pShape->SetHeld(m_cDesc.m_cEffects.m_cForbidden.Has(eEffect::Kinematics));
  m_cDesc.m_vGravity = m_pState->m_vGravity;
  m_stdContacts.clear();
  m_stdSensorEvents.clear();
  m_pSensors->Forget();
  ContentChanged();
  OnLoaded();
}

} // namespace Shapes
