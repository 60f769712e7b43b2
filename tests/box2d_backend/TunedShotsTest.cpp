// SPDX-License-Identifier: MIT
// Where and how a tuned world bounces a ball off shapes that do not move: faces, arcs, their ends and where
// they join, by shots whose exact way is known. Each has a control that the shipped profile fails.
#include "TunedTesting.h"

namespace Shapes::Tests {
namespace {

/// Of 1,000 shots at the ends of an arc of radius 1, r = .1, up to 85 degrees from the normal and 90 m/s.
int CountWrongAtEnds(const CTuning& tuning, double degrees) {
  CRandom random(67);
  CRange range(MakeBox2D(tuning), {CArcDesc({0, 0}, 1, 0, static_cast<float>(degrees * g_fDegree))}, 0.1f);
  const auto aim = [&] {
    const Vector2d end = UnitVector(random.Coin() ? degrees * g_fDegree : 0);
    const Vector2d n = UnitVector(360 * g_fDegree * random.Unit());
    const double incidence = EitherSign(random, 85 * g_fDegree), phase = random.Unit();
    return CAim{end, n, incidence, 1 + 89 * random.Unit(), phase, 3};
  };
  return range.CountWrong(1000, aim, 0.5);
}

TEST(TunedArcEndTest, NakedEndsAreRound) {
  for (const double degrees : {90, 180, 270, 340}) {
    SCOPED_TRACE(degrees);
    EXPECT_EQ(CountWrongAtEnds(g_cTuned, degrees), 0);
    EXPECT_GT(CountWrongAtEnds(g_cShipped, degrees), 100); // the control
  }
}

// Where two shapes join: a tuned world does not feel a smooth joint, and knows where a corner is.

Vector2d Turned(const Vector2d& v, double angle) {
  return v.x() * UnitVector(angle) + v.y() * Perp(UnitVector(angle));
}

/// Two segments or arcs that join smoothly at the origin, where their tangent has the direction `m_fTurn`.
/// Curvature 0 is a segment; to the left is positive.
struct CTwoCurves {
  double m_fCurvature0, m_fCurvature1; // before and after the origin
  double m_fTurn;

  double CurvatureAt(double s) const { return s < 0 ? m_fCurvature0 : m_fCurvature1; }
  /// The point at length s, and the unit normal there, to the left.
  Vector2d Pt(double s) const {
    const double k = CurvatureAt(s);
    return Turned(k == 0 ? Vector2d(s, 0) : Vector2d(std::sin(k * s) / k, (1 - std::cos(k * s)) / k),
                  m_fTurn);
  }
  Vector2d Norm(double s) const { return Perp(UnitVector(m_fTurn + CurvatureAt(s) * s)); }

