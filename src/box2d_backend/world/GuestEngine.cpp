// SPDX-License-Identifier: MIT
#include "GuestEngine.h"

#include <Shapes/Box2D.h>

#include "../../shapes/Validate.h"

#include <stdexcept>
#include <utility>

namespace Shapes::Box2D {

CTuning GetGuestTuning(eProfile e) {
  CTuning tuning = GetTuning(e);
  tuning.m_fScale = 1.0f;
  tuning.m_bAdaptiveSubsteps = false;
  return tuning;
}

CGuestEngine::CGuestEngine(b2World& b2, CWorldCore& world)
    : m_pWorld(&b2), m_cWorld(world), m_cWatch([this](CShapeId id) { OnLost(id); }) {
  const CWorldDesc& desc = world.GetDesc();
  if (desc.m_vGravity != Vector2::Zero())
    Refuse("m_vGravity", "not zero", "(0, 0): the b2World has the gravity");
  for (const eEffect e : {eEffect::Gravity, eEffect::Continuous})
    if ((desc.m_cEffects.m_cForced | desc.m_cEffects.m_cForbidden).Has(e))
      Refuse("m_cEffects", std::string(GetName(e)) + " forced or forbidden",
             "neither: it belongs to the b2World, by SetGravity and SetContinuousPhysics");
  if (b2.IsLocked())
    throw std::logic_error("MakeWorld was called during b2World::Step: call it before or after");
  const CTuning tuning = GetGuestTuning(desc.m_cBox2D.m_eProfile);
  m_pStepper = std::make_unique<CStepper>(b2, world, tuning, &m_cWatch);
  m_pChain = CListenerChain::Install(b2);
  PlaceSentinel();
  ReadHostSettings();
}

CGuestEngine::~CGuestEngine() {
  m_pChain->SetGatherer(nullptr);
  if (!IsAlive() || IsBox2DAtWork()) return;
  const CDuring busy(m_bIsBusy, true);
  m_pStepper->RemoveAll();
  if (m_pSentinel != nullptr) m_pWorld->DestroyBody(m_pSentinel);
  m_pChain->TakeOut(*m_pWorld);
}

void CGuestEngine::PreStep(float dt) {
  RequireRange("dt", dt, g_fMinTimeStep, g_fMaxTimeStep);
  RequireIdle();
  if (m_fStep > 0.0f)
    throw std::logic_error("PreStep was called twice: call b2World::Step, and then PostStep, in between");
  RemoveLost();
  const CDuring busy(m_bIsBusy, true);
  PlaceSentinel();
  if (m_pSentinel->GetPosition() != b2Vec2_zero)
    throw std::logic_error(
        "b2World::ShiftOrigin was called of a b2World that has shapes of a CBox2DWorld: they "
        "stay where they are. Remove them before, and add them at their new places after");
  if (!m_pChain->IsCalledBy(*m_pWorld)) {
    m_pChain = m_pChain->InstallAgain(*m_pWorld);
    ++m_cWorld.Stats().m_nListenersReplaced;
  }
  ReadHostSettings();
  m_cWorld.BeginStep();
  m_cWorld.DriveShapes(dt);
  m_cWorld.BeginSubstep();
  m_fStep = dt;
  m_pStepper->KeepMasses();
  m_pStepper->TakeBalls(); // the game may have moved or kicked them
  m_cWorld.NoteChange();
  m_pStepper->BeginSubstep();
  m_pStepper->BeforeStep(dt);
  m_pChain->SetGatherer(&m_pStepper->GetListener());
}

void CGuestEngine::PostStep() {
  RequireIdle();
  if (!(m_fStep > 0.0f))
    throw std::logic_error("PostStep was called without PreStep: call PreStep(dt) before b2World::Step");
  RemoveLost();
  const CDuring busy(m_bIsBusy, true);
  m_pChain->SetGatherer(nullptr);
  m_pStepper->AfterStep();
  m_pStepper->AddPathVertices([](float part) { return part; });
  m_pStepper->EndSubstep(m_fStep);
  const float dt = std::exchange(m_fStep, 0.0f);
  m_cWorld.EndSubstep(dt);
  m_cWorld.StopShapes(dt);
  m_cWorld.EndStep();
}

void CGuestEngine::Access(eAccess access) {
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
  if (m_fStep == 0.0f) ReadHostSettings();
  if (access == eAccess::Change) PlaceSentinel();
}

void CGuestEngine::Added(CShapeId id) {
  const CDuring busy(m_bIsBusy, true);
  m_pStepper->Added(id);
}

void CGuestEngine::Removed(CShapeId id, std::unique_ptr<CShape>) {
  const CDuring busy(m_bIsBusy, true);
  m_pStepper->Removed(id);
}

void CGuestEngine::Changed(CShapeId id, eChange change) {
  const CDuring busy(m_bIsBusy, true);
  m_pStepper->Changed(id, change);
}

bool CGuestEngine::IsBox2DAtWork() const { return m_bIsBusy || m_pWorld->IsLocked() || m_pChain->IsInside(); }

void CGuestEngine::RequireIdle() const {
  if (!IsAlive())
    throw std::logic_error("The b2World is gone, or all bodies in it were destroyed: what was there last can "
                           "be read, but nothing else can be done");
  if (IsBox2DAtWork())
    throw std::logic_error("A change in a callback of Box2D, or during b2World::Step: change it before "
                           "PreStep or after PostStep");
}

// The body may be one of a b2World that is being destroyed: only when that is over it is known whether the
// shape is to go, too.
void CGuestEngine::OnLost(CShapeId id) {
  if (id == CShapeId())
    m_pSentinel = nullptr;
  else if (m_pStepper->OnLost(id))
    m_stdLost.push_back(id);
}

void CGuestEngine::RemoveLost() {
  for (const CShapeId id : m_stdLost) {
    std::unique_ptr<CShape> pShape;
    m_cWorld.Stats().m_nBodiesLost += m_cWorld.Erase(id, pShape);
  }
  m_stdLost.clear();
}

void CGuestEngine::ReadHostSettings() {
  if (m_pStepper->SetGravity(m_pWorld->GetGravity())) m_cWorld.InvalidatePlan();
  m_cWorld.SetContinuousByHost(m_pWorld->GetContinuousPhysics());
}

void CGuestEngine::PlaceSentinel() {
  if (m_pSentinel != nullptr) {
    if (m_pStepper->IsEmpty()) m_pSentinel->SetTransform(b2Vec2_zero, 0.0f); // wherever the origin is now
    return;
  }
  b2BodyDef def;
  def.enabled = false; // nothing in the game meets it or finds it, also if the game enables all bodies
  m_pSentinel = m_pWorld->CreateBody(&def);
  const CWatched<b2CircleShape> point;
  b2FixtureDef fixture;
  fixture.shape = &point;
  fixture.isSensor = true;
  fixture.filter.categoryBits = fixture.filter.maskBits = 0;
  m_cWatch.Watch(*m_pSentinel->CreateFixture(&fixture)->GetShape(), CShapeId());
}

} // namespace Shapes::Box2D

