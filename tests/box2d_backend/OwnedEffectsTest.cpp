// SPDX-License-Identifier: MIT
// What runs of Box2D in a world of its own.
#include "../Descs.h"
#include "../Numbers.h"
#include "../Steps.h"

#include <Shapes/Shapes.h>

#include <gtest/gtest.h>

#include <memory>

#include "box2d_backend/world/OwnedEngine.h"

namespace Shapes {
namespace {

std::unique_ptr<CWorld> Make(eProfile profile, const CEffectChoice& choice = g_cAutomatic) {
  CWorldDesc desc;
  desc.m_fTimeStep = g_fDt;
  desc.m_cBox2D.m_eProfile = profile;
  desc.m_cEffects = choice;
  return GetBackend(eBackend::Box2D)->MakeWorld(desc);
}

/// Whether a ball that is thrown at a wall gets through it, and the steps in which Continuous ran.
struct CThrow {
  bool m_bIsThrough;
  std::uint64_t m_nContinuous;
};
CThrow Throw(eProfile profile, const CEffectChoice& choice, float speed, float kick = 0) {
  auto pWorld = Make(profile, choice);
  pWorld->Add(CLineSegDesc({0, -1}, {0, 1}));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-1, 0}, 0.1f, {speed, 0}));
  pWorld->SetGravity({kick, 0});
  const int n = kick > 0 ? 1 : speed > 50 ? 2 : 30; // without a wall it would be well behind it then
  Steps(*pWorld, n);
  return {pWorld->GetPos(ball).x() > 0, pWorld->GetStats().GetSubstepsWith(eEffect::Continuous)};
}

TEST(OwnedEffectsTest, AFastBallGetsThroughNoWallUnlessContinuousIsForbidden) {
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned}) {
    SCOPED_TRACE(profile == eProfile::Tuned ? "tuned" : "shipped");
    EXPECT_FALSE(Throw(profile, g_cAutomatic, 70).m_bIsThrough);
    EXPECT_EQ(Throw(profile, g_cAutomatic, 70).m_nContinuous, 2u);
    EXPECT_TRUE(Throw(profile, g_cApproximate, 70).m_bIsThrough);
    EXPECT_EQ(Throw(profile, g_cApproximate, 70).m_nContinuous, 0u);
    EXPECT_FALSE(Throw(profile, g_cContinuous, 70).m_bIsThrough);
    EXPECT_FALSE(Throw(profile, g_cAutomatic, 2.999f).m_bIsThrough); // slow ones are swept, too
    EXPECT_EQ(Throw(profile, g_cAutomatic, 2.999f).m_nContinuous, 30u);
    EXPECT_EQ(Throw(profile, g_cApproximate, 2.999f).m_nContinuous, 0u);
  }
}

TEST(OwnedEffectsTest, WhatGravityAddsInASubstepIsSwept) {
  // Box2D moves the ball by its speed after the kick: 6,000 / 60 = 100, which is 1.67 in the first step.
  const CThrow thrown = Throw(eProfile::Shipped, g_cAutomatic, 0, 6000);
  EXPECT_EQ(thrown.m_nContinuous, 1u);
  EXPECT_FALSE(thrown.m_bIsThrough);
  EXPECT_TRUE(Throw(eProfile::Shipped, g_cApproximate, 0, 6000).m_bIsThrough);
}

TEST(OwnedEffectsTest, WhatStandsStillIsMetLikeAStaticShape) {
  // Also where it did not always do so.
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned}) {
    std::vector<Vector2> paths[3];
    for (const int k : {0, 1, 2}) {
      auto pWorld = Make(profile);
      pWorld->SetGravity({0, -10});
      CArcDesc desc({0, -1}, 1, 0, g_fPi);
      desc.m_eMotionType = k == 0 ? eMotion::Static : eMotion::Kinematic;
      desc.m_vRotCenter = {0, -1};
      const CShapeId arc = pWorld->Add(desc);
      if (k == 2) {
        pWorld->SetRotSpeed(arc, 1);
        pWorld->Step();
        pWorld->SetRotSpeed(arc, 0);
        pWorld->Step();
        pWorld->Reset(arc);
      }
      const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.2f, 0.4f}, 0.1f, {0, 0}, 1, 0.9f));
      for (int i = 0; i < 100; ++i) {
        pWorld->Step();
        paths[k].push_back(pWorld->GetPos(ball));
      }
    }
    EXPECT_EQ(paths[0], paths[1]);
    EXPECT_EQ(paths[0], paths[2]);
    EXPECT_GT(paths[0].back().x(), 0.5f); // it has been met
  }
}

TEST(OwnedEffectsTest, ContactsCountWhereSomebodyHearsOfThem) {
  for (const bool sensor : {true, false}) {
    auto pWorld = Make(eProfile::Shipped, {{}, {eEffect::Events}});
    pWorld->Add(CLineSegDesc({0, -1}, {0, 1}));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-0.5f, 0}, 0.1f, {2, 0}));
    CCircleDesc zone({5, 5}, 0.1f);
    zone.m_bIsSensor = sensor;
    pWorld->Add(zone);
    Steps(*pWorld, 20);
    EXPECT_LT(pWorld->GetVel(ball).x(), 0);
    EXPECT_EQ(pWorld->GetStats().m_nContacts > 0, sensor);
  }
}

TEST(OwnedEffectsTest, SensorsSeeTheWayBackWithoutEvents) {
  // To the wall and back within a substep: seen only if the world knows where the ball turned.
  for (const bool wall : {true, false}) {
    auto pWorld = Make(eProfile::Shipped, {{}, {eEffect::Events}});
    CLineSegDesc desc({0, -1}, {0, 1});
    desc.m_bIsSensor = !wall;
    pWorld->Add(desc);
    const CShapeId id = pWorld->Add(Sensor(CLineSegDesc({-0.3f, -1}, {-0.3f, 1})));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-0.6f, 0}, 0.1f, {60, 0}));
    pWorld->Step();
    EXPECT_EQ(pWorld->GetPos(ball).x() < -0.4f, wall); // 1 a step: .5 to the wall, .5 back
    std::size_t seen = 0;
    for (const CSensorEvent& event : pWorld->GetSensorEvents())
      seen += event.m_cShape == id;
    EXPECT_EQ(seen, 2u);
    pWorld->Step();
  }
}

} // namespace
} // namespace Shapes
