// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/World.h>

#include <box2d/box2d.h>

#include <set>
#include <vector>

#include "Convert.h"

namespace Shapes::Box2D {

/// Name of a shape in a b2Fixture.
inline CShapeId GetId(const b2Fixture& fixture) {
  return {static_cast<std::uint32_t>(const_cast<b2Fixture&>(fixture).GetUserData().pointer)};
}
inline bool IsBall(const b2Fixture& fixture) { return fixture.GetBody()->GetType() == b2_dynamicBody; }

/// Listens to a b2World: makes the elasticity the product of both, and collects contacts in the library's
/// terms.
class CContactGatherer final : public b2ContactListener {
public:
  explicit CContactGatherer(const CScale& scale) : m_cScale(scale) {}

  void BeginContact(b2Contact* pContact) override;
  void EndContact(b2Contact* pContact) override;
  void PreSolve(b2Contact* pContact, const b2Manifold* pOld) override;

  /// The contacts since the last call, one for each ball and shape that met, the fastest of several, by ball
  /// and then by shape.
  std::vector<CContactEvent> TakeContacts();

  /// A sensor and a ball that touch now, or two balls one of which is a sensor.
  struct CSensorPair {
    CShapeId m_cBall, m_cShape;
    friend auto operator<=>(const CSensorPair&, const CSensorPair&) = default;
  };
  /// Those pairs that touch now, and those that touched at any time since the last call.
  std::vector<CSensorPair> TakeSensorPairs();
  /// Forgets what was collected; for a world that is made anew.
  void Clear();

private:
  CScale m_cScale;
  std::vector<CContactEvent> m_stdEvents;
  std::multiset<CSensorPair> m_stdTouching; // an arc touches once for each of its edges
  std::vector<CSensorPair> m_stdBegun;
};

} // namespace Shapes::Box2D
