// SPDX-License-Identifier: MIT
#include "ImpactTesting.h"

#include "Tolerances.h"

namespace Shapes::Geometry {
namespace {

std::unique_ptr<CShape> MakeRandomShape(CRandom& random, int i, const Vector2& origin) {
  const Vector2 p = origin + random.InSquare(1);
  return MakeAnyShape(random, static_cast<std::uint32_t>(i), p, 1);
}

CMotion MakeRandomMotion(CRandom& random) {
  CMotion motion;
  motion.m_fRadius = static_cast<double>(random.Uniform(0, 0.15f));
  motion.m_fDuration = 1.0;
  motion.m_vPos = Wide(random.InSquare(2));
  motion.m_vVel = Wide(random.VectorOfLength(0, 4));
  motion.m_vAcc = Wide(random.VectorOfLength(0, 12));
  return motion;
}

// The control is a ball that stands still. The test has to tell so of most of those that stay away, or it is
// of no use.
TEST(ParabolicMotion, ABallThatIsOutOfTheWayStaysAway) {
  int away = 0, told = 0, wrong = 0;
  ForEachCase(23, 8000, [&](CRandom& random, int i) {
    const Vector2 origin = i % 8 < 4 ? Vector2(0, 0) : Vector2(1e5f, -3e4f);
    const std::unique_ptr<CShape> pShape = MakeRandomShape(random, i, origin);
    CShapeGeometry o = MakeShapeGeometry(*pShape, 0.0);
    o.m_vVel = Wide(random.VectorOfLength(0, 2));
    CMotion motion = MakeRandomMotion(random);
    motion.m_vPos += Wide(origin);
    motion.m_fDuration = static_cast<double>(random.Scale(-6, 0));
    const double start = random.Unit(), reach = random.Coin() ? 0.0 : 0.1 * random.Unit();
    const auto oracle = MakeOracle(o, motion);
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 200; ++k) {
      const double t = motion.m_fDuration * k / 200;
      const Vector2d x = motion.PosAt(t) - (start + t) * o.m_vVel;
      nearest = std::min(nearest, static_cast<double>(oracle.DistanceOf(x, 0)));
    }
    const bool isOut = IsOutOfWay(o, motion, start, reach);
    ASSERT_FALSE(isOut && nearest <= motion.m_fRadius + reach) << nearest;
    CImpact impact;
    ASSERT_FALSE(isOut && Sweep(o, motion, start, impact) != eSweep::None);
    away += nearest > motion.m_fRadius + reach;
    told += isOut;
    CMotion standing = motion;
    standing.m_vVel = o.m_vVel;
    standing.m_vAcc = Vector2d::Zero();
    wrong += IsOutOfWay(o, standing, start, reach) && nearest <= motion.m_fRadius + reach;
  });
  EXPECT_GT(told, 0.8 * away) << "of " << away;
  EXPECT_GT(wrong, 200);
}

TEST(ParabolicMotion, NothingIsOutOfTheWayOfAShapeThatTurns) {
  CShapeGeometry o = MakeShapeGeometry(CLineSeg(CLineSegDesc({0, 0}, {1, 0})), 0.0);
  const CMotion motion{{50, 50}, {0, 0}, 0.1, 1.0};
  EXPECT_TRUE(IsOutOfWay(o, motion, 0.0, 0.0));
  o.m_fTurnSpeed = 1.0;
  EXPECT_FALSE(IsOutOfWay(o, motion, 0.0, 0.0));
}

TEST(ParabolicMotion, ABallThatIsThrownUpMeetsTheFloorThatItLeft) {
  const CShapeGeometry floor = MakeShapeGeometry(CLineSeg(CLineSegDesc({-5, 0}, {5, 0})), 0.0);
  CMotion motion{{0, 0.5}, {1, 3}, 0.5, 1.0, {0, -10}};
  CImpact impact;
  ASSERT_EQ(Sweep(floor, motion, 0.0, impact), eSweep::Impact);
  EXPECT_NEAR(impact.m_fTime, 0.6, 1e-12);
  EXPECT_NEAR(impact.m_fClosing, 10.0, 1e-12);
  motion.m_fDuration = 0.59;
  EXPECT_EQ(Sweep(floor, motion, 0.0, impact), eSweep::None);
  motion.m_vAcc = {0, 10};
  motion.m_fDuration = 100.0;
  EXPECT_EQ(Sweep(floor, motion, 0.0, impact), eSweep::None);
}

// Gravity, as one of two balls feels it that the other one does not, moves it along the surface that it
// touches, down or first up and then back. Followed by the distance, which gravity might bend towards that
// surface, the search takes thousands of steps, and does not come to an end.
TEST(ParabolicMotion, ABallThatFallsAlongWhatItTouchesIsFollowedToTheEnd) {
  ForEachCase(31, 2000, [&](CRandom& random, int i) {
    const double r = static_cast<double>(random.Scale(-2, 0)), R = static_cast<double>(random.Scale(-2, 0));
    const double speed = i % 2 == 0 ? 0.0 : static_cast<double>(random.Scale(-6, 0));
    const CMotion other{{0, 0}, {0, 0}, R, 0.1};
    const CMotion ball{{r + R, 0}, {0, speed}, r, 0.1, {0, -10}};
    CImpact impact;
    // As it comes back it grazes the other one.
    EXPECT_NE(ImpactBallBall(other, ball, impact), eSweep::OutOfIterations) << speed;
    EXPECT_TRUE(speed > 0.0 || ImpactBallBall(other, ball, impact) == eSweep::None);
    // Control: a little towards it.
    const CMotion towards{{r + R, 0}, {-1e-3, speed}, r, 0.1, {0, -10}};
    EXPECT_EQ(ImpactBallBall(other, towards, impact), eSweep::Impact);
  });
}

// At any depth: that it approaches is found before it is deeper by more than that share of its overlap.
TEST(ParabolicMotion, ABallThatIsDeepInAnotherOneIsMetWhenItTurnsRound) {
  int met = 0;
  ForEachCase(37, 3000, [&](CRandom& random, int) {
    const Vector2d away = Wide(AngleToVector(random.Uniform(0, 2 * g_fPi))), v = Wide(random.InSquare(1));
    const CMotion other{{0, 0}, {0, 0}, 0.5, 0.1};
    const CMotion ball{0.05 * away, v, 0.5, 0.1, {0, -10}};
    CImpact impact;
    if (away.dot(v) < 0.0 || ImpactBallBall(other, ball, impact) != eSweep::Impact) return;
    ++met;
    double least = 1.0; // overlap before
    for (int k = 0; k <= 500; ++k)
      least = std::min(least, 1.0 - ball.PosAt(impact.m_fTime * k / 500).norm());
    const double overlap = 1.0 - ball.PosAt(impact.m_fTime).norm();
    EXPECT_LE(overlap - least, 1.5 * g_fDeeper * least);
  });
  EXPECT_GT(met, 100);
}

// By differences of the gap, for a shape that turns and a ball that falls.
TEST(ParabolicMotion, TheGapClosesAsItsSecondDerivativeSays) {
  int impacts = 0;
  ForEachCase(29, 1200, [&](CRandom& random, int i) {
    const CTrial trial = ClearTrial(random, g_eTypes[i % 4], eSides::Both, true, true);
    const auto oracle = MakeOracle(trial.m_cShape, trial.m_cMotion);
    const auto gap = [&](double t) { return static_cast<double>(oracle.Gap(t)); };
    CImpact impact;
    if (Sweep(trial.m_cShape, trial.m_cMotion, 0.0, impact) != eSweep::Impact) return;
    const double t = impact.m_fTime, h = 1e-4;
    const double closing = -(gap(t + h) - 2.0 * gap(t) + gap(t - h)) / (h * h);
    // At an end of a shape the second derivative jumps.
    const double later = -(gap(t + 2 * h) - 2.0 * gap(t + h) + gap(t)) / (h * h);
    if (std::abs(later - closing) > 0.01 * (1.0 + std::abs(closing))) return;
    ++impacts;
    EXPECT_NEAR(impact.m_fClosing, closing, 0.02 * (1.0 + std::abs(closing))) << i;
  });
  EXPECT_GT(impacts, 50);
}

} // namespace
} // namespace Shapes::Geometry
