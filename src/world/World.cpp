// SPDX-License-Identifier: MIT
// The public world: checks what is asked of it and finds the shape; WorldCore and Questions do the rest.
#include <Shapes/World.h>

#include "../shapes/Validate.h"
#include "Stops.h"
#include "WorldCore.h"

#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace Shapes {
namespace {

[[noreturn]] void RefuseId(CShapeId id, const char* expected) {
  Refuse("id", std::to_string(id.m_nValue), expected);
}

// A shape that is not a ball.
template <class TDesc>
std::unique_ptr<CShape> MakeChecked(const TDesc& desc) {
  auto pShape = MakeShape(desc);
  if (desc.m_eMotionType == eMotion::Static) {
    pShape->SetVel(desc.m_vVel); // which a static shape refuses
    pShape->SetRotSpeed(desc.m_fRotSpeed);
  }
  RequireLimits(desc.m_cLimits, desc.m_eMotionType);
  return pShape;
}
std::unique_ptr<CShape> MakeChecked(const CDynamicCircleDesc&) {
  Refuse("m_eMotionType", "Dynamic", "Static or Kinematic: a compound has no balls");
}

void RequireExtent(const CWorldLimits& limits, const CAabb2D& box) {
  // A world without limits of its own takes every shape, also with a box that reaches twice as far.
  if (limits.m_fMaxLength == g_fMaxLength) return;
  for (const Vector2& corner : {box.GetTopLeft(), box.GetBottomRt()})
    RequireVector("m_vPos and extent (a corner of the box of the shape)", corner, limits.m_fMaxLength);
}

void RequireShape(const CWorldLimits& limits, const CShape& shape) {
  RequireExtent(limits, shape.GetAABB());
  RequireVector("m_vRotCenter", shape.GetRotCenter(), limits.m_fMaxLength);
  RequireVector("m_vVel", shape.GetVel(), limits.m_fMaxSpeed);
}

void RequireBall(const CWorldLimits& limits, const Vector2& p, float r, const Vector2& v, float mass) {
  RequireExtent(limits, CAabb2D(p - Vector2(r, r), p + Vector2(r, r)));
  RequireVector("m_vVel", v, limits.m_fMaxSpeed);
  RequireRange("m_fMass", mass, limits.m_fMinMass, limits.m_fMaxMass);
}

void RequireState(const CWorldLimits& limits, const CWorldState& state) {
  // A world can load any state of another one with the same limits.
  if (state.m_cLimits == limits) return;
  RequireVector("m_vGravity", state.m_vGravity, limits.m_fMaxSpeed);
  for (const CShapeEntry& entry : state.m_stdShapes) {
    RequireShape(limits, *entry.m_pShape);
    RequireVector("m_vVel", entry.m_vVel, limits.m_fMaxSpeed); // of one that is held, or at a stop
  }
  const CBallArrays& b = state.m_cBalls;
  for (std::size_t i = 0; i < b.Size(); ++i)
    RequireBall(limits, b.m_stdPos[i], b.m_stdRadius[i], b.m_stdVel[i], b.m_stdMass[i]);
}

bool IsBall(const CWorldState& state, CShapeId id) { return state.FindBall(id) != CWorldState::npos; }

std::size_t FindBall(const CWorldState& state, CShapeId id) {
  const std::size_t i = state.FindBall(id);
  if (i == CWorldState::npos) RefuseId(id, "the id of a ball in this world");
  return i;
}

constexpr const char* g_sShape = "the id of a shape in this world that is not a ball";
constexpr const char* g_sShapeOrBall = "the id of a shape or a ball in this world";

// A shape that is not a ball.
// @param expected  what the id should be, for the message
const CShapeEntry& FindEntry(const CWorldState& state, CShapeId id, const char* expected = g_sShape) {
  const std::size_t k = state.FindShape(id);
  if (k == CWorldState::npos) RefuseId(id, expected);
  return state.m_stdShapes[k];
}
CShapeEntry& FindEntry(CWorldState& state, CShapeId id, const char* expected = g_sShape) {
  return const_cast<CShapeEntry&>(FindEntry(std::as_const(state), id, expected));
}

const CShape& FindShape(const CWorldState& state, CShapeId id, const char* expected = g_sShape) {
  return *FindEntry(state, id, expected).m_pShape;
}

CShapeEntry& FindKinematic(CWorldState& state, CShapeId id, const char* expected,
                           const char* expectedId = g_sShape) {
  CShapeEntry& entry = FindEntry(state, id, expectedId);
  if (entry.m_pShape->GetMotionType() != eMotion::Kinematic) RefuseId(id, expected);
  return entry;
}

constexpr const char* g_sToBeTurned = "a kinematic shape, to be turned";
constexpr const char* g_sToBeMoved = "a ball or a kinematic shape, to be moved";

// A property of a shape or a ball.
template <class T, class U>
std::remove_cvref_t<U> GetProperty(const CWorldCore& core, CShapeId id, std::vector<T> CBallArrays::*ofBalls,
                                   U (CShape::*ofShape)() const) {
  const CWorldState& state = core.ReadState();
  const std::size_t i = state.FindBall(id);
  return i != CWorldState::npos ? static_cast<std::remove_cvref_t<U>>((state.m_cBalls.*ofBalls)[i])
                                : (FindShape(state, id, g_sShapeOrBall).*ofShape)();
}

template <class T, class U>
void SetProperty(CWorldCore& core, CShapeId id, eChange what, std::vector<T> CBallArrays::*ofBalls,
                 void (CShape::*ofShape)(U), std::type_identity_t<U> value) {
  core.Access(eAccess::Change);
  CWorldState& state = core.GetState();
  if (const std::size_t i = state.FindBall(id); i != CWorldState::npos)
    core.ChangeBall(i, what, [&](CBallArrays& b, std::size_t ball) { (b.*ofBalls)[ball] = value; });
  else
    core.ChangeShape(FindEntry(state, id, g_sShapeOrBall), what,
                     [&](CShapeEntry& entry) { (*entry.m_pShape.*ofShape)(value); });
}

// Changes the pose of a shape, unless the engine could not hold it there.
template <class F>
void SetPose(CWorldCore& core, CShapeEntry& entry, eChange what, const F& change) {
  if (core.GetLimits().m_fMaxLength != g_fMaxLength) {
    const auto pCopy = entry.m_pShape->Clone();
    change(*pCopy);
    RequireShape(core.GetLimits(), *pCopy);
  }
  core.ChangeShape(entry, what, [&](CShapeEntry& changed) { change(*changed.m_pShape); });
}

template <class TDesc>
CShapeId AddTo(CWorldCore& core, const TDesc& desc) {
  std::unique_ptr<CShape> pShape = MakeChecked(desc);
  core.Access(eAccess::Change);
  RequireShape(core.GetLimits(), *pShape);
  return core.Add(std::move(pShape), desc.m_cLimits);
}

CShapeId AddTo(CWorldCore& core, const CDynamicCircleDesc& desc) {
  core.Access(eAccess::Change);
  const CDynamicCircle checked(desc);
  if (desc.m_fRotSpeed != 0.0f) Refuse("m_fRotSpeed", ToText(desc.m_fRotSpeed), "0: balls do not spin");
  RequireLimits(desc.m_cLimits, desc.m_eMotionType);
  RequireBall(core.GetLimits(), desc.m_vPos, desc.m_fRadius, desc.m_vVel, desc.m_fMass);
  return core.Add(desc);
}

void RequireWay(const Vector2& from, const Vector2& to, float radius) {
  RequireVector("from", from, g_fMaxLength);
  RequireVector("to", to, g_fMaxLength);
  RequireRange("radius", radius, 0.0f, g_fMaxLength);
}

} // namespace

