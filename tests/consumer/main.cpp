// SPDX-License-Identifier: MIT
// Somebody else's program uses the library: it names its engine and drops a ball onto the floor.
#include <Shapes/Shapes.h>

#include <iostream>

int main() {
  Shapes::CWorldDesc desc;
  desc.m_vGravity = {0, -10};
  const auto pWorld = Shapes::MakeWorld(desc);
  pWorld->Add(Shapes::CLineSegDesc({-1, 0}, {1, 0}));
  const auto ball = pWorld->Add(Shapes::CDynamicCircleDesc({0, 1}, 0.1f));
  for (int i = 0; i < 30; ++i)
    pWorld->Step();
  std::cout << "engine: " << Shapes::GetDefaultBackend().GetName() << '\n';
  const bool hasBox2D = Shapes::GetBackend(Shapes::eBackend::Box2D) != nullptr;
  std::cout << "box2d: " << (hasBox2D ? "yes" : "no") << '\n';
  return pWorld->GetVel(ball).y() > 0 ? 0 : 1; // it has bounced
}
