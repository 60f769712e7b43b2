// SPDX-License-Identifier: MIT
// Filters, and other switches: what meets what, as solid ones and as sensors; the same on every engine, in
// every mode.
#include "Backends.h"

namespace Shapes {
namespace {

constexpr CFilter g_cRed{1, 2}, g_cBlue{2, 1}, g_cDeaf{2, 0}, g_cAll{};
// Pairs, and whether they meet.
const struct {
  CFilter m_cFirst, m_cSecond;
  bool m_bMeet;
} g_stdPairs[] = {{g_cRed, g_cBlue, true},
                  {g_cRed, g_cRed, false},
                  {g_cBlue, g_cDeaf, false},
                  {g_cRed, g_cDeaf, false},
                  {g_cAll, g_cAll, true},
                  {g_cAll, g_cBlue, true},
                  {{0x8000, 0x8000}, g_cAll, false},
                  {{0x8000, 0x8000}, {0x8000, 0x8000}, true}};

const CEffectChoice g_stdChoices[] = {g_cAutomatic, g_cApproximate, g_cContinuous};

class CFilterContract : public CEveryBackend {
protected:
  template <class F>
  void InEveryMode(const F& f) {
    for (const auto& pair : g_stdPairs)
      for (const CEffectChoice& choice : g_stdChoices)
        for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned})
          for (const bool swap : {false, true}) {
            SCOPED_TRACE(testing::Message() << &pair - g_stdPairs << ' ' << &choice - g_stdChoices);
            f(swap ? pair.m_cSecond : pair.m_cFirst, swap ? pair.m_cFirst : pair.m_cSecond, pair.m_bMeet,
              choice, profile);
          }
  }
};
SHAPES_ON_EVERY_BACKEND(CFilterContract);

TEST_P(CFilterContract, ABallMeetsShapesAndBallsByIt) {
  InEveryMode([&](CFilter first, CFilter second, bool meet, const CEffectChoice& choice, eProfile profile) {
    for (const bool isWall : {true, false}) {
      const auto pWorld = Make(choice, profile);
      const CShapeId ball = pWorld->Add(Filtered(CDynamicCircleDesc({0, 0}, 0.1f, {2, 0}), first));
      if (isWall)
        pWorld->Add(Filtered(CLineSegDesc({1, -1}, {1, 1}), second));
      else
        pWorld->Add(Filtered(CDynamicCircleDesc({1, 0}, 0.1f), second));
      Steps(*pWorld, 60);
      EXPECT_EQ(pWorld->GetVel(ball).x() < 1, meet);
      EXPECT_EQ(pWorld->GetFilter(ball), first);
    }
  });
}

TEST_P(CFilterContract, SensorsDetectByIt) {
  InEveryMode([&](CFilter first, CFilter second, bool meet, const CEffectChoice& choice, eProfile profile) {
    for (const bool ballIsSensor : {false, true}) {
      const auto pWorld = Make(choice, profile);
      const CCircleDesc zone = Filtered(CCircleDesc({1, 0}, 0.3f), first);
      const CDynamicCircleDesc ball = Filtered(CDynamicCircleDesc({0, 0}, 0.1f, {2, 0}), second);
      pWorld->Add(ballIsSensor ? zone : Sensor(zone));
      pWorld->Add(ballIsSensor ? Sensor(ball) : ball);
      EXPECT_EQ(Told(*pWorld, 60, &CWorld::GetSensorEvents).size(), meet ? 2u : 0u);
    }
  });
}

enum class eSwitch { Filter, CanCollide, Sensor };

// Lets a ball or a floor meet nothing, or the other one again.
void SetMeets(CWorld& world, CShapeId id, eSwitch by, bool meets) {
  switch (by) {
  case eSwitch::Filter: return world.SetFilter(id, meets ? g_cAll : CFilter{4, 4});
  case eSwitch::CanCollide: return world.SetCanCollide(id, meets);
  case eSwitch::Sensor: return world.SetSensor(id, !meets);
  }
}
bool GetMeets(const CWorld& world, CShapeId id) {
  return world.GetFilter(id) == g_cAll && world.GetCanCollide(id) && !world.GetSensor(id);
}

// A ball that lies on a floor falls through it from the moment on when it does not meet it any more.
TEST_P(CFilterContract, AChangeTakesEffectInTheNextStep) {
  for (const eSwitch by : {eSwitch::Filter, eSwitch::CanCollide, eSwitch::Sensor})
    for (const CEffectChoice& choice : g_stdChoices)
      for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned})
        for (const bool ofBall : {false, true}) {
          SCOPED_TRACE(static_cast<int>(by));
          const auto pWorld = Make(choice, profile, {0, -10});
          const CShapeId floor = pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
          const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.1f}, 0.1f, {0, 0}, 1, 0));
          const CShapeId changed = ofBall ? ball : floor;
          Steps(*pWorld, 60);
          EXPECT_GT(pWorld->GetPos(ball).y(), 0.05f);
          SetMeets(*pWorld, changed, by, false);
          const CSavedState saved = pWorld->SaveState();
          Steps(*pWorld, 30);
          EXPECT_LT(pWorld->GetPos(ball).y(), -0.5f);
          pWorld->LoadState(saved);
          EXPECT_FALSE(GetMeets(*pWorld, changed));
          SetMeets(*pWorld, changed, by, true);
          EXPECT_TRUE(GetMeets(*pWorld, changed));
          Steps(*pWorld, 30);
          EXPECT_GT(pWorld->GetPos(ball).y(), 0.05f);
        }
}

// In a pile of two kinds that do not meet, each kind lies as if the other one were not there.
TEST_P(CFilterContract, BallsOfTwoKindsLieInOnePlace) {
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned}) {
    const auto pWorld = Make(g_cAutomatic, profile, {0, -10});
    pWorld->Add(CLineSegDesc({-0.11f, 0}, {0.11f, 0}));
    for (const float x : {-0.11f, 0.11f})
      pWorld->Add(CLineSegDesc({x, 0}, {x, 3}));
    std::vector<CShapeId> ids;
    for (int i = 0; i < 4; ++i) {
      const CDynamicCircleDesc desc({0, 0.15f + 0.25f * static_cast<float>(i / 2)}, 0.1f, {0, 0}, 1, 0);
      ids.push_back(pWorld->Add(Filtered(desc, i % 2 == 0 ? CFilter{1, 1 | 4} : CFilter{2, 2 | 4})));
    }
    for (const CShapeId id : pWorld->GetShapeIds())
      pWorld->SetFilter(id, {4, 0xFFFF});
    Steps(*pWorld, 240);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(pWorld->GetPos(ids[static_cast<std::size_t>(i)]).y(), i < 2 ? 0.1f : 0.3f, 0.02f);
  }
}

TEST_P(CFilterContract, ShapesWithoutAWorldMeetByIt) {
  for (const auto& pair : g_stdPairs) {
    CLineSeg wall(CLineSegDesc({0, -1}, {0, 1}));
    CDynamicCircle ball(CDynamicCircleDesc({-0.05f, 0}, 0.1f, {1, 0}));
    wall.SetFilter(pair.m_cFirst);
    ball.SetFilter(pair.m_cSecond);
    CContactDesc c(&wall, &ball);
    EXPECT_EQ(Backend().CollisionDetected(c), pair.m_bMeet);
  }
}

} // namespace
} // namespace Shapes
