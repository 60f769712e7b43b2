// SPDX-License-Identifier: MIT
// Native's sweeps against the exact reference, on trials that seek the hard region: by 50 digits, and where
// the sines of those take their time, by double.
#include "Tolerances.h"

#include "ImpactTesting.h"

namespace Shapes::Geometry {
namespace {

constexpr double g_fNever = std::numeric_limits<double>::infinity();

// The answer of the reference. Its time is g_fNever if nothing is met.
struct CAnswer {
  double m_fTime;
  Vector2d m_vNorm;
  bool m_bBegins;
};
template <class T>
CAnswer ToAnswer(bool met, const Compare::CHit<T>& hit) {
  const Vector2d n(static_cast<double>(hit.m_vNorm.x()), static_cast<double>(hit.m_vNorm.y()));
  return {met ? static_cast<double>(hit.m_fTime) : g_fNever, n, hit.m_bBegins};
}

// When native's sweep meets something, and its bounds: of the gap, and of the rounding of the time.
struct CTime {
  CTime(eSweep found, const CImpact& impact, const Vector2d& v)
      : m_fTime(found == eSweep::Impact ? impact.m_fTime : g_fNever),
        m_fApproach(found == eSweep::Impact ? -(v - impact.m_vSurface).dot(impact.m_vNorm) : 0.0) {}

  bool IsMet() const { return m_fTime < g_fNever; }
  double ErrorOf(const CAnswer& exact) const { return std::abs(m_fTime - exact.m_fTime); }

  double m_fTime;
  double m_fApproach;
  double m_fBound = 0.0;
  double m_fRounding = 4.0 * 0x1p-52;
};

// Counts hits, misses, and trials near a graze.
class CJudge {
public:
  explicit CJudge(int trials) : m_nTrials(trials) {}

