// SPDX-License-Identifier: MIT
// Sensors see, on every engine alike, each ball that touches them on its way.
#include "Backends.h"

namespace Shapes {
namespace {

constexpr float g_fExactDt = 1.0f / 64.0f; // v dt is exact

class CSensorContract : public CEveryBackend {
protected:
  std::unique_ptr<CWorld> Make() const { return Backend().MakeWorld(Described({0, 0}, g_fExactDt)); }
  std::unique_ptr<CWorld> m_pWorld = Make();
};
SHAPES_ON_EVERY_BACKEND(CSensorContract);

// Whether a sensor that is seen at the end of steps only would see this step's touch: the control.
bool IsTouchedAtTheEnd(const CWorld& world) {
  return !world.GetSensorEvents().empty() && world.GetSensorEvents().back().m_bBegin;
}

TEST_P(CSensorContract, ABallIsSeenAtTenDiametersAStep) {
  // Everything is about .05 large and at the origin, the ball goes 1 unit a step, from each of 1000 phases.
  constexpr float r = 0.05f, v = 20 * r / g_fExactDt;
  constexpr int phases = 1000, steps = 6;
  const std::vector<CAnyShapeDesc> sensors{
      Sensor(CPointDesc(Vector2(0, 0.02f))),
      Sensor(CLineSegDesc({0, -0.1f}, {0.03f, 0.1f})),
      Sensor(CCircleDesc({0, 0.04f}, 0.05f)),
      Sensor(CArcDesc({0, 0}, 0.05f, 1, 3)),
      Sensor(Turning(CLineSegDesc({0, -0.1f}, {0, 0.1f}), 10)),
      Sensor(CDynamicCircleDesc({0, 0.02f}, r)),
  };
  for (std::size_t kind = 0; kind <= sensors.size(); ++kind) {
    SCOPED_TRACE(kind);
    auto pWorld = Make();
    const bool ballIsSensor = kind == sensors.size(); // over a post that is none
    const CShapeId sensor = pWorld->Add(ballIsSensor ? CPointDesc(Vector2(0, 0.02f)) : sensors[kind]);
    const CDynamicCircleDesc desc({50, 50}, r);
    const CShapeId ball = pWorld->Add(ballIsSensor ? Sensor(desc) : desc);
    const bool amongBalls = pWorld->GetMotionType(sensor) == eMotion::Dynamic;
    const CShapeId first = amongBalls ? sensor : ball, second = amongBalls ? ball : sensor;
    int atTheEnd = 0;
    for (int k = 0; k < phases; ++k) {
      pWorld->SetPos(ball, {-3.0f - static_cast<float>(k) / phases, 0});
      pWorld->SetVel(ball, {v, 0});
      std::size_t contacts = 0;
      const auto events = Told(*pWorld, steps, &CWorld::GetSensorEvents, [&] {
        pWorld->Step();
        for (const CContactEvent& contact : pWorld->GetContacts()) {
          ++contacts;
          EXPECT_TRUE(contact.m_bIsSensor);
          EXPECT_LE(contact.m_vPOI.norm(), 0.2f);
          EXPECT_NEAR(contact.m_vNorm.norm(), 1, 1e-5f);
        }
        atTheEnd += IsTouchedAtTheEnd(*pWorld);
      });
      ASSERT_EQ(events, (std::vector<CSensorEvent>{{second, first, true}, {second, first, false}})) << k;
      ASSERT_GE(contacts, 1u);
      ASSERT_EQ(pWorld->GetVel(ball), Vector2(v, 0)); // no response
    }
    EXPECT_LT(atTheEnd, phases / 3);
    EXPECT_GT(atTheEnd, 0);
    EXPECT_EQ(pWorld->GetStats().m_nContacts, 0u);
  }
}

TEST_P(CSensorContract, ABallAtRestIsSeenByASensorThatTurnsOverIt) {
  // A bar of length 1 that turns by 1.4 rad a step; the tip sweeps 14 diameters.
  constexpr int phases = 1000;
  int atTheEnd = 0;
  for (int k = 0; k < phases; ++k) {
    auto pWorld = Make();
    const CShapeId bar =
        pWorld->Add(Sensor(Turning(CLineSegDesc({0, 0}, {1, 0}), 1.4f / g_fTwoPi / g_fExactDt)));
    const float angle = 1.0f + 2.0f * static_cast<float>(k) / phases;
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc(0.9f * AngleToVector(angle), 0.05f));
    const auto events = Told(*pWorld, 3, &CWorld::GetSensorEvents, [&] {
      pWorld->Step();
      atTheEnd += IsTouchedAtTheEnd(*pWorld);
      for (const CContactEvent& contact : pWorld->GetContacts()) {
        if (pWorld->GetSensorEvents().size() != 2) continue; // it is over it at the end, or was at first
        EXPECT_NEAR((contact.m_vPOI - pWorld->GetPos(ball)).norm(), 0, 0.05f * g_fRotatedPathError * 1.1f);
        EXPECT_NEAR(contact.m_vNorm.dot(perp(AngleToVector(angle))), 1, 1e-2f); // from where it came
        EXPECT_NEAR(contact.m_fSpeed, 1.4f / g_fExactDt * 0.9f, 0.5f);
      }
    });
    ASSERT_EQ(events, (std::vector<CSensorEvent>{{bar, ball, true}, {bar, ball, false}})) << k;
    // Stopped, it is where it is, whatever its last turn was.
    pWorld->SetRotSpeed(bar, 0);
    pWorld->SetPos(ball, 0.9f * AngleToVector(pWorld->GetOrientation(bar) - 0.7f));
    ASSERT_TRUE(Told(*pWorld, 1, &CWorld::GetSensorEvents).empty()) << k;
  }
  EXPECT_LT(atTheEnd, phases / 3); // the control
  EXPECT_GT(atTheEnd, 0);
}

TEST_P(CSensorContract, ASensorDoesNotStandInTheWay) { // of anything, nor is it there for other sensors' sake
  const CShapeId zone = m_pWorld->Add(Sensor(CCircleDesc({0, 0}, 1)));
  const CShapeId ghost = m_pWorld->Add(Sensor(CDynamicCircleDesc({0, 0.5f}, 0.1f)));
  const CShapeId floor = m_pWorld->Add(CLineSegDesc({-2, -0.5f}, {2, -0.5f}));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0, 0.5f}, 0.1f, {0, -8}));
  Steps(*m_pWorld, 16);
  EXPECT_NEAR(m_pWorld->GetVel(ball).y(), 8, 1e-3f); // the floor answered
  EXPECT_EQ(m_pWorld->GetVel(ghost), Vector2(0, 0));
  // Touches at the end, by ball and then by shape; after the contacts that were answered.
  m_pWorld->SetPos(ball, {0, -0.4375f});
  m_pWorld->SetPos(ghost, {0, -0.375f});
  m_pWorld->SetVel(ball, {0, -1});
  m_pWorld->Step();
  std::vector<std::pair<CShapeId, CShapeId>> sensed;
  bool answered = false;
  for (const CContactEvent& contact : m_pWorld->GetContacts()) {
    if (contact.m_bIsSensor) sensed.emplace_back(contact.m_cBall, contact.m_cShape);
    EXPECT_FALSE(!contact.m_bIsSensor && !sensed.empty());
    answered |= !contact.m_bIsSensor;
  }
  EXPECT_TRUE(answered);
  // The ghost is over the floor by .125, more than its radius.
  EXPECT_EQ(sensed, (std::vector<std::pair<CShapeId, CShapeId>>{{ghost, zone}, {ghost, ball}, {ball, zone}}));
  EXPECT_FALSE(std::count(sensed.begin(), sensed.end(), std::pair(ghost, floor)));
}

} // namespace
} // namespace Shapes
