// SPDX-License-Identifier: MIT
#include "Games.h"

#include <box2d/box2d.h>

#include <cmath>

namespace Shapes::Compare::Benchmark {
namespace {

b2Vec2 ToBox2D(const Vector2& v) { return {v.x(), v.y()}; }

class CBox2DGame final : public CGame {
public:
  CBox2DGame(const CPegField& field, bool continuous, bool pairs)
      : m_cWorld({0.0f, g_fGravity}), m_pGround(MakeGround()) {
    m_cWorld.SetContinuousPhysics(continuous);
    for (const CAnyShapeDesc& shape : field.m_stdShapes)
      std::visit([this](const auto& desc) { AddShape(desc); }, shape);
    for (const CDynamicCircleDesc& ball : field.m_stdBalls)
      AddBall(ball, continuous, pairs);
  }
  void Step() override { m_cWorld.Step(g_fStep, 8, 3); }

private:
  b2Body* MakeGround() {
    const b2BodyDef def;
    return m_cWorld.CreateBody(&def);
  }
  void AddFixture(const b2Shape& shape) { m_pGround->CreateFixture(&shape, 0.0f); }

  void AddShape(const CLineSegDesc& desc) {
    b2EdgeShape edge;
    edge.SetTwoSided(ToBox2D(desc.GetEndPt0()), ToBox2D(desc.GetEndPt1()));
    AddFixture(edge);
  }
  void AddShape(const CArcDesc& desc) {
    constexpr int pieces = 8;
    b2Vec2 points[pieces + 1];
    for (int i = 0; i <= pieces; ++i) {
      const float angle =
          desc.GetAngle0() + (desc.GetAngle1() - desc.GetAngle0()) * static_cast<float>(i) / pieces;
      points[i] = ToBox2D(desc.m_vPos + desc.m_fRadius * Vector2(std::cos(angle), std::sin(angle)));
    }
    b2ChainShape chain;
    chain.CreateChain(points, pieces + 1, points[0], points[pieces]);
    AddFixture(chain);
  }
  void AddShape(const CCircleDesc& desc) {
    b2CircleShape circle;
    circle.m_p = ToBox2D(desc.m_vPos);
    circle.m_radius = desc.m_fRadius;
    AddFixture(circle);
  }
  void AddShape(const CPointDesc&) {} // the field has none
  void AddShape(const CDynamicCircleDesc&) {}

  void AddBall(const CDynamicCircleDesc& desc, bool continuous, bool pairs) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = ToBox2D(desc.m_vPos);
    def.linearVelocity = ToBox2D(desc.m_vVel);
    def.fixedRotation = true;
    def.allowSleep = false;
    def.bullet = continuous && pairs;
    b2CircleShape circle;
    circle.m_radius = desc.m_fRadius;
    b2FixtureDef fixture;
    fixture.shape = &circle;
    fixture.density = 1.0f;
    fixture.friction = 0.0f;
    fixture.restitution = desc.m_fElasticity;
    fixture.filter.groupIndex = pairs ? 0 : -1;
    m_cWorld.CreateBody(&def)->CreateFixture(&fixture);
  }

  b2World m_cWorld;
  b2Body* m_pGround;
};

} // namespace

std::unique_ptr<CGame> MakeBox2DGame(const CPegField& field, bool continuous, bool pairs) {
  return std::make_unique<CBox2DGame>(field, continuous, pairs);
}

} // namespace Shapes::Compare::Benchmark
