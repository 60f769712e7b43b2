// SPDX-License-Identifier: MIT
#include "GuestWorld.h"

#include "../shapes/Validate.h"

#include <stdexcept>
#include <utility>

namespace Shapes::Box2D {
namespace {

// Scale and length of its steps are the game's.
CTuning GetGuestTuning(eProfile e) {
  CTuning tuning = GetTuning(e);
  tuning.m_fScale = 1.0f;
  tuning.m_bCuts = false;
  return tuning;
}

class CBusy {
public:
  explicit CBusy(bool& b) : m_bIs(b) { m_bIs = true; }
  ~CBusy() { m_bIs = false; }
  CBusy(const CBusy&) = delete;
  CBusy& operator=(const CBusy&) = delete;

private:
  bool& m_bIs;
};

} // namespace

CGuestWorld::CGuestWorld(b2World& world, const CWorldDesc& desc)
    // A ball may meet what is in the game only.
    : CBox2DWorld(desc, CStepper::GetLimits(desc, GetGuestTuning(desc.m_eProfile)), {eEffect::Events}),
      m_pWorld(&world),
      m_cTies([this](CShapeId id) { OnLost(id); }) {
  if (desc.m_vGravity != Vector2::Zero())
    Refuse("m_vGravity", "not zero", "(0, 0): the b2World has the gravity");
  for (const eEffect e : {eEffect::Gravity, eEffect::Continuous})
    if ((desc.m_cEffects.m_cForced | desc.m_cEffects.m_cForbidden).Has(e))
      Refuse("m_cEffects", std::string(GetName(e)) + " forced or forbidden",
             "neither: it belongs to the b2World, by SetGravity and SetContinuousPhysics");
  if (world.IsLocked())
    throw std::logic_error("MakeWorld was called during b2World::Step: call it before or after");
  m_pStepper = std::make_unique<CStepper>(world, State(), Stats(), GetDesc(), GetGuestTuning(desc.m_eProfile),
                                          &m_cTies);
  m_pChain = CListenerChain::Install(world);
  Watch();
  LookAround();
}

CGuestWorld::~CGuestWorld() {
  m_pChain->SetGatherer(nullptr);
  if (!IsAlive() || IsBox2DAtWork()) return;
  const CBusy busy(m_bIsBusy);
  m_pStepper->RemoveAll();
  if (m_pSentinel != nullptr) m_pWorld->DestroyBody(m_pSentinel);
  m_pChain->TakeOut(*m_pWorld);
}

void CGuestWorld::PreStep(float dt) {
  RequireRange("dt", dt, g_fMinTimeStep, g_fMaxTimeStep);
  RequireIdle();
  if (m_fStep > 0.0f)
    throw std::logic_error("PreStep was called twice: call b2World::Step, and then PostStep, in between");
  RemoveLost();
  const CBusy busy(m_bIsBusy);
  Watch();
  if (!m_pChain->IsCalledBy(*m_pWorld)) {
    m_pChain = m_pChain->InstallAgain(*m_pWorld);
    ++Stats().m_nListenersReplaced;
  }
  LookAround();
  BeginStep();
  if (std::exchange(m_nPlanned, GetContentVersion()) != GetContentVersion()) m_pStepper->Plan(GetRunning());
  m_fStep = dt;
  m_pStepper->TakeBalls(); // the game may have moved or kicked them
  m_pStepper->BeginSubstep();
  m_pStepper->BeforeStep(dt);
  m_pChain->SetGatherer(&m_pStepper->GetListener());
}

void CGuestWorld::PostStep() {
  RequireIdle();
  if (!(m_fStep > 0.0f))
    throw std::logic_error("PostStep was called without PreStep: call PreStep(dt) before b2World::Step");
  RemoveLost();
  const CBusy busy(m_bIsBusy);
  m_pChain->SetGatherer(nullptr);
  m_pStepper->AfterStep();
  for (const CStepper::CBend& bend : m_pStepper->GetBends())
    Bend(bend.m_nBall, bend.m_vPos, bend.m_fPart);
  m_pStepper->EndSubstep(m_fStep);
  for (const CContactEvent& event : m_pStepper->TakeContacts()) {
    if (Runs(eEffect::Events)) Report(event);
    ++Stats().m_nContacts;
  }
  EndSubstep(std::exchange(m_fStep, 0.0f));
  EndStep();
}

void CGuestWorld::OnAccess(eAccess access) {
  if (access == eAccess::Step)
    throw std::logic_error("Step was called of a world in a game's b2World: call PreStep(dt), then "
                           "b2World::Step(dt, ...), and then PostStep()");
  if (access == eAccess::SaveLoad)
    throw std::logic_error("The state of a world in a game's b2World can be neither saved nor loaded: what "
                           "belongs to the game would not go with it");
  if (access == eAccess::SetGravity) Refuse("m_vGravity", "the b2World's", "a call of b2World::SetGravity");
  if (access == eAccess::Change) {
    RequireIdle();
    if (m_fStep > 0.0f)
      throw std::logic_error("A change between PreStep and PostStep: change it before or after");
  }
  if (!IsAlive() || IsBox2DAtWork()) return;
  RemoveLost();
  if (m_fStep == 0.0f) LookAround();
  if (access == eAccess::Change) Watch();
}

void CGuestWorld::OnAdded(CShapeId id) {
  const CBusy busy(m_bIsBusy);
  m_pStepper->OnAdded(id);
}

void CGuestWorld::OnRemoved(CShapeId id) {
  const CBusy busy(m_bIsBusy);
  m_pStepper->OnRemoved(id);
}

void CGuestWorld::OnChanged(CShapeId id, eChange what) {
  const CBusy busy(m_bIsBusy);
  m_pStepper->OnChanged(id, what);
  if (what == eChange::Properties) m_nPlanned = 0; // elasticities decide whether a listener is needed
}

bool CGuestWorld::IsBox2DAtWork() const { return m_bIsBusy || m_pWorld->IsLocked() || m_pChain->IsInside(); }

void CGuestWorld::RequireIdle() const {
  if (!IsAlive())
    throw std::logic_error("The b2World is gone, or all bodies in it were destroyed: what was there last can "
                           "be read, but nothing else can be done");
  if (IsBox2DAtWork())
    throw std::logic_error("A change in a callback of Box2D, or during b2World::Step: change it before "
                           "PreStep or after PostStep");
}

// The body may be one of a b2World that is being destroyed: only when that is over it is known whether the
// shape is to go, too.
void CGuestWorld::OnLost(CShapeId id) {
  if (id == CShapeId())
    m_pSentinel = nullptr;
  else if (m_pStepper->OnLost(id))
    m_stdLost.push_back(id);
}

void CGuestWorld::RemoveLost() {
  for (const CShapeId id : m_stdLost)
    Stats().m_nBodiesLost += Forget(id);
  m_stdLost.clear();
}

void CGuestWorld::LookAround() {
  if (m_pStepper->SetGravity(m_pWorld->GetGravity())) ContentChanged();
  ContinuousIsGiven(m_pWorld->GetContinuousPhysics());
}

void CGuestWorld::Watch() {
  if (m_pSentinel != nullptr) return;
  b2BodyDef def;
  def.enabled = false; // nothing in the game meets it or finds it
  m_pSentinel = m_pWorld->CreateBody(&def);
  const CTied<b2CircleShape> point;
  m_cTies.Tie(*m_pSentinel->CreateFixture(&point, 0.0f)->GetShape(), CShapeId());
}

} // namespace Shapes::Box2D

namespace Shapes {

std::unique_ptr<CBox2DWorld> MakeWorld(b2World& world, const CWorldDesc& desc) {
  return std::make_unique<Box2D::CGuestWorld>(world, desc);
}

} // namespace Shapes
