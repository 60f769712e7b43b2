// SPDX-License-Identifier: MIT
#include "OwnedWorld.h"

#include <algorithm>

namespace Shapes::Box2D {

COwnedWorld::COwnedWorld(const CWorldDesc& desc, const CTuning& tuning)
    : CWorld(desc, CStepper::GetLimits(desc, tuning),
             tuning.m_bContinuous ? CEffects{eEffect::Continuous} : CEffects()),
      m_cTuning(tuning) {
  Rebuild();
}

void COwnedWorld::Rebuild() {
  m_pStepper.reset();
  m_pWorld = std::make_unique<b2World>(b2Vec2_zero);
  m_pWorld->SetAllowSleeping(false);
  m_pStepper = std::make_unique<CStepper>(*m_pWorld, State(), Stats(), GetDesc(), m_cTuning);
  m_nPlanned = 0;
}

void COwnedWorld::Plan() {
  m_nPlanned = GetContentVersion();
  m_pStepper->Plan(GetRunning());
  m_pWorld->SetGravity(m_pStepper->GetGravity());
  m_pWorld->SetContactListener(m_pStepper->NeedsNoListener() ? nullptr : &m_pStepper->GetListener());
}

bool COwnedWorld::IsContinuous() {
  const bool isFast = IsContinuousOpen() && MovesFast(GetKick());
  if (isFast) CountContinuous();
  return isFast || Runs(eEffect::Continuous);
}

void COwnedWorld::Substep(float dt) {
  if (m_nPlanned != GetContentVersion()) Plan();
  m_pWorld->SetContinuousPhysics(IsContinuous());
  m_pStepper->BeginSubstep();
  // Counted anew for what is left, because a kick makes a ball faster.
  float left = dt;
  for (unsigned cuts = 2, most = g_nMaxCuts; cuts > 1; --most) {
    cuts = m_cTuning.m_bCuts ? std::min(m_pStepper->CountCuts(left), most) : 1;
    const float h = left / static_cast<float>(cuts);
    m_pStepper->BeforeStep(h);
    m_pWorld->Step(h, static_cast<int32>(GetDesc().m_nVelocityIterations),
                   static_cast<int32>(GetDesc().m_nPositionIterations));
    m_pStepper->AfterStep();
    for (const CStepper::CBend& bend : m_pStepper->GetBends())
      Bend(bend.m_nBall, bend.m_vPos, (dt - left + bend.m_fPart * h) / dt);
    left -= h;
  }
  m_pStepper->EndSubstep(dt);
  for (const CContactEvent& event : m_pStepper->TakeContacts()) {
    if (Runs(eEffect::Events)) Report(event);
    ++Stats().m_nContacts;
  }
}

} // namespace Shapes::Box2D