struct CSavedState::CImpl {
  CWorldState m_cState;
};

CWorld::CWorld(std::unique_ptr<CImpl> pImpl) : m_pImpl(std::move(pImpl)) {}
CWorld::~CWorld() = default;

const CWorldDesc& CWorld::GetDesc() const { return m_pImpl->GetDesc(); }
const CWorldStats& CWorld::GetStats() const { return m_pImpl->GetStats(); }
CEffects CWorld::GetEffects() const { return m_pImpl->GetEffects(); }
std::string CWorld::ExplainEffects() const { return m_pImpl->ExplainEffects(); }
void CWorld::Step() { m_pImpl->Step(); }
std::span<const CContactEvent> CWorld::GetContacts() const { return m_pImpl->GetContacts(); }
std::span<const CSensorEvent> CWorld::GetSensorEvents() const { return m_pImpl->GetSensorEvents(); }
std::span<const CTouchEvent> CWorld::GetTouchEvents() const { return m_pImpl->GetTouchEvents(); }
std::span<const CShapeId> CWorld::GetHaltedBalls() const { return m_pImpl->GetHaltedBalls(); }

void CWorld::SetGravity(const Vector2& g) {
  m_pImpl->Access(eAccess::SetGravity);
  RequireVector("m_vGravity", g, m_pImpl->GetLimits().m_fMaxSpeed);
  m_pImpl->SetGravity(g);
}

