// SPDX-License-Identifier: MIT
// A whole pinball in sixty lines: three balls, played by a script that flips when a ball is near.
#include <Shapes/Shapes.h>

#include <algorithm>
#include <iostream>

using namespace Shapes;

int main(int argc, char** argv) {
  const CBackend* pEngine = GetBackend(argc > 1 ? argv[1] : "native");
  if (pEngine == nullptr)
    return std::cerr << "engine '" << argv[1] << "' is not in this build: expected native or box2d\n", 2;
  CWorldDesc desc;
  desc.m_vGravity = {0, -10};
  desc.m_fTimeStep = 1.0f / 120;
  desc.m_cEffects.m_cForced.Set(eEffect::Touches);
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
    flipper.m_cLimits = i == 0 ? CMotionLimits::OfAngle(0, 1) : CMotionLimits::OfAngle(-1, 0);
    flippers[i] = pWorld->Add(flipper);
  }
  CLineSegDesc drainDesc({-4, 0.3f}, {4, 0.3f});
  drainDesc.m_bIsSensor = true;
  const CShapeId drain = pWorld->Add(drainDesc);

  const Vector2 start(0.3f, 11), push(2, 0);
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc(start, 0.2f, push, 1, 0.9f));
  int score = 0, step = 0;
  for (int balls = 3; balls > 0 && step < 120 * 600; ++step) {
    const Vector2 p = pWorld->GetPos(ball);
    for (int i = 0; i < 2; ++i) {
      const bool isUp = p.y() < 1.9f && (i == 0) == (p.x() < 0);
      pWorld->SetRotSpeed(flippers[i], (i == 0) == isUp ? 1.8f : -1.8f); // as far as its stop
    }
    pWorld->Step();
    for (const CTouchEvent& event : pWorld->GetTouchEvents())
      if (event.m_bBegin && std::find(bumpers, bumpers + 3, event.m_cShape) != bumpers + 3) score += 100;
    for (const CSensorEvent& event : pWorld->GetSensorEvents())
      if (event.m_bBegin && event.m_cShape == drain)
        pWorld->SetPos(ball, start), pWorld->SetVel(ball, push), --balls;
  }
  std::cout << pEngine->GetName() << ": " << score << " points in " << step / 120 << " seconds\n";
}
