// SPDX-License-Identifier: MIT
// The engines that were built, for tests that run on each of them.
#pragma once

#include "../GameClock.h"

#include "../Testing.h"

namespace Shapes {

inline std::vector<const CBackend*> BuiltBackends() {
  std::vector<const CBackend*> built;
  for (const CBackend& backend : GetBackends())
    built.push_back(&backend);
  return built;
}

inline std::string BackendName(const testing::TestParamInfo<const CBackend*>& info) {
  return std::string(info.param->GetName());
}

/// The name of the parameter for GoogleTest.
inline void PrintTo(const CBackend* pBackend, std::ostream* pOut) { *pOut << pBackend->GetName(); }

class CEveryBackend : public testing::TestWithParam<const CBackend*> {
protected:
  const CBackend& Backend() const { return *GetParam(); }
  bool IsNative() const { return Backend().GetName() == "native"; }
  bool IsBox2D() const { return Backend().GetName() == "box2d"; } // whose limits are narrower
  /// How far a POI or a touching ball may be off: rounding; on Box2D its time of impact stops
  /// within 3 slops of .005, and its discrete contacts reach through a skin of .01.
  float Skin() const { return IsBox2D() ? 0.016f : 1e-6f; }
  std::unique_ptr<CWorld> Make(const CEffectChoice& choice = g_cAutomatic,
                               eProfile profile = eProfile::Shipped, const Vector2& gravity = {0, 0}) const {
    return Backend().MakeWorld(Described(gravity, g_fDt, 1, choice, profile));
  }
};

/// How a world may run.
struct CMode {
  const char* m_sName;
  CEffectChoice m_cEffects;
  eProfile m_eProfile = eProfile::Shipped;
};

inline const CMode g_stdModes[] = {{"automatic", g_cAutomatic},
                                   {"approximate", g_cApproximate},
                                   {"continuous", g_cContinuous},
                                   {"tuned", g_cAutomatic, eProfile::Tuned}};

#define SHAPES_ON_EVERY_BACKEND(suite)                                                                       \
  INSTANTIATE_TEST_SUITE_P(, suite, testing::ValuesIn(BuiltBackends()), BackendName)

/// Begins and ends of n steps as "+" and "-".
template <class T>
std::string Marks(CWorld& world, std::span<const T> (CWorld::*pGet)() const, int n = 1) {
  std::string marks;
  for (const T& event : Told(world, n, pGet))
    marks += event.m_bBegin ? '+' : '-';
  return marks;
}
/// Contacts in which the ball approached: what touches on is left out.
inline std::vector<CContactEvent> Impacts(CWorld& world, int n) {
  std::vector<CContactEvent> impacts = Told(world, n, &CWorld::GetContacts);
  std::erase_if(impacts, [](const CContactEvent& event) { return !(event.m_fSpeed > 0); });
  return impacts;
}

/// Ways in which a shape and a ball that touch come apart between two steps.
using CParting = void (*)(CWorld&, CShapeId shape, CShapeId ball);
inline constexpr CParting g_stdPartings[] = {
    [](CWorld& w, CShapeId shape, CShapeId) { w.Remove(shape); },
    [](CWorld& w, CShapeId, CShapeId ball) { w.Remove(ball); },
    [](CWorld& w, CShapeId shape, CShapeId) { w.SetSensor(shape, !w.GetSensor(shape)); },
    [](CWorld& w, CShapeId shape, CShapeId) { w.SetCanCollide(shape, false); },
    [](CWorld& w, CShapeId, CShapeId ball) { w.SetCanCollide(ball, false); },
    [](CWorld& w, CShapeId, CShapeId ball) { w.SetPos(ball, Vector2(0, 9)); },
    [](CWorld& w, CShapeId shape, CShapeId) { w.SetPos(shape, Vector2(0, -9)); }};

/// How far p is from the curve of a shape, or from the rim of a ball: negative in a ball.
inline float GetDistance(const CWorld& world, CShapeId id, const Vector2& p) {
  if (world.GetMotionType(id) == eMotion::Dynamic) return Length(p - world.GetPos(id)) - world.GetRadius(id);
  return DistanceFrom(world.GetShape(id), p);
}

} // namespace Shapes
