// SPDX-License-Identifier: MIT
// An effect that is not called for changes nothing, be it allowed, forced or forbidden; and states go from
// one choice to another. The same on every engine.
#include "Backends.h"

namespace Shapes {
namespace {

constexpr std::uint64_t g_nEffectBitsContractSeed = 505;

// The content of a scene.
struct CScene {
  bool m_bGravity = true, m_bTurns = true, m_bPairs = true, m_bSensor = true, m_bFast = true;
  float m_fElasticity = 0.9f;
};

// A box with a bit of everything in it.
std::unique_ptr<CWorld> MakeWorldOf(const CBackend& backend, const CScene& scene, const CEffectChoice& choice,
                                    eProfile profile = eProfile::Shipped) {
  const Vector2 gravity(0, scene.m_bGravity ? -2 : 0);
  auto pWorld = backend.MakeWorld(Described(gravity, 1.0f / 120.0f, 1, choice, profile));
  for (const CLineSegDesc& wall : Walls({-2, -2}, {2, 2}, scene.m_fElasticity))
    pWorld->Add(wall);
  pWorld->Add(CArcDesc({0, 0}, 1.9f, 0.2f, 2.9f, scene.m_fElasticity));
  pWorld->Add(CPointDesc(Vector2(0.3f, -1)));
  pWorld->Add(Turning(CLineSegDesc({-1, -1}, {-0.5f, -1}, scene.m_fElasticity), scene.m_bTurns ? 0.6f : 0.0f,
                      {-0.75f, -1}));
  if (scene.m_bSensor) pWorld->Add(MakeZone({0, 0}, 0.5f));
  Tests::CRandom random(g_nEffectBitsContractSeed);
  for (int i = 0; i < (scene.m_bPairs ? 12 : 1); ++i) {
    const float x = -1.3f + 0.6f * static_cast<float>(i % 4), y = -0.6f + 0.6f * static_cast<float>(i / 4);
    const float speed = scene.m_bFast && i % 4 == 0 ? 12.0f : 1.0f;
    const float angle = random.Uniform(0, g_fTwoPi);
    pWorld->Add(CDynamicCircleDesc({x, y}, 0.1f, speed * AngleToVector(angle), 1, scene.m_fElasticity));
  }
  return pWorld;
}

// Where all balls are after each of n steps.
std::vector<Vector2> Path(CWorld& world, int n = 400) {
  std::vector<Vector2> path;
  for (int i = 0; i < n; ++i) {
    world.Step();
    path.insert(path.end(), world.GetBallPositions().begin(), world.GetBallPositions().end());
    path.insert(path.end(), world.GetBallVelocities().begin(), world.GetBallVelocities().end());
  }
  return path;
}

class CEffectBits : public CEveryBackend {
protected:
  std::vector<Vector2> Run(const CScene& scene, const CEffectChoice& choice,
                           eProfile profile = eProfile::Shipped) const {
    return Path(*MakeWorldOf(Backend(), scene, choice, profile));
  }
};
SHAPES_ON_EVERY_BACKEND(CEffectBits);

TEST_P(CEffectBits, WhatIsNotCalledForChangesNothing) {
  CScene flat, still, alone, blind;
  flat.m_bGravity = still.m_bTurns = alone.m_bPairs = blind.m_bSensor = false;
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned})
    for (const auto& [e, scene] : {std::pair(eEffect::Gravity, flat),
                                   {eEffect::Kinematics, still},
                                   {eEffect::BallPairs, alone},
                                   {eEffect::Sensors, blind}}) {
      SCOPED_TRACE(GetName(e));
      const auto path = Run(scene, g_cAutomatic, profile);
      EXPECT_EQ(path, Run(scene, {{e}, {}}, profile));
      EXPECT_EQ(path, Run(scene, {{}, {e}}, profile));
      // The control: where it is called for, without it all is different.
      if (e == eEffect::Sensors) continue;
      EXPECT_NE(Run({}, g_cAutomatic, profile), Run({}, {{}, {e}}, profile));
    }
}

TEST_P(CEffectBits, BallsAreSweptByDefaultHoweverSlowTheyAre) {
  CScene slow;
  slow.m_bGravity = slow.m_bTurns = slow.m_bFast = false;
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned}) {
    const auto path = Run(slow, g_cAutomatic, profile);
    EXPECT_EQ(path, Run(slow, g_cContinuous, profile));
    // The control; Box2D as it ships solves contacts of slow balls in the same way with and without it.
    if (!IsBox2D()) {
      EXPECT_NE(path, Run(slow, g_cApproximate, profile));
    }
  }
}