CShapeId CWorld::Add(const CAnyShapeDesc& any) {
  return std::visit([this](const auto& desc) { return AddTo(*m_pImpl, desc); }, any);
}

std::vector<CShapeId> CWorld::AddCompound(std::span<const CAnyShapeDesc> descs, const Vector2& rotCenter,
                                          float revsPerSecond, const Vector2& v,
                                          const CMotionLimits& limits) {
  m_pImpl->Access(eAccess::Change);
  // Even where there is no shape that would be asked.
  RequireVector("m_vRotCenter", rotCenter, m_pImpl->GetLimits().m_fMaxLength);
  RequireRange("m_fRotSpeed", revsPerSecond, -g_fMaxRotSpeed, g_fMaxRotSpeed);
  RequireVector("m_vVel", v, m_pImpl->GetLimits().m_fMaxSpeed);
  RequireLimits(limits, eMotion::Kinematic);
  std::vector<std::unique_ptr<CShape>> shapes;
  const auto make = [&](auto desc) {
    desc.m_eMotionType = eMotion::Kinematic;
    desc.m_vRotCenter = rotCenter;
    desc.m_fRotSpeed = revsPerSecond;
    desc.m_vVel = v;
    desc.m_cLimits = limits;
    auto pShape = MakeChecked(desc);
    RequireShape(m_pImpl->GetLimits(), *pShape);
    return pShape;
  };
  for (std::size_t i = 0; i < descs.size(); ++i)
    shapes.push_back(OfElement("shape", i, [&] { return std::visit(make, descs[i]); }));
  std::vector<CShapeId> ids;
  for (auto& pShape : shapes)
    ids.push_back(m_pImpl->Add(std::move(pShape), limits));
  return ids;
}

void CWorld::Remove(CShapeId id) {
  m_pImpl->Access(eAccess::Change);
  if (!m_pImpl->Remove(id)) RefuseId(id, g_sShapeOrBall);
}

bool CWorld::Contains(CShapeId id) const {
  const CWorldState& state = m_pImpl->ReadState();
  return IsBall(state, id) || state.FindShape(id) != CWorldState::npos;
}

eShape CWorld::GetShapeType(CShapeId id) const {
  const CWorldState& state = m_pImpl->ReadState();
  return IsBall(state, id) ? eShape::Circle : FindShape(state, id, g_sShapeOrBall).GetShapeType();
}

eMotion CWorld::GetMotionType(CShapeId id) const {
  const CWorldState& state = m_pImpl->ReadState();
  return IsBall(state, id) ? eMotion::Dynamic : FindShape(state, id, g_sShapeOrBall).GetMotionType();
}

Vector2 CWorld::GetPos(CShapeId id) const {
  return GetProperty(*m_pImpl, id, &CBallArrays::m_stdPos, &CShape::GetPos);
}

void CWorld::SetPos(CShapeId id, const Vector2& p) {
  m_pImpl->Access(eAccess::Change);
  RequireVector("m_vPos", p, g_fMaxLength);
  CWorldState& state = m_pImpl->GetState();
  const std::size_t i = state.FindBall(id);
  if (i == CWorldState::npos)
    return SetPose(*m_pImpl, FindEntry(state, id, g_sShapeOrBall), eChange::Pose,
                   [&](CShape& shape) { shape.Relocate(p); });
  const Vector2 r = Vector2::Constant(state.m_cBalls.m_stdRadius[i]);
  RequireExtent(m_pImpl->GetLimits(), CAabb2D(p - r, p + r));
  m_pImpl->ChangeBall(i, eChange::Pose, [&](CBallArrays& b, std::size_t ball) { b.SetPos(ball, p); });
}

float CWorld::GetElasticity(CShapeId id) const {
  return GetProperty(*m_pImpl, id, &CBallArrays::m_stdElasticity, &CShape::GetElasticity);
}

void CWorld::SetElasticity(CShapeId id, float e) {
  RequireRange("m_fElasticity", e, 0.0f, g_fMaxElasticity);
  SetProperty(*m_pImpl, id, eChange::Properties, &CBallArrays::m_stdElasticity, &CShape::SetElasticity, e);
}

bool CWorld::GetSensor(CShapeId id) const {
  return GetProperty(*m_pImpl, id, &CBallArrays::m_stdSensor, &CShape::GetSensor);
}

void CWorld::SetSensor(CShapeId id, bool is) {
  SetProperty(*m_pImpl, id, eChange::Sensor, &CBallArrays::m_stdSensor, &CShape::SetSensor, is);
}

bool CWorld::GetCanCollide(CShapeId id) const {
  return GetProperty(*m_pImpl, id, &CBallArrays::m_stdCanCollide, &CShape::GetCanCollide);
}

