// SPDX-License-Identifier: MIT
// Balls that meet points, segments, circles, arcs and each other where a case has an answer of its own; and
// what overlaps at the beginning of a motion, against distances by closest points and angles. In between,
// SweepAgreementTest.cpp and FirstImpactTest.cpp hold the sweeps against references.
#include "Tolerances.h"

#include "ImpactTesting.h"

namespace Shapes::Geometry {
namespace {

CShapeGeometry PointAt(const Vector2& p) { return MakeShapeGeometry(CPoint(CPointDesc(p)), 0.0); }

TEST(ImpactPointCircle, FromExactlyOnThePointItGoesBackWhereItCameFrom) {
  CImpact impact;
  double depth = 0.0;
  const CShapeGeometry point = PointAt({1, 2});
  ASSERT_EQ(Sweep(point, {{1, 2}, {3, 0}, 0.5, 1.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_vNorm, Vector2d(-1, 0));
  ASSERT_TRUE(Overlap(point, {{1, 2}, {0, 0}, 0.5, 1.0}, 0.0, impact, depth));
  EXPECT_EQ(impact.m_vNorm, Vector2d(0, 1));
  EXPECT_EQ(depth, 0.5);
}

TEST(ImpactPointCircle, ABallWithoutRadiusMeetsWhatItFliesInto) {
  CImpact impact;
  const CShapeGeometry point = PointAt({1, 2});
  ASSERT_EQ(Sweep(point, {{-1, 2}, {4, 0}, 0.0, 1.0}, 0.0, impact), eSweep::Impact);
  EXPECT_NEAR(impact.m_fTime, 0.5, g_nSweepRoundings * 0x1p-52);
  EXPECT_EQ(impact.m_vNorm, Vector2d(-1, 0));
  EXPECT_EQ(Sweep(point, {{-1, 2.0 + 1e-12}, {4, 0}, 0.0, 1.0}, 0.0, impact), eSweep::None);
}

TEST(ImpactPointCircle, TheEndOfTheLegBelongsToIt) {
  CImpact impact;
  const CShapeGeometry point = PointAt({0, 0});
  ASSERT_EQ(Sweep(point, {{2, 0}, {-1, 0}, 0.5, 1.5}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 1.5);
  EXPECT_EQ(Sweep(point, {{2, 0}, {-1, 0}, 0.5, std::nextafter(1.5, 0.0)}, 0.0, impact), eSweep::None);
}

// A point flies into the face again and again, and stays on its side: whatever the rounding of where it is,
// it is met by the face that it has seen first.
TEST(ImpactLineSegCircle, ABallWithoutRadiusStaysOnItsSide) {
  ForEachCase(23, 5000, [&](CRandom& random, int) {
    const CShapeGeometry seg = RandomOutline(random, eShape::LineSeg, eSides::Both, false);
    const Vector2d foot = seg.m_vPt0 + random.Unit() * (seg.m_vPt1 - seg.m_vPt0);
    const Vector2d p = foot + seg.m_vFront * (0.1 + random.Unit());
    const CMotion motion{p, 2.0 * (foot - p), 0.0, 1.0};
    CImpact impact;
    ASSERT_EQ(Sweep(seg, motion, 0.0, impact), eSweep::Impact);
    ASSERT_GT(impact.m_vNorm.dot(seg.m_vFront), 0.99);
    const CMotion back{motion.m_vPos + motion.m_vVel * impact.m_fTime, -motion.m_vVel, 0.0, 1.0};
    ASSERT_EQ(Sweep(seg, back, 0.0, impact), eSweep::None);
    const CMotion again{back.m_vPos, motion.m_vVel, 0.0, 1.0};
    ASSERT_EQ(Sweep(seg, again, 0.0, impact), eSweep::Impact);
    ASSERT_LE(impact.m_fTime * again.m_vVel.norm(), GapBound({seg, again}));
    ASSERT_GT(impact.m_vNorm.dot(seg.m_vFront), 0.99);
  });
}

// A shape without an end is met at both faces as with it, and at the other end, also by what is deep in that.
void ExpectMetWithoutAnEnd(const CShapeGeometry& whole, const Vector2d& place, const Vector2d& away,
                           double r) {
  const Vector2d along = Perp(away); // at the place, to where end 0 is or end 1
  for (const bool isFirst : {true, false}) {
    CShapeGeometry without = whole;
    (isFirst ? without.m_bHasEnd0 : without.m_bHasEnd1) = false;
    for (const double side : {1.0, -1.0}) {
      const CMotion motion{place + side * (r + 0.1) * away, -side * away, r, 0.2};
      CImpact impact, expected;
      ASSERT_EQ(Sweep(whole, motion, 0.0, expected), eSweep::Impact);
      ASSERT_EQ(Sweep(without, motion, 0.0, impact), eSweep::Impact);
      EXPECT_NEAR(impact.m_fTime, expected.m_fTime, GapBound({whole, motion}));
      EXPECT_LT((impact.m_vNorm - expected.m_vNorm).norm(), 1e-9);
    }
    for (const bool toFirst : {true, false}) {
      const Vector2d& end = toFirst ? whole.m_vPt0 : whole.m_vPt1;
      const Vector2d out = along.dot(end - place) > 0.0 ? along : Vector2d(-along);
      for (const double gap : {0.01, -0.5 * r}) {
        const CMotion motion{end + (r + gap) * out, -out, r, 0.02};
        CImpact impact;
        ASSERT_EQ(Sweep(whole, motion, 0.0, impact), eSweep::Impact);
        EXPECT_EQ(Sweep(without, motion, 0.0, impact) == eSweep::Impact, toFirst != isFirst);
      }
    }
  }
}

TEST(ImpactLineSegCircle, WithoutAnEndItIsMetAtTheRest) {
  ForEachCase(27, 1000, [&](CRandom& random, int) {
    const CShapeGeometry seg = RandomOutline(random, eShape::LineSeg, eSides::Both, false);
    const Vector2d foot = seg.m_vPt0 + (0.1 + 0.8 * random.Unit()) * (seg.m_vPt1 - seg.m_vPt0);
    ExpectMetWithoutAnEnd(seg, foot, seg.m_vFront, 0.05 + random.Unit());
  });
}

TEST(ImpactCircleArc, WithoutAnEndItIsMetAtTheRest) {
  ForEachCase(28, 1000, [&](CRandom& random, int) {
    const float from = random.Uniform(0, 6), span = random.Uniform(0.5f, 1.5f), R = random.Uniform(2, 5);
    const CShapeGeometry arc = MakeShapeGeometry(CArc(CArcDesc(Vector2::Zero(), R, from, from + span)), 0.0);
    const auto middle = static_cast<double>(from + 0.5f * span);
    const Vector2d out(std::cos(middle), std::sin(middle));
    ExpectMetWithoutAnEnd(arc, static_cast<double>(R) * out, out, 0.05);
  });
}

// A ball that lies on a face slides off over the end, with no impact there whatever the rounding.
TEST(ImpactLineSegCircle, ABallSlidesOffOverTheEnd) {
  ForEachCase(25, 5000, [&](CRandom& random, int) {
    CShapeGeometry seg = RandomOutline(random, eShape::LineSeg, eSides::Both, false);
    const double r = 0.05 + random.Unit(), share = random.Unit();
    const Vector2d along = seg.m_vPt1 - seg.m_vPt0;
    const CMotion motion{seg.m_vPt0 + share * along + r * seg.m_vFront, 3.0 * along, r, 1.0};
    CImpact impact;
    EXPECT_EQ(Sweep(seg, motion, 0.0, impact), eSweep::None);
    seg.m_eSides = eSides::Front;
    ASSERT_EQ(Sweep(seg, motion, 0.0, impact), eSweep::None);
  });
}

// A place in floats may be in an end by a rounding, of one solid side too; deeper it has come from behind.
TEST(ImpactLineSegCircle, ABallLiesOnAnEndThatRoundingPutsItInto) {
  CShapeGeometry seg = MakeShapeGeometry(CLineSeg(CLineSegDesc({0, 0}, {1, 0})), 0.0);
  seg.m_eSides = eSides::Front;
  const auto lies = [&](double depth) {
    CImpact impact;
    double gap;
    return Near(seg, {(0.5 - depth) * Vector2d(-0.6, 0.8), {0, 0}, 0.5, 1.0}, 0.0, 1e-6, impact, gap);
  };
  EXPECT_TRUE(lies(2e-7));
  EXPECT_FALSE(lies(2e-6));
}

CShapeGeometry Ring(float R) { return MakeShapeGeometry(CCircle(CCircleDesc({0, 0}, R)), 0.0); }

// Head on, from outside and from inside, where nothing has to be rounded.
TEST(ImpactCircleCircle, ARingIsMetFromBothSides) {
  for (const double x : {5.0, 1.0}) {
    CImpact impact;
    ASSERT_EQ(Sweep(Ring(2), {{x, 0}, {-1, 0}, 0.5, 9.0}, 0.0, impact), eSweep::Impact);
    EXPECT_EQ(impact.m_fTime, 2.5);
    EXPECT_EQ(impact.m_vNorm, Vector2d(1, 0));
    EXPECT_EQ(impact.m_fCurve, 0.0);
  }
}

// The gap that opens at rate u closes again after 2 u / m_fCurve, as it does for small u.
TEST(ImpactCircleCircle, TheCurveTellsHowSoonABallComesBack) {
  const double R = 2.0, r = 0.5, speed = 3.0, u = 1e-3;
  CImpact impact, next;
  const CMotion along{{0, R - r}, {speed, -u}, r, 1.0};
  ASSERT_EQ(Sweep(Ring(2), along, 0.0, next), eSweep::Impact);
  ASSERT_EQ(Sweep(Ring(2), {along.m_vPos, {speed, u}, r, 1.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 0.0);
  EXPECT_EQ(impact.m_fCurve, speed * speed / (R - r));
  EXPECT_NEAR(next.m_fTime, 2.0 * u / impact.m_fCurve, 1e-6 * next.m_fTime);
}

// A ball that overlaps the ring from inside, and goes inward by less than it overlaps, is met where it begins
// to approach again.
TEST(ImpactCircleCircle, AnOverlappingBallIsNotLost) {
  ForEachCase(33, 5000, [&](CRandom& random, int) {
    const double r = 0.05 + 0.9 * random.Unit(), depth = r * 0.99 * random.Unit(), far = 1.0 - r + depth;
    const double angle = 6.28 * random.Unit(), inward = 1.57 * random.Unit();
    const Vector2d u(std::cos(angle), std::sin(angle));
    const CMotion motion{far * u, std::cos(inward) * Perp(u) - std::sin(inward) * u, r, 4.0};
    CImpact impact;
    ASSERT_EQ(Sweep(Ring(1), motion, 0.0, impact), eSweep::Impact);
    const Vector2d p = motion.m_vPos + motion.m_vVel * impact.m_fTime;
    const double closest = far * std::cos(inward); // of its way to the centre
    ASSERT_NEAR(p.norm(), std::max(1.0 - r, closest), 1e-7);
    ASSERT_GE(impact.m_vNorm.dot(u), -1.0);
    ASSERT_LE(impact.m_vNorm.dot(motion.m_vVel), 1e-7);
  });
}

// A ball in a ring, for a thousand bounces that keep its speed, never gets out.
TEST(ImpactCircleCircle, ABallInARingStaysThere) {
  const CShapeGeometry ring = Ring(1);
  ForEachCase(34, 50, [&](CRandom& random, int) {
    CMotion motion{random.InSquare(0.4f).cast<double>(), random.Direction().cast<double>(),
                   random.Coin() ? 0.3 : 0.0, 10.0};
    for (int k = 0; k < 1000; ++k) {
      CImpact impact;
      ASSERT_EQ(Sweep(ring, motion, 0.0, impact), eSweep::Impact);
      motion.m_vPos += motion.m_vVel * impact.m_fTime;
      motion.m_vVel -= 2.0 * motion.m_vVel.dot(impact.m_vNorm) * impact.m_vNorm;
      ASSERT_LE(motion.m_vPos.norm() + motion.m_fRadius, 1.0 + 1e-12);
    }
  });
}

// In a gap that is narrower than itself a ball touches both ends: each stops it, also where the other is
// nearer.
TEST(ImpactCircleArc, InANarrowGapBothEndsStopTheBall) {
  const CShapeGeometry c = MakeShapeGeometry(CArc(CArcDesc({0, 0}, 1, 0.25f, -0.25f)), 0.0);
  const double r = 0.5, half = std::sin(0.25), x = std::cos(0.25) + std::sqrt(r * r - half * half);
  for (const double y : {1.0, -1.0}) {
    CImpact impact;
    ASSERT_EQ(Sweep(c, {{x, 0}, {0, y}, r, 1.0}, 0.0, impact), eSweep::Impact);
    EXPECT_NEAR(impact.m_fTime, 0.0, 1e-6);
    EXPECT_LT(impact.m_vNorm.y() * y, 0.0);
  }
}

// Quarter turns have the same bits but for signs and places.
TEST(ImpactCircleArc, QuarterTurnsChangeNothing) {
  int hits = 0;
  ForEachCase(43, 5000, [&](CRandom& random, int) {
    const CTrial trial = RandomTrial(random, eShape::Arc, eSides::Both);
    CTrial turned = trial;
    for (Vector2d* v : {&turned.m_cShape.m_vCenter, &turned.m_cShape.m_vPt0, &turned.m_cShape.m_vPt1,
                        &turned.m_cMotion.m_vPos, &turned.m_cMotion.m_vVel})
      *v = Perp(*v);
    CImpact a, b;
    const eSweep found = Sweep(trial.m_cShape, trial.m_cMotion, 0.0, a);
    ASSERT_EQ(found, Sweep(turned.m_cShape, turned.m_cMotion, 0.0, b));
    if (found != eSweep::Impact) return;
    ++hits;
    ASSERT_EQ(a.m_fTime, b.m_fTime);
    ASSERT_EQ(Perp(a.m_vNorm), b.m_vNorm);
    ASSERT_EQ(a.m_fCurve, b.m_fCurve);
  });
  EXPECT_GT(hits, 1000);
}

TEST(ImpactBallBall, TheShorterLegEndsTheSearch) {
  CImpact impact;
  const CMotion other{{0, 0}, {0, 0}, 0.5, 1.0}, ball{{3, 0}, {-1, 0}, 0.5, 4.0};
  EXPECT_EQ(ImpactBallBall(other, ball, impact), eSweep::None);
  EXPECT_EQ(ImpactBallBall(ball, other, impact), eSweep::None);
  CMotion longer = other;
  longer.m_fDuration = 4.0;
  ASSERT_EQ(ImpactBallBall(longer, ball, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 2.0);
  EXPECT_EQ(impact.m_vNorm, Vector2d(1, 0));
}

TEST(ImpactBallBall, BallsAtOnePlaceGoBackWhereTheyCameFrom) {
  CImpact impact;
  double depth = 0.0;
  const CMotion other{{1, 1}, {0, 2}, 0.5, 1.0}, ball{{1, 1}, {0, -2}, 0.25, 1.0};
  ASSERT_EQ(ImpactBallBall(other, ball, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 0.0);
  EXPECT_EQ(impact.m_vNorm, Vector2d(0, 1));
  ASSERT_TRUE(OverlapBallBall(other, ball, impact, depth));
  EXPECT_EQ(depth, 0.75);
  EXPECT_EQ(impact.m_vNorm, Vector2d(0, 1));
  EXPECT_EQ(impact.m_vPOI, Vector2d(1, 1.5));
}

double Distance(const CShapeGeometry& o, const CMotion& motion, const Vector2d& p) {
  return static_cast<double>(MakeOracle(o, motion).DistanceOf(p, 0));
}

TEST(SweepOverlap, IsTheDistanceToWhatHasBothSides) {
  int overlaps = 0, none = 0;
  ForEachCase(70, 40000, [&](CRandom& random, int) {
    const bool turns = random.Coin();
    const CTrial trial = RandomTrial(random, g_eTypes[random.Below(4)], eSides::Both, turns);
    const CMotion& motion = trial.m_cMotion;
    const double start = turns ? random.Unit() : 0.0, r = motion.m_fRadius;
    const CShapeGeometry now = RotatedFor(trial.m_cShape, start);
    // From inside a ball that does not fit meets no more than the ends of an arc.
    if (now.m_eShapeType == eShape::Arc && r >= now.m_fRadius) return;
    const double distance = Distance(now, motion, motion.m_vPos), bound = GapBound(trial);
    CImpact impact;
    double depth = 0.0;
    const bool overlap = Overlap(trial.m_cShape, motion, start, impact, depth);
    if (std::abs(distance - r) > bound) {
      ASSERT_EQ(overlap, distance < r);
    }
    ++(overlap ? overlaps : none);
    if (!overlap) return;
    ASSERT_EQ(impact.m_fTime, 0.0);
    ASSERT_GT(depth, 0.0);
    ASSERT_NEAR(depth, r - distance, bound);
    ASSERT_NEAR(impact.m_vNorm.norm(), 1.0, 8.0 * 0x1p-52);
    ASSERT_LE(Distance(now, motion, impact.m_vPOI), bound);
    ASSERT_LE((motion.m_vPos + depth * impact.m_vNorm - impact.m_vPOI - r * impact.m_vNorm).norm(), bound);
  });
  EXPECT_GT(overlaps, 5000);
  EXPECT_GT(none, 5000);
}

// Of one side, the face on this side counts as before; the ends and the other side do not.
TEST(SweepOverlap, OneSidedShapesAreOverlappedOnTheirSolidSideOnly) {
  int both = 0, none = 0;
  ForEachCase(71, 40000, [&](CRandom& random, int) {
    const eSides sides = random.Coin() ? eSides::Front : eSides::Back;
    CTrial trial = RandomTrial(random, random.Coin() ? eShape::LineSeg : eShape::Arc, sides);
    const CShapeGeometry oneSided = trial.m_cShape;
    trial.m_cShape.m_eSides = eSides::Both;
    CImpact a, b;
    double depthA = 0.0, depthB = 0.0;
    const bool overlapOne = Overlap(oneSided, trial.m_cMotion, 0.0, a, depthA);
    const bool overlapBoth = Overlap(trial.m_cShape, trial.m_cMotion, 0.0, b, depthB);
    if (!overlapBoth) {
      ASSERT_FALSE(overlapOne);
      return;
    }
    const Vector2d& c = oneSided.m_vCenter;
    const Vector2d out =
        oneSided.m_eShapeType == eShape::LineSeg ? oneSided.m_vFront : Vector2d(b.m_vPOI - c);
    const double side = sides == eSides::Front ? 1.0 : -1.0;
    const double fromEnd = std::min((b.m_vPOI - oneSided.m_vPt0).norm(), (b.m_vPOI - oneSided.m_vPt1).norm());
    if (depthB < 1e-12 || (fromEnd < 1e-9 && fromEnd > 0.0)) return;
    const bool solid = fromEnd > 0.0 && side * b.m_vNorm.dot(out) > 0.0;
    if (fromEnd == 0.0 || std::abs(trial.m_cMotion.m_fRadius - depthB) > 1e-12) {
      ASSERT_EQ(overlapOne, solid);
    }
    ++(overlapOne ? both : none);
    if (!overlapOne) return;
    ASSERT_NEAR(depthA, depthB, 1e-14);
    ASSERT_LE((a.m_vNorm - b.m_vNorm).norm(), 1e-9);
  });
  EXPECT_GT(both, 2000);
  EXPECT_GT(none, 2000);
}

} // namespace
} // namespace Shapes::Geometry
