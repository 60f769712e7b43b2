// SPDX-License-Identifier: MIT
// A world on an engine that writes down its calls and does as the test says: they come in the order that
// src/world/Engine.h promises, and sensors see paths with vertices within a substep.
#include "world/WorldCore.h"

#include "../Testing.h"

namespace Shapes {
namespace {

using CEngineCalls = std::vector<std::string>;

class CToldEngine final : public CEngine {
public:
  void Access(eAccess access) override {
    static constexpr const char* names[] = {"read", "change", "gravity", "step", "save"};
    m_stdCalls.emplace_back(names[static_cast<int>(access)]);
    if (m_bRefuses) throw std::logic_error("refused");
  }
  void Added(CShapeId id) override { Record("Added", id); }
  void Removed(CShapeId id, std::unique_ptr<CShape>) override { Record("Removed", id); }
  void Changed(CShapeId id, eChange change) override {
    static constexpr const char* names[] = {"pose",   "rotation centre", "reset",       "motion",
                                            "sensor", "filter",          "can-collide", "properties"};
    Record(std::string("Changed ") + names[static_cast<int>(change)], id);
  }
  void Plan(CEffects running) override {
    m_cPlanned = running;
    m_stdCalls.emplace_back("Plan");
  }
  void Substep(float dt) override {
    m_fSubstep = dt;
    m_stdCalls.emplace_back("Substep");
    m_stdSubstep();
  }
  std::shared_ptr<const CEngineMemory> Save() override {
    m_stdCalls.emplace_back("Save");
    return m_pMemory;
  }
  void Loaded(const CEngineMemory* pMemory) override {
    m_stdCalls.emplace_back(pMemory == m_pMemory.get() ? "Loaded" : "Loaded without memory");
  }

  std::function<void()> m_stdSubstep = [] {}; // what it does in one
  CEngineCalls m_stdCalls;
  std::shared_ptr<const CEngineMemory> m_pMemory = std::make_shared<CEngineMemory>();
  bool m_bRefuses = false;
  CEffects m_cPlanned;
  float m_fSubstep = 0;

private:
  void Record(const std::string& what, CShapeId id) {
    m_stdCalls.push_back(what + " " + std::to_string(id.m_nValue));
  }
};

/// A world on it.
class CToldWorld {
public:
  explicit CToldWorld(unsigned substeps = 1)
      : m_cWorld(std::make_unique<CWorldCore>(Described({0, 0}, 0.25f, substeps), CWorldLimits(), CEffects(),
                                              [this](CWorldCore& core) { return MakeEngine(core); })) {}

  CWorld* operator->() { return &m_cWorld; }
  CToldEngine& Engine() { return *m_pEngine; }
  /// The calls since the last time.
  CEngineCalls Calls() { return std::exchange(m_pEngine->m_stdCalls, {}); }
  void SetSubstep(std::function<void()> f) { m_pEngine->m_stdSubstep = std::move(f); }
  void AddPathVertex(std::size_t ball, const Vector2& p, float t) { m_pCore->AddPathVertex(ball, p, t); }

  /// Ball i goes over these places to its next position, at these shares of the substep.
  void Go(std::size_t i, const std::vector<std::pair<float, Vector2>>& vertices, const Vector2& to) {
    CBallArrays& b = m_pCore->GetState().m_cBalls;
    b.m_stdPrevPos[i] = b.m_stdPos[i];
    for (const auto& [t, p] : vertices)
      AddPathVertex(i, p, t);
    b.m_stdPos[i] = to;
  }

  std::vector<CSensorEvent> StepAndReport() {
    m_cWorld.Step();
    return {m_cWorld.GetSensorEvents().begin(), m_cWorld.GetSensorEvents().end()};
  }

private:
  std::unique_ptr<CEngine> MakeEngine(CWorldCore& core) {
    auto pEngine = std::make_unique<CToldEngine>();
    m_pCore = &core;
    m_pEngine = pEngine.get();
    return pEngine;
  }

