// SPDX-License-Identifier: MIT
#include "OwnedEngine.h"

#include "../../Tolerances.h"
#include "../contact/PairSweep.h"

#include <algorithm>

namespace Shapes::Box2D {

COwnedEngine::COwnedEngine(CWorldCore& world, const CTuning& tuning) : m_cWorld(world), m_cTuning(tuning) {
  Rebuild();
}

void COwnedEngine::Rebuild() {
  m_pStepper.reset();
  m_pWorld = std::make_unique<b2World>(b2Vec2_zero);
  m_pWorld->SetAllowSleeping(false);
  m_pStepper = std::make_unique<CStepper>(*m_pWorld, m_cWorld, m_cTuning);
  m_bPlanIsOld = true;
}

void COwnedEngine::Added(CShapeId id) {
  m_pStepper->Added(id);
  m_bPlanIsOld = true;
}

void COwnedEngine::Removed(CShapeId id, std::unique_ptr<CShape>) {
  m_pStepper->Removed(id);
  m_bPlanIsOld = true;
}

void COwnedEngine::Changed(CShapeId id, eChange change) {
  m_pStepper->Changed(id, change);
  // A shape in another place may have a new body, which has to get its restitution again.
  const bool isBall = m_cWorld.GetState().FindBall(id) != CWorldState::npos;
  m_bPlanIsOld |= change != eChange::Motion && !(change == eChange::Pose && isBall);
}

void COwnedEngine::Plan(CEffects running) {
  m_cRunning = running;
  m_bPlanIsOld = true;
}

void COwnedEngine::PlanStepper() {
  m_bPlanIsOld = false;
  m_pStepper->Plan(m_cRunning);
  m_pWorld->SetContactListener(m_pStepper->NeedsNoListener() ? nullptr : &m_pStepper->GetListener());
}

void COwnedEngine::Substep(float dt) {
  if (m_bPlanIsOld) PlanStepper();
  const CBox2DSettings& settings = m_cWorld.GetDesc().m_cBox2D;
  m_pWorld->SetGravity(m_pStepper->GetGravity());
  m_pWorld->SetContinuousPhysics(m_cRunning.Has(eEffect::Continuous));
  m_pStepper->BeginSubstep();
  // Counted anew for what is left, because an impact makes a ball faster.
  float left = dt;
  for (unsigned parts = 2, most = g_nMaxAdaptiveSubsteps; parts > 1; --most) {
    parts = m_cTuning.m_bAdaptiveSubsteps ? std::min(m_pStepper->CountSubsteps(left), most) : 1;
    const float h = left / static_cast<float>(parts);
    m_pStepper->BeforeStep(h);
    m_pWorld->Step(h, static_cast<int32>(settings.m_nVelocityIterations),
                   static_cast<int32>(settings.m_nPositionIterations));
    m_pStepper->AfterStep();
    m_pStepper->AddPathVertices([=](float part) { return (dt - left + part * h) / dt; });
    left -= h;
  }
  m_pStepper->EndSubstep(dt);
}

std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc, const CTuning& tuning) {
  return std::make_unique<CWorld>(std::make_unique<CWorldCore>(
      desc, CStepper::GetLimits(desc, tuning), CEffects(),
      [&](CWorldCore& world) { return std::make_unique<COwnedEngine>(world, tuning); }));
}

extern const CBackend::CEntry g_cEntry{"box2d", CollidePair, [](const CWorldDesc& desc) {
                                         return MakeWorld(desc, GetTuning(desc.m_cBox2D.m_eProfile));
                                       }};

} // namespace Shapes::Box2D
