// SPDX-License-Identifier: MIT
// Kinematic shapes that move by their velocity, or turn, up to their stops: where they go, what they do to
// balls until then and afterwards, what sensors see of them; the same on every engine.
#include "Backends.h"

namespace Shapes {
namespace {

constexpr float g_fLow = -0.4f, g_fHigh = 0.7f;

// A blade of length 1 about the origin, to the right.
CLineSegDesc StoppedFlipper(float revsPerSecond,
                            const CMotionLimits& limits = CMotionLimits::OfAngle(g_fLow, g_fHigh)) {
  CLineSegDesc desc = Turning(CLineSegDesc({0, 0}, {1, 0}), revsPerSecond);
  desc.m_cLimits = limits;
  return desc;
}

CLineSegDesc Wall(const Vector2& v) { return Moving(CLineSegDesc({0, -2}, {0, 2}), v); } // upright, at x = 0

class CStopContract : public CEveryBackend {
protected:
  std::unique_ptr<CWorld> m_pWorld = Make(g_cAutomatic, eProfile::Tuned);
};
SHAPES_ON_EVERY_BACKEND(CStopContract);

TEST_P(CStopContract, StopsExactlyAtBothAngles) {
  for (const CEffectChoice& choice : {g_cAutomatic, g_cApproximate, g_cContinuous})
    for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned})
      for (const float speed : {0.03f, 1.0f, 7.0f, 100.0f}) {
        SCOPED_TRACE(speed);
        const auto pWorld = Make(choice, profile);
        pWorld->Add(CDynamicCircleDesc({5, 5}, 0.1f)); // out of the way
        const CShapeId flipper = pWorld->Add(StoppedFlipper(speed));
        const int steps = static_cast<int>(0.2f / speed / g_fDt) + 2;
        Steps(*pWorld, steps);
        EXPECT_EQ(pWorld->GetOrientation(flipper), g_fHigh);
        EXPECT_EQ(pWorld->GetRotSpeed(flipper), speed); // the drive
        EXPECT_EQ(pWorld->GetShape(flipper).GetSurfaceVelocity({1, 1}), Vector2(0, 0));
        EXPECT_FALSE(pWorld->GetEffects().Has(eEffect::Kinematics)); // it rests, and costs nothing
        pWorld->SetRotSpeed(flipper, -speed);
        Steps(*pWorld, 2 * steps);
        EXPECT_EQ(pWorld->GetOrientation(flipper), NormalizeAngle(g_fLow));
        pWorld->SetLimits(flipper, {});
        Steps(*pWorld, 1);
        EXPECT_NE(pWorld->GetOrientation(flipper), NormalizeAngle(g_fLow));
      }
}

// As slow as 1e-6 rad a step, about as much as the orientation is rounded to.
TEST_P(CStopContract, LeavesAStopHoweverSlowly) {
  const CShapeId flipper = m_pWorld->Add(StoppedFlipper(1));
  Steps(*m_pWorld, 30);
  m_pWorld->SetRotSpeed(flipper, -1e-5f);
  Steps(*m_pWorld, 100);
  EXPECT_NEAR(m_pWorld->GetOrientation(flipper), g_fHigh - g_fTwoPi * 1e-5f * 100 * g_fDt, 1e-5f);
}

