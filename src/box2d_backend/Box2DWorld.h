// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/World.h>

#include <box2d/box2d.h>

#include <map>
#include <memory>

#include "ContactGatherer.h"
#include "Convert.h"

namespace Shapes::Box2D {

/// A world on a b2World of its own: one b2Body for each shape. Elasticity is the product, there is no
/// restitution threshold, no friction, no rotation of balls, and no sleep; all else is as Box2D ships.
class CBox2DWorld final : public CWorld {
public:
  explicit CBox2DWorld(const CWorldDesc& desc);

private:
  struct CBody {
    b2Body* m_pBody;
    float m_fBaseOrientation; // orientation of the shape when its fixtures were made
    int m_nArcPieces;
  };

  void Substep(float dt) override;
  void OnAdded(CShapeId id) override;
  void OnRemoved(CShapeId id) override;
  void OnChanged(CShapeId id, eChange what) override;
  // Bodies made anew have no contacts and no cached impulses: whoever goes on from a saved state has the same
  // bits.
  void OnSaved() override { Rebuild(); }
  void OnLoaded() override { Rebuild(); }

  void Rebuild();
  void CountClamped(float dt);
  void TakeBalls();
  void TurnShapes(float dt);
  void ReportContacts();
  void ReportSensors();
  void CreateBall(std::size_t i);
  void CreateShape(const CShape& shape, CShapeId id);
  void SetProperties(CShapeId id);

  CScale m_cScale;
  CContactGatherer m_cGatherer;
  std::unique_ptr<b2World> m_pWorld;
  std::map<CShapeId, CBody> m_stdBodies;
};

} // namespace Shapes::Box2D
