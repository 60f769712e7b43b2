// SPDX-License-Identifier: MIT
#include "Games.h"

namespace Shapes::Compare::Benchmark {
namespace {

class CShapesGame final : public CGame {
public:
  CShapesGame(const CField& field, eBackend backend, CEffectChoice effects, bool pairs) {
    CWorldDesc desc;
    desc.m_vGravity = {0.0f, g_fGravity};
    desc.m_fTimeStep = field.m_fStep;
    desc.m_cEffects = effects;
    desc.m_cBox2D.m_fSagittaTolerance = g_fSagitta;
    if (!pairs) desc.m_cEffects.m_cForbidden.Set(eEffect::BallPairs);
    m_pWorld = GetBackend(backend)->MakeWorld(desc);
    for (const CAnyShapeDesc& shape : field.m_stdShapes)
      m_pWorld->Add(shape);
    for (const CFlipper& flipper : field.m_stdFlippers)
      m_stdFlippers.push_back(
          {m_pWorld->AddCompound(flipper.m_stdParts, flipper.m_vPivot), flipper.m_fUpSpeed});
    for (const CDynamicCircleDesc& ball : field.m_stdBalls)
      m_pWorld->Add(ball);
  }
  void Step() override { m_pWorld->Step(); }
  void Turn(float factor) override {
    for (const CTurning& flipper : m_stdFlippers)
      m_pWorld->SetRotSpeed(flipper.m_stdIds, factor * flipper.m_fUpSpeed);
  }
  std::vector<Vector2> GetBallPositions() const override {
    return {m_pWorld->GetBallPositions().begin(), m_pWorld->GetBallPositions().end()};
  }

private:
  struct CTurning {
    std::vector<CShapeId> m_stdIds;
    float m_fUpSpeed;
  };

  std::unique_ptr<CWorld> m_pWorld;
  std::vector<CTurning> m_stdFlippers;
};

} // namespace

std::unique_ptr<CGame> MakeShapesGame(const CField& field, eBackend backend, CEffectChoice effects,
                                      bool pairs) {
  return std::make_unique<CShapesGame>(field, backend, effects, pairs);
}

} // namespace Shapes::Compare::Benchmark
