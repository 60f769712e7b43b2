// SPDX-License-Identifier: MIT
// What overlaps at the beginning of a motion, against distances by closest points and angles.
#include "ImpactTesting.h"

namespace Shapes::Geometry {
namespace {

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
