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
      std::vector<CSensorEvent> events;
      std::size_t contacts = 0;
      for (int step = 0; step < steps; ++step) {
        pWorld->Step();
        events.insert(events.end(), pWorld->GetSensorEvents().begin(), pWorld->GetSensorEvents().end());
        for (const CContactEvent& contact : pWorld->GetContacts()) {
          ++contacts;
          EXPECT_TRUE(contact.m_bIsSensor);
          EXPECT_LE(contact.m_vPOI.norm(), 0.2f);
          EXPECT_NEAR(contact.m_vNorm.norm(), 1, 1e-5f);
        }
        // The touches that a look at the end of the step only would see: the control.
        if (!events.empty() && events.back().m_bBegin) ++atTheEnd;
      }
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
    std::vector<CSensorEvent> events;
    for (int step = 0; step < 3; ++step) {
      pWorld->Step();
      events.insert(events.end(), pWorld->GetSensorEvents().begin(), pWorld->GetSensorEvents().end());
      if (!events.empty() && events.back().m_bBegin) ++atTheEnd;
      for (const CContactEvent& contact : pWorld->GetContacts()) {
        if (pWorld->GetSensorEvents().size() != 2) continue; // it is over it at the end, or was at first
        EXPECT_NEAR((contact.m_vPOI - pWorld->GetPos(ball)).norm(), 0, 0.05f * g_fRotatedPathError * 1.1f);
        EXPECT_NEAR(contact.m_vNorm.dot(perp(AngleToVector(angle))), 1, 1e-2f); // from where it came
        EXPECT_NEAR(contact.m_fSpeed, 1.4f / g_fExactDt * 0.9f, 0.5f);
      }
    }
    ASSERT_EQ(events, (std::vector<CSensorEvent>{{bar, ball, true}, {bar, ball, false}})) << k;
    // Stopped, it is where it is, whatever its last turn was.
    pWorld->SetRotSpeed(bar, 0);
    pWorld->SetPos(ball, 0.9f * AngleToVector(pWorld->GetOrientation(bar) - 0.7f));
    ASSERT_TRUE(Told(*pWorld, 1, &CWorld::GetSensorEvents).empty()) << k;
  }
  EXPECT_LT(atTheEnd, phases / 3); // the control
  EXPECT_GT(atTheEnd, 0);
}

TEST_P(CSensorContract, TheContactOfACrossingIsWhereTheCentreWasClosest) {
  const CShapeId wall = m_pWorld->Add(Sensor(CLineSegDesc({-1, 0}, {1, 0})));
  const CShapeId post = m_pWorld->Add(Sensor(CPointDesc(Vector2(0.125f, -1))));
  m_pWorld->Add(CDynamicCircleDesc({0, 0.5f}, 0.25f, {0, -128})); // 2 units: to -1.5
  m_pWorld->Step();
  const auto contacts = m_pWorld->GetContacts();
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0].m_cShape, wall);
  EXPECT_NEAR((contacts[0].m_vPOI - Vector2(0, 0)).norm(), 0, 1e-6f);
  EXPECT_NEAR((contacts[0].m_vNorm - Vector2(0, 1)).norm(), 0, 1e-6f); // against its way
  EXPECT_NEAR(contacts[0].m_fSpeed, 128, 1e-3f);
  EXPECT_EQ(contacts[1].m_cShape, post);
  EXPECT_EQ(contacts[1].m_vPOI, Vector2(0.125f, -1));
  EXPECT_NEAR((contacts[1].m_vNorm - Vector2(-1, 0)).norm(), 0, 1e-6f);
  EXPECT_NEAR(contacts[1].m_fSpeed, 0, 1e-3f); // it passes
  EXPECT_EQ(contacts[0].m_fSetback, 0);
}

TEST_P(CSensorContract, ACircleIsADiskAndAnArcIsACurve) {
  for (const bool disk : {true, false}) {
    auto pWorld = Make();
    const CShapeId zone =
        disk ? pWorld->Add(Sensor(CCircleDesc({0, 0}, 2))) : pWorld->Add(Sensor(CArcDesc({0, 0}, 2, 0, 0)));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 0.25f, {16, 0})); // .25 a step
    std::vector<CSensorEvent> events;
    std::size_t contacts = 0;
    for (int step = 1; step <= 12; ++step) {
      pWorld->Step();
      contacts += pWorld->GetContacts().size();
      for (const CSensorEvent& event : pWorld->GetSensorEvents()) {
        events.push_back(event);
        // In from the beginning, or when its front is at the curve; out when it is past it.
        EXPECT_EQ(step, !event.m_bBegin ? 9 : disk ? 1 : 8);
      }
    }
    EXPECT_EQ(events, (std::vector<CSensorEvent>{{zone, ball, true}, {zone, ball, false}}));
    EXPECT_EQ(contacts, disk ? 9u : 2u);
    EXPECT_EQ(pWorld->GetStats().m_nSensorHits, contacts);
  }
}

TEST_P(CSensorContract, EndsBelongToASensorAndSidesDoNotMatter) {
  const auto touches = [&](const CAnyShapeDesc& sensor, const Vector2& from, const Vector2& way) {
    auto pWorld = Make();
    pWorld->Add(sensor);
    pWorld->Add(CDynamicCircleDesc(from, 0.1f, way / g_fExactDt));
    pWorld->Step();
    EXPECT_EQ(pWorld->GetSensorEvents().size() % 2, 0u);
    return !pWorld->GetSensorEvents().empty();
  };
  CLineSegDesc seg = Sensor(CLineSegDesc({-1, 0}, {1, 0}));
  CArcDesc arc = Sensor(CArcDesc({0, -1}, 1, 0.5f * g_fPi - 0.2f, 0.5f * g_fPi + 0.2f));
  EXPECT_TRUE(touches(seg, {1.05f, 1}, {0, -2})); // past the end, where a solid one is open
  EXPECT_FALSE(touches(seg, {1.15f, 1}, {0, -2}));
  EXPECT_TRUE(touches(arc, {0.25f, 1}, {0, -2}));
  EXPECT_FALSE(touches(arc, {0.35f, 1}, {0, -2}));
  for (const eSides sides : {eSides::Both, eSides::Front, eSides::Back}) {
    seg.m_eSides = arc.m_eSides = sides;
    for (const float y : {1.0f, -1.0f}) {
      EXPECT_TRUE(touches(seg, {0, y}, {0, -2 * y}));
      EXPECT_TRUE(touches(arc, {0, y}, {0, -2 * y}));
    }
  }
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
