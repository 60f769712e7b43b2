// SPDX-License-Identifier: MIT
// A game that has a b2World of its own: boxes on a ground, a seesaw, a listener that counts. Shapes comes
// into it: an arc, two flippers, and balls that push the boxes and are kicked by the flippers.
#include <Shapes/Box2D.h>
#include <Shapes/Shapes.h>

#include <box2d/box2d.h>

#include <algorithm>
#include <iostream>

namespace {

class CGameListener : public b2ContactListener {
public:
  void BeginContact(b2Contact*) override { ++m_nHeard; }
  int m_nHeard = 0;
};

b2Body* AddBox(b2World& world, const b2Vec2& p, float halfWidth, float halfHeight, b2BodyType type) {
  b2BodyDef def;
  def.type = type;
  def.position = p;
  b2Body* pBody = world.CreateBody(&def);
  b2PolygonShape box;
  box.SetAsBox(halfWidth, halfHeight);
  pBody->CreateFixture(&box, 1.0f);
  return pBody;
}

} // namespace

int main() {
  // The game as it was.
  CGameListener listener;
  b2World world({0, -10});
  world.SetContactListener(&listener);
  AddBox(world, {0, -0.5f}, 20, 0.5f, b2_staticBody);
  b2Body* pStack[3];
  for (int i = 0; i < 3; ++i)
    pStack[i] = AddBox(world, {4, 0.25f + 0.5f * static_cast<float>(i)}, 0.25f, 0.25f, b2_dynamicBody);
  b2Body* pPost = AddBox(world, {-4, 0.5f}, 0.1f, 0.5f, b2_staticBody);
  b2Body* pPlank = AddBox(world, {-4, 1.1f}, 1.5f, 0.1f, b2_dynamicBody);
  b2RevoluteJointDef joint;
  joint.Initialize(pPost, pPlank, {-4, 1.1f});
  world.CreateJoint(&joint);

  // The balls and flippers of Shapes in it.
  Shapes::CWorldDesc desc;
  desc.m_cBox2D.m_eProfile = Shapes::eProfile::Tuned;
  const auto pShapes = Shapes::MakeWorld(world, desc);
  pShapes->GetWorld().Add(
      Shapes::CArcDesc({2, 2}, 2, Shapes::g_fPi, 1.5f * Shapes::g_fPi)); // a ramp down to the boxes
  for (const float x : {-4.9f, -3.1f}) {
    Shapes::CLineSegDesc flipper({x, 4}, {x + 0.8f, 4});
    flipper.m_eMotionType = Shapes::eMotion::Kinematic;
    flipper.m_vRotCenter = flipper.GetEndPt0();
    flipper.m_fRotSpeed = 1;
    pShapes->GetWorld().Add(flipper);
  }
  const auto runner =
      pShapes->GetWorld().Add(Shapes::CDynamicCircleDesc({0.2f, 2.5f}, 0.15f, {0, -4}, 1, 0.3f));
  const auto kicked =
      pShapes->GetWorld().Add(Shapes::CDynamicCircleDesc({-2.6f, 4.15f}, 0.1f, {0, 0}, 0.5f, 0.8f));
  pShapes->GetWorld().Add(Shapes::CDynamicCircleDesc({-5, 2}, 0.2f, {0, 0}, 5, 0.2f)); // onto the plank

  float fastest = 0, highest = 0, tilt = 0;
  int met = 0;
  for (int i = 0; i < 240; ++i) {
    const float dt = 1.0f / 60.0f;
    pShapes->PreStep(dt);
    world.Step(dt, 8, 3);
    pShapes->PostStep();
    highest = std::max(highest, pShapes->GetWorld().GetPos(kicked).y());
    tilt = std::max(tilt, pPlank->GetAngle());
    for (const b2Body* pBox : pStack)
      fastest = std::max(fastest, pBox->GetLinearVelocity().Length());
    for (const auto& contact :
         pShapes->GetWorld().GetContacts()) // no shape of Shapes: one of the game's bodies
      met += contact.m_cBall == runner && contact.m_cShape == Shapes::CShapeId();
  }
  const Shapes::CWorldStats& stats = pShapes->GetWorld().GetStats();
  std::cout << "a ball pushed a box to " << fastest << " m/s\n"
            << "a flipper kicked a ball up to " << highest << " m\n"
            << "a ball tilted the plank by " << tilt << " rad\n"
            << "contacts of the first ball with bodies of the game: " << met << '\n'
            << "the game's listener heard " << listener.m_nHeard << " contacts begin\n"
            << "lost: " << stats.m_nBodiesLost << ", slowed down: " << stats.m_nMovesClamped << '\n';
}
