// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/Box2D.h>

#include <box2d/box2d.h>

#include <memory>
#include <vector>

#include "ListenerChain.h"
#include "Stepper.h"
#include "Ties.h"
#include "Tuning.h"

namespace Shapes::Box2D {

/// A world in a b2World that belongs to a game.
class CGuestWorld final : public CBox2DWorld {
public:
  CGuestWorld(b2World& world, const CWorldDesc& desc);
  ~CGuestWorld() override;

  void PreStep(float dt) override;
  void PostStep() override;
  bool IsAlive() const override { return m_cTies.IsAnyLeft(); }

private:
  void OnAccess(eAccess access) override;
  void Substep(float) override {} // not called: Step is refused
  void OnAdded(CShapeId id) override;
  void OnRemoved(CShapeId id) override;
  void OnChanged(CShapeId id, eChange what) override;
  void OnSaved() override {}
  void OnLoaded() override {}

  bool IsBox2DAtWork() const;
  void RequireIdle() const;
  void OnLost(CShapeId id);
  void RemoveLost();
  /// Gravity and continuous physics are the game's.
  void LookAround();
  void Watch();

  b2World* m_pWorld;
  std::unique_ptr<CStepper> m_pStepper;
  CListenerChain* m_pChain = nullptr;
  b2Body* m_pSentinel = nullptr; ///< there even if nothing else is, so that the end of the b2World is noticed
  std::uint64_t m_nPlanned = 0;  ///< version of the content
  float m_fStep = 0.0f;          ///< between PreStep and PostStep, else 0
  bool m_bIsBusy = false;        ///< calls Box2D, which may call the game
  std::vector<CShapeId> m_stdLost;
  CTies m_cTies;
};

} // namespace Shapes::Box2D
