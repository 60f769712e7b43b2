// SPDX-License-Identifier: MIT
// The pair kernels at the borders of what they meet: touches, ends, sides, and centres on a shape. What
// overlaps in between is held to the error bounds of the kernels in tests/bounds/CollideBoundsTest.cpp.
#include "native/narrowphase/Collide.h"

#include "../Testing.h"
#include "traps/Traps.h"

namespace Shapes::Native {
namespace {

/// A ball that has not moved in this step.
CBall Ball(const Vector2& p, float r, const Vector2& v = Vector2::Zero()) { return {p, p, v, r}; }

CPoint Point(const Vector2& p) { return CPoint(CPointDesc(p)); }
CLineSeg Seg(const Vector2& p0, const Vector2& p1, eSides sides = eSides::Both) {
  return CLineSeg(Sided(CLineSegDesc(p0, p1), sides));
}
CCircle Circle(float R) { return CCircle(CCircleDesc({0, 0}, R)); }
CArc Arc(float r, float degrees0, float degrees1, eSides sides = eSides::Both) {
  return CArc(Sided(CArcDesc({0, 0}, r, degrees0 * g_fPi / 180, degrees1 * g_fPi / 180), sides));
}

constexpr double g_fRoundings = 4 * g_fUlp;

bool Meets(const CBall& other, const CBall& ball, CHit& hit) { return CollideBallBall(other, ball, hit); }
bool Meets(const CShape& shape, const CBall& ball, CHit& hit) { return Collide(shape, ball, hit); }

/// Whether the ball meets it with exactly this normal, and with this setback and POI.
/// @param error  of the setback
template <class T>
testing::AssertionResult Hits(const T& shape, const CBall& ball, const Vector2& n, double setback,
                              double error = 0, const std::optional<Vector2>& poi = {}) {
  CHit hit;
  if (!Meets(shape, ball, hit)) return testing::AssertionFailure() << "no contact";
  if (hit.m_vNorm == n && std::abs(hit.m_fSetback - setback) <= error &&
      hit.m_vPOI == poi.value_or(hit.m_vPOI))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "n " << hit.m_vNorm.transpose() << ", setback " << hit.m_fSetback
                                     << ", POI " << hit.m_vPOI.transpose();
}

template <class T>
bool Misses(const T& shape, const CBall& ball) {
  CHit hit;
  return !Meets(shape, ball, hit);
}

const Vector2 g_vUp(0, 1), g_vDown(0, -1), g_vLeft(-1, 0), g_vRight(1, 0);

TEST(Collide, NanInPositionOrRadiusIsNoContact) {
  const CWithoutTraps onPurpose;
  const float d = g_fNan, r = 1;
  EXPECT_FALSE(d >= r); // the condition for a miss that lets NaN through
  const CPoint point = Point({0, 0});
  const CLineSeg seg = Seg({-1, 0}, {1, 0});
  const CCircle circle = Circle(1);
  const CArc full = Arc(1, 0, 0), arc = Arc(1, 0, 57);
  const CBall good = Ball({0, 0}, 1);
  CHit hit;
  for (const CBall& bad : {Ball({g_fNan, 0.1f}, 0.5f), Ball({0.9f, g_fNan}, 0.5f), Ball({0, 0.1f}, g_fNan)}) {
    for (const CShape* pShape : std::initializer_list<const CShape*>{&point, &seg, &circle, &full, &arc})
      EXPECT_TRUE(Misses(*pShape, bad)) << static_cast<int>(pShape->GetShapeType());
    EXPECT_TRUE(Misses(good, bad) && Misses(bad, good));
  }
  EXPECT_FALSE(CollidePt({g_fNan, 0}, Ball({0, 0.5f}, 1), hit));
  if (CollidePt({0, 0}, Ball({0, 0}, 1, {g_fNan, 0}), hit)) {
    EXPECT_TRUE(hit.m_vNorm.allFinite()); // of the velocity nothing gets there
  }
}

TEST(Collide, WhatOnlyTouchesIsNotMet) {
  EXPECT_TRUE(Misses(Point({0, 0}), Ball({3, 4}, 5)));
  EXPECT_FALSE(Misses(Point({0, 0}), Ball({3, 4}, std::nextafter(5.0f, 6.0f))));
  EXPECT_TRUE(Misses(Point({0, 0}), Ball({0, 0}, 0)));
  EXPECT_TRUE(Misses(Seg({-1, 0}, {1, 0}), Ball({0.25f, 0.5f}, 0.5f)));
  EXPECT_TRUE(Misses(Circle(1), Ball({1.5f, 0}, 0.5f)));
  EXPECT_TRUE(Misses(Arc(1, 350, 10), Ball({1.1f, 0}, 0.1f)));
  EXPECT_TRUE(Misses(Ball({0, 0}, 1), Ball({0, 2}, 1)));
}

TEST(CollidePointCircle, ACentreOnThePointGoesBackWhereItCameFrom) {
  const Vector2 p(0, 0);
  EXPECT_FALSE((p / p.norm()).allFinite()); // dividing by the distance
  EXPECT_TRUE(Hits(Point(p), Ball(p, 0.5f, g_vRight), g_vLeft, 0.5));
  EXPECT_TRUE(Hits(Point(p), Ball(p, 0.5f), g_vUp, 0.5));  // at rest
  EXPECT_TRUE(Hits(Circle(0), Ball(p, 0.5f), g_vUp, 0.5)); // a circle without extent is a point
}

TEST(CollideLineSegCircle, EndsAreOpen) {
  const CLineSeg seg = Seg({0, 0}, {1, 0});
  EXPECT_TRUE(Misses(seg, Ball({-0.3f, 0.1f}, 0.5f)) && Misses(seg, Ball({1.001f, 0.1f}, 0.5f)));
  EXPECT_FALSE(Misses(seg, Ball({0, 0.1f}, 0.5f))); // exactly above an end is above it
  EXPECT_FALSE(Misses(seg, Ball({1, 0.1f}, 0.5f)));
}

TEST(CollideLineSegCircle, OneWithoutLengthIsAPoint) {
  for (const Vector2& p : {Vector2(1, 1.4f), Vector2(0.6f, 1), Vector2(1.2f, 0.8f), Vector2(1, 1.5f)}) {
    CHit point;
    const bool met = CollidePt({1, 1}, Ball(p, 0.5f), point);
    if (met)
      EXPECT_TRUE(Hits(Seg({1, 1}, {1, 1}), Ball(p, 0.5f), point.m_vNorm, point.m_fSetback)) << p.transpose();
    else
      EXPECT_TRUE(Misses(Seg({1, 1}, {1, 1}), Ball(p, 0.5f))) << p.transpose();
  }
}

TEST(CollideLineSegCircle, ACentreOnTheSegmentGoesBackToTheSideItCameFrom) {
  const CLineSeg seg = Seg({-1, 0}, {1, 0});
  for (const float y : {1.0f, -1.0f}) {
    EXPECT_TRUE(Hits(seg, {{0, 0}, {-1, y}, {1, -y}, 0.5f}, {0, y}, 0.5)); // by where it was
    EXPECT_TRUE(Hits(seg, Ball({0, 0}, 0.5f, {1, -y}), {0, y}, 0.5));      // by where it goes
  }
  EXPECT_TRUE(Hits(seg, Ball({0, 0}, 0.5f), g_vUp, 0.5)); // at rest: the front
}

TEST(CollideLineSegCircle, OneSidedSegmentsLetTheOtherSideThrough) {
  const Vector2 a(-1, 0), b(1, 0);
  const CBall falling{{0, 0.1f}, {0, 0.6f}, {0, -5}, 0.5f}, rising{{0, -0.1f}, {0, -0.6f}, {0, 5}, 0.5f};
  // Giving the ends the other way round does not turn the front downward: they are put in order.
  for (const CLineSeg& seg : {Seg(a, b, eSides::Front), Seg(b, a, eSides::Front)}) {
    EXPECT_TRUE(Hits(seg, falling, g_vUp, 0.4, g_fRoundings));
    EXPECT_TRUE(Misses(seg, rising));
  }
  EXPECT_TRUE(Hits(Seg(a, b, eSides::Back), rising, g_vDown, 0.4, g_fRoundings));
  EXPECT_TRUE(Misses(Seg(a, b, eSides::Back), falling));
}

TEST(CollideLineSegCircle, AOneSidedSegmentPushesBackAcrossIfTheBallCameFromItsSolidSide) {
  const CLineSeg seg = Seg({-1, 0}, {1, 0}, eSides::Front);
  EXPECT_TRUE(Hits(seg, {{0, -0.2f}, {0, 0.6f}, {0, -48}, 0.5f}, g_vUp, 0.7, g_fRoundings));
  // On the way through from the open side it is let go until it is out.
  EXPECT_TRUE(Misses(seg, {{0, 0.2f}, {0, -0.1f}, {0, 5}, 0.5f}));
}

TEST(CollideCircleCircle, ACentreExactlyOnTheRingIsOnTheSideFromWhichItCame) {
  for (const float x : {1.0f, -1.0f}) {
    EXPECT_TRUE(Hits(Circle(1), {{1, 0}, {1 - 0.25f * x, 0}, {x, 0}, 0.5f}, {-x, 0}, 0.5));
    EXPECT_TRUE(Hits(Circle(1), Ball({1, 0}, 0.5f, {x, 0}), {-x, 0}, 0.5)); // placed there: by its velocity
  }
}

TEST(CollideCircleCircle, ABallThatDoesNotFitInsideIsOutside) {
  EXPECT_TRUE(Hits(Circle(1), Ball({0.5f, 0}, 1.5f), g_vRight, 2));
  EXPECT_TRUE(Hits(Circle(1), Ball({0, 0}, 1, {0, 3}), g_vDown, 2)); // against its velocity
  EXPECT_TRUE(Misses(Circle(2), Ball({0, 0}, 0.5f)));                // one that fits is free
}

TEST(CollideCircleArc, AShortArcIsMetOnItsSideOnly) {
  EXPECT_FALSE(Misses(CArc(CArcDesc({0, 0}, 1, 0, 1e-7f)), Ball({1.09f, 0}, 0.1f, g_vLeft)));
  EXPECT_TRUE(Misses(CArc(CArcDesc({1000, 1000}, 1, 0, 1e-5f)), Ball({998.95f, 1000}, 0.1f, g_vRight)));
}

TEST(CollideCircleArc, InsideABallIsFreeUnlessItFitsAndTouches) {
  EXPECT_TRUE(Misses(Arc(2, 0, 0), Ball({0, 0}, 0.5f)));
  EXPECT_TRUE(Misses(Arc(1, 0, 0), Ball({0, 0}, 1, g_vRight)));
  EXPECT_TRUE(Misses(Arc(1, 0, 0), Ball({0.3f, 0.2f}, 1.5f, g_vRight)));
}

// The figure in docs/conventions.md. CollideBoundsTest.cpp holds other places and velocities to the same
// rule.
TEST(CollideCircleArc, LetsGoOfABallInsideThatLeavesPastAnEnd) {
  const CArc arc = Arc(1, 0, 90);
  const Vector2 p(0.9f, 0.05f);
  EXPECT_FALSE(Misses(arc, Ball(p, 0.2f, {1, 2})));     // along the arc
  EXPECT_FALSE(Misses(arc, Ball(p, 0.2f, {2, -1})));    // off it, but more outward
  EXPECT_TRUE(Misses(arc, Ball(p, 0.2f, {1, -2})));     // past the end
  EXPECT_TRUE(Misses(arc, Ball(p, 0.2f, {-1, -0.1f}))); // inward
}

TEST(CollideCircleArc, LetsGoByTheVelocityRelativeToTheSurface) {
  const CKinematicArc arc(Turning(CArcDesc({0, 0}, 1, 0, g_fPi / 2), 1)); // its end 0 moves up at 2 pi
  EXPECT_TRUE(Misses(arc, Ball({0.9f, 0.05f}, 0.2f, {1, 2})));
  EXPECT_FALSE(Misses(arc, Ball({0.9f, 0.05f}, 0.2f, {1, 7})));
}

TEST(CollideCircleArc, ACentreOnTheArcGoesBackToTheSideItCameFrom) {
  for (const float x : {1.0f, -1.0f})
    EXPECT_TRUE(Hits(Arc(1, 300, 60), {{1, 0}, {1 + 0.2f * x, 0}, {-3 * x, 0}, 0.1f}, {x, 0}, Wide(0.1f)));
}

TEST(CollideBallBall, CoincidentCentresSeparateAgainstTheirRelativeVelocity) {
  EXPECT_TRUE(Hits(Ball({1, 1}, 0.5f, {3, 0}), Ball({1, 1}, 0.5f, {1, 0}), g_vRight, 1));
  EXPECT_TRUE(Hits(Ball({1, 1}, 0.5f), Ball({1, 1}, 0.5f), g_vUp, 1)); // at rest: a fixed axis
}

} // namespace
} // namespace Shapes::Native
