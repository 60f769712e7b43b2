// SPDX-License-Identifier: MIT
// Without friction what moves along itself does nothing to balls that lie on it, of however many shapes it
// is made.
#include "NativeTesting.h"

namespace Shapes {
namespace {

constexpr float g_fHeavy = 10;

struct CResult {
  double m_fGain = 0; // largest one in a step, in energies at the start
  float m_fFastest = 0;
};

CResult Play(CWorld& world, float gravity = g_fHeavy) {
  CResult result;
  const double first = GetEnergy(world, gravity);
  double last = first;
  for (int step = 0; step < 300; ++step) {
    world.Step();
    const double before = std::exchange(last, GetEnergy(world, gravity));
    result.m_fGain = std::max(result.m_fGain, (last - before) / first);
    result.m_fFastest = std::max(result.m_fFastest, GetFastest(world));
  }
  return result;
}

void AddBalls(CWorld& world, const Vector2& middle, float half) {
  CRandom random(1);
  for (int i = 0; i < 50; ++i)
    world.Add(CDynamicCircleDesc(middle + random.InSquare(half), 0.15f, Vector2::Zero(), 1, 0.5f));
}

// A drum of arcs that turn about its middle.
CResult PlayDrum(int arcs, float revsPerSecond) {
  const auto pWorld = MakeNative(g_cAutomatic, g_fHeavy);
  const Vector2 middle(0, 4);
  const auto at = [&](int k) { return 2 * g_fPi * static_cast<float>(k) / static_cast<float>(arcs); };
  for (int k = 0; k < arcs; ++k)
    pWorld->Add(Turning(CArcDesc(middle, 4, at(k), at(k + 1)), revsPerSecond, middle));
  AddBalls(*pWorld, middle, 2.4f);
  return Play(*pWorld);
}

// A belt of segments between two walls. The balls lie on its front, or gravity pulls them up to its back.
CResult PlayBelt(int segments, float speed, bool isFront) {
  const float up = isFront ? 1.0f : -1.0f;
  const auto pWorld = MakeNative(g_cAutomatic, up * g_fHeavy);
  const auto at = [&](int k) {
    return Vector2(-200 + 400 * static_cast<float>(k) / static_cast<float>(segments), 0);
  };
  for (int k = 0; k < segments; ++k) {
    CLineSegDesc part = Turning(CLineSegDesc(at(k), at(k + 1)));
    part.m_vVel = {speed, 0};
    pWorld->Add(part);
  }
  for (const float x : {-2.0f, 2.0f})
    pWorld->Add(CLineSegDesc({x, 0}, {x, 40 * up}));
  AddBalls(*pWorld, {0, 2.2f * up}, 1.8f);
  return Play(*pWorld, up * g_fHeavy);
}

// Overlaps at the start are lifted: 8e-4 of the energy at most.
void ExpectAsAtRest(const CResult& moving, const CResult& resting) {
  EXPECT_LT(resting.m_fGain, 1e-3);
  EXPECT_LT(moving.m_fGain, 1e-3);
  EXPECT_LT(moving.m_fFastest, 1.2f * resting.m_fFastest); // in piles it is chance who is hit how
}

TEST(ContinuousEnds, ADrumThatTurnsDoesNothing) {
  for (const int arcs : {2, 4, 16})
    for (const float revsPerSecond : {0.5f, 2.0f}) {
      SCOPED_TRACE(testing::Message() << arcs << " arcs, " << revsPerSecond);
      ExpectAsAtRest(PlayDrum(arcs, revsPerSecond), PlayDrum(arcs, 0));
    }
}

TEST(ContinuousEnds, ABeltThatMovesAlongItselfDoesNothing) {
  for (const bool isFront : {true, false})
    for (const int segments : {1, 8, 40})
      for (const float speed : {5.0f, 30.0f}) {
        SCOPED_TRACE(testing::Message() << segments << " segments, " << speed << (isFront ? "" : ", back"));
        ExpectAsAtRest(PlayBelt(segments, speed, isFront), PlayBelt(segments, 0, isFront));
      }
}

// The control: an end beyond which nothing goes on is a corner.
TEST(ContinuousEnds, ADrumWithAGapThrowsBalls) {
  const auto pWorld = MakeNative(g_cAutomatic, g_fHeavy);
  const Vector2 middle(0, 4);
  pWorld->Add(CCircleDesc(middle, 4.2f));
  pWorld->Add(Turning(CArcDesc(middle, 4, 0, 6), 0.5f, middle));
  AddBalls(*pWorld, middle, 2.4f);
  EXPECT_GT(Play(*pWorld).m_fGain, 1e-2);
}

} // namespace
} // namespace Shapes
