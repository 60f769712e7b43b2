// SPDX-License-Identifier: MIT
#include "Games.h"

#include <box2d/box2d.h>

#include <utility>
#include <vector>

namespace Shapes::Compare::Benchmark {
namespace {

b2Vec2 ToBox2D(const Vector2& v) { return {v.x(), v.y()}; }

class CBox2DGame final : public CGame {
public:
  CBox2DGame(const CField& field, eByHand byHand, bool pairs)
      : m_cWorld({0.0f, g_fGravity}), m_fStep(field.m_fStep) {
    m_cWorld.SetContinuousPhysics(byHand != eByHand::Discrete);
    AddBody(b2_staticBody, Vector2::Zero(), field.m_stdShapes);
    for (const CFlipper& flipper : field.m_stdFlippers)
      m_stdFlippers.emplace_back(AddBody(b2_kinematicBody, flipper.m_vPivot, flipper.m_stdParts),
                                 2.0f * g_fPi * flipper.m_fUpSpeed);
    b2BodyDef body;
    body.type = b2_dynamicBody;
    body.fixedRotation = true;
    body.allowSleep = field.m_bMaySleep && byHand != eByHand::LikeShapes;
    body.bullet = field.m_bBullets && byHand == eByHand::Continuous && pairs;
    b2FixtureDef fixture;
    fixture.density = 1.0f;
    fixture.friction = 0.0f;
    if (byHand == eByHand::LikeShapes) fixture.restitutionThreshold = 0.0f;
    fixture.filter.groupIndex = pairs ? 0 : -1;
    for (const CDynamicCircleDesc& ball : field.m_stdBalls)
      AddBall(ball, body, fixture);
  }
  void Step() override { m_cWorld.Step(m_fStep, 8, 3); }
  void Turn(float factor) override {
    for (const auto& [pBody, upSpeed] : m_stdFlippers)
      pBody->SetAngularVelocity(factor * upSpeed);
  }
  std::vector<Vector2> GetBallPositions() const override {
    std::vector<Vector2> positions;
    for (const b2Body* pBody = m_cWorld.GetBodyList(); pBody != nullptr; pBody = pBody->GetNext())
      if (pBody->GetType() == b2_dynamicBody)
        positions.emplace_back(pBody->GetPosition().x, pBody->GetPosition().y);
    return positions;
  }

private:
  b2Body* AddBody(b2BodyType type, const Vector2& origin, const std::vector<CAnyShapeDesc>& shapes) {
    b2BodyDef def;
    def.type = type;
    def.position = ToBox2D(origin);
    b2Body* pBody = m_cWorld.CreateBody(&def);
    for (const CAnyShapeDesc& shape : shapes)
      std::visit([&](const auto& desc) { AddShape(*pBody, desc); }, shape);
    return pBody;
  }
  static b2Vec2 At(const b2Body& body, const Vector2& p) { return ToBox2D(p) - body.GetPosition(); }
  static void AddFixture(b2Body& body, const b2Shape& shape, const CShapeDesc& desc) {
    b2FixtureDef def;
    def.shape = &shape;
    def.isSensor = desc.m_bIsSensor;
    body.CreateFixture(&def);
  }
  static void AddCircle(b2Body& body, const CShapeDesc& desc, float radius) {
    b2CircleShape circle;
    circle.m_p = At(body, desc.m_vPos);
    circle.m_radius = radius;
    AddFixture(body, circle, desc);
  }

  static void AddEdge(b2Body& body, const CShapeDesc& desc, const Vector2& p0, const Vector2& p1) {
    b2EdgeShape edge;
    edge.SetTwoSided(At(body, p0), At(body, p1));
    AddFixture(body, edge, desc);
  }

  static void AddShape(b2Body& body, const CLineSegDesc& desc) {
    AddEdge(body, desc, desc.GetEndPt0(), desc.GetEndPt1());
  }
  static void AddShape(b2Body& body, const CArcDesc& desc) {
    const auto ends = CutArc(desc);
    for (std::size_t i = 1; i < ends.size(); ++i)
      AddEdge(body, desc, ends[i - 1], ends[i]);
  }
  static void AddShape(b2Body& body, const CCircleDesc& desc) { AddCircle(body, desc, desc.m_fRadius); }
  static void AddShape(b2Body& body, const CPointDesc& desc) { AddCircle(body, desc, 0.0f); }
  static void AddShape(b2Body&, const CDynamicCircleDesc&) {} // none among the shapes

  void AddBall(const CDynamicCircleDesc& desc, b2BodyDef& body, b2FixtureDef& fixture) {
    body.position = ToBox2D(desc.m_vPos);
    body.linearVelocity = ToBox2D(desc.m_vVel);
    b2CircleShape circle;
    circle.m_radius = desc.m_fRadius;
    fixture.shape = &circle;
    fixture.restitution = desc.m_fElasticity;
    m_cWorld.CreateBody(&body)->CreateFixture(&fixture);
  }

  b2World m_cWorld;
  float m_fStep;
  std::vector<std::pair<b2Body*, float>> m_stdFlippers; // and their speeds up, radians per second
};

} // namespace

std::unique_ptr<CGame> MakeBox2DGame(const CField& field, eByHand byHand, bool pairs) {
  return std::make_unique<CBox2DGame>(field, byHand, pairs);
}

} // namespace Shapes::Compare::Benchmark