// The blade comes to the ball in the step in which it stops. In front of the stop the kick is that of one
// that turns on, behind it there is none.
TEST_P(CStopContract, KicksUntilItStopsAndNotAfterwards) {
  const float r = 0.05f, d = 0.8f, speed = 4; // .42 rad a step
  for (const float angle : {0.5f, 0.6f, 0.69f, 0.71f, 0.8f, 1.0f}) {
    SCOPED_TRACE(angle);
    Vector2 v[2];
    for (const bool stops : {true, false}) {
      const auto pWorld = Make(g_cAutomatic, eProfile::Tuned);
      pWorld->Add(StoppedFlipper(speed, stops ? CMotionLimits::OfAngle(g_fLow, g_fHigh) : CMotionLimits()));
      // Touched when the blade is at this angle.
      const CShapeId ball =
          pWorld->Add(CDynamicCircleDesc(d * AngleToVector(angle) + r * perp(AngleToVector(angle)), r));
      Steps(*pWorld, 2);
      v[stops] = pWorld->GetVel(ball);
      if (stops) Steps(*pWorld, 20);
      EXPECT_TRUE(!stops || (pWorld->GetVel(ball) - v[1]).norm() == 0.0f);
    }
    // Tuned Box2D errs by 1% of the speed of a kick, native by roundings.
    const float kick = 2 * g_fTwoPi * speed * d;
    EXPECT_LE((v[1] - (angle < g_fHigh ? v[0] : Vector2(0, 0))).norm(), kick * (IsBox2D() ? 0.02f : 1e-5f));
    if (angle < 0.8f) {
      EXPECT_NEAR(v[0].norm(), kick, 0.02f * kick); // the control: it reaches all of these
    }
  }
}

// A ball that falls onto a flipper which is pressed against its stop has the path of one on a wall.
TEST_P(CStopContract, AtItsStopItIsAsGoodAsStatic) {
  for (const eProfile profile : {eProfile::Shipped, eProfile::Tuned}) {
    const auto velocityOn = [&](const CLineSegDesc& desc) {
      const auto pWorld = Make(g_cAutomatic, profile, {0, -10});
      pWorld->Add(desc);
      const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.7f, 0.5f}, 0.1f, {0, 0}, 1, 0.5f));
      Steps(*pWorld, 40);
      return pWorld->GetVel(ball);
    };
    const Vector2 v = velocityOn(CLineSegDesc({0, 0}, {1, 0})),
                  stopped = velocityOn(StoppedFlipper(-3, CMotionLimits::OfAngle(0, 1)));
    EXPECT_NEAR((v - stopped).norm(), 0.0f, 1e-5f);                   // of 3 m/s some roundings
    EXPECT_GT((v - velocityOn(StoppedFlipper(-3, {}))).norm(), 0.5f); // the control: one that has no stop
  }
}

TEST_P(CStopContract, StillRestsThereWhenItsStateIsLoaded) {
  const CShapeId flipper = m_pWorld->Add(StoppedFlipper(7));
  Steps(*m_pWorld, 20);
  const auto pOther = Make(g_cAutomatic, eProfile::Tuned);
  for (CWorld* pWorld : {m_pWorld.get(), pOther.get()}) {
    pWorld->LoadState(m_pWorld->SaveState());
    EXPECT_FALSE(pWorld->GetEffects().Has(eEffect::Kinematics));
    EXPECT_EQ(pWorld->GetShape(flipper).GetSurfaceVelocity({1, 1}), Vector2(0, 0));
    EXPECT_EQ(pWorld->GetRotSpeed(flipper), 7); // the drive
  }
  m_pWorld->SetRotSpeed(flipper, -7);
  Steps(*m_pWorld, 1);
  EXPECT_NE(m_pWorld->GetOrientation(flipper), g_fHigh);
}

TEST_P(CStopContract, StopsAtTwoPlaces) {
  CLineSegDesc plunger = Moving(CLineSegDesc({-0.1f, 0}, {0.1f, 0}), {0, 5});
  plunger.m_cLimits = CMotionLimits::OfCenter({0, 0.3f}, {0, -1});
  const CShapeId id = m_pWorld->Add(plunger);
  Steps(*m_pWorld, 10);
  EXPECT_EQ(m_pWorld->GetRotCenter(id), Vector2(0, 0.3f));
  EXPECT_NEAR(m_pWorld->GetPos(id).y(), 0.3f, 1e-7f);
  EXPECT_EQ(m_pWorld->GetVel(id), Vector2(0, 5)); // the drive
  m_pWorld->SetVel(id, {0, -5});
  Steps(*m_pWorld, 30);
  EXPECT_EQ(m_pWorld->GetRotCenter(id), Vector2(0, -1));
  // One coordinate stops, the other goes on.
  m_pWorld->SetLimits(id, CMotionLimits::OfCenter({0, -1}, {4, -0.9f}));
  m_pWorld->SetVel(id, {6, 6});
  Steps(*m_pWorld, 10);
  EXPECT_EQ(m_pWorld->GetRotCenter(id).y(), -0.9f);
  EXPECT_NEAR(m_pWorld->GetRotCenter(id).x(), 1.0f, 1e-5f);
}

