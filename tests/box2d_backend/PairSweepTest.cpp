// SPDX-License-Identifier: MIT
// Box2D's resolution to CollisionDetected, by its time of impact: how far it is from the exact one, and where
// its skin begins.
#include "box2d_backend/contact/PairSweep.h"

#include "../GameClock.h"
#include "Box2DTesting.h"

namespace Shapes::Box2D {
namespace {

// b2TimeOfImpact stops when the distance of the centres or centre lines is the sum of both radii less 3 slops
// of .005, within a quarter of a slop. The radius of an edge is .01, that of a circle its own. So a ball
// sinks this deep into what it meets, in metres:
constexpr float g_fStopTolerance = 0.25f * b2_linearSlop;
constexpr float g_fIntoEdge = 3.0f * b2_linearSlop - b2_polygonRadius;
constexpr float g_fIntoCircle = 3.0f * b2_linearSlop;
constexpr float g_fRounding = 2e-5f; // 16 ulp of 10, which no coordinate below exceeds

constexpr float g_fR = 0.1f; // radius of balls

class CPairSweepTest : public testing::Test {
protected:
  void SetUp() override { CGameClock::Set(g_fDt, 0.0f); }

  /// A ball that has flown from `from` by `way` in the last step.
  static CDynamicCircle Fly(const Vector2& from, const Vector2& way, float r = g_fR) {
    CDynamicCircle ball(CDynamicCircleDesc(from, r, way / g_fDt));
    ball.move();
    return ball;
  }

