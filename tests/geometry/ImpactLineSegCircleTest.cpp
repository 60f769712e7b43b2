// SPDX-License-Identifier: MIT
#include "ImpactTesting.h"

#include <cmath>

namespace Shapes::Geometry {
namespace {

CShapeGeometry Floor(eSides sides = eSides::Both) {
  CLineSegDesc desc({-1, 0}, {1, 0});
  desc.m_eSides = sides;
  return MakeShapeGeometry(CLineSeg(desc), 0.0);
}

TEST(ImpactLineSegCircle, AgreesWith50Digits) {
  ExpectAgrees<CFifty>(eShape::LineSeg, eSides::Both, false, 20, 8000);
  ExpectAgrees<CFifty>(eShape::LineSeg, eSides::Front, false, 21, 4000);
  ExpectAgrees<CFifty>(eShape::LineSeg, eSides::Back, false, 22, 4000);
}

TEST(ImpactLineSegCircle, BothFacesAndTheRoundEndsAreMet) {
  CImpact impact;
  ASSERT_EQ(Sweep(Floor(), {{0.5, 2}, {0, -1}, 0.25, 2.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 1.75);
  EXPECT_EQ(impact.m_vNorm, Vector2d(0, 1));
  EXPECT_EQ(impact.m_vPOI, Vector2d(0.5, 0));
  ASSERT_EQ(Sweep(Floor(), {{0.5, -2}, {0, 1}, 0.25, 2.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_vNorm, Vector2d(0, -1));
  ASSERT_EQ(Sweep(Floor(), {{3, 0}, {-1, 0}, 0.25, 2.0}, 0.0, impact), eSweep::Impact);
  EXPECT_EQ(impact.m_fTime, 1.75);
  EXPECT_EQ(impact.m_vNorm, Vector2d(1, 0));
  EXPECT_EQ(Sweep(Floor(), {{3, 0.26}, {-1, 0}, 0.25, 10.0}, 0.0, impact), eSweep::None);
}

// The ball comes from the open side, by the face or by an end, and is met when it comes back.
TEST(ImpactLineSegCircle, AOneSidedSegmentIsOpenFromBehind) {
  CImpact impact;
  for (const double x : {0.5, 1.1}) {
    EXPECT_EQ(Sweep(Floor(eSides::Front), {{x, -2}, {0, 1}, 0.25, 9.0}, 0.0, impact), eSweep::None);
    EXPECT_EQ(Sweep(Floor(eSides::Front), {{x, 2}, {0, -1}, 0.25, 9.0}, 0.0, impact), eSweep::Impact);
    EXPECT_EQ(Sweep(Floor(eSides::Back), {{x, -2}, {0, 1}, 0.25, 9.0}, 0.0, impact), eSweep::Impact);
    EXPECT_EQ(Sweep(Floor(eSides::Back), {{x, 2}, {0, -1}, 0.25, 9.0}, 0.0, impact), eSweep::None);
  }
  // Half way through: the centre is behind, it goes back; the centre is in front, it goes on.
  EXPECT_EQ(Sweep(Floor(eSides::Front), {{0, -0.1}, {0, -1}, 0.25, 9.0}, 0.0, impact), eSweep::None);
  EXPECT_EQ(Sweep(Floor(eSides::Front), {{0, 0.1}, {0, 1}, 0.25, 9.0}, 0.0, impact), eSweep::None);
  EXPECT_EQ(Sweep(Floor(eSides::Front), {{0, 0.1}, {0, -1}, 0.25, 9.0}, 0.0, impact), eSweep::Impact);
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

// Swapped ends, and a mirror: the same bits, or those of the mirror.
TEST(ImpactLineSegCircle, EndsMayBeSwappedAndAllMirrored) {
  int hits = 0;
  ForEachCase(24, 5000, [&](CRandom& random, int) {
    const CTrial trial = RandomTrial(random, eShape::LineSeg, eSides::Both);
    CTrial mirrored = trial;
    for (Vector2d* v : {&mirrored.m_cShape.m_vCenter, &mirrored.m_cShape.m_vPt0, &mirrored.m_cShape.m_vPt1,
                        &mirrored.m_cShape.m_vFront, &mirrored.m_cMotion.m_vPos, &mirrored.m_cMotion.m_vVel})
      v->x() = -v->x();
    std::swap(mirrored.m_cShape.m_vPt0, mirrored.m_cShape.m_vPt1); // the front is to the left again
    CImpact a, b;
    ASSERT_EQ(Sweep(trial.m_cShape, trial.m_cMotion, 0.0, a),
              Sweep(mirrored.m_cShape, mirrored.m_cMotion, 0.0, b));
    if (!(a.m_fTime < trial.m_cMotion.m_fDuration)) return;
    ++hits;
    ASSERT_NEAR(a.m_fTime, b.m_fTime, GapBound(trial) / -a.m_vNorm.dot(trial.m_cMotion.m_vVel));
  });
  EXPECT_GT(hits, 1000);
}

} // namespace
} // namespace Shapes::Geometry
