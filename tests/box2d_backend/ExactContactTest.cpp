// SPDX-License-Identifier: MIT
// Where a ball meets the geometry of one shape, or of one that goes on in another, against an oracle that
// knows distances only: its way is found by conservative steps, without any root.
#include "box2d_backend/contact/ExactContact.h"

#include "Box2DTesting.h"

namespace Shapes::Tests {
namespace {

using Box2D::CContactGeometry;
using Box2D::CExactContact;
using Box2D::FindExactContact;

CContactGeometry MakeDisk(const Vector2d& c, double R) { return {.m_vCentre = c, .m_fRadius = R}; }

CContactGeometry MakeSegment(const Vector2d& p0, const Vector2d& p1) {
  const Vector2d u = (p1 - p0).normalized();
  return {.m_eKind = CContactGeometry::eKind::LineSeg,
          .m_vCentre = 0.5 * (p0 + p1),
          .m_cEnd0 = {.m_vPos = p0, .m_vOut = -u},
          .m_cEnd1 = {.m_vPos = p1, .m_vOut = u}};
}

/// @param span  counterclockwise from the angle a0, radians; 2 pi is the full circle
CContactGeometry MakeArcOutline(const Vector2d& c, double R, double a0, double span) {
  const Vector2d u0 = UnitVector(a0), u1 = UnitVector(a0 + span);
  return {.m_eKind = CContactGeometry::eKind::Arc,
          .m_vCentre = c,
          .m_fRadius = R,
          .m_bFull = span >= 2 * std::numbers::pi,
          .m_bLong = span > std::numbers::pi,
          .m_cEnd0 = {.m_vPos = c + R * u0, .m_vOut = -Perp(u0)},
          .m_cEnd1 = {.m_vPos = c + R * u1, .m_vOut = Perp(u1)}};
}

/// The point of a geometry that is nearest to p. By angles, not by cross products. Disks are solid; the
/// nearest point of one is on its rim.
Vector2d NearestPt(const CContactGeometry& o, const Vector2d& p) {
  const Vector2d &p0 = o.m_cEnd0.m_vPos, &p1 = o.m_cEnd1.m_vPos;
  if (o.m_eKind == CContactGeometry::eKind::LineSeg) {
    const Vector2d way = p1 - p0;
    return p0 + std::clamp((p - p0).dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }
  const Vector2d d = p - o.m_vCentre;
  if (o.m_eKind == CContactGeometry::eKind::Arc && !o.m_bFull) {
    const auto angle = [&](const Vector2d& v) { // counterclockwise from end 0
      const Vector2d u0 = p0 - o.m_vCentre;
      const double a = std::atan2(Cross(u0, v), u0.dot(v));
      return a < 0 ? a + 2 * std::numbers::pi : a;
    };
    if (angle(d) > angle(p1 - o.m_vCentre)) return (p - p0).norm() < (p - p1).norm() ? p0 : p1;
  }
  return o.m_vCentre + o.m_fRadius * (d.norm() > 0 ? Vector2d(d.normalized()) : Vector2d(0, 1));
}

/// Below 0 within a disk.
double DistanceFrom(const CContactGeometry& o, const Vector2d& p) {
  if (o.m_eKind == CContactGeometry::eKind::Disk) return (p - o.m_vCentre).norm() - o.m_fRadius;
  return (p - NearestPt(o, p)).norm();
}

/// When a ball that is clear of all outlines first touches one of them, or when one that overlaps one began
/// to do so: on its way no distance changes faster than the ball moves. Never later than it is, and earlier
/// by what the tolerance is on the way there. Where the ball only grazes, and does so for long, steps get a
/// least length, which may pass over an overlap of 1e-10 of the radius of the smaller circle.
/// @param most  longest way that is looked at, metres
/// @return none if there is nothing within that
template <class TDistance>
std::optional<double> MarchToContact(TDistance distance, const Vector2d& q, const Vector2d& w, double r,
                                     double most, double tolerance) {
  const double sign = distance(q) < r ? -1 : 1;
  const Vector2d u = sign * w.normalized();
  double s = 0;
  for (int i = 0; s <= most; ++i) {
    const double free = sign * (distance(q + s * u) - r);
    if (free <= tolerance) return sign * s / w.norm();
    s += i < 4000 ? free : std::max(free, 1e-5 * r);
  }
  return {};
}

/// The unit vector from the nearest point of a geometry to p. @param p not the centre of a disk
Vector2d GradientAt(const CContactGeometry& o, const Vector2d& p) {
  const Vector2d& from = o.m_eKind == CContactGeometry::eKind::Disk ? o.m_vCentre : NearestPt(o, p);
  return (p - from).normalized();
}

// A normal that is given is compared with that of a place, which errs by as much.
constexpr double g_fSlack = 4;
constexpr double g_fExactContactError = 0x1p-50; // a few roundings in double

/// A ball near a geometry that goes there, or not.
struct CApproach {
  CContactGeometry m_cGeometry;
  Vector2d m_vPos, m_vVel;
  double m_fRadius;
  double m_fSmallest; // what near is measured by

  double Distance(const Vector2d& p) const { return DistanceFrom(m_cGeometry, p); }
  double Gap() const { return Distance(m_vPos) - m_fRadius; }
  Vector2d At(double t) const { return m_vPos + t * m_vVel; }
  /// Errors are relative to this: see FindExactContact.
  double Size() const {
    const CContactGeometry& o = m_cGeometry;
    return m_vPos.norm() + o.m_vCentre.norm() + o.m_fRadius + m_fRadius + o.m_cEnd0.m_vPos.norm() +
           o.m_cEnd1.m_vPos.norm();
  }
  /// The largest errors, by the documented bound and the slack.
  double PlaceBound() const { return g_fSlack * g_fExactContactError * Size(); }
  double NormalBound() const { return PlaceBound() / m_fSmallest; }
  Vector2d NormalAt(const Vector2d& p) const { return GradientAt(m_cGeometry, p); }
  CExactContact Find() const { return FindExactContact(m_cGeometry, m_vPos, m_vVel, m_fRadius); }
  std::optional<double> March(double most) const {
    const auto distance = [this](const Vector2d& p) { return Distance(p); };
    return MarchToContact(distance, m_vPos, m_vVel, m_fRadius, most, 1e-13 * Size());
  }
};

enum class eOutline { Point, Disk, LineSeg, Arc, Ring };
constexpr eOutline g_eAll[] = {eOutline::Point, eOutline::Disk, eOutline::LineSeg, eOutline::Arc,
                               eOutline::Ring};

/// Sizes from 1/16 to 32, anywhere on the geometry and a little past its ends, in any direction, from an
/// overlap of a tenth up to half of the smallest size away. Some graze it, some pass beside it.
CApproach MakeApproach(CRandom& random, eOutline kind) {
  CApproach a;
  const double r = random.Scale(-4, 1), R = kind == eOutline::Point ? 0 : random.Scale(-4, 4);
  const Vector2d c = Wide(random.InSquare(10));
  const double along = 1.3 * random.Unit() - 0.15; // of the length; beyond 0 and 1 around the ends
  const Vector2d u = Wide(random.Direction());
  const double turn = 2 * std::numbers::pi, a0 = turn * random.Unit(), span = turn * random.Unit();
  Vector2d at = c + R * u, n = u;
  a.m_fSmallest = r;
  if (kind == eOutline::LineSeg) {
    const Vector2d way = Wide(random.Vector(-3, 4));
    a.m_cGeometry = MakeSegment(c, c + way);
    a.m_fSmallest = std::min(r, way.norm());
    at = c + std::clamp(along, 0.0, 1.0) * way;
    if (along >= 0 && along <= 1) n = (random.Coin() ? 1 : -1) * Perp(way.normalized());
  } else if (kind == eOutline::Arc || kind == eOutline::Ring) {
    a.m_cGeometry = MakeArcOutline(c, R, a0, kind == eOutline::Ring ? turn : span);
    a.m_fSmallest = std::min({r, R, std::abs(R - r)});
    const double angle = a0 + std::clamp(along, 0.0, 1.0) * (kind == eOutline::Ring ? turn : span);
    at = c + R * UnitVector(angle);
    if (kind == eOutline::Ring || (along >= 0 && along <= 1))
      n = (random.Coin() ? 1 : -1) * UnitVector(angle);
  } else {
    a.m_cGeometry = MakeDisk(c, R);
  }
  a.m_fRadius = r;
  a.m_vVel = Wide(random.Vector(-3, 6));
  const bool grazes = random.Below(8) == 0, passes = random.Below(4) == 0;
  if (grazes) a.m_vVel = a.m_vVel.norm() * (Perp(n) + random.SignedScale(-30, -6) * n);
  a.m_vPos = at + r * n - a.m_fSmallest * (0.6 * random.Unit() - 0.1) * a.m_vVel.normalized();
  if (passes) a.m_vPos += 0.3 * a.m_fSmallest * random.Unit() * n;
  return a;
}

constexpr std::uint64_t g_nTrueContactSeed = 61;
// The oracle stops 1e-13 of all sizes away from what it touches.
constexpr double g_fMarched = 4e-13;

/// Calls f for a number of random approaches that are near, on the given side of touching.
template <class F>
void ForEach(eOutline kind, bool clear, int count, F f) {
  CRandom random(g_nTrueContactSeed);
  for (int k = 0; k < count && !testing::Test::HasFailure();) { // one is enough
    const CApproach a = MakeApproach(random, kind);
    const double gap = clear ? a.Gap() : -a.Gap();
    if (gap < 1e-9 * a.Size() || gap > (clear ? 0.25 : 0.05) * a.m_fSmallest) continue;
    SCOPED_TRACE(testing::Message() << "seed " << g_nTrueContactSeed << ", case " << k);
    f(a), ++k;
  }
}

void ExpectTouch(const CApproach& a, const CExactContact& met) {
  const Vector2d p = a.At(met.m_fTime);
  EXPECT_NEAR(a.Distance(p), a.m_fRadius, a.PlaceBound());
  EXPECT_LE((met.m_vNorm - a.NormalAt(p)).norm(), a.NormalBound());
}

TEST(TrueContactTest, AClearBallMeetsWhatIsFirstOnItsWay) {
  for (const eOutline kind : g_eAll) {
    SCOPED_TRACE(static_cast<int>(kind));
    int touched = 0, grazed = 0, missed = 0;
    ForEach(kind, true, 4000, [&](const CApproach& a) {
      const CExactContact met = a.Find();
      const double speed = a.m_vVel.norm(), most = 0.5 * a.m_fSmallest;
      EXPECT_NEAR(met.m_fGap, a.Gap(), a.PlaceBound());
      EXPECT_NEAR(met.m_vNorm.norm(), 1, 1e-15);
      const double cosine = -met.m_vNorm.dot(a.m_vVel) / speed;
      const auto exact = a.March(most);
      if (exact && *exact * speed > 0.99 * most) return; // about to be not near any more
      if (!exact) {
        // Nothing is answered but grazing, or later.
        EXPECT_TRUE(cosine <= 1e-4 || met.m_fTime * speed >= 0.99 * most) << cosine << ", " << met.m_fTime;
        missed += met.m_bMisses;
        return;
      }
      if (met.m_bMisses) { // may be where the oracle sees a touch within its tolerance
        EXPECT_LE(std::abs(a.NormalAt(a.At(*exact)).dot(a.m_vVel)) / speed, 1e-4);
        return;
      }
      ExpectTouch(a, met);
      ++touched;
      grazed += cosine < 0.01;
      if (cosine < 0.01) return; // the oracle cannot tell when
      EXPECT_NEAR(met.m_fTime * speed * cosine, *exact * speed * cosine, g_fMarched * a.Size());
    });
    EXPECT_GT(touched, 1000);
    EXPECT_GT(grazed, 2);
    EXPECT_GT(missed, kind == eOutline::Ring ? -1 : 20);
  }
}

TEST(TrueContactTest, ABallThatHasComeTooFarIsTracedBack) {
  for (const eOutline kind : g_eAll) {
    SCOPED_TRACE(static_cast<int>(kind));
    int traced = 0, bare = 0, deeper = 0, turned = 0;
    ForEach(kind, false, 3000, [&](const CApproach& a) {
      const CExactContact met = a.Find();
      EXPECT_NEAR(met.m_fGap, a.Gap(), a.PlaceBound());
      const Vector2d now = a.NormalAt(a.m_vPos);
      if (met.m_fTime == 0) {
        EXPECT_LE((met.m_vNorm - now).norm(), a.NormalBound());
        bare += now.dot(a.m_vVel) < 0; // past an end
        return;
      }
      EXPECT_LT(met.m_vNorm.dot(a.m_vVel), 0);
      turned += met.m_fTime < 0 && (met.m_vNorm - now).norm() > 0.01;
      const double speed = a.m_vVel.norm(), cosine = -met.m_vNorm.dot(a.m_vVel) / speed;
      if (met.m_fTime * speed > 0.5 * a.m_fSmallest) return; // it will meet something else far ahead
      const Vector2d between = a.m_cGeometry.m_cEnd1.m_vPos - a.m_cGeometry.m_cEnd0.m_vPos;
      if (kind == eOutline::Arc && between.norm() < 2 * a.m_fRadius) return; // may touch both ends at once
      const bool isDeeper = a.Distance(a.At(met.m_fTime)) < a.m_fRadius - 1e-9 * a.Size();
      deeper += isDeeper; // came out of an end, but along an arc
      if (isDeeper) return;
      ExpectTouch(a, met);
      const auto exact = a.March(a.m_fSmallest);
      if (met.m_fTime > 0 || !exact || cosine < 0.01) return;
      EXPECT_NEAR(met.m_fTime * speed * cosine, *exact * speed * cosine, g_fMarched * a.Size());
      ++traced;
    });
    EXPECT_GT(traced, 300);
    EXPECT_GT(turned, 50); // the control: the normal of now is another one
    EXPECT_LE(bare, 25);
    EXPECT_LE(deeper, kind == eOutline::Arc ? 5 : 0);
  }
}

TEST(TrueContactTest, WithoutVelocityItIsTheDistance) {
  for (const eOutline kind : g_eAll)
    for (const bool clear : {true, false})
      ForEach(kind, clear, 1000, [&](CApproach a) {
        a.m_vVel.setZero();
        const CExactContact met = a.Find();
        EXPECT_EQ(met.m_fTime, 0);
        EXPECT_FALSE(met.m_bMisses);
        EXPECT_NEAR(met.m_fGap, a.Gap(), a.PlaceBound());
        EXPECT_LE((met.m_vNorm - a.NormalAt(a.m_vPos)).norm(), a.NormalBound());
      });
}

TEST(TrueContactTest, WhereThereIsNoDirectionItIsAgainstTheVelocityOrUp) {
  for (const CContactGeometry& o : {MakeDisk({1, 2}, 0), MakeDisk({1, 2}, 0.5)}) {
    const CExactContact met = FindExactContact(o, {1, 2}, {3, -4}, 0.1);
    EXPECT_LE((met.m_vNorm - Vector2d(-0.6, 0.8)).norm(), 1e-15);
    EXPECT_EQ(met.m_fGap, -0.1 - o.m_fRadius);
    EXPECT_EQ(FindExactContact(o, {1, 2}, {0, 0}, 0.1).m_vNorm, Vector2d(0, 1));
  }
  const CExactContact met = FindExactContact(MakeArcOutline({1, 2}, 1, 0, 7), {1, 2}, {3, -4}, 0.9);
  EXPECT_LE((met.m_vNorm - Vector2d(-0.6, 0.8)).norm(), 1e-15);
  EXPECT_NEAR(met.m_fGap, 0.1, 1e-15);
}

TEST(TrueContactTest, PowersOfTwoAndQuarterTurnsChangeNoBit) {
  for (const eOutline kind : g_eAll)
    ForEach(kind, true, 1000, [&](const CApproach& a) {
      const CExactContact met = a.Find();
      for (const auto& [scale, isTurned] : {std::pair(0x1p-20, false), {0x1p30, false}, {1.0, true}}) {
        SCOPED_TRACE(testing::Message() << "times " << scale << (isTurned ? ", turned" : ""));
        const auto turn = [turns = isTurned](const Vector2d& v) { return turns ? Perp(v) : v; };
        CApproach b = a;
        CContactGeometry& o = b.m_cGeometry;
        for (Vector2d* pV : {&b.m_vPos, &b.m_vVel, &o.m_vCentre, &o.m_cEnd0.m_vPos, &o.m_cEnd1.m_vPos})
          *pV = scale * turn(*pV);
        for (CContactGeometry::CEnd* pEnd : {&o.m_cEnd0, &o.m_cEnd1})
          pEnd->m_vOut = turn(pEnd->m_vOut);
        b.m_fRadius *= scale, o.m_fRadius *= scale;
        EXPECT_EQ(b.Find().m_vNorm, turn(met.m_vNorm));
        EXPECT_EQ(b.Find().m_fTime, met.m_fTime);
        EXPECT_EQ(b.Find().m_fGap, scale * met.m_fGap);
        b = a;
        b.m_vVel *= scale; // faster, and as much sooner
        EXPECT_EQ(b.Find().m_vNorm, met.m_vNorm);
        EXPECT_EQ(b.Find().m_fTime * scale, met.m_fTime);
      }
    });
}

constexpr double g_fMarchedJoint = 1e-11; // of the oracle, here where all sizes are about 1

/// A shape whose way leads to the origin, and its neighbour from there on. Curvature is to the left of the
/// way.
struct CJoined {
  CContactGeometry m_cShape, m_cNeighbour;

  /// @param turn  of the way at the origin, radians to the left; 0 is smooth
  CJoined(double bend, double nextBend, double heading, double turn, bool isJoined = true) {
    const Vector2d next = UnitVector(heading + turn);
    m_cShape = From(-UnitVector(heading), -bend);
    m_cNeighbour = From(next, nextBend);
    auto& end = m_cShape.m_cEnd0.m_vPos.norm() < 1e-12 ? m_cShape.m_cEnd0 : m_cShape.m_cEnd1;
    end = {end.m_vPos, end.m_vOut, isJoined, next, nextBend};
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
        const CJoined joined(bend, nextBend, 2 * std::numbers::pi * random.Unit(), turn, isJoined);
        const CContactGeometry &o = joined.m_cShape, &neighbour = joined.m_cNeighbour;
        const double r = 0.05 + 0.15 * random.Unit();
        const Vector2d at = Wide(random.VectorOfLength(0, 0.1f));
        const Vector2d w = Wide(random.Vector(-2, 5)), u = w.normalized();
        const Vector2d q = at - (r + 0.1) * u;
        const auto distance = [&](const Vector2d& p) { return joined.Distance(p); };
        if (distance(q) < r) continue;
        const auto first = MarchToContact(distance, q, w, r, 0.5, 1e-14);
        if (!first) continue;
        // From a little before, as an engine does.
        const Vector2d from = q + *first * w - 0.02 * random.Unit() * u, there = q + *first * w;
        const double exact = (there - from).norm() / w.norm();
        const bool ofNeighbour = DistanceFrom(neighbour, there) < DistanceFrom(o, there);
        const Vector2d n = GradientAt(ofNeighbour ? neighbour : o, there);
        const double cosine = -n.dot(u);
        if (cosine < 0.05 || (ofNeighbour && !isTheirs)) continue;
        const CExactContact met = FindExactContact(o, from, w, r);
        ++counts.m_nMet;
        counts.m_nOfNeighbour += ofNeighbour;
        counts.m_nWrong += (met.m_vNorm - n).norm() > g_fMarchedJoint / cosine / r ||
                           std::abs(met.m_fTime - exact) * w.norm() > g_fMarchedJoint / cosine;
        const Vector2d p = from + met.m_fTime * w;
        const double off =
            std::min(std::abs(DistanceFrom(o, p) - r), std::abs(DistanceFrom(neighbour, p) - r));
        counts.m_nInvented +=
            w.dot(met.m_vNorm) < 0 && !met.m_bMisses && off > 1e-14 && met.m_fTime * w.norm() < 0.1;
      }
  return counts;
}

TEST(TrueContactJointTest, ASmoothJointIsNotFelt) {
  const CCounts counts = Shoot(0, true, true);
  EXPECT_GT(counts.m_nMet, 4000);
  EXPECT_GT(counts.m_nOfNeighbour, 1000);
  EXPECT_EQ(counts.m_nWrong, 0);
  EXPECT_EQ(counts.m_nInvented, 0);
  EXPECT_GT(Shoot(0, false, true).m_nWrong, 500); // the control: an end that is not joined
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

} // namespace
} // namespace Shapes::Tests
