// SPDX-License-Identifier: MIT
// Steps a world that calls for some effects only, for callgrind: step-cost BALLS STEPS EFFECT... The effects
// that are named are called for by what is in the world (Events, and pairs of many balls, cannot be left out
// otherwise than by forbidding them). Prints what ran.
#include "Descs.h"
#include "Random.h"

#include <Shapes/Shapes.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

using namespace Shapes;

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s BALLS STEPS [EFFECT...]\n", argv[0]);
    return 2;
  }
  const int balls = std::atoi(argv[1]), steps = std::atoi(argv[2]);
  const std::vector<std::string_view> named(argv + 3, argv + argc);
  const auto calls = [&](eEffect e) {
    return std::find(named.begin(), named.end(), GetName(e)) != named.end();
  };

  CWorldDesc desc;
  if (calls(eEffect::Gravity)) desc.m_vGravity = {0, -0.1f};
  for (const eEffect e : {eEffect::Events, eEffect::BallPairs, eEffect::Continuous})
    if (!calls(e)) desc.m_cEffects.m_cForbidden.Set(e);
  const auto pWorld = GetBackend(eBackend::Native)->MakeWorld(desc);

  Tests::CRandom random(1);
  constexpr float half = 8;
  for (const CLineSegDesc& wall : Walls({-half, -half}, {half, half}))
    pWorld->Add(wall);
  // One ball flies in the middle of nothing.
  for (int i = 0; balls > 1 && i < 60; ++i) {
    const Vector2 p = random.InSquare(half - 1);
    pWorld->Add(CLineSegDesc(p, p + random.VectorOfLength(0.1f, 1.0f)));
  }
  // A still flipper where Kinematics is not called for.
  const float revsPerSecond = calls(eEffect::Kinematics) ? 0.1f : 0.0f;
  if (balls > 1) pWorld->Add(Turning(CLineSegDesc({-1, 7}, {1, 7}), revsPerSecond, {0, 7}));
  if (calls(eEffect::Sensors)) pWorld->Add(MakeZone({0, -6}));
  for (int i = 0; i < balls; ++i) {
    const float speed = calls(eEffect::Continuous) ? 10.0f : 0.5f;
    const Vector2 p = balls > 1 ? random.InSquare(half - 1) : Vector2(0, 0);
    pWorld->Add(CDynamicCircleDesc(p, 0.1f, balls > 1 ? speed * random.Direction() : Vector2(0.01f, 0)));
  }
  for (int i = 0; i < steps; ++i)
    pWorld->Step();
  const CWorldStats& stats = pWorld->GetStats();
  for (const auto n : stats.m_stdSubstepsWith)
    std::printf("%llu ", static_cast<unsigned long long>(n));
  std::printf("substeps with each effect, %llu contacts\n",
              static_cast<unsigned long long>(stats.m_nContacts));
}
