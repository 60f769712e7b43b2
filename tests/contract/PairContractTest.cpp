// SPDX-License-Identifier: MIT
// CollisionDetected and CollisionResponse, the same on every engine.
#include "Backends.h"

namespace Shapes {
namespace {

class CPairContract : public CEveryBackend {
protected:
  void SetUp() override { CGameClock::Set(g_fDt, 0.0f); }
  bool Detects(CShape& shape, CDynamicCircle& ball) const {
    CContactDesc c(&shape, &ball);
    return Backend().CollisionDetected(c);
  }

  /// A ball of radius r that has just moved to `to` with velocity v, from `to` - v dt.
  static CDynamicCircle Arrive(const Vector2& to, const Vector2& v, float r = 0.1f) {
    CDynamicCircle ball(CDynamicCircleDesc(to - v * g_fDt, r, v));
    ball.move();
    return ball;
  }

  /// The ball comes straight down on a surface whose top is at the origin, and overlaps it by .03.
  void ExpectHitFromAbove(CShape& shape) {
    CDynamicCircle ball = Arrive({0, 0.07f}, {0, -6});
    CContactDesc c(&shape, &ball);
    ASSERT_TRUE(Backend().CollisionDetected(c));
    EXPECT_NEAR(c.m_vNorm.x(), 0.0f, 0.1f); // Box2D's chords of an arc are up to .1 rad off at 16 pieces
    EXPECT_NEAR(c.m_vNorm.norm(), 1.0f, 1e-6f);
    EXPECT_GT(c.m_vNorm.y(), 0.99f);
    EXPECT_NEAR(c.m_vPOI.x(), 0.0f, Skin());
    EXPECT_NEAR(c.m_vPOI.y(), 0.0f, Skin());
    EXPECT_NEAR(c.m_fSetback, 0.03f, Skin());
    EXPECT_NEAR(c.m_fSpeed, 6.0f, 0.07f); // 6 cos(.1) and up
    ball.CollisionResponse(c);
    EXPECT_NEAR(ball.GetVel().y(), 6.0f, 0.13f); // 6 cos(.2) and up
    EXPECT_NEAR(ball.GetPos().y(), 0.1f, Skin());
  }

