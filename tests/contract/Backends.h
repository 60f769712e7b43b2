// SPDX-License-Identifier: MIT
// The engines that were built, for tests that run on each of them.
#pragma once

#include "../Numbers.h"
#include "../Steps.h"

#include <Shapes/Shapes.h>

#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>
#include <vector>

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

/// What GoogleTest prints of the parameter.
inline void PrintTo(const CBackend* pBackend, std::ostream* pOut) { *pOut << pBackend->GetName(); }

class CEveryBackend : public testing::TestWithParam<const CBackend*> {
protected:
  const CBackend& Backend() const { return *GetParam(); }
  bool IsNative() const { return Backend().GetName() == "native"; }
  /// How far a POI or a touching ball may be off: rounding on native; on Box2D its time of impact stops
  /// within 3 slops of .005, and its discrete contacts reach through a skin of .01.
  float Skin() const { return IsNative() ? 1e-6f : 0.016f; }
  std::unique_ptr<CWorld> Make(const CEffectChoice& choice = g_cAutomatic,
                               eProfile profile = eProfile::Shipped, const Vector2& gravity = {0, 0}) const {
    CWorldDesc desc;
    desc.m_vGravity = gravity;
    desc.m_fTimeStep = g_fDt;
    desc.m_cEffects = choice;
    desc.m_cBox2D.m_eProfile = profile;
    return Backend().MakeWorld(desc);
  }
};

#define SHAPES_ON_EVERY_BACKEND(suite)                                                                       \
  INSTANTIATE_TEST_SUITE_P(, suite, testing::ValuesIn(BuiltBackends()), BackendName)

/// Sets what CShape::move uses, as a game does it.
struct CGameClock : CShapeCommon {
  static void Set(float dt, float gravity) {
    m_fTimeStep = dt;
    m_fGravity = gravity;
  }
};

} // namespace Shapes