TEST_P(CStopContract, ACompoundStopsAsOne) {
  const CAnyShapeDesc descs[] = {CCircleDesc({0, 0}, 0.2f), CCircleDesc({1, 0}, 0.1f),
                                 CLineSegDesc({0, 0.2f}, {1, 0.1f}), CPointDesc(Vector2(1.1f, 0))};
  const auto ids = m_pWorld->AddCompound(descs, {0, 0}, 6, {0, 0}, CMotionLimits::OfAngle(g_fLow, g_fHigh));
  for (const int steps : {1, 1, 1, 8}) {
    Steps(*m_pWorld, steps);
    for (const CShapeId id : ids)
      EXPECT_EQ(m_pWorld->GetOrientation(id), m_pWorld->GetOrientation(ids[0]));
  }
  EXPECT_EQ(m_pWorld->GetOrientation(ids[0]), g_fHigh);
  m_pWorld->SetRotSpeed(ids, -1);
  Steps(*m_pWorld, 60);
  for (const CShapeId id : ids)
    EXPECT_EQ(m_pWorld->GetOrientation(id), NormalizeAngle(g_fLow));
}

// The stops that are asked for lie where the parts come to be.
TEST_P(CStopContract, ACompoundTakesTheStopsOfAnotherShape) {
  const CMotionLimits stops = CMotionLimits::OfAngle(g_fLow, g_fHigh);
  for (CShapeId first = m_pWorld->Add(StoppedFlipper(1)); first.m_nValue < 500;) {
    const CAnyShapeDesc descs[] = {CPointDesc(Vector2(0, 0)), CPointDesc(Vector2(1, 0)),
                                   CPointDesc(Vector2(2, 0))};
    const auto ids = m_pWorld->AddCompound(descs, {0, 0}, 6, {0, 0}, m_pWorld->GetLimits(first));
    for (const CShapeId id : ids)
      ASSERT_EQ(m_pWorld->GetLimits(id), stops);
    first = ids.front();
  }
}

TEST_P(CStopContract, WhatIsBeyondItsStopsMovesTowardsThemOnly) {
  const CShapeId id = m_pWorld->Add(StoppedFlipper(1));
  m_pWorld->SetOrientation(id, 1);
  Steps(*m_pWorld, 10);
  EXPECT_EQ(m_pWorld->GetOrientation(id), 1.0f);
  m_pWorld->SetRotSpeed(id, -1);
  Steps(*m_pWorld, 3);
  EXPECT_NEAR(m_pWorld->GetOrientation(id), 1 - g_fTwoPi * 3 * g_fDt, 1e-5f);
  m_pWorld->SetOrientation(id, 0.2f);
  m_pWorld->SetRotSpeed(id, 1);
  Steps(*m_pWorld, 30);
  EXPECT_EQ(m_pWorld->GetOrientation(id), g_fHigh);
}