void CWorld::SetCanCollide(CShapeId id, bool can) {
  SetProperty(*m_pImpl, id, eChange::CanCollide, &CBallArrays::m_stdCanCollide, &CShape::SetCanCollide, can);
}

CFilter CWorld::GetFilter(CShapeId id) const {
  return GetProperty(*m_pImpl, id, &CBallArrays::m_stdFilter, &CShape::GetFilter);
}

void CWorld::SetFilter(CShapeId id, const CFilter& filter) {
  SetProperty(*m_pImpl, id, eChange::Filter, &CBallArrays::m_stdFilter, &CShape::SetFilter, filter);
}

void* CWorld::GetUserPtr(CShapeId id) const {
  return GetProperty(*m_pImpl, id, &CBallArrays::m_stdUser, &CShape::GetUserPtr);
}

void CWorld::SetUserPtr(CShapeId id, void* p) {
  SetProperty(*m_pImpl, id, eChange::Properties, &CBallArrays::m_stdUser, &CShape::SetUserPtr, p);
}

std::vector<CShapeId> CWorld::GetShapeIds() const {
  std::vector<CShapeId> ids;
  for (const CShapeEntry& entry : m_pImpl->ReadState().m_stdShapes)
    ids.push_back(entry.m_cId);
  return ids;
}

const CShape& CWorld::GetShape(CShapeId id) const { return FindShape(m_pImpl->ReadState(), id); }
float CWorld::GetOrientation(CShapeId id) const { return GetShape(id).GetOrientation(); }
Vector2 CWorld::GetRotCenter(CShapeId id) const { return GetShape(id).GetRotCenter(); }
float CWorld::GetRotSpeed(CShapeId id) const { return FindEntry(m_pImpl->ReadState(), id).m_fRotSpeed; }

void CWorld::SetOrientation(CShapeId id, float angle) {
  m_pImpl->Access(eAccess::Change);
  SetPose(*m_pImpl, FindKinematic(m_pImpl->GetState(), id, g_sToBeTurned), eChange::Pose,
          [&](CShape& shape) { shape.SetOrientation(angle); });
}

void CWorld::SetRotSpeed(CShapeId id, float revsPerSecond) {
  m_pImpl->Access(eAccess::Change);
  CShapeEntry& entry = FindKinematic(m_pImpl->GetState(), id, g_sToBeTurned);
  RequireRange("m_fRotSpeed", revsPerSecond, -g_fMaxRotSpeed, g_fMaxRotSpeed);
  if (revsPerSecond == entry.m_fRotSpeed) return;
  m_pImpl->ChangeShape(entry, eChange::Motion,
                       [&](CShapeEntry& changed) { changed.SetRotSpeed(revsPerSecond); });
}

void CWorld::SetRotSpeed(std::span<const CShapeId> ids, float revsPerSecond) {
  m_pImpl->Access(eAccess::Change);
  for (const CShapeId id : ids)
    FindKinematic(m_pImpl->GetState(), id, g_sToBeTurned);
  for (const CShapeId id : ids)
    SetRotSpeed(id, revsPerSecond);
}

void CWorld::SetRotCenter(CShapeId id, const Vector2& center) {
  m_pImpl->Access(eAccess::Change);
  RequireVector("m_vRotCenter", center, m_pImpl->GetLimits().m_fMaxLength);
  CShapeEntry& entry = FindKinematic(m_pImpl->GetState(), id, g_sToBeTurned);
  m_pImpl->ChangeShape(entry, eChange::RotCenter,
                       [&](CShapeEntry& changed) { changed.m_pShape->SetRotCenter(center); });
}

CMotionLimits CWorld::GetLimits(CShapeId id) const { return FindEntry(m_pImpl->ReadState(), id).m_cLimits; }

void CWorld::SetLimits(CShapeId id, const CMotionLimits& limits) {
  m_pImpl->Access(eAccess::Change);
  CShapeEntry& entry = FindEntry(m_pImpl->GetState(), id);
  RequireLimits(limits, entry.m_pShape->GetMotionType());
  m_pImpl->NoteStops();
  m_pImpl->ChangeShape(entry, eChange::Motion, [&](CShapeEntry& changed) {
    changed.m_cLimits = limits;
    changed.SetHeld(changed.m_bIsHeld); // it moves again if a stop is gone
  });
}

void CWorld::Reset(CShapeId id) {
  m_pImpl->Access(eAccess::Change);
  SetPose(*m_pImpl, FindKinematic(m_pImpl->GetState(), id, "a kinematic shape, to be put back"),
          eChange::Reset, [](CShape& shape) { shape.Reset(); });
}

