// SPDX-License-Identifier: MIT
// The sweep against a search that shares nothing with it, against 50 digits and known answers; and distances.
#include "reference/Sweep.h"
#include "ReferenceTesting.h"
#include "SweepOracle.h"
#include "reference/Distance.h"
#include "reference/Scalar.h"

namespace Shapes::Compare::Tests {
namespace {

struct CTrial {
  CShapeGeometry<double> m_cGeometry;
  CTurning<double> m_cTurning;
  CSweptBall<double> m_cBall;
  double m_fTimeMax = 1.0;
};

double Between(CRandom& random, double least, double most) { return least + (most - least) * random.Unit(); }

CVec2d InSquare(CRandom& random, double half) {
  const double x = Between(random, -half, half);
  const double y = Between(random, -half, half);
  return {x, y};
}

CShapeGeometry<double> RandomFigure(CRandom& random, eShape type, bool oneSided) {
  CShapeGeometry<double> f;
  f.m_eShapeType = type;
  f.m_vCenter = InSquare(random, 1.0);
  if (oneSided) f.m_eSides = random.Coin() ? eSides::Front : eSides::Back;
  if (type == eShape::LineSeg) {
    f.m_vPt0 = InSquare(random, 1.0);
    f.m_vPt1 = InSquare(random, 1.0);
  }
  if (type == eShape::Circle || type == eShape::Arc) f.m_fRadius = Between(random, 0.05, 1.0);
  if (type == eShape::Arc) {
    const double a0 = Between(random, 0.0, 6.28), span = Between(random, 1e-3, 6.28);
    f.m_bFull = !oneSided && random.Below(8) == 0;
    f.m_bWide = span > std::numbers::pi;
    f.m_vPt0 = f.m_vCenter + f.m_fRadius * CVec2d(std::cos(a0), std::sin(a0));
    f.m_vPt1 = f.m_vCenter + f.m_fRadius * CVec2d(std::cos(a0 + span), std::sin(a0 + span));
  }
  return f;
}

// A ball that is clear of the shape, on a way that goes near it.
CTrial RandomTrial(CRandom& random, eShape type, bool oneSided, bool turns, bool falls = false) {
  for (;;) {
    CTrial trial;
    trial.m_cGeometry = RandomFigure(random, type, oneSided);
    const double r = Between(random, 0.01, 0.4);
    const CVec2d p = InSquare(random, 2.0), target = InSquare(random, 1.0);
    trial.m_cBall = {p, (target - p) * Between(random, falls ? 0.0 : 0.5, 3.0), r};
    if (turns) {
      trial.m_cTurning = {InSquare(random, 1.0), Between(random, -60.0, 60.0)};
      trial.m_fTimeMax = Between(random, 0.01, 0.2);
      trial.m_cBall.m_vVel *= Between(random, 0.0, 8.0);
    }
    if (falls) trial.m_cBall.m_vAcc = InSquare(random, turns ? 200.0 : 10.0);
    const CSweepOracle oracle(trial.m_cGeometry, trial.m_cTurning, trial.m_cBall, trial.m_fTimeMax);
    const bool tooBigInside = trial.m_cGeometry.m_bFull && r >= trial.m_cGeometry.m_fRadius &&
                              (p - trial.m_cGeometry.m_vCenter).norm() < trial.m_cGeometry.m_fRadius;
    if (oracle.Gap(0) > 1e-6L && !tooBigInside) return trial;
  }
}

// The published bound: gap at the time of impact.
double GapBound(const CTrial& trial) {
  return (trial.m_cTurning.m_fSpeed == 0.0 ? 16 : g_nTouchRoundings + 16) * g_fEps *
         (GetExtent(trial.m_cGeometry, trial.m_cBall, trial.m_cTurning) +
          trial.m_fTimeMax * trial.m_cBall.m_vVel.norm() +
          trial.m_fTimeMax * trial.m_fTimeMax * trial.m_cBall.m_vAcc.norm() / 2.0);
}

// Where the ball touches a shape that does not turn.
ePart PartOf(const CShapeGeometry<double>& f, const CHit<double>& hit, double bound) {
  if (f.m_eShapeType == eShape::Point) return ePart::Point;
  if (f.m_eShapeType != eShape::Circle && !f.m_bFull) {
    if ((hit.m_vPOI - f.m_vPt0).norm() <= bound) return ePart::End0;
    if ((hit.m_vPOI - f.m_vPt1).norm() <= bound) return ePart::End1;
  }
  if (f.m_eShapeType == eShape::LineSeg)
    return Cross(CVec2d(f.m_vPt1 - f.m_vPt0), hit.m_vNorm) > 0 ? ePart::Front : ePart::Back;
  return hit.m_vNorm.dot(hit.m_vPOI - f.m_vCenter) > 0 ? ePart::Outside : ePart::Inside;
}

struct CCase {
  eShape m_eShapeType;
  bool m_bOneSided;
  bool m_bTurns;
  int m_nTrials;
  bool m_bFalls = false; // under an acceleration of any direction
};

std::string Name(const CCase& c) {
  const char* shape = c.m_eShapeType == eShape::Point     ? "Point"
                      : c.m_eShapeType == eShape::LineSeg ? "LineSeg"
                      : c.m_eShapeType == eShape::Circle  ? "Circle"
                                                          : "Arc";
  return std::string(shape) + (c.m_bOneSided ? "OneSided" : "") + (c.m_bTurns ? "Turning" : "") +
         (c.m_bFalls ? "Falling" : "");
}
void PrintTo(const CCase& c, std::ostream* pOut) { *pOut << Name(c); }

class CSweepAgainstSearch : public testing::TestWithParam<CCase> {};

// No hit is missed, none is invented, the earliest is found, and POI, normal and part are those of the
// contact.
TEST_P(CSweepAgainstSearch, FindsTheSameImpact) {
  const CCase& c = GetParam();
  const std::uint64_t seed = 20240 + static_cast<std::uint64_t>(c.m_eShapeType) * 8 + c.m_bOneSided * 2 +
                             c.m_bTurns + c.m_bFalls * 1000;
  int hits = 0, misses = 0, ambiguous = 0;
  ForEachCase(seed, c.m_nTrials, [&](CRandom& random, int) {
    const CTrial trial = RandomTrial(random, c.m_eShapeType, c.m_bOneSided, c.m_bTurns, c.m_bFalls);
    const CSweepOracle oracle(trial.m_cGeometry, trial.m_cTurning, trial.m_cBall, trial.m_fTimeMax);
    CHit<double> hit;
    const bool met = Sweep(trial.m_cGeometry, trial.m_cTurning, trial.m_cBall, trial.m_fTimeMax, hit);
    const auto impact = oracle.FirstImpact();
    if (hit.m_bGraze) {
      ++ambiguous;
      return;
    }
    ASSERT_EQ(met, impact.has_value());
    ++(met ? hits : misses);
    if (!met) return;
    const double bound = GapBound(trial);
    const CVec2d v = trial.m_cBall.GetVel(hit.m_fTime);
    const double approach = -(v - hit.m_vSurface).dot(hit.m_vNorm);
    const double frame =
        -(v - trial.m_cTurning.m_fSpeed * Perp(CVec2d(hit.m_vCenter - trial.m_cTurning.m_vCenter)))
             .dot(hit.m_vNorm);
    ASSERT_NEAR(approach, frame,
                1e-9 * (1.0 + std::abs(approach))); // rotation about the centre of the ball adds none
    ASSERT_GT(approach, 0.0);
    // Twice the bound: close to a tangent the gap is not linear in the time.
    ASSERT_LE(std::abs(static_cast<double>(*impact - real(hit.m_fTime))), 2 * bound / approach + 4 * g_fEps);
    ASSERT_LE(std::abs(static_cast<double>(oracle.Gap(hit.m_fTime))), 2.0 * bound);
    ASSERT_NEAR(hit.m_vNorm.norm(), 1.0, 8.0 * g_fEps);
    ASSERT_LE((hit.m_vCenter - hit.m_vPOI - trial.m_cBall.m_fRadius * hit.m_vNorm).norm(), 2.0 * bound);
    ASSERT_LE(std::abs(static_cast<double>(oracle.DistanceOf(hit.m_vPOI, hit.m_fTime))), 2.0 * bound);
    ASSERT_FALSE(hit.m_bOverlapped || hit.m_bBegins);
    if (!c.m_bTurns) {
      ASSERT_EQ(hit.m_ePart, PartOf(trial.m_cGeometry, hit, 2.0 * bound));
    }
  });
  EXPECT_GT(hits, c.m_nTrials / 10);
  EXPECT_GT(misses, c.m_nTrials / 20);
  EXPECT_LE(ambiguous, 1); // none in two million
}

INSTANTIATE_TEST_SUITE_P(
    , CSweepAgainstSearch,
    testing::Values(
        CCase{eShape::Point, false, false, 20000}, CCase{eShape::LineSeg, false, false, 20000},
        CCase{eShape::LineSeg, true, false, 20000}, CCase{eShape::Circle, false, false, 20000},
        CCase{eShape::Arc, false, false, 40000}, CCase{eShape::Arc, true, false, 40000},
        CCase{eShape::Point, false, true, 5000}, CCase{eShape::LineSeg, false, true, 10000},
        CCase{eShape::LineSeg, true, true, 10000}, CCase{eShape::Circle, false, true, 5000},
        CCase{eShape::Arc, false, true, 10000}, CCase{eShape::Arc, true, true, 10000},
        CCase{eShape::Point, false, false, 20000, true}, CCase{eShape::LineSeg, false, false, 20000, true},
        CCase{eShape::LineSeg, true, false, 20000, true}, CCase{eShape::Circle, false, false, 20000, true},
        CCase{eShape::Arc, false, false, 40000, true}, CCase{eShape::Arc, true, false, 40000, true},
        CCase{eShape::Point, false, true, 3000, true}, CCase{eShape::LineSeg, true, true, 3000, true},
        CCase{eShape::Circle, false, true, 3000, true}, CCase{eShape::Arc, false, true, 5000, true}),
    [](const auto& test) { return Name(test.param); });

CVec<CFifty> To50(const CVec2d& v) { return {CFifty(v.x()), CFifty(v.y())}; }

bool Sweep50(const CTrial& trial, CHit<CFifty>& hit) {
  const CSweptBall<double>& b = trial.m_cBall;
  return Sweep<CFifty>(
      trial.m_cGeometry.Cast<CFifty>(), {To50(trial.m_cTurning.m_vCenter), CFifty(trial.m_cTurning.m_fSpeed)},
      {To50(b.m_vPos), To50(b.m_vVel), CFifty(b.m_fRadius), To50(b.m_vAcc)}, CFifty(trial.m_fTimeMax), hit);
}

// The control: gravity that is kicked at the start of the step, v += g dt, meets at another time.
TEST(Sweep, KickedGravityMissesTheTimeOfImpact) {
  int hits = 0, wrong = 0;
  ForEachCase(51, 2000, [&](CRandom& random, int) {
    CTrial trial = RandomTrial(random, random.Coin() ? eShape::LineSeg : eShape::Circle, false, false, true);
    CHit<double> hit, kicked;
    if (!Sweep(trial.m_cGeometry, trial.m_cBall, trial.m_fTimeMax, hit) || hit.m_bGraze) return;
    ++hits;
    const double approach = -trial.m_cBall.GetVel(hit.m_fTime).dot(hit.m_vNorm);
    const double bound = 2.0 * GapBound(trial) / approach + 4.0 * g_fEps * hit.m_fTime;
    CSweptBall<double> ball = trial.m_cBall;
    ball.m_vVel += ball.m_vAcc * trial.m_fTimeMax;
    ball.m_vAcc = {0, 0};
    wrong += !Sweep(trial.m_cGeometry, ball, trial.m_fTimeMax, kicked) ||
             std::abs(kicked.m_fTime - hit.m_fTime) > 1000.0 * bound;
  });
  EXPECT_GT(hits, 400);
  EXPECT_EQ(wrong, hits);
}

// The bound of the straight path, and the control: the textbook formula of the quadratic does not keep it.
TEST(Sweep, NearGrazesKeepTheBoundThatTheTextbookBreaks) {
  double worst = 0.0, worstTextbook = 0.0;
  ForEachCase(31, 3000, [&](CRandom& random, int) {
    const double R = 0.1, far = Between(random, 1.0, 100.0);
    const double gap = R * std::pow(10.0, -1.0 - 5.0 * random.Unit());
    const double angle = Between(random, 0.0, 6.28), c = std::cos(angle), s = std::sin(angle);
    CTrial trial;
    trial.m_cGeometry.m_eShapeType = eShape::Point;
    const CVec2d d(-far * c - (R - gap) * s, -far * s + (R - gap) * c);
    trial.m_cBall = {d, {c, s}, R};
    trial.m_fTimeMax = 2.0 * far;
    CHit<double> hit;
    CHit<CFifty> exact;
    ASSERT_TRUE(Sweep(trial.m_cGeometry, trial.m_cBall, trial.m_fTimeMax, hit));
    ASSERT_TRUE(Sweep50(trial, exact));
    const double truth = static_cast<double>(exact.m_fTime);
    const double approach = static_cast<double>(-To50(trial.m_cBall.m_vVel).dot(exact.m_vNorm));
    const double bound = 16.0 * g_fEps * (d.norm() + R) / approach + 4.0 * g_fEps * truth;
    const double textbook = TextbookTime(d, trial.m_cBall.m_vVel, R);
    worst = std::max(worst, std::abs(hit.m_fTime - truth) / bound);
    worstTextbook = std::max(worstTextbook, std::abs(textbook - truth) / bound);
  });
  EXPECT_LE(worst, 1.0);
  EXPECT_GT(worstTextbook, 10.0);
}

// The control of the turning path: Newton's method steps over impacts that the safe step finds.
TEST(Sweep, NewtonWouldMissWhatTheSafeStepFinds) {
  int hits = 0, missedByNewton = 0;
  ForEachCase(60, 1000, [&](CRandom& random, int) {
    const CTrial trial = RandomTrial(random, eShape::Point, false, true);
    CHit<double> hit;
    if (!Sweep(trial.m_cGeometry, trial.m_cTurning, trial.m_cBall, trial.m_fTimeMax, hit)) return;
    ++hits;
    const CSweepOracle oracle(trial.m_cGeometry, trial.m_cTurning, trial.m_cBall, trial.m_fTimeMax);
    missedByNewton += !oracle.NewtonComesTo(hit.m_fTime);
  });
  EXPECT_GT(hits, 100);
  EXPECT_GT(missedByNewton, hits / 20);
}

TEST(DistanceTest, IsThatOfTheOracle) {
  const eShape types[] = {eShape::Point, eShape::LineSeg, eShape::Circle, eShape::Arc};
  ForEachCase(17, 1600, [&](CRandom& random, int i) {
    const CShapeGeometry<double> f = RandomFigure(random, types[i % 4], false);
    const CVec2d p = InSquare(random, 2.0);
    const real distance = CSweepOracle(f, {}, {p, {0, 0}, 0}, 0).Gap(0);
    EXPECT_NEAR(Distance(f, p), static_cast<double>(distance), 32.0 * g_fEps);
  });
}

TEST(DistanceTest, OfSpecialPlaces) {
  const CShapeGeometry<double> seg = MakeShapeGeometry(CLineSegDesc({0, 0}, {4, 0})),
                               spot = MakeShapeGeometry(CLineSegDesc({1, 1}, {1, 1}));
  EXPECT_EQ(Distance(seg, CVec2d(2, 0)), 0.0);
  EXPECT_EQ(Distance(spot, CVec2d(4, 5)), 5.0);
  EXPECT_EQ(Distance(MakeShapeGeometry(CCircleDesc({1, 0}, 2)), CVec2d(1, 0)), 2.0); // the centre
}

// ---- Known answers: what overlaps at the start, what a turning blade presses; and along parabolas tangents,
// and what touches at the start. Times of impact that are hard are among the hard cases, and tests/geometry
// holds sweeps of two kinds against each other.

using CBalld = CSweptBall<double>;

struct CFound {
  bool m_bMet;
  CHit<double> m_cHit;
};

CFound Shoot(const CAnyShapeDesc& desc, const CBalld& ball, double tMax = 10.0,
             eMeet meet = eMeet::Approaching) {
  CFound result;
  result.m_bMet = Sweep(MakeShapeGeometry(desc), ball, tMax, result.m_cHit, meet);
  return result;
}

TEST(SweepCases, OverlapIsHitOnlyIfItApproaches) {
  struct {
    CAnyShapeDesc m_cShape;
    CVec2d m_vPos;
    CVec2d m_vOut;
    double m_fDepth;
  } cases[] = {{CPointDesc({0, 0}), {.3, 0}, {1, 0}, .2},
               {CLineSegDesc({-1, 0}, {1, 0}), {0, -.3}, {0, -1}, .2},
               {CLineSegDesc({-1, 0}, {1, 0}), {1.3, 0}, {1, 0}, .2},
               {CCircleDesc({0, 0}, 1), {1.3, 0}, {1, 0}, .2},
               {CCircleDesc({0, 0}, 1), {.7, 0}, {-1, 0}, .2},
               {CArcDesc({0, 0}, 1, -1, 1), {.7, 0}, {-1, 0}, .2},
               {CArcDesc({0, 0}, 1, -1, 1), {1.3, 0}, {1, 0}, .2}};
  for (const auto& c : cases) {
    SCOPED_TRACE(testing::Message() << "shape " << c.m_cShape.index() << " at " << c.m_vPos.x());
    const CVec2d in = -c.m_vOut;
    const CFound approaching = Shoot(c.m_cShape, {c.m_vPos, in, .5}, .1);
    ASSERT_TRUE(approaching.m_bMet);
    EXPECT_EQ(approaching.m_cHit.m_fTime, 0.0);
    EXPECT_TRUE(approaching.m_cHit.m_bOverlapped);
    EXPECT_NEAR(approaching.m_cHit.m_fDepth, c.m_fDepth, 16 * g_fEps);
    EXPECT_NEAR((approaching.m_cHit.m_vNorm - c.m_vOut).norm(), 0.0, 1e-15);
    EXPECT_FALSE(Shoot(c.m_cShape, {c.m_vPos, c.m_vOut, .5}, .1).m_bMet);
    EXPECT_FALSE(Shoot(c.m_cShape, {c.m_vPos, {0, 0}, .5}, .1).m_bMet);
    // A sensor is touched whichever way the ball goes.
    EXPECT_TRUE(Shoot(c.m_cShape, {c.m_vPos, c.m_vOut, .5}, .1, eMeet::Touching).m_bMet);
  }
}

// A ball that a turning blade carries along, in touch and not approaching, is met as soon as the blade
// presses.
TEST(SweepCases, PressedByATurningBlade) {
  const CShapeGeometry<double> blade = MakeShapeGeometry(CLineSegDesc({0, 0}, {1, 0}));
  CHit<double> hit;
  ASSERT_TRUE(Sweep<double>(blade, {{0, 0}, 10}, {{.5, .1}, {1, 5}, .1}, 1.0 / 60, hit));
  EXPECT_LT(hit.m_fTime, 1e-9);
  // One that is faster than the blade leaves.
  EXPECT_FALSE(Sweep<double>(blade, {{0, 0}, 10}, {{.5, .1}, {0, 8}, .1}, 1.0 / 60, hit));
}

const CVec2d g_vDown(0, -8);

CFound Throw(const CAnyShapeDesc& desc, const CVec2d& p, const CVec2d& v, double r, double tMax = 10,
             const CVec2d& g = g_vDown) {
  return Shoot(desc, {p, v, r, g}, tMax);
}

TEST(Parabola, ApexIsFoundInOneLongStep) { // both ends of the way are far below
  EXPECT_TRUE(Throw(CPointDesc({0, 10.1f}), {-2, 0}, {1.265, 12.65}, .25, 20).m_bMet);
  EXPECT_FALSE(Throw(CPointDesc({0, 10.5f}), {-2, 0}, {1.265, 12.65}, .25, 20).m_bMet);
}

// Of a straight way that only touches a point at the time 10, and of a parabola that only touches a ceiling,
// or a point, with its apex at the time .5: within a `close` distance, and no more at a larger one.
TEST(Parabola, TangentsAreFlaggedOnBothSides) {
  const struct {
    CAnyShapeDesc m_cShape;
    CBalld m_cBall;
    double m_fTime, m_fClose;
  } cases[] = {{CPointDesc({0, 1}), {{-10, 0}, {1, 0}, 1}, 10, 1e-12},
               {Wall({-9, 1.5f}, {9, 1.5f}), {{0, 0}, {2, 4}, .5, g_vDown}, .5, 1e-11},
               {CPointDesc({1, 1.5f}), {{0, 0}, {2, 4}, .5, g_vDown}, .5, 1e-11}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.m_cShape.index());
    const auto toss = [&](double over, double tMax) {
      CBalld ball = c.m_cBall;
      ball.m_vPos.y() += over;
      return Shoot(c.m_cShape, ball, tMax);
    };
    const double close = c.m_fClose, far = 1e4 * close, all = 2 * c.m_fTime;
    EXPECT_TRUE(toss(close, all).m_bMet && toss(close, all).m_cHit.m_bGraze);
    EXPECT_TRUE(!toss(-close, all).m_bMet && toss(-close, all).m_cHit.m_bGraze);
    EXPECT_NEAR(toss(-close, all).m_cHit.m_fTime, c.m_fTime, c.m_fTime < 1 ? 1e-6 : 1e-12);
    EXPECT_TRUE(toss(far, all).m_bMet && !toss(far, all).m_cHit.m_bGraze);
    EXPECT_FALSE(toss(-far, all).m_cHit.m_bGraze);
    EXPECT_FALSE(toss(-close, .9 * c.m_fTime).m_cHit.m_bGraze); // it does not get that far
  }
}

// Touching and overlapping balls that do not approach are met when they begin to.
TEST(Parabola, WhatBeginsToApproachIsMet) {
  for (const CAnyShapeDesc& floor :
       {CAnyShapeDesc(Wall({-9, 0}, {9, 0})), CAnyShapeDesc(CCircleDesc({0, -2}, 2)),
        CAnyShapeDesc(CPointDesc({0, 0})), CAnyShapeDesc(CArcDesc({0, 4}, 4, 0, 0)),
        CAnyShapeDesc(Sided(Wall({-9, 0}, {9, 0}), eSides::Front))}) {
    SCOPED_TRACE(floor.index());
    for (const double depth : {0.0, 1e-8, .125}) {
      const CFound rests = Throw(floor, {0, .5 - depth}, {0, 0}, .5);
      ASSERT_TRUE(rests.m_bMet);
      EXPECT_EQ(rests.m_cHit.m_fTime, 0);
      EXPECT_TRUE(rests.m_cHit.m_bBegins);
      EXPECT_NEAR(rests.m_cHit.m_fDepth, depth, 1e-15);
      EXPECT_EQ(rests.m_cHit.m_bOverlapped, depth > 0);
      if (depth < .1) continue;
      const CFound leaves = Throw(floor, {0, .5 - depth}, {0, .8}, .5); // .04 up, in .1
      ASSERT_TRUE(leaves.m_bMet);
      EXPECT_NEAR(leaves.m_cHit.m_fTime, .1, 1e-14);
      EXPECT_NEAR(leaves.m_cHit.m_fDepth, .085, 1e-14);
      // High enough it comes back from clear.
      const CFound clear = Throw(floor, {0, .5 - depth}, {0, 4}, .5);
      ASSERT_TRUE(clear.m_bMet);
      EXPECT_NEAR(clear.m_cHit.m_fTime, (4 + std::sqrt(14.0)) / 8, 1e-14);
      EXPECT_FALSE(clear.m_cHit.m_bOverlapped);
    }
    // Accelerated off, or along a straight one, it is let go.
    EXPECT_FALSE(Throw(floor, {0, .5}, {0, 0}, .5, .1, {0, 8}).m_bMet);
  }
  EXPECT_FALSE(Throw(Wall({-9, 0}, {9, 0}), {0, .5}, {1, 0}, .5, 1, {3, 0}).m_bMet);
  // A centre on the other side is not held back.
  EXPECT_FALSE(Throw(Sided(Wall({-9, 0}, {9, 0}), eSides::Front), {0, -.1}, {0, 0}, .5).m_bMet);
  EXPECT_FALSE(Throw(Wall({-9, 0}, {9, 0}), {0, -.1}, {0, 0}, .5).m_bMet);
}

// Hops of any height last 2 v / g to a few roundings, though their height is below every rounding of place.
TEST(Parabola, TinyHopsKeepTheirRelativePrecision) {
  for (const CAnyShapeDesc& floor :
       {CAnyShapeDesc(Wall({-9, 0}, {9, 0})), CAnyShapeDesc(CCircleDesc({0, -2}, 2))})
    for (const double v : {1e-3, 1e-6, 1e-9, 1e-11}) {
      const CFound hop = Throw(floor, {0, .5 + 4 * g_fEps}, {0, v}, .5);
      ASSERT_TRUE(hop.m_bMet);
      EXPECT_NEAR(hop.m_cHit.m_fTime, 2 * v / 8, 8 * g_fEps * v / 8) << v;
      EXPECT_FALSE(hop.m_cHit.m_bOverlapped);
    }
}

TEST(Parabola, BallsOfWhichOneRests) {
  CHit<double> hit;
  // .5 of free fall onto a ball that is held.
  ASSERT_TRUE(SweepBalls<double>({{0, 0}, {0, 0}, .25}, {{0, 1}, {0, 0}, .25, g_vDown}, 1.0, hit));
  EXPECT_NEAR(hit.m_fTime, std::sqrt(2 * .5 / 8), 1e-15);
  EXPECT_NEAR((hit.m_vPOI - CVec2d(0, .25)).norm(), 0, 1e-15);
  // Both fall: never.
  EXPECT_FALSE(SweepBalls<double>({{0, 0}, {0, 0}, .25, g_vDown}, {{0, 1}, {0, 0}, .25, g_vDown}, 1.0, hit));
  // Thrown after a falling one it is met as if there were no gravity, where both are by then.
  ASSERT_TRUE(SweepBalls<double>({{0, 0}, {0, 0}, .25, g_vDown}, {{0, 1}, {0, -2}, .25, g_vDown}, 1.0, hit));
  EXPECT_NEAR(hit.m_fTime, .25, 1e-15);
  EXPECT_NEAR((hit.m_vPOI - CVec2d(0, .25 - 4 * .0625)).norm(), 0, 1e-15);
  EXPECT_NEAR((hit.m_vSurface - CVec2d(0, -2)).norm(), 0, 1e-15);
}

} // namespace
} // namespace Shapes::Compare::Tests