TEST_P(CStopContract, WhatCannotBeIsRefused) {
  const CShapeId id = m_pWorld->Add(StoppedFlipper(1)), wall = m_pWorld->Add(CLineSegDesc({0, 0}, {1, 1}));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({5, 5}, 0.1f));
  const auto refused = [](const auto& f) { return MessageOf<std::invalid_argument>(f); };
  CMotionLimits nowhere;
  nowhere.m_vLeastCenter = {g_fNan, 0};
  for (const CMotionLimits& limits :
       {CMotionLimits::OfAngle(1, 0), CMotionLimits::OfAngle(0, 7), CMotionLimits::OfAngle(0, g_fInf),
        CMotionLimits::OfAngle(g_fNan, 1), nowhere}) {
    EXPECT_TRUE(Says(refused([&] { m_pWorld->SetLimits(id, limits); }), "m_cLimits"));
    EXPECT_TRUE(Says(refused([&] { m_pWorld->Add(StoppedFlipper(1, limits)); }), "m_cLimits"));
  }
  EXPECT_EQ(m_pWorld->GetLimits(id), CMotionLimits::OfAngle(g_fLow, g_fHigh));
  EXPECT_NE(refused([&] { m_pWorld->SetLimits(wall, CMotionLimits::OfAngle(0, 1)); }), "");
  EXPECT_NE(refused([&] { m_pWorld->SetLimits(ball, CMotionLimits::OfAngle(0, 1)); }), "");
  EXPECT_EQ(refused([&] { m_pWorld->SetLimits(wall, {}); }), "");
  CLineSegDesc turning = StoppedFlipper(1, {});
  turning.m_eMotionType = eMotion::Static;
  EXPECT_EQ(refused([&] { m_pWorld->Add(turning); }),
            "m_fRotSpeed is 1: expected 0: a static shape does not turn");
  CLineSegDesc moving = Wall({1, 0});
  moving.m_eMotionType = eMotion::Static;
  EXPECT_TRUE(Says(refused([&] { m_pWorld->Add(moving); }), "m_vVel"));
  EXPECT_EQ(m_pWorld->GetShapeIds().size(), 2u);
}

class CMovingWallContract : public CEveryBackend {
protected:
  std::unique_ptr<CWorld> m_pWorld = Make();
};
SHAPES_ON_EVERY_BACKEND(CMovingWallContract);

// A wall at V against which a ball comes at v leaves it with 2 V - v, however fast it is: at 60 it moves by
// ten radii a step. Moved by SetPos instead it has no speed, which is the control.
TEST_P(CMovingWallContract, AWallGivesABallTwiceItsSpeed) {
  for (const float speed : {0.5f, 2.0f, 6.0f, 12.0f, 60.0f}) {
    SCOPED_TRACE(speed);
    const auto pWorld = Make();
    const CShapeId wall = pWorld->Add(Wall({speed, 0}));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({1, 0}, 0.1f, {-1, 0}));
    for (int i = 0; i < 300 && !(pWorld->GetVel(ball).x() > 0.0f); ++i)
      pWorld->Step();
    EXPECT_NEAR(pWorld->GetVel(ball).x(), 2.0f * speed + 1.0f, 1e-5f * speed);
    EXPECT_EQ(pWorld->GetVel(wall), Vector2(speed, 0));
    Steps(*pWorld, 20);
    EXPECT_GT(pWorld->GetPos(ball).x(), pWorld->GetPos(wall).x());
  }
  const auto pWorld = Make();
  const CShapeId wall = pWorld->Add(Wall({0, 0}));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({1, 0}, 0.1f, {-1, 0}));
  for (int i = 1; i <= 60; ++i) {
    pWorld->SetPos(wall, {2.0f * g_fDt * static_cast<float>(i), 0});
    pWorld->Step();
  }
  EXPECT_LT(pWorld->GetVel(ball).x(), 1.5f);
}

TEST_P(CMovingWallContract, ItIsWhereItsVelocityTakesIt) {
  CLineSegDesc desc = Wall({0.3f, -0.7f});
  desc.m_vRotCenter = {0, 1};
  const CShapeId wall = m_pWorld->Add(desc);
  Steps(*m_pWorld, 6000);
  const float t = 100.0f; // seconds
  EXPECT_NEAR(m_pWorld->GetPos(wall).x(), 0.3f * t, 2e-5f);
  EXPECT_NEAR(m_pWorld->GetPos(wall).y(), -0.7f * t, 5e-5f);
  EXPECT_NEAR(m_pWorld->GetRotCenter(wall).y(), 1 - 0.7f * t, 5e-5f);
  m_pWorld->SetVel(wall, {0, 0});
  const Vector2 there = m_pWorld->GetPos(wall);
  Steps(*m_pWorld, 10);
  EXPECT_EQ(m_pWorld->GetPos(wall), there);
  m_pWorld->Reset(wall);
  EXPECT_EQ(m_pWorld->GetPos(wall), Vector2(0, 0));
  EXPECT_EQ(m_pWorld->GetRotCenter(wall), Vector2(0, 1));
}

