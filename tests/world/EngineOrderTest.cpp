// SPDX-License-Identifier: MIT
// The order in which a world calls its engine, as src/world/Engine.h promises it.
#include "world/WorldCore.h"

#include <Shapes/Shapes.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace Shapes {
namespace {

/// Records its calls.
class CRecordingEngine final : public CEngine {
public:
  explicit CRecordingEngine(std::vector<std::string>& calls) : m_stdCalls(calls) {}

  void Access(eAccess access) override {
    static constexpr const char* names[] = {"read", "change", "gravity", "step", "save"};
    m_stdCalls.emplace_back(names[static_cast<int>(access)]);
    if (m_bRefuses) throw std::logic_error("refused");
  }
  void Added(CShapeId id) override { Record("Added", id); }
  void Removed(CShapeId id) override { Record("Removed", id); }
  void Changed(CShapeId id, eChange change) override {
    static constexpr const char* names[] = {"pose", "motion", "sensor", "filter", "properties"};
    Record(std::string("Changed ") + names[static_cast<int>(change)], id);
  }
  void Plan(CEffects running) override {
    m_cPlanned = running;
    m_stdCalls.emplace_back("Plan");
  }
  void Substep(float dt) override {
    m_fSubstep = dt;
    m_stdCalls.emplace_back("Substep");
  }
  void Saved() override { m_stdCalls.emplace_back("Saved"); }
  void Loaded() override { m_stdCalls.emplace_back("Loaded"); }

  bool m_bRefuses = false;
  CEffects m_cPlanned;
  float m_fSubstep = 0;

private:
  void Record(const std::string& what, CShapeId id) {
    m_stdCalls.push_back(what + " " + std::to_string(id.m_nValue));
  }
  std::vector<std::string>& m_stdCalls;
};

using CCalls = std::vector<std::string>;

class EngineOrder : public testing::Test {
protected:
  EngineOrder() {
    CWorldDesc desc;
    desc.m_fTimeStep = 0.5f;
    desc.m_nSubsteps = 2;
    desc.m_vGravity = {0, -8};
    m_pWorld = std::make_unique<CWorld>(
        std::make_unique<CWorldCore>(desc, CWorldLimits(), CEffects(), [this](CWorldCore&) {
          auto pEngine = std::make_unique<CRecordingEngine>(m_stdCalls);
          m_pEngine = pEngine.get();
          return pEngine;
        }));
  }
  /// The calls since the last time.
  CCalls Calls() { return std::exchange(m_stdCalls, {}); }

  std::vector<std::string> m_stdCalls;
  CRecordingEngine* m_pEngine = nullptr;
  std::unique_ptr<CWorld> m_pWorld;
};

TEST_F(EngineOrder, EachChangeIsReportedOnceAfterTheAccess) {
  m_pWorld->Add(CPointDesc({0, 1}));
  EXPECT_EQ(Calls(), (CCalls{"change", "Added 1"}));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0, 0}, 1));
  EXPECT_EQ(Calls(), (CCalls{"change", "Added 2"}));
  m_pWorld->SetPos(ball, {3, 4});
  EXPECT_EQ(Calls(), (CCalls{"change", "Changed pose 2"}));
  m_pWorld->SetVel(ball, {1, 0});
  EXPECT_EQ(Calls(), (CCalls{"change", "Changed motion 2"}));
  m_pWorld->SetElasticity(ball, 0.5f);
  EXPECT_EQ(Calls(), (CCalls{"change", "Changed properties 2"}));
  m_pWorld->SetSensor(ball, true);
  EXPECT_EQ(Calls(), (CCalls{"change", "Changed sensor 2"}));
  m_pWorld->Remove(ball);
  EXPECT_EQ(Calls(), (CCalls{"change", "Removed 2"}));
  EXPECT_THROW(m_pWorld->SetVel(ball, {1, 0}), std::invalid_argument);
  EXPECT_EQ(Calls(), (CCalls{"change"}));
}

TEST_F(EngineOrder, PlansBeforeTheFirstSubstepAndOnlyWhereEffectsChange) {
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0, 0}, 1));
  Calls();
  m_pWorld->Step();
  EXPECT_EQ(Calls(), (CCalls{"step", "Plan", "Substep", "Substep"}));
  EXPECT_EQ(m_pEngine->m_cPlanned, CEffects{eEffect::Gravity});
  EXPECT_EQ(m_pEngine->m_fSubstep, 0.25f);
  m_pWorld->SetVel(ball, {1, 0});
  m_pWorld->SetPos(ball, {1, 0});
  m_pWorld->SetElasticity(ball, 0.5f);
  m_pWorld->SetUserPtr(ball, this);
  Calls();
  m_pWorld->Step();
  EXPECT_EQ(Calls(), (CCalls{"step", "Substep", "Substep"}));
  m_pWorld->Add(CPointDesc({0, 9}));
  Calls();
  m_pWorld->Step();
  EXPECT_EQ(Calls(), (CCalls{"step", "Plan", "Substep", "Substep"})); // Events
  m_pWorld->Add(CPointDesc({0, 19}));
  Calls();
  m_pWorld->Step();
  EXPECT_EQ(Calls(), (CCalls{"step", "Substep", "Substep"})); // as before
}

TEST_F(EngineOrder, StatesAreSavedAndLoadedAfterTheAccess) {
  m_pWorld->Add(CDynamicCircleDesc({0, 0}, 1));
  Calls();
  const CSavedState state = m_pWorld->SaveState();
  EXPECT_EQ(Calls(), (CCalls{"save", "Saved"}));
  m_pWorld->LoadState(state);
  EXPECT_EQ(Calls(), (CCalls{"save", "Loaded"}));
}

TEST_F(EngineOrder, WhatTheEngineRefusesChangesNothing) {
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0, 0}, 1));
  m_pEngine->m_bRefuses = true;
  Calls();
  EXPECT_THROW(m_pWorld->SetPos(ball, {3, 4}), std::logic_error);
  EXPECT_THROW(m_pWorld->Add(CPointDesc({0, 1})), std::logic_error);
  EXPECT_THROW(m_pWorld->Step(), std::logic_error);
  EXPECT_EQ(Calls(), (CCalls{"change", "change", "step"}));
  m_pEngine->m_bRefuses = false;
  EXPECT_EQ(m_pWorld->GetPos(ball), Vector2(0, 0));
  EXPECT_TRUE(m_pWorld->GetShapeIds().empty());
}

} // namespace
} // namespace Shapes