namespace Shapes {

struct CBox2DWorld::CImpl {
  Box2D::CGuestEngine* m_pEngine = nullptr; // which belongs to the world
  std::unique_ptr<CWorld> m_pWorld;
};

CBox2DWorld::CBox2DWorld(std::unique_ptr<CImpl> pImpl) : m_pImpl(std::move(pImpl)) {}
CBox2DWorld::~CBox2DWorld() = default;
CWorld& CBox2DWorld::GetWorld() { return *m_pImpl->m_pWorld; }
const CWorld& CBox2DWorld::GetWorld() const { return *m_pImpl->m_pWorld; }
void CBox2DWorld::PreStep(float dt) { m_pImpl->m_pEngine->PreStep(dt); }
void CBox2DWorld::PostStep() { m_pImpl->m_pEngine->PostStep(); }
bool CBox2DWorld::IsAlive() const { return m_pImpl->m_pEngine->IsAlive(); }

std::unique_ptr<CBox2DWorld> MakeWorld(b2World& world, const CWorldDesc& desc) {
  auto pImpl = std::make_unique<CBox2DWorld::CImpl>();
  const auto makeEngine = [&](CWorldCore& core) {
    auto pEngine = std::make_unique<Box2D::CGuestEngine>(world, core);
    pImpl->m_pEngine = pEngine.get();
    return pEngine;
  };
  const CWorldLimits limits =
      Box2D::CStepper::GetLimits(desc, Box2D::GetGuestTuning(desc.m_cBox2D.m_eProfile));
  // Events: a ball may meet bodies that only the game knows.
  pImpl->m_pWorld = std::make_unique<CWorld>(
      std::make_unique<CWorldCore>(desc, limits, CEffects{eEffect::Events}, makeEngine));
  return std::make_unique<CBox2DWorld>(std::move(pImpl));
}

} // namespace Shapes
