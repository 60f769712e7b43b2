// SPDX-License-Identifier: MIT
#include "WorldCore.h"

#include "../Tolerances.h"
#include "../shapes/Validate.h"
#include "Stops.h"

#include <algorithm>

namespace Shapes {
namespace {

// Effects that are compiled in. All, but for builds that measure what an effect costs where it does not run.
#ifdef SHAPES_WITHOUT_EFFECTS
constexpr CEffects g_cBuilt = CEffects::All() - CEffects{SHAPES_WITHOUT_EFFECTS};
#else
constexpr CEffects g_cBuilt = CEffects::All();
#endif

void RequireCount(const char* field, unsigned value, unsigned most) {
  if (value < 1 || value > most)
    Refuse(field, std::to_string(value), "a whole number from 1 to " + std::to_string(most));
}

// Seconds of one substep.
float GetSubstep(const CWorldDesc& desc) { return desc.m_fTimeStep / static_cast<float>(desc.m_nSubsteps); }

} // namespace

CWorld::CImpl::CImpl(const CWorldDesc& desc, const CWorldLimits& limits, CEffects needs,
                     const CMakeEngine& makeEngine)
    : m_cDesc(desc), m_cLimits(limits), m_cNeeds(needs) {
  const CBox2DSettings& box2D = desc.m_cBox2D;
  RequireRange("m_fLengthUnit", box2D.m_fLengthUnit, g_fMinLengthUnit,
               g_fMaxLength); // first: the limits follow from it
  RequireVector("m_vGravity", desc.m_vGravity, limits.m_fMaxSpeed);
  RequirePositive("m_fTimeStep", desc.m_fTimeStep, g_fMaxTimeStep);
  RequireCount("m_nSubsteps", desc.m_nSubsteps, g_nMaxSubsteps);
  RequireCount("m_nThreads", desc.m_nThreads, g_nMaxThreads);
  RequireRange("m_fTimeStep / m_nSubsteps", GetSubstep(desc), g_fMinTimeStep, g_fMaxTimeStep);
  RequirePositive("m_fSagittaTolerance", box2D.m_fSagittaTolerance, g_fMaxLength);
  if (box2D.m_eProfile != eProfile::Shipped && box2D.m_eProfile != eProfile::Tuned)
    Refuse("m_eProfile", std::to_string(static_cast<int>(box2D.m_eProfile)), "Shipped or Tuned");
  RequireCount("m_nVelocityIterations", box2D.m_nVelocityIterations, 1000);
  RequireCount("m_nPositionIterations", box2D.m_nPositionIterations, 1000);
  for (int i = 0; i < static_cast<int>(eEffect::Size); ++i) {
    const auto e = static_cast<eEffect>(i);
    if (desc.m_cEffects.m_cForced.Has(e) && desc.m_cEffects.m_cForbidden.Has(e))
      Refuse("m_cEffects", std::string(GetName(e)) + " both forced and forbidden", "at most one of both");
  }
  if (desc.m_cEffects.m_cForced.Has(eEffect::Touches) && IsForbidden(eEffect::Events))
    Refuse("m_cEffects", "Touches forced and Events forbidden", "Events too: touches are found by contacts");
  m_cState.m_vGravity = desc.m_vGravity;
  m_cState.m_cLimits = limits;
  m_pEngine = makeEngine(*this);
}

const CWorldState& CWorld::CImpl::ReadState() const {
  // The engine may have to find out what has happened already; that changes nothing that was true.
  m_pEngine->Access(eAccess::Read);
  return m_cState;
}

const CWorldStats& CWorld::CImpl::GetStats() {
  Access(eAccess::Read);
  CountEffects();
  return m_cStats;
}

void CWorld::CImpl::CountEffects() {
  const std::uint64_t substeps = m_cStats.m_nSubsteps - std::exchange(m_nCounted, m_cStats.m_nSubsteps);
  for (std::size_t i = 0; i < m_cStats.m_stdSubstepsWith.size(); ++i)
    if (m_cRunning.Has(static_cast<eEffect>(i))) m_cStats.m_stdSubstepsWith[i] += substeps;
}

void CWorld::CImpl::PlanSubsteps() {
  m_bPlanIsOld = false;
  CountEffects();
  const CEffectChoice& choice = m_cDesc.m_cEffects;
  const CEffects called = GetCalledFor(m_cContent, m_cState) | choice.m_cForced | m_cNeeds;
  CEffects running = (called - choice.m_cForbidden) & g_cBuilt;
  if (m_bHostRunsContinuous) running.Set(eEffect::Continuous, *m_bHostRunsContinuous);
  m_bEngineIsPlanned = m_bEngineIsPlanned && running == m_cRunning;
  m_cRunning = running;
  // Balls that move without them would keep those of another place.
  if (!running.Has(eEffect::Gravity) || !running.Has(eEffect::Continuous)) m_cState.m_cBalls.ForgetTails();
}

const CQuestions& CWorld::CImpl::Ask() {
  Access(eAccess::Read);
  if (!m_cQuestions) m_cQuestions.emplace(m_cState);
  return *m_cQuestions;
}

void CWorld::CImpl::UpdateContent(const CContent& before, const CContent& after) {
  if (before != after) InvalidatePlan();
  m_cContent.Replace(before, after);
}

void CWorld::CImpl::SetContinuousByHost(bool runs) {
  if (m_bHostRunsContinuous == runs) return;
  m_bHostRunsContinuous = runs;
  InvalidatePlan();
}

CEffects CWorld::CImpl::GetEffects() {
  Access(eAccess::Read);
  // As it would be found in the next step.
  if (m_bPlanIsOld) PlanSubsteps();
  return m_cRunning;
}

std::string CWorld::CImpl::ExplainEffects() {
  const CEffects running = GetEffects();
  const CEffects byHost = m_bHostRunsContinuous ? CEffects{eEffect::Continuous} : CEffects();
  return Explain(running, m_cDesc.m_cEffects, m_cNeeds, byHost, m_cContent, m_cState);
}

void CWorld::CImpl::SetGravity(const Vector2& g) {
  m_cState.m_vGravity = m_cDesc.m_vGravity = g;
  m_cState.m_cBalls.ForgetTails();
  m_cState.m_cBalls.m_cDisturbed.m_bIsEverywhere = true;
  InvalidatePlan();
}

CShapeId CWorld::CImpl::Add(std::unique_ptr<CShape> pShape, const CMotionLimits& limits) {
  const CShapeId id{m_cState.m_nNextId++};
  CShapeEntry entry(id, std::move(pShape));
  entry.m_cLimits = limits;
  NoteChange();
  NoteStops();
  entry.SetHeld(IsForbidden(eEffect::Kinematics));
  m_cState.m_stdShapes.push_back(std::move(entry));
  UpdateContent({}, CContent::Of(m_cState.m_stdShapes.back()));
  Disturb(*m_cState.m_stdShapes.back().m_pShape);
  m_cSensors.Invalidate();
  m_pEngine->Added(id);
  return id;
}

CShapeId CWorld::CImpl::Add(const CDynamicCircleDesc& desc) {
  const CShapeId id{m_cState.m_nNextId++};
  CBallArrays& b = m_cState.m_cBalls;
  b.Add(id, desc);
  NoteChange();
  UpdateContent({}, CContent::Of(b, b.Size() - 1));
  m_cSensors.Invalidate();
  m_pEngine->Added(id);
  return id;
}

bool CWorld::CImpl::Erase(CShapeId id, std::unique_ptr<CShape>& pShape) {
  NoteChange();
  NoteStops();
  if (const std::size_t i = m_cState.FindBall(id); i != CWorldState::npos) {
    UpdateContent(CContent::Of(m_cState.m_cBalls, i), {});
    m_cState.m_cBalls.m_cDisturbed.Add(m_cState.m_cBalls.GetAABB(i));
    m_cState.m_cBalls.Remove(i);
  } else if (const std::size_t k = m_cState.FindShape(id); k != CWorldState::npos) {
    const auto entry = m_cState.m_stdShapes.begin() + static_cast<std::ptrdiff_t>(k);
    UpdateContent(CContent::Of(*entry), {});
    Disturb(*entry->m_pShape);
    pShape = std::move(entry->m_pShape);
    m_cState.m_stdShapes.erase(entry);
  } else {
    return false;
  }
  m_cSensors.Invalidate();
  return true;
}

bool CWorld::CImpl::Remove(CShapeId id) {
  std::unique_ptr<CShape> pShape;
  FailIf(!Erase(id, pShape));
  m_pEngine->Removed(id, std::move(pShape));
  return true;
}

template <class F>
void CWorld::CImpl::ForEachWithStops(const F& f) {
  if (!HaveStops()) return;
  if (std::exchange(m_bStopsChanged, false)) {
    m_stdWithStops.clear();
    for (std::size_t k = 0; k < m_cState.m_stdShapes.size(); ++k)
      if (m_cState.m_stdShapes[k].HasStops()) m_stdWithStops.push_back(k);
  }
  for (const std::size_t k : m_stdWithStops)
    f(m_cState.m_stdShapes[k]);
}

// Of what is left of a substep, up to where the first shape comes to its stop.
float CWorld::CImpl::FindPart(float left) {
  const float least = g_fLeastPart * GetSubstep(m_cDesc);
  double part = left;
  ForEachWithStops([&](const CShapeEntry& entry) {
    const double time = GetTimeToStop(entry);
    if (time > least && time < left - least) part = std::min(part, time);
  });
  return static_cast<float>(part);
}

void CWorld::CImpl::SubstepInParts(float dt) {
  for (float left = dt; left > 0.0f;) {
    const float part = FindPart(left);
    DriveShapes(part);
    BeginSubstep();
    m_pEngine->Substep(part);
    EndSubstep(part);
    StopShapes(part);
    left -= part;
  }
}

// For the next dt seconds: what is at a stop rests.
void CWorld::CImpl::DriveShapes(float dt) {
  ForEachWithStops([&](CShapeEntry& entry) {
    const CDrive drive = GetDrive(entry, dt), before = entry.GetDrive();
    if (drive.m_vVel != before.m_vVel || drive.m_fRotSpeed != before.m_fRotSpeed)
      ChangeShape(entry, eChange::Motion, [&](CShapeEntry& changed) { changed.SetDrive(drive); });
  });
  // Without stops what has made the plan old waits for the next step.
  if (HaveStops() && m_bPlanIsOld) PlanSubsteps();
}

void CWorld::CImpl::StopShapes(float dt) {
  ForEachWithStops([&](CShapeEntry& entry) {
    if (HasCome(entry, dt))
      ChangeShape(entry, eChange::Motion, [&](CShapeEntry& changed) { SnapToStops(changed, dt); });
  });
}

void CWorld::CImpl::BeginSubstep() {
  if (!m_bEngineIsPlanned) m_pEngine->Plan(m_cRunning);
  m_bEngineIsPlanned = true;
}

void CWorld::CImpl::ClearReports() {
  m_stdContacts.clear();
  m_stdSensorEvents.clear();
  m_stdTouchEvents.clear();
  m_stdHalted.clear();
  m_nFollowed = 0;
}

void CWorld::CImpl::BeginStep() {
  if (m_bPlanIsOld) PlanSubsteps();
  ClearReports();
  if (Runs(eEffect::Sensors)) m_cSensors.Begin(m_cState, m_stdSensorEvents);
  if (Runs(eEffect::Touches))
    EndLost(m_cState, eMeeting::Solid, m_cState.m_stdSolidTouching, m_stdTouchEvents);
}

void CWorld::CImpl::EndSubstep(float dt) {
  ++m_cStats.m_nSubsteps;
  m_cQuestions.reset();
  if (Runs(eEffect::Touches))
    FollowTouches(std::span(m_stdContacts).subspan(m_nFollowed), m_pEngine->GetTouchReach(), m_cState,
                  m_stdTouchEvents);
  if (Runs(eEffect::Sensors)) Sense(dt);
  m_nFollowed = m_stdContacts.size();
}

void CWorld::CImpl::Sense(float dt) {
  // Asked again: the host may have destroyed bodies in the middle of the step.
  const bool any = m_cSensors.Begin(m_cState, m_stdSensorEvents);
  // Ends of pairs were all that was left to report.
  if (!any && !m_cDesc.m_cEffects.m_cForced.Has(eEffect::Sensors)) InvalidatePlan();
  if (!any) return;
  for (const CContactEvent& event : m_cSensors.Sense(m_cState, dt, m_stdSensorEvents, m_cStats)) {
    Report(event);
    ++m_cStats.m_nSensorHits;
  }
}

void CWorld::CImpl::EndStep() {
  ++m_cStats.m_nSteps;
  std::sort(m_stdHalted.begin(), m_stdHalted.end());
  m_stdHalted.erase(std::unique(m_stdHalted.begin(), m_stdHalted.end()), m_stdHalted.end());
}

void CWorld::CImpl::Step() {
  Access(eAccess::Step);
  BeginStep();
  const float dt = GetSubstep(m_cDesc);
  for (unsigned i = 0; i < m_cDesc.m_nSubsteps; ++i)
    SubstepInParts(dt);
  EndStep();
}

void CWorld::CImpl::Report(const CContactEvent& event) {
  if (!Runs(eEffect::Events)) return;
  m_stdContacts.push_back(event);
  ++m_cStats.m_nReported;
}

void CWorld::CImpl::ReportHalted(CShapeId ball) {
  m_stdHalted.push_back(ball);
  ++m_cStats.m_nBallsHalted;
}

void CWorld::CImpl::AddPathVertex(std::size_t ball, const Vector2& p, float t) {
  if (Runs(eEffect::Sensors)) m_cSensors.AddPathVertex(ball, p, t);
}

CWorldState CWorld::CImpl::SaveState() {
  CWorldState saved = m_cState;
  saved.m_pMemory = m_pEngine->Save();
  return saved;
}

void CWorld::CImpl::LoadState(const CWorldState& state) {
  // Ids that were given since are not given again.
  const std::uint32_t nextId = std::max(m_cState.m_nNextId, state.m_nNextId);
  m_cState = CWorldState(state);
  NoteChange();
  NoteStops();
  m_cState.m_nNextId = nextId;
  m_cState.m_cLimits = m_cLimits;
  // A shape at its stop still rests.
  for (CShapeEntry& entry : m_cState.m_stdShapes)
    if (entry.m_bIsHeld != IsForbidden(eEffect::Kinematics)) entry.SetHeld(!entry.m_bIsHeld);
  m_cDesc.m_vGravity = m_cState.m_vGravity;
  ClearReports();
  m_cSensors.Invalidate();
  m_cContent = CountContent(m_cState);
  InvalidatePlan();
  if (m_cState.m_pMemory == nullptr) m_cState.m_cBalls.ForgetTails(); // the engine that it is from keeps none
  m_pEngine->Loaded(std::exchange(m_cState.m_pMemory, nullptr).get());
}

} // namespace Shapes
