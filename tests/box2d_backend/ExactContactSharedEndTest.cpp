// SPDX-License-Identifier: MIT
// Where a ball meets the geometry of a shape that goes on in another one, against the first of both.
#include <gtest/gtest.h>

#include <string>

#include "box2d_backend/ExactContactTesting.h"

namespace Shapes::Tests {
namespace {

constexpr double g_fMarchedJoint = 1e-11; // of the oracle, here where all sizes are about 1

/// A shape whose way leads to the origin, and its neighbour from there on. Curvature is to the left of the
/// way.
struct CJoined {
  CContactGeometry m_cShape, m_cNeighbour;

  /// @param turn  of the way at the origin, radians to the left; 0 is smooth
  CJoined(double bend, double nextBend, double heading, double turn) {
    const Vector2d u = UnitVector(heading), next = UnitVector(heading + turn);
    m_cShape = From(-u, -bend);
    m_cNeighbour = From(next, nextBend);
    CContactGeometry::CEnd& end =
        m_cShape.m_cEnd0.m_vPos.norm() < 1e-12 ? m_cShape.m_cEnd0 : m_cShape.m_cEnd1;
    end.m_bIsShared = true;
    end.m_vNext = next;
    end.m_fBend = nextBend;
  }

  CContactGeometry Unjoined() const {
    CContactGeometry o = m_cShape;
    o.m_cEnd0.m_bIsShared = o.m_cEnd1.m_bIsShared = false;
    return o;
  }
  double Distance(const Vector2d& p) const {
    return std::min(DistanceFrom(m_cShape, p), DistanceFrom(m_cNeighbour, p));
  }

private:
  // From the origin in the direction u: a segment of length 1, or a third of a circle.
  static CContactGeometry From(const Vector2d& u, double bend) {
    if (bend == 0) return MakeSegment({0, 0}, u);
    const double third = 2 * std::numbers::pi / 3;
    const Vector2d c = Perp(u) / bend;
    const double angle = std::atan2(-c.y(), -c.x());
    return MakeArcOutline(c, 1 / std::abs(bend), bend > 0 ? angle : angle - third, third);
  }
};

constexpr double g_fBends[] = {0, 1, -1, 0.3, -2};

struct CCounts {
  int m_nMet = 0, m_nOfNeighbour = 0, m_nWrong = 0, m_nInvented = 0;
};

/// Shots of balls of .05 to .2 that touch one of the two within .1 of where they join. Wrong: what comes
/// first is not what was found. Invented: neither of the two is touched by then.
/// @param isTheirs  whether what the neighbour meets first counts
CCounts Shoot(double turn, bool isJoined, bool isTheirs) {
  CRandom random(62);
  CCounts counts;
  for (const double bend : g_fBends)
    for (const double nextBend : g_fBends)
      for (int k = 0; k < 300; ++k) {
        const CJoined joined(bend, nextBend, 2 * std::numbers::pi * random.Unit(), turn);
        const CContactGeometry o = isJoined ? joined.m_cShape : joined.Unjoined();
        const double r = 0.05 + 0.15 * random.Unit();
        const Vector2d at = random.VectorOfLength(0, 0.1f).cast<double>();
        const Vector2d w = random.Vector(-2, 5).cast<double>(), u = w.normalized();
        const Vector2d q = at - (r + 0.1) * u;
        const auto distance = [&](const Vector2d& p) { return joined.Distance(p); };
        if (distance(q) < r) continue;
        const auto first = MarchToContact(distance, q, w, r, 0.5, 1e-14);
        if (!first) continue;
        // From a little before, as an engine does.
        const Vector2d from = q + *first * w - 0.02 * random.Unit() * u, there = q + *first * w;
        const double exact = (there - from).norm() / w.norm();
        const bool ofNeighbour =
            DistanceFrom(joined.m_cNeighbour, there) < DistanceFrom(joined.m_cShape, there);
        const Vector2d n = GradientAt(ofNeighbour ? joined.m_cNeighbour : joined.m_cShape, there);
        const double cosine = -n.dot(u);
        if (cosine < 0.05 || (ofNeighbour && !isTheirs)) continue;
        const CExactContact met = FindExactContact(o, from, w, r);
        ++counts.m_nMet;
        counts.m_nOfNeighbour += ofNeighbour;
        counts.m_nWrong += (met.m_vNorm - n).norm() > g_fMarchedJoint / cosine / r ||
                           std::abs(met.m_fTime - exact) * w.norm() > g_fMarchedJoint / cosine;
        const Vector2d p = from + met.m_fTime * w;
        const double own = std::abs(DistanceFrom(o, p) - r),
                     theirs = std::abs(DistanceFrom(joined.m_cNeighbour, p) - r);
        if (w.dot(met.m_vNorm) < 0 && !met.m_bMisses)
          counts.m_nInvented += std::min(own, theirs) > 1e-14 && met.m_fTime * w.norm() < 0.1;
      }
  return counts;
}

TEST(TrueContactJointTest, ASmoothJointIsNotFelt) {
  const CCounts counts = Shoot(0, true, true);
  EXPECT_GT(counts.m_nMet, 4000);
  EXPECT_GT(counts.m_nOfNeighbour, 1000);
  EXPECT_EQ(counts.m_nWrong, 0);
  EXPECT_EQ(counts.m_nInvented, 0);
}

TEST(TrueContactJointTest, AnEndThatIsNotJoinedIs) { // the control
  EXPECT_GT(Shoot(0, false, true).m_nWrong, 500);
}

TEST(TrueContactJointTest, AtACornerEachMeetsItsOwn) {
  for (const double turn : {-2.0, -1.2, -0.5, -0.1, 0.1, 0.5, 1.2, 2.0}) {
    SCOPED_TRACE(turn);
    const CCounts counts = Shoot(turn, true, false);
    EXPECT_GT(counts.m_nMet, 1000);
    EXPECT_EQ(counts.m_nWrong, 0);
    EXPECT_EQ(counts.m_nInvented, 0);
  }
}

TEST(TrueContactJointTest, TheNormalTurnsSteadilyOverAJoint) {
  // Balls side by side that come down at 30 degrees on two segments that are a flat roof or a flat valley.
  // Between the two faces of the roof is the end, on which the normal turns by the step over r.
  const double r = 0.1, step = 1e-4;
  const Vector2d w(0.5, -1);
  for (const double turn : {-0.3, 0.0}) {
    const CJoined joined(0, 0, 0, turn);
    Vector2d last(0, 1);
    for (double x = -0.3; x < 0.3; x += step) {
      const Vector2d q(x, 0.12);
      const CExactContact met = FindExactContact(joined.m_cShape, q, w, r);
      ASSERT_LE((met.m_vNorm - last).norm(), 2 * step / r) << turn << ", " << x;
      last = met.m_vNorm;
    }
    EXPECT_LE((last - Perp(UnitVector(turn))).norm(), 1e-15);
  }
}

} // namespace
} // namespace Shapes::Tests
