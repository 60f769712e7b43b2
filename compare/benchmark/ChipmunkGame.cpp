// SPDX-License-Identifier: MIT
#include "Games.h"

#include <chipmunk/chipmunk.h>

#include <utility>
#include <vector>

namespace Shapes::Compare::Benchmark {
namespace {

cpVect ToChipmunk(const Vector2& v) { return {static_cast<cpFloat>(v.x()), static_cast<cpFloat>(v.y())}; }

class CChipmunkGame final : public CGame {
public:
  CChipmunkGame(const CField& field, bool hash, bool pairs)
      : m_pSpace(cpSpaceNew()), m_fStep(static_cast<cpFloat>(field.m_fStep)) {
    cpSpaceSetGravity(m_pSpace, {0.0, static_cast<cpFloat>(g_fGravity)});
    if (field.m_bMaySleep) cpSpaceSetSleepTimeThreshold(m_pSpace, 0.5); // it has no default
    if (hash)
      cpSpaceUseSpatialHash(m_pSpace, static_cast<cpFloat>(field.m_fCell),
                            static_cast<int>(10 * (field.m_stdShapes.size() + field.m_stdBalls.size())));
    AddShapes(cpSpaceGetStaticBody(m_pSpace), field.m_stdShapes);
    for (const CFlipper& flipper : field.m_stdFlippers) {
      cpBody* pBody = AddBody(cpBodyNewKinematic(), flipper.m_vPivot);
      AddShapes(pBody, flipper.m_stdParts);
      m_stdFlippers.emplace_back(pBody, 2.0f * g_fPi * flipper.m_fUpSpeed);
    }
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
  void Step() override { cpSpaceStep(m_pSpace, m_fStep); }
  void Turn(float factor) override {
    for (const auto& [pBody, upSpeed] : m_stdFlippers)
      cpBodySetAngularVelocity(pBody, static_cast<cpFloat>(factor * upSpeed));
  }
  std::vector<Vector2> GetBallPositions() const override {
    std::vector<Vector2> positions;
    for (cpBody* pBody : m_stdBodies) {
      const auto [x, y] = cpBodyGetPosition(pBody);
      if (cpBodyGetType(pBody) == CP_BODY_TYPE_DYNAMIC)
        positions.emplace_back(static_cast<float>(x), static_cast<float>(y));
    }
    return positions;
  }

private:
  cpBody* AddBody(cpBody* pBody, const Vector2& p) {
    m_stdBodies.push_back(cpSpaceAddBody(m_pSpace, pBody));
    cpBodySetPosition(pBody, ToChipmunk(p));
    return pBody;
  }
  cpShape* Add(cpShape* pShape, const CShapeDesc& desc) {
    cpShapeSetElasticity(pShape, static_cast<cpFloat>(desc.m_fElasticity));
    cpShapeSetSensor(pShape, desc.m_bIsSensor);
    m_stdShapes.push_back(cpSpaceAddShape(m_pSpace, pShape));
    return pShape;
  }
  static cpVect At(cpBody* pBody, const Vector2& p) {
    return cpvsub(ToChipmunk(p), cpBodyGetPosition(pBody));
  }
  void AddShapes(cpBody* pBody, const std::vector<CAnyShapeDesc>& shapes) {
    for (const CAnyShapeDesc& shape : shapes)
      std::visit([&](const auto& desc) { AddShape(pBody, desc); }, shape);
  }
  void AddSegment(cpBody* pBody, const CShapeDesc& desc, const Vector2& p0, const Vector2& p1) {
    Add(cpSegmentShapeNew(pBody, At(pBody, p0), At(pBody, p1), 0.0), desc);
  }
  void AddCircle(cpBody* pBody, const CShapeDesc& desc, float radius) {
    Add(cpCircleShapeNew(pBody, static_cast<cpFloat>(radius), At(pBody, desc.m_vPos)), desc);
  }

  void AddShape(cpBody* pBody, const CLineSegDesc& desc) {
    AddSegment(pBody, desc, desc.GetEndPt0(), desc.GetEndPt1());
  }
  void AddShape(cpBody* pBody, const CArcDesc& desc) {
    const auto ends = CutArc(desc);
    for (std::size_t i = 1; i < ends.size(); ++i)
      AddSegment(pBody, desc, ends[i - 1], ends[i]);
  }
  void AddShape(cpBody* pBody, const CCircleDesc& desc) { AddCircle(pBody, desc, desc.m_fRadius); }
  void AddShape(cpBody* pBody, const CPointDesc& desc) { AddCircle(pBody, desc, 0.0f); }
  void AddShape(cpBody*, const CDynamicCircleDesc&) {} // none among the shapes

  void AddBall(const CDynamicCircleDesc& desc, bool pairs) {
    cpBody* pBody = AddBody(cpBodyNew(1.0, INFINITY), desc.m_vPos);
    cpBodySetVelocity(pBody, ToChipmunk(desc.m_vVel));
    cpShape* pShape = Add(cpCircleShapeNew(pBody, static_cast<cpFloat>(desc.m_fRadius), {0.0, 0.0}), desc);
    if (!pairs) cpShapeSetFilter(pShape, {1, CP_ALL_CATEGORIES, CP_ALL_CATEGORIES}); // one group: no contact
  }

  cpSpace* m_pSpace;
  cpFloat m_fStep;
  std::vector<cpShape*> m_stdShapes;
  std::vector<cpBody*> m_stdBodies;
  std::vector<std::pair<cpBody*, float>> m_stdFlippers; // and their speeds up, radians per second
};

} // namespace

std::unique_ptr<CGame> MakeChipmunkGame(const CField& field, bool hash, bool pairs) {
  return std::make_unique<CChipmunkGame>(field, hash, pairs);
}

} // namespace Shapes::Compare::Benchmark
