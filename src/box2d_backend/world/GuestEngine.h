// SPDX-License-Identifier: MIT
#pragma once

#include "../../world/WorldCore.h"

#include <box2d/box2d.h>

#include <memory>
#include <vector>

#include "DestructionWatch.h"
#include "ListenerChain.h"
#include "Stepper.h"
#include "Tuning.h"

namespace Shapes::Box2D {

/// Scale and length of the steps are the game's.
CTuning GetGuestTuning(eProfile e);

/// Steps a world in a b2World that belongs to a game.
class CGuestEngine final : public CEngine {
public:
  CGuestEngine(b2World& b2, CWorldCore& world);
  ~CGuestEngine() override;

  void PreStep(float dt);
  void PostStep();
  bool IsAlive() const { return m_cWatch.IsAnyLeft(); }

  void Access(eAccess access) override;
  void Added(CShapeId id) override;
  void Removed(CShapeId id, std::unique_ptr<CShape> pShape) override;
  void Changed(CShapeId id, eChange change) override;
  void Plan(CEffects running) override { m_pStepper->Plan(running); }
  void Substep(float) override {} // not called: Step is refused
  void Loaded(const CEngineMemory*) override {}
  float GetTouchReach() const override { return m_pStepper->GetTouchReach(); }

private:
  bool IsBox2DAtWork() const;
  void RequireIdle() const;
  void OnLost(CShapeId id);
  void RemoveLost();
  /// Gravity and continuous physics are the game's.
  void ReadHostSettings();
  void PlaceSentinel();

  b2World* m_pWorld;
  CWorldCore& m_cWorld;
  std::unique_ptr<CStepper> m_pStepper;
  CListenerChain* m_pChain = nullptr;
  b2Body* m_pSentinel = nullptr; ///< there even if nothing else is, so that the end of the b2World is noticed
  float m_fStep = 0.0f;          ///< between PreStep and PostStep, else 0
  bool m_bIsBusy = false;        ///< calls Box2D, which may call the game
  std::vector<CShapeId> m_stdLost;
  CDestructionWatch m_cWatch;
};

} // namespace Shapes::Box2D