  CWorldCore* m_pCore = nullptr;
  CToldEngine* m_pEngine = nullptr;
  CWorld m_cWorld; // which makes the engine
};

TEST(EngineOrder, EachChangeIsReportedOnceAfterTheAccess) {
  CToldWorld world(2);
  const CShapeId ball{2};
  const std::pair<const char*, std::function<void()>> changes[] = {
      {"Added 1", [&] { world->Add(CPointDesc(Vector2(0, 1))); }},
      {"Added 2", [&] { world->Add(CDynamicCircleDesc(Vector2(0, 0), 1)); }},
      {"Changed pose 2", [&] { world->SetPos(ball, Vector2(3, 4)); }},
      {"Changed motion 2", [&] { world->SetVel(ball, Vector2(1, 0)); }},
      {"Changed properties 2", [&] { world->SetElasticity(ball, 0.5f); }},
      {"Changed sensor 2", [&] { world->SetSensor(ball, true); }},
      {"Removed 2", [&] { world->Remove(ball); }}};
  for (const auto& [pReported, change] : changes) {
    change();
    EXPECT_EQ(world.Calls(), (CEngineCalls{"change", pReported}));
  }
  EXPECT_THROW(world->SetVel(ball, {1, 0}), std::invalid_argument);
  EXPECT_EQ(world.Calls(), (CEngineCalls{"change"}));
}

TEST(EngineOrder, PlansBeforeTheFirstSubstepAndOnlyWhereEffectsChange) {
  CToldWorld world(2);
  const auto callsOfAStep = [&] {
    world.Calls();
    world->Step();
    return world.Calls();
  };
  const CEngineCalls planned{"step", "Plan", "Substep", "Substep"}, asBefore{"step", "Substep", "Substep"};
  world->SetGravity({0, -8});
  const CShapeId ball = world->Add(CDynamicCircleDesc({0, 0}, 1));
  EXPECT_EQ(callsOfAStep(), planned);
  EXPECT_EQ(world.Engine().m_cPlanned, (CEffects{eEffect::Gravity, eEffect::Continuous}));
  EXPECT_EQ(world.Engine().m_fSubstep, 0.125f);
  world->SetVel(ball, {1, 0});
  world->SetPos(ball, {1, 0});
  world->SetElasticity(ball, 0.5f);
  world->SetUserPtr(ball, &world);
  EXPECT_EQ(callsOfAStep(), asBefore);
  world->Add(CPointDesc({0, 9}));
  EXPECT_EQ(callsOfAStep(), planned); // Events
  world->Add(CPointDesc({0, 19}));
  EXPECT_EQ(callsOfAStep(), asBefore);
}

TEST(EngineOrder, StatesAreSavedAndLoadedAfterTheAccess) {
  CToldWorld world(2);
  world->Add(CDynamicCircleDesc({0, 0}, 1));
  world.Calls();
  const CSavedState state = world->SaveState();
  EXPECT_EQ(world.Calls(), (CEngineCalls{"save", "Save"}));
  world->LoadState(state);
  EXPECT_EQ(world.Calls(), (CEngineCalls{"save", "Loaded"}));
}

TEST(EngineOrder, WhatTheEngineRefusesChangesNothing) {
  CToldWorld world(2);
  const CShapeId ball = world->Add(CDynamicCircleDesc({0, 0}, 1));
  world.Engine().m_bRefuses = true;
  world.Calls();
  EXPECT_THROW(world->SetPos(ball, {3, 4}), std::logic_error);
  EXPECT_THROW(world->Add(CPointDesc({0, 1})), std::logic_error);
  EXPECT_THROW(world->Step(), std::logic_error);
  EXPECT_EQ(world.Calls(), (CEngineCalls{"change", "change", "step"}));
  world.Engine().m_bRefuses = false;
  EXPECT_EQ(world->GetPos(ball), Vector2(0, 0));
  EXPECT_TRUE(world->GetShapeIds().empty());
}

TEST(SensorsTest, ABallThatTouchesOnlyAtAVertexOfItsPathIsDetected) {
  for (const bool vertices : {true, false}) { // without it: the control
    CToldWorld world;
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
    CToldWorld world;
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
  CToldWorld world;
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
  CToldWorld world(3);
  const CShapeId zone = world->Add(Sensor(CCircleDesc({0, 0}, 1)));
  const CShapeId ball = world->Add(CDynamicCircleDesc({-4, 0}, 0.25f));
  float x = -4;
  world.SetSubstep([&] { world.Go(0, {}, {x += 4, 0}); });
  EXPECT_EQ(world.StepAndReport(), (std::vector<CSensorEvent>{{zone, ball, true}, {zone, ball, false}}));
  // In the first two it was there: into it, and out of it.
  ASSERT_EQ(world->GetContacts().size(), 2u);
  EXPECT_EQ(world->GetContacts()[0].m_vPOI, Vector2(-1, 0)); // at rest in the middle: where it came from
}

} // namespace
} // namespace Shapes