  // All have their tops at the origin.
  CPoint m_cPoint{CPointDesc(Vector2(0, 0))};
  CKinematicLineSeg m_cSeg{CLineSegDesc({-1, 0}, {1, 0})};
  CCircle m_cCircle{CCircleDesc({0, -1}, 1)};
  CArc m_cArc{CArcDesc({0, -1}, 1, 0, g_fPi)};
  CDynamicCircle m_cBall = Arrive({0, 0.07f}, {0, -6});
};
SHAPES_ON_EVERY_BACKEND(CPairContract);

TEST_P(CPairContract, EveryShapeIsHitFromAbove) {
  CArc fromInside(CArcDesc({0, 1}, 1, g_fPi, 0)), bowl(CArcDesc({0, 1}, 1, 0, 0));
  for (CShape* pShape :
       std::initializer_list<CShape*>{&m_cPoint, &m_cSeg, &m_cCircle, &m_cArc, &fromInside, &bowl}) {
    SCOPED_TRACE(static_cast<int>(pShape->GetShapeType()));
    ExpectHitFromAbove(*pShape);
  }
}

TEST_P(CPairContract, ABallInsideACircleMeetsARingAndASolidOnBox2D) {
  CCircle circle(CCircleDesc({0, 0}, 1));
  CDynamicCircle ball = Arrive({0, -0.95f}, {0, -6});
  CContactDesc c(&circle, &ball);
  ASSERT_TRUE(Backend().CollisionDetected(c));
  // Box2D's circle shape is solid: it pushes the ball out through the nearer side.
  EXPECT_NEAR(c.m_vNorm.y(), IsBox2D() ? -1.0f : 1.0f, 1e-6f);
}

TEST_P(CPairContract, BallsShareSetbackAndMomentumByMass) {
  CDynamicCircle still(CDynamicCircleDesc({0, -0.1f}, 0.1f, {0, 0}, 3.0f));
  still.move();
  CDynamicCircle ball = Arrive({0, 0.07f}, {0, -6});
  CContactDesc c(&still, &ball);
  ASSERT_TRUE(Backend().CollisionDetected(c));
  EXPECT_NEAR(c.m_fSetback, 0.03f, Skin());
  EXPECT_NEAR(c.m_vPOI.y(), 0.0f, Skin());
  EXPECT_NEAR(c.m_fSpeed, 6.0f, 0.01f);
  ball.CollisionResponse(c);
  // Elastic, 1 against 3: v' = -6 (1-3)/4 = 3 and -6 * 2/4 = -3.
  EXPECT_NEAR(ball.GetVel().y(), 3.0f, 0.01f);
  EXPECT_NEAR(still.GetVel().y(), -3.0f, 0.01f);
  EXPECT_NEAR(ball.GetPos().y() - 0.07f, 0.75f * c.m_fSetback, 1e-6f);
  EXPECT_NEAR(-0.1f - still.GetPos().y(), 0.25f * c.m_fSetback, 1e-6f);
  for (const CDynamicCircle* pBall : {&still, &ball}) // boxes follow
    EXPECT_NEAR(pBall->GetAABB().GetTopLeft().y(), pBall->GetPos().y() + 0.1f, 1e-6f);
}

TEST_P(CPairContract, ABallDoesNotMeetItself) { EXPECT_FALSE(Detects(m_cBall, m_cBall)); }

TEST_P(CPairContract, SensorsAreDetectedButNotAnswered) {
  for (const bool isBall : {false, true}) {
    CDynamicCircle ball = Arrive({0, 0.07f}, {0, -6});
    CShape& sensor = isBall ? static_cast<CShape&>(ball) : m_cSeg;
    sensor.SetSensor(true);
    CContactDesc c(&m_cSeg, &ball);
    ASSERT_TRUE(Backend().CollisionDetected(c));
    const Vector2 p = ball.GetPos(), v = ball.GetVel();
    ball.CollisionResponse(c);
    EXPECT_EQ(ball.GetPos(), p);
    EXPECT_EQ(ball.GetVel(), v);
    sensor.SetSensor(false); // the control: the same contact is answered
    ball.CollisionResponse(c);
    EXPECT_NE(ball.GetVel(), v);
  }
}

TEST_P(CPairContract, WhatCannotCollideIsNotMet) {
  for (CShape* pShape : std::initializer_list<CShape*>{&m_cSeg, &m_cBall}) {
    pShape->SetCanCollide(false);
    EXPECT_FALSE(Detects(m_cSeg, m_cBall));
    pShape->SetCanCollide();
    EXPECT_TRUE(Detects(m_cSeg, m_cBall));
  }
}

TEST_P(CPairContract, NakedEndsAreOpenAndRoundOnBox2D) {
  CLineSeg seg(CLineSegDesc({0, 0}, {1, 0}));
  CDynamicCircle ball = Arrive({-0.05f, 0.05f}, {0, -6});
  EXPECT_EQ(Detects(seg, ball), IsBox2D());
  EXPECT_TRUE(Detects(m_cPoint, ball)); // where there is a guard the engines agree
}

TEST_P(CPairContract, OneSidedShapesLetBallsPassFromTheOpenSide) {
  for (const eSides sides : {eSides::Front, eSides::Back}) {
    CLineSeg seg(Sided(CLineSegDesc({-1, 0}, {1, 0}), sides));
    CArc arc(Sided(CArcDesc({0, -1}, 1, 0, g_fPi), sides));
    const float solid = sides == eSides::Front ? 1.0f : -1.0f; // y of the solid side
    for (CShape* pShape : std::initializer_list<CShape*>{&seg, &arc}) {
      CDynamicCircle hits = Arrive({0, solid * 0.07f}, {0, -solid * 6});
      CContactDesc c(pShape, &hits);
      ASSERT_TRUE(Backend().CollisionDetected(c));
      EXPECT_GT(c.m_vNorm.y() * solid, 0.99f);
      CDynamicCircle passes = Arrive({0, -solid * 0.07f}, {0, solid * 6});
      EXPECT_FALSE(Detects(*pShape, passes));
    }
  }
}

TEST_P(CPairContract, AFlipperKicksThroughTheContact) {
  CKinematicLineSeg flipper(Turning(CLineSegDesc({0, 0}, {1, 0}), 1));
  flipper.move(); // 6 degrees
  CDynamicCircle ball(CDynamicCircleDesc({0.5f, 0.11f}, 0.1f));
  ball.move();
  CContactDesc c(&flipper, &ball);
  ASSERT_TRUE(Backend().CollisionDetected(c));
  ball.CollisionResponse(c);
  // The surface at half a unit moves at 2 pi .5 = 3.14; an elastic kick gives twice that.
  EXPECT_NEAR(ball.GetVel().norm(), 2.0f * g_fPi, 0.2f); // the POI is up to .01 farther out
  EXPECT_GT(ball.GetVel().y(), 6.0f);
}

TEST_P(CPairContract, AnotherRotationCentreDoesNotMoveAShape) {
  EXPECT_TRUE(Detects(m_cSeg, m_cBall));
  m_cSeg.SetRotCenter({50, 0});
  EXPECT_TRUE(Detects(m_cSeg, m_cBall));
}

TEST_P(CPairContract, NullAndTheContactOfAnotherBallAreRefused) {
  CContactDesc noShape(nullptr, &m_cBall), noBall(&m_cPoint, nullptr), c(&m_cSeg, &m_cBall);
  EXPECT_THROW(Backend().CollisionDetected(noShape), std::invalid_argument);
  EXPECT_THROW(Backend().CollisionDetected(noBall), std::invalid_argument);
  ASSERT_TRUE(Backend().CollisionDetected(c));
  CDynamicCircle other = Arrive({0, 0.07f}, {0, -6});
  EXPECT_THROW(other.CollisionResponse(c), std::invalid_argument);
  EXPECT_THROW(m_cBall.CollisionResponse(noShape), std::invalid_argument);
  EXPECT_EQ(other.GetVel(), Vector2(0, -6));
}

TEST(BackendTest, TheDefaultEngineAnswersCollisionDetectedOfAShape) {
  CGameClock::Set(g_fDt, 0.0f);
  CLineSeg seg(CLineSegDesc({-1, 0}, {1, 0}));
  CDynamicCircle ball(CDynamicCircleDesc({0, 0.17f}, 0.1f, {1, -6}));
  ball.move();
  CContactDesc byShape(&seg, &ball), byBackend(&seg, &ball);
  ASSERT_TRUE(seg.CollisionDetected(byShape));
  ASSERT_TRUE(GetDefaultBackend().CollisionDetected(byBackend));
  EXPECT_EQ(byShape.m_vPOI, byBackend.m_vPOI);
  EXPECT_EQ(byShape.m_fSetback, byBackend.m_fSetback);
}

TEST(BackendTest, EachEngineNamesItself) {
  ASSERT_NE(GetBackend(eBackend::Native), nullptr);
  EXPECT_EQ(GetBackend(eBackend::Native)->GetName(), "native");
  if (GetBackend(eBackend::Box2D) != nullptr) {
    EXPECT_EQ(GetBackend(eBackend::Box2D)->GetName(), "box2d");
  }
  EXPECT_EQ(GetDefaultBackend().GetName(), SHAPES_TEST_DEFAULT_BACKEND);
}

} // namespace
} // namespace Shapes
