// SPDX-License-Identifier: MIT
// Sensors on an engine that does as the test says: paths with vertices within a substep.
#include "../Descs.h"

#include "world/WorldCore.h"

#include <Shapes/Shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace Shapes {
namespace {

/// Moves its balls as it is told.
class CScriptedEngine final : public CEngine {
public:
  std::function<void()> m_stdSubstep = [] {};

  void Added(CShapeId) override {}
  void Removed(CShapeId) override {}
  void Changed(CShapeId, eChange) override {}
  void Plan(CEffects) override {}
  void Substep(float) override { m_stdSubstep(); }
  void Loaded() override {}
};

/// A world on it.
class CScriptedWorld {
public:
  explicit CScriptedWorld(unsigned substeps = 1) : CScriptedWorld(MakeCore(substeps)) {}

  CWorld* operator->() { return &m_cWorld; }
  void SetSubstep(std::function<void()> f) { m_pEngine->m_stdSubstep = std::move(f); }
  void AddPathVertex(std::size_t ball, const Vector2& p, float t) { m_cCore.AddPathVertex(ball, p, t); }

  /// Ball i goes over these places to its next position, at these shares of the substep.
  void Go(std::size_t i, const std::vector<std::pair<float, Vector2>>& vertices, const Vector2& to) {
    CBallArrays& b = m_cCore.GetState().m_cBalls;
    b.m_stdPrevPos[i] = b.m_stdPos[i];
    for (const auto& [t, p] : vertices)
      AddPathVertex(i, p, t);
    b.m_stdPos[i] = to;
  }

  /// The shapes turn by what they turn in this time.
  void Turn(float dt) {
    for (CShapeEntry& entry : m_cCore.GetState().m_stdShapes)
      entry.m_pShape->Advance(dt);
  }

  std::vector<CSensorEvent> StepAndReport() {
    m_cWorld.Step();
    return {m_cWorld.GetSensorEvents().begin(), m_cWorld.GetSensorEvents().end()};
  }

private:
  struct CMade {
    std::unique_ptr<CWorldCore> m_pCore;
    CScriptedEngine* m_pEngine = nullptr;
  };
  static CMade MakeCore(unsigned substeps) {
    CWorldDesc desc;
    desc.m_fTimeStep = 0.25f;
    desc.m_nSubsteps = substeps;
    CMade made;
    made.m_pCore = std::make_unique<CWorldCore>(desc, CWorldLimits(), CEffects(), [&](CWorldCore&) {
      auto pEngine = std::make_unique<CScriptedEngine>();
      made.m_pEngine = pEngine.get();
      return pEngine;
    });
    return made;
  }
  explicit CScriptedWorld(CMade made)
      : m_cCore(*made.m_pCore), m_pEngine(made.m_pEngine), m_cWorld(std::move(made.m_pCore)) {}

