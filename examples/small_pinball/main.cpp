// SPDX-License-Identifier: MIT
// A whole pinball in sixty lines: three balls, played by a script that flips when a ball is near.
#include <Shapes/Shapes.h>

#include <algorithm>
#include <iostream>

using namespace Shapes;

int main(int argc, char** argv) {
  const CBackend* pEngine = GetBackend(argc > 1 ? argv[1] : "native");
  if (pEngine == nullptr)
    return std::cerr << "the engine is " << argv[1] << ": expected native or box2d\n", 2;
  CWorldDesc desc;
  desc.m_vGravity = {0, -10};
  desc.m_fTimeStep = 1.0f / 120;
  const auto pWorld = pEngine->MakeWorld(desc);

  // A bowl upside down on two walls, and two ramps to the flippers.
  pWorld->Add(CArcDesc({0, 8}, 4, 0, g_fPi, 0.8f));
  for (const float side : {-1.0f, 1.0f}) {
    pWorld->Add(CLineSegDesc({4 * side, 0}, {4 * side, 8}, 0.8f));
    pWorld->Add(CLineSegDesc({4 * side, 3}, {1.6f * side, 1.8f}, 0.5f));
  }
  CShapeId bumpers[3], flippers[2];
  for (int i = 0; i < 3; ++i)
    bumpers[i] =
        pWorld->Add(CCircleDesc({1.8f * static_cast<float>(i - 1), i == 1 ? 7.0f : 8.5f}, 0.5f, 1.4f));
  for (int i = 0; i < 2; ++i) {
    const float side = i == 0 ? -1.0f : 1.0f;
    CLineSegDesc flipper({1.6f * side, 1.8f}, {0.35f * side, 1.2f}, 0.5f);
    flipper.m_eMotionType = eMotion::Kinematic;
    flipper.m_vRotCenter = {1.6f * side, 1.8f};
    flippers[i] = pWorld->Add(flipper);
  }
  CLineSegDesc drainDesc({-4, 0.3f}, {4, 0.3f});
  drainDesc.m_bIsSensor = true;
  const CShapeId drain = pWorld->Add(drainDesc);

  const Vector2 start(0.3f, 11), push(2, 0);
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc(start, 0.2f, push, 1, 0.9f));
  int score = 0, step = 0;
  float turned[2] = {0, 0}; // how far each flipper is up, in revolutions
  for (int balls = 3; balls > 0 && step < 120 * 600; ++step) {
    const Vector2 p = pWorld->GetPos(ball);
    for (int i = 0; i < 2; ++i) {
      const bool isUp = p.y() < 1.9f && (i == 0) == (p.x() < 0);
      const float turn = std::clamp((isUp ? 0.15f : 0.0f) - turned[i], -0.01f, 0.015f);
      turned[i] += turn;
      pWorld->SetRotSpeed(flippers[i], (i == 0 ? turn : -turn) / desc.m_fTimeStep);
    }
    pWorld->Step();
    for (const CContactEvent& contact : pWorld->GetContacts())
      if (std::find(bumpers, bumpers + 3, contact.m_cShape) != bumpers + 3) score += 100;
    for (const CSensorEvent& event : pWorld->GetSensorEvents())
      if (event.m_bBegin && event.m_cShape == drain)
        pWorld->SetPos(ball, start), pWorld->SetVel(ball, push), --balls;
  }
  std::cout << pEngine->GetName() << ": " << score << " points in " << step / 120 << " seconds\n";
}
