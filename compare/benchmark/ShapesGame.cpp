// SPDX-License-Identifier: MIT
#include "Games.h"

namespace Shapes::Compare::Benchmark {
namespace {

class CShapesGame final : public CGame {
public:
  CShapesGame(const CPegField& field, eBackend backend, CEffectChoice effects, bool pairs) {
    CWorldDesc desc;
    desc.m_vGravity = {0.0f, g_fGravity};
    desc.m_fTimeStep = g_fStep;
    desc.m_cEffects = effects;
    if (!pairs) desc.m_cEffects.m_cForbidden.Set(eEffect::BallPairs);
    m_pWorld = GetBackend(backend)->MakeWorld(desc);
    for (const CAnyShapeDesc& shape : field.m_stdShapes)
      m_pWorld->Add(shape);
    for (const CDynamicCircleDesc& ball : field.m_stdBalls)
      m_pWorld->Add(ball);
  }
  void Step() override { m_pWorld->Step(); }

private:
  std::unique_ptr<CWorld> m_pWorld;
};

} // namespace

std::unique_ptr<CGame> MakeShapesGame(const CPegField& field, eBackend backend, CEffectChoice effects,
                                      bool pairs) {
  return std::make_unique<CShapesGame>(field, backend, effects, pairs);
}

} // namespace Shapes::Compare::Benchmark
