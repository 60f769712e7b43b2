// SPDX-License-Identifier: MIT
#include "Games.h"

#include <chipmunk/chipmunk.h>

#include <cmath>
#include <vector>

namespace Shapes::Compare::Benchmark {
namespace {

cpVect ToChipmunk(const Vector2& v) { return {static_cast<cpFloat>(v.x()), static_cast<cpFloat>(v.y())}; }

class CChipmunkGame final : public CGame {
public:
  CChipmunkGame(const CPegField& field, float cells, bool pairs) : m_pSpace(cpSpaceNew()) {
    cpSpaceSetGravity(m_pSpace, {0.0, static_cast<cpFloat>(g_fGravity)});
    if (cells > 0.0f)
      cpSpaceUseSpatialHash(m_pSpace, static_cast<cpFloat>(cells),
                            static_cast<int>(10 * (field.m_stdShapes.size() + field.m_stdBalls.size())));
    for (const CAnyShapeDesc& shape : field.m_stdShapes)
      std::visit([this](const auto& desc) { AddShape(desc); }, shape);
    for (const CDynamicCircleDesc& ball : field.m_stdBalls)
      AddBall(ball, pairs);
  }
  ~CChipmunkGame() override {
    for (cpShape* pShape : m_stdShapes) {
      cpSpaceRemoveShape(m_pSpace, pShape);
      cpShapeFree(pShape);
    }
    for (cpBody* pBody : m_stdBodies) {
      cpSpaceRemoveBody(m_pSpace, pBody);
      cpBodyFree(pBody);
    }
    cpSpaceFree(m_pSpace);
  }
  void Step() override { cpSpaceStep(m_pSpace, static_cast<cpFloat>(g_fStep)); }

private:
  cpShape* Add(cpShape* pShape, float elasticity) {
    cpShapeSetElasticity(pShape, static_cast<cpFloat>(elasticity));
    cpSpaceAddShape(m_pSpace, pShape);
    m_stdShapes.push_back(pShape);
    return pShape;
  }
  void AddSegment(const Vector2& p0, const Vector2& p1) {
    Add(cpSegmentShapeNew(cpSpaceGetStaticBody(m_pSpace), ToChipmunk(p0), ToChipmunk(p1), 0.0), 1.0f);
  }
  void AddShape(const CLineSegDesc& desc) { AddSegment(desc.GetEndPt0(), desc.GetEndPt1()); }
  void AddShape(const CArcDesc& desc) {
    constexpr int pieces = 8;
    const auto at = [&](int i) {
      const float angle =
          desc.GetAngle0() + (desc.GetAngle1() - desc.GetAngle0()) * static_cast<float>(i) / pieces;
      return Vector2(desc.m_vPos + desc.m_fRadius * Vector2(std::cos(angle), std::sin(angle)));
    };
    for (int i = 0; i < pieces; ++i)
      AddSegment(at(i), at(i + 1));
  }
  void AddShape(const CCircleDesc& desc) {
    Add(cpCircleShapeNew(cpSpaceGetStaticBody(m_pSpace), static_cast<cpFloat>(desc.m_fRadius),
                         ToChipmunk(desc.m_vPos)),
        1.0f);
  }
  void AddShape(const CPointDesc&) {} // the field has none
  void AddShape(const CDynamicCircleDesc&) {}

  void AddBall(const CDynamicCircleDesc& desc, bool pairs) {
    cpBody* pBody = cpSpaceAddBody(m_pSpace, cpBodyNew(1.0, INFINITY));
    m_stdBodies.push_back(pBody);
    cpBodySetPosition(pBody, ToChipmunk(desc.m_vPos));
    cpBodySetVelocity(pBody, ToChipmunk(desc.m_vVel));
    cpShape* pShape =
        Add(cpCircleShapeNew(pBody, static_cast<cpFloat>(desc.m_fRadius), {0.0, 0.0}), desc.m_fElasticity);
    if (!pairs) cpShapeSetFilter(pShape, {1, CP_ALL_CATEGORIES, CP_ALL_CATEGORIES}); // one group: no contact
  }

  cpSpace* m_pSpace;
  std::vector<cpShape*> m_stdShapes;
  std::vector<cpBody*> m_stdBodies;
};

} // namespace

std::unique_ptr<CGame> MakeChipmunkGame(const CPegField& field, float cells, bool pairs) {
  return std::make_unique<CChipmunkGame>(field, cells, pairs);
}

} // namespace Shapes::Compare::Benchmark
