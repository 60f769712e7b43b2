// SPDX-License-Identifier: MIT
// A ball bounces in a bowl.
#include <Shapes/Shapes.h>

#include <iostream>

int main() {
  Shapes::CWorldDesc desc;
  desc.m_vGravity = {0, -10};
  const auto pWorld = Shapes::MakeWorld(desc);
  pWorld->Add(Shapes::CArcDesc({0, 0}, 2, 0, 0)); // equal angles: the full circle
  const auto ball = pWorld->Add(Shapes::CDynamicCircleDesc({0.5f, 1}, 0.1f, {0, 0}, 1, 0.8f));

  std::cout << "engine: " << Shapes::GetDefaultBackend().GetName() << '\n';
  for (int i = 1; i <= 180; ++i) {
    pWorld->Step();
    for (const auto& contact : pWorld->GetContacts())
      std::cout << "step " << i << ": contact at (" << contact.m_vPOI.transpose() << "), speed "
                << contact.m_fSpeed << '\n';
  }
  std::cout << "at the end the ball is at (" << pWorld->GetPos(ball).transpose() << ")\n";
}
