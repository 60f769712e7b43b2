// SPDX-License-Identifier: MIT
// Worlds of games, for the tests of what becomes of them.
#pragma once

#include "Box2DTesting.h"

namespace Shapes {

/// A b2World with the calls that a test needs in one line each.
class CGame {
public:
  explicit CGame(const b2Vec2& gravity = b2Vec2_zero) : m_cWorld(gravity) {}

  static b2Body* AddBody(b2World& world, b2BodyType type, const b2Vec2& p = b2Vec2_zero, float angle = 0.0f) {
    b2BodyDef def;
    def.type = type;
    def.position = p;
    def.angle = angle;
    return world.CreateBody(&def);
  }
  b2Body* AddBody(b2BodyType type, const b2Vec2& p = b2Vec2_zero, float angle = 0.0f) {
    return AddBody(m_cWorld, type, p, angle);
  }
  /// Without friction and threshold, so that what is left has a counterpart.
  static b2Fixture* AddFixture(b2Body* pBody, const b2Shape& shape, float restitution = 0.0f) {
    b2FixtureDef def;
    def.shape = &shape;
    def.density = 1.0f;
    def.friction = 0.0f;
    def.restitution = restitution;
    def.restitutionThreshold = 0.0f;
    return pBody->CreateFixture(&def);
  }
  b2Body* AddBall(const b2Vec2& p, const b2Vec2& v = b2Vec2_zero, float restitution = 0.0f, float r = 0.1f) {
    b2Body* pBody = AddBody(b2_dynamicBody, p);
    AddFixture(pBody, Circle(b2Vec2_zero, r), restitution);
    pBody->SetLinearVelocity(v);
    return pBody;
  }
  b2Body* AddStatic(const b2Shape& shape, float restitution = 0.0f) {
    b2Body* pBody = AddBody(b2_staticBody);
    AddFixture(pBody, shape, restitution);
    return pBody;
  }

  static b2CircleShape Circle(const b2Vec2& p, float r) {
    b2CircleShape circle;
    circle.m_p = p;
    circle.m_radius = r;
    return circle;
  }
  static b2EdgeShape Edge(const b2Vec2& p, const b2Vec2& q) {
    b2EdgeShape edge;
    edge.SetTwoSided(p, q);
    return edge;
  }
  static b2PolygonShape Box(float halfWidth, float halfHt) {
    b2PolygonShape box;
    box.SetAsBox(halfWidth, halfHt);
    return box;
  }

  b2World m_cWorld;
};

template <class TDesc>
std::vector<TDesc> GetAll(const CSceneDesc& scene) {
  std::vector<TDesc> all;
  for (const CAnyShapeDesc& any : scene.m_stdShapes)
    if (const TDesc* p = std::get_if<TDesc>(&any)) all.push_back(*p);
  return all;
}

} // namespace Shapes