  /// One of the two shapes: of length 1, or a quarter of a turn.
  CAnyShapeDesc Shape(double k, bool after) const {
    if (k == 0) return CLineSegDesc(Vector2::Zero(), Turned({after ? 1 : -1, 0}, m_fTurn).cast<float>());
    const double joint = m_fTurn + (k > 0 ? -90 : 90) * g_fDegree; // seen from the centre
    const double first = (k > 0) == after ? joint : joint - 90 * g_fDegree;
    return CArcDesc(Turned({0, 1 / k}, m_fTurn).cast<float>(), static_cast<float>(1 / std::abs(k)),
                    static_cast<float>(first), static_cast<float>(first + 90 * g_fDegree));
  }
};

/// Of 2,000 shots of 1 to 20 m/s, up to 85 degrees from the normal, within .15 of the joint. Nothing is
/// explained on segments: their normal is the same everywhere.
int CountWrong(const CTuning& tuning, double curvature0, double curvature1, bool left) {
  CRandom random(42);
  int wrong = 0;
  for (int table = 0; table < 10; ++table) { // half of the shots at axially aligned shapes
    const CTwoCurves joint{curvature0, curvature1, table < 5 ? 0 : 360 * g_fDegree * random.Unit()};
    CRange range(MakeBox2D(tuning), {joint.Shape(curvature0, false), joint.Shape(curvature1, true)}, 0.1f);
    wrong += range.CountWrong(200, [&] {
      const double s = EitherSign(random, 0.15), incidence = EitherSign(random, 85 * g_fDegree);
      const double speed = 1 + 19 * random.Unit();
      return CAim{joint.Pt(s), (left ? 1 : -1) * joint.Norm(s), incidence, speed, random.Unit()};
    });
  }
  return wrong;
}

TEST(TunedJointTest, ASmoothJointIsNotFelt) {
  // A segment, an arc, a narrower one, and the other way round to an s.
  for (const auto& [before, after] : {std::pair(0, 0), std::pair(0, 1), std::pair(1, 2), std::pair(1, -1)})
    for (const bool left : {true, false}) {
      if (after < 0 && !left) continue; // the same by symmetry
      SCOPED_TRACE(testing::Message() << before << " into " << after << (left ? ", left" : ", right"));
      EXPECT_EQ(CountWrong(g_cTuned, before, after, left), 0);
      if (!left && after == 0) continue;                           // two segments are alike from both sides
      EXPECT_GT(CountWrong(g_cShipped, before, after, left), 100); // the control
    }
  EXPECT_GT(CountWrong(Without(&CTuning::m_bGhostVertices), 0, 0, true), 10);
}

/// The same for two segments that meet at an angle, from the side where they are a concave or a convex
/// corner.
int CountWrongAtCorner(const CTuning& tuning, double degrees, bool convex) {
  CRandom random(42);
  const double half = 0.5 * degrees * g_fDegree;
  const Vector2d right = Turned({0, 1}, -half), left = Turned({0, 1}, half); // a V with its tip at the origin
  const CLineSegDesc toRight({0, 0}, (4 * right).cast<float>()), toLeft({0, 0}, (4 * left).cast<float>());
  CRange range(MakeBox2D(tuning), {toRight, toLeft}, 0.1f);
  const auto aim = [&] {
    const double s = 0.02 + 0.5 * random.Unit(), speed = 1 + 19 * random.Unit(), phase = random.Unit();
    const bool atTip = convex && random.Unit() < 0.4;
    Vector2d at = s * right, n = (convex ? -1 : 1) * Perp(right);
    if (random.Coin()) at.x() = -at.x(), n.x() = -n.x();
    if (atTip) at.setZero(), n = Turned({0, -1}, EitherSign(random, 90 * g_fDegree - half));
    return CAim{at, n, EitherSign(random, 80 * g_fDegree), speed, phase, 4};
  };
  return range.CountWrong(1000, aim, 0.5);
}

TEST(TunedJointTest, CornersAreWhereTheyAre) {
  for (const double degrees : {45, 60, 90, 120, 135})
    for (const bool convex : {false, true}) {
      SCOPED_TRACE(testing::Message() << degrees << (convex ? " degrees, convex" : " degrees, concave"));
      EXPECT_EQ(CountWrongAtCorner(g_cTuned, degrees, convex), 0);
      if (degrees == 90) continue;
      EXPECT_GT(CountWrongAtCorner(g_cShipped, degrees, convex), convex ? 100 : 5); // the control
    }
}

// Where a surface is to a ball that bounces off it head-on, seen from the way it takes afterwards.

struct CTarget {
  const char* m_sName;
  double m_fContact; // distance of the ball's centre from the origin when it touches, r = .1
  bool m_bInside;
  CAnyShapeDesc (*m_fnMake)(const Vector2& u); // a shape about the origin that is met by a ball on the axis u
};
const Vector2 g_vHere(0, 0);
const CTarget g_cTargets[]{
    {"point", 0.1, false, [](const Vector2&) -> CAnyShapeDesc { return CPointDesc(g_vHere); }},
    {"face of a segment", 0.1, false,
     [](const Vector2& u) -> CAnyShapeDesc { return CLineSegDesc(perp(u), -perp(u)); }},
    {"end of a segment", 0.1, false,
     [](const Vector2& u) -> CAnyShapeDesc { return CLineSegDesc(g_vHere, -u); }},
    {"circle", 0.6, false, [](const Vector2&) -> CAnyShapeDesc { return CCircleDesc(g_vHere, 0.5f); }},
    {"arc, outside", 1.1, false, [](const Vector2&) -> CAnyShapeDesc { return CArcDesc(g_vHere, 1, 0, 0); }},
    {"arc, inside", 0.9, true, [](const Vector2&) -> CAnyShapeDesc { return CArcDesc(g_vHere, 1, 0, 0); }},
    {"ball", 0.2, false, [](const Vector2&) -> CAnyShapeDesc { return CDynamicCircleDesc(g_vHere, 0.1f); }}};

/// How far the surface is out of place, towards the ball: half of the shift of the outgoing way against the
/// exact one; infinity if there was no bounce. Of two balls in their relative motion.
double Offset(const CTuning& tuning, const CTarget& target, double speed, double phase, double angle) {
  auto pWorld = MakeBox2D(tuning);
  const Vector2d u = UnitVector(angle), n = target.m_bInside ? Vector2d(-u) : u;
  const CShapeId other = pWorld->Add(target.m_fnMake(u.cast<float>()));
  const Vector2d touching = target.m_fContact * u;
  const double dt = g_fDt, clear = std::floor(0.05 / (speed * dt)) + 1; // steps
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc(
      (touching + (clear + phase) * speed * dt * n).cast<float>(), 0.1f, (-speed * n).cast<float>()));
  const double t = (pWorld->GetPos(ball).cast<double>() - touching).dot(n) / speed;
  const int steps = static_cast<int>(t / dt) + 1 + std::max(3, static_cast<int>(0.03 / speed / dt));
  Steps(*pWorld, steps);

