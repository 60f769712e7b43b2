// SPDX-License-Identifier: MIT
#pragma once

#include "../../world/WorldCore.h"

#include <box2d/box2d.h>

#include <memory>

#include "Stepper.h"
#include "Tuning.h"

namespace Shapes::Box2D {

/// Steps a world in a b2World of its own: one b2Body for each shape. Elasticity is the product, there is no
/// restitution threshold, no friction, no rotation of balls, and no sleep; all else is as the tuning says.
class COwnedEngine final : public CEngine {
public:
  COwnedEngine(CWorldCore& world, const CTuning& tuning);

  void Added(CShapeId id) override;
  void Removed(CShapeId id, std::unique_ptr<CShape> pShape) override;
  void Changed(CShapeId id, eChange change) override;
  void Plan(CEffects running) override;
  void Substep(float dt) override;
  // Bodies made anew have no contacts and no cached impulses: a world that goes on from a saved state has the
  // same bits.
  std::shared_ptr<const CEngineMemory> Save() override {
    Rebuild();
    return nullptr;
  }
  void Loaded(const CEngineMemory*) override { Rebuild(); }
  float GetTouchReach() const override { return m_pStepper->GetTouchReach(); }

private:
  void Rebuild();
  void PlanStepper();

  CWorldCore& m_cWorld;
  CTuning m_cTuning;
  CEffects m_cRunning;
  bool m_bPlanIsOld = true; // effects, or elasticities, which decide whether a listener is needed
  std::unique_ptr<b2World> m_pWorld;
  std::unique_ptr<CStepper> m_pStepper;
};

/// An empty world on Box2D with this tuning.
std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc, const CTuning& tuning);

} // namespace Shapes::Box2D