Vector2 CWorld::GetVel(CShapeId id) const {
  const CWorldState& state = m_pImpl->ReadState();
  const std::size_t i = state.FindBall(id);
  return i != CWorldState::npos ? state.m_cBalls.m_stdVel[i] : FindEntry(state, id, g_sShapeOrBall).m_vVel;
}

float CWorld::GetRadius(CShapeId id) const {
  const CWorldState& state = m_pImpl->ReadState();
  return state.m_cBalls.m_stdRadius[FindBall(state, id)];
}

float CWorld::GetMass(CShapeId id) const {
  const CWorldState& state = m_pImpl->ReadState();
  return state.m_cBalls.m_stdMass[FindBall(state, id)];
}

void CWorld::SetVel(CShapeId id, const Vector2& v) {
  m_pImpl->Access(eAccess::Change);
  RequireVector("m_vVel", v, m_pImpl->GetLimits().m_fMaxSpeed);
  const std::size_t i = m_pImpl->GetState().FindBall(id);
  if (i == CWorldState::npos) {
    CShapeEntry& entry = FindKinematic(m_pImpl->GetState(), id, g_sToBeMoved, g_sShapeOrBall);
    if (v == entry.m_vVel) return;
    return m_pImpl->ChangeShape(entry, eChange::Motion, [&](CShapeEntry& changed) { changed.SetVel(v); });
  }
  m_pImpl->ChangeBall(i, eChange::Motion, [&](CBallArrays& b, std::size_t ball) { b.SetVel(ball, v); });
}

void CWorld::SetVel(std::span<const CShapeId> ids, const Vector2& v) {
  m_pImpl->Access(eAccess::Change);
  RequireVector("m_vVel", v, m_pImpl->GetLimits().m_fMaxSpeed);
  for (const CShapeId id : ids)
    if (!IsBall(m_pImpl->GetState(), id))
      FindKinematic(m_pImpl->GetState(), id, g_sToBeMoved, g_sShapeOrBall);
  for (const CShapeId id : ids)
    SetVel(id, v);
}

std::span<const CShapeId> CWorld::GetBallIds() const { return m_pImpl->ReadState().m_cBalls.m_stdId; }
std::span<const Vector2> CWorld::GetBallPositions() const { return m_pImpl->ReadState().m_cBalls.m_stdPos; }
std::span<const Vector2> CWorld::GetBallVelocities() const { return m_pImpl->ReadState().m_cBalls.m_stdVel; }

CSavedState CWorld::SaveState() {
  m_pImpl->Access(eAccess::SaveLoad);
  CSavedState saved;
  saved.m_pImpl = std::make_shared<const CSavedState::CImpl>(CSavedState::CImpl{m_pImpl->SaveState()});
  return saved;
}

void CWorld::LoadState(const CSavedState& state) {
  m_pImpl->Access(eAccess::SaveLoad);
  if (!state.m_pImpl) Refuse("state", "empty", "what SaveState returned");
  RequireState(m_pImpl->GetLimits(), state.m_pImpl->m_cState);
  m_pImpl->LoadState(state.m_pImpl->m_cState);
}

std::optional<CCastHit> CWorld::Cast(const Vector2& from, const Vector2& to, float radius,
                                     const CFilter& filter) const {
  RequireWay(from, to, radius);
  return m_pImpl->Ask().Cast(from, to, radius, filter);
}

std::vector<CCastHit> CWorld::CastAll(const Vector2& from, const Vector2& to, float radius,
                                      const CFilter& filter) const {
  RequireWay(from, to, radius);
  return m_pImpl->Ask().CastAll(from, to, radius, filter);
}

std::optional<CClosestHit> CWorld::FindClosest(const Vector2& p, float reach, const CFilter& filter) const {
  RequireVector("p", p, g_fMaxLength);
  RequireRange("reach", reach, 0.0f, std::numeric_limits<float>::infinity());
  return m_pImpl->Ask().FindClosest(p, reach, filter);
}

std::vector<CShapeId> CWorld::FindInCircle(const Vector2& center, float radius, const CFilter& filter) const {
  RequireVector("center", center, g_fMaxLength);
  RequireRange("radius", radius, 0.0f, g_fMaxLength);
  return m_pImpl->Ask().FindInCircle(center, radius, filter);
}

std::vector<CShapeId> CWorld::FindInBox(const CAabb2D& box, const CFilter& filter) const {
  RequireVector("box", box.GetTopLeft(), g_fMaxLength);
  RequireVector("box", box.GetBottomRt(), g_fMaxLength);
  return m_pImpl->Ask().FindInBox(box, filter);
}

} // namespace Shapes