  Vector2d p = Wide(pWorld->GetPos(ball)), v = Wide(pWorld->GetVel(ball));
  if (pWorld->GetMotionType(other) == eMotion::Dynamic)
    p -= Wide(pWorld->GetPos(other)), v -= Wide(pWorld->GetVel(other));
  // A ball that goes on as if nothing were there is not shifted at all.
  if (!(n.dot(v) > 0.9 * speed)) return g_fNever;
  return 0.5 * n.dot(p - (steps * dt - t) * v - touching);
}

/// Its size that a share of 256 phases of the step do not exceed.
double OffsetOf(double share, const CTuning& tuning, const CTarget& target, double speed) {
  CRandom random(44);
  std::vector<double> offsets;
  for (double phase = 0.5 / 256; phase < 1; phase += 1.0 / 256)
    offsets.push_back(std::abs(Offset(tuning, target, speed, phase, 360 * g_fDegree * random.Unit())));
  return Quantile(offsets, share);
}

TEST(TunedWallTest, SurfacesAreWhereTheyAre) {
  CTuning unscaled = g_cTuned; // with Box2D's slop as it is
  unscaled.m_fScale = 1;
  for (const CTarget& target : g_cTargets) {
    double shipped = 0;
    for (const double speed : {0.1, 1.0, 10.0}) {
      SCOPED_TRACE(testing::Message() << target.m_sName << " at " << speed);
      EXPECT_LE(OffsetOf(0.5, g_cTuned, target, speed), g_fTunedOffset);
      shipped = std::max(shipped, OffsetOf(0.5, g_cShipped, target, speed));
    }
    EXPECT_GT(shipped, 5 * g_fTunedOffset) << target.m_sName; // the control, at one speed at least
    EXPECT_LE(OffsetOf(1, g_cTuned, target, 0.1), g_fTunedOffset) << target.m_sName;
    EXPECT_GT(OffsetOf(1, unscaled, target, 0.1), g_fTunedOffset) << target.m_sName;
  }
}

} // namespace
} // namespace Shapes::Tests