// The centre of rotation goes straight on, and everything keeps its distance from it.
TEST_P(CMovingWallContract, ACompoundMovesAndTurnsAsOne) {
  std::vector<CAnyShapeDesc> parts{CLineSegDesc({1, 0}, {2, 0}), CCircleDesc({2, 0}, 0.1f),
                                   CPointDesc({1, 0}), CArcDesc({1.5f, 0}, 0.2f, 0, 1)};
  const std::vector<CShapeId> ids = m_pWorld->AddCompound(parts, {1, 0}, 0.25f, {2, 0});
  ASSERT_EQ(ids.size(), 4u);
  Steps(*m_pWorld, 60);
  const Vector2 places[] = {{3, 0.5f}, {3, 1}, {3, 0}, {3, 0.5f}};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT((m_pWorld->GetPos(ids[i]) - places[i]).norm(), 2e-5f) << i;
  const auto& bar = static_cast<const CLineSeg&>(m_pWorld->GetShape(ids[0]));
  EXPECT_LT(std::min((bar.GetEndPt0() - m_pWorld->GetPos(ids[1])).norm(),
                     (bar.GetEndPt1() - m_pWorld->GetPos(ids[1])).norm()),
            1e-6f);
  m_pWorld->SetVel(ids, {0, -3});
  Steps(*m_pWorld, 240); // a whole turn
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT((m_pWorld->GetPos(ids[i]) - places[i] - Vector2(0, -12)).norm(), 5e-5f) << i;
  parts.push_back(CCircleDesc({0, 0}, -1));
  const auto refusal = [&] {
    return MessageOf<std::invalid_argument>([&] { m_pWorld->AddCompound(parts, {0, 0}); });
  };
  EXPECT_TRUE(Says(refusal(), "shape 4: m_fRadius is -1: expected"));
  EXPECT_FALSE(m_pWorld->Contains({ids[3].m_nValue + 1})); // nothing was half added
  parts.back() = CDynamicCircleDesc({0, 0}, 1);
  EXPECT_TRUE(Says(refusal(), "shape 4: m_eMotionType is Dynamic"));
  parts.back() = CPointDesc(Vector2(2 * g_fMaxLength, 0)); // beyond what an engine holds
  EXPECT_TRUE(Says(refusal(), "shape 4: m_vPos"));
}

// One that crosses a ball within a step begins and ends.
TEST_P(CMovingWallContract, ASensorThatMovesSeesABallThatRests) {
  for (const float speed : {1.0f, 90.0f}) {
    const auto pWorld = Make();
    const CShapeId sensor = pWorld->Add(Sensor(Wall({speed, 0})));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0.75f, 0}, 0.1f));
    const auto events = Told(*pWorld, 120, &CWorld::GetSensorEvents, [&] {
      pWorld->Step();
      for (const CContactEvent& event : pWorld->GetContacts())
        EXPECT_NEAR(event.m_vPOI.x(), 0.75f, 0.1f + 1e-4f);
    });
    EXPECT_EQ(events, (std::vector<CSensorEvent>{{sensor, ball, true}, {sensor, ball, false}}));
    EXPECT_EQ(pWorld->GetVel(ball), Vector2(0, 0));
  }
}

// Far out it stops at the limit of what coordinates may be, and nothing else happens.
TEST_P(CMovingWallContract, ItStopsAtTheGreatestLength) {
  const float limit = IsBox2D() ? g_fMaxBox2DLength : g_fMaxLength;
  const CShapeId point = m_pWorld->Add(Moving(CPointDesc({0.999f * limit, 0}), {1e-4f * limit, 0}));
  Steps(*m_pWorld, 100 * 60);
  const float x = m_pWorld->GetPos(point).x();
  EXPECT_LE(x, limit);
  EXPECT_GT(x, 0.999f * limit); // the control: it has moved
  m_pWorld->Step();
  EXPECT_EQ(m_pWorld->GetPos(point).x(), x);
}

} // namespace
} // namespace Shapes