  CWorldCore& m_cCore;
  CScriptedEngine* m_pEngine;
  CWorld m_cWorld;
};

TEST(SensorsTest, ABallThatTouchesOnlyAtAVertexOfItsPathIsDetected) {
  for (const bool vertices : {true, false}) { // without it: the control
    CScriptedWorld world;
    const CShapeId post = world->Add(Sensor(CPointDesc(Vector2(0, 1))));
    const CShapeId ball = world->Add(CDynamicCircleDesc({-1, 0}, 0.25f));
    world.SetSubstep([&] {
      if (vertices)
        world.Go(0, {{0.5f, {0, 0.875f}}}, {1, 0});
      else
        world.Go(0, {}, {1, 0});
    });
    const auto events = world.StepAndReport();
    if (!vertices) {
      EXPECT_TRUE(events.empty());
      continue;
    }
    EXPECT_EQ(events, (std::vector<CSensorEvent>{{post, ball, true}, {post, ball, false}}));
    ASSERT_EQ(world->GetContacts().size(), 1u);
    const CContactEvent& contact = world->GetContacts()[0];
    EXPECT_TRUE(contact.m_bIsSensor);
    EXPECT_EQ(contact.m_vPOI, Vector2(0, 1));
    EXPECT_EQ(contact.m_vNorm, Vector2(0, -1));
    EXPECT_FLOAT_EQ(contact.m_fSpeed, 0.875f / 0.125f); // on its way up
    EXPECT_EQ(contact.m_fSetback, 0);
    EXPECT_EQ(world->GetStats().m_nSensorHits, 1u);
    // The vertex was for that substep.
    world.SetSubstep([&] { world.Go(0, {}, {-1, 0}); });
    EXPECT_TRUE(world.StepAndReport().empty());
  }
}

TEST(SensorsTest, TwoBallsTouchIfTheyAreThereAtTheSameTime) {
  for (const float when : {0.25f, 0.75f}) {
    CScriptedWorld world;
    world->Add(CDynamicCircleDesc({-4, 0}, 0.25f));
    world->Add(Sensor(CDynamicCircleDesc({0, -4}, 0.25f)));
    world.SetSubstep([&] {
      world.Go(0, {{0.25f, {0, 0}}}, {4, 0}); // at the crossing after a quarter of the time
      world.Go(1, {{when, {0, 0}}}, {0, 4});  // this one then too, or later
    });
    EXPECT_EQ(world.StepAndReport().size(), when == 0.25f ? 2u : 0u);
  }
}

TEST(SensorsTest, VerticesOfSeveralBallsMayBeReportedInAnyOrder) {
  CScriptedWorld world;
  world->Add(Sensor(CPointDesc(Vector2(0, 1))));
  for (int i = 0; i < 3; ++i)
    world->Add(CDynamicCircleDesc({-1, 0}, 0.25f));
  world.SetSubstep([&] {
    world.AddPathVertex(2, {0, 1}, 0.5f); // in the order of time of each, not of balls
    world.AddPathVertex(0, {0, -3}, 0.125f);
    world.Go(0, {{0.5f, {0, 1}}}, {1, 0});
    world.Go(1, {}, {1, 0});
    world.Go(2, {}, {1, 0});
  });
  world->Step();
  ASSERT_EQ(world->GetContacts().size(), 2u);
  EXPECT_EQ(world->GetContacts()[0].m_cBall, world->GetBallIds()[0]);
  EXPECT_EQ(world->GetContacts()[1].m_cBall, world->GetBallIds()[2]);
}

TEST(SensorsTest, EachSubstepReportsItsOwn) {
  CScriptedWorld world(3);
  const CShapeId zone = world->Add(Sensor(CCircleDesc({0, 0}, 1)));
  const CShapeId ball = world->Add(CDynamicCircleDesc({-4, 0}, 0.25f));
  float x = -4;
  world.SetSubstep([&] { world.Go(0, {}, {x += 4, 0}); });
  EXPECT_EQ(world.StepAndReport(), (std::vector<CSensorEvent>{{zone, ball, true}, {zone, ball, false}}));
  // In the first two it was there: into it, and out of it.
  ASSERT_EQ(world->GetContacts().size(), 2u);
  EXPECT_EQ(world->GetContacts()[0].m_vPOI, Vector2(-1, 0)); // at rest in the middle: where it came from
}

TEST(SensorsTest, ATurningSensorIsWhereItWasAtThatTime) {
  // A bar on its way from 0 to 90 degrees meets a ball at rest on the diagonal; the normal is back against
  // it.
  CScriptedWorld world;
  // A quarter turn in the step of a quarter second.
  const CShapeId bar = world->Add(Turning(Sensor(CLineSegDesc({0, 0}, {2, 0})), 1));
  const CShapeId ball = world->Add(CDynamicCircleDesc({1, 1}, 0.125f));
  world.SetSubstep([&] {
    world.Go(0, {}, {1, 1});
    world.Turn(0.25f);
  });
  EXPECT_EQ(world.StepAndReport(), (std::vector<CSensorEvent>{{bar, ball, true}, {bar, ball, false}}));
  ASSERT_EQ(world->GetContacts().size(), 1u);
  const CContactEvent& contact = world->GetContacts()[0];
  EXPECT_NEAR((contact.m_vPOI - Vector2(1, 1)).norm(), 0, 1e-2f * 0.125f); // the error that is documented
  EXPECT_NEAR(contact.m_vNorm.dot(Normalize(Vector2(-1, 1))), 1, 1e-3f);
  EXPECT_NEAR(contact.m_fSpeed, g_fTwoPi * std::sqrt(2.0f), 0.01f);
  // Stopped, it is where it is, whatever its last turn was.
  world->SetRotSpeed(bar, 0);
  world.SetSubstep([&] { world.Go(0, {}, {1, 1}); });
  EXPECT_TRUE(world.StepAndReport().empty());
}

} // namespace
} // namespace Shapes
