// SPDX-License-Identifier: MIT
// The engines that were built, for tests that run on each of them.
#pragma once

#include <Shapes/Shapes.h>

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

namespace Shapes {

inline std::vector<eBackend> BuiltBackends() {
  std::vector<eBackend> built;
  for (const eBackend e : {eBackend::Native, eBackend::Box2D})
    if (GetBackend(e) != nullptr) built.push_back(e);
  return built;
}

inline std::string BackendName(const testing::TestParamInfo<eBackend>& info) {
  return std::string(GetBackend(info.param)->GetName());
}

/// What GoogleTest prints of the parameter.
inline void PrintTo(eBackend e, std::ostream* pOut) { *pOut << GetBackend(e)->GetName(); }

class CEveryBackend : public testing::TestWithParam<eBackend> {
protected:
  const CBackend& Backend() const { return *GetBackend(GetParam()); }
  bool IsNative() const { return GetParam() == eBackend::Native; }
  /// How far a POI or a touching ball may be off: rounding on native; on Box2D its time of impact stops
  /// within 3 slops of .005, and its discrete contacts reach through a skin of .01.
  float Skin() const { return IsNative() ? 1e-6f : 0.016f; }
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