TEST_P(CEffectBits, WhoWatchesChangesNothing) {
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned})
    for (const float e : {1.0f, 0.9f, 1.02f}) {
      CScene scene, blind;
      scene.m_fElasticity = blind.m_fElasticity = e;
      blind.m_bSensor = false;
      const auto path = Run(scene, g_cAutomatic, profile);
      EXPECT_EQ(path, Run(scene, {{}, {eEffect::Events}}, profile));
      EXPECT_EQ(path, Run(scene, {{}, {eEffect::Sensors}}, profile));
      EXPECT_EQ(path, Run(scene, {{}, {eEffect::Events, eEffect::Sensors}}, profile));
      EXPECT_EQ(path, Run(blind, {{}, {eEffect::Events}}, profile));
    }
}

TEST_P(CEffectBits, WhoBeginsToWatchChangesNothing) {
  // Elasticities change while balls touch, and somebody looks on now and then.
  std::vector<Vector2> paths[2];
  for (const bool watched : {true, false}) {
    CScene scene;
    scene.m_bSensor = scene.m_bTurns = false;
    scene.m_fElasticity = 1;
    auto pWorld =
        MakeWorldOf(Backend(), scene, watched ? g_cAutomatic : CEffectChoice{{}, {eEffect::Events}});
    Tests::CRandom random(g_nEffectBitsContractSeed);
    const float elasticities[] = {0.0f, 0.5f, 1.0f};
    for (int k = 0; k < 60; ++k) {
      const float e = elasticities[random.Below(3)];
      for (const CShapeId id : pWorld->GetBallIds())
        pWorld->SetElasticity(id, k % 3 == 0 ? e : 1);
      pWorld->SetElasticity(CShapeId{1}, k % 4 == 0 ? e : 1);
      if (k == 20) pWorld->SetSensor(CShapeId{5}, true);
      if (k == 40) pWorld->SetSensor(CShapeId{5}, false);
      const auto part = Path(*pWorld, 10);
      paths[watched].insert(paths[watched].end(), part.begin(), part.end());
    }
    EXPECT_EQ(pWorld->GetStats().m_nReported > 0, watched);
  }
  EXPECT_EQ(paths[0], paths[1]);
}

TEST_P(CEffectBits, AStateGoesFromOneChoiceToAnother) {
  const CEffectChoice held{{}, {eEffect::Kinematics, eEffect::BallPairs, eEffect::Gravity}};
  auto pFrom = MakeWorldOf(Backend(), {}, g_cAutomatic), pHeld = MakeWorldOf(Backend(), {}, held);
  Path(*pFrom, 50);
  const CShapeId blade{7};
  const CSavedState saved = pFrom->SaveState();
  const float angle = pFrom->GetOrientation(blade);
  pHeld->LoadState(saved);
  Path(*pHeld, 50);
  EXPECT_EQ(pHeld->GetRotSpeed(blade), 0.6f);
  EXPECT_EQ(pHeld->GetOrientation(blade), angle);
  EXPECT_EQ(pHeld->GetStats().m_nShapesTurned + pHeld->GetStats().m_nBallsAccelerated, 0u);
  const CEffects running = pHeld->GetEffects();
  EXPECT_TRUE((running & held.m_cForbidden).IsEmpty());

  // A shape that was held there turns again where nothing is forbidden: only the choice of a world says so.
  const CSavedState heldState = pHeld->SaveState();
  pFrom->LoadState(heldState);
  EXPECT_TRUE(pFrom->GetEffects().Has(eEffect::Kinematics));
  Path(*pFrom, 50);
  EXPECT_NE(pFrom->GetOrientation(blade), angle);

  // And whoever goes on from the same state by the same choice has the same bits, watched or not.
  auto pUnwatched = MakeWorldOf(Backend(), {}, {{}, {eEffect::Events}});
  pFrom->LoadState(saved);
  pUnwatched->LoadState(saved);
  EXPECT_EQ(Path(*pFrom), Path(*pUnwatched));
}

} // namespace
} // namespace Shapes
