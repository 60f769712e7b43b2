// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/World.h>

#include <box2d/box2d.h>

#include <memory>

#include "Bodies.h"
#include "ContactGatherer.h"
#include "Convert.h"
#include "Tuning.h"

namespace Shapes::Box2D {

/// A world on a b2World of its own: one b2Body for each shape. Elasticity is the product, there is no
/// restitution threshold, no friction, no rotation of balls, and no sleep; all else is as the tuning says.
class CBox2DWorld final : public CWorld {
public:
  explicit CBox2DWorld(const CWorldDesc& desc) : CBox2DWorld(desc, GetTuning(desc.m_eProfile)) {}
  CBox2DWorld(const CWorldDesc& desc, const CTuning& tuning);

private:
  void Substep(float dt) override;
  void OnAdded(CShapeId id) override;
  void OnRemoved(CShapeId id) override;
  void OnChanged(CShapeId id, eChange what) override;
  // Bodies made anew have no contacts and no cached impulses: whoever goes on from a saved state has the same
  // bits.
  void OnSaved() override { Rebuild(); }
  void OnLoaded() override { Rebuild(); }

  void Rebuild();
  void JoinShapes();
  void CountClamped(float h);
  unsigned CountCuts(float dt) const;
  void StepBox2D(float h);
  void TakeBalls();
  void TurnShapes(float dt);

  CTuning m_cTuning;
  CScale m_cScale;
  std::unique_ptr<b2World> m_pWorld;
  std::unique_ptr<CBodies> m_pBodies;
  std::unique_ptr<CContactGatherer> m_pGatherer;
  bool m_bJointsChanged = false;
};

} // namespace Shapes::Box2D