  static bool Meets(CShape& shape, CDynamicCircle& ball) {
    CContactDesc c(&shape, &ball);
    return CollidePair(c);
  }
  /// The contact of both, which must meet.
  static CContactDesc Meet(CShape& shape, CDynamicCircle& ball) {
    CContactDesc c(&shape, &ball);
    EXPECT_TRUE(CollidePair(c));
    return c;
  }
};

TEST_F(CPairSweepTest, TheSetbackFromASegmentIsExactWithinTheSlop) {
  ForEachCase(21, 5000, [&](CRandom& random, int) {
    const Vector2 t = random.Direction(), n = perp(t);
    CLineSeg seg(CLineSegDesc(-3 * t, 3 * t));
    const float gap = random.Uniform(0.02f, 1), depth = random.Uniform(0.02f, 5),
                r = random.Uniform(0.05f, 0.5f);
    // Comes from n or from -n, at up to 45 degrees, and would end up `depth` inside or beyond.
    const Vector2 nhat = random.Coin() ? n : Vector2(-n);
    const float along = random.Uniform(-0.3f, 0.3f);
    CDynamicCircle ball = Fly((gap + r) * nhat, (gap + depth) * (along * t - nhat), r);
    const CContactDesc c = Meet(seg, ball);
    EXPECT_NEAR((c.m_vNorm - nhat).norm(), 0, 1e-5f);
    EXPECT_NEAR(depth - c.m_fSetback, g_fIntoEdge, g_fStopTolerance + g_fRounding);
    // The point touched is on the line, as deep as the ball sank.
    EXPECT_NEAR(c.m_vPOI.dot(nhat), -g_fIntoEdge, g_fStopTolerance + g_fRounding);
  });
}

TEST_F(CPairSweepTest, AnImpactOnACircleIsOnTheWayOfTheBallWithinTheSlop) {
  ForEachCase(22, 10000, [&](CRandom& random, int) {
    const float R = random.Coin() ? 0.0f : random.Uniform(0.1f, 1), D = R + g_fR; // R = 0: a point
    const auto pShape = R == 0.0f ? MakeShape(CPointDesc({0, 0})) : MakeShape(CCircleDesc({0, 0}, R));
    // The way passes the centre at up to .8 of D, and ends beyond the place of the impact.
    const float aside = random.Uniform(-0.8f, 0.8f) * D, before = D + random.Uniform(0.02f, 1);
    const float met = -std::sqrt((D - g_fIntoCircle) * (D - g_fIntoCircle) - aside * aside);
    const Vector2 dir = random.Direction(), from = -before * dir + aside * perp(dir),
                  way = (before + met + random.Uniform(0.02f, 2)) * dir;
    CDynamicCircle ball = Fly(from, way);
    const CContactDesc c = Meet(*pShape, ball);
    const Vector2 p = c.m_vPOI + g_fR * c.m_vNorm; // the ball's centre at the impact
    EXPECT_NEAR(p.norm(), D - g_fIntoCircle, g_fStopTolerance + g_fRounding);
    EXPECT_NEAR((c.m_vNorm - p.normalized()).norm(), 0, 1e-4f);
    EXPECT_NEAR(Cross(p - from, dir), 0, g_fRounding);
    EXPECT_LT((p - from).norm(), way.norm() + g_fRounding);
    EXPECT_LT(p.dot(dir), 0); // the near side, not the far one
    EXPECT_NEAR(c.m_fSetback, (p - ball.GetPos()).dot(c.m_vNorm), g_fRounding);
  });
}

TEST_F(CPairSweepTest, TheSetbackFromAnArcIsExactWithinTheSlopAndTheSagitta) {
  CArc arc(CArcDesc({0, 0}, 1, 0, g_fPi));
  ForEachCase(24, 2000, [&](CRandom& random, int) {
    const Vector2 u = AngleToVector(random.Uniform(0.1f, g_fPi - 0.1f));
    const bool outside = random.Coin();
    const float side = outside ? 1.0f : -1.0f, gap = random.Uniform(0.03f, 0.5f),
                depth = random.Uniform(0.03f, 0.3f);
    CDynamicCircle ball = Fly((1 + side * (gap + g_fR)) * u, -side * (gap + depth) * u);
    const CContactDesc c = Meet(arc, ball);
    const float angle = 0.5f * g_fPi / 16; // between a chord and the arc at its ends
    EXPECT_GT(c.m_vNorm.dot(side * u), std::cos(1.01f * angle));
    // Chords lie inside the arc: seen from outside they are up to a sagitta farther away, from inside nearer.
    // The setback is along the normal of the chord, so it is shorter than the way by its cosine.
    const float into = depth - c.m_fSetback - g_fIntoEdge, bound = g_fStopTolerance + g_fRounding;
    EXPECT_GE(into, -bound - (outside ? 0 : g_fSagittaTolerance));
    EXPECT_LE(into, bound + (outside ? g_fSagittaTolerance : 0) + (1 - std::cos(angle)) * depth);
  });
}

TEST_F(CPairSweepTest, BothBallsAreFollowed) {
  ForEachCase(25, 2000, [&](CRandom& random, int) {
    // Head on; each makes its part of the way, and they would have passed through each other.
    const Vector2 nhat = random.Direction();
    const float wayA = random.Uniform(0, 2), wayB = random.Uniform(0, 2) + 0.5f;
    CDynamicCircle a = Fly(Vector2(0, 0), wayA * nhat);
    CDynamicCircle b = Fly(0.5f * nhat, -wayB * nhat);
    const CContactDesc c = Meet(a, b);
    // They close .3 before they touch, and sink into each other a little.
    const float time = (0.3f + g_fIntoCircle) / (wayA + wayB);
    EXPECT_NEAR((c.m_vNorm - nhat).norm(), 0, 1e-4f);
    EXPECT_NEAR(c.m_fSetback, (1 - time) * (wayA + wayB), g_fStopTolerance + g_fRounding);
  });
}

TEST_F(CPairSweepTest, ATurningFlipperIsFollowed) {
  // It turns half a radian in the step and passes over a ball that lies still, without overlapping it at
  // either end.
  CKinematicLineSeg flipper(Turning(CLineSegDesc({0, 0}, {1, 0}), 0.5f / (g_fTwoPi * g_fDt)));
  flipper.move();
  CDynamicCircle ball = Fly(0.8f * AngleToVector(0.25f), {0, 0}, 0.05f);
  const CContactDesc c = Meet(flipper, ball);
  EXPECT_GT(c.m_vNorm.dot(perp(AngleToVector(0.25f))), 0.99f); // it came from below
  flipper.SetOrientation(0.5f); // the control: placed there, it has not passed over anything
  EXPECT_FALSE(Meets(flipper, ball));
}

TEST_F(CPairSweepTest, EdgesHaveASkinAndCirclesHaveNone) {
  const auto setback = [](const CAnyShapeDesc& desc, float gap) { // 0 if they do not touch
    const auto pShape = MakeShape(desc);
    CDynamicCircle ball = Fly({0, g_fR + gap}, {0, 0});
    CContactDesc c(pShape.get(), &ball);
    return CollidePair(c) ? c.m_fSetback : 0.0f;
  };
  const CArcDesc arc({0, -1}, 1, 0, g_fPi); // its top is a vertex, which is on the arc
  for (const CAnyShapeDesc& edge : {CAnyShapeDesc(CLineSegDesc({-1, 0}, {1, 0})), CAnyShapeDesc(arc)}) {
    EXPECT_NEAR(setback(edge, 0.9f * b2_polygonRadius), 0.1f * b2_polygonRadius, 1e-6f);
    EXPECT_EQ(setback(edge, 1.1f * b2_polygonRadius), 0);
  }
  for (const CAnyShapeDesc& round :
       {CAnyShapeDesc(CCircleDesc({0, -1}, 1)), CAnyShapeDesc(CPointDesc({0, 0}))}) {
    EXPECT_NEAR(setback(round, -0.001f), 0.001f, 1e-6f);
    EXPECT_EQ(setback(round, 0.001f), 0);
  }
}

TEST_F(CPairSweepTest, TheEarliestPieceIsTheOneThatIsMet) {
  // Straight through a bowl: from far outside the near side is met, from within the far side.
  CArc bowl(CArcDesc({0, 0}, 1, 0, 0));
  for (const auto& [start, side] : {std::pair(-3.0f, -1.0f), std::pair(-0.5f, 1.0f)}) {
    CDynamicCircle ball = Fly({start, 0.2f}, {6, 0});
    const CContactDesc c = Meet(bowl, ball);
    EXPECT_GT(side * c.m_vPOI.x(), 0.9f);
    EXPECT_LT(c.m_vNorm.x(), -0.9f);
  }
}

TEST_F(CPairSweepTest, WhatABallLeavesIsNotMet) {
  CLineSeg seg(CLineSegDesc({-1, 0}, {1, 0}));
  CDynamicCircle leaves = Fly({0, 0.05f}, {0, 1}); // overlaps at first
  EXPECT_FALSE(Meets(seg, leaves));
  CDynamicCircle stays = Fly({0, 0.05f}, {0, 0.01f}); // the control, out to the skin
  EXPECT_NEAR(Meet(seg, stays).m_fSetback, g_fR - 0.06f + b2_polygonRadius, 1e-5f);
}

TEST_F(CPairSweepTest, AShapeThatWasMovedIsMetWhereItIs) {
  CLineSeg seg(CLineSegDesc({-1, 0}, {1, 0}));
  CDynamicCircle ball = Fly({0, 1}, {0, -2});
  EXPECT_TRUE(Meets(seg, ball)); // what Box2D needs is kept with the shape from here on
  seg.SetPos({5, 0});
  EXPECT_FALSE(Meets(seg, ball));
  seg.SetPos({0, 0.5f});
  EXPECT_NEAR(Meet(seg, ball).m_vPOI.y(), 0.5f - g_fIntoEdge, g_fStopTolerance + g_fRounding);

  CKinematicLineSeg flipper(CLineSegDesc({-1, 0}, {1, 0}));
  EXPECT_TRUE(Meets(flipper, ball));
  flipper.SetRotCenter({-1, 0});
  flipper.SetOrientation(-0.5f * g_fPi); // hangs down at x = -1
  EXPECT_FALSE(Meets(flipper, ball));
}

TEST_F(CPairSweepTest, TheAnswerIsTheSameFarFromTheOrigin) {
  // 8192 has steps of 2^-10; all that is added to it below is a multiple of that. The sweep is about the
  // shape, so not a digit is lost.
  const Vector2 far(8192, -8192);
  CLineSeg here(CLineSegDesc({-1, 0}, {1, 0})),
      there(CLineSegDesc(far + Vector2(-1, 0), far + Vector2(1, 0)));
  CDynamicCircle ballHere = Fly({0.25f, 0.5f}, {0, -0.75f}, 0.125f),
                 ballThere = Fly(far + Vector2(0.25f, 0.5f), {0, -0.75f}, 0.125f);
  const CContactDesc c = Meet(here, ballHere), d = Meet(there, ballThere);
  EXPECT_NEAR(c.m_fSetback, d.m_fSetback, 1e-6f);
  EXPECT_NEAR((d.m_vPOI - far - c.m_vPOI).norm(), 0, 0x1p-10f);
}

} // namespace
} // namespace Shapes::Box2D
