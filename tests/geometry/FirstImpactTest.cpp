// SPDX-License-Identifier: MIT
// The sweeps of native and of the exact reference against a search that shares nothing with them, and against
// 50 digits near grazes; with the controls that show what easier methods miss.
#include "ImpactTesting.h"

namespace Shapes::Geometry {
namespace {

using Compare::Tests::CSweepOracle;
using Compare::Tests::real;

constexpr double g_fEps = std::numeric_limits<double>::epsilon();

/// The answer of one of the sweeps, and its published bound: of the gap at the time of impact.
struct CFound {
  const char* m_sSweep;
  bool m_bMet;
  double m_fTime;
  Vector2d m_vPOI, m_vNorm, m_vSurface;
  double m_fGapBound;
};

CFound FindByNative(const CTrial& trial) {
  CImpact impact;
  const eSweep found = Sweep(trial.m_cShape, trial.m_cMotion, 0.0, impact);
  EXPECT_NE(found, eSweep::OutOfIterations);
  return {"native",       found == eSweep::Impact, impact.m_fTime, impact.m_vPOI,
          impact.m_vNorm, impact.m_vSurface,       GapBound(trial)};
}

CFound FindByReference(const CTrial& trial, Compare::CHit<double>& hit) {
  const CMotion& motion = trial.m_cMotion;
  const bool met = SweepExactly(trial, hit);
  const Compare::CTurning<double> turning{trial.m_cShape.m_vRotCenter, trial.m_cShape.m_fTurnSpeed};
  const double size = GetExtent(ForReference(trial.m_cShape), BallOf<double>(motion), turning);
  const double way =
      motion.m_fDuration * (motion.m_vVel.norm() + motion.m_fDuration * motion.m_vAcc.norm() / 2.0);
  const double roundings = turning.m_fSpeed == 0.0 ? 16 : Compare::g_nTouchRoundings + 16;
  return {"reference",
          met,
          hit.m_fTime,
          hit.m_vPOI,
          hit.m_vNorm,
          hit.m_vSurface,
          roundings * g_fEps * (size + way)};
}

std::array<CFound, 2> FindByBoth(const CTrial& trial, Compare::CHit<double>& hit) {
  const CFound byReference = FindByReference(trial, hit);
  return {byReference, FindByNative(trial)};
}

// Where the ball touches a shape that does not turn.
Compare::ePart PartOf(const CShapeGeometry& o, const Compare::CHit<double>& hit, double bound) {
  using Compare::ePart;
  if (o.m_eShapeType == eShape::Point) return ePart::Point;
  if (o.m_eShapeType != eShape::Circle && !o.m_bFull) {
    if ((hit.m_vPOI - o.m_vPt0).norm() <= bound) return ePart::End0;
    if ((hit.m_vPOI - o.m_vPt1).norm() <= bound) return ePart::End1;
  }
  if (o.m_eShapeType == eShape::LineSeg)
    return Cross(o.m_vPt1 - o.m_vPt0, hit.m_vNorm) > 0 ? ePart::Front : ePart::Back;
  return hit.m_vNorm.dot(hit.m_vPOI - o.m_vCenter) > 0 ? ePart::Outside : ePart::Inside;
}

class CSweepAgainstSearch : public testing::TestWithParam<CTrials> {};

// No hit is missed, none is invented, the earliest is found, and POI, normal and part are those of the
// contact.
TEST_P(CSweepAgainstSearch, FindsTheSameImpact) {
  const CTrials& c = GetParam();
  int hits = 0, misses = 0, ambiguous = 0;
  ForEachCase(c.GetSeed(), c.m_nTrials, [&](CRandom& random, int) {
    const eSides sides = c.GetSides(random);
    const CTrial trial = ClearTrial(random, c.m_eShapeType, sides, c.m_bTurns, c.m_bFalls);
    const CMotion& motion = trial.m_cMotion;
    const CSweepOracle oracle = MakeOracle(trial.m_cShape, motion);
    const auto impact = oracle.FirstImpact();
    Compare::CHit<double> hit;
    const auto founds = FindByBoth(trial, hit);
    if (hit.m_bGraze) {
      ++ambiguous;
      return;
    }
    ++(impact ? hits : misses);
    for (const CFound& found : founds) {
      SCOPED_TRACE(found.m_sSweep);
      ASSERT_EQ(found.m_bMet, impact.has_value());
      if (!impact) continue;
      const double bound = found.m_fGapBound, t = found.m_fTime;
      const Vector2d center = motion.PosAt(t), v = motion.VelAt(t);
      const double approach = -(v - found.m_vSurface).dot(found.m_vNorm);
      // Of the frame at the centre of the ball: a rotation about that adds none.
      const Vector2d frame = trial.m_cShape.m_fTurnSpeed * Perp(center - trial.m_cShape.m_vRotCenter);
      ASSERT_NEAR(approach, -(v - frame).dot(found.m_vNorm), 1e-9 * (1.0 + std::abs(approach)));
      ASSERT_GT(approach, 0.0);
      // Twice the bound: close to a tangent the gap is not linear in the time.
      ASSERT_LE(std::abs(static_cast<double>(*impact - real(t))), 2 * bound / approach + 4 * g_fEps);
      ASSERT_LE(std::abs(static_cast<double>(oracle.Gap(t))), 2.0 * bound);
      ASSERT_NEAR(found.m_vNorm.norm(), 1.0, 8.0 * g_fEps);
      ASSERT_LE((center - found.m_vPOI - motion.m_fRadius * found.m_vNorm).norm(), 2.0 * bound);
      ASSERT_LE(std::abs(static_cast<double>(oracle.DistanceOf(found.m_vPOI, t))), 2.0 * bound);
    }
    if (!impact) return;
    ASSERT_FALSE(hit.m_bOverlapped || hit.m_bBegins);
    if (!c.m_bTurns) {
      ASSERT_EQ(hit.m_ePart, PartOf(trial.m_cShape, hit, 2.0 * founds[0].m_fGapBound));
    }
  });
  EXPECT_GT(hits, c.m_nTrials / 10);
  EXPECT_GT(misses, c.m_nTrials / 20);
  EXPECT_LE(ambiguous, 1); // none in two million
}

INSTANTIATE_TEST_SUITE_P(
    , CSweepAgainstSearch,
    testing::Values(
        CTrials{eShape::Point, false, false, 20000}, CTrials{eShape::LineSeg, false, false, 20000},
        CTrials{eShape::LineSeg, true, false, 20000}, CTrials{eShape::Circle, false, false, 20000},
        CTrials{eShape::Arc, false, false, 40000}, CTrials{eShape::Arc, true, false, 40000},
        CTrials{eShape::Point, false, true, 5000}, CTrials{eShape::LineSeg, false, true, 10000},
        CTrials{eShape::LineSeg, true, true, 10000}, CTrials{eShape::Circle, false, true, 5000},
        CTrials{eShape::Arc, false, true, 10000}, CTrials{eShape::Arc, true, true, 10000},
        CTrials{eShape::Point, false, false, 20000, true},
        CTrials{eShape::LineSeg, false, false, 20000, true},
        CTrials{eShape::LineSeg, true, false, 20000, true},
        CTrials{eShape::Circle, false, false, 20000, true}, CTrials{eShape::Arc, false, false, 40000, true},
        CTrials{eShape::Arc, true, false, 40000, true}, CTrials{eShape::Point, false, true, 3000, true},
        CTrials{eShape::LineSeg, true, true, 3000, true}, CTrials{eShape::Circle, false, true, 3000, true},
        CTrials{eShape::Arc, false, true, 5000, true}),
    [](const auto& test) { return Name(test.param); });

TEST(SweepOverlapping, IsMetOnlyIfItApproaches) {
  const struct {
    CAnyShapeDesc m_cShape;
    Vector2d m_vPos, m_vOut;
    double m_fDepth;
  } rows[] = {{CPointDesc({0, 0}), {.3, 0}, {1, 0}, .2},
              {CPointDesc({0, 0}), {.5, 0}, {1, 0}, 0},
              {CLineSegDesc({-1, 0}, {1, 0}), {0, -.3}, {0, -1}, .2},
              {CLineSegDesc({-1, 0}, {1, 0}), {1.3, 0}, {1, 0}, .2},
              {CCircleDesc({0, 0}, 1), {1.3, 0}, {1, 0}, .2},
              {CCircleDesc({0, 0}, 1), {.7, 0}, {-1, 0}, .2},
              {CArcDesc({0, 0}, 1, -1, 1), {.7, 0}, {-1, 0}, .2},
              {CArcDesc({0, 0}, 1, -1, 1), {1.3, 0}, {1, 0}, .2}};
  for (const auto& row : rows) {
    SCOPED_TRACE(&row - rows);
    CTrial trial{MakeShapeGeometry(*MakeShape(row.m_cShape), 0.0), {row.m_vPos, -row.m_vOut, .5, .1}};
    Compare::CHit<double> hit;
    for (const CFound& found : FindByBoth(trial, hit)) {
      ASSERT_TRUE(found.m_bMet) << found.m_sSweep;
      EXPECT_EQ(found.m_fTime, 0.0) << found.m_sSweep;
      EXPECT_NEAR((found.m_vNorm - row.m_vOut).norm(), 0.0, 1e-15) << found.m_sSweep;
    }
    EXPECT_EQ(hit.m_bOverlapped, row.m_fDepth > 0.0);
    EXPECT_NEAR(hit.m_fDepth, row.m_fDepth, 16 * g_fEps);
    for (const Vector2d& v : {row.m_vOut, Vector2d(0, 0)}) {
      trial.m_cMotion.m_vVel = v;
      for (const CFound& found : FindByBoth(trial, hit))
        EXPECT_FALSE(found.m_bMet) << found.m_sSweep << ' ' << v.transpose();
      // A sensor is touched whichever way the ball goes.
      EXPECT_EQ(Compare::Sweep(ForReference(trial.m_cShape), BallOf<double>(trial.m_cMotion), .1, hit,
                               Compare::eMeet::Touching),
                row.m_fDepth > 0.0);
    }
  }
  // Along a convex shape that it touches or overlaps.
  for (const double y : {.5, .25}) {
    Compare::CHit<double> hit;
    const CTrial along{MakeShapeGeometry(CPoint(CPointDesc({0, 0})), 0.0), {{0, y}, {1, 0}, .5, 10.0}};
    for (const CFound& found : FindByBoth(along, hit))
      EXPECT_FALSE(found.m_bMet) << found.m_sSweep;
  }
}

// The control: gravity that is kicked at the start of the step, v += g dt, meets at another time.
TEST(SweepControl, KickedGravityMissesTheTimeOfImpact) {
  int hits = 0, wrong = 0;
  ForEachCase(51, 2000, [&](CRandom& random, int) {
    const eShape type = random.Coin() ? eShape::LineSeg : eShape::Circle;
    const CTrial trial = ClearTrial(random, type, eSides::Both, false, true);
    const CFound found = FindByNative(trial);
    if (!found.m_bMet) return;
    ++hits;
    const double approach = -trial.m_cMotion.VelAt(found.m_fTime).dot(found.m_vNorm);
    const double bound = 2.0 * found.m_fGapBound / approach + 4.0 * g_fEps * found.m_fTime;
    CTrial kicked = trial;
    kicked.m_cMotion.m_vVel += trial.m_cMotion.m_vAcc * trial.m_cMotion.m_fDuration;
    kicked.m_cMotion.m_vAcc = {0, 0};
    const CFound late = FindByNative(kicked);
    wrong += !late.m_bMet || std::abs(late.m_fTime - found.m_fTime) > 1000.0 * bound;
  });
  EXPECT_GT(hits, 400);
  EXPECT_EQ(wrong, hits);
}

// The control of what turns: Newton's method on the same gap steps over impacts that the safe step finds.
TEST(SweepControl, NewtonMissesImpacts) {
  int hits = 0, missed = 0;
  ForEachCase(60, 1000, [&](CRandom& random, int) {
    const CTrial trial = ClearTrial(random, g_eTypes[random.Below(4)], eSides::Both, true);
    const CFound found = FindByNative(trial);
    if (!found.m_bMet) return;
    ++hits;
    missed += !MakeOracle(trial.m_cShape, trial.m_cMotion).NewtonComesTo(found.m_fTime);
  });
  EXPECT_GT(hits, 200);
  EXPECT_GT(missed, hits / 20);
}

// The bound of the straight way, and the control: the textbook's formula of the quadratic does not keep it.
TEST(SweepNearGraze, KeepsTheBoundThatTheTextbookBreaks) {
  double worst[2] = {0.0, 0.0}, worstTextbook = 0.0;
  ForEachCase(31, 3000, [&](CRandom& random, int) {
    const double r = 0.1, far = 1 + 99 * random.Unit(), gap = r * std::pow(10.0, -1 - 5 * random.Unit());
    const double angle = 6.28 * random.Unit();
    const Vector2d v(std::cos(angle), std::sin(angle)), d = -far * v + (r - gap) * Perp(v);
    const CTrial trial{MakeShapeGeometry(CPoint(CPointDesc(Vector2(0, 0))), 0.0), {d, v, r, 2.0 * far}};
    Compare::CHit<CFifty> exact;
    Compare::CHit<double> hit;
    ASSERT_TRUE(SweepExactly(trial, exact));
    const double truth = static_cast<double>(exact.m_fTime);
    const double approach = static_cast<double>(-To<CFifty>(v).dot(exact.m_vNorm));
    const double bound = 16.0 * g_fEps * (d.norm() + r) / approach + 4.0 * g_fEps * truth;
    const auto founds = FindByBoth(trial, hit);
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_TRUE(founds[k].m_bMet);
      worst[k] = std::max(worst[k], std::abs(founds[k].m_fTime - truth) / bound);
    }
    const double textbook = Compare::Tests::TextbookTime(d, v, r);
    worstTextbook = std::max(worstTextbook, std::abs(textbook - truth) / bound);
  });
  EXPECT_LE(worst[0], 1.0) << "reference";
  EXPECT_LE(worst[1], 1.0) << "native";
  EXPECT_GT(worstTextbook, 10.0);
}

} // namespace
} // namespace Shapes::Geometry
