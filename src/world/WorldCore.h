// SPDX-License-Identifier: MIT
// A world behind its interface: the state, the effects that run, the reports of the step, and the engine.
#pragma once

#include "Effects.h"
#include "Engine.h"
#include "Questions.h"
#include "Sensors.h"
#include "Touches.h"
#include "WorldState.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace Shapes {

struct CWorld::CImpl {
public:
  using CMakeEngine = std::function<std::unique_ptr<CEngine>(CWorldCore&)>;
  /// @throws std::invalid_argument naming the field of the description that is not valid
  /// @param needs  effects that the engine runs wherever they are not forbidden
  CImpl(const CWorldDesc& desc, const CWorldLimits& limits, CEffects needs, const CMakeEngine& makeEngine);

  // For the engine.
  CWorldState& GetState() { return m_cState; }
  CWorldStats& Stats() { return m_cStats; }
  const CWorldDesc& GetDesc() const { return m_cDesc; }
  const CWorldLimits& GetLimits() const { return m_cLimits; }
  /// Takes up a contact that was responded to, for GetContacts if Events runs.
  void Report(const CContactEvent& event);
  /// Takes up a ball that was halted in the substep, once for each.
  void ReportHalted(CShapeId ball);
  /// A ball (its index) was at p when the share t of the substep was over, 0 .. 1; in the order of time for
  /// each ball. The sensors take its path for straight in between.
  void AddPathVertex(std::size_t ball, const Vector2& p, float t);

  // For an engine that is stepped by the host, who owns the b2World: the parts of Step.
  void BeginStep();
  void BeginSubstep();
  void EndSubstep(float dt);
  void EndStep();
  /// Before and after a substep of dt seconds, for shapes that have stops.
  void DriveShapes(float dt);
  void StopShapes(float dt);
  /// Called when the owner of the b2World decides whether continuous physics is on.
  void SetContinuousByHost(bool runs);
  /// Effects and the plan of the engine are found anew before the next substep.
  void InvalidatePlan() { m_bPlanIsOld = true; }
  /// The indices of shapes are others, or their stops.
  void NoteStops() { m_bStopsChanged = true; }
  /// Something is elsewhere, came, went, or is another one: by anything but a step.
  void NoteChange() { m_cQuestions.reset(); }
  /// Erases a shape or a ball from the state.
  /// @param pShape  gets the shape
  /// @return false if there is none of that id
  bool Erase(CShapeId id, std::unique_ptr<CShape>& pShape);

  // For the interface.
  void Access(eAccess access) { m_pEngine->Access(access); }
  /// The state, up to date.
  const CWorldState& ReadState() const;
  void Step();
  const CWorldStats& GetStats();
  CEffects GetEffects();
  std::string ExplainEffects();
  std::span<const CContactEvent> GetContacts() const { return m_stdContacts; }
  std::span<const CSensorEvent> GetSensorEvents() const { return m_stdSensorEvents; }
  /// Of the state as it is now.
  const CQuestions& Ask();
  std::span<const CTouchEvent> GetTouchEvents() const { return m_stdTouchEvents; }
  std::span<const CShapeId> GetHaltedBalls() const { return m_stdHalted; }
  void SetGravity(const Vector2& g);
  CShapeId Add(std::unique_ptr<CShape> pShape, const CMotionLimits& limits);
  CShapeId Add(const CDynamicCircleDesc& desc);
  /// @return false if there is none of that id
  bool Remove(CShapeId id);
  /// Applies `change` to a shape that is not a ball, or to a ball (the arrays and its index), counts what
  /// effects depend on anew, and informs the engine. Where `change` throws nothing has changed.
  template <class F>
  void ChangeShape(CShapeEntry& entry, eChange what, const F& change);
  template <class F>
  void ChangeBall(std::size_t i, eChange what, const F& change);
  CWorldState SaveState();
  void LoadState(const CWorldState& state);

private:
  bool Runs(eEffect e) const { return m_cRunning.Has(e); }
  bool IsForbidden(eEffect e) const { return m_cDesc.m_cEffects.m_cForbidden.Has(e); }
  void ClearReports();
  void UpdateContent(const CContent& before, const CContent& after);
  void PlanSubsteps();
  void CountEffects();
  // Whether a change may move balls that rest near it.
  static bool DoesDisturb(eChange what) {
    return what != eChange::RotCenter && what != eChange::Motion && what != eChange::Properties;
  }
  void Disturb(const CShape& shape) {
    if (IsSolid(shape)) m_cState.m_cBalls.m_cDisturbed.Add(shape.GetAABB());
  }
  bool HaveStops() const { return m_cContent.m_nWithStops > 0 && !IsForbidden(eEffect::Kinematics); }
  template <class F>
  void ForEachWithStops(const F& f);
  float FindPart(float left);
  void SubstepInParts(float dt);
  void Sense(float dt);

  CWorldDesc m_cDesc;
  CWorldLimits m_cLimits;
  CEffects m_cNeeds;
  std::optional<bool> m_bHostRunsContinuous; // where that is the host's decision
  CEffects m_cRunning;
  bool m_bPlanIsOld = true;
  bool m_bEngineIsPlanned = false;
  std::uint64_t m_nCounted = 0; // substeps whose effects are in the statistics
  CContent m_cContent;
  CWorldState m_cState;
  CSensors m_cSensors;
  std::vector<CContactEvent> m_stdContacts;
  std::vector<CSensorEvent> m_stdSensorEvents;
  std::vector<CTouchEvent> m_stdTouchEvents;
  std::vector<CShapeId> m_stdHalted;
  std::size_t m_nFollowed = 0; // contacts of this step that Touches knows of
  CWorldStats m_cStats;
  bool m_bStopsChanged = true;
  std::vector<std::size_t> m_stdWithStops; // indices of shapes
  // Until the next step or change.
  std::optional<CQuestions> m_cQuestions;
  std::unique_ptr<CEngine> m_pEngine; // last: it is made from the rest, and goes before it
};

template <class F>
void CWorld::CImpl::ChangeShape(CShapeEntry& entry, eChange what, const F& change) {
  NoteChange();
  const CContent before = CContent::Of(entry);
  const CAabb2D box = entry.m_pShape->GetAABB();
  const bool wasSolid = IsSolid(*entry.m_pShape);
  change(entry);
  UpdateContent(before, CContent::Of(entry));
  if (DoesDisturb(what) && wasSolid) m_cState.m_cBalls.m_cDisturbed.Add(box);
  if (DoesDisturb(what)) Disturb(*entry.m_pShape);
  if (what == eChange::Sensor) m_cSensors.Invalidate();
  m_cSensors.InvalidateShape(*entry.m_pShape);
  m_pEngine->Changed(entry.m_cId, what);
}

template <class F>
void CWorld::CImpl::ChangeBall(std::size_t i, eChange what, const F& change) {
  CBallArrays& b = m_cState.m_cBalls;
  NoteChange();
  const CContent before = CContent::Of(b, i);
  if (DoesDisturb(what)) b.m_cDisturbed.Add(b.GetAABB(i));
  change(b, i);
  const bool isPushed = b.IsAsleep(i) && !b.m_stdVel[i].isZero(0.0f);
  if (DoesDisturb(what) || isPushed) b.m_stdCalm[i] = 0.0f;
  UpdateContent(before, CContent::Of(b, i));
  if (what == eChange::Sensor) m_cSensors.Invalidate();
  m_pEngine->Changed(b.m_stdId[i], what);
}

} // namespace Shapes