  /// Whether both have met something at the same time. If they differ by more than the bound, native's time
  /// has to be between those of a ball that is larger and of one that is smaller.
  /// @param more  by so much  @param slack  of these times
  /// @param ask  the reference about a ball that is larger by its argument
  template <class F>
  bool HaveMet(const CTime& time, const CAnswer& exact, double more, double slack, const F& ask) {
    const bool exactlyMet = exact.m_fTime < g_fNever;
    // Away from tangents the gap is linear in the time.
    const double bound = time.m_fBound + time.m_fRounding * time.m_fApproach;
    if (time.IsMet() != exactlyMet || (exactlyMet && !(time.ErrorOf(exact) * time.m_fApproach <= bound))) {
      const double larger = ask(more).m_fTime, smaller = ask(-more).m_fTime;
      // One-sided ends let go what overlaps by more than rounding: there the smaller one may be the first.
      const auto [first, last] = std::minmax({larger, exact.m_fTime, smaller});
      ++m_nAmbiguous;
      EXPECT_TRUE(time.m_fTime >= first - slack && time.m_fTime <= last + slack)
          << "at " << time.m_fTime << " instead of " << larger << " .. " << exact.m_fTime << " .. "
          << smaller;
      return false;
    }
    ++(exactlyMet ? m_nHits : m_nMisses);
    if (exactlyMet) {
      EXPECT_GT(time.m_fApproach, 0.0);
    }
    return exactlyMet;
  }
  /// That there was at least so much of each.
  void ExpectMany(int least) const {
    EXPECT_GT(m_nHits, least);
    EXPECT_GT(m_nMisses, least);
    EXPECT_LT(m_nAmbiguous, m_nTrials / 100);
    testing::Test::RecordProperty("ambiguous", m_nAmbiguous);
    testing::Test::RecordProperty("hits", m_nHits);
  }

private:
  int m_nTrials, m_nHits = 0, m_nMisses = 0, m_nAmbiguous = 0;
};

template <class T>
void ExpectAgrees(const CTrials& trials) {
  CJudge judge(trials.m_nTrials);
  int unanswered = 0;
  ForEachCase(trials.GetSeed(), trials.m_nTrials, [&](CRandom& random, int) {
    const eSides sides = trials.GetSides(random);
    const CTrial trial = RandomTrial(random, trials.m_eShapeType, sides, trials.m_bTurns);
    const CMotion& motion = trial.m_cMotion;
    // A shape that is let go in the beginning is met a bit later or earlier, or by another part.
    CShapeGeometry whole = trial.m_cShape;
    whole.m_eSides = eSides::Both;
    CImpact impact;
    double depth;
    const bool covers =
        motion.m_fRadius >= whole.m_fRadius && (motion.m_vPos - whole.m_vCenter).norm() < whole.m_fRadius;
    const bool overlaps = Overlap(whole, motion, 0.0, impact, depth) || covers;
    if (overlaps && (trials.m_bTurns || OverlapsInside(trial))) return;
    const eSweep found = Sweep(trial.m_cShape, motion, 0.0, impact);
    ASSERT_NE(found, eSweep::OutOfIterations);
    const auto ask = [&](double more) {
      Compare::CHit<T> hit;
      return ToAnswer(SweepExactly<T>(trial, hit, more), hit);
    };
    CAnswer exact;
    try {
      exact = ask(0.0);
    } catch (const std::runtime_error&) { // an arc that turns about its own centre, a slow ball beside it
      ++unanswered;
      return;
    }
    if (exact.m_bBegins) return; // it was let go at first
    CTime time(found, impact, motion.m_vVel);
    time.m_fBound = GapBound(trial);
    time.m_fRounding *= motion.m_fDuration;
    const double more = 4.0 * std::max(time.m_fBound, g_nSweepRoundings * 0x1p-52 * trial.m_cShape.m_fSize);
    const bool exactEnds = sides == eSides::Both || !time.IsMet();
    const double slack = time.m_fRounding + (exactEnds ? 0.0 : 2.0 * more / time.m_fApproach);
    if (!judge.HaveMet(time, exact, more, slack, ask)) return;
    ASSERT_NEAR(impact.m_vNorm.norm(), 1.0, 8.0 * 0x1p-52);
    const Vector2d center = motion.m_vPos + motion.m_vVel * impact.m_fTime;
    // How far along the shape it is off, by the smallest circle on which that can be.
    const double least = std::min(motion.m_fRadius, trial.m_cShape.m_fRadius > motion.m_fRadius
                                                        ? trial.m_cShape.m_fRadius - motion.m_fRadius
                                                        : motion.m_fRadius);
    const double turning =
        std::abs(trial.m_cShape.m_fTurnSpeed) * (trial.m_cShape.m_fSize + motion.m_fRadius);
    const double speed = (motion.m_vVel - impact.m_vSurface).norm() + turning;
    if (overlaps) return; // perhaps several parts
    ASSERT_LE((impact.m_vNorm - exact.m_vNorm).norm() * least,
              2.0 * (time.ErrorOf(exact) * speed + time.m_fBound));
    ASSERT_LE((center - impact.m_vPOI - motion.m_fRadius * impact.m_vNorm).norm(), 2.0 * time.m_fBound);
  });
  judge.ExpectMany(trials.m_nTrials / 20);
  EXPECT_LE(unanswered, trials.m_nTrials / 1000);
}

class CSweepAgainst50Digits : public testing::TestWithParam<CTrials> {};

TEST_P(CSweepAgainst50Digits, FindsTheSameImpact) { ExpectAgrees<CFifty>(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    , CSweepAgainst50Digits,
    testing::Values(CTrials{eShape::Point, false, false, 8000}, CTrials{eShape::LineSeg, false, false, 8000},
                    CTrials{eShape::LineSeg, true, false, 8000}, CTrials{eShape::Circle, false, false, 8000},
                    CTrials{eShape::Arc, false, false, 8000}, CTrials{eShape::Arc, true, false, 8000},
                    CTrials{eShape::Point, false, true, 100}, CTrials{eShape::LineSeg, false, true, 100},
                    CTrials{eShape::Circle, false, true, 100}, CTrials{eShape::Arc, false, true, 100}),
    [](const auto& test) { return Name(test.param); });

class CSweepAgainstReference : public testing::TestWithParam<CTrials> {};

TEST_P(CSweepAgainstReference, FindsTheSameImpact) { ExpectAgrees<double>(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    , CSweepAgainstReference,
    testing::Values(CTrials{eShape::Point, false, true, 20000}, CTrials{eShape::LineSeg, false, true, 20000},
                    CTrials{eShape::LineSeg, true, true, 20000}, CTrials{eShape::Circle, false, true, 20000},
                    CTrials{eShape::Arc, false, true, 10000}, CTrials{eShape::Arc, true, true, 10000}),
    [](const auto& test) { return Name(test.param); });

// Two whose ways graze, meet, or begin touching. To swap them changes signs only.
TEST(SweepOfTwoBalls, FindsTheImpactOf50Digits) {
  CJudge judge(20000);
  ForEachCase(50, 20000, [&](CRandom& random, int) {
    const CTrial trial = RandomTrial(random, eShape::Circle, eSides::Both);
    const Vector2d drift = Wide(random.InSquare(3.0f));
    const CMotion other{trial.m_cShape.m_vCenter, drift, trial.m_cShape.m_fRadius, 1.0};
    CMotion ball = trial.m_cMotion;
    ball.m_vVel += drift;
    CImpact impact, swapped;
    const eSweep found = ImpactBallBall(other, ball, impact);
    ASSERT_EQ(ImpactBallBall(ball, other, swapped), found);
    if (found == eSweep::Impact) {
      ASSERT_TRUE(swapped.m_fTime == impact.m_fTime && swapped.m_vNorm == -impact.m_vNorm);
    }
    double depth = 0.0, swappedDepth = 0.0;
    CImpact overlap;
    ASSERT_EQ(OverlapBallBall(other, ball, overlap, depth),
              OverlapBallBall(ball, other, overlap, swappedDepth));
    ASSERT_EQ(depth, swappedDepth);

    const auto ask = [&](double more) {
      Compare::CHit<CFifty> hit;
      return ToAnswer(
          Compare::SweepBalls<CFifty>(BallOf<CFifty>(other), BallOf<CFifty>(ball, more), CFifty(1), hit),
          hit);
    };
    const CAnswer exact = ask(0.0);
    const double size = std::max(other.m_vPos.cwiseAbs().maxCoeff(), ball.m_vPos.cwiseAbs().maxCoeff()) +
                        other.m_fRadius + ball.m_fRadius;
    CTime time(found, impact, ball.m_vVel);
    time.m_fBound = 16.0 * 0x1p-52 * (size + other.m_vVel.norm() + ball.m_vVel.norm());
    const double more = 4.0 * std::max(time.m_fBound, g_nSweepRoundings * 0x1p-52 * size);
    if (!judge.HaveMet(time, exact, more, time.m_fRounding, ask)) return;
    ASSERT_LE((impact.m_vNorm - exact.m_vNorm).norm() * (other.m_fRadius + ball.m_fRadius),
              2.0 * (time.ErrorOf(exact) * trial.m_cMotion.m_vVel.norm() + time.m_fBound));
    ASSERT_EQ(impact.m_vSurface, other.m_vVel);
    ASSERT_NEAR((impact.m_vPOI - other.PosAt(impact.m_fTime)).norm(), other.m_fRadius, 2.0 * time.m_fBound);
  });
  judge.ExpectMany(4000);
}

} // namespace
} // namespace Shapes::Geometry
