// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/World.h>

#include <box2d/box2d.h>

#include <memory>

#include "Stepper.h"
#include "Tuning.h"

namespace Shapes::Box2D {

/// A world on a b2World of its own: one b2Body for each shape. Elasticity is the product, there is no
/// restitution threshold, no friction, no rotation of balls, and no sleep; all else is as the tuning says.
class COwnedWorld final : public CWorld {
public:
  explicit COwnedWorld(const CWorldDesc& desc) : COwnedWorld(desc, GetTuning(desc.m_eProfile)) {}
  COwnedWorld(const CWorldDesc& desc, const CTuning& tuning);

private:
  void Substep(float dt) override;
  void OnAdded(CShapeId id) override { m_pStepper->OnAdded(id); }
  void OnRemoved(CShapeId id) override { m_pStepper->OnRemoved(id); }
  void OnChanged(CShapeId id, eChange what) override {
    m_pStepper->OnChanged(id, what);
    if (what == eChange::Properties) m_nPlanned = 0; // elasticities decide whether a listener is needed
  }
  // Bodies made anew have no contacts and no cached impulses: whoever goes on from a saved state has the same
  // bits.
  void OnSaved() override { Rebuild(); }
  void OnLoaded() override { Rebuild(); }
  void Rebuild();
  void Plan();
  /// Whether Continuous runs in the substep that begins; counts it.
  bool IsContinuous();

  CTuning m_cTuning;
  std::uint64_t m_nPlanned = 0; // version of the content
  std::unique_ptr<b2World> m_pWorld;
  std::unique_ptr<CStepper> m_pStepper;
};

} // namespace Shapes::Box2D
